#pragma once
// Warns of what is allowed in a project but unlikely.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <set>
#include <string>

namespace calc {

// Warns only; requires a project that was read without errors. planes_on_surfaces: ids of planes
// requested in a surface.
void warn_about_project(const Project& project, const std::set<std::string>& planes_on_surfaces,
                        Diagnostics& diagnostics);

}  // namespace calc
