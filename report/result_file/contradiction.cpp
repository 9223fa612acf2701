#include "report/result_file/contradiction.h"

#include "calc/base/day.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/names.h"
#include "report/result_file/json_cursor.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "rules/verdict/coverage.h"
#include "rules/verdict/judge_buildings.h"
#include "rules/verdict/members.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

using rules::Verdict;

// Where in the file, and in words.
struct Place {
  std::string path;   // "/projects/0/spaces/0/planes/0"
  std::string words;  // "project 'office.xml', plane 'work'"

  Place at(std::string_view list, std::size_t index, const std::string& name = {}) const {
    return {fmt::format("{}/{}/{}", path, list, index), name.empty() ? words : words + ", " + name};
  }
};

std::string shown(bool is_so) { return is_so ? "true" : "false"; }
std::string shown(double number) { return std::isnan(number) ? "null" : format_shortest(number); }
template <class Enum>
requires std::is_enum_v<Enum> std::string shown(Enum value) {
  return fmt::format("'{}'", calc::name_of(value));
}

template <class T>
[[noreturn]] void refuse(const Place& place, std::string_view key, const T& says, const T& follows,
                         std::string_view why) {
  throw BadJson(
      printable(fmt::format("{}/{}: the file says {}, but its other values give {} ({}: {})",
                            place.path, key, shown(says), shown(follows), place.words, why)));
}

template <class T>
void expect(const Place& place, std::string_view key, const T& says, const T& follows,
            std::string_view why) {
  if (says != follows) refuse(place, key, says, follows, why);
}

[[noreturn]] void refuse_place(const Place& place, std::string_view key, std::string_view what) {
  throw BadJson(printable(fmt::format("{}/{}: {} ({})", place.path, key, what, place.words)));
}

// "between 420.25 and 428.75 lx, required ≥ 450 lx"
std::string grounds(const rules::Finding& finding, const calc::Estimate& measured) {
  const rules::Requirement& requirement = finding.requirement;
  return fmt::format(
      "{} to {}, required {}", shown(measured.low), shown(measured.high),
      format_required({requirement.limit, requirement.comparison}, rules::unit_of(requirement)));
}

// What an interval proves: one that cannot be trusted, or that is open where only glare ratings
// are, nothing.
Verdict proved(const rules::Finding& finding, const calc::Estimate& measured) {
  const bool says_something =
      calc::is_finite(measured) || rules::has_open_ends(finding.requirement, measured);
  if (finding.is_doubtful || !says_something || measured.low > measured.high) {
    return Verdict::undecided;
  }
  return rules::decide(finding.requirement, measured).verdict;
}

// ---- a finding

const char* unfit_words(const SpacePart& space, const ProjectPart& project,
                        const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const bool is_open = std::any_of(requirement.deviations.begin(), requirement.deviations.end(),
                                   [](const auto& deviation) { return !deviation.is_accepted; });
  if (is_open) return "the plane has a deviation that nobody accepts";
  if (requirement.origin.pack.empty() || requirement.state == rules::LightState::initial ||
      (rules::is_of_space(requirement.metric) && !rules::is_of_road(requirement.metric))) {
    return nullptr;
  }
  const auto has_no_factor = [&](const LuminaireMark& mark) {
    return std::any_of(project.luminaires.begin(), project.luminaires.end(),
                       [&](const LuminaireRow& row) {
                         return row.type_id == mark.type_id && !row.maintenance.is_stated;
                       });
  };
  return std::any_of(space.luminaires.begin(), space.luminaires.end(), has_no_factor)
             ? "a luminaire states no maintenance factor"
             : nullptr;
}

