#pragma once
// Texts and numbers as a DXF file holds them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// R12 has room for 255 bytes in a value.
inline constexpr std::size_t kMostDxfBytes = 250;

// As R12 calls Windows-1252, in which texts are.
inline constexpr std::string_view kDxfCodePage = "ANSI_1252";

// As the value of one group: bytes of Windows-1252 on one line, at most kMostDxfBytes long, of
// which a cut text ends with "...". utf8: anything; what printable() makes of it is shown. Other
// characters become \U+XXXX ("°" and "±" the codes of R12), those beyond 16 bits "<U+1F4A1>", which
// R12 has no escape for; \ and ^ are escaped and "%%" is "% %", so that no name is a control code.
std::string dxf_text(std::string_view utf8);

// A long text as several values of at most `columns` >= 1 characters each, broken at blanks where
// there are any. At least one, which may be "".
std::vector<std::string> dxf_lines(std::string_view utf8, std::size_t columns);

// Signs that most fonts of CAD programs lack as ASCII: "≥" is ">=". For text to be read, not for
// data.
std::string dxf_signs(std::string_view utf8);

// Of R12: A to Z, digits, "-" and "_", at most 31 bytes. start: of such characters alone. utf8: its
// other characters become "_".
std::string dxf_name(std::string_view start, std::string_view utf8);

// Rounded to micrometres, with a decimal point; never "-0.0". "0.0" of what is not finite.
std::string dxf_number(double value);

}  // namespace report
