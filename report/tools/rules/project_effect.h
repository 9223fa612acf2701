#pragma once
// Which verdicts of a project another rule pack changes: the project is checked with both.

#include "report/document/document.h"
#include "report/shell/command/command.h"
#include "report/tools/check/check_options.h"
#include "rules/pack/pack_fields.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// What is asked, and what came of it.
struct JudgedLimit {
  std::string limit;          // "≥ 500 lx"; "" of aggregates and classes
  std::string verdict;        // "pass", with what a report must say beside it: "fail, waived"
  std::string severity = {};  // "" of what counts by itself; "advice", "in-aggregate"
};

struct ChangedVerdict {
  std::string place;  // the plane, else the room; "" = the project
  std::string id;     // of the check, the project's own requirement or the aggregate
  std::optional<JudgedLimit> before, after;  // empty: it is not asked
};

struct ProjectEffect {
  std::string project;
  rules::Outcome before = rules::Outcome::nothing_asked, after = rules::Outcome::nothing_asked;
  std::size_t asked = 0;  // requirements of the two packs, with either
  std::vector<ChangedVerdict> changed;
};

// The packs that are compared.
struct ComparedPacks {
  const rules::RulePack& before;
  const rules::RulePack& after;
  const rules::RowNames& rows;  // what rows of `before` are called in `after`
};

// For a check in which one of them stands for both, whichever of them the project names, and with
// the rows that it names by their numbers there. loaded: all others.
std::vector<rules::RulePack> packs_with(bool is_after, const ComparedPacks& compared,
                                        const std::vector<rules::RulePack>& loaded);

// Those that are not the same in both, of requirements, aggregates and classes.
ProjectEffect effect_on(const report::ProjectPart& before, const report::ProjectPart& after,
                        const ComparedPacks& compared);

// Empty after an error, or if the project cannot be judged with one of them, which has been
// printed. check: of one project.
std::optional<ProjectEffect> check_with_both(const CheckOptions& check, const RunContext& context,
                                             const ComparedPacks& compared);

}  // namespace cli
