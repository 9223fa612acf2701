#pragma once
// The effect of a change on the limits of a rule pack.

#include "calc/base/names.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <functional>
#include <string>

namespace rules {

// stricter: no limit became easier to meet, and one harder; easier: the reverse. unclear: unknown.
enum class Tightening { none, stricter, easier, unclear };

// Returns the joint effect of two changes.
Tightening joined(Tightening a, Tightening b);

// Returns the effect of one limit in place of another; unclear if an upper limit becomes a lower
// one or the reverse.
Tightening tightening_of(Comparison before_by, double before, Comparison after_by, double after);

// Returns whether a limit may depend on the change.
using HangsOn = std::function<bool(const RuleCheck&)>;

// Returns the effect over all checks that both packs have, for every row of `before` at all levels
// that a project may choose. after: the same pack with the change, and the same rows. A limit known
// only to a project, by a fact or a result, makes the effect unclear if it depends on the change; a
// limit that is not known at all, before or after, does not count.
Tightening tightening_of(const RulePack& before, const RulePack& after, const HangsOn& hangs_on);

// Returns the effect on a single row, by its place in both packs.
Tightening tightening_of_row(const RulePack& before, const RulePack& after, std::size_t row,
                             const HangsOn& hangs_on);

// Returns whether the formula of a check, or of a check whose limit it uses, has such a part.
bool has_part(const RuleCheck& check, const RulePack& pack, ExpressionKind kind,
              const std::string& name);

}  // namespace rules

namespace calc {

// "none" and "unclear" have no word: reports do not mention them.
template <>
struct EnumNames<rules::Tightening> {
  static constexpr EnumName<rules::Tightening> list[] = {{rules::Tightening::stricter, "stricter"},
                                                         {rules::Tightening::easier, "easier"}};
};

}  // namespace calc
