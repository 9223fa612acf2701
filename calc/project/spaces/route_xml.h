#pragma once
// Reads <route>: an escape route.

#include "calc/project/reading/project_context.h"

namespace calc {

// Returns a plane; after an error only its id and its requirements are of use. origin_m: of the
// coordinates in the file.
CalcPlane read_route(ProjectContext& context, ElementReader& reader, const glm::dvec3& origin_m);

}  // namespace calc
