#include "report/text/plain_text.h"

#include "calc/base/utf8.h"

#include <algorithm>
#include <array>

namespace report {
namespace {

struct Range {
  char32_t first, last;
};

template <std::size_t N>
bool is_in(char32_t c, const std::array<Range, N>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [c](Range range) { return c >= range.first && c <= range.last; });
}

std::size_t width_of(char32_t c) {
  static constexpr std::array<Range, 6> kCombining{{{0x300, 0x36F},
                                                    {0x200B, 0x200D},
                                                    {0x1AB0, 0x1AFF},
                                                    {0x20D0, 0x20FF},
                                                    {0xFE00, 0xFE0F},
                                                    {0xFE20, 0xFE2F}}};
  static constexpr std::array<Range, 7> kWide{{{0x1100, 0x115F},
                                               {0x2E80, 0xA4CF},
                                               {0xAC00, 0xD7A3},
                                               {0xF900, 0xFAFF},
                                               {0xFF00, 0xFF60},
                                               {0x1F300, 0x1FAFF},
                                               {0x20000, 0x3FFFD}}};
  if (is_in(c, kCombining)) return 0;
  return is_in(c, kWide) ? 2 : 1;
}

}  // namespace

std::size_t display_width(std::string_view utf8) {
  std::size_t width = 0;
  while (!utf8.empty()) {
    const calc::Utf8Character point = calc::first_character(utf8);
    width += point.length == 0 ? 1 : width_of(point.code);
    utf8.remove_prefix(std::max<std::size_t>(point.length, 1));
  }
  return width;
}

std::size_t bytes_within(std::string_view utf8, std::size_t columns) {
  std::size_t width = 0, length = 0;
  while (length < utf8.size()) {
    const calc::Utf8Character point = calc::first_character(utf8.substr(length));
    width += point.length == 0 ? 1 : width_of(point.code);
    if (width > columns && length > 0) break;
    length += std::max<std::size_t>(point.length, 1);
  }
  return length;
}

std::string shorten_start(std::string_view utf8, std::size_t columns) {
  std::size_t width = display_width(utf8);
  if (width <= columns) return std::string(utf8);
  while (!utf8.empty() && width + 1 > columns) {  // + 1: the ellipsis
    const calc::Utf8Character point = calc::first_character(utf8);
    width -= point.length == 0 ? 1 : width_of(point.code);
    utf8.remove_prefix(std::max<std::size_t>(point.length, 1));
  }
  return "…" + std::string(utf8);
}

std::string shorten_end(std::string_view utf8, std::size_t columns) {
  if (display_width(utf8) <= columns) return std::string(utf8);
  const std::size_t length = columns > 1 ? bytes_within(utf8, columns - 1) : 0;
  const std::string start(utf8.substr(0, length));
  return (display_width(start) < columns ? start : "") + "…";
}

std::string shorten_middle(std::string_view utf8, std::size_t columns) {
  if (display_width(utf8) <= columns) return std::string(utf8);
  const std::size_t end = (columns - 1) / 3;
  if (end == 0) return shorten_end(utf8, columns);
  const std::string last = shorten_start(utf8, end + 1);  // with an ellipsis
  return shorten_end(utf8, columns - display_width(last) + 1) +
         last.substr(std::string_view("…").size());
}

std::string shorten_name(std::string_view utf8, std::size_t columns) {
  constexpr std::size_t kLong = 24, kRoom = 12;  // columns
  const bool has_room = columns >= kRoom && display_width(utf8) > kLong;
  return has_room ? shorten_middle(utf8, columns) : shorten_end(utf8, columns);
}

}  // namespace report
