#include "report/document/shown_plane.h"

#include <cstddef>
#include <utility>

namespace report {

ShownPlane::ShownPlane(const PlanePart& plane) : plane_(plane) {
  if (!plane.asked_light || plane.asked_light->is_shown) return;
  PlanePart& shown = changed_.emplace(plane);
  AskedLight& light = *shown.asked_light;
  for (std::size_t i = 0; i < shown.points.size(); ++i) {
    PointRow& point = shown.points[i];
    AskedPoint& asked = light.points[i];
    std::swap(point.measured, asked.measured);
    std::swap(point.direct_lx, asked.direct_lx);
    std::swap(point.indirect_lx, asked.indirect_lx);
  }
  std::swap(shown.average, light.average);
  std::swap(shown.minimum, light.minimum);
  std::swap(shown.maximum, light.maximum);
  std::swap(shown.uniformity_min_avg, light.uniformity_min_avg);
  std::swap(shown.uniformity_min_max, light.uniformity_min_max);
  light.is_shown = true;
}

}  // namespace report
