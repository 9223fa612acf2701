#include "calc/proofs/point_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace calc {
namespace {

// Right-handed axes with z along the unit normal; the usual axes for an upward one.
glm::dmat3 frame_about(const glm::dvec3& normal) {
  const glm::dvec3 aside = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 y = glm::normalize(glm::cross(normal, aside));
  return {glm::cross(y, normal), y, normal};
}

std::vector<NormalGroup> group_by_normal(const PointSet& points) {
  std::vector<NormalGroup> groups;
  std::size_t last = 0;  // neighbours mostly share their normal
  for (std::size_t i = 0; i < points.position_m.size(); ++i) {
    const glm::dvec3& normal = points.normal[i];
    const double height_m = glm::dot(normal, points.position_m[i]);
    if (groups.empty() || groups[last].normal != normal) {
      const auto found = std::find_if(groups.begin(), groups.end(), [&](const NormalGroup& group) {
        return group.normal == normal;
      });
      last = static_cast<std::size_t>(found - groups.begin());
      if (found == groups.end()) groups.push_back({normal, height_m});
      if (groups.size() > kMostNormalGroups) return {};
    }
    groups[last].lowest_m = std::min(groups[last].lowest_m, height_m);
  }
  return groups;
}

}  // namespace

std::vector<glm::dvec3> local_positions_m(const PreparedScene& scene, const SensorGrid& grid) {
  std::vector<glm::dvec3> local;
  local.reserve(grid.position_m.size());
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    local.push_back(grid.measured_m(i) - scene.origin_m);
  }
  return local;
}

std::array<glm::dvec3, 8> box_corners(const glm::dvec3& low, const glm::dvec3& high) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = {(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                  (k & 4) != 0 ? high.z : low.z};
  }
  return corners;
}

PointBounds bounds_of(const PointSet& points) {
  const glm::dmat3 axes = frame_about(points.normal[0]);
  glm::dvec3 low(std::numeric_limits<double>::max()), high = -low;
  for (const glm::dvec3& p : points.position_m) {
    const glm::dvec3 q = p * axes;  // dot products with the axes
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  PointBounds bounds;
  bounds.corner_m = box_corners(low, high);
  for (glm::dvec3& corner : bounds.corner_m) {
    corner = axes * corner;
    bounds.reach_m = std::max(bounds.reach_m, glm::length(corner));
  }
  if (points.has_back()) bounds.groups = group_by_normal(points);
  return bounds;
}

}  // namespace calc
