#pragma once
// The maintenance plan: what must be done so that the maintained values of a report come true.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// "" where a project has no luminaire. index: of the project.
std::string html_maintenance(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
