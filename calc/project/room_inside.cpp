#include "calc/project/room_inside.h"

#include "calc/scene/polygon.h"

#include <algorithm>

namespace calc {
namespace {

constexpr double kOnBoundary_m = 1.0e-6;

}  // namespace

bool room_contains(const RoomShell& shell, const glm::dvec3& point_m) {
  if (point_m.z < shell.floor_z_m - kOnBoundary_m) return false;
  if (point_m.z > shell.floor_z_m + shell.height_m + kOnBoundary_m) return false;
  const glm::dvec2 foot(point_m);
  return contains_point(shell.footprint_m, foot) ||
         distance_to_boundary(shell.footprint_m, foot) <= kOnBoundary_m;
}

double distance_outside_m(const RoomShell& shell, const glm::dvec3& point_m) {
  if (room_contains(shell, point_m)) return 0.0;
  const glm::dvec2 foot(point_m);
  const double sideways_m =
      contains_point(shell.footprint_m, foot) ? 0.0 : distance_to_boundary(shell.footprint_m, foot);
  const double upright_m =
      std::max({0.0, shell.floor_z_m - point_m.z, point_m.z - shell.floor_z_m - shell.height_m});
  return glm::length(glm::dvec2(sideways_m, upright_m));
}

}  // namespace calc
