#pragma once
// <require pack="..." row="..." role="..."/>: what a rule pack requires of a plane.

#include "calc/base/message.h"
#include "calc/base/xml_reader.h"
#include "rules/binding/requirement_reader.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/limit.h"
#include "rules/pack/rule_pack.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// The scene that a requirement names, and why it does not do for emergency lighting; "" = it does.
struct ChosenScene {
  std::string id;
  calc::Message problem;
  calc::Message outage_problem;  // why no single luminaire can be put out in it
};

// One requirement for each check of the pack with the role, in order, without those for which the
// row specifies nothing. What cannot be judged (a value that the pack does not know, a fact that is
// not stated, a limit that hangs on another plane's result, light that luxgate does not calculate,
// a plane that faces another way or lies at another height than the role's) has its reason in
// `problem`, a height that is only unusual in `note`. `scene`: as read and checked by the caller.
// role: of a plane that a workplace has made; "": the attribute, or else the pack's own. Empty
// after an error, which is reported.
std::vector<Requirement> read_rule_reference(calc::ElementReader& reader, const std::string& role,
                                             const RequirementContext& context,
                                             const ChosenScene& scene);

// Ids of the checks of a role that a row, or a pack without rows, asks for.
std::vector<std::string> asked_checks(const std::string& role, const LimitScope& scope);

// The attribute "pack", see named_pack(). nullptr after an error.
const RulePack* find_pack(calc::ElementReader& reader, const std::vector<RulePack>& packs);
// The attribute "row"; nullptr if there is none, or after an error.
const RuleRow* find_row(calc::ElementReader& reader, const RulePack& pack);
// The attributes "level", required without it, and "level-because", "" without it.
struct ChosenLevel {
  RowLevel level;
  std::string because;
};
ChosenLevel read_level(calc::ElementReader& reader, const RulePack& pack, const RuleRow* row);

// What can be said of row, level, role and facts without a pack.
void check_row_values(calc::ElementReader& reader);

// "EN 12464-1:2021 34.2": title, edition and the check's clause or else the row, with
// level_words() of the values in the limit, and with trust_remark() where there is one.
calc::Message clause_text(const RulePack& pack, const RuleCheck& check, const RuleRow* row,
                          const RowLevel& level, Trust trust);

// "task-illuminance=500 lx; ..." in base units, by id. Only facts of the pack, each once.
std::map<std::string, double> read_facts(calc::ElementReader& reader, const RulePack& pack);

}  // namespace rules
