#include "rules/fitness/obstacles.h"

#include "calc/scene/solids.h"

#include <algorithm>
#include <map>
#include <string>

namespace rules {

std::size_t points_in_obstacles(const calc::SensorGrid& grid, const calc::Space& space) {
  struct Known {
    const calc::Body* body = nullptr;
    calc::BoundingBox box;
  };
  std::map<std::string, Known> known;  // by id
  std::size_t count = 0;
  for (const calc::DroppedPoint& point : grid.dropped) {
    if (point.reason != calc::DropReason::inside_solid) continue;
    Known& one = known[point.body];
    if (one.body == nullptr) {
      const auto found =
          std::find_if(space.bodies.begin(), space.bodies.end(),
                       [&](const calc::Body& body) { return body.id == point.body; });
      if (found == space.bodies.end()) continue;
      one = {&*found, calc::bounding_box(found->vertex_m)};
    }
    const glm::dvec3 above = point.position_m + glm::dvec3(0.0, 0.0, kObstacleAbove_m);
    if (locate_point(*one.body, one.box, above) == calc::SolidSide::inside) ++count;
  }
  return count;
}

}  // namespace rules
