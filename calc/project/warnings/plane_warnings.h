#pragma once
// Warns of unlikely planes.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <set>
#include <string>

namespace calc {

// Warns of planes in a surface, and of planes that face away from every luminaire. on_purpose: ids
// of planes requested in a surface; they face away from it, whatever the light does.
void warn_planes(const Project& project, const Space& space,
                 const std::set<std::string>& on_purpose, Diagnostics& diagnostics);

}  // namespace calc
