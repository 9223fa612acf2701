#pragma once
// All rooms of a project that are asked the same row of a rule pack, taken together: what they come
// to, and where it is closest.

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
  // The gravest of them, and of the pack's aggregates that they are members of.
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  // The smallest margin of what was judged and has one, and whose it is; empty: nothing has.
  std::optional<double> margin = {};
  std::string room = {}, plane = {}, requirement = {};

  // Wherever it is asked all of the row has a verdict.
  bool is_wholly_judged() const { return whole - open == times; }
  // Asked as a whole wherever it is asked, and everything met that can be judged.
  bool is_met() const { return outcome == rules::Outcome::pass && whole == times && excepted == 0; }
};

// In the order in which rows are first asked. Rows with levels of their own are rows by themselves.
std::vector<RowUse> row_uses(const ProjectPart& project);

}  // namespace report