void check_decision(const Place& place, const rules::Finding& finding) {
  const calc::Estimate& measured = finding.measured;
  const std::string why = grounds(finding, measured);
  expect(place, "verdict", finding.verdict, proved(finding, measured), why);
  if (!calc::is_finite(measured) && !rules::has_open_ends(finding.requirement, measured)) return;
  const auto [comparison, limit] =
      std::pair(finding.requirement.comparison, finding.requirement.limit);
  double margin = rules::margin_of(finding.requirement, measured, finding.verdict);
  // Files of other programs may have rounded it.
  constexpr double kSame = 1e-9;
  const auto is_like = [&](double other) {
    return std::abs(finding.margin - other) <= kSame * std::max(1.0, std::abs(other));
  };
  // Of results of earlier versions it is that of the value, also where an end is open.
  const double of_value = rules::margin(measured.value, comparison, limit);
  if (is_like(of_value)) margin = of_value;
  const bool has_margin = std::isfinite(margin);
  if (!has_margin && std::isfinite(finding.margin)) {
    refuse(place, "margin", finding.margin, margin, why);
  }
  if (has_margin && !is_like(margin)) {
    refuse(place, "margin", finding.margin, margin, why);
  }
  rules::Decision decision = rules::decide(finding.requirement, measured);
  if (finding.is_doubtful) decision = {};
  expect(place, "is_close", finding.is_close, decision.is_close, why);
  expect(place, "by_tolerance", finding.by_tolerance, decision.by_tolerance, why);
}

// Waivers and stated deviations last up to their last day, by the day of the result.
void check_days(const Place& place, const rules::Finding& finding, std::string_view day) {
  const std::string why = fmt::format("judged on {}", day);
  const std::optional<rules::Waiver>& waiver = finding.requirement.waiver;
  if (waiver) {
    const bool applies = rules::can_be_waived(finding.verdict) && waiver->holds_on(day);
    expect(place, "waiver/applies", finding.is_waived, applies, why + ", until " + waiver->until);
  }
  const auto& deviations = finding.requirement.deviations;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const rules::Deviation& deviation = deviations[i];
    const bool lasts = deviation.stated && deviation.stated->holds_on(day);
    expect(place.at("deviations", i), "accepted", deviation.is_accepted, lasts, why);
  }
}

void check_finding(const Place& place, const rules::Finding& finding, std::string_view day) {
  check_days(place, finding, day);
  if (finding.verdict != Verdict::not_judged) return check_decision(place, finding);
  constexpr const char* kWhy =
      "a result that is not judged is neither close nor within a tolerance";
  expect(place, "is_close", finding.is_close, false, kWhy);
  expect(place, "by_tolerance", finding.by_tolerance, false, kWhy);
  expect(place, "doubtful", finding.is_doubtful, false, kWhy);
}

// ---- a plane

// A look does not say whether it could trust its interval: undecided it may always be.
void check_look(const Place& place, const PlaneLook& look, const PlanePart& plane) {
  for (std::size_t i = 0; i < look.findings.size(); ++i) {
    const LookFinding& seen = look.findings[i];
    if (seen.verdict == Verdict::not_judged || seen.verdict == Verdict::undecided) continue;
    rules::Finding finding = plane.findings[i];
    finding.is_doubtful = false;
    expect(place.at("findings", i), "verdict", seen.verdict, proved(finding, seen.measured),
           grounds(finding, seen.measured));
  }
}

// The last look is the result.
void check_last_look(const Place& place, const PlanePart& plane) {
  const PlaneLook& last = plane.looks.back();
  const Place own = place.at("look_results", plane.looks.size() - 1);
  for (std::size_t i = 0; i < last.findings.size(); ++i) {
    const rules::Finding& finding = plane.findings[i];
    const bool was_judged = last.findings[i].verdict != Verdict::not_judged;
    const bool is_judged = finding.verdict != Verdict::not_judged;
    const Place of = own.at("findings", i, fmt::format("requirement '{}'", finding.requirement.id));
    constexpr const char* kWhy = "the last sampling round is the result";
    expect(of, "is_judged", was_judged, is_judged, kWhy);
    if (!is_judged) continue;
    const calc::Estimate &seen = last.findings[i].measured, &said = finding.measured;
    if (!calc::is_finite(seen) && !calc::is_finite(said)) continue;  // open ends have no one text
    const bool is_same = seen.low == said.low && seen.value == said.value && seen.high == said.high;
    expect(of, "measured", is_same, true, kWhy);
  }
}

