#include "calc/photometry/read/text_encoding.h"

#include "calc/base/utf8.h"

#include <array>
#include <cstddef>

namespace calc {
namespace {

// Windows-1252, bytes 0x80 to 0x9F; the five unassigned ones become U+FFFD.
constexpr std::array<char16_t, 32> kWindows1252{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

}  // namespace

std::string utf8_from_file_text(std::string_view text) {
  const bool already = !first_invalid_utf8(text);
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) {
      out += ' ';
    } else if (already) {
      out += text[i];
    } else {
      out += utf8_from_code_point(byte >= 0x80 && byte < 0xA0 ? kWindows1252[byte - 0x80] : byte);
    }
  }
  return out;
}

std::string quotable(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return utf8_from_file_text(text);
  std::size_t end = kLongest;
  while (end > kLongest - 4 && is_utf8_continuation(text[end])) --end;  // not inside a character
  return utf8_from_file_text(text.substr(0, end)) + "...";
}

bool looks_like_utf16(std::string_view bytes) {
  if (has_utf16_mark(bytes)) return true;
  const std::string_view head = bytes.substr(0, 4);
  return head.size() == 4 && (head[0] == '\0') != (head[1] == '\0') &&
         (head[0] == '\0') == (head[2] == '\0') && (head[1] == '\0') == (head[3] == '\0');
}

}  // namespace calc
