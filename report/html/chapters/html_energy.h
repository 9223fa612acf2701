#pragma once
// Power and energy of all rooms of a project in one table.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the table; "" if no room has a luminaire. index: of the project.
std::string html_energy(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
