#pragma once
// Rooms that a design has given to another one: who splits a file, or makes one of two, asks for
// nothing less.

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

// A room has moved if its project has lost it and exactly one other has got one of its id, name and
// shape. It takes along its aggregates, and what its luminaires, scenes and materials are; whatever
// else is asked of a project stays with it, or goes along with the last room. Nothing: none has
// moved. Projects that could not be judged give and take nothing.
std::optional<MovedRooms> find_moved_rooms(const Document& before, const Document& after);

}  // namespace report
