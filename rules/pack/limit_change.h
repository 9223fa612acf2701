#pragma once
// What one change does to the limits of a rule pack.

#include "calc/base/names.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <functional>
#include <string>

namespace rules {

// stricter: no limit became easier to meet, and one harder; easier: the other way round. unclear:
// nobody can be sure.
enum class Tightening { none, stricter, easier, unclear };

// Both together.
Tightening joined(Tightening a, Tightening b);

// Of one limit in place of another; of a lower one in place of an upper one nobody can be sure.
Tightening tightening_of(Comparison before_by, double before, Comparison after_by, double after);

// Whether a limit may hang on what was changed.
using HangsOn = std::function<bool(const RuleCheck&)>;

// Over all checks that both packs have, for every row of `before` at all levels that a project may
// ask for. after: the same pack but for the change; of the same rows. A limit that only a
// project knows, by a fact or a result, makes it unclear if it hangs on the change; one that nobody
// knows, before or after, is no limit.
Tightening tightening_of(const RulePack& before, const RulePack& after, const HangsOn& hangs_on);

// Of one row alone, by its place in both packs.
Tightening tightening_of_row(const RulePack& before, const RulePack& after, std::size_t row,
                             const HangsOn& hangs_on);

// Whether the formula of a check, or of one whose limit is in it, has such a part.
bool has_part(const RuleCheck& check, const RulePack& pack, ExpressionKind kind,
              const std::string& name);

}  // namespace rules

namespace calc {

// "none" and "unclear" have no word: nothing is said.
template <>
struct EnumNames<rules::Tightening> {
  static constexpr EnumName<rules::Tightening> list[] = {{rules::Tightening::stricter, "stricter"},
                                                         {rules::Tightening::easier, "easier"}};
};

}  // namespace calc
