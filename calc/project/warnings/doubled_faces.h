#pragma once
// Faces of a body that lie exactly on others of it with another material, as programs export a
// front and a back, or two drawings of one thing. Otherwise their order in the file would decide
// which of them light meets.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace calc {

struct DoubledFaces {
  std::size_t triangles = 0;  // that others of a darker material cover, all or in part; 0 = none
  double area_m2 = 0.0;       // of them
  glm::dvec3 first_m{0.0};    // a corner of the first one
};

// Gives all triangles of unlike reflectance that share a place the darker one's material; no
// surface moves. Near to linear in the body's triangles; of a body built to cost more, only a part
// is examined. tolerance_m: how far apart they may be.
DoubledFaces settle_doubled_faces(Body& body, const std::vector<Material>& materials,
                                  double tolerance_m);

}  // namespace calc
