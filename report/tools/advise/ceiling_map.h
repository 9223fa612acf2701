#pragma once
// A plan of the ceiling that shows where an additional luminaire helps.

#include "report/tools/advise/room_advice.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

// Returns the luminaire types with known places, largest gain first. requirement: index into
// room.requirements.
std::vector<std::string> types_on_map(const RoomPlaces& room, std::size_t requirement);

// Returns a <figure>: every free place in the colour of the gain that a luminaire of that type adds
// to the requirement there (with the best of several mountings), outline and luminaires of the
// room, the best places by their numbers in room.best. "" without such places.
std::string ceiling_map(const RoomPlaces& room, std::size_t requirement, const std::string& type);

}  // namespace cli
