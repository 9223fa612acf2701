#pragma once
// What is hardly meant of planes.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <set>
#include <string>

namespace calc {

// Planes in a surface, and planes that face away from every luminaire. on_purpose: ids of planes
// that were asked to lie in a surface; they look away from it, whatever the light does.
void warn_planes(const Project& project, const Space& space,
                 const std::set<std::string>& on_purpose, Diagnostics& diagnostics);

}  // namespace calc
