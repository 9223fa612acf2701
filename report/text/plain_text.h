#pragma once
// Makes names from files safe to show, and measures their width.

#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace report {

using calc::comes_before;
using calc::printable;
using calc::printable_path;

// Returns the columns that valid UTF-8 takes on a terminal: 0 for combining marks, 2 for East Asian
// wide characters and emoji, else 1.
std::size_t display_width(std::string_view utf8);

// Returns the bytes of the text's start that are at most `columns` wide, but at least one character
// if there is any.
std::size_t bytes_within(std::string_view utf8, std::size_t columns);

// Returns the end of the text, at most `columns` >= 1 wide; a cut text starts with "…". Never cuts
// inside a character.
std::string shorten_start(std::string_view utf8, std::size_t columns);
// Returns the start in the same way; a cut text ends in "…".
std::string shorten_end(std::string_view utf8, std::size_t columns);
// Returns start and end in the same way, with "…" between them: about two thirds from the start.
std::string shorten_middle(std::string_view utf8, std::size_t columns);
// Returns a name; a long one keeps its end, too, which may distinguish it from others.
std::string shorten_name(std::string_view utf8, std::size_t columns);

}  // namespace report
