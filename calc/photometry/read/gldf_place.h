#pragma once
// Where the emitters of a GLDF product are in the luminaire.

#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/gldf_choice.h"
#include "calc/photometry/read/zip_archive.h"

#include <vector>

namespace calc {

// Of each light, as the L3D model of the variant has it, the middle of the box around all of them
// at the origin. Where the model does not say it of each, all are at the origin, not turned, which
// is warned of. A single light is there always; that it is at several places is warned of. Empty,
// with an error, if one of several lights is.
std::optional<std::vector<EmitterPlace>> places_of(const std::vector<GldfLight>& lights,
                                                   const GldfProduct& product, ZipArchive& archive,
                                                   Diagnostics& diagnostics);

// "'a', 'b'"
std::string ids_of(const std::vector<GldfLight>& lights);
// What to write instead of one luminaire: "emitter=\"a\", emitter=\"b\""
std::string as_single_luminaires(const std::vector<GldfLight>& lights);

}  // namespace calc
