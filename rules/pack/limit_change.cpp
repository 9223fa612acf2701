#include "rules/pack/limit_change.h"

#include "rules/pack/limit.h"

#include <algorithm>
#include <cstddef>

namespace rules {
namespace {

bool has_part(const Expression& expression, const RulePack& pack,
              const std::function<bool(const Expression&)>& is_it) {
  if (is_it(expression)) return true;
  if (expression.kind == ExpressionKind::limit_of) {
    return has_part(pack.find_check(expression.name)->limit, pack, is_it);
  }
  return std::any_of(expression.operands.begin(), expression.operands.end(),
                     [&](const Expression& operand) { return has_part(operand, pack, is_it); });
}

// Returns whether the limit depends on a fact or result that only a project knows.
bool hangs_on_project(const RuleCheck& check, const RulePack& pack) {
  return has_part(check.limit, pack, [](const Expression& part) {
    return part.kind == ExpressionKind::fact || part.kind == ExpressionKind::result_of;
  });
}

// Returns whether the check is only an alternative to another, so that adding it is not stricter.
bool is_alternative(const RuleCheck& check, const RulePack& pack) {
  const bool is_in_aggregate = std::any_of(
      pack.aggregates.begin(), pack.aggregates.end(), [&](const RuleAggregate& aggregate) {
        const auto& checks = aggregate.checks;
        return aggregate.rule != AggregateRule::all &&
               std::find(checks.begin(), checks.end(), check.id) != checks.end();
      });
  return is_in_aggregate || !check.instead_of.empty() ||
         std::any_of(pack.checks.begin(), pack.checks.end(),
                     [&](const RuleCheck& other) { return other.instead_of == check.id; });
}

class LimitChange {
 public:
  LimitChange(const RulePack& before, const RulePack& after) : before_(before), after_(after) {}

  Tightening of(const RuleCheck& check, const RuleCheck& changed, const RuleRow* row_before,
                const RuleRow* row_after, const RowLevel& level) const {
    const Limit was = evaluate_limit(check, {before_, row_before, level});
    const Limit is = evaluate_limit(changed, {after_, row_after, level});
    if (was.status == LimitStatus::unknown || is.status == LimitStatus::unknown) {
      // Where the scale ends, or for values off it, nobody can take steps.
      if (level.steps != 0) return Tightening::none;
      const bool is_never_known = was.status == is.status && !hangs_on_project(check, before_) &&
                                  !hangs_on_project(changed, after_);
      return is_never_known ? Tightening::none : Tightening::unclear;
    }
    if (was.status != is.status) {
      if (is_alternative(check, before_) &&
          !changes_with_all_others(check, row_before, row_after)) {
        return Tightening::unclear;
      }
      return is.status == LimitStatus::known ? Tightening::stricter : Tightening::easier;
    }
    if (was.status == LimitStatus::not_applicable) return Tightening::none;
    return tightening_of(check.comparison, was.value.value, changed.comparison, is.value.value);
  }

 private:
  bool is_known(const RuleCheck& check, const RulePack& pack, const RuleRow* row) const {
    return evaluate_limit(check, {pack, row}).status == LimitStatus::known;
  }

  // Returns whether alternatives of a check are required exactly when the check is, before and
  // after.
  bool changes_with_all_others(const RuleCheck& check, const RuleRow* row_before,
                               const RuleRow* row_after) const {
    for (const RuleAggregate& aggregate : before_.aggregates) {
      const auto& checks = aggregate.checks;
      if (std::find(checks.begin(), checks.end(), check.id) != checks.end()) return false;
    }
    for (const RuleCheck& other : before_.checks) {
      if (other.instead_of != check.id && check.instead_of != other.id) continue;
      const RuleCheck* other_after = after_.find_check(other.id);
      if (other_after == nullptr) return false;
      if (is_known(other, before_, row_before) != is_known(check, before_, row_before)) {
        return false;
      }
      if (is_known(*other_after, after_, row_after) !=
          is_known(*after_.find_check(check.id), after_, row_after)) {
        return false;
      }
    }
    return true;
  }

  const RulePack& before_;
  const RulePack& after_;
};

Tightening tightening_for(const RulePack& before, const RulePack& after, const RuleRow* row_before,
                          const RuleRow* row_after, const HangsOn& hangs_on) {
  const LimitChange change(before, after);
  const calc::Names levels =
      row_before == nullptr ? calc::Names{level_names().front()} : before.levels_of(*row_before);
  Tightening result = Tightening::none;
  for (const RuleCheck& check : before.checks) {
    const RuleCheck* changed = after.find_check(check.id);
    if (changed == nullptr || !hangs_on(check)) continue;
    for (const auto& name : levels) {
      result = joined(result, change.of(check, *changed, row_before, row_after, level_named(name)));
    }
    if (row_after == nullptr || row_before->has_modified_level()) continue;
    result = joined(result, change.of(check, *changed, row_before, row_after, RowLevel::modified));
  }
  return result;
}

}  // namespace

Tightening joined(Tightening a, Tightening b) {
  if (a == Tightening::none) return b;
  if (b == Tightening::none || a == b) return a;
  return Tightening::unclear;
}

Tightening tightening_of(Comparison before_by, double before, Comparison after_by, double after) {
  const bool is_lower = is_lower_limit(before_by);
  if (is_lower_limit(after_by) != is_lower) return Tightening::unclear;
  const auto stricter_if = [](bool is) { return is ? Tightening::stricter : Tightening::easier; };
  if (before != after) return stricter_if((after > before) == is_lower);
  if (before_by == after_by) return Tightening::none;
  return stricter_if(after_by == Comparison::more_than || after_by == Comparison::less_than);
}

Tightening tightening_of(const RulePack& before, const RulePack& after, const HangsOn& hangs_on) {
  if (before.rows.empty()) return tightening_for(before, after, nullptr, nullptr, hangs_on);
  Tightening result = Tightening::none;
  for (std::size_t row = 0; row < before.rows.size(); ++row) {
    result = joined(result, tightening_of_row(before, after, row, hangs_on));
  }
  return result;
}

Tightening tightening_of_row(const RulePack& before, const RulePack& after, std::size_t row,
                             const HangsOn& hangs_on) {
  return tightening_for(before, after, &before.rows[row], &after.rows[row], hangs_on);
}

bool has_part(const RuleCheck& check, const RulePack& pack, ExpressionKind kind,
              const std::string& name) {
  return has_part(check.limit, pack,
                  [&](const Expression& part) { return part.kind == kind && part.name == name; });
}

}  // namespace rules
