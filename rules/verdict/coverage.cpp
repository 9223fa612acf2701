#include "rules/verdict/coverage.h"

#include "rules/pack/limit.h"
#include "rules/verdict/outcome.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace rules {
namespace {

struct Asked {
  const RulePack* pack = nullptr;
  const RuleRow* row = nullptr;
  RowLevel level = RowLevel::required;
  std::map<std::string, double> facts;
  const calc::Workplace* workplace = nullptr;  // null: <require> elements
  std::vector<std::pair<const RuleCheck*, const Finding*>> findings;
};

bool belongs_to(const calc::CalcPlane& plane, const calc::Workplace& workplace) {
  return !plane.made_by.empty() && plane.id.starts_with(workplace.id + ".");
}

const calc::Workplace* workplace_of(const calc::Space& space, const calc::CalcPlane& plane) {
  const calc::Workplace* found = nullptr;
  for (const calc::Workplace& workplace : space.workplaces) {
    if (!belongs_to(plane, workplace)) continue;
    if (found == nullptr || workplace.id.size() > found->id.size()) found = &workplace;
  }
  return found;
}

std::vector<Asked> asked_in(const calc::Space& space, const std::vector<JudgedPlane>& planes,
                            const std::vector<RulePack>& packs) {
  std::vector<Asked> all;
  for (const JudgedPlane& judged : planes) {
    const calc::Workplace* workplace = workplace_of(space, *judged.plane);
    for (const Finding& finding : *judged.findings) {
      const RuleOrigin& origin = finding.requirement.origin;
      if (origin.row.empty()) continue;
      const auto pack = std::find_if(packs.begin(), packs.end(), [&](const RulePack& candidate) {
        return candidate.full_id() == origin.pack;
      });
      if (pack == packs.end()) continue;
      const RuleRow* row = pack->find_row(origin.row);
      const RuleCheck* check = pack->find_check(origin.check);
      if (row == nullptr || check == nullptr) continue;
      const RowLevel level = origin.is_modified ? RowLevel::modified : RowLevel::required;
      auto same = std::find_if(all.begin(), all.end(), [&](const Asked& asked) {
        return asked.pack == &*pack && asked.row == row && asked.level == level &&
               asked.workplace == workplace;
      });
      if (same == all.end()) {
        all.push_back({&*pack, row, level, origin.facts, workplace, {}});
        same = std::prev(all.end());
      }
      same->findings.emplace_back(check, &finding);
    }
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const Asked& asked) { return asked.workplace != nullptr; });
  return all;
}

RoleState state_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::pass:
      return RoleState::met;
    case Outcome::fail:
      return RoleState::failed;
    case Outcome::undecided:
      return RoleState::undecided;
    case Outcome::waived:
      return RoleState::waived;
    case Outcome::not_judged:
    case Outcome::warned:
    case Outcome::nothing_asked:
      break;
  }
  return RoleState::not_judged;
}

void add_zone_words(const std::string& role, const std::string& zone, const std::string& text,
                    std::string& words) {
  words += words.empty() ? "" : ", ";
  words += zone == role ? text : fmt::format("{}: {}", zone, text);
}

// Of a role and its parts ("wall.1"): why there is no plane of them.
void cover_unmade(const calc::Workplace& workplace, std::string_view today, bool is_asked,
                  RoleCoverage& coverage) {
  std::string not_made;
  bool has_ended = false;
  for (const calc::UnmadeZone& zone : workplace.unmade) {
    if (zone.role != coverage.role && !zone.role.starts_with(coverage.role + ".")) continue;
    if (!zone.left_out) {
      add_zone_words(coverage.role, zone.role, zone.why, not_made);
      continue;
    }
    const bool is_over = !zone.left_out->holds_on(today);
    coverage.left_out.push_back({zone.role, *zone.left_out, is_over});
    add_zone_words(coverage.role, zone.role,
                   is_over ? ended_words(*zone.left_out) : waiver_words(*zone.left_out),
                   coverage.words);
    has_ended = has_ended || is_over;
  }
  if (coverage.left_out.empty()) coverage.words = not_made;
  if (!is_asked && !not_made.empty()) coverage.state = RoleState::not_made;
  if (!is_asked && !coverage.left_out.empty()) coverage.state = RoleState::left_out;
  if (has_ended) coverage.state = RoleState::left_out_ended;
}

// Empty: the row requires nothing of it, or advice only.
std::optional<RoleCoverage> cover(const Asked& asked, const std::string& role,
                                  std::string_view today) {
  const LimitScope scope{*asked.pack, asked.row, asked.level, asked.facts};
  const RuleCheck* needed = required_check(
      role, scope, [](const RuleCheck& check) { return check.severity != Severity::advice; });
  if (needed == nullptr) return std::nullopt;
  RoleCoverage coverage;
  coverage.role = role;
  Outcome outcome = Outcome::nothing_asked;
  bool is_asked = false;
  for (const auto& [check, finding] : asked.findings) {
    if (check->role != role || check->severity == Severity::advice) continue;
    outcome = graver(outcome, outcome_of(*finding));
    is_asked = true;
  }
  if (is_asked) coverage.state = state_of(outcome);
  if (asked.workplace != nullptr) cover_unmade(*asked.workplace, today, is_asked, coverage);
  if (!is_asked && !needed->quantity->kernel) {
    coverage.state = RoleState::not_possible;
    coverage.words = fmt::format("{} is not measured on planes", needed->quantity->name);
  }
  return coverage;
}

}  // namespace

bool RowCoverage::is_whole() const {
  return std::none_of(roles.begin(), roles.end(), [](const RoleCoverage& role) {
    return role.state == RoleState::never_asked || role.state == RoleState::left_out_ended;
  });
}

bool RowCoverage::is_met() const {
  return std::all_of(roles.begin(), roles.end(), [](const RoleCoverage& role) {
    return role.state == RoleState::met || role.state == RoleState::waived ||
           role.state == RoleState::left_out || role.state == RoleState::not_made ||
           role.state == RoleState::not_possible;
  });
}

std::vector<const calc::CalcPlane*> planes_asked(const calc::Space& space, std::string_view today) {
  std::vector<const calc::CalcPlane*> planes;
  for (const calc::CalcPlane& plane : space.planes) planes.push_back(&plane);
  for (const calc::LeftOutPlane& left_out : space.left_out) {
    if (!left_out.by.holds_on(today)) planes.push_back(&left_out.plane);
  }
  return planes;
}

std::string ended_words(const calc::Waiver& by) {
  return fmt::format("leaving it out ended on {}, by {}: {}", by.until, by.owner, by.reason);
}

std::vector<RowCoverage> row_coverage(const calc::Space& space,
                                      const std::vector<JudgedPlane>& planes,
                                      const std::vector<RulePack>& packs, std::string_view today) {
  std::vector<RowCoverage> rows;
  for (const Asked& asked : asked_in(space, planes, packs)) {
    RowCoverage row;
    row.workplace = asked.workplace == nullptr ? "" : asked.workplace->id;
    row.clause = fmt::format("{}:{} {}{}", asked.pack->title, asked.pack->edition, asked.row->ref,
                             asked.level == RowLevel::modified ? " (modified)" : "");
    for (const std::string& role : asked.pack->roles()) {
      if (std::optional<RoleCoverage> covered = cover(asked, role, today)) {
        row.roles.push_back(std::move(*covered));
      }
    }
    if (!row.roles.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace rules
