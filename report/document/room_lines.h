#pragma once
// The requirements of a room, one line each: requirements that walls or observers meet alike share
// a line.

#include "report/document/room_summary.h"

#include <string>
#include <vector>

namespace report {

// A line of requirements. It points into the project.
struct RoomLine {
  std::string role;  // of a rule pack, that the planes have: "wall"; "" = none
  // In document order, never empty. Several parts have the same requirement and the same verdict,
  // without waiver or deviation.
  std::vector<RoomCause::Part> parts;

  // Returns the part with the least margin.
  const RoomCause::Part& worst() const { return worst_of(parts); }
};

// Returns all requirements of the room's planes, in document order. Those that fail, are waived,
// are close to their limit or rest on a deviation have their own lines.
std::vector<RoomLine> room_lines(const SpacePart& space);

}  // namespace report
