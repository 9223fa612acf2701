#include "calc/forecast/memory_need.h"

#include "calc/scene/receiver_kernel.h"
#include "calc/scene/sensor_grid.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace calc {
namespace {

// Bytes.  [measured on x86-64 by the most that was resident: boxes of 12 triangles, ceilings full
// of panels, planes of one and of four million points with 16 and with 32 replicates]
constexpr double kProgram = 64.0 * (1 << 20);
constexpr double kPointHeld = 300.0;         // the point and its row in the report
constexpr double kReceiverReplicate = 65.0;  // of each receiver and replicate
constexpr double kTriangleHeld = 80.0, kTriangleInWork = 900.0;
constexpr double kObjectHeld = 700.0, kLuminaireInWork = 2700.0;

struct SpaceCounts {
  double points = 0.0, receivers = 0.0, triangles = 0.0;
};

SpaceCounts count_in(const Space& space, PointCount count) {
  SpaceCounts counts;
  for (const CalcPlane& plane : space.planes) {
    const double points =
        count == PointCount::exactly ? planned_points(plane) : most_planned_points(plane);
    counts.points += points;
    counts.receivers += points * static_cast<double>(receivers_per_point(plane.derived));
  }
  for (const Body& body : space.bodies) {
    counts.triangles += static_cast<double>(body.triangle.size());
  }
  return counts;
}

}  // namespace

double MemoryNeed::with(std::size_t spaces_at_once) const {
  double all = held;
  for (std::size_t i = 0; i < std::min(spaces_at_once, of_space.size()); ++i) all += of_space[i];
  return all;
}

ProjectNeed need_of(const Project& project, int replicates, PointCount count) {
  ProjectNeed need;
  need.memory.held = kProgram;
  for (const Space& space : project.spaces) {
    const SpaceCounts counts = count_in(space, count);
    const auto luminaires = static_cast<double>(space.luminaires.size());
    need.points += counts.points;
    need.memory.held += kPointHeld * counts.points + kTriangleHeld * counts.triangles +
                        kObjectHeld * (luminaires + static_cast<double>(space.bodies.size()));
    need.memory.of_space.push_back(kReceiverReplicate * replicates * counts.receivers +
                                   kTriangleInWork * counts.triangles +
                                   kLuminaireInWork * luminaires);
  }
  std::sort(need.memory.of_space.begin(), need.memory.of_space.end(), std::greater<>());
  return need;
}

std::optional<ProjectNeed> need_within(const Project& project, int replicates, const Budget& budget,
                                       Diagnostics& diagnostics) {
  // Not "greater than": what is not a number must not pass.
  const auto fits = [&](BudgetOf of, double amount) { return amount <= budget[of]; };
  const ProjectNeed most = need_of(project, replicates, PointCount::at_most);
  if (fits(BudgetOf::points, most.points) && fits(BudgetOf::memory, most.memory.with(1))) {
    return most;
  }
  const ProjectNeed need = need_of(project, replicates, PointCount::exactly);
  for (const auto& [of, amount] : {std::pair{BudgetOf::points, need.points},
                                   std::pair{BudgetOf::memory, need.memory.with(1)}}) {
    if (fits(of, amount)) continue;
    report_beyond(diagnostics, {project.path, 0, 0}, "the project takes", of, amount, budget);
    return std::nullopt;
  }
  return need;
}

std::size_t spaces_within(const MemoryNeed& need, const Budget& budget, std::size_t most) {
  std::size_t at_once = std::max<std::size_t>(most, 1);
  while (at_once > 1 && need.with(at_once) > budget[BudgetOf::memory]) --at_once;
  return at_once;
}

}  // namespace calc
