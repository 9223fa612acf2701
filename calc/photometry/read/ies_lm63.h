#pragma once
// Reads IESNA / IES LM-63 files, versions 1986 to 2019, photometric types A, B and C.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/ies_tilt.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Reads the whole file, `text`: 8-bit, without a byte order mark. Luminaire frame: in type C the
// horizontal angle H is C, for types A and B see table_of_type_ab(); the opening's length is along
// C0, its width along C90. Intensity = table x candela multiplier x ballast factor (x field 12 in
// 1986 and 1991 files only) (x TILT factor of tilt 0; PhotometrySource::lamp_tilt keeps the
// others); lamp lumens never scale the table. Empty if and only if at least one error was reported.
// name: the path for messages. read_companion: for TILT=<file>, without which such a file is
// refused.
std::optional<PhotometricWeb> parse_lm63(std::string_view text, const std::string& name,
                                         Diagnostics& diagnostics,
                                         const CompanionReader& read_companion = {});

}  // namespace calc
