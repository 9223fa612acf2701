#pragma once
// Photometry files to webs. The format is told by content, not by name.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// bytes: a whole LM-63 (.ies), EULUMDAT (.ldt), TM-33 (.xml) or GLDF (.gldf) file; name: the path
// used in messages. options: which light of a file with several; an option that the format does not
// have is an error. Empty if and only if at least one error was reported.
std::optional<PhotometricWeb> parse_photometry(std::string_view bytes, const std::string& name,
                                               Diagnostics& diagnostics,
                                               const PhotometryOptions& options = {});

// A format that can be read, in words.
struct PhotometryFormatInfo {
  std::string_view name;       // "LM-63"
  std::string_view as_a_file;  // "an LM-63 file"
  std::string_view extension;  // ".ies", as it usually is
};
std::vector<PhotometryFormatInfo> photometry_formats();

// The same without GLDF, for the files inside a container.
std::optional<PhotometricWeb> parse_text_photometry(std::string_view bytes, const std::string& name,
                                                    Diagnostics& diagnostics,
                                                    const PhotometryOptions& options);

}  // namespace calc
