#include "calc/base/encoding.h"

#include "calc/base/utf8.h"

#include <array>
#include <cstddef>
#include <utility>

namespace calc {
namespace {

// Bytes 0x80 to 0x9F.
constexpr std::array<char16_t, 32> kWindows1252{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

constexpr std::string_view kUtf32Marks[] = {std::string_view("\xFF\xFE\0\0", 4),
                                            std::string_view("\0\0\xFE\xFF", 4)};

class Utf16Reader {
 public:
  Utf16Reader(std::string_view bytes, bool is_big) : bytes_(bytes), is_big_(is_big) {}

  DecodedText read() {
    DecodedText text;
    while (at_ < bytes_.size()) {
      const std::optional<char32_t> code = next();
      if (!code) {
        text.problem = "the UTF-16 text has an incomplete character";
        return text;
      }
      text.utf8 += utf8_from_code_point(*code);
    }
    return text;
  }

 private:
  std::optional<char32_t> next() {
    const std::optional<char32_t> first = unit();
    if (!first || *first < 0xD800 || *first > 0xDFFF) return first;
    const std::optional<char32_t> second = unit();
    if (*first > 0xDBFF || !second || *second < 0xDC00 || *second > 0xDFFF) return std::nullopt;
    return 0x10000 + ((*first - 0xD800) << 10u) + (*second - 0xDC00);
  }
  std::optional<char32_t> unit() {
    if (bytes_.size() - at_ < 2) return std::nullopt;
    const auto low = static_cast<unsigned char>(bytes_[at_ + (is_big_ ? 1 : 0)]);
    const auto high = static_cast<unsigned char>(bytes_[at_ + (is_big_ ? 0 : 1)]);
    at_ += 2;
    return static_cast<char32_t>(high) << 8u | low;
  }

  std::string_view bytes_;
  bool is_big_;
  std::size_t at_ = 0;
};

DecodedText from_utf16(std::string_view bytes, TextEncoding encoding) {
  if (has_utf16_mark(bytes)) bytes.remove_prefix(2);
  return Utf16Reader(bytes, encoding == TextEncoding::utf16_be).read();
}

}  // namespace

TextEncoding encoding_of(std::string_view bytes) {
  for (const std::string_view mark : kUtf32Marks) {
    if (bytes.starts_with(mark)) return TextEncoding::utf32;
  }
  if (has_utf16_mark(bytes)) {
    return bytes.front() == '\xFF' ? TextEncoding::utf16_le : TextEncoding::utf16_be;
  }
  const std::string_view head = bytes.substr(0, 4);
  if (head.size() < 4) return TextEncoding::utf8;
  const auto is_zero = [&](std::size_t i) { return head[i] == '\0'; };
  if (is_zero(0) != is_zero(2) || is_zero(1) != is_zero(3) || is_zero(0) == is_zero(1)) {
    return TextEncoding::utf8;
  }
  return is_zero(0) ? TextEncoding::utf16_be : TextEncoding::utf16_le;
}

DecodedText decoded_text(std::string bytes) {
  const TextEncoding encoding = encoding_of(bytes);
  if (encoding == TextEncoding::utf8) return {std::move(bytes), ""};
  if (encoding == TextEncoding::utf32) return {"", "the file is UTF-32"};
  return from_utf16(bytes, encoding);
}

std::string start_of_text(std::string_view bytes, std::size_t most) {
  const std::string_view start = bytes.substr(0, most);
  const TextEncoding encoding = encoding_of(start);
  if (encoding == TextEncoding::utf32) return "";
  if (encoding != TextEncoding::utf8) return from_utf16(start, encoding).utf8;
  return std::string(without_byte_order_mark(start));
}

std::string utf8_from_windows_1252(unsigned char byte) {
  return utf8_from_code_point(byte >= 0x80 && byte < 0xA0 ? kWindows1252[byte - 0x80] : byte);
}

std::string utf8_from_windows_1252(std::string_view text) {
  std::string utf8;
  for (const char c : text) utf8 += utf8_from_windows_1252(static_cast<unsigned char>(c));
  return utf8;
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) utf8 += utf8_from_code_point(static_cast<unsigned char>(c));
  return utf8;
}

}  // namespace calc
