#pragma once
// Text files in other encodings to UTF-8, which is what everything inside the program is.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

enum class TextEncoding { utf8, utf16_le, utf16_be, utf32 };

// By the byte order mark, else by where the zero bytes of the first two characters stand. Single-
// byte code pages look like UTF-8 here.
TextEncoding encoding_of(std::string_view bytes);

// UTF-8 stays as it is, with its mark; UTF-16 loses its mark.
struct DecodedText {
  std::string utf8;     // with a problem: what comes before it
  std::string problem;  // in words, "" = none
};
// UTF-8 is not checked. Problems: UTF-32, and UTF-16 with half a character in it.
DecodedText decoded_text(std::string bytes);

// The beginning of the text, for those who tell what a file is. most: in bytes of the file. What
// cannot be decoded ends it.
std::string start_of_text(std::string_view bytes, std::size_t most);

// Bytes of single-byte code pages. Windows-1252 leaves five bytes open: U+FFFD.
std::string utf8_from_windows_1252(unsigned char byte);
std::string utf8_from_windows_1252(std::string_view text);
std::string utf8_from_latin1(std::string_view text);

}  // namespace calc
