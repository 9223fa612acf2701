#pragma once
// Averages, fluxes, form factors and grid statistics of the open validation cases.

#include "report/tools/selftest/case.h"
#include "tests/validation/open_tables.h"

#include <string>
#include <vector>

namespace validation {

// What tables say of one such number and what it takes to calculate it.
struct ScalarResult {
  cli::selftest::CaseResult result;
  std::vector<std::string> printed;   // of each number
  std::vector<std::string> left_out;  // numbers that were not calculated, and why
};

ScalarResult run_scalars(const Row& row, const Tables& tables, const cli::selftest::Effort& effort);

}  // namespace validation
