#include "calc/photometry/read/text_encoding.h"

#include "calc/base/encoding.h"
#include "calc/base/utf8.h"

#include <cstddef>

namespace calc {
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
      out += utf8_from_windows_1252(byte);
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

}  // namespace calc
