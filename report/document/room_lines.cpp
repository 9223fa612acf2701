#include "report/document/room_lines.h"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace report {
namespace {

std::map<std::string, std::string> role_of_planes(const SpacePart& space) {
  std::map<std::string, std::string> roles;
  for (const rules::RowCoverage& row : space.coverage) {
    for (const rules::RoleCoverage& role : row.roles) {
      for (const rules::RequirementName& name : role.of) roles.emplace(name.plane_id, role.role);
    }
  }
  return roles;
}

// Nothing of it must be read by itself.
bool can_be_folded(const rules::Finding& finding) {
  const bool is_good = finding.verdict == rules::Verdict::pass ||
                       outcome_of(finding) == rules::Outcome::nothing_asked;
  return is_good && !finding.is_waived && !finding.is_close && !finding.by_tolerance &&
         finding.requirement.deviations.empty() && !finding.requirement.origin.is_weakened;
}

bool is_one_line(const RoomLine& line, const std::string& role, const PlanePart& plane,
                 const rules::Finding& finding) {
  const RoomCause::Part& known = line.parts.front();
  const rules::Requirement &a = known.finding->requirement, &b = finding.requirement;
  return line.role == role && known.plane->kernel == plane.kernel &&
         known.finding->verdict == finding.verdict && can_be_folded(*known.finding) &&
         known.finding->reason == finding.reason && a.metric == b.metric &&
         a.derived == b.derived && a.comparison == b.comparison && a.limit == b.limit &&
         a.scene == b.scene && a.state == b.state && a.severity == b.severity &&
         a.clause == b.clause && a.mask.id == b.mask.id && a.direct_only == b.direct_only &&
         a.origin.is_user_supplied == b.origin.is_user_supplied &&
         std::holds_alternative<std::monostate>(a.arguments) &&
         std::holds_alternative<std::monostate>(b.arguments);
}

}  // namespace

std::vector<RoomLine> room_lines(const SpacePart& space) {
  const std::map<std::string, std::string> roles = role_of_planes(space);
  std::vector<RoomLine> lines;
  for (const PlanePart& plane : space.planes) {
    const auto found = roles.find(plane.id);
    const std::string role = found == roles.end() ? "" : found->second;
    for (const rules::Finding& finding : plane.findings) {
      const auto line = role.empty() || !can_be_folded(finding)
                            ? lines.end()
                            : std::find_if(lines.begin(), lines.end(), [&](const RoomLine& known) {
                                return is_one_line(known, role, plane, finding);
                              });
      RoomLine& own = line == lines.end() ? lines.emplace_back(RoomLine{role, {}}) : *line;
      own.parts.push_back({&plane, &finding});
    }
  }
  return lines;
}

}  // namespace report
