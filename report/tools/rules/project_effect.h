#pragma once
// Which verdicts of a project another rule pack changes: the project is checked with both.

#include "report/document/document.h"
#include "report/shell/command.h"
#include "report/tools/check/check_options.h"
#include "rules/pack/pack_fields.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// What is asked, and what came of it.
struct JudgedLimit {
  std::string limit;    // "≥ 500 lx"; "" of aggregates and classes
  std::string verdict;  // "pass", with what a report must say beside it: "fail, waived"
};

struct ChangedVerdict {
  std::string place;                         // the plane, else the room; "" = the project
  std::string id;                            // of the requirement or aggregate
  std::optional<JudgedLimit> before, after;  // empty: it is not asked
};

struct ProjectEffect {
  std::string project;
  rules::Outcome before = rules::Outcome::nothing_asked, after = rules::Outcome::nothing_asked;
  std::size_t asked = 0;  // requirements of the two packs, with either
  std::vector<ChangedVerdict> changed;
};

// Packs for a run of a project in which `pack` stands for both of the two that are compared,
// whichever of them the project names, and by the rows that it names: `loaded` without those.
// rows_of_first, rows_of_second: what rows of `pack` are called in them.
struct ComparedPacks {
  const rules::RulePack& before;
  const rules::RulePack& after;
  const rules::RowNames& rows;  // of `before`, by what they are called in `after`
};
std::vector<rules::RulePack> packs_with(bool is_after, const ComparedPacks& compared,
                                        const std::vector<rules::RulePack>& loaded);

// Those that are not the same in both, of requirements, aggregates and classes.
ProjectEffect effect_on(const report::ProjectPart& before, const report::ProjectPart& after,
                        const ComparedPacks& compared);

// Empty after an error, which has been printed. check: of one project.
std::optional<ProjectEffect> check_with_both(const CheckOptions& check, const RunContext& context,
                                             const ComparedPacks& compared);

}  // namespace cli
