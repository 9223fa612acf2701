#pragma once
// Reads photometry files as webs. The content tells the format, not the name.

#include "calc/base/diagnostics.h"
#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Reads a whole LM-63 (.ies), EULUMDAT (.ldt), TM-33 (.xml) or GLDF (.gldf) file. name: the path
// used in messages. options: which light of a file with several; an option that the format does not
// have is an error. Empty if and only if at least one error was reported.
std::optional<PhotometricWeb> parse_photometry(std::string_view bytes, const std::string& name,
                                               Diagnostics& diagnostics,
                                               const PhotometryOptions& options = {});

// Reads a whole luminaire in the same way, also several lights of a file that shine together
// (GLDF). parse_photometry() refuses those.
std::optional<LuminaireLight> parse_luminaire_light(std::string_view bytes, const std::string& name,
                                                    Diagnostics& diagnostics,
                                                    const PhotometryOptions& options = {});

// Returns every choice that a file with several lights offers, in its order; empty if it holds one,
// or is not readable. Only variants and emitters are set.
std::vector<PhotometryOptions> photometry_choices(std::string_view bytes);

// Returns the light of the only emitter; empty, with an error, if there are several.
std::optional<PhotometricWeb> only_light(LuminaireLight light, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics);

// A format that can be read, in words.
struct PhotometryFormatInfo {
  std::string_view name;       // "LM-63"
  std::string_view as_a_file;  // "an LM-63 file"
  std::string_view extension;  // ".ies", as it usually is
};
std::vector<PhotometryFormatInfo> photometry_formats();

// Reads the same formats except GLDF, for the files inside a container.
std::optional<PhotometricWeb> parse_text_photometry(std::string_view bytes, const std::string& name,
                                                    Diagnostics& diagnostics,
                                                    const PhotometryOptions& options);

}  // namespace calc
