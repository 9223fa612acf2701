#pragma once
// Finds doubtful parts of a rule pack that can be read.

#include "calc/base/diagnostics.h"
#include "rules/pack/rule_pack.h"

namespace rules {

// Reports warnings: names that no formula uses, numbers marked unverified, unusual numbers of rows,
// rows that require nothing and do not say why. Reports errors: impossible numbers of rows.
void lint_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics);

}  // namespace rules
