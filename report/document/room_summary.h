#pragma once
// A line for each room: is it met, what are its main values, what is nearest to its limit. Made
// once for all formats.

#include "report/document/document.h"
#include "rules/verdict/outcome.h"

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

// Points into the project.
struct RoomSummary {
  const SpacePart* space = nullptr;
  // The gravest of what counts, of requirements of its planes and aggregates about it: advice and
  // what is waived do not.
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  int required = 0, met = 0;  // of the requirements that count
  // The requirement of the gravest verdict, and of these the one with the least margin, of the task
  // or of planes that the project describes by itself. Glare: of all planes. Null: none is asked.
  const rules::Finding* average = nullptr;
  const rules::Finding* uniformity = nullptr;  // minimum / average
  const rules::Finding* glare = nullptr;       // UGR, at observers or by table
  std::vector<RoomCause> causes;               // gravest first
};

// Of all rooms of which something is asked, in their order. Valid as long as the project.
std::vector<RoomSummary> room_summaries(const ProjectPart& project);

}  // namespace report
