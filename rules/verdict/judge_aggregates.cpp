#include "rules/verdict/judge_aggregates.h"

#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/scene/polygon.h"
#include "calc/scene/route_shape.h"
#include "calc/scene/zone_shapes.h"
#include "rules/applicability/covered_surface.h"
#include "rules/pack/evaluate.h"
#include "rules/pack/limit.h"
#include "rules/verdict/coverage.h"
#include "rules/verdict/members.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

namespace rules {
namespace {

struct Entry {
  const JudgedPlane* place;
  const Finding* finding;

  const RuleOrigin& origin() const { return finding->requirement.origin; }
};

// Findings that belong together, at least one; of one row and level unless they are of many rooms.
using Group = std::vector<Entry>;

bool names_check(const std::vector<std::string>& checks, const std::string& id) {
  return std::find(checks.begin(), checks.end(), id) != checks.end();
}

std::vector<Entry> entries_of(const std::vector<JudgedPlane>& planes, const RulePack& pack,
                              const std::vector<std::string>& checks) {
  std::vector<Entry> entries;
  for (const JudgedPlane& place : planes) {
    for (const Finding& finding : *place.findings) {
      const RuleOrigin& origin = finding.requirement.origin;
      if (origin.pack != pack.full_id() || !names_check(checks, origin.check)) continue;
      entries.push_back({&place, &finding});
    }
  }
  return entries;
}

// Returns groups in order of their first entries. belong: whether two entries are of one group.
template <class Belong>
std::vector<Group> grouped(const std::vector<Entry>& entries, Belong belong) {
  std::vector<Group> groups;
  for (const Entry& entry : entries) {
    const auto own = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& group) { return belong(group.front(), entry); });
    if (own == groups.end()) {
      groups.push_back({entry});
    } else {
      own->push_back(entry);
    }
  }
  return groups;
}

bool is_same_place(const calc::SourceLocation& a, const calc::SourceLocation& b) {
  return a.file == b.file && a.line == b.line && a.column == b.column;
}

// Returns whether both are from one <require> of one plane.
bool is_same_element(const Entry& a, const Entry& b) {
  const Requirement &left = a.finding->requirement, &right = b.finding->requirement;
  return a.place->plane == b.place->plane && is_same_place(left.where, right.where) &&
         left.origin.row == right.origin.row && left.scene == right.scene &&
         left.origin.level == right.origin.level;
}

bool is_same_use(const Entry& a, const Entry& b) {
  return a.place->space == b.place->space && a.origin().row == b.origin().row &&
         a.origin().level == b.origin().level && a.origin().facts == b.origin().facts;
}

bool is_same_plane(const Entry& a, const Entry& b) { return a.place->plane == b.place->plane; }
bool is_same_room(const Entry& a, const Entry& b) { return a.place->space == b.place->space; }

// Returns whether one plane can have all of them: a <require> has those of one role.
bool is_about_one_part(const std::vector<std::string>& checks, const RulePack& pack) {
  if (checks.empty()) return true;
  const std::string& role = pack.find_check(checks.front())->role;
  return std::all_of(checks.begin(), checks.end(),
                     [&](const std::string& id) { return pack.find_check(id)->role == role; });
}

LimitScope scope_of(const RulePack& pack, const RuleOrigin& origin) {
  return {pack, pack.find_row(origin.row), origin.level, origin.facts};
}

// A member with its verdict if everything waived were met.
struct Part {
  AggregateMember member;
  Verdict lived_with = Verdict::pass;
  calc::Message why_no_area;  // "" if it has one, or nothing is known of it
};

constexpr std::size_t kMostToldMembers = 4;

// Returns the source of a member's verdict, unless it is a pass: planes and the first reason.
calc::Message where_from(const std::vector<Entry>& entries, Verdict verdict) {
  if (verdict == Verdict::pass) return {};
  std::vector<std::string> planes;
  calc::Message reason;
  for (const Entry& entry : entries) {
    if (entry.finding->verdict != verdict) continue;
    const std::string& id = entry.place->plane->id;
    if (!names_check(planes, id)) planes.push_back(id);
    if (reason.empty() && verdict != Verdict::fail) reason = entry.finding->reason;
  }
  calc::Message where = calc::names_message(planes, kMostToldMembers);
  append(where, reason, ": ");
  return where;
}

