#pragma once
// Estimates the memory for a check of a project before it takes any.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace calc {

// Approximate bytes, rather too many: see memory_need.cpp for measurements.
struct MemoryNeed {
  double held = 0.0;             // of the project and its results, as long as it is in work
  std::vector<double> of_space;  // more while a space is calculated, the largest first

  // Returns the need with so many spaces at a time.
  double with(std::size_t spaces_at_once) const;
};

struct ProjectNeed {
  double points = 0.0;  // of all planes, see planned_points()
  MemoryNeed memory;
};
enum class PointCount { at_most, exactly };  // most_planned_points(), planned_points()
// Returns the need of a project. replicates: as of RadiositySettings.
ProjectNeed need_of(const Project& project, int replicates, PointCount count);

// Returns the need. Empty, with an error at the project, if it has more points than the budget
// allows, or needs more memory even with one space at a time; the number of threads does not
// matter. Points are counted exactly only if their upper bound exceeds the budget.
std::optional<ProjectNeed> need_within(const Project& project, int replicates, const Budget& budget,
                                       Diagnostics& diagnostics);

// Returns how many of the spaces may be calculated at the same time, of `most`; at least 1.
std::size_t spaces_within(const MemoryNeed& need, const Budget& budget, std::size_t most);

}  // namespace calc
