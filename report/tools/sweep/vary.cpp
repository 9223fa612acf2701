#include "report/tools/sweep/vary.h"

#include "calc/base/text.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace cli {
namespace {

constexpr int kMostDecimals = 12;

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// Digits behind the point; more than are useful with an exponent.
int decimals_of(std::string_view number) {
  if (number.find_first_of("eE") != number.npos) return kMostDecimals + 1;
  const std::size_t point = number.find('.');
  return point == number.npos ? 0 : static_cast<int>(number.size() - point - 1);
}

// Adds the values of "from:to:step"; gives what is wrong.
std::string add_range(std::string_view item, std::vector<std::string>& values) {
  const std::vector<std::string_view> words = parts_of(item, ':');
  double number[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto parsed = calc::parse_number(words[i]);
    if (!parsed)
      return fmt::format("in '{}', which is from:to:step, '{}' is not a number", item, words[i]);
    number[i] = *parsed;
  }
  const auto [from, to, step] = number;
  if (step == 0.0) return fmt::format("in '{}', which is from:to:step, the step is 0", item);
  // Binary noise loses no last value.
  const double steps = std::floor((to - from) / step + 1e-9);
  if (steps < 0.0) {
    return fmt::format("in '{}', which is from:to:step, the step {} leads away from {}", item,
                       words[2], words[1]);
  }
  if (steps >= static_cast<double>(kMostVariants)) {
    return fmt::format("'{}' has more than {} values", item, kMostVariants);
  }
  const int decimals = std::max(decimals_of(words[0]), decimals_of(words[2]));
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i) {
    const double value = from + static_cast<double>(i) * step;
    values.push_back(decimals > kMostDecimals ? report::format_shortest(value)
                                              : report::format_fixed(value, decimals));
  }
  return "";
}

bool is_range(std::string_view item) {
  const std::vector<std::string_view> words = parts_of(item, ':');
  return words.size() == 3 && std::any_of(words.begin(), words.end(), [](std::string_view word) {
           return calc::parse_number(word).has_value();
         });
}

}  // namespace

std::optional<Vary> parse_vary(const std::string& text, std::string& problem) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) {
    problem = fmt::format(
        "'{}' is not PATH=LIST, as linear.flux-lm=3000:5000:500 or L.columns=3,4,5", text);
    return std::nullopt;
  }
  Vary vary{text.substr(0, equals), {}};
  for (const std::string_view item : parts_of(std::string_view(text).substr(equals + 1), ',')) {
    if (calc::trim(item).empty()) {
      problem = fmt::format("'{}' has an empty value; values are separated by single commas", text);
      return std::nullopt;
    }
    if (!is_range(item)) {
      vary.values.emplace_back(calc::trim(item));
    } else if (problem = add_range(item, vary.values); !problem.empty()) {
      return std::nullopt;
    }
    if (vary.values.size() > kMostVariants) {
      problem = fmt::format("'{}' has more than {} values", vary.path, kMostVariants);
      return std::nullopt;
    }
  }
  std::set<std::string_view> known;
  for (const std::string& value : vary.values) {
    if (known.insert(value).second) continue;
    problem = fmt::format("'{}': the value '{}' is given twice", vary.path, value);
    return std::nullopt;
  }
  return vary;
}

std::size_t count_variants(const std::vector<Vary>& vary) {
  std::size_t count = 1;
  for (const Vary& one : vary) {
    count *= one.values.size();
    if (count > kMostVariants) return kMostVariants + 1;
  }
  return count;
}

std::vector<std::string> values_of_variant(const std::vector<Vary>& vary, std::size_t variant) {
  std::vector<std::string> values(vary.size());
  for (std::size_t v = vary.size(); v-- > 0;) {
    values[v] = vary[v].values[variant % vary[v].values.size()];
    variant /= vary[v].values.size();
  }
  return values;
}

std::vector<check::SetValue> settings_of_variant(const std::vector<Vary>& vary,
                                                 const std::vector<std::string>& values) {
  std::vector<check::SetValue> settings;
  for (std::size_t v = 0; v < vary.size(); ++v) settings.push_back({vary[v].path, values[v]});
  return settings;
}

}  // namespace cli
