#pragma once
// GLDF containers (.gldf): a ZIP archive with product.xml and photometry files.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// bytes: the archive; name: its path, used in messages as a folder ("a.gldf/product.xml").
// PhotometryOptions::variant and ::emitter choose the light (gldf_choice.h), ::lamp_set is handed
// on to the photometry file. Files on the web are not fetched.
//
// GLDF's rule is that product.xml goes before the photometry file [gldf.io, conventions, GLDF over
// photometry]. For the luminous flux it is followed where its meaning is clear, with a warning and
// a note in PhotometrySource::applied_factors:
// - the equipment's RatedLuminousFlux is that of the lamps: the light is scaled by its ratio to the
//   lamp flux of a file with relative photometry;
// - a fixed emitter's RatedLuminousFlux may mean lamps or luminaire: it scales the light where both
//   are the same (absolute photometry, or a light output ratio of 100 % within 2 points).
// Otherwise, and where only single lamps state a flux, a difference of more than 1 % is warned of
// and the file's light is kept. The power is the equipment's, else the file's, else the light
// source's.
// Empty if and only if at least one error was reported.
std::optional<PhotometricWeb> parse_gldf(std::string_view bytes, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics);

}  // namespace calc
