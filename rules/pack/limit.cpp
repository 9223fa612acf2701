#include "rules/pack/limit.h"

#include "calc/base/sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rules {
namespace {

constexpr double kSameValue = 1e-9;  // relative

calc::Message number(double value, const char* unit) {
  return calc::Message::number(fmt::format("{:.9g} {}", value, unit));
}

bool is_same(double a, double b) { return std::abs(a - b) <= kSameValue * std::abs(b); }

calc::Estimate exactly(double value) { return {value, value, value}; }

Limit known(const calc::Estimate& value, Trust trust = Trust::confirmed) {
  Limit limit;
  limit.value = value;
  limit.trust = trust;
  return limit;
}

Limit missing(LimitStatus status, calc::Message reason) {
  Limit limit;
  limit.status = status;
  limit.reason = std::move(reason);
  return limit;
}

Limit unknown(calc::Message reason) { return missing(LimitStatus::unknown, std::move(reason)); }

Limit stepped(const RuleScale& scale, int steps, Limit start) {
  if (start.value.low != start.value.high) {
    return unknown(calc::say<calc::Sentence::scale_inexact>(scale.id));
  }
  const auto at = std::find_if(scale.values.begin(), scale.values.end(),
                               [&](double value) { return is_same(start.value.value, value); });
  const char* unit = base_unit(scale.unit.dimension);
  if (at == scale.values.end()) {
    return unknown(
        calc::say<calc::Sentence::not_on_scale>(number(start.value.value, unit), scale.id));
  }
  const std::ptrdiff_t index = at - scale.values.begin() + steps;
  if (index < 0 || index >= static_cast<std::ptrdiff_t>(scale.values.size())) {
    return unknown(
        calc::say<calc::Sentence::scale_ends>(scale.id, steps, number(start.value.value, unit)));
  }
  start.value = exactly(scale.values[static_cast<std::size_t>(index)]);
  return start;
}

// Returns the value; only the parameter of a scale moves in steps, the others stay unchanged.
Limit stepped_value(const RuleValue& value, const LimitScope& scope) {
  const Limit limit = known(exactly(*value.required), value.trust);
  const RuleScale* scale = scope.pack.find_scale_of(value.parameter);
  if (scale == nullptr) return limit;
  Limit taken = stepped(*scale, scope.level.steps, limit);
  taken.level = scope.level;
  taken.trust = std::max(taken.trust, scale->trust);
  return taken;
}

Limit row_value(const Expression& expression, const LimitScope& scope) {
  if (scope.row == nullptr) return unknown(calc::say<calc::Sentence::no_row>());
  const RuleValue* value = scope.row->find_value(expression.name);
  if (value == nullptr || !value->required) {
    const NoValue why = value == nullptr ? NoValue::not_specified : value->why;
    const calc::Message reason =
        why == NoValue::unknown
            ? calc::say<calc::Sentence::value_unknown>(scope.row->ref, expression.name)
            : calc::say<calc::Sentence::row_value_is>(scope.row->ref, expression.name,
                                                      calc::name_of(why));
    return missing(why == NoValue::unknown ? LimitStatus::unknown : LimitStatus::not_applicable,
                   reason);
  }
  if (scope.level.steps != 0) return stepped_value(*value, scope);
  const bool is_modified = scope.level.is_modified && value->modified.has_value();
  Limit limit = known(exactly(is_modified ? *value->modified : *value->required), value->trust);
  if (is_modified) limit.level = scope.level;
  return limit;
}

std::optional<double> look_up(const RuleTable& table, double key) {
  const auto value_of = [](const RuleTable::Entry& entry, double used_key) {
    return entry.value.value_or(used_key);
  };
  const RuleTable::Entry* below = nullptr;  // the last key that is not above
  const RuleTable::Entry* above = nullptr;  // the first key that is not below
  for (const RuleTable::Entry& entry : table.entries) {
    if (entry.key <= key || is_same(entry.key, key)) below = &entry;
    if (above == nullptr && (entry.key >= key || is_same(entry.key, key))) above = &entry;
  }
  switch (table.match) {
    case TableMatch::exact:
      if (below == nullptr || below != above) return std::nullopt;
      return value_of(*below, key);
    case TableMatch::next_lower:
      if (below == nullptr) return std::nullopt;
      return value_of(*below, key);
    case TableMatch::next_higher:
      if (above == nullptr) return std::nullopt;
      return value_of(*above, key);
    case TableMatch::linear:
      break;
  }
  if (below == nullptr || above == nullptr) return std::nullopt;
  if (below == above) return value_of(*below, key);
  const double share = (key - below->key) / (above->key - below->key);
  return (1.0 - share) * value_of(*below, below->key) + share * value_of(*above, above->key);
}

Limit table_value(const RuleTable& table, Limit key) {
  if (key.value.low != key.value.high) {
    return unknown(calc::say<calc::Sentence::table_inexact>(table.id));
  }
  const std::optional<double> value = look_up(table, key.value.value);
  if (!value) {
    return unknown(calc::say<calc::Sentence::table_has_none>(
        table.id, number(key.value.value, base_unit(table.key_unit.dimension))));
  }
  key.value = exactly(*value);
  key.trust = std::max(key.trust, table.trust);
  return key;
}

// Combines intervals by their ends, because nothing is negative.
calc::Estimate combined(ExpressionKind kind, const calc::Estimate& a, const calc::Estimate& b) {
  switch (kind) {
    case ExpressionKind::add:
      return {a.value + b.value, a.low + b.low, a.high + b.high};
    case ExpressionKind::multiply:
      return {a.value * b.value, a.low * b.low, a.high * b.high};
    case ExpressionKind::divide:
      return {a.value / b.value, a.low / b.high, a.high / b.low};
    case ExpressionKind::minimum:
      return {std::min(a.value, b.value), std::min(a.low, b.low), std::min(a.high, b.high)};
    default:
      return {std::max(a.value, b.value), std::max(a.low, b.low), std::max(a.high, b.high)};
  }
}

// Joins the parts of both; a missing part makes the whole missing.
Limit joined(ExpressionKind kind, const Limit& a, const Limit& b) {
  if (a.status != LimitStatus::known) return a;
  if (b.status != LimitStatus::known) return b;
  if (kind == ExpressionKind::divide && !(b.value.low > 0.0)) {
    return unknown(calc::say<calc::Sentence::limit_divides_by_zero>());
  }
  const calc::Estimate value = combined(kind, a.value, b.value);
  // At once: the smaller of a NaN and a number would be the number.
  if (!std::isfinite(value.value) || !std::isfinite(value.low) || !std::isfinite(value.high)) {
    return unknown(calc::say<calc::Sentence::limit_not_finite>());
  }
  Limit limit = known(value, std::max(a.trust, b.trust));
  limit.level = a.level == RowLevel::required ? b.level : a.level;
  return limit;
}

Limit evaluate(const Expression& expression, const LimitScope& scope);

Limit of_operands(const Expression& expression, const LimitScope& scope) {
  Limit limit = evaluate(expression.operands.front(), scope);
  for (std::size_t i = 1; i < expression.operands.size(); ++i) {
    limit = joined(expression.kind, limit, evaluate(expression.operands[i], scope));
  }
  if (limit.status != LimitStatus::known) return limit;
  if (expression.kind == ExpressionKind::table) {
    return table_value(*scope.pack.find_table(expression.name), limit);
  }
  if (expression.kind == ExpressionKind::step) {
    return stepped(*scope.pack.find_scale(expression.name), expression.steps, limit);
  }
  return limit;
}

Limit result_of(const RuleCheck& check, const LimitScope& scope) {
  const std::optional<calc::Estimate> result =
      scope.result_of ? scope.result_of(check) : std::nullopt;
  if (!result) return unknown(calc::say<calc::Sentence::result_not_known>(check.id));
  return known(*result);
}

Limit fact(const std::string& id, const LimitScope& scope) {
  const auto found = scope.facts.find(id);
  if (found == scope.facts.end()) return unknown(calc::say<calc::Sentence::fact_not_stated>(id));
  return known(exactly(found->second));
}

Limit evaluate(const Expression& expression, const LimitScope& scope) {
  switch (expression.kind) {
    case ExpressionKind::number:
      return known(exactly(expression.number));
    case ExpressionKind::row_value:
      return row_value(expression, scope);
    case ExpressionKind::limit_of:
      return evaluate_limit(*scope.pack.find_check(expression.name), scope);
    case ExpressionKind::result_of:
      return result_of(*scope.pack.find_check(expression.name), scope);
    case ExpressionKind::fact:
      return fact(expression.name, scope);
    default:
      return of_operands(expression, scope);
  }
}

// Returns the pack's limit at a special place, which replaces the usual one.
Limit at_special_place(const RuleCheck& check, Limit usual, const LimitScope& scope) {
  const RuleSpecial* special = check.find_special(scope.special, scope.row);
  if (special == nullptr || usual.status == LimitStatus::not_applicable) return usual;
  if (special->place == calc::SpecialPlace::other_wall) {
    const bool is_easier = usual.status == LimitStatus::known &&
                           (is_lower_limit(check.comparison) ? special->limit < usual.value.low
                                                             : special->limit > usual.value.high);
    if (!is_easier) return usual;
  }
  Limit limit = known(exactly(special->limit), special->trust);
  limit.special = special;
  return limit;
}

}  // namespace