// Groups give the plane's light together, at every point: previews are made of it.
void check_groups(const Place& place, const PlanePart& plane) {
  // Of kShareDigits digits, and of very small shares.
  constexpr double kRounding = 5e-6, kDark_lx = 1e-9;
  const auto differ = [](double sum, double all) {
    return std::abs(sum - all) > kRounding * std::abs(all) + kDark_lx;
  };
  double average = 0.0;
  std::vector<double> sum(plane.points.size(), 0.0);
  for (std::size_t g = 0; g < plane.groups.size(); ++g) {
    const GroupShare& share = plane.groups[g];
    if (share.point_lx.empty()) return;
    average += share.average_lx.value;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (!(share.point_lx[i] >= 0.0))
        refuse_place(place.at("groups", g), "point_lx", "light must not be below 0");
      sum[i] += share.point_lx[i];
    }
  }
  if (plane.groups.empty()) return;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (differ(sum[i], plane.points[i].measured.value)) {
      refuse_place(
          place, "groups",
          fmt::format("their light at point {} does not add up to the value of the point", i + 1));
    }
  }
  if (differ(average, plane.average.value))
    refuse_place(place, "groups", "their averages do not add up to the average of the plane");
}

void check_plane(const Place& place, const ProjectPart& project, const SpacePart& space,
                 const PlanePart& plane, std::string_view day) {
  for (std::size_t i = 0; i < plane.findings.size(); ++i) {
    const rules::Finding& finding = plane.findings[i];
    const Place own =
        place.at("findings", i, fmt::format("requirement '{}'", finding.requirement.id));
    const char* obstacle =
        plane.is_computed ? unfit_words(space, project, finding) : "the plane was not computed";
    if (obstacle != nullptr) {
      expect(own, "verdict", finding.verdict, Verdict::not_judged, obstacle);
    }
    check_finding(own, finding, day);
  }
  for (std::size_t i = 0; i < plane.looks.size(); ++i) {
    check_look(place.at("look_results", i), plane.looks[i], plane);
  }
  if (!plane.looks.empty()) check_last_look(place, plane);
  check_groups(place, plane);
}

// ---- what is made of findings

// Of a project, by plane and requirement.
class Findings {
 public:
  explicit Findings(const ProjectPart& project) {
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes) {
        for (const rules::Finding& finding : plane.findings) {
          found_.emplace(std::pair(plane.id, finding.requirement.id), Named{&finding, &space});
        }
      }
    }
  }

  struct Named {
    const rules::Finding* finding;
    const SpacePart* space;
  };

  Named of(const Place& place, std::size_t index, const rules::RequirementName& name) const {
    const auto found = found_.find(std::pair(name.plane_id, name.id));
    if (found != found_.end()) return found->second;
    refuse_place(place.at("of", index), "requirement",
                 fmt::format("plane '{}' has no requirement '{}'", name.plane_id, name.id));
  }

 private:
  std::map<std::pair<std::string, std::string>, Named> found_;
};

// It is of the member's check, plane or room.
bool belongs_to(const Findings::Named& named, const rules::AggregateMember& member,
                rules::AggregateOver over) {
  switch (over) {
    case rules::AggregateOver::planes:
      return named.finding->requirement.plane_id == member.name;
    case rules::AggregateOver::rooms:
      return named.space->id == member.name;
    case rules::AggregateOver::checks:
      break;
  }
  return named.finding->requirement.origin.check == member.name;
}

