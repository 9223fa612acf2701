#pragma once
// <deviation>: a project states that a plane differs from the plane that a standard's number is
// about, and that this is accepted.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"
#include "rules/catalogue/deviation.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace rules {

// Returns the row for the tables of the project file, which do not know rules.
const calc::ElementRow& deviation_element();

// Returns the deviations in `parent`, a <require> or a <workplace>. role: role of a workplace's
// plane, which its deviations name; "" in a <require>, whose deviations name none. Each aspect
// counts once.
std::vector<StatedDeviation> read_deviations(calc::ElementReader& parent, const std::string& role);

// Reports deviations of a workplace whose role is not in the pack.
void check_deviation_roles(calc::ElementReader& workplace, const RulePack& pack);

}  // namespace rules
