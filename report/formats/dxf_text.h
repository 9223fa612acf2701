#pragma once
// Texts and numbers in the form of a DXF file.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// R12 allows 255 bytes in a value.
inline constexpr std::size_t kMostDxfBytes = 250;

// R12's name of Windows-1252, the encoding of texts.
inline constexpr std::string_view kDxfCodePage = "ANSI_1252";

// Returns the value of one group: bytes of Windows-1252 on one line, at most kMostDxfBytes long; a
// cut text ends with "...". utf8: anything; printable() is applied. Other characters become \U+XXXX
// ("°" and "±" the codes of R12), those beyond 16 bits "<U+1F4A1>", because R12 has no escape for
// them; \ and ^ are escaped and "%%" is "% %", so that no name is a control code.
std::string dxf_text(std::string_view utf8);

// Returns a long text as several values of at most `columns` >= 1 characters each, broken at blanks
// if possible. At least one value, which may be "".
std::vector<std::string> dxf_lines(std::string_view utf8, std::size_t columns);

// Returns the text with ASCII for signs that most CAD fonts lack: ">=" for "≥". For text to be
// read, not for data.
std::string dxf_signs(std::string_view utf8);

// Returns a name for R12: A to Z, digits, "-" and "_", at most 31 bytes. start: only such
// characters. utf8: its other characters become "_".
std::string dxf_name(std::string_view start, std::string_view utf8);

// Returns the value rounded to micrometres, with a decimal point; never "-0.0", and "0.0" if it is
// not finite.
std::string dxf_number(double value);

}  // namespace report
