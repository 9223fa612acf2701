#pragma once
// <deviation>: a project says that a plane is not quite the one that a standard's number is about,
// and that somebody lives with it.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"
#include "rules/catalogue/deviation.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace rules {

// As the tables of the project file would have it, which know no rules.
const calc::ElementRow& deviation_element();

// Those that stand in `parent`, a <require> or a <workplace>. role: of a workplace's plane, whose
// deviations name it; "" in a <require>, whose do not. Each aspect counts once.
std::vector<StatedDeviation> read_deviations(calc::ElementReader& parent, const std::string& role);

// Reports deviations of a workplace that name no role of the pack.
void check_deviation_roles(calc::ElementReader& workplace, const RulePack& pack);

}  // namespace rules
