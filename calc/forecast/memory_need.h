#pragma once
// What a check of a project takes of memory, before it takes any.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace calc {

// In bytes, about, and rather too much: see memory_need.cpp for what was measured.
struct MemoryNeed {
  double held = 0.0;             // of the project and its results, as long as it is in work
  std::vector<double> of_space;  // more while a space is calculated, the largest first

  // With so many spaces at a time.
  double with(std::size_t spaces_at_once) const;
};

struct ProjectNeed {
  double points = 0.0;  // of all planes, see planned_points()
  MemoryNeed memory;
};
enum class PointCount { at_most, exactly };  // most_planned_points(), planned_points()
// replicates: as of RadiositySettings.
ProjectNeed need_of(const Project& project, int replicates, PointCount count);

// Empty, and an error at the project, where it has more points than the budget allows, or takes
// more memory even with one space at a time. How many threads there are changes nothing. Points are
// counted exactly only where the most that there may be would be too many.
std::optional<ProjectNeed> need_within(const Project& project, int replicates, const Budget& budget,
                                       Diagnostics& diagnostics);

// How many of the spaces may be calculated at the same time, of `most`; at least 1.
std::size_t spaces_within(const MemoryNeed& need, const Budget& budget, std::size_t most);

}  // namespace calc
