#pragma once
// Rooms that moved to another project: splitting a file, or joining two, does not weaken
// requirements.

#include "calc/base/message.h"
#include "report/document/document.h"

#include <optional>
#include <string>
#include <vector>

namespace report {

struct MovedRooms {
  Document before;                   // as if each room had been where it is now
  std::vector<calc::Message> notes;  // which went where, a sentence for each two projects
};

// Returns the moved rooms. A room has moved if its project lost it and exactly one other project
// got one with its id, name and shape. It takes along its aggregates, and its luminaires, scenes
// and materials; other requirements on a project stay with it, or move with its last room. Empty:
// none has moved. Projects that could not be judged are not considered.
std::optional<MovedRooms> find_moved_rooms(const Document& before, const Document& after);

}  // namespace report
