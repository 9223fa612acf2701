#pragma once
// Levels that would make a project pass, in words that every format shares. Names in them are
// printable; nothing is escaped.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// "Full output", "Light scene evening"
std::string advice_scene(const Texts& t, const LevelAdvice& advice);
// What came of it: sentences. reason: of none_found, in the reader's language.
std::string advice_outcome(const Texts& t, const LevelAdvice& advice, const std::string& reason);
// The same with its own reason.
std::string advice_outcome(const Texts& t, const LevelAdvice& advice);

// There is something to be said: somebody has asked, and something is not met.
bool has_advice(const ProjectPart& project);

struct AdviceRow {                              // of a group with levels
  std::string group, luminaires, now, advised;  // "window", "5", "100 %", "64 %"
};
std::vector<AdviceRow> advice_rows(const Texts& t, const LevelAdvice& advice);

struct AdviceList {
  std::string title;
  std::vector<std::string> items;  // "Office, Desk: average ≥ 500 lx"
};
// What excludes each other, what is not met: those that there are.
std::vector<AdviceList> advice_lists(const Texts& t, const ProjectPart& project,
                                     const LevelAdvice& advice);

}  // namespace report
