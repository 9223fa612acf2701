#pragma once
// Surfaces that send light themselves: stretch ceilings, light walls.

#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"

#include <glm/glm.hpp>

namespace calc {

// A rectangle's corner and sides, in metres.
struct RectangleSides {
  glm::dvec3 origin_m, u_m, v_m;
};

// If the element has a luminous-exitance: adds to `set` a luminaire that fills the rectangle and
// sends that much light off each square metre, evenly and diffusely (Lambert), towards u x v. It is
// of a luminaire type of its own. Reports sides that are not at right angles, and the luminaire's
// attributes on a surface that is dark.
void add_luminous_surface(ProjectContext& context, ElementReader& reader,
                          const RectangleSides& sides, ObjectSet& set);

}  // namespace calc
