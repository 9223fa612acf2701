#include "report/formats/dxf_text.h"

#include "calc/base/encoding.h"
#include "calc/base/utf8.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace report {
namespace {

// A character as it stands in the file.
using Pieces = std::vector<std::string>;

// No value of a group holds these: line ends, and what terminals or readers take for commands.
bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

// Its byte in the file's code page, which dxf_head() names; 0: it has none.
char windows_1252_byte(char32_t code) {
  if (code >= 0xA0 && code <= 0xFF) return static_cast<char>(code);
  static const std::map<char32_t, char> kOthers = [] {
    std::map<char32_t, char> others;
    for (int byte = 0x80; byte < 0xA0; ++byte) {
      const std::string utf8 = calc::utf8_from_windows_1252(static_cast<unsigned char>(byte));
      const char32_t letter = calc::first_character(utf8).code;
      constexpr char32_t kNone = 0xFFFD;
      if (letter != kNone) others[letter] = static_cast<char>(byte);
    }
    return others;
  }();
  const auto found = kOthers.find(code);
  return found == kOthers.end() ? '\0' : found->second;
}

std::string piece_of(char32_t code) {
  if (is_control(code)) return " ";
  if (code == U'\\') return "\\U+005C";
  if (code == U'^') return "^ ";
  // The two that R12 itself has.
  if (code == U'\u00B0') return "%%d";
  if (code == U'\u00B1') return "%%p";
  if (code < 0x7F) return {static_cast<char>(code)};
  if (const char byte = windows_1252_byte(code)) return {byte};
  return code <= 0xFFFF ? fmt::format("\\U+{:04X}", static_cast<unsigned>(code))
                        : fmt::format("<U+{:04X}>", static_cast<unsigned>(code));
}

Pieces pieces_of(std::string_view utf8) {
  const std::string text = calc::printable(utf8);
  Pieces pieces;
  for (std::string_view left = text; !left.empty();) {
    const calc::Utf8Character next = calc::first_character(left);
    pieces.push_back(next.length == 0 ? " " : piece_of(next.code));
    left.remove_prefix(std::max<std::size_t>(next.length, 1));
  }
  // "%%d" is a degree sign; what a name says of it is "% %d".
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].front() == '%' && pieces[i - 1].back() == '%') pieces[i].insert(0, " ");
  }
  return pieces;
}

// Pieces [begin, end).
std::string joined(const Pieces& pieces, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text += pieces[i];
  return text;
}

// The end of what fits, from `begin` on.
std::size_t fitting(const Pieces& pieces, std::size_t begin, std::size_t most_bytes,
                    std::size_t most_pieces) {
  std::size_t end = begin, bytes = 0;
  while (end < pieces.size() && end - begin < most_pieces &&
         bytes + pieces[end].size() <= most_bytes) {
    bytes += pieces[end].size();
    ++end;
  }
  return end;
}

}  // namespace

std::string dxf_text(std::string_view utf8) {
  constexpr std::string_view kCut = "...";
  // More cannot be shown, and names may be long.
  constexpr std::size_t kMostCharacters = kMostDxfBytes + 1, kMostOfOne = 4;
  const Pieces pieces = pieces_of(utf8.substr(0, kMostCharacters * kMostOfOne));
  if (fitting(pieces, 0, kMostDxfBytes, pieces.size()) == pieces.size())
    return joined(pieces, 0, pieces.size());
  const std::size_t end = fitting(pieces, 0, kMostDxfBytes - kCut.size(), pieces.size());
  return joined(pieces, 0, end).append(kCut);
}

std::vector<std::string> dxf_lines(std::string_view utf8, std::size_t columns) {
  const Pieces pieces = pieces_of(utf8);
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = fitting(pieces, begin, kMostDxfBytes, columns);
    if (end < pieces.size()) {
      std::size_t blank = end;
      while (blank > begin && pieces[blank] != " ") --blank;
      // A line of nothing but blanks would be no progress for who reads it.
      const bool has_words = std::any_of(pieces.begin() + static_cast<std::ptrdiff_t>(begin),
                                         pieces.begin() + static_cast<std::ptrdiff_t>(blank),
                                         [](const std::string& piece) { return piece != " "; });
      if (has_words) end = blank;
    }
    lines.push_back(joined(pieces, begin, end));
    begin = end;
    if (begin < pieces.size() && pieces[begin] == " ") ++begin;
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::string dxf_signs(std::string_view utf8) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 19> kSigns{
      {{"≥", ">="},
       {"≤", "<="},
       {"−", "-"},
       {"–", "-"},
       {"—", "-"},
       {"…", "..."},
       {"└", "-"},
       {"✓", "+"},
       {"✗", "x"},
       {"○", "o"},
       {"▼", "v"},
       {"▲", "^"},
       {"↔", "<->"},
       {"→", "->"},
       {"\u00A0", " "},
       {"\u2009", " "},
       {"\u202F", " "},
       {"Ē", "Em"},
       {"·", "|"}}};
  std::string text;
  while (!utf8.empty()) {
    const auto* sign = std::find_if(kSigns.begin(), kSigns.end(),
                                    [&](const auto& one) { return utf8.starts_with(one.first); });
    if (sign == kSigns.end()) {
      text += utf8.front();
      utf8.remove_prefix(1);
    } else {
      text += sign->second;
      utf8.remove_prefix(sign->first.size());
    }
  }
  return text;
}

std::string dxf_name(std::string_view start, std::string_view utf8) {
  constexpr std::size_t kMost = 31;
  std::string name(start);
  for (const char byte : utf8) {
    if (name.size() >= kMost) break;
    if (calc::is_utf8_continuation(byte)) continue;
    const bool is_lower = byte >= 'a' && byte <= 'z';
    const bool is_plain =
        (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') || byte == '-' || byte == '_';
    name += is_lower ? static_cast<char>(byte - 'a' + 'A') : is_plain ? byte : '_';
  }
  return name;
}

std::string dxf_number(double value) {
  constexpr double kLarge = 1e9;  // more has no micrometres
  if (!std::isfinite(value)) return "0.0";
  if (std::abs(value) >= kLarge) {
    std::string text = format_shortest(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  std::string text = format_fixed(value, 6);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text + "0" : text;
}

}  // namespace report
