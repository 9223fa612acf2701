#include "rules/applicability/obstacles.h"

#include "calc/scene/solids.h"

#include <algorithm>
#include <map>
#include <string>

namespace rules {

namespace {

struct Known {
  const calc::Body* body = nullptr;
  calc::BoundingBox box;
};

// Calls visit(point, known) for each dropped point that lies inside a body of the space.
template <class Visit>
void for_each_inside(const calc::SensorGrid& grid, const calc::Space& space, Visit visit) {
  std::map<std::string, Known> known;  // by id
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
    visit(point, one);
  }
}

}  // namespace

std::size_t points_in_obstacles(const calc::SensorGrid& grid, const calc::Space& space) {
  std::size_t count = 0;
  for_each_inside(grid, space, [&](const calc::DroppedPoint& point, const Known& one) {
    const glm::dvec3 above = point.position_m + glm::dvec3(0.0, 0.0, kObstacleAbove_m);
    if (locate_point(*one.body, one.box, above) == calc::SolidSide::inside) ++count;
  });
  return count;
}

std::size_t points_in_posts(const calc::SensorGrid& grid, const calc::Space& space) {
  constexpr double kPost = 0.05;  // of a cell: columns take more
  const double cell_m2 = grid.spacing_u_m * grid.spacing_v_m;
  std::size_t count = 0;
  for_each_inside(grid, space, [&](const calc::DroppedPoint&, const Known& one) {
    const glm::dvec3 size_m = one.box.upper - one.box.lower;
    const double along_u_m = glm::dot(glm::abs(grid.u), size_m);
    const double along_v_m = glm::dot(glm::abs(grid.v), size_m);
    if (along_u_m * along_v_m < kPost * cell_m2) ++count;
  });
  return count;
}

}  // namespace rules
