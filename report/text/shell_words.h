#pragma once
// Command lines as text that a POSIX shell reads back to the same words.

#include <string>
#include <string_view>
#include <vector>

namespace report {

// The word as it must be written: plain where nothing in it is special, else in single quotes.
std::string shell_quoted(const std::string& word);

// The words of a line made of shell_quoted() words with blanks between. Of other lines: knows
// blanks, single quotes and backslashes outside them; a quote without end reaches to the end.
std::vector<std::string> shell_words(std::string_view line);

}  // namespace report
