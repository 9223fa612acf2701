#pragma once
// Converts text in the 8-bit code pages of photometry files to UTF-8.

#include <string>
#include <string_view>

namespace calc {

// Returns the text itself if it is valid UTF-8, else read as Windows-1252; control characters
// become blanks.
std::string utf8_from_file_text(std::string_view text);

// Returns a piece of a file for a message: as above, at most 40 bytes and then "...".
std::string quotable(std::string_view text);

}  // namespace calc
