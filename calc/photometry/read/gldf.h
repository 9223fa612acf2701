#pragma once
// GLDF containers (.gldf): a ZIP archive with product.xml and photometry files.

#include "calc/base/diagnostics.h"
#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
// and the file's light is kept.
// So it is with the power: the equipment's, which holds its gear, goes first. That of light sources
// alone may lack the gear: it goes before the file's if it is higher, or if the light was scaled,
// because the file's power is then that of other light. Power that belongs to other light is not
// used: then none is known. PhotometrySource::power_rule says whose it is.
//
// Several emitters (gldf_choice.h): each has its own photometry, flux, power and place
// (gldf_place.h). Together they are refused where one is turned in product.xml (nothing says in
// which order), and where two share an equipment that states a flux or a power, because nothing
// says whether that is of one or of all.
// Empty if and only if at least one error was reported.
std::optional<LuminaireLight> parse_gldf_luminaire(std::string_view bytes, const std::string& name,
                                                   const PhotometryOptions& options,
                                                   Diagnostics& diagnostics);

// What can be chosen in it (gldf_choices()); empty if product.xml cannot be read.
std::vector<PhotometryOptions> choices_of_gldf(std::string_view bytes);

// The same of one light; several are an error.
std::optional<PhotometricWeb> parse_gldf(std::string_view bytes, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics);

}  // namespace calc
