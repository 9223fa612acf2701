#pragma once
// Functions for UTF-8 that readers and writers need, and for byte order marks.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns the text after the UTF-8 byte order mark, if there is one.
std::string_view without_byte_order_mark(std::string_view bytes);
// Returns whether the bytes begin with a UTF-16 mark, in either byte order.
bool has_utf16_mark(std::string_view bytes);

// Returns true for the second and later bytes of a character.
constexpr bool is_utf8_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

// The first character of a text that is not empty. length: in bytes; 0 = it is not valid.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;
};
Utf8Character first_character(std::string_view text);

// Returns the offset of the first byte that breaks the encoding (also overlong forms, surrogates
// and codes above U+10FFFF).
std::optional<std::size_t> first_invalid_utf8(std::string_view text);

// Returns the character in UTF-8; requires a code up to 0x10FFFF.
std::string utf8_from_code_point(char32_t code);

// Returns true also for U+2028/2029 and the bidirectional controls, which could make a line read
// differently, and for the two code points XML does not allow.
bool is_control(char32_t code);
// Returns whether it ends with "##", "##vso" or "##teamcity", CI commands if a "[" follows.
bool ends_with_command(std::string_view text);

// Returns the text, which may hold anything, as valid UTF-8 on one line. Broken sequences become
// U+FFFD; control characters (line ends, tabs, terminal escapes, changes of writing direction)
// become blanks. "##[", "##vso[" and "##teamcity[", which CI runners take for commands anywhere in
// a line, get a blank.
std::string printable(std::string_view text);
// Returns a printable path for the start of a line: it never begins with "::", also a CI command.
std::string printable_path(std::string_view path);

// Returns at most `characters` characters, then "..." if more follow.
std::string shorten_utf8(std::string_view text, std::size_t characters);

}  // namespace calc
