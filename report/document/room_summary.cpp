#include "report/document/room_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>

namespace report {
namespace {

// Of the task, or of what the project describes by itself.
bool is_of_own_role(const RoomCause& cause) {
  return std::any_of(cause.parts.begin(), cause.parts.end(), [](const RoomCause::Part& part) {
    return part.finding->requirement.origin.is_of_own_role;
  });
}

// Whether one line can say both: neither is judged, for the same reason, or the same is required of
// two planes and missed for the same reason. What has arguments of its own has its own line.
bool is_one_cause(const RoomCause& cause, rules::Outcome outcome, const PlanePart& plane,
                  const rules::Finding& finding) {
  if (cause.outcome != outcome || cause.parts.empty()) return false;
  const rules::Finding& known = *cause.parts.front().finding;
  if (known.verdict != finding.verdict || !(known.reason == finding.reason)) return false;
  if (finding.verdict == rules::Verdict::not_judged) return true;
  // That the task fails must not hide behind a wall that is worse.
  if (is_of_own_role(cause) != finding.requirement.origin.is_of_own_role) return false;
  const rules::Requirement &a = known.requirement, &b = finding.requirement;
  const bool is_known_plane = std::any_of(cause.parts.begin(), cause.parts.end(),
                                          [&](const auto& part) { return part.plane == &plane; });
  return !is_known_plane && cause.parts.front().plane->kernel == plane.kernel &&
         a.metric == b.metric && a.derived == b.derived && a.comparison == b.comparison &&
         a.scene == b.scene && a.state == b.state &&
         std::holds_alternative<std::monostate>(a.arguments);
}

void add_cause(const PlanePart& plane, const rules::Finding& finding, rules::Outcome outcome,
               RoomSummary& room) {
  if (finding.verdict == rules::Verdict::pass) return;
  const auto known = std::find_if(room.causes.begin(), room.causes.end(), [&](const auto& cause) {
    return is_one_cause(cause, outcome, plane, finding);
  });
  RoomCause& cause = known == room.causes.end() ? room.causes.emplace_back() : *known;
  cause.outcome = outcome;
  cause.parts.push_back({&plane, &finding});
}

void add_finding(const PlanePart& plane, const rules::Finding& finding, RoomSummary& room) {
  const rules::Outcome outcome = outcome_of(finding);
  if (outcome != rules::Outcome::nothing_asked) add_cause(plane, finding, outcome, room);
  add_to_values(plane, finding, finding.requirement.origin.is_of_own_role, room);
}

// Several workplaces may share a wall.
WallCounts walls_of(const SpacePart& space) {
  std::map<std::string, rules::Outcome> walls;  // by plane
  for (const rules::RowCoverage& row : space.coverage) {
    for (const rules::RoleCoverage& role : row.roles) {
      if (role.role != "wall") continue;
      for (const rules::RequirementName& name : role.of) {
        walls.emplace(name.plane_id, rules::Outcome::nothing_asked);
      }
    }
  }
  for (const PlanePart& plane : space.planes) {
    const auto wall = walls.find(plane.id);
    if (wall == walls.end()) continue;
    for (const rules::Finding& finding : plane.findings) {
      wall->second = graver(wall->second, outcome_of(finding));
    }
  }
  WallCounts counts;
  for (const auto& [id, outcome] : walls) {
    counts.asked += outcome == rules::Outcome::nothing_asked ? 0 : 1;
    counts.met += outcome == rules::Outcome::pass ? 1 : 0;
    counts.not_judged += outcome == rules::Outcome::not_judged ? 1 : 0;
  }
  return counts;
}

}  // namespace

const RoomCause::Part& RoomCause::worst() const { return worst_of(parts); }

const RoomCause::Part& worst_of(const std::vector<RoomCause::Part>& parts) {
  using Part = RoomCause::Part;
  const auto margin = [](const Part& part) {
    const double own = part.finding->margin;
    return std::isnan(own) ? std::numeric_limits<double>::infinity() : own;
  };
  return *std::min_element(parts.begin(), parts.end(),
                           [&](const Part& a, const Part& b) { return margin(a) < margin(b); });
}

std::vector<RoomSummary> room_summaries(const ProjectPart& project) {
  std::vector<RoomSummary> rooms;
  for (const SpacePart& space : project.spaces) {
    RoomSummary room;
    room.space = &space;
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        add_finding(plane, finding, room);
        add_row(finding.requirement.origin, room.rows);
      }
    }
    room.walls = walls_of(space);
    std::vector<const rules::AggregateFinding*> aggregates;
    for (const rules::AggregateFinding& finding : project.aggregates) {
      if (finding.space_id != space.id) continue;
      aggregates.push_back(&finding);
      if (finding.kind == rules::AggregateKind::row_class) room.classes.push_back(&finding);
      const rules::Outcome outcome = outcome_of(finding);
      room.outcome = graver(room.outcome, outcome);
      const bool is_cause = finding.verdict != rules::Verdict::pass;
      if (is_cause && outcome != rules::Outcome::nothing_asked)
        room.causes.push_back({outcome, {}, &finding});
      if (!rules::counts(outcome)) continue;
      ++room.required;
      room.met += finding.verdict == rules::Verdict::pass ? 1 : 0;
    }
    // A room with a row of a standard, none of whose numbers counts, must not disappear.
    if (room.outcome == rules::Outcome::nothing_asked && space.coverage.empty()) continue;
    std::stable_sort(room.causes.begin(), room.causes.end(),
                     [](const RoomCause& a, const RoomCause& b) {
                       if (a.outcome != b.outcome) return a.outcome < b.outcome;
                       return is_of_own_role(a) && !is_of_own_role(b);
                     });
    room.areas = room_areas(space, aggregates);
    rooms.push_back(std::move(room));
  }
  return rooms;
}

}  // namespace report
