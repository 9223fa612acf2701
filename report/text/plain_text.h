#pragma once
// Names from files made safe to show, and how much room they take.

#include "calc/base/utf8.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace report {

using calc::printable;
using calc::printable_path;

// Columns a terminal needs for valid UTF-8: 0 for combining marks, 2 for East Asian wide characters
// and emoji, else 1.
std::size_t display_width(std::string_view utf8);

// The end of the text, at most `columns` >= 1 wide; a cut text starts with "…". Never cuts inside a
// character.
std::string shorten_start(std::string_view utf8, std::size_t columns);
// Its start, likewise; a cut text ends in "…".
std::string shorten_end(std::string_view utf8, std::size_t columns);

}  // namespace report
