#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace calc {
namespace {

using Point = glm::dvec2;

double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

// Length that counts as zero for these points.
template <class Vector>
double length_tolerance(const std::vector<Vector>& points) {
  if (points.empty()) return 0.0;
  Vector lower = points[0], upper = points[0];
  for (const Vector& p : points) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  const double farthest = std::max(glm::length(lower), glm::length(upper));
  return kPolygonTolerance * glm::length(upper - lower) +
         4.0 * std::numeric_limits<double>::epsilon() * farthest;
}

double distance_to_segment(Point p, Point a, Point b) {
  const Point along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + t * along));
}

bool cross_properly(Point a, Point b, Point c, Point d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return ((c_side > 0.0) != (d_side > 0.0)) && ((a_side > 0.0) != (b_side > 0.0)) &&
         c_side != 0.0 && d_side != 0.0 && a_side != 0.0 && b_side != 0.0;
}

bool boxes_apart(Point a, Point b, Point c, Point d, double gap) {
  return std::max(a.x, b.x) + gap < std::min(c.x, d.x) ||
         std::max(c.x, d.x) + gap < std::min(a.x, b.x) ||
         std::max(a.y, b.y) + gap < std::min(c.y, d.y) ||
         std::max(c.y, d.y) + gap < std::min(a.y, b.y);
}

bool segments_touch(Point a, Point b, Point c, Point d, double gap) {
  if (boxes_apart(a, b, c, d, gap)) return false;
  return cross_properly(a, b, c, d) || distance_to_segment(a, c, d) <= gap ||
         distance_to_segment(b, c, d) <= gap || distance_to_segment(c, a, b) <= gap ||
         distance_to_segment(d, a, b) <= gap;
}

// Doubly linked ring of the corners that are still there, counter-clockwise.
class EarClipper {
 public:
  EarClipper(const std::vector<Point>& polygon, double tolerance)
      : corner_(polygon), tolerance_(tolerance), left_(polygon.size()) {
    const std::size_t n = polygon.size();
    const bool clockwise = signed_area(polygon) < 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      next_.push_back(static_cast<std::uint32_t>((i + 1) % n));
      previous_.push_back(static_cast<std::uint32_t>((i + n - 1) % n));
    }
    if (clockwise) next_.swap(previous_);
    reversed_ = clockwise;
  }

  std::optional<std::vector<glm::uvec3>> run() {
    std::uint32_t at = 0;
    while (left_ > 3) {
      // Within the tolerance first; where that leaves nothing, as far as double goes.
      const std::optional<std::uint32_t> ear = find_ear(at, tolerance_);
      const std::optional<std::uint32_t> any_ear = ear ? ear : find_ear(at, 0.0);
      if (!any_ear) return std::nullopt;
      at = next_[clip(*any_ear)];
    }
    if (!(height(previous_[at], at, next_[at]) > 0.0)) return std::nullopt;
    clip(at);
    return std::move(triangles_);
  }

 private:
  // Twice the area of the triangle at this corner, over its longest side: its height.
  double height(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Point ab = corner_[b] - corner_[a], bc = corner_[c] - corner_[b];
    const double longest =
        std::max({glm::length(ab), glm::length(bc), glm::length(corner_[a] - corner_[c])});
    return cross(ab, bc) / longest;
  }

  // Strictly convex, and no other corner in the closed triangle: so a corner on a straight side
  // never ends up in the middle of a triangle's side.
  bool is_ear(std::uint32_t b, double gap) const {
    const std::uint32_t a = previous_[b], c = next_[b];
    if (!(height(a, b, c) > gap)) return false;
    for (std::uint32_t p = next_[c]; p != a; p = next_[p]) {
      if (!is_outside(p, a, b, gap) && !is_outside(p, b, c, gap) && !is_outside(p, c, a, gap)) {
        return false;
      }
    }
    return true;
  }

  // Right of the line from -> to by more than the gap.
  bool is_outside(std::uint32_t p, std::uint32_t from, std::uint32_t to, double gap) const {
    const Point along = corner_[to] - corner_[from];
    return cross(along, corner_[p] - corner_[from]) < -gap * glm::length(along);
  }

  std::optional<std::uint32_t> find_ear(std::uint32_t start, double gap) const {
    std::uint32_t b = start;
    for (std::size_t i = 0; i < left_; ++i, b = next_[b]) {
      if (is_ear(b, gap)) return b;
    }
    return std::nullopt;
  }

  // Takes corner b out and returns the corner after it.
  std::uint32_t clip(std::uint32_t b) {
    const std::uint32_t a = previous_[b], c = next_[b];
    triangles_.push_back(reversed_ ? glm::uvec3(c, b, a) : glm::uvec3(a, b, c));
    next_[a] = c;
    previous_[c] = a;
    --left_;
    return c;
  }

  const std::vector<Point>& corner_;
  double tolerance_;
  std::size_t left_;
  bool reversed_ = false;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<glm::uvec3> triangles_;
};

