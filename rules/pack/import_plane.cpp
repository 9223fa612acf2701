#include "rules/pack/import_plane.h"

#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rules {
namespace {

enum class Kind { desk, floor, upright };

struct KindWords {
  Kind kind;
  std::string_view meaning;
  std::vector<std::string> words;
};

const std::array<KindWords, 3>& all_words() {
  static const std::array<KindWords, 3> kWords{
      {{Kind::desk,
        "horizontal at the height of desks",
        {"desk", "task", "task area", "task plane", "horizontal", "horizontal task plane",
         "working plane", "work plane"}},
       {Kind::floor, "on the floor, 0 to 0.2 m above it", {"floor", "on the floor", "ground"}},
       {Kind::upright,
        "upright",
        {"vertical", "upright", "vertical task plane", "shelf", "shelves", "board", "boards",
         "rack face", "face"}}}};
  return kWords;
}

constexpr TaskPlane::Heights kFloor{0.0, 0.2};  // as the rows about floors of the shipped packs

// Returns the text in lower case, with one blank for each run of blanks, _ and -.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\t' || c == '_' || c == '-';
    if (is_blank && (result.empty() || result.back() == ' ')) continue;
    const bool is_capital = c >= 'A' && c <= 'Z';
    result += is_blank ? ' ' : is_capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return std::string(calc::trim(result));
}

// Takes "1.6" or ".8" from the front.
std::optional<double> take_number(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && (calc::is_digit(text[length]) || text[length] == '.')) ++length;
  const std::optional<double> number = calc::parse_number(text.substr(0, length));
  text = calc::trim(text.substr(length));
  return number;
}

// Reads "1.6 m", "0.8 to 2 m" (and "0.8 2 m", the rest of "0.8-2 m"), "85 cm".
std::optional<TaskPlane::Heights> parse_heights(std::string_view text) {
  const std::optional<double> low = take_number(text);
  if (!low) return std::nullopt;
  const bool has_to = text.starts_with("to ");
  if (has_to) text = calc::trim(text.substr(3));
  std::optional<double> high = low;
  if (has_to || (!text.empty() && calc::is_digit(text.front()))) high = take_number(text);
  for (const std::string_view end : {" above the floor", " above floor"}) {
    if (text.ends_with(end)) text.remove_suffix(end.size());
  }
  const double unit_m = text == "cm" ? 0.01 : 1.0;
  if (!high || (text != "m" && text != "cm") || *high < *low) return std::nullopt;
  return TaskPlane::Heights{unit_m * *low, unit_m * *high};
}

// Returns whether there is a minus that is not a dash between two numbers.
bool has_negative_number(std::string_view text) {
  char before = ' ';  // but for blanks
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '-' && !calc::is_digit(before) && calc::is_digit(text[i + 1])) return true;
    if (text[i] != ' ' && text[i] != '\t') before = text[i];
  }
  return false;
}

}  // namespace

std::optional<TaskPlane> parse_task_plane(std::string_view text) {
  if (has_negative_number(text)) return std::nullopt;
  const std::string all = plain(text);
  TaskPlane plane;
  std::string_view words = all;
  const auto digit = std::find_if(all.begin(), all.end(), calc::is_digit);
  if (digit != all.end()) {
    const auto at = static_cast<std::size_t>(digit - all.begin());
    plane.heights_m = parse_heights(words.substr(at));
    if (!plane.heights_m) return std::nullopt;
    words = calc::trim(words.substr(0, at));
    if (words == "at" || words.ends_with(" at"))
      words = calc::trim(words.substr(0, words.size() - 2));
  }
  if (words.empty()) return plane;
  for (const KindWords& kind : all_words()) {
    if (std::find(kind.words.begin(), kind.words.end(), words) == kind.words.end()) continue;
    plane.is_upright = kind.kind == Kind::upright;
    if (kind.kind == Kind::floor && !plane.heights_m) plane.heights_m = kFloor;
    return plane;
  }
  return std::nullopt;
}

std::string task_plane_choices() {
  std::string text;
  for (const KindWords& kind : all_words()) text += kind.words.front() + ", ";
  return text + "a height such as '1.1 m', or both";
}

std::string task_plane_words() {
  std::string text;
  for (const KindWords& kind : all_words()) {
    text += fmt::format("{} ({}); ", fmt::join(kind.words, ", "), kind.meaning);
  }
  return text +
         "with or without these words a height above the floor, '1.1 m' or '0.8 to 2 m'; "
         "empty is desk";
}

}  // namespace rules
