#pragma once
// Grids of open validation cases, and their statistics.

#include "report/tools/selftest/case.h"
#include "tests/validation/open_places.h"
#include "tests/validation/open_tables.h"

#include <optional>

namespace validation {

struct GridCase {
  Places places;             // its points, all of the same area
  double maintenance = 1.0;  // factor of all values
  double known_to = 0.0;     // relative
};

// The grid that a number is about; empty if the tables do not say.
std::optional<GridCase> grid_case(const Row& item, const Row& scalar, const Tables& tables);

// Average, minimum, maximum, U0 or Ud, with the program's own interval.
cli::selftest::Measured grid_statistic(const Row& scalar, const GridCase& grid,
                                       const cli::selftest::Solution& solution);

}  // namespace validation
