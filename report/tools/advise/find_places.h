#pragma once
// Where a luminaire more helps most, by reciprocity, and whether the checked project agrees.

#include "report/tools/advise/room_light.h"

#include <vector>

namespace cli {

// One for each scene and room with requirements that more light would help and that no levels meet.
// Of every free place and every way of mounting in the room its gain; the best three, and as many
// together as it takes, are checked. Where there is no advice, `problem` says why.
std::vector<RoomPlaces> find_places(const RoomQuestions& questions);

// Everything that the places were looked for is met with them, and nothing is lost.
bool is_enough(const CheckedPlaces& checked);

// One for each room with luminaires in which everything is met, in all scenes: which luminaires can
// go, one after the other, as long as everything that hangs on points stays met; the whole is
// checked.
std::vector<RoomSpare> find_spare(const RoomQuestions& questions);

// One for each scene and room with requirements that more light would help and that no levels
// meet: which of its luminaires to turn or tilt. The best three, and several together, are checked.
std::vector<RoomTurns> find_turns(const RoomQuestions& questions);

// One for each scene and room with such requirements; without any, of those that are met. Each
// surface is checked with 0.1 more of reflectance.
std::vector<RoomSurfaces> find_surfaces(const RoomQuestions& questions);

}  // namespace cli
