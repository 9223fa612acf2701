#pragma once
// All rooms of a project that use the same row of a rule pack, taken together: their outcome, and
// the smallest margin.

#include "report/document/document.h"
#include "rules/verdict/outcome.h"

#include <optional>
#include <string>
#include <vector>

namespace report {

struct RowUse {
  calc::Message clause;            // "EN 12464-1:2021 34.2"
  bool is_user_supplied = false;   // see rules::RuleOrigin
  std::vector<std::string> rooms;  // ids, each once
  int times = 0;                   // it is asked, by workplaces or by planes of a room together
  int whole = 0;                   // of these: nothing of the row was never asked
  int open = 0;                    // of the whole: something of the row cannot be judged there
  int excepted = 0;                // of these: something of the row is waived or left out
  int requirements = 0, met = 0;   // that count, each once
  // The gravest outcome of them, and of the pack's aggregates that they are members of.
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  // The smallest margin of judged requirements, and its place; empty: nothing has a margin.
  std::optional<double> margin = {};
  std::string room = {}, plane = {}, requirement = {};

  // Returns whether all of the row has a verdict wherever it is required.
  bool is_wholly_judged() const { return whole - open == times; }
  // Returns whether all of the row is required wherever it is used, and everything that can be
  // judged is met.
  bool is_met() const { return outcome == rules::Outcome::pass && whole == times && excepted == 0; }
};

// Returns the rows in the order of their first use. Rows at different levels count as different
// rows.
std::vector<RowUse> row_uses(const ProjectPart& project);

}  // namespace report
