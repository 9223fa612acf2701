#pragma once
// What rooms are called where they stand beside each other.

#include "report/document/document.h"

#include <string>
#include <vector>

namespace report {

// Of all spaces, in their order: their names; with their ids behind, where several have the same;
// of those without a name the id. Not printable().
std::vector<std::string> room_titles(const ProjectPart& project);

}  // namespace report