// Returns the verdict with everything waived taken as met, as far as the document tells.
Verdict check_member(const Place& place, const Findings& findings,
                     const rules::AggregateMember& member, rules::AggregateOver over) {
  Verdict verdict = Verdict::pass, lived_with = Verdict::pass;
  bool is_waived = false;
  for (std::size_t i = 0; i < member.of.size(); ++i) {
    const Findings::Named named = findings.of(place, i, member.of[i]);
    if (!belongs_to(named, member, over)) {
      refuse_place(place.at("of", i), "requirement", "it is not part of this member");
    }
    const rules::Finding& finding = *named.finding;
    verdict = verdict_of_both(verdict, finding.verdict);
    lived_with = verdict_of_both(lived_with, finding.is_waived ? Verdict::pass : finding.verdict);
    is_waived = is_waived || finding.is_waived;
  }
  constexpr const char* kWhy = "from its requirements";
  expect(place, "is_waived", member.is_waived, is_waived, kWhy);
  if (member.is_in_part) {
    expect(place, "in_part", true, verdict == Verdict::pass, kWhy);
    verdict = Verdict::not_judged;
    lived_with = Verdict::not_judged;
  }
  const bool may_lack_checks = member.of.empty() || over == rules::AggregateOver::rooms;
  if (may_lack_checks && member.verdict == verdict_of_both(verdict, Verdict::not_judged)) {
    return verdict_of_both(lived_with,
                           member.verdict == verdict ? lived_with : Verdict::not_judged);
  }
  expect(place, "verdict", member.verdict, member.of.empty() ? Verdict::not_judged : verdict, kWhy);
  return lived_with;
}

// As many digits as files keep of the members.
bool is_same_sum(double said, double follows) {
  constexpr double kRounding = 1e-9;
  return std::abs(said - follows) <= kRounding * std::max(std::abs(said), std::abs(follows));
}

// A room of a building: what it has is what the room's own numbers say.
void check_room(const Place& place, const ProjectPart& project, const Findings& findings,
                const rules::Requirement& asked, const rules::AggregateMember& room) {
  for (std::size_t i = 0; i < room.of.size(); ++i) {
    findings.of(place, i, room.of[i]);
    refuse_place(place.at("of", i), "requirement", "a room of a building must not list any");
  }
  const auto space = std::find_if(project.spaces.begin(), project.spaces.end(),
                                  [&](const SpacePart& one) { return one.id == room.name; });
  if (space == project.spaces.end()) refuse_place(place, "name", "the project has no such room");
  const bool is_energy = asked.metric == rules::Metric::leni;
  std::optional<double> value = space->power.density_w_m2();
  if (is_energy) {
    const bool is_known = space->energy && space->energy->problem.empty();
    value = is_known ? std::optional(space->energy->leni_kwh_m2) : std::nullopt;
  }
  const auto is_same = [](const std::optional<double>& said, const std::optional<double>& follows) {
    return said.has_value() == follows.has_value() && (!said || is_same_sum(*said, *follows));
  };
  if (is_energy && value && space->energy->words != room.stated) {
    refuse_place(place, "stated", "it is not what the room itself states");
  }
  const double area_m2 = space->power.area_m2;
  constexpr const char* kWhy = "from the room itself";
  expect(place, "value", is_same(room.value, value), true, kWhy);
  const std::optional<double> area = area_m2 > 0.0 ? std::optional(area_m2) : std::nullopt;
  expect(place, "area_m2", is_same(room.area_m2, area), true, kWhy);
  const bool is_judged = room.value && !std::isnan(asked.limit);
  const Verdict verdict =
      is_judged ? rules::decide(asked, {*room.value, *room.value, *room.value}).verdict
                : Verdict::not_judged;
  expect(place, "verdict", room.verdict, verdict, "from its value and the limit");
  expect(place, "is_waived", room.is_waived, false, "a single room has no requirement");
}