// Near the origin nothing is lost in products of coordinates.
std::vector<Point> shifted_to_first(const std::vector<Point>& polygon) {
  std::vector<Point> shifted;
  shifted.reserve(polygon.size());
  for (const Point& p : polygon) shifted.push_back(p - polygon[0]);
  return shifted;
}

bool is_simple(const std::vector<Point>& p, double gap) {
  const std::size_t n = p.size();
  if (n < 3 || !std::all_of(p.begin(), p.end(), is_finite)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
    if (glm::length(b - a) <= gap) return false;
    // Neighbouring sides share b; a fold back brings the far end of one onto the other.
    if (distance_to_segment(c, a, b) <= gap || distance_to_segment(a, b, c) <= gap) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && segments_touch(a, b, p[j], p[(j + 1) % n], gap)) return false;
    }
  }
  return signed_area(p) != 0.0;
}

// Newell's normal; its length is twice the area of the projection along it.
glm::dvec3 newell_normal(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  }
  return sum;
}

// A unit vector at right angles to a unit vector: away from the axis the normal is farthest from.
glm::dvec3 any_perpendicular(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  glm::dvec3 axis(0.0, 0.0, 1.0);
  if (size.x <= size.y && size.x <= size.z)
    axis = {1.0, 0.0, 0.0};
  else if (size.y <= size.z)
    axis = {0.0, 1.0, 0.0};
  return glm::normalize(glm::cross(axis, normal));
}

bool all_finite(const std::vector<glm::dvec3>& corners) {
  return std::all_of(corners.begin(), corners.end(), [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

}  // namespace

double polygon_gap(const std::vector<glm::dvec2>& polygon) { return length_tolerance(polygon); }
double polygon_gap(const std::vector<glm::dvec3>& polygon) { return length_tolerance(polygon); }

bool is_simple_polygon(const std::vector<glm::dvec2>& polygon) {
  if (polygon.empty()) return false;
  return is_simple(shifted_to_first(polygon), length_tolerance(polygon));
}

double signed_area(const std::vector<glm::dvec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice;
}

bool contains_point(const std::vector<glm::dvec2>& polygon, glm::dvec2 point) {
  if (polygon.size() < 3) return false;
  if (distance_to_boundary(polygon, point) <= length_tolerance(polygon)) return true;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    if ((a.y > 0.0) == (b.y > 0.0)) continue;
    // The side crosses the line to the right of the point.
    if ((cross(a, b) > 0.0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

double distance_to_boundary(const std::vector<glm::dvec2>& polygon, glm::dvec2 point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    nearest = std::min(nearest, distance_to_segment(point, a, b));
  }
  return nearest;
}

std::optional<std::vector<glm::uvec3>> triangulate_polygon(const std::vector<glm::dvec2>& polygon) {
  if (!is_simple_polygon(polygon)) return std::nullopt;
  const std::vector<Point> local = shifted_to_first(polygon);
  return EarClipper(local, length_tolerance(polygon)).run();
}

std::optional<FlatPolygon> flatten_polygon(const std::vector<glm::dvec3>& corners) {
  if (corners.size() < 3 || !all_finite(corners)) return std::nullopt;
  const double gap = length_tolerance(corners);
  glm::dvec3 centre(0.0);
  double size = 0.0;
  for (const glm::dvec3& p : corners) {
    centre += (p - corners[0]) / static_cast<double>(corners.size());
    size = std::max(size, glm::length(p - corners[0]));
  }
  const glm::dvec3 normal = newell_normal(corners);
  // A strip of the tolerance's width has no area.
  if (!(glm::length(normal) > gap * size)) return std::nullopt;

  const glm::dvec3 w = glm::normalize(normal), u = any_perpendicular(w), v = glm::cross(w, u);
  FlatPolygon flat;
  for (const glm::dvec3& p : corners) {
    const glm::dvec3 local = p - corners[0] - centre;
    flat.corner.emplace_back(glm::dot(local, u), glm::dot(local, v));
    flat.deviation = std::max(flat.deviation, std::abs(glm::dot(local, w)) / size);
  }
  return flat;
}

std::optional<std::vector<glm::uvec3>> triangulate_polygon(const std::vector<glm::dvec3>& corners) {
  const std::optional<FlatPolygon> flat = flatten_polygon(corners);
  if (!flat || flat->deviation > kPlanarTolerance) return std::nullopt;
  return triangulate_polygon(flat->corner);
}

}  // namespace calc
