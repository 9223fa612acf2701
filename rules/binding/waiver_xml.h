#pragma once
// <waiver>: a project names checks of a rule pack's row whose failure is accepted.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/waiver.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace rules {

// Returns the row for the tables of the project file, which do not know rules.
const calc::ElementRow& waiver_element();

struct WaivedCheck {
  std::string check;  // its id
  calc::Waiver by;
  calc::SourceLocation where;
};

// Returns the waived checks in `parent`, a <require> or a <workplace>; each counts once. pack: the
// pack that the parent names; null = not known, and names are not compared.
std::vector<WaivedCheck> read_waived_checks(calc::ElementReader& parent, const RulePack* pack);

// Reports waived checks that the parent does not require. asked: ids of the required checks.
void check_waived_are_asked(calc::ElementReader& parent, const std::vector<WaivedCheck>& waived,
                            const RulePack& pack, const std::vector<std::string>& asked);

}  // namespace rules
