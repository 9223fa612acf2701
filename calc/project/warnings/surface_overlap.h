#pragma once
// Tests whether a planar area lies in the surface of a body.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace calc {

// Tests one area against many bodies. Surfaces count that are in the area's plane within 1e-6 m and
// share more than a strip of 1e-6 m with it (holes and margins are ignored).
class SurfaceOverlap {
 public:
  explicit SurfaceOverlap(const PlanarArea& area);

  bool with(const Body& body) const;

 private:
  using Triangle = std::array<glm::dvec2, 3>;

  bool touches_plane(const Body& body) const;
  // Returns coordinates along u, v and the normal.
  glm::dvec3 local(const glm::dvec3& point) const;

  PlanarArea area_;
  std::vector<Triangle> triangles_;
};

}  // namespace calc
