#pragma once
// Finds the verdicts of a project that another rule pack changes: the project is checked with both.

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

// A requirement and its result.
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

// The compared packs.
struct ComparedPacks {
  const rules::RulePack& before;
  const rules::RulePack& after;
  const rules::RowNames& rows;  // what rows of `before` are called in `after`
};

// Returns the packs for a check in which one of the two replaces both, whichever the project names,
// with the rows that the project names by their numbers there. loaded: all others.
std::vector<rules::RulePack> packs_with(bool is_after, const ComparedPacks& compared,
                                        const std::vector<rules::RulePack>& loaded);

// Returns requirements, aggregates and classes that differ between both.
ProjectEffect effect_on(const report::ProjectPart& before, const report::ProjectPart& after,
                        const ComparedPacks& compared);

// Checks a project with both. Empty after an error, or if the project cannot be judged with one of
// them, which is printed. check: of one project.
std::optional<ProjectEffect> check_with_both(const CheckOptions& check, const RunContext& context,
                                             const ComparedPacks& compared);

}  // namespace cli
