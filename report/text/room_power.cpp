#include "report/text/room_power.h"

#include "calc/scene/installed_power.h"
#include "calc/scene/polygon.h"
#include "report/text/words.h"

#include <glm/glm.hpp>

#include <cmath>
#include <utility>

namespace report {
namespace {

const PlanePart* reference_plane(const SpacePart& space) {
  const PlanePart* largest = nullptr;
  std::pair<bool, double> most{false, 0.0};
  for (const PlanePart& plane : space.planes) {
    if (!plane.is_computed || !is_plain_illuminance(plane) || plane.outline_m.empty() ||
        !is_horizontal(glm::cross(plane.grid.u, plane.grid.v)) || !(plane.average.low > 0.0)) {
      continue;
    }
    const std::pair of(!plane.findings.empty(), std::abs(calc::signed_area(plane.outline_m)));
    if (of <= most) continue;
    largest = &plane;
    most = of;
  }
  return largest;
}

}  // namespace

std::optional<PowerByLight> power_by_light(const SpacePart& space) {
  const std::optional<double> density = space.power.density_w_m2();
  if (!density || space.power.luminaires == 0) return {};
  const PlanePart* plane = reference_plane(space);
  if (plane == nullptr) return {};
  const auto at = [&](double average_lx) {
    return calc::power_per_100_lx_w_m2(*density, average_lx);
  };
  const calc::Estimate& average = plane->average;  // the quotient falls with it
  return PowerByLight{plane, {at(average.value), at(average.high), at(average.low)}};
}

}  // namespace report
