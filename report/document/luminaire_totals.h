#pragma once
// What a schedule of luminaires adds up to.

#include "report/document/document.h"

#include <cstddef>
#include <string>

namespace report {

// Of all types of a project together.
struct LuminaireTotals {
  int count = 0;
  double flux_lm = 0, power_w = 0;
  bool is_power_known = true;  // of every type that is used
};

LuminaireTotals totals_of(const std::vector<LuminaireRow>& luminaires);

// By which schedules and plans name a type: "A" to "Z", then "AA" and so on, in the order of the
// schedule.
std::string position_letter(std::size_t row);

}  // namespace report
