#pragma once
// IESNA / IES LM-63 files, versions 1986 to 2019, photometric type C.

#include "calc/diagnostics.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// text: the whole file, 8-bit, without a byte order mark. Luminaire frame: the horizontal angle H
// is C, the opening's length lies along C0, its width along C90. Intensity = table x candela
// multiplier x ballast factor (x field 12 in 1986 and 1991 files only) (x TILT factor of tilt 0);
// lamp lumens never scale the table. Empty if and only if at least one error was reported. name:
// the path for messages.
std::optional<PhotometricWeb> parse_lm63(std::string_view text, const std::string& name,
                                         Diagnostics& diagnostics);

}  // namespace calc
