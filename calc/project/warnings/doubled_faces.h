#pragma once
// Faces of one body that lie exactly on others of it, of another material: as programs export a
// front and a back, or two drawings of one thing. Which of them light met would go by their order
// in the file.

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

// Where triangles of unlike reflectance share a place, all of them get the darker one's material;
// no surface moves. Near to linear in the body's triangles; of a body made to cost more only a part
// is looked at. tolerance_m: how far apart they may be.
DoubledFaces settle_doubled_faces(Body& body, const std::vector<Material>& materials,
                                  double tolerance_m);

}  // namespace calc
