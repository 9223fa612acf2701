#pragma once
// Words for levels that would make a project pass, shared by every format. Names in them are
// printable; nothing is escaped.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// Returns "Full output", "Light scene evening".
std::string advice_scene(const Texts& t, const LevelAdvice& advice);
// Returns sentences about the outcome. reason: of none_found, in the reader's language.
std::string advice_outcome(const Texts& t, const LevelAdvice& advice, const std::string& reason);
// Returns the sentences with the advice's own reason.
std::string advice_outcome(const Texts& t, const LevelAdvice& advice);

// Returns whether there is advice to report: it was requested, and something is not met.
bool has_advice(const ProjectPart& project);

struct AdviceRow {                              // of a group with levels
  std::string group, luminaires, now, advised;  // "window", "5", "100 %", "64 %"
};
std::vector<AdviceRow> advice_rows(const Texts& t, const LevelAdvice& advice);

struct AdviceList {
  std::string title;
  std::vector<std::string> items;  // "Office, Desk: average ≥ 500 lx"
};
// Returns the lists that exist: requirements that exclude each other, requirements that are not
// met.
std::vector<AdviceList> advice_lists(const Texts& t, const ProjectPart& project,
                                     const LevelAdvice& advice);

}  // namespace report
