#pragma once
// Reads GLDF containers (.gldf): a ZIP archive with product.xml and photometry files.

#include "calc/base/diagnostics.h"
#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Reads the light that PhotometryOptions::variant and ::emitter choose (gldf_choice.h); ::lamp_set
// applies to the photometry file. bytes: the archive; name: its path, used in messages as a folder
// ("a.gldf/product.xml"). Files on the web are not fetched.
//
// GLDF gives product.xml precedence over the photometry file [gldf.io, conventions, GLDF over
// photometry]. The luminous flux follows this where its meaning is clear, with a warning and a note
// in PhotometrySource::applied_factors:
// - the equipment's RatedLuminousFlux is that of the lamps: the light is scaled by its ratio to the
//   lamp flux of a file with relative photometry;
// - a fixed emitter's RatedLuminousFlux may mean lamps or luminaire: it scales the light where both
//   are the same (absolute photometry, or a light output ratio of 100 % within 2 points).
// Otherwise, and where only single lamps state a flux, a difference of more than 1 % gives a
// warning and the file's light is kept.
// The same precedence holds for the power: the equipment's, with its gear, comes first. That of
// light sources alone may lack the gear: it replaces the file's if it is higher, or if the light
// was scaled, because the file's power is then that of other light. Power that belongs to other
// light is not used, and no power is known then. PhotometrySource::power_rule names its source.
//
// Several emitters (gldf_choice.h): each has its own photometry, flux, power and place
// (gldf_place.h). They are refused together where one is turned in product.xml (its order of
// rotations is not defined), and where two share an equipment that states a flux or a power,
// because that may be of one or of all.
// Empty if and only if at least one error was reported.
std::optional<LuminaireLight> parse_gldf_luminaire(std::string_view bytes, const std::string& name,
                                                   const PhotometryOptions& options,
                                                   Diagnostics& diagnostics);

// Returns its choices (gldf_choices()); empty if product.xml cannot be read.
std::vector<PhotometryOptions> choices_of_gldf(std::string_view bytes);

// Reads a single light in the same way; several are an error.
std::optional<PhotometricWeb> parse_gldf(std::string_view bytes, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics);

}  // namespace calc
