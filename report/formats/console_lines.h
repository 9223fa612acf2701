#pragma once
// Lines of a terminal: colours, columns, and texts over several lines.

#include "rules/verdict/outcome.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

inline constexpr const char* kBold = "\033[1m";
inline constexpr const char* kDim = "\033[2m";
inline constexpr const char* kReset = "\033[0m";

const char* outcome_colour(rules::Outcome outcome);

inline constexpr std::size_t kGap = 2;  // blanks between columns

std::string padded(const std::string& text, std::size_t width, bool to_the_right);
void trim_end(std::string& text);

// Returns a text behind `start`, over as many lines as a terminal of that width needs; 0: one line.
// Further lines begin with `indent` blanks, fewer if the terminal is narrow. A word wider than a
// line is broken: no line is wider than a terminal of 20 columns or more. Ends in '\n'.
std::string wrapped_lines(const std::string& start, const std::string& text, std::size_t indent,
                          int terminal_width);
// Returns the same behind `indent` blanks and a mark of two columns, or none.
std::string note_lines(const std::string& note, std::size_t indent, int terminal_width,
                       const char* mark = "└ ");
// Returns a row of a table that is too wide for the terminal: its first cell, and below it the
// others. colour: of the first cell; "" = none.
std::string stacked_cells(const std::vector<std::string>& cells, const std::string& colour,
                          int terminal_width);

}  // namespace report
