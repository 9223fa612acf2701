#pragma once
// Names from files made safe to show, and how much room they take.

#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace report {

using calc::comes_before;
using calc::printable;
using calc::printable_path;

// Columns a terminal needs for valid UTF-8: 0 for combining marks, 2 for East Asian wide characters
// and emoji, else 1.
std::size_t display_width(std::string_view utf8);

// Bytes of the text's start that are at most `columns` wide; of at least one character, if there is
// any.
std::size_t bytes_within(std::string_view utf8, std::size_t columns);

// The end of the text, at most `columns` >= 1 wide; a cut text starts with "…". Never cuts inside a
// character.
std::string shorten_start(std::string_view utf8, std::size_t columns);
// Its start, likewise; a cut text ends in "…".
std::string shorten_end(std::string_view utf8, std::size_t columns);
// Its start and its end, likewise, with "…" between them: about two thirds are of the start.
std::string shorten_middle(std::string_view utf8, std::size_t columns);
// A name: of a long one the end stays, too, since that may be what tells it from others.
std::string shorten_name(std::string_view utf8, std::size_t columns);

}  // namespace report
