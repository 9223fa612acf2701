#pragma once
// A line for each room: whether it is met, its main values, and the value nearest to its limit.
// Made once for all formats.

#include "report/document/document.h"
#include "report/document/room_areas.h"
#include "rules/verdict/outcome.h"

#include <string>
#include <vector>

namespace report {

// One reason why a room does not pass: requirements not judged for one cause, or the same
// requirement that several planes do not meet. Points into the project.
struct RoomCause {
  struct Part {
    const PlanePart* plane = nullptr;
    const rules::Finding* finding = nullptr;
  };

  rules::Outcome outcome = rules::Outcome::fail;  // not_judged, fail, undecided or waived
  std::vector<Part> parts;  // in document order; empty: it is an aggregate about the room
  const rules::AggregateFinding* aggregate = nullptr;

  // See worst_of().
  const Part& worst() const;
};

// Returns the part with the least margin; the first part if none was judged. parts: not empty.
const RoomCause::Part& worst_of(const std::vector<RoomCause::Part>& parts);

// Counts of the walls on which rows require something, each once.
struct WallCounts {
  int asked = 0, met = 0, not_judged = 0;
};

// The summary of a room. Its values are of requirements on its planes and aggregates about it.
// Points into the project.
struct RoomSummary : KeyValues {
  const SpacePart* space = nullptr;
  WallCounts walls;
  std::vector<AskedRow> rows;  // each once, in the order in which they are first asked
  std::vector<const rules::AggregateFinding*> classes;  // of roads
  std::vector<RoomCause> causes;                        // gravest first, of these the task's
  std::vector<RoomArea> areas;                          // gravest first; empty: one task, or none
};

// Returns summaries of all rooms with requirements, in their order; valid as long as the project.
std::vector<RoomSummary> room_summaries(const ProjectPart& project);

}  // namespace report
