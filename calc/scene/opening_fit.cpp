#include "calc/scene/opening_fit.h"

#include "calc/scene/housing.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace calc {
namespace {

constexpr double kTouch_m = 1.0e-6;

using LocalTriangle = std::array<glm::dvec3, 3>;

// Separating axes of a triangle and a box about the origin: the box's faces, the triangle's plane,
// and the cross products of their edges [Akenine01].
bool overlaps_box(const LocalTriangle& corner, const glm::dvec3& half) {
  const auto is_separating = [&](const glm::dvec3& axis) {
    const double reach = glm::dot(half, glm::abs(axis));
    const double a = glm::dot(axis, corner[0]), b = glm::dot(axis, corner[1]),
                 c = glm::dot(axis, corner[2]);
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
  };
  const std::array<glm::dvec3, 3> unit{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                       glm::dvec3(0, 0, 1)};
  for (const glm::dvec3& axis : unit) {
    if (is_separating(axis)) return false;
  }
  const std::array<glm::dvec3, 3> edge{corner[1] - corner[0], corner[2] - corner[1],
                                       corner[0] - corner[2]};
  if (is_separating(glm::cross(edge[0], edge[1]))) return false;
  for (const glm::dvec3& axis : unit) {
    for (const glm::dvec3& e : edge) {
      if (is_separating(glm::cross(axis, e))) return false;
    }
  }
  return true;
}

}  // namespace

LuminousOpening flattened(const LuminousOpening& opening) {
  LuminousOpening flat = opening;
  switch (opening.shape) {
    case OpeningShape::box:
    case OpeningShape::cylinder_c0:
    case OpeningShape::cylinder_c90:
      flat.shape = OpeningShape::rectangle;
      break;
    case OpeningShape::cylinder:
    case OpeningShape::ellipsoid:
      flat.shape = OpeningShape::disk;
      break;
    default:
      break;
  }
  return flat;
}

bool OpeningFit::is_cut(const LuminousOpening& opening, const Luminaire& luminaire) {
  if (!opening.is_body()) return false;
  if (!bodies_) {
    for (const Body& body : space_.bodies) body_box_.push_back(bounding_box(body.vertex_m));
    bodies_.emplace(body_box_);
    for (std::size_t i = 0; i < body_box_.size(); ++i) bodies_->add(i);
    bodies_->sort();
  }
  const glm::dvec3 half = glm::max(0.5 * opening.size_m() - kTouch_m, glm::dvec3(0.0));
  const double reach_m = glm::length(half);
  const glm::dmat3 to_local = glm::transpose(luminaire.world_from_luminaire);
  const BoundingBox around{luminaire.position_m - reach_m, luminaire.position_m + reach_m};
  for (const std::size_t i : bodies_->near(around, 0.0)) {
    const Body& body = space_.bodies[i];
    if (is_housing_of(body, luminaire)) continue;
    for (const glm::uvec3& t : body.triangle) {
      const auto local = [&](std::uint32_t v) {
        return to_local * (body.vertex_m[v] - luminaire.position_m);
      };
      if (overlaps_box({local(t.x), local(t.y), local(t.z)}, half)) return true;
    }
  }
  return false;
}

LuminousOpening OpeningFit::fitted(const LuminousOpening& opening, const Luminaire& luminaire) {
  return is_cut(opening, luminaire) ? flattened(opening) : opening;
}

}  // namespace calc
