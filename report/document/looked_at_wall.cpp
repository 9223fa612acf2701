#include "report/document/looked_at_wall.h"

#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace report {
namespace {

constexpr double kAlmostZero = 1e-9;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 edge_of(const std::vector<glm::dvec2>& footprint, std::size_t i) {
  return footprint[(i + 1) % footprint.size()] - footprint[i];
}

// Index of the first edge that a ray from `from` meets; the number of edges: it meets none.
std::size_t edge_ahead(const std::vector<glm::dvec2>& footprint, const glm::dvec2& from,
                       const glm::dvec2& direction) {
  std::size_t nearest = footprint.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const glm::dvec2 edge = edge_of(footprint, i), to_start = footprint[i] - from;
    const double slope = cross(direction, edge);
    if (std::abs(slope) < kAlmostZero) continue;
    const double way = cross(to_start, edge) / slope, along = cross(to_start, direction) / slope;
    if (way < kAlmostZero || along < 0.0 || along > 1.0 || way >= least) continue;
    least = way;
    nearest = i;
  }
  return nearest;
}

bool is_in_line_with_previous(const std::vector<glm::dvec2>& footprint, std::size_t i) {
  const glm::dvec2 a = edge_of(footprint, i - 1), b = edge_of(footprint, i);
  return std::abs(cross(a, b)) <= kAlmostZero * glm::length(a) * glm::length(b) &&
         glm::dot(a, b) > 0.0;
}

}  // namespace

std::size_t looked_at_wall(const SpacePart& space, const PlanePart& plane) {
  const std::vector<glm::dvec2>& footprint = space.footprint_m;
  if (!calc::has_look(plane.kernel, plane.derived) || footprint.size() < 3) return 0;
  std::vector<std::size_t> seen(footprint.size(), 0);
  for (const PointRow& point : plane.points) {
    const std::size_t edge =
        edge_ahead(footprint, glm::dvec2(point.position_m), glm::dvec2(point.normal));
    if (edge < seen.size()) ++seen[edge];
  }
  const auto most = std::max_element(seen.begin(), seen.end());
  if (*most == 0) return 0;
  auto wall = static_cast<std::size_t>(std::distance(seen.begin(), most));
  while (wall > 0 && is_in_line_with_previous(footprint, wall)) --wall;
  return wall + 1;
}

}  // namespace report
