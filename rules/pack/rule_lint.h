#pragma once
// What is doubtful in a rule pack that can be read.

#include "calc/base/diagnostics.h"
#include "rules/pack/rule_pack.h"

namespace rules {

// Warnings: names that no formula uses, numbers marked unverified, unusual numbers of rows, rows
// that require nothing and do not say why. Errors: numbers of rows that cannot be meant.
void lint_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics);

}  // namespace rules
