#pragma once
// Writes and reads command lines of a POSIX shell.

#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns the word as it must be written: plain if nothing in it is special, else in single quotes.
std::string shell_quoted(const std::string& word);

// Returns the words of a line made of shell_quoted() words with blanks between. In other lines it
// knows blanks, single quotes and backslashes outside them; an unclosed quote reaches to the end.
std::vector<std::string> shell_words(std::string_view line);

}  // namespace report
