#pragma once
// What a room is, in figures: size, surfaces, power, and where its luminaires are.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Size, floor area, height, reflectances of surfaces, luminaires by type, installed power, also by
// 100 lx of the largest horizontal plane, of those that something is asked of if there are any;
// then a folded table of luminaires with their numbers in plans. "" of a space of which nothing is
// known and where nothing shines.
std::string html_room_data(const Texts& t, const ProjectPart& project, const SpacePart& space);

// Its figures alone, as rows of a table.
std::string html_room_facts(const Texts& t, const ProjectPart& project, const SpacePart& space);

// Longer tables of luminaires are for the CSV file.
inline constexpr std::size_t kMostLuminaireRows = 1000;

}  // namespace report
