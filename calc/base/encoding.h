#pragma once
// Converts text files in other encodings to UTF-8, the encoding of all text inside the program.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

enum class TextEncoding { utf8, utf16_le, utf16_be, utf32 };

// Returns the encoding by the byte order mark, else by the places of zero bytes in the first two
// characters. Single-byte code pages count as UTF-8.
TextEncoding encoding_of(std::string_view bytes);

// The text in UTF-8. UTF-8 input keeps its byte order mark; UTF-16 loses it.
struct DecodedText {
  std::string utf8;     // with a problem: what comes before it
  std::string problem;  // in words, "" = none
};
// Decodes a text without checking UTF-8. Problems are UTF-32, and UTF-16 with half a character.
DecodedText decoded_text(std::string bytes);

// Returns the beginning of the text, to tell what a file is. It ends after `most` bytes of the file
// or before what cannot be decoded.
std::string start_of_text(std::string_view bytes, std::size_t most);

// Converts bytes of single-byte code pages. Five bytes unused in Windows-1252 become U+FFFD.
std::string utf8_from_windows_1252(unsigned char byte);
std::string utf8_from_windows_1252(std::string_view text);
std::string utf8_from_latin1(std::string_view text);

}  // namespace calc
