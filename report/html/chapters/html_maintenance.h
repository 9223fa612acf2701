#pragma once
// The maintenance plan: the work on which the maintained values of a report rest.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the plan; "" if a project has no luminaire. index: of the project.
std::string html_maintenance(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
