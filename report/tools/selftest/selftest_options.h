#pragma once
// The options of `luxgate selftest`.

#include "report/shell/command/command.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

struct SelftestOptions {
  std::vector<std::string> only;  // names of cases or kinds; empty = all
  bool as_json = false;
  bool lists = false;         // names the cases, runs nothing
  bool shows_all = false;     // a line for every number
  bool has_timing = false;    // results are the same bytes without
  std::string report_folder;  // "" = none
  std::uint64_t seed = 1;     // the first of `seeds`
  int seeds = 1;
  int jobs = 0;
};

Command selftest_syntax(SelftestOptions& options);

}  // namespace cli
