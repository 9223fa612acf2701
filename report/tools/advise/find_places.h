#pragma once
// Finds the places where an additional luminaire helps most, by reciprocity, and checks them in the
// changed project.

#include "report/tools/advise/room_light.h"

#include <vector>

namespace cli {

// Returns a result for each scene and room with requirements that need more light and that no
// levels meet. It has the gain of every free place and every mounting in the room; the best three,
// and as many together as needed, are checked. Without advice `problem` says why.
std::vector<RoomPlaces> find_places(const RoomQuestions& questions);

// Returns whether all requirements of the search are met and no other is lost.
bool is_enough(const CheckedPlaces& checked);

// Returns a result for each room with luminaires whose requirements are all met in all scenes: the
// luminaires that can be removed one after the other while all requirements on points stay met; the
// whole is checked.
std::vector<RoomSpare> find_spare(const RoomQuestions& questions);

// Returns a result for each scene and room with requirements that need more light and that no
// levels meet: the luminaires to turn or tilt. The best three, and several together, are checked.
std::vector<RoomTurns> find_turns(const RoomQuestions& questions);

// Returns a result for each scene and room with such requirements; if there are none, for those
// that are met. Each surface is checked with 0.1 more reflectance.
std::vector<RoomSurfaces> find_surfaces(const RoomQuestions& questions);

}  // namespace cli
