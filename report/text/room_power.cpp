#include "report/text/room_power.h"

#include "calc/scene/installed_power.h"
#include "calc/scene/polygon.h"
#include "report/text/plane_names.h"
#include "report/text/words.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace report {
namespace {

// Something is asked of its average in normal operation.
bool is_asked_for_average(const PlanePart& plane) {
  return std::any_of(plane.findings.begin(), plane.findings.end(), [](const auto& finding) {
    const rules::Requirement& asked = finding.requirement;
    return asked.metric == rules::Metric::average && asked.scene.empty() &&
           asked.state == rules::LightState::maintained;
  });
}

const PlanePart* reference_plane(const SpacePart& space) {
  constexpr double kLarger = 1 + 1e-9;  // of equal planes the first one counts
  const PlanePart* best = nullptr;
  std::pair<bool, bool> asked{false, false};
  double area_m2 = 0.0;
  for (const PlanePart& plane : space.planes) {
    const glm::dvec3 normal = glm::cross(plane.grid.u, plane.grid.v);
    if (!plane.is_computed || !is_plain_illuminance(plane) || plane.outline_m.empty() ||
        plane.grid.route || !is_horizontal(normal) || !(normal.z > 0.0) ||
        !(plane.average.low > 0.0)) {
      continue;
    }
    const std::pair of(is_asked_for_average(plane), !plane.findings.empty());
    const double its_m2 = std::abs(calc::signed_area(plane.outline_m));
    if (best != nullptr && (of < asked || (of == asked && its_m2 <= area_m2 * kLarger))) continue;
    best = &plane;
    asked = of;
    area_m2 = its_m2;
  }
  return best;
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

std::string power_plane_words(const Texts& t, const SpacePart& space,
                              const PowerByLight& by_light) {
  const std::string title = plane_in_room(t, space, *by_light.plane);
  return by_light.plane->asked_light ? t.say<Text::at_full_output>(title) : title;
}

}  // namespace report
