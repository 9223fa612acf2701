#pragma once
// Rows of rule packs as HTML, with all rooms that are asked them.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// "" where only one room is asked any. index: of the project.
std::string html_uses(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
