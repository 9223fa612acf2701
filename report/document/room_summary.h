#pragma once
// A line for each room: is it met, what are its main values, what is nearest to its limit. Made
// once for all formats.

#include "report/document/document.h"
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
// A row of a rule pack that something of a room is asked by.
struct AskedRow {
  std::string pack, row;  // "en12464-1:2021", "34.2"
  bool is_user_supplied = false;

  bool operator==(const AskedRow&) const = default;
};

// Of the walls that rows ask something of, each once.
struct WallCounts {
  int asked = 0, met = 0, not_judged = 0;
};

// Points into the project.
struct RoomSummary {
  const SpacePart* space = nullptr;
  // The gravest of what counts, of requirements of its planes and aggregates about it: advice and
  // what is waived do not.
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  int required = 0, met = 0;  // of the requirements that count
  // The requirement of the gravest verdict, and of these the one with the least margin, of the task
  // or of planes that the project describes by itself. Glare: of all planes. Null: none is asked.
  const rules::Finding* average = nullptr;      // of illuminance, or of a carriageway's luminance
  const rules::Finding* uniformity = nullptr;   // minimum / average of either
  const rules::Finding* minimum = nullptr;      // as on the line of an escape route
  const rules::Finding* glare = nullptr;        // UGR, at observers or by table
  const rules::Finding* cylindrical = nullptr;  // average of Ez
  WallCounts walls;
  std::vector<AskedRow> rows;  // each once, in the order in which they are first asked
  std::vector<const rules::AggregateFinding*> classes;  // of roads
  std::vector<RoomCause> causes;                        // gravest first, of these the task's
};

// Of all rooms of which something is asked, in their order. Valid as long as the project.
std::vector<RoomSummary> room_summaries(const ProjectPart& project);

}  // namespace report
