#pragma once
// What is doubtful in a rule pack that has no error.

#include "calc/base/diagnostics.h"
#include "rules/pack/rule_pack.h"

namespace rules {

// Warnings: names that no formula uses, numbers marked unverified.
void lint_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics);

}  // namespace rules
