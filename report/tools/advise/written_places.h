#pragma once
// Advised luminaires in the text of a project.

#include "report/tools/advise/room_light.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// With the luminaires that are enough in each of these rooms, the cheapest of them where there are
// several, and levels for scenes that are not met now and have some; checked as a whole with other
// random numbers. Empty: `problem` says why.
struct PlacesText {
  std::optional<std::string> text;
  std::string problem;
  WrittenAdvice told = {};  // without its file
};
PlacesText with_places(const RoomQuestions& questions, const std::vector<RoomPlaces>& rooms);

}  // namespace cli