void check_sum(const Place& place, const ProjectPart& project, const Findings& findings,
               const rules::AggregateFinding& finding, std::string_view day) {
  const rules::Finding& sum = *finding.sum;
  const Place own{place.path + "/sum", place.words};
  constexpr const char* kWhy = "it is that of the sum";
  if (!rules::adds_up_over_rooms(sum.requirement.metric)) {
    refuse_place(own, "quantity", "it does not add up over rooms");
  }
  expect(place, "over", finding.over, rules::AggregateOver::rooms, "of a building");
  if (finding.id != rules::building_finding_id(finding.building_id, sum.requirement.id)) {
    refuse_place(place, "id", "it must consist of the ids of building and requirement");
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < finding.members.size(); ++i) {
    if (names.insert(finding.members[i].name).second) continue;
    refuse_place(place.at("members", i), "name", "a building lists each room once");
  }
  expect(place, "verdict", finding.verdict, sum.verdict, kWhy);
  expect(place, "is_waived", finding.is_waived, sum.is_waived, kWhy);
  expect(place, "severity", finding.severity, sum.requirement.severity, kWhy);
  check_finding(own, sum, day);
  for (std::size_t i = 0; i < finding.members.size(); ++i) {
    check_room(place.at("members", i), project, findings, sum.requirement, finding.members[i]);
  }
  if (sum.verdict == Verdict::not_judged) return;
  const std::optional<double> rooms = rules::sum_of(finding.members);
  if (!rooms) refuse_place(place, "members", "the value of one room is not known");
  const calc::Estimate& said = sum.measured;
  const bool is_same =
      is_same_sum(said.value, *rooms) && said.low == said.value && said.high == said.value;
  expect(own, "measured", is_same, true, "from the rooms and their floors");
}

void check_aggregate(const Place& place, const ProjectPart& project, const Findings& findings,
                     const rules::AggregateFinding& finding, std::string_view day) {
  if (finding.sum) return check_sum(place, project, findings, finding, day);
  std::vector<rules::AggregateMember> lived_with = finding.members;
  for (std::size_t i = 0; i < finding.members.size(); ++i) {
    lived_with[i].verdict =
        check_member(place.at("members", i), findings, finding.members[i], finding.over);
  }
  rules::RuleAggregate terms;
  terms.rule = finding.rule;
  terms.count = finding.count;
  terms.share = finding.share;
  terms.by_area = finding.by_area;
  const std::optional<Verdict> verdict = combined_verdict(terms, finding.members);
  if (!verdict) refuse_place(place, "members", "nothing is required of them");
  constexpr const char* kWhy = "from its members";
  expect(place, "verdict", finding.verdict, *verdict, kWhy);
  const bool may_be_waived =
      *verdict != Verdict::pass &&
      combined_verdict(terms, lived_with).value_or(Verdict::pass) == Verdict::pass;
  // A room may lack a check, which then is not met whatever is waived.
  const bool is_sure = finding.over != rules::AggregateOver::rooms;
  if (is_sure || finding.is_waived) {
    expect(place, "is_waived", finding.is_waived, may_be_waived, kWhy);
  }
  if (finding.kind != rules::AggregateKind::row_class) return;
  expect(place, "severity", finding.severity, rules::Severity::advice, "classes are advice");
  if (*verdict == Verdict::fail && finding.reached == finding.asked) {
    refuse_place(place, "reached", "the required class fails and is not reached");
  }
}

void check_role(const Place& place, const Findings& findings, const rules::RoleCoverage& role,
                bool is_user_supplied, std::string_view day) {
  bool has_ended = false;
  for (std::size_t i = 0; i < role.left_out.size(); ++i) {
    const rules::LeftOutZone& zone = role.left_out[i];
    expect(place.at("left_out", i), "has_ended", zone.has_ended, !zone.by.holds_on(day),
           fmt::format("judged on {}, until {}", day, zone.by.until));
    has_ended = has_ended || zone.has_ended;
  }
  if (role.state == rules::RoleState::left_out && role.left_out.empty()) {
    refuse_place(place, "left_out", "the role is left out, but the list is empty");
  }
  const bool says_so = role.state == rules::RoleState::left_out_ended;
  if (has_ended || says_so) {
    expect(place, "state", says_so, has_ended, "from the days up to which it is left out");
    return;
  }
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  if (role.state == rules::RoleState::asked_in_part) {
    if (role.of.empty()) refuse_place(place, "of", "no part has a requirement");
    if (role.words.empty()) refuse_place(place, "words", "the part is not named");
    return;
  }
  bool has_waived = false;
  for (std::size_t i = 0; i < role.of.size(); ++i) {
    const rules::Finding& finding = *findings.of(place, i, role.of[i]).finding;
    expect(place.at("of", i), "user_supplied", is_user_supplied,
           finding.requirement.origin.is_user_supplied, "of the row, from its requirements");
    const rules::Outcome of_one = outcome_of(finding);
    outcome = graver(outcome, of_one);
    has_waived = has_waived || of_one == rules::Outcome::waived;
  }
  if (!role.of.empty()) {
    expect(place, "state", role.state, rules::state_of(outcome, has_waived),
           "from its requirements");
  } else if (rules::is_of_findings(role.state)) {
    expect(place, "state", role.state, rules::RoleState::never_asked, "nothing is required");
  }
}

