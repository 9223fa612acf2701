#pragma once
// The little of UTF-8 that readers and writers need, and byte order marks.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// What follows the mark of UTF-8, where there is one.
std::string_view without_byte_order_mark(std::string_view bytes);
// Whether a mark of UTF-16 begins the bytes, in either order.
bool has_utf16_mark(std::string_view bytes);

// True for the second and later bytes of a character.
constexpr bool is_utf8_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

// The character that begins a text, which is not empty. length: in bytes; 0 = it is not valid.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;
};
Utf8Character first_character(std::string_view text);

// Offset of the first byte that breaks the encoding (overlong forms, surrogates and codes above
// U+10FFFF included).
std::optional<std::size_t> first_invalid_utf8(std::string_view text);

// code: up to 0x10FFFF.
std::string utf8_from_code_point(char32_t code);

// Also U+2028/2029 and the bidirectional controls, which could make a line read differently, and
// the two code points XML does not allow.
bool is_control(char32_t code);
// "##", "##vso", "##teamcity": with a '[' behind it a CI runner takes it for a command.
bool ends_with_command(std::string_view text);

// Names from files made safe to show: they may hold anything. The text as valid UTF-8 on one line:
// broken sequences become U+FFFD, control characters (line ends, tabs, terminal escapes, what turns
// the direction of writing) a blank. "##[", "##vso[" and "##teamcity[", which CI runners take for
// commands anywhere in a line, get a blank.
std::string printable(std::string_view text);
// Of a path that begins a line: none begins with "::", which is a command, too.
std::string printable_path(std::string_view path);

// At most `characters` characters, "..." for the rest.
std::string shorten_utf8(std::string_view text, std::size_t characters);

}  // namespace calc
