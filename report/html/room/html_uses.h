#pragma once
// Rooms in a line each, and rows of rule packs with all rooms that are asked them.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// The lines of room_overview.h, each with a link to its room. "" where there are none. folder: of
// the pages of rooms; "" = they are in this page.
std::string html_rooms(const Texts& t, const ProjectPart& project, std::size_t index,
                       const std::string& folder);

// "" where only one room is asked any. index: of the project.
std::string html_uses(const Texts& t, const ProjectPart& project, std::size_t index);

}  // namespace report