void check_coverage(const Place& place, const Findings& findings, const SpacePart& space,
                    std::string_view day) {
  for (std::size_t r = 0; r < space.coverage.size(); ++r) {
    const rules::RowCoverage& row = space.coverage[r];
    const Place own = place.at("coverage", r, "row " + row.clause.english());
    for (std::size_t k = 0; k < row.roles.size(); ++k) {
      check_role(own.at("roles", k, fmt::format("role '{}'", row.roles[k].role)), findings,
                 row.roles[k], row.is_user_supplied, day);
    }
  }
}

// ---- a project

// Every error costs a verdict.
void check_errors(const Place& place, const ProjectPart& project) {
  if (!project.is_judged || outcome_of(project) == rules::Outcome::not_judged) return;
  const bool has_error =
      std::any_of(project.diagnostics.begin(), project.diagnostics.end(),
                  [](const auto& one) { return one.severity() == calc::Severity::error; });
  if (has_error) expect(place, "is_judged", true, false, "it has errors");
}

void check_project(const Place& place, const ProjectPart& project, std::string_view day) {
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const SpacePart& space = project.spaces[s];
    for (std::size_t k = 0; k < space.planes.size(); ++k) {
      check_plane(
          place.at("spaces", s).at("planes", k, fmt::format("plane '{}'", space.planes[k].id)),
          project, space, space.planes[k], day);
    }
  }
  const Findings findings(project);
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    check_coverage(place.at("spaces", s), findings, project.spaces[s], day);
  }
  for (std::size_t i = 0; i < project.aggregates.size(); ++i) {
    const rules::AggregateFinding& aggregate = project.aggregates[i];
    check_aggregate(place.at("aggregates", i,
                             fmt::format("{} '{}'", calc::name_of(aggregate.kind), aggregate.id)),
                    project, findings, aggregate, day);
  }
  check_errors(place, project);
}

// The day that waivers are held against; "" where nothing hangs on it.
std::string checked_day(const Document& document) {
  const Place place{"/provenance", "waivers and stated deviations end"};
  const std::string& day = document.provenance.judged_on;
  if (day.empty() && !hangs_on_the_day(document)) return day;
  if (!calc::is_day(day)) refuse_place(place, "judged_on", "a day, YYYY-MM-DD, is needed");
  const std::string& timestamp = document.provenance.timestamp;
  // Under a policy the clock's day counts, whatever the reports are dated.
  const bool is_by_clock = !document.provenance.policy.empty();
  if (!timestamp.empty() && !is_by_clock && !timestamp.starts_with(day)) {
    refuse_place(place, "judged_on", "it is not the day of the timestamp");
  }
  return day;
}

// Who takes the word out that only a part was judged must take it out everywhere.
void check_selection(const Place& place, const ProjectPart& project, bool is_part) {
  const bool says_part = std::any_of(project.diagnostics.begin(), project.diagnostics.end(),
                                     [](const calc::Diagnostic& one) {
                                       return one.id == calc::DiagnosticId::part_selected ||
                                              one.id == calc::DiagnosticId::nothing_selected;
                                     });
  if (says_part ? !is_part : is_part && project.is_judged) {
    refuse_place(place, "diagnostics", "it contradicts provenance/selection");
  }
}

}  // namespace

void refuse_contradictions(const Document& document) {
  const std::string day = checked_day(document);
  const Place root{"", ""};
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const ProjectPart& project = document.projects[p];
    Place place = root.at("projects", p);
    place.words = fmt::format("project '{}'", project.path);
    check_project(place, project, day);
    check_selection(place, project, !document.provenance.selection.empty());
  }
}

}  // namespace report
