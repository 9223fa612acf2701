#pragma once
// A line for each room: is it met, what are its main values, what is nearest to its limit. Made
// once for all formats.

#include "report/document/document.h"
#include "report/document/room_areas.h"
#include "rules/verdict/outcome.h"

#include <string>
#include <vector>

namespace report {

// What keeps a room from passing, for one reason: what could not be judged for one cause, or the
// same requirement that several of its planes do not meet. Points into the project.
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

// The part with the least margin; the first one where none was judged. parts: not empty.
const RoomCause::Part& worst_of(const std::vector<RoomCause::Part>& parts);

// Of the walls that rows ask something of, each once.
struct WallCounts {
  int asked = 0, met = 0, not_judged = 0;
};

// Its values are of requirements of its planes and aggregates about it. Points into the project.
struct RoomSummary : KeyValues {
  const SpacePart* space = nullptr;
  WallCounts walls;
  std::vector<AskedRow> rows;  // each once, in the order in which they are first asked
  std::vector<const rules::AggregateFinding*> classes;  // of roads
  std::vector<RoomCause> causes;                        // gravest first, of these the task's
  std::vector<RoomArea> areas;                          // gravest first; empty: one task, or none
};

// Of all rooms of which something is asked, in their order. Valid as long as the project.
std::vector<RoomSummary> room_summaries(const ProjectPart& project);

}  // namespace report
