#pragma once
// <box>, <quad>, <polygon> and <mesh> to bodies in the coordinates around them, id empty, not
// repeated.

#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// The set is empty on errors. Each allows the attributes "repeat" and "step" besides its own.
ObjectSet read_box(ProjectContext& context, ElementReader& reader);
ObjectSet read_quad(ProjectContext& context, ElementReader& reader);
ObjectSet read_polygon(ProjectContext& context, ElementReader& reader);
ObjectSet read_mesh(ProjectContext& context, ElementReader& reader);

}  // namespace calc
