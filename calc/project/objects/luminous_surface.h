#pragma once
// Surfaces that emit light: stretch ceilings, light walls.

#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"

#include <glm/glm.hpp>

namespace calc {

// A rectangle's corner and sides, in metres.
struct RectangleSides {
  glm::dvec3 origin_m, u_m, v_m;
};

// Adds a luminaire to `set` if the element has a luminous-exitance. It fills the rectangle, has its
// own luminaire type, and emits that much light from each square metre, evenly and diffusely
// (Lambert), towards u x v. Reports sides that are not at right angles, and the luminaire's
// attributes on a surface that is dark.
void add_luminous_surface(ProjectContext& context, ElementReader& reader,
                          const RectangleSides& sides, ObjectSet& set);

}  // namespace calc
