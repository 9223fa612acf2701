#pragma once
// The requirements of a room, a line each: what walls or observers meet alike is one line.

#include "report/document/room_summary.h"

#include <string>
#include <vector>

namespace report {

// Points into the project.
struct RoomLine {
  std::string role;  // of a rule pack, that the planes have: "wall"; "" = none
  // In document order, never empty. Several: all have the same requirement and the same verdict,
  // which nothing weakens.
  std::vector<RoomCause::Part> parts;

  // The one with the least margin.
  const RoomCause::Part& worst() const { return worst_of(parts); }
};

// All requirements of the room's planes, in document order. What fails, is waived, is close to its
// limit or rests on a deviation has a line of its own.
std::vector<RoomLine> room_lines(const SpacePart& space);

}  // namespace report