Part part_of(std::string name, const std::vector<Entry>& entries) {
  Part part;
  part.member.name = std::move(name);
  part.member.verdict = Verdict::pass;
  for (const Entry& entry : entries) {
    const Finding& finding = *entry.finding;
    part.member.verdict = verdict_of_both(part.member.verdict, finding.verdict);
    part.lived_with =
        verdict_of_both(part.lived_with, finding.is_waived ? Verdict::pass : finding.verdict);
    part.member.is_waived = part.member.is_waived || finding.is_waived;
    part.member.of.push_back({finding.requirement.plane_id, finding.requirement.id});
  }
  part.member.reason = where_from(entries, part.member.verdict);
  return part;
}

// Returns a part for a check that no plane here requires; nothing if the row requires nothing of
// it.
std::optional<Part> missing_part(const RulePack& pack, const RuleCheck& check,
                                 const RuleOrigin& origin) {
  if (evaluate_limit(check, scope_of(pack, origin)).status == LimitStatus::not_applicable) {
    return std::nullopt;
  }
  Part part;
  part.member.name = check.id;
  part.lived_with = Verdict::not_judged;
  part.member.reason = check.quantity->kernel || check.quantity->of_space
                           ? calc::say<calc::Sentence::role_not_asked>(check.role)
                           : calc::say<calc::Sentence::not_calculated>(check.quantity->name);
  return part;
}

// Makes a pass not judged if the eyes look one way only, or see nothing that is rated.
void take_eyes_in_part(const std::vector<Entry>& entries, Part& part) {
  if (part.member.verdict != Verdict::pass) return;
  std::vector<EyesAsked> eyes;
  for (const Entry& entry : entries) {
    if (!entry.place->plane->made_by.empty()) return;
    eyes.push_back({entry.place->plane, entry.finding});
  }
  part.member.reason = eyes_in_part(eyes);
  if (part.member.reason.empty()) return;
  part.member.is_in_part = true;
  part.member.verdict = Verdict::not_judged;
  part.lived_with = Verdict::not_judged;
}

// Returns the checks of one plane or of one row in a room.
std::vector<Part> parts_by_check(const RulePack& pack, const std::vector<std::string>& checks,
                                 const Group& group) {
  std::vector<Part> parts;
  for (const std::string& id : checks) {
    std::vector<Entry> own;
    std::copy_if(group.begin(), group.end(), std::back_inserter(own),
                 [&](const Entry& entry) { return entry.origin().check == id; });
    if (!own.empty()) {
      parts.push_back(part_of(id, own));
      if (pack.find_check(id)->quantity->derived == calc::DerivedQuantity::ugr) {
        take_eyes_in_part(own, parts.back());
      }
    } else if (auto missing = missing_part(pack, *pack.find_check(id), group.front().origin())) {
      parts.push_back(std::move(*missing));
    }
  }
  return parts;
}

