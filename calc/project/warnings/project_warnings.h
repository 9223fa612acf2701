#pragma once
// What is allowed in a project but hardly meant.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <set>
#include <string>

namespace calc {

// Warnings only; the project must have been read without errors. planes_on_surfaces: ids of planes
// that were asked to lie in a surface.
void warn_about_project(const Project& project, const std::set<std::string>& planes_on_surfaces,
                        Diagnostics& diagnostics);

}  // namespace calc
