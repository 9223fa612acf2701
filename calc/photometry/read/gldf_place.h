#pragma once
// Places the emitters of a GLDF product in the luminaire.

#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/gldf_choice.h"
#include "calc/photometry/read/zip_archive.h"

#include <vector>

namespace calc {

// Returns the place of each light in the L3D model of the variant, with the middle of the box
// around all of them at the origin. If the model lacks a place, all are at the origin, not turned,
// with a warning. A single light is always there; several places of it give a warning. Empty, with
// an error, if one of several lights has several places.
std::optional<std::vector<EmitterPlace>> places_of(const std::vector<GldfLight>& lights,
                                                   const GldfProduct& product, ZipArchive& archive,
                                                   Diagnostics& diagnostics);

// Returns "'a', 'b'".
std::string ids_of(const std::vector<GldfLight>& lights);
// Returns what to write instead of one luminaire: "emitter=\"a\", emitter=\"b\"".
std::string as_single_luminaires(const std::vector<GldfLight>& lights);

}  // namespace calc
