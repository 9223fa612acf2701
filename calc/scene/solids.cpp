#include "calc/scene/solids.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace calc {
namespace {

constexpr double kSurfaceTolerance = 1.0e-9;  // of the bounding box's diagonal

glm::dvec3 nearest_on_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  if (!(length2 > 0.0)) return a;
  return a + std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) * along;
}

// A triangle relative to the point that is being located.
struct Corners {
  glm::dvec3 a, b, c;
};

// Is the origin within `gap` of the triangle?
bool touches_origin(const Corners& t, double gap) {
  const glm::dvec3 lower = glm::min(t.a, glm::min(t.b, t.c));
  const glm::dvec3 upper = glm::max(t.a, glm::max(t.b, t.c));
  if (!BoundingBox{lower - gap, upper + gap}.contains(glm::dvec3(0.0))) return false;
  const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double length = glm::length(normal);
  if (std::abs(glm::dot(t.a, normal)) > gap * length) return false;
  const glm::dvec3 origin(0.0);
  for (const auto& [from, to] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
    if (glm::length(nearest_on_segment(origin, from, to)) <= gap) return true;
  }
  // In the plane and away from the sides: inside if it is on the same side of all three.
  const double ab = glm::dot(glm::cross(t.a, t.b), normal);
  const double bc = glm::dot(glm::cross(t.b, t.c), normal);
  const double ca = glm::dot(glm::cross(t.c, t.a), normal);
  return ab > 0.0 && bc > 0.0 && ca > 0.0;
}

// A ray from the origin upwards. Seen along it, a point lies at (x - z * slant_x, y - z * slant_y).
struct Ray {
  double slant_x, slant_y;
};

// Slants in no simple ratio to each other or to the axes, so that rays from grids rarely meet the
// edges of boxes.
Ray generic_ray(int attempt) {
  constexpr double kGoldenRatio = 1.6180339887498949;
  const double turn = 1.0 + attempt * 2.0 * kPi / kGoldenRatio;
  const double slant = 0.2360679 + std::fmod(attempt * 0.4142135, 0.5);
  return {slant * calc::cos(turn), slant * calc::sin(turn)};
}

enum class Hit { no, yes, unclear };

Hit intersect(const Ray& ray, const Corners& t) {
  const auto across = [&](const glm::dvec3& p) {
    return glm::dvec2(p.x - p.z * ray.slant_x, p.y - p.z * ray.slant_y);
  };
  const glm::dvec2 a = across(t.a), b = across(t.b), c = across(t.c);
  // Each side's term changes only its sign in the triangle on the other side of the edge, so that a
  // ray past an edge is counted for exactly one of the two.
  const double ab = a.x * b.y - a.y * b.x;
  const double bc = b.x * c.y - b.y * c.x;
  const double ca = c.x * a.y - c.y * a.x;
  const bool any_left = ab > 0.0 || bc > 0.0 || ca > 0.0;
  const bool any_right = ab < 0.0 || bc < 0.0 || ca < 0.0;
  if (any_left && any_right) return Hit::no;
  if (ab == 0.0 || bc == 0.0 || ca == 0.0) return Hit::unclear;
  const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double height = glm::dot(t.a, normal);
  const double slope = glm::dot(glm::dvec3(ray.slant_x, ray.slant_y, 1.0), normal);
  if (height == 0.0 || slope == 0.0) return Hit::unclear;
  return (height > 0.0) == (slope > 0.0) ? Hit::yes : Hit::no;
}

Corners corners_from(const Body& body, const glm::uvec3& triangle, const glm::dvec3& point) {
  return {body.vertex_m[triangle.x] - point, body.vertex_m[triangle.y] - point,
          body.vertex_m[triangle.z] - point};
}

bool has_area(const Corners& t) { return glm::cross(t.b - t.a, t.c - t.a) != glm::dvec3(0.0); }

// Parity of the crossings; empty if the ray meets an edge.
std::optional<bool> odd_crossings(const Body& body, const glm::dvec3& point, const Ray& ray) {
  bool odd = false;
  for (const glm::uvec3& triangle : body.triangle) {
    const Corners t = corners_from(body, triangle, point);
    const Hit hit = intersect(ray, t);
    if (hit == Hit::unclear && has_area(t)) return std::nullopt;
    if (hit == Hit::yes) odd = !odd;
  }
  return odd;
}

double surface_tolerance(const BoundingBox& box) {
  const double farthest = std::max(glm::length(box.lower), glm::length(box.upper));
  return kSurfaceTolerance * box.diagonal() +
         4.0 * std::numeric_limits<double>::epsilon() * farthest;
}

}  // namespace

void BoundingBox::add(const glm::dvec3& point) {
  lower = glm::min(lower, point);
  upper = glm::max(upper, point);
}

bool BoundingBox::contains(const glm::dvec3& point) const {
  return glm::all(glm::lessThanEqual(lower, point)) && glm::all(glm::lessThanEqual(point, upper));
}

