#pragma once
// Reads <require pack="..." row="..." role="..."/>: what a rule pack requires of a plane.

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

// The scene that a requirement names, and why it cannot serve for emergency lighting; "" = it can.
struct ChosenScene {
  std::string id;
  calc::Message problem;
  calc::Message outage_problem;  // why no single luminaire can be put out in it
};

// Returns one requirement for each check of the role, in the pack's order, without those for which
// the row specifies nothing. `problem` says why a requirement cannot be judged: the pack lacks the
// value, a fact is not stated, the limit depends on another plane's result, luxgate does not
// calculate the light, or the plane's direction or height is not the role's. `note` names a merely
// unusual height. scene: read and checked by the caller. role: of a plane made by a workplace; "" =
// the attribute, or else the pack's own role. Empty after an error, which is reported.
std::vector<Requirement> read_rule_reference(calc::ElementReader& reader, const std::string& role,
                                             const RequirementContext& context,
                                             const ChosenScene& scene);

// Returns the ids of the checks of a role that a row, or a pack without rows, requires.
std::vector<std::string> asked_checks(const std::string& role, const LimitScope& scope);

// Reads the attribute "pack", see named_pack(); returns nullptr after an error.
const RulePack* find_pack(calc::ElementReader& reader, const std::vector<RulePack>& packs);
// Reads the attribute "row"; returns nullptr if there is none, or after an error.
const RuleRow* find_row(calc::ElementReader& reader, const RulePack& pack);
// The attributes "level" (required if absent) and "level-because" ("" if absent).
struct ChosenLevel {
  RowLevel level;
  std::string because;
};
ChosenLevel read_level(calc::ElementReader& reader, const RulePack& pack, const RuleRow* row);

// Checks row, level, role and facts as far as that is possible without a pack.
void check_row_values(calc::ElementReader& reader);

// Returns "EN 12464-1:2021 34.2": title, edition and the check's clause or else the row, with
// level_words() of the values in the limit and trust_remark(), if any.
calc::Message clause_text(const RulePack& pack, const RuleCheck& check, const RuleRow* row,
                          const RowLevel& level, Trust trust);

// Reads "task-illuminance=500 lx; ..." by id, in base units; each is a fact of the pack, once.
std::map<std::string, double> read_facts(calc::ElementReader& reader, const RulePack& pack);

}  // namespace rules
