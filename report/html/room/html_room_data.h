#pragma once
// A room in figures: size, surfaces, power, and the places of its luminaires.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns size, floor area, height, reflectances of surfaces, luminaires by type and installed
// power, also by 100 lx of the largest horizontal plane (one with requirements, if there is any);
// then a folded table of luminaires with their numbers in plans. "" for a space about which nothing
// is known and that has no light.
std::string html_room_data(const Texts& t, const ProjectPart& project, const SpacePart& space);

// Returns only the figures, as rows of a table.
std::string html_room_facts(const Texts& t, const ProjectPart& project, const SpacePart& space);

// Most rows of a table of luminaires; the CSV file has longer tables.
inline constexpr std::size_t kMostLuminaireRows = 1000;

}  // namespace report
