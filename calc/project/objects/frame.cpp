#include "calc/project/objects/frame.h"

#include "calc/base/elementary.h"

#include <cmath>

namespace calc {

glm::dmat3 rotation_about_z(double angle_rad) {
  const double c = calc::cos(angle_rad), s = calc::sin(angle_rad);
  return {glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1)};
}

glm::dmat3 luminaire_frame(const glm::dvec3& axis, double rotation_rad) {
  const glm::dvec3 a = glm::normalize(axis);
  const glm::dmat3 turned = rotation_about_z(rotation_rad);
  const double sine = calc::hypot(a.x, a.y);
  if (sine == 0.0) {
    const glm::dmat3 half_turn_about_x(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0),
                                       glm::dvec3(0, 0, -1));
    return a.z < 0.0 ? turned : half_turn_about_x * turned;
  }
  // Rodrigues: unit vector n = (0, 0, -1) x a / sine and cos = -a.z; no term cancels, however small
  // the sine.
  const glm::dvec3 n(a.y / sine, -a.x / sine, 0.0);
  const glm::dmat3 cross(glm::dvec3(0, n.z, -n.y), glm::dvec3(-n.z, 0, n.x),
                         glm::dvec3(n.y, -n.x, 0));
  const double cosine = -a.z;
  return (cosine * glm::dmat3(1.0) + sine * cross + (1.0 - cosine) * glm::outerProduct(n, n)) *
         turned;
}

std::optional<glm::dmat3> luminaire_frame_towards(const glm::dvec3& axis, const glm::dvec3& c0) {
  const double length = glm::length(c0);
  if (length == 0.0) return std::nullopt;
  const glm::dvec3 a = glm::normalize(axis);
  const glm::dvec3 across = c0 / length - glm::dot(c0 / length, a) * a;
  if (glm::length(across) < 1.0e-9) return std::nullopt;
  const glm::dvec3 x = glm::normalize(across);
  return glm::dmat3(x, glm::cross(-a, x), -a);
}

}  // namespace calc
