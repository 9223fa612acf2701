#include "calc/rays/sight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace calc {
namespace {

struct HalfSpace {
  glm::dvec3 normal;  // unit, outward
  double height;      // inside: dot(normal, p) <= height

  double above(const glm::dvec3& p) const { return glm::dot(normal, p) - height; }
};

// Through three places, with `inner` on its inner side; none if they lie in a line, or `inner` in
// the plane.
std::optional<HalfSpace> half_space(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                    const glm::dvec3& inner) {
  const glm::dvec3 u = b - a, v = c - a, across = glm::cross(u, v);
  const double area = glm::length(across);
  if (!(area > 1e-9 * glm::length(u) * glm::length(v))) return std::nullopt;
  const glm::dvec3 normal = across / area;
  const double side = glm::dot(normal, inner - a);
  if (side == 0.0) return std::nullopt;
  const glm::dvec3 outward = side > 0.0 ? -normal : normal;
  return HalfSpace{outward, glm::dot(outward, a)};
}

SightBox box_of(const TriangleTree::Node& node, std::size_t lane) {
  SightBox box{};
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    box.low_m[axis] = static_cast<double>(node.low_m[static_cast<std::size_t>(axis)][lane]);
    box.high_m[axis] = static_cast<double>(node.high_m[static_cast<std::size_t>(axis)][lane]);
  }
  return box;
}

// The convex hull of a point and a parallelogram, as half-spaces that hold it, a margin wider.
class Pyramid {
 public:
  explicit Pyramid(const SightQuery& query)
      : place_{query.from_m, query.corner_m[0], query.corner_m[1], query.corner_m[2],
               query.corner_m[3]},
        margin_m_(query.margin_m) {
    const glm::dvec3 middle = 0.5 * (place_[1] + place_[3]);
    for (std::size_t k = 0; k < 4; ++k) {
      edge_[k] = place_[k + 1] - place_[0];
      add(half_space(place_[0], place_[k + 1], place_[(k + 1) % 4 + 1], middle));
    }
    edge_[4] = place_[2] - place_[1];
    edge_[5] = place_[3] - place_[2];
    add(half_space(place_[1], place_[2], place_[3], place_[0]));
    low_m_ = high_m_ = place_[0];
    for (const glm::dvec3& p : place_) {
      low_m_ = glm::min(low_m_, p);
      high_m_ = glm::max(high_m_, p);
    }
    low_m_ -= glm::dvec3(margin_m_);
    high_m_ += glm::dvec3(margin_m_);
  }

  // false: no triangle in that box meets it, by more than rounding.
  bool may_meet(const TriangleTree::Node& node, std::size_t lane) const {
    const auto [low, high] = box_of(node, lane);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      if (low[axis] > high_m_[axis] || high[axis] < low_m_[axis]) return false;
    }
    const double slack_m = kSlack * margin_m_;
    for (std::size_t k = 0; k < planes_; ++k) {
      const glm::dvec3& n = plane_[k].normal;
      const glm::dvec3 lowest(n.x > 0.0 ? low.x : high.x, n.y > 0.0 ? low.y : high.y,
                              n.z > 0.0 ? low.z : high.z);
      if (plane_[k].above(lowest) > slack_m) return false;
    }
    return true;
  }

  bool meets(const Triangle& t) const {
    for (std::size_t k = 0; k < planes_; ++k) {
      if (plane_[k].above(t.a) > 0.0 && plane_[k].above(t.b) > 0.0 && plane_[k].above(t.c) > 0.0) {
        return false;
      }
    }
    const std::array<glm::dvec3, 3> side{t.b - t.a, t.c - t.b, t.a - t.c};
    if (separates(glm::cross(side[0], side[1]), t)) return false;
    for (const glm::dvec3& a : side) {
      for (const glm::dvec3& b : edge_) {
        if (separates(glm::cross(a, b), t)) return false;
      }
    }
    return true;
  }

 private:
  // Of the margin; rounding is far below it.
  static constexpr double kSlack = 1.0 / 64.0;

  void add(std::optional<HalfSpace> plane) {
    if (!plane) return;
    plane->height += margin_m_;
    plane_[planes_++] = *plane;
  }

  bool separates(const glm::dvec3& axis, const Triangle& t) const {
    const double a = glm::dot(axis, t.a), b = glm::dot(axis, t.b), c = glm::dot(axis, t.c);
    const double low = std::min({a, b, c}), high = std::max({a, b, c});
    double lowest = glm::dot(axis, place_[0]), highest = lowest;
    for (std::size_t k = 1; k < place_.size(); ++k) {
      const double at = glm::dot(axis, place_[k]);
      lowest = std::min(lowest, at);
      highest = std::max(highest, at);
    }
    const double apart = std::max(low - highest, lowest - high);
    return apart > 0.0 && apart * apart > margin_m_ * margin_m_ * glm::dot(axis, axis);
  }

  std::array<glm::dvec3, 5> place_;  // the point, the corners
  double margin_m_;
  std::array<glm::dvec3, 6> edge_;  // directions: from the point, along the parallelogram
  std::array<HalfSpace, 5> plane_{};
  std::size_t planes_ = 0;
  glm::dvec3 low_m_, high_m_;
};

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const Triangle& t) { return {t.a, t.b, t.c}; }

