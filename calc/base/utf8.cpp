#include "calc/base/utf8.h"

#include <algorithm>

namespace calc {
namespace {

constexpr std::string_view kUtf8ByteOrderMark = "\xEF\xBB\xBF";

char byte_of(char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); }

}  // namespace

std::string_view without_byte_order_mark(std::string_view bytes) {
  if (bytes.starts_with(kUtf8ByteOrderMark)) bytes.remove_prefix(kUtf8ByteOrderMark.size());
  return bytes;
}

bool has_utf16_mark(std::string_view bytes) {
  return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

Utf8Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  char32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_utf8_continuation(text[i])) return {};
    code = (code << 6u) | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  }
  const bool is_overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (is_overlong || is_surrogate || code > 0x10FFFF) return {};
  return {code, length};
}

std::optional<std::size_t> first_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = first_character(text.substr(i)).length;
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

std::string utf8_from_code_point(char32_t code) {
  const auto tail = [&](unsigned shift) { return byte_of(0x80u | ((code >> shift) & 0x3Fu)); };
  if (code < 0x80u) return {byte_of(code)};
  if (code < 0x800u) return {byte_of(0xC0u | (code >> 6u)), tail(0)};
  if (code < 0x10000u) return {byte_of(0xE0u | (code >> 12u)), tail(6), tail(0)};
  return {byte_of(0xF0u | (code >> 18u)), tail(12), tail(6), tail(0)};
}

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069) || c == 0x2028 || c == 0x2029 || c == 0xFFFE || c == 0xFFFF;
}

bool ends_with_command(std::string_view text) {
  const std::size_t end = text.size();
  std::size_t begin = end;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  return text.substr(0, begin).ends_with("##");
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character point = first_character(text);
    if (point.length == 0) {
      result += "\xEF\xBF\xBD";  // U+FFFD
    } else if (is_control(point.code)) {
      result += ' ';
    } else {
      if (point.code == '[' && ends_with_command(result)) result += ' ';
      result += text.substr(0, point.length);
    }
    text.remove_prefix(std::max<std::size_t>(point.length, 1));
  }
  return result;
}

std::string printable_path(std::string_view path) {
  return path.starts_with(':') ? "./" + printable(path) : printable(path);
}

std::string shorten_utf8(std::string_view text, std::size_t characters) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_utf8_continuation(text[i])) continue;
    if (count++ == characters) return std::string(text.substr(0, i)) + "...";
  }
  return std::string(text);
}

}  // namespace calc
