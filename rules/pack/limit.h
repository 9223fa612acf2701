#pragma once
// A formula of a rule pack as a number: the limit of a check for one row, level and project.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "rules/pack/rule_pack.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace rules {

// What a formula may refer to, beside the pack.
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
  unknown,         // something is missing that the limit hangs on
};

struct Limit {
  LimitStatus status = LimitStatus::known;
  calc::Estimate value;            // of known, base units; an interval if it hangs on a result
  Trust trust = Trust::confirmed;  // the worst of everything that it was made of
  RowLevel level;                  // of the values in it: of the scope, if it changes one of them
  calc::Message reason;            // of not_applicable and unknown, in words
  // The number that it is, where the plane is at a special place and the pack has one for that.
  const RuleSpecial* special = nullptr;
};

// The formula must be one of scope.pack, which was read without error: names are known, units fit
// and nothing goes round in a circle.
Limit evaluate_limit(const RuleCheck& check, const LimitScope& scope);

// Whether its limit hangs on a value of the row, or on the limit of a check that does.
bool needs_row(const RuleCheck& check, const RulePack& pack);

// The check of a role that says whether a row requires something of it: one that hangs on the row,
// if there is one, for of a ceiling without a value in the row a uniformity is not required either.
// Null: the row requires nothing of the role. Checks that `counts` refuses are passed over.
const RuleCheck* required_check(const std::string& role, const LimitScope& scope,
                                const std::function<bool(const RuleCheck&)>& counts);

}  // namespace rules
