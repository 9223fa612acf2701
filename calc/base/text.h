#pragma once
// Locale-free text helpers shared by all readers.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Returns whether c is 0 to 9, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Splits at blanks, tabs and line ends; no empty parts.
std::vector<std::string_view> split_words(std::string_view text);
std::string_view trim(std::string_view text);
// Returns the text with A to Z as a to z and all else unchanged.
std::string ascii_lowered(std::string_view text);

// Returns the finite decimal number that is the whole text ("1.5", "-2e3"); no nan, inf, hex or
// trailing text.
std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_integer(std::string_view text);

// As people sort names: "Room 9" before "Room 10".
bool comes_before(std::string_view a, std::string_view b);

// "a, b or c"
std::string join_choices(const std::vector<std::string_view>& choices);

// Returns the end of a shortened list: "and 3 more", or with `what` "and 3 more rooms".
std::string and_more(std::size_t left_out, std::string_view what = {});

// Returns "a, b, c and 3 more" with at most `most` names.
std::string list_names(const std::vector<std::string>& names, std::size_t most);

// Returns "; did you mean 'x'?" for the closest choice within a third of its length, else "".
std::string suggestion(std::string_view found, const std::vector<std::string_view>& choices);

}  // namespace calc