Limit evaluate_limit(const RuleCheck& check, const LimitScope& scope) {
  Limit limit = at_special_place(check, evaluate(check.limit, scope), scope);
  if (limit.status == LimitStatus::known && !std::isfinite(limit.value.high)) {
    return unknown(calc::say<calc::Sentence::limit_not_finite>());
  }
  limit.trust = std::max(limit.trust, check.trust);
  return limit;
}

namespace {

bool needs_row(const Expression& expression, const RulePack& pack) {
  if (expression.kind == ExpressionKind::row_value) return true;
  if (expression.kind == ExpressionKind::limit_of) {
    return needs_row(pack.find_check(expression.name)->limit, pack);
  }
  return std::any_of(expression.operands.begin(), expression.operands.end(),
                     [&](const Expression& operand) { return needs_row(operand, pack); });
}

}  // namespace

bool needs_row(const RuleCheck& check, const RulePack& pack) {
  return needs_row(check.limit, pack);
}

const RuleCheck* required_check(const std::string& role, const LimitScope& scope,
                                const std::function<bool(const RuleCheck&)>& counts) {
  const RuleCheck* of_row = nullptr;
  const RuleCheck* of_all = nullptr;
  bool has_row_check = false;
  for (const RuleCheck& check : scope.pack.checks) {
    if (check.role != role || !counts(check)) continue;
    const bool is_required = evaluate_limit(check, scope).status != LimitStatus::not_applicable;
    const bool hangs_on_row = needs_row(check, scope.pack);
    has_row_check = has_row_check || hangs_on_row;
    if (!is_required) continue;
    const RuleCheck*& first = hangs_on_row ? of_row : of_all;
    if (first == nullptr) first = &check;
  }
  return has_row_check ? of_row : of_all;
}

}  // namespace rules
