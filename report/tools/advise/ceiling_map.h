#pragma once
// Where a luminaire more helps, as a plan of the ceiling.

#include "report/tools/advise/room_advice.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

// Types of luminaires that places are known of, those with the most gain first; requirement: of
// room.requirements.
std::vector<std::string> types_on_map(const RoomPlaces& room, std::size_t requirement);

// A <figure>: every free place in the colour of what a luminaire of that type there adds to the
// requirement (where it could hang in several ways, the best of them), outline and luminaires of
// the room, the best places by their numbers in room.best. "" without such places.
std::string ceiling_map(const RoomPlaces& room, std::size_t requirement, const std::string& type);

}  // namespace cli
