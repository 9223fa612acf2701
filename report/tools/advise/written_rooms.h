#pragma once
// Writes advised luminaires, and new aims of existing ones, into the text of a project.

#include "report/tools/advise/advice.h"
#include "report/tools/advise/room_light.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// Sufficient advice for each of these rooms, and levels for unmet scenes that have some; checked as
// a whole with other random numbers. Empty: `problem` says why.
struct RoomsText {
  std::optional<std::string> text;
  std::string problem;
  WrittenAdvice told = {};  // without its file
};
// Adds sufficient luminaires, the cheapest if there are several choices.
RoomsText with_places(const RoomQuestions& questions, const std::vector<RoomPlaces>& rooms);
// Turns or tilts luminaires, as few as are sufficient.
RoomsText with_turns(const RoomQuestions& questions, const std::vector<RoomTurns>& rooms);

}  // namespace cli