class Cover {
 public:
  explicit Cover(const SightQuery& query) : query_(query) {}

  bool hides(const Triangle& t) const {
    return stands_between(t) && is_within(t.a, t.b, t.c) && is_within(t.b, t.c, t.a) &&
           is_within(t.c, t.a, t.b);
  }

  bool hide(const Triangle& s, const Triangle& t) const {
    if (!stands_between(s) || !stands_between(t)) return false;
    const Corners first = corners_of(s), second = corners_of(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 &a = first[i], &b = first[(i + 1) % 3], &c = first[(i + 2) % 3];
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 &d = second[k], &e = second[(k + 1) % 3], &f = second[(k + 2) % 3];
        if ((d == a && e == b) || (d == b && e == a)) return hides_quad(a, b, c, f);
      }
    }
    return false;
  }

 private:
  // All ends lie beyond the triangle's plane.
  bool stands_between(const Triangle& t) const {
    const auto plane = half_space(t.a, t.b, t.c, query_.from_m);
    if (!plane || plane->above(query_.from_m) > -query_.clear_m) return false;
    return std::all_of(query_.corner_m.begin(), query_.corner_m.end(),
                       [&](const glm::dvec3& p) { return plane->above(p) >= query_.clear_m; });
  }

  // All ends lie on one side of the plane through the point and an edge, that of `inner`.
  bool is_within(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& inner) const {
    const auto plane = half_space(query_.from_m, a, b, inner);
    return plane &&
           std::all_of(query_.corner_m.begin(), query_.corner_m.end(),
                       [&](const glm::dvec3& p) { return plane->above(p) <= -query_.margin_m; });
  }

  // Triangles a b c and a b d: as seen from the point, a convex figure a c b d that holds all ends.
  bool hides_quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                  const glm::dvec3& d) const {
    const auto bounds = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& near,
                            const glm::dvec3& far) {
      const auto plane = half_space(query_.from_m, p, q, near);
      return plane && plane->above(far) < 0.0 && is_within(p, q, near);
    };
    const auto seam = half_space(query_.from_m, a, b, c);
    return seam && seam->above(d) > 0.0 && bounds(a, c, b, d) && bounds(c, b, a, d) &&
           bounds(b, d, a, c) && bounds(d, a, b, c);
  }

  const SightQuery& query_;
};

bool is_covered(const TriangleTree& tree, const SightQuery& query,
                const std::array<TriangleHit, 4>& hits) {
  const Cover cover(query);
  std::optional<std::uint32_t> second;
  const std::uint32_t first = hits[0].triangle;
  for (const TriangleHit& hit : hits) {
    if (hit.triangle == first) continue;
    if (second && hit.triangle != *second) return false;
    second = hit.triangle;
  }
  if (!second) return cover.hides(tree.triangle(first));
  return cover.hide(tree.triangle(first), tree.triangle(*second));
}

