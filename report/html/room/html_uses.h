#pragma once
// Rooms in one line each, and rows of rule packs with all rooms that use them.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the lines of room_overview.h, each with a link to its room; "" if there are none. folder:
// of the pages of rooms; "" = they are in this page.
std::string html_rooms(const Texts& t, const ProjectPart& project, std::size_t index,
                       const std::string& folder);

// Returns the rows; "" if only one room uses any. index: of the project.
std::string html_uses(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
