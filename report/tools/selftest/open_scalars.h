#pragma once
// Averages, fluxes, form factors and grid statistics of the open validation cases.

#include "report/tools/selftest/case.h"
#include "report/tools/selftest/open_tables.h"

#include <string>
#include <vector>

namespace cli::selftest {

// What tables say of one such number and what it takes to calculate it.
struct ScalarResult {
  CaseResult result;
  std::vector<std::string> printed;   // of each number
  std::vector<std::string> left_out;  // numbers that were not calculated, and why
};

ScalarResult run_scalars(const Row& row, const Tables& tables, const Effort& effort);

}  // namespace cli::selftest
