#pragma once
// Titles of rooms in lists.

#include "report/document/document.h"

#include <string>
#include <vector>

namespace report {

// Returns the titles of all spaces, in their order: the name; with the id behind it if several have
// that name; the id if there is no name. Not printable().
std::vector<std::string> room_titles(const ProjectPart& project);

}  // namespace report
