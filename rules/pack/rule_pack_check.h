#pragma once
// Checks that need a whole rule pack: names in formulas, their units, cycles.

#include "calc/base/diagnostics.h"
#include "rules/pack/rule_pack.h"

namespace rules {

void check_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics);

}  // namespace rules
