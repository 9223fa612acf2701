#pragma once
// Reads <box>, <quad>, <polygon> and <mesh> as bodies in the coordinates around them, with an empty
// id and not repeated.

#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// The set is empty on errors. Each element also allows the attributes "repeat" and "step".
ObjectSet read_box(ProjectContext& context, ElementReader& reader);
ObjectSet read_quad(ProjectContext& context, ElementReader& reader);
ObjectSet read_polygon(ProjectContext& context, ElementReader& reader);
ObjectSet read_mesh(ProjectContext& context, ElementReader& reader);

}  // namespace calc
