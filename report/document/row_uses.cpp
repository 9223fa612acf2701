#include "report/document/row_uses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace report {
namespace {

using Name = std::pair<std::string, std::string>;  // plane, requirement

void add_finding(const SpacePart& space, const std::string& plane, const rules::Finding& finding,
                 RowUse& use) {
  const rules::Outcome outcome = outcome_of(finding);
  if (outcome == rules::Outcome::nothing_asked) return;
  ++use.requirements;
  use.met += finding.verdict == rules::Verdict::pass ? 1 : 0;
  use.outcome = graver(use.outcome, outcome);
  const bool has_margin = finding.verdict != rules::Verdict::not_judged &&
                          finding.requirement.limit != 0.0 && std::isfinite(finding.margin);
  if (!has_margin || (use.margin && finding.margin >= *use.margin)) return;
  use.margin = finding.margin;
  use.room = space.id;
  use.plane = plane;
  use.requirement = finding.requirement.id;
}

}  // namespace

std::vector<RowUse> row_uses(const ProjectPart& project) {
  std::vector<RowUse> uses;
  std::map<std::pair<calc::Message, bool>, std::size_t> index;  // by clause, and who supplies it
  std::map<std::size_t, std::set<Name>> taken;  // by use: walls that workplaces share
  for (const SpacePart& space : project.spaces) {
    std::map<Name, const rules::Finding*> findings;
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        findings[{plane.id, finding.requirement.id}] = &finding;
      }
    }
    for (const rules::RowCoverage& row : space.coverage) {
      const auto [found, is_new] =
          index.emplace(std::pair(row.clause, row.is_user_supplied), uses.size());
      if (is_new) {
        uses.emplace_back().clause = row.clause;
        uses.back().is_user_supplied = row.is_user_supplied;
      }
      RowUse& use = uses[found->second];
      if (use.rooms.empty() || use.rooms.back() != space.id) use.rooms.push_back(space.id);
      ++use.times;
      use.whole += row.is_whole() ? 1 : 0;
      use.open += row.is_whole() && !row.asks_all() ? 1 : 0;
      use.excepted += row.has_exceptions() ? 1 : 0;
      for (const rules::RoleCoverage& role : row.roles) {
        // What is asked for again, since leaving it out has ended, has no result.
        if (role.state == rules::RoleState::left_out_ended) {
          use.outcome = graver(use.outcome, rules::Outcome::not_judged);
        }
        for (const rules::RequirementName& name : role.of) {
          const auto finding = findings.find({name.plane_id, name.id});
          const bool is_first = taken[found->second].insert({name.plane_id, name.id}).second;
          if (!is_first || finding == findings.end()) continue;
          add_finding(space, name.plane_id, *finding->second, use);
        }
      }
    }
  }
  for (const rules::AggregateFinding& aggregate : project.aggregates) {
    if (aggregate.kind != rules::AggregateKind::aggregate) continue;
    for (std::size_t u = 0; u < uses.size(); ++u) {
      const bool is_of_use =
          std::any_of(aggregate.members.begin(), aggregate.members.end(), [&](const auto& member) {
            return std::any_of(member.of.begin(), member.of.end(), [&](const auto& name) {
              return taken[u].contains({name.plane_id, name.id});
            });
          });
      if (is_of_use) uses[u].outcome = graver(uses[u].outcome, outcome_of(aggregate));
    }
  }
  return uses;
}

}  // namespace report
