#pragma once
// Streets: cross-section, the values for each driver, and power and energy by EN 13201-5.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the streets; "" if the project has none. index: of the project.
std::string html_roads(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
