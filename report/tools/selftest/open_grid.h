#pragma once
// Grids of open validation cases, and their statistics.

#include "report/tools/selftest/case.h"
#include "report/tools/selftest/open_places.h"
#include "report/tools/selftest/open_tables.h"

#include <optional>

namespace cli::selftest {

struct GridCase {
  Places places;             // its points, all of the same area
  double maintenance = 1.0;  // factor of all values
  double known_to = 0.0;     // relative
};

// The grid that a number is about; empty if the tables do not say.
std::optional<GridCase> grid_case(const Row& item, const Row& scalar, const Tables& tables);

// Average, minimum, maximum, U0 or Ud, with the program's own interval.
Measured grid_statistic(const Row& scalar, const GridCase& grid, const Solution& solution);

}  // namespace cli::selftest
