#pragma once
// EULUMDAT files (.ldt): one value per line in a fixed order.

#include "calc/diagnostics.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// text: the whole file, 8-bit, without a byte order mark. The luminous length lies along C90-C270,
// the width along C0-C180; width 0 is a circle. Intensity = table (cd/klm) x conversion factor x
// flux of the first lamp set / 1000; a negative number of lamps marks absolute photometry and
// scales the same. Empty if and only if at least one error was reported. name: the path for
// messages.
std::optional<PhotometricWeb> parse_eulumdat(std::string_view text, const std::string& name,
                                             Diagnostics& diagnostics);

}  // namespace calc
