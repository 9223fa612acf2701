#include "calc/photometry/stated_colour.h"

#include "calc/base/text.h"

#include <array>
#include <cstddef>
#include <string>

namespace calc {
namespace {

constexpr double kBest = 100.0;
// A smaller number is a group, a colour code or a slip.
constexpr double kLeastIndex = 20.0;

struct Group {
  std::string_view name;
  StatedRa ra;
};
constexpr std::array kGroups{Group{"1a", {90.0, kBest}}, Group{"1b", {80.0, 89.0}},
                             Group{"2a", {70.0, 79.0}},  Group{"2b", {60.0, 69.0}},
                             Group{"3", {40.0, 59.0}},   Group{"4", {20.0, 39.0}}};

// ASCII alone, without blanks that divide nothing: "Ra 80" is "ra80", but "9 0" are two numbers.
// What else there is makes the text unknown.
std::string without_blanks(std::string_view text) {
  std::string small;
  bool is_divided = false;  // by a blank, from what is there already
  for (const char c : text) {
    if (c == ' ' || c == '\t') {
      is_divided = true;
      continue;
    }
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool goes_on = is_digit(lower) || (lower >= 'a' && lower <= 'z');
    if (is_divided && !small.empty() && is_digit(small.back()) && goes_on) small += ' ';
    is_divided = false;
    small += lower;
  }
  return small;
}

bool take(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

// Digits with at most one point and digits behind it, at the start of `text`, which loses them.
std::optional<double> take_number(std::string_view& text) {
  constexpr std::size_t kMostDigits = 5;
  double number = 0.0, step = 1.0;
  std::size_t digits = 0, place = 0;
  bool is_behind_point = false;
  for (; place < text.size(); ++place) {
    const char c = text[place];
    if (c == '.' && !is_behind_point && digits > 0) {
      is_behind_point = true;
      continue;
    }
    if (c < '0' || c > '9') break;
    if (++digits > kMostDigits) return std::nullopt;
    number = 10.0 * number + (c - '0');
    if (is_behind_point) step *= 10.0;
  }
  if (digits == 0 || text[place - 1] == '.') return std::nullopt;
  text.remove_prefix(place);
  return number / step;
}

// A digit alone is a group only where nothing is said of what it is.
std::optional<StatedRa> group_of(std::string_view name, bool needs_letter) {
  for (const Group& group : kGroups) {
    if (group.name == name && (group.name.size() > 1 || !needs_letter)) return group.ra;
  }
  return std::nullopt;
}

std::optional<double> take_index(std::string_view& text) {
  const std::optional<double> value = take_number(text);
  return value && *value >= kLeastIndex && *value <= kBest ? value : std::nullopt;
}

}  // namespace

std::optional<StatedRa> stated_ra(std::string_view text) {
  const std::string all = without_blanks(text);
  std::string_view rest = all;
  const bool is_named = take(rest, "ra") || take(rest, "cri");
  if (const std::optional<StatedRa> group = group_of(rest, is_named)) return group;
  if (!is_named && take(rest, "r")) return group_of(rest, true);  // "R9": of one colour alone
  const bool is_at_least = take(rest, ">=") || take(rest, "\u2265") || take(rest, ">");
  if (is_named && !is_at_least && !take(rest, "=")) take(rest, ":");
  const std::optional<double> low = take_index(rest);
  if (!low) return std::nullopt;
  if (rest.empty()) return is_at_least ? StatedRa{*low, kBest} : StatedRa{*low, *low};
  if (is_at_least || !take(rest, "-")) return std::nullopt;
  const std::optional<double> high = take_index(rest);
  if (!high || !rest.empty() || *high < *low) return std::nullopt;
  return StatedRa{*low, *high};
}

std::optional<double> stated_colour_temperature_k(std::string_view text) {
  constexpr double kLeast_k = 1000.0, kMost_k = 25000.0;
  const std::string all = without_blanks(text);
  std::string_view rest = all;
  const std::optional<double> kelvin = take_number(rest);
  if (!kelvin || !(rest.empty() || rest == "k" || rest == " k")) return std::nullopt;
  if (*kelvin < kLeast_k || *kelvin > kMost_k) return std::nullopt;
  return kelvin;
}

}  // namespace calc
