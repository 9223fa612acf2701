#include "rules/pack/row_values.h"

#include "rules/catalogue/metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rules {
namespace {

constexpr double kLeastRating = 10.0, kMostRating = 30.0;  // of UGR, where it is used
constexpr double kBestRendering = 100.0;
constexpr double kSameStep = 1e-9;  // relative

// Returns the first check whose limit is only the parameter; nullptr: none.
const RuleCheck* check_of(const RulePack& pack, const std::string& parameter) {
  const auto found =
      std::find_if(pack.checks.begin(), pack.checks.end(), [&](const RuleCheck& check) {
        return check.limit.kind == ExpressionKind::row_value && check.limit.name == parameter;
      });
  return found == pack.checks.end() ? nullptr : &*found;
}

// Returns the number in the unit of the pack, as in the file.
std::string number_text(const RulePack& pack, const RuleValue& value, double number) {
  const Unit& unit = pack.find_parameter(value.parameter)->unit;
  const std::string text = fmt::format("{:.6g}", number / unit.factor);
  return unit.dimension == Dimension::plain ? text : fmt::format("{} {}", text, unit.name);
}

bool is_on(const RuleScale& scale, double number) {
  return std::any_of(scale.values.begin(), scale.values.end(),
                     [&](double step) { return std::abs(step - number) <= kSameStep * step; });
}

// Returns "70 lx is on no step of the scale 'steps'; next to it are 50 and 75 lx", or "".
std::string scale_words(const RulePack& pack, const RuleValue& value, double number) {
  const RuleScale* scale = nullptr;
  for (const RuleScale& candidate : pack.scales) {
    if (candidate.unit.dimension != Dimension::illuminance) continue;
    if (is_on(candidate, number)) return {};
    if (scale == nullptr) scale = &candidate;
  }
  if (scale == nullptr) return {};
  const auto above = std::upper_bound(scale->values.begin(), scale->values.end(), number);
  std::string next;
  if (above != scale->values.begin()) next = number_text(pack, value, *(above - 1));
  if (above != scale->values.end()) {
    next += (next.empty() ? "" : " and ") + number_text(pack, value, *above);
  }
  return fmt::format("{} is not a step of the scale '{}'; nearest: {}",
                     number_text(pack, value, number), scale->id, next);
}

struct Words {
  bool is_error = false;
  std::string text;
};

Words words_about(const RulePack& pack, const RuleCheck& check, const RuleValue& value,
                  double number) {
  const std::string shown = number_text(pack, value, number);
  const bool is_lower = is_lower_limit(check.comparison);
  if (is_lower && number == 0.0) {
    return {check.dimension() == Dimension::illuminance,
            shown + " requires nothing: every plane passes"};
  }
  if (is_ratio(check.metric)) {
    const bool is_fraction = check.metric != Metric::gradient;
    return {is_fraction && number > 1.0,
            is_fraction && number > 1.0 ? shown + " is out of range; allowed: 0 to 1" : ""};
  }
  const std::string quantity = check.quantity->name;
  if (quantity == "Ra" && number > kBestRendering) {
    return {true, fmt::format("{} is out of range; allowed: 0 to {:g}", shown, kBestRendering)};
  }
  if (quantity == "UGR" && (number < kLeastRating || number > kMostRating)) {
    return {false,
            fmt::format("{} is unusual; usual are {:g} to {:g}", shown, kLeastRating, kMostRating)};
  }
  const bool has_steps = is_lower && check.dimension() == Dimension::illuminance;
  return {false, has_steps ? scale_words(pack, value, number) : ""};
}

}  // namespace

std::vector<RowValueProblem> row_value_problems(const RulePack& pack) {
  std::vector<RowValueProblem> problems;
  for (const RuleRow& row : pack.rows) {
    for (const RuleValue& value : row.values) {
      const RuleCheck* check = check_of(pack, value.parameter);
      if (check == nullptr || !value.required) continue;
      const auto add = [&](bool is_of_modified, const Words& words) {
        if (words.text.empty()) return;
        problems.push_back({&row, &value, is_of_modified, words.is_error, words.text});
      };
      add(false, words_about(pack, *check, value, *value.required));
      if (!value.modified) continue;
      if (is_lower_limit(check->comparison) && *value.modified < *value.required) {
        add(true, {true, fmt::format("{} at the level 'modified' is below the required {}",
                                     number_text(pack, value, *value.modified),
                                     number_text(pack, value, *value.required))});
      } else {
        add(true, words_about(pack, *check, value, *value.modified));
      }
    }
  }
  return problems;
}

std::vector<const RuleRow*> rows_without_requirement(const RulePack& pack) {
  std::vector<const RuleRow*> rows;
  for (const RuleRow& row : pack.rows) {
    bool is_silent = false, is_answered = !row.note.empty();
    for (const RuleCheck& check : pack.checks) {
      if (check.role != pack.role) continue;
      if (check.limit.kind != ExpressionKind::row_value) {
        is_answered = true;  // it is required of all rows, or hangs on more than the row
        continue;
      }
      const RuleValue* value = row.find_value(check.limit.name);
      is_silent = is_silent || value == nullptr ||
                  (!value->required && value->why == NoValue::not_specified);
      is_answered = is_answered || (value != nullptr && (value->required.has_value() ||
                                                         value->why != NoValue::not_specified));
    }
    if (is_silent && !is_answered) rows.push_back(&row);
  }
  return rows;
}

}  // namespace rules
