#pragma once
// Reads EULUMDAT files (.ldt): one value per line in a fixed order.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Reads the whole file, `text`: 8-bit, without a byte order mark. The luminous length is along
// C90-C270, the width along C0-C180; width 0 is a circle. Intensity = table (cd/klm) x conversion
// factor x flux of the chosen lamp set / 1000 (sets are alternatives, never added;
// PhotometryOptions::lamp_set); a negative number of lamps marks absolute photometry and scales the
// same. Empty if and only if at least one error was reported. name: the path for messages.
std::optional<PhotometricWeb> parse_eulumdat(std::string_view text, const std::string& name,
                                             const PhotometryOptions& options,
                                             Diagnostics& diagnostics);

}  // namespace calc
