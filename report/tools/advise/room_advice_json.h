#pragma once
// Returns places and surfaces as JSON, each a part of the advice.

#include "report/text/json_keys.h"
#include "report/tools/advise/room_advice.h"

namespace cli {

report::JsonKeys room_places_keys(const RoomPlaces& room);
report::JsonKeys room_spare_keys(const RoomSpare& room);
report::JsonKeys room_turns_keys(const RoomTurns& room);
report::JsonKeys room_surfaces_keys(const RoomSurfaces& room);

}  // namespace cli
