#pragma once
// Advised luminaires, and ways of hanging those that there are, in the text of a project.

#include "report/tools/advise/advice.h"
#include "report/tools/advise/room_light.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// What is enough in each of these rooms, and levels for scenes that are not met now and have some;
// checked as a whole with other random numbers. Empty: `problem` says why.
struct RoomsText {
  std::optional<std::string> text;
  std::string problem;
  WrittenAdvice told = {};  // without its file
};
// The luminaires more that are enough, the cheapest of them where there are several.
RoomsText with_places(const RoomQuestions& questions, const std::vector<RoomPlaces>& rooms);
// The luminaires turned or tilted, as few of them as are enough.
RoomsText with_turns(const RoomQuestions& questions, const std::vector<RoomTurns>& rooms);

}  // namespace cli
