#pragma once
// Places and surfaces as JSON, a part of the advice.

#include "report/tools/advise/room_advice.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace cli {

// [{"scene", "space", ...}]: as many as were looked at.
nlohmann::ordered_json places_json(const std::vector<RoomPlaces>& rooms);
nlohmann::ordered_json spare_json(const std::vector<RoomSpare>& rooms);
nlohmann::ordered_json surfaces_json(const std::vector<RoomSurfaces>& rooms);

}  // namespace cli