// Returns flat pieces that do not overlap; none if a plane has no area.
std::vector<calc::PlanarArea> pieces_of(const calc::CalcPlane& plane) {
  if (const auto* area = std::get_if<calc::PlanarArea>(&plane.area)) return {*area};
  std::vector<calc::PlanarArea> pieces;
  const auto* route = std::get_if<calc::EscapeRoute>(&plane.area);
  if (route == nullptr) return pieces;
  for (const calc::RouteLeg& leg : calc::route_legs(route->line)) {
    calc::PlanarArea piece;
    piece.origin_m.z = 0.5 * (leg.from_z_m + leg.to_z_m);
    piece.u = {1.0, 0.0, 0.0};
    piece.v = {0.0, 1.0, 0.0};
    const double right_m = -0.5 * route->line.width_m;
    piece.outline_m = {
        leg.place_m(leg.begin_m(right_m), right_m), leg.place_m(leg.end_m(right_m), right_m),
        leg.place_m(leg.end_m(-right_m), -right_m), leg.place_m(leg.begin_m(-right_m), -right_m)};
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::optional<double> area_of(const calc::CalcPlane& plane) {
  double area_m2 = 0.0;
  for (const calc::PlanarArea& piece : pieces_of(plane)) {
    area_m2 += calc::area_left(piece.outline_m, piece.holes_m);
  }
  return area_m2 > 0.0 ? std::optional(area_m2) : std::nullopt;
}

// Neighbours are drawn with edges that overlap by a little.
constexpr double kNeighbours = 0.01;

// Returns whether both share a floor area, which would count twice.
bool share_floor(const calc::CalcPlane& plane, const calc::CalcPlane& other) {
  double shared_m2 = 0.0;
  for (const calc::PlanarArea& piece : pieces_of(plane)) {
    for (const calc::PlanarArea& its : pieces_of(other)) shared_m2 += shared_area_m2(piece, its);
  }
  return shared_m2 >
         kNeighbours * std::min(area_of(plane).value_or(0.0), area_of(other).value_or(0.0));
}

std::optional<double> area_of(const calc::Space& space) {
  const double area_m2 =
      std::abs(calc::signed_area(space.shell ? space.shell->footprint_m : space.outline_m));
  return area_m2 > 0.0 ? std::optional(area_m2) : std::nullopt;
}

// Returns the planes; planes that share their floor have no area of their own.
std::vector<Part> parts_by_plane(const std::vector<Entry>& entries, bool by_area) {
  std::vector<Part> parts;
  const std::vector<Group> groups = grouped(entries, is_same_plane);
  for (const Group& group : groups) {
    const JudgedPlane& own = *group.front().place;
    Part part = part_of(own.plane->id, group);
    part.member.area_m2 = area_of(*own.plane);
    for (const Group& other : groups) {
      const JudgedPlane& its = *other.front().place;
      if (!by_area || its.plane == own.plane || its.space != own.space) continue;
      if (!share_floor(*own.plane, *its.plane)) continue;
      part.why_no_area =
          calc::say<calc::Sentence::planes_share_floor>(own.plane->id, its.plane->id);
      part.member.area_m2.reset();
      break;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// Returns the rooms: a room passes if every check of every row that it requires does.
std::vector<Part> parts_by_room(const RulePack& pack, const std::vector<std::string>& checks,
                                const std::vector<Entry>& entries) {
  std::vector<Part> parts;
  for (const Group& room : grouped(entries, is_same_room)) {
    Part part = part_of(room.front().place->space->id, room);
    for (const Group& use : grouped(room, is_same_use)) {
      for (const Part& check : parts_by_check(pack, checks, use)) {
        const Verdict verdict = verdict_of_both(part.member.verdict, check.member.verdict);
        if (verdict != part.member.verdict) {
          part.member.reason = calc::Message::words(check.member.name) + ": " + check.member.reason;
        }
        part.member.verdict = verdict;
        part.lived_with = verdict_of_both(part.lived_with, check.lived_with);
      }
    }
    part.member.area_m2 = area_of(*room.front().place->space);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<AggregateMember> members_of(const std::vector<Part>& parts) {
  std::vector<AggregateMember> members;
  for (const Part& part : parts) members.push_back(part.member);
  return members;
}

// Returns the verdict if everything waived were met.
std::optional<Verdict> lived_with(const RuleAggregate& aggregate, const std::vector<Part>& parts) {
  std::vector<AggregateMember> members = members_of(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) members[i].verdict = parts[i].lived_with;
  return combined_verdict(aggregate, members);
}

// Returns "fail: glare (desk.observer.1); not judged: luminance (luminance is not calculated)".
calc::Message reason_text(const std::vector<Part>& parts) {
  calc::Message text;
  for (const Verdict verdict : {Verdict::fail, Verdict::undecided, Verdict::not_judged}) {
    std::vector<calc::Message> names;
    for (const Part& part : parts) {
      const AggregateMember& member = part.member;
      if (member.verdict != verdict) continue;
      const calc::Message name = calc::Message::words(member.name);
      names.push_back(member.reason.empty() || member.reason == name
                          ? name
                          : name + " (" + member.reason + ")");
    }
    if (names.empty()) continue;
    const calc::Message list = calc::listed(names, kMostToldMembers);
    append(text, verdict == Verdict::fail        ? calc::say<calc::Sentence::failing>(list)
                 : verdict == Verdict::undecided ? calc::say<calc::Sentence::undecided_are>(list)
                                                 : calc::say<calc::Sentence::not_judged_are>(list));
  }
  return text;
}

// Returns the persons who waived parts of it.
calc::Message waiver_text(const std::vector<Entry>& entries) {
  std::vector<calc::Message> told;
  for (const Entry& entry : entries) {
    const std::optional<Waiver>& waiver = entry.finding->requirement.waiver;
    if (!entry.finding->is_waived || !waiver) continue;
    calc::Message text =
        calc::say<calc::Sentence::waived_by>(waiver->owner, waiver->until, waiver->reason);
    if (std::find(told.begin(), told.end(), text) == told.end()) told.push_back(std::move(text));
  }
  return calc::listed(told, kMostToldMembers);
}

Trust worst_trust(const RulePack& pack, Trust own, const std::vector<std::string>& checks,
                  const std::vector<Entry>& entries) {
  Trust trust = own;
  for (const Entry& entry : entries) {
    trust = std::max(trust, evaluate_limit(*pack.find_check(entry.origin().check),
                                           scope_of(pack, entry.origin()))
                                .trust);
  }
  for (const std::string& id : checks) trust = std::max(trust, pack.find_check(id)->trust);
  return trust;
}

calc::Message clause_of(const RulePack& pack, const std::string& clause, const Group& group,
                        Trust trust) {
  std::string text = fmt::format("{}:{}", pack.title, pack.edition);
  const RuleOrigin& origin = group.front().origin();
  const std::string& ref = clause.empty() ? origin.row : clause;
  if (!ref.empty()) text += " " + ref;
  const std::string level = level_words(origin.level);
  if (!level.empty() && clause.empty()) text += fmt::format(" ({})", level);
  return with_trust(calc::Message::words(text), trust);
}

calc::Message note_of(const RulePack& pack, const std::string& own, Trust trust) {
  calc::Message note = trust_remark(trust);
  if (pack.status != "published") {
    append(note, calc::say<calc::Sentence::pack_status>(pack.full_id(), pack.status));
  }
  append(note, calc::Message::words(own));
  return note;
}

void settle(AggregateFinding& finding, const RuleAggregate& aggregate,
            const std::vector<Part>& parts, const Group& group) {
  finding.is_waived = finding.verdict != Verdict::pass &&
                      lived_with(aggregate, parts).value_or(Verdict::pass) == Verdict::pass;
  if (finding.verdict != Verdict::pass) finding.reason = reason_text(parts);
  if (finding.is_waived) append(finding.reason, waiver_text(group));
  finding.members = members_of(parts);
}

std::optional<AggregateFinding> aggregate_finding(const RulePack& pack,
                                                  const RuleAggregate& aggregate,
                                                  const Group& group,
                                                  const std::vector<Part>& parts) {
  const std::optional<Verdict> verdict = combined_verdict(aggregate, members_of(parts));
  if (!verdict) return std::nullopt;
  AggregateFinding finding;
  finding.id = aggregate.id;
  finding.rule = aggregate.rule;
  finding.over = aggregate.over;
  finding.count = aggregate.count;
  finding.share = aggregate.share;
  finding.by_area = aggregate.by_area;
  finding.severity = aggregate.severity;
  finding.verdict = *verdict;
  finding.where = group.front().finding->requirement.where;
  const bool is_of_room = aggregate.over == AggregateOver::checks;
  if (is_of_room) finding.space_id = group.front().place->space->id;
  if (is_of_room && is_about_one_part(aggregate.checks, pack)) {
    finding.plane_id = group.front().place->plane->id;
  }
  const Trust trust = worst_trust(pack, aggregate.trust, aggregate.checks, group);
  // Of a whole project the rows may be many.
  finding.clause = clause_of(
      pack,
      is_of_room ? aggregate.clause : (aggregate.clause.empty() ? aggregate.id : aggregate.clause),
      group, trust);
  finding.is_user_supplied = !pack.is_built_in;
  finding.note = note_of(pack, aggregate.note, trust);
  settle(finding, aggregate, parts, group);
  if (*verdict == Verdict::not_judged && lacks_areas(aggregate, finding.members)) {
    const auto shared = std::find_if(parts.begin(), parts.end(),
                                     [](const Part& part) { return !part.why_no_area.empty(); });
    append(finding.reason,
           shared == parts.end() ? calc::say<calc::Sentence::area_unknown>() : shared->why_no_area);
  }
  if (lacks_members(aggregate, finding.members)) {
    append(finding.reason, calc::say<calc::Sentence::too_few_apply>(aggregate.count, parts.size()));
  }
  return finding;
}

void judge_aggregate(const std::vector<JudgedPlane>& planes, const RulePack& pack,
                     const RuleAggregate& aggregate, std::vector<AggregateFinding>& findings) {
  const std::vector<Entry> entries = entries_of(planes, pack, aggregate.checks);
  if (entries.empty()) return;
  const auto add = [&](const Group& group, const std::vector<Part>& parts) {
    if (auto finding = aggregate_finding(pack, aggregate, group, parts)) {
      findings.push_back(std::move(*finding));
    }
  };
  switch (aggregate.over) {
    case AggregateOver::planes:
      return add(entries, parts_by_plane(entries, aggregate.by_area));
    case AggregateOver::rooms:
      return add(entries, parts_by_room(pack, aggregate.checks, entries));
    case AggregateOver::checks:
      break;
  }
  const bool is_of_plane = is_about_one_part(aggregate.checks, pack);
  for (const Group& group : grouped(entries, is_of_plane ? is_same_element : is_same_use)) {
    add(group, parts_by_check(pack, aggregate.checks, group));
  }
}

// Returns what every plane of the group has measured, by check. An interval that cannot be trusted
// is unlimited.
std::map<std::string, calc::Estimate> measured_on(const calc::CalcPlane* plane,
                                                  const Group& group) {
  constexpr double kOpen = 0.5 * std::numeric_limits<double>::max();  // a policy may widen it
  std::map<std::string, calc::Estimate> measured;
  std::set<std::string> unknown;
  for (const Entry& entry : group) {
    const Finding& finding = *entry.finding;
    if (entry.place->plane != plane) continue;
    if (finding.verdict == Verdict::not_judged) {
      unknown.insert(entry.origin().check);
      continue;
    }
    const calc::Estimate& estimate = finding.measured;
    const calc::Estimate own =
        finding.is_doubtful ? calc::Estimate{estimate.value, -kOpen, kOpen} : estimate;
    const auto [found, is_first] = measured.emplace(entry.origin().check, own);
    if (is_first) continue;
    // Several scenes: whichever holds.
    found->second.low = std::min(found->second.low, own.low);
    found->second.high = std::max(found->second.high, own.high);
  }
  for (const std::string& check : unknown) measured.erase(check);
  return measured;
}

// Returns the status of all checks of a class, with the limits of this row.
CheckStatus class_status(const RulePack& pack, const RuleClass& item, const RuleRow& row,
                         const Group& group) {
  RuleAggregate all;
  std::vector<WeightedStatus> members;
  std::set<std::string> seen;
  for (const Entry& entry : group) {
    Evidence evidence{pack, &row, scope_of(pack, entry.origin()).level, entry.origin().facts,
                      measured_on(entry.place->plane, group)};
    seen.insert(entry.origin().check);
    members.push_back({evaluate_check(*pack.find_check(entry.origin().check), evidence)});
  }
  for (const std::string& id : item.checks) {
    if (seen.contains(id)) continue;
    const Evidence evidence{pack, &row, scope_of(pack, group.front().origin()).level,
                            group.front().origin().facts};
    members.push_back({evaluate_check(*pack.find_check(id), evidence)});
  }
  return combine_statuses(all, members);
}

void judge_class(const std::vector<JudgedPlane>& planes, const RulePack& pack,
                 const RuleClass& item, std::vector<AggregateFinding>& findings) {
  std::vector<Entry> entries = entries_of(planes, pack, item.checks);
  std::erase_if(entries,
                [&](const Entry& entry) { return !names_check(item.rows, entry.origin().row); });
  const bool is_of_plane = is_about_one_part(item.checks, pack);
  for (const Group& group : grouped(entries, is_of_plane ? is_same_element : is_same_use)) {
    const std::vector<Part> parts = parts_by_check(pack, item.checks, group);
    const std::optional<Verdict> verdict = combined_verdict(RuleAggregate{}, members_of(parts));
    if (!verdict) continue;
    AggregateFinding finding;
    finding.kind = AggregateKind::row_class;
    finding.id = item.id;
    finding.space_id = group.front().place->space->id;
    if (is_of_plane) finding.plane_id = group.front().place->plane->id;
    finding.severity = Severity::advice;
    finding.verdict = *verdict;
    finding.where = group.front().finding->requirement.where;
    const Trust trust = worst_trust(pack, Trust::confirmed, item.checks, group);
    finding.clause = clause_of(pack, "", group, trust);
    finding.is_user_supplied = !pack.is_built_in;
    finding.note = note_of(pack, "", trust);
    finding.asked = group.front().origin().row;
    for (const std::string& ref : item.rows) {
      const CheckStatus status = class_status(pack, item, *pack.find_row(ref), group);
      const bool is_reached = status == CheckStatus::pass;
      if (finding.possible.empty() && (is_reached || status == CheckStatus::undecided)) {
        finding.possible = ref;
      }
      if (!is_reached) continue;
      finding.reached = ref;
      break;
    }
    settle(finding, RuleAggregate{}, parts, group);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

std::vector<AggregateFinding> judge_aggregates(const std::vector<JudgedPlane>& planes,
                                               const std::vector<RulePack>& packs) {
  std::vector<AggregateFinding> findings;
  for (const RulePack& pack : packs) {
    for (const RuleAggregate& aggregate : pack.aggregates) {
      judge_aggregate(planes, pack, aggregate, findings);
    }
    for (const RuleClass& item : pack.classes) judge_class(planes, pack, item, findings);
  }
  return findings;
}

}  // namespace rules
