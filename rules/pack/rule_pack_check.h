#pragma once
// What can only be seen with a whole rule pack at hand: names in formulas, their units, circles.

#include "calc/base/diagnostics.h"
#include "rules/pack/rule_pack.h"

namespace rules {

void check_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics);

}  // namespace rules