BoundingBox bounding_box(const std::vector<glm::dvec3>& points) {
  BoundingBox box;
  for (const glm::dvec3& point : points) box.add(point);
  return box;
}

std::vector<std::uint32_t> weld_vertices(const std::vector<glm::dvec3>& vertex) {
  std::vector<std::uint32_t> order(vertex.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  const auto key = [&](std::uint32_t i) {
    return std::make_tuple(vertex[i].x, vertex[i].y, vertex[i].z, i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> welded(vertex.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertex[order[i]] == vertex[order[i - 1]];
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

bool is_watertight(const Body& body) {
  const std::vector<std::uint32_t> welded = weld_vertices(body.vertex_m);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * body.triangle.size());
  for (const glm::uvec3& triangle : body.triangle) {
    const std::array corner{welded[triangle.x], welded[triangle.y], welded[triangle.z]};
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (std::size_t i = 0; i < 3; ++i)
      edges.emplace_back(std::minmax(corner[i], corner[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    while (end < edges.size() && edges[end] == edges[begin]) ++end;
    if ((end - begin) % 2 != 0) return false;
    begin = end;
  }
  return !edges.empty();
}

SolidSide locate_point(const Body& body, const BoundingBox& box, const glm::dvec3& point) {
  const double gap = surface_tolerance(box);
  if (!BoundingBox{box.lower - gap, box.upper + gap}.contains(point)) return SolidSide::outside;
  for (const glm::uvec3& triangle : body.triangle) {
    if (touches_origin(corners_from(body, triangle, point), gap)) return SolidSide::on_surface;
  }
  constexpr int kAttempts = 16;  // each one fails only if a ray meets an edge exactly
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::optional<bool> odd = odd_crossings(body, point, generic_ray(attempt));
    if (odd) return *odd ? SolidSide::inside : SolidSide::outside;
  }
  return SolidSide::on_surface;
}

SolidLocator::SolidLocator(const Body& body)
    : body_(body), box_(bounding_box(body.vertex_m)), gap_(surface_tolerance(box_)) {
  constexpr double kMostColumns = 512.0;
  columns_ = static_cast<std::size_t>(
      std::clamp(std::sqrt(0.5 * static_cast<double>(body.triangle.size())), 1.0, kMostColumns));
  // Counted first, then filled in.
  begin_.assign(columns_ * columns_ + 1, 0);
  const auto for_each_column = [&](const glm::uvec3& t, auto visit) {
    BoundingBox around;
    for (int i = 0; i < 3; ++i) around.add(body.vertex_m[t[i]]);
    const std::size_t x0 = column(around.lower.x - gap_, 0), x1 = column(around.upper.x + gap_, 0);
    const std::size_t y0 = column(around.lower.y - gap_, 1), y1 = column(around.upper.y + gap_, 1);
    for (std::size_t y = y0; y <= y1; ++y) {
      for (std::size_t x = x0; x <= x1; ++x) visit(y * columns_ + x);
    }
  };
  for (const glm::uvec3& t : body.triangle) {
    for_each_column(t, [&](std::size_t at) { ++begin_[at + 1]; });
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  triangle_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t t = 0; t < body.triangle.size(); ++t) {
    for_each_column(body.triangle[t], [&](std::size_t at) { triangle_[next[at]++] = t; });
  }
}

std::size_t SolidLocator::column(double along, std::size_t axis) const {
  const auto i = static_cast<glm::length_t>(axis);
  const double size = box_.upper[i] - box_.lower[i];
  if (!(size > 0.0)) return 0;
  const double at = (along - box_.lower[i]) / size * static_cast<double>(columns_);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(columns_ - 1)));
}

SolidSide SolidLocator::locate(const glm::dvec3& point) const {
  if (!BoundingBox{box_.lower - gap_, box_.upper + gap_}.contains(point)) {
    return SolidSide::outside;
  }
  const std::size_t at = column(point.y, 1) * columns_ + column(point.x, 0);
  const auto corners = [&](std::size_t i, const glm::dvec3& from) {
    return corners_from(body_, body_.triangle[triangle_[i]], from);
  };
  for (std::size_t i = begin_[at]; i < begin_[at + 1]; ++i) {
    if (touches_origin(corners(i, point), gap_)) return SolidSide::on_surface;
  }
  // Farther than gap_ from the surface, so that a shift of less changes nothing but which edges the
  // upright ray meets.
  constexpr int kAttempts = 16;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Ray way = generic_ray(attempt);
    const glm::dvec3 from = point + 0.4 * gap_ * glm::dvec3(way.slant_x, way.slant_y, 0.0);
    bool odd = false, is_clear = true;
    for (std::size_t i = begin_[at]; i < begin_[at + 1] && is_clear; ++i) {
      const Corners t = corners(i, from);
      const Hit hit = intersect({0.0, 0.0}, t);
      is_clear = hit != Hit::unclear || !has_area(t);
      if (hit == Hit::yes) odd = !odd;
    }
    if (is_clear) return odd ? SolidSide::inside : SolidSide::outside;
  }
  return locate_point(body_, box_, point);
}

}  // namespace calc