// The hull of two boxes, as half-spaces that hold it.
class Shaft {
 public:
  Shaft(const SightBox& one, const SightBox& other, double margin_m)
      : low_m_(glm::min(one.low_m, other.low_m) - margin_m),
        high_m_(glm::max(one.high_m, other.high_m) + margin_m) {
    for (glm::length_t across = 0; across < 3; ++across) {
      const glm::length_t i = (across + 1) % 3, k = (across + 2) % 3;
      for (const double side_i : {-1.0, 1.0}) {
        for (const double side_k : {-1.0, 1.0}) {
          const glm::dvec2 side(side_i, side_k);
          const glm::dvec2 a = corner(one, i, k, side), b = corner(other, i, k, side);
          const glm::dvec2 along = b - a;
          const double length_m = glm::length(along);
          if (!(length_m > margin_m)) continue;
          glm::dvec2 normal = glm::dvec2(-along.y, along.x) / length_m;
          if (normal.x * side.x < 0.0 || normal.y * side.y < 0.0) normal = -normal;
          if (normal.x * side.x < 0.0 || normal.y * side.y < 0.0) continue;
          HalfSpace plane{glm::dvec3(0.0), glm::dot(normal, a) + margin_m};
          plane.normal[i] = normal.x;
          plane.normal[k] = normal.y;
          plane_[planes_++] = plane;
        }
      }
    }
  }

  // false: nothing in that box reaches into it.
  bool may_meet(const SightBox& box) const {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      if (box.low_m[axis] > high_m_[axis] || box.high_m[axis] < low_m_[axis]) return false;
    }
    for (std::size_t p = 0; p < planes_; ++p) {
      const glm::dvec3& n = plane_[p].normal;
      const glm::dvec3 lowest(n.x > 0.0 ? box.low_m.x : box.high_m.x,
                              n.y > 0.0 ? box.low_m.y : box.high_m.y,
                              n.z > 0.0 ? box.low_m.z : box.high_m.z);
      if (plane_[p].above(lowest) > 0.0) return false;
    }
    return true;
  }

  bool may_meet(const Triangle& t) const {
    if (!may_meet(SightBox{glm::min(t.a, glm::min(t.b, t.c)), glm::max(t.a, glm::max(t.b, t.c))})) {
      return false;
    }
    for (std::size_t p = 0; p < planes_; ++p) {
      const HalfSpace& plane = plane_[p];
      if (plane.above(t.a) > 0.0 && plane.above(t.b) > 0.0 && plane.above(t.c) > 0.0) return false;
    }
    return true;
  }

 private:
  static glm::dvec2 corner(const SightBox& box, glm::length_t i, glm::length_t k,
                           const glm::dvec2& side) {
    return {side.x > 0.0 ? box.high_m[i] : box.low_m[i],
            side.y > 0.0 ? box.high_m[k] : box.low_m[k]};
  }

  glm::dvec3 low_m_, high_m_;
  std::array<HalfSpace, 12> plane_{};
  std::size_t planes_ = 0;
};

}  // namespace

bool is_free_between(const TriangleTree& tree, const SightBox& one, const SightBox& other,
                     double margin_m) {
  const Shaft shaft(one, other, margin_m);
  bool is_free = true;
  tree.visit_if(
      [&](const auto& node, std::size_t lane) { return shaft.may_meet(box_of(node, lane)); },
      [&](std::uint32_t index) {
        is_free = !shaft.may_meet(tree.triangle(index));
        return is_free;
      });
  return is_free;
}

Sight sight_of(const TriangleTree& tree, const SightQuery& query) {
  if (tree.is_empty()) return Sight::free;
  std::array<Ray, 4> rays;
  std::array<TriangleHit, 4> hits;
  for (std::size_t k = 0; k < 4; ++k) {
    if (glm::length(query.corner_m[k] - query.from_m) < query.clear_m) return Sight::unknown;
    rays[k].origin = glm::vec3(query.from_m);
    rays[k].direction = glm::vec3(query.corner_m[k]) - rays[k].origin;
    rays[k].most = 1.0f;
  }
  const std::uint32_t met = tree.first_hits(rays, hits);
  if (met == 0xf) return is_covered(tree, query, hits) ? Sight::hidden : Sight::unknown;
  if (met != 0) return Sight::unknown;
  const Pyramid pyramid(query);
  Sight result = Sight::free;
  tree.visit_if([&](const auto& node, std::size_t lane) { return pyramid.may_meet(node, lane); },
                [&](std::uint32_t index) {
                  if (pyramid.meets(tree.triangle(index))) result = Sight::unknown;
                  return result == Sight::free;
                });
  return result;
}

}  // namespace calc
