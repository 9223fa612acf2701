#pragma once
// Evaluates a formula of a rule pack: the limit of a check for one row, level and project.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "rules/pack/rule_pack.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace rules {

// Everything that a formula may refer to, beside the pack.
struct LimitScope {
  const RulePack& pack;
  const RuleRow* row = nullptr;  // nullptr: none was chosen
  RowLevel level = RowLevel::required;
  std::map<std::string, double> facts = {};  // by id, in base units
  // The measured result of another check, with its interval; empty: not known.
  std::function<std::optional<calc::Estimate>(const RuleCheck&)> result_of = {};
  calc::SpecialPlace special = calc::SpecialPlace::none;  // of the plane
};

enum class LimitStatus {
  known,
  not_applicable,  // the row requires nothing
  unknown,         // something is missing that the limit needs
};

struct Limit {
  LimitStatus status = LimitStatus::known;
  calc::Estimate value;            // of known, base units; an interval if it depends on a result
  Trust trust = Trust::confirmed;  // the worst of everything that it was made of
  RowLevel level;                  // of the values in it: of the scope, if it changes one of them
  calc::Message reason;            // of not_applicable and unknown, in words
  // The special number that the limit is, if the plane is at a special place for which the pack has
  // one.
  const RuleSpecial* special = nullptr;
};

// Returns the limit of a check. The formula must be from scope.pack, which was read without error:
// names are known, units fit and there are no cycles.
Limit evaluate_limit(const RuleCheck& check, const LimitScope& scope);

// Returns whether the limit depends on a value of the row, directly or through another check's
// limit.
bool needs_row(const RuleCheck& check, const RulePack& pack);

// Returns the check of a role that shows whether a row requires anything of it. If a check of the
// role depends on the row, only such checks count: without a value for the ceiling, its uniformity
// is not required either. Null: the row requires nothing of the role. Checks that `counts` refuses
// are skipped.
const RuleCheck* required_check(const std::string& role, const LimitScope& scope,
                                const std::function<bool(const RuleCheck&)>& counts);

}  // namespace rules
