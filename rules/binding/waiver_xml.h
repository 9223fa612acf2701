#pragma once
// <waiver>: a project says which checks of a rule pack's row somebody lives without.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/waiver.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace rules {

// As the tables of the project file would have it, which know no rules.
const calc::ElementRow& waiver_element();

struct WaivedCheck {
  std::string check;  // its id
  calc::Waiver by;
  calc::SourceLocation where;
};

// Those that stand in `parent`, a <require> or a <workplace>, check by check; each counts once.
// pack: the one that the parent names; null: not known, and then names are not compared.
std::vector<WaivedCheck> read_waived_checks(calc::ElementReader& parent, const RulePack* pack);

// Reports those that the parent does not ask. asked: ids of the checks that it does.
void check_waived_are_asked(calc::ElementReader& parent, const std::vector<WaivedCheck>& waived,
                            const RulePack& pack, const std::vector<std::string>& asked);

}  // namespace rules
