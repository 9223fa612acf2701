#include "report/document/room_summary.h"

namespace report {
namespace {

// The worse of two for the same column: by verdict, then by margin; the first of equal ones.
const rules::Finding* worse(const rules::Finding* known, const rules::Finding& other) {
  if (known == nullptr) return &other;
  const rules::Outcome was = outcome_of(*known), is = outcome_of(other);
  if (was != is) return is < was ? &other : known;
  return other.margin < known->margin ? &other : known;
}

bool is_glare(const PlanePart& plane, const rules::Requirement& requirement) {
  return requirement.metric == rules::Metric::ugr_table ||
         (plane.derived == calc::DerivedQuantity::ugr &&
          requirement.metric == rules::Metric::maximum);
}

void add_finding(const PlanePart& plane, const rules::Finding& finding, RoomSummary& room) {
  const rules::Outcome outcome = outcome_of(finding);
  if (outcome == rules::Outcome::nothing_asked) return;
  room.outcome = graver(room.outcome, outcome);
  if (!rules::counts(outcome)) return;
  ++room.required;
  room.met += finding.verdict == rules::Verdict::pass ? 1 : 0;
  const rules::Requirement& requirement = finding.requirement;
  if (is_glare(plane, requirement)) room.glare = worse(room.glare, finding);
  const bool is_plain =
      plane.kernel == calc::ReceiverKernel::planar && plane.derived == calc::DerivedQuantity::none;
  if (!is_plain || !requirement.origin.is_of_own_role) return;
  if (requirement.metric == rules::Metric::average) room.average = worse(room.average, finding);
  if (requirement.metric == rules::Metric::uniformity_min_avg) {
    room.uniformity = worse(room.uniformity, finding);
  }
}

}  // namespace

std::vector<RoomSummary> room_summaries(const ProjectPart& project) {
  std::vector<RoomSummary> rooms;
  for (const SpacePart& space : project.spaces) {
    RoomSummary room;
    room.space = &space;
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) add_finding(plane, finding, room);
    }
    for (const rules::AggregateFinding& finding : project.aggregates) {
      if (finding.space_id != space.id) continue;
      const rules::Outcome outcome = outcome_of(finding);
      room.outcome = graver(room.outcome, outcome);
      if (!rules::counts(outcome)) continue;
      ++room.required;
      room.met += finding.verdict == rules::Verdict::pass ? 1 : 0;
    }
    if (room.outcome != rules::Outcome::nothing_asked) rooms.push_back(room);
  }
  return rooms;
}

}  // namespace report
