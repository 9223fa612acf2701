#include "calc/scene/zone_shapes.h"

#include "calc/scene/polygon.h"
#include "calc/scene/polygon_cut.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace calc {
namespace {

constexpr double kSliver = 1.0e-9;
constexpr double kStraight = 1.0e-9;  // sine of the turn at a corner

using Polygon = std::vector<glm::dvec2>;

glm::dvec2 outwards(glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 along = glm::normalize(to - from);
  return {along.y, -along.x};
}

// Corners on a straight side would have no moved sides that meet.
Polygon without_straight_corners(const Polygon& polygon) {
  Polygon corners;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 before =
        outwards(polygon[(i + polygon.size() - 1) % polygon.size()], polygon[i]);
    const glm::dvec2 after = outwards(polygon[i], polygon[(i + 1) % polygon.size()]);
    if (std::abs(before.x * after.y - before.y * after.x) > kStraight)
      corners.push_back(polygon[i]);
  }
  return corners;
}

// A side that is moved inwards too far turns round.
bool keeps_directions(const Polygon& before, const Polygon& after) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::size_t next = (i + 1) % before.size();
    if (!(glm::dot(before[next] - before[i], after[next] - after[i]) > 0.0)) return false;
  }
  return true;
}

// What is left of the polygon on one side of an axis-parallel line: sign * (p[axis] - limit) <= 0.
Polygon cut_by(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double sp = sign * (p[axis] - limit), sq = sign * (q[axis] - limit);
    if (sp <= 0.0) result.push_back(p);
    if ((sp < 0.0 && sq > 0.0) || (sp > 0.0 && sq < 0.0)) {
      glm::dvec2 on_line = p + sp / (sp - sq) * (q - p);
      on_line[axis] = limit;
      result.push_back(on_line);
    }
  }
  return result;
}

double area_of(const Polygon& polygon) { return std::abs(signed_area(polygon)); }

std::vector<ConvexPiece> without(std::vector<ConvexPiece> pieces, const Polygon& hole) {
  for (const ConvexPiece& part : convex_pieces(hole)) pieces = cut_out(pieces, part);
  return pieces;
}

}  // namespace

Polygon moved_sides(const Polygon& polygon, double width_m) {
  const Polygon corners = without_straight_corners(polygon);
  const std::size_t n = corners.size();
  Polygon moved;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 before = outwards(corners[(i + n - 1) % n], corners[i]);
    const glm::dvec2 after = outwards(corners[i], corners[(i + 1) % n]);
    // The point that is width_m beyond both sides.
    moved.push_back(corners[i] + width_m / (1.0 + glm::dot(before, after)) * (before + after));
  }
  if (n < 3 || !keeps_directions(corners, moved) || !is_simple_polygon(moved) ||
      !(signed_area(moved) > 0.0)) {
    return {};
  }
  return moved;
}

Polygon within_bounds(const Polygon& polygon, const Polygon& region) {
  glm::dvec2 lower = region[0], upper = region[0];
  for (const glm::dvec2& corner : region) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  Polygon result = polygon;
  for (int axis = 0; axis < 2; ++axis) {
    result = cut_by(result, axis, upper[axis], 1.0);
    result = cut_by(result, axis, lower[axis], -1.0);
  }
  if (!(area_of(result) > kSliver * area_of(polygon))) return {};
  return is_simple_polygon(result) ? result : polygon;
}

std::vector<Polygon> pieces_outside(const Polygon& polygon, const Polygon& region) {
  const double least = kSliver * area_of(polygon);
  std::vector<Polygon> pieces;
  for (ConvexPiece& piece : without(convex_pieces(polygon), region)) {
    if (area_of(piece) > least) pieces.push_back(std::move(piece));
  }
  return pieces;
}

double area_left(const Polygon& outline, const std::vector<Polygon>& holes) {
  std::vector<ConvexPiece> pieces = convex_pieces(outline);
  for (const Polygon& hole : holes) pieces = without(std::move(pieces), hole);
  return area(pieces);
}

}  // namespace calc
