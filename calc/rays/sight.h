#pragma once
// What a point sees of a parallelogram, by proof.

#include "calc/rays/triangle_tree.h"

#include <glm/glm.hpp>

#include <array>

namespace calc {

enum class Sight {
  unknown,
  free,   // nothing comes between the point and any place of the parallelogram
  hidden  // something comes between, wherever the place
};

struct SightQuery {
  glm::dvec3 from_m;
  std::array<glm::dvec3, 4> corner_m;  // in order around it
  double margin_m;                     // both answers still hold if ends are moved by this, > 0
  double clear_m;  // what hides keeps this far off both ends: what is nearer may not be met
};

// Returns a proof of sight. free: no triangle comes within the margin of the convex hull of point
// and corners, by a plane that separates them [the separating axes of two convex bodies]. hidden:
// one triangle, or two that share an edge and together look convex from the point, block all four
// corners, and so all between. What several other triangles hide together is unknown. The answer
// depends only on query and triangles.
Sight sight_of(const TriangleTree& tree, const SightQuery& query);

struct SightBox {
  glm::dvec3 low_m, high_m;
};

// Returns true if no triangle comes within the margin of the convex hull of the two boxes, so that
// every place in one sees every place in the other; false: not known. Tests the planes through two
// parallel edges, one of each box, that leave both boxes on one side.  [shafts: HW94]
bool is_free_between(const TriangleTree& tree, const SightBox& one, const SightBox& other,
                     double margin_m);

}  // namespace calc
