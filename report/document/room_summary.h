#pragma once
// A line for each room: is it met, what are its main values, what is nearest to its limit. Made
// once for all formats.

#include "report/document/document.h"
#include "rules/verdict/outcome.h"

#include <vector>

namespace report {

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
};

// Of all rooms of which something is asked, in their order.
std::vector<RoomSummary> room_summaries(const ProjectPart& project);

}  // namespace report
