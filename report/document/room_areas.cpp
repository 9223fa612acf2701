#include "report/document/room_areas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace report {
namespace {

// The worse of two for the same column: by verdict, then by margin; the first of equal ones. Of
// what passes in both directions the least that is required says more than the most.
const rules::Finding* worse(const rules::Finding* known, const rules::Finding& other) {
  if (known == nullptr) return &other;
  const rules::Outcome was = outcome_of(*known), is = outcome_of(other);
  if (was != is) return is < was ? &other : known;
  const bool was_least = rules::is_lower_limit(known->requirement.comparison),
             is_least = rules::is_lower_limit(other.requirement.comparison);
  if (was_least != is_least) return is_least ? &other : known;
  return other.margin < known->margin ? &other : known;
}

bool is_glare(const PlanePart& plane, const rules::Requirement& requirement) {
  return requirement.metric == rules::Metric::ugr_table ||
         (plane.derived == calc::DerivedQuantity::ugr &&
          requirement.metric == rules::Metric::maximum);
}

bool is_plain(const PlanePart& plane) {
  return plane.kernel == calc::ReceiverKernel::planar &&
         plane.derived == calc::DerivedQuantity::none;
}

using AreaPart = RoomArea::Part;

// A workplace, or a plane that no workplace asks.
struct TaskPlace {
  std::string workplace;
  std::vector<AreaPart> parts;  // in document order
};

// A carriageway and the strips beside it are areas by themselves, whatever role a pack is about.
bool is_strip(const SpacePart& space, const rules::Requirement& requirement) {
  return space.road.has_value() && requirement.origin.workplaces.empty();
}

bool is_of_area(const SpacePart& space, const rules::Requirement& requirement) {
  return requirement.origin.is_of_own_role || is_strip(space, requirement);
}

// That makes an area: no wall, no eye, nothing about the room, and no advice alone.
bool is_task(const SpacePart& space, const AreaPart& part) {
  const rules::Requirement& requirement = part.finding->requirement;
  if (outcome_of(*part.finding) == rules::Outcome::nothing_asked) return false;
  if (rules::is_of_road(requirement.metric)) return true;
  const bool is_own = is_plain(*part.plane) && requirement.origin.is_of_own_role;
  return (is_own || is_strip(space, requirement)) && !rules::is_about_space(requirement.metric);
}

// What the project asks of a workplace's plane besides is of the workplace.
std::vector<std::string> workplaces_of(const PlanePart& plane) {
  std::vector<std::string> ids;
  std::set<std::string> known;
  for (const rules::Finding& finding : plane.findings) {
    for (const std::string& id : finding.requirement.origin.workplaces) {
      if (known.insert(id).second) ids.push_back(id);
    }
  }
  return ids;
}

std::vector<TaskPlace> places_of(const SpacePart& space) {
  std::vector<TaskPlace> places;
  std::map<std::pair<std::string, const PlanePart*>, std::size_t> index;
  const auto add = [&](const std::string& workplace, const AreaPart& part) {
    const PlanePart* own = workplace.empty() ? part.plane : nullptr;
    const auto [found, is_new] = index.emplace(std::pair(workplace, own), places.size());
    if (is_new) places.push_back({workplace, {}});
    places[found->second].parts.push_back(part);
  };
  for (const PlanePart& plane : space.planes) {
    const std::vector<std::string> of_plane = workplaces_of(plane);
    for (const rules::Finding& finding : plane.findings) {
      const std::vector<std::string>& own = finding.requirement.origin.workplaces;
      for (const std::string& id : own.empty() ? of_plane : own) add(id, {&plane, &finding});
      if (of_plane.empty()) add("", {&plane, &finding});
    }
  }
  return places;
}

AskedRow row_of(const rules::RuleOrigin& origin) {
  if (origin.pack.empty() || origin.row.empty()) return {};
  return {origin.pack, origin.row, origin.is_user_supplied};
}

RoomArea area_of_parts(const SpacePart& space, const std::string& workplace,
                       const std::vector<AreaPart>& parts) {
  RoomArea area;
  area.workplace = workplace;
  area.parts = parts;
  for (const AreaPart& part : parts) {
    const rules::Requirement& requirement = part.finding->requirement;
    add_to_values(*part.plane, *part.finding, is_of_area(space, requirement), area);
    if (!is_task(space, part)) continue;
    if (area.task == nullptr) area.task = part.plane;
    // A wall that tasks share is asked by the row of one of them.
    add_row(requirement.origin, area.rows);
  }
  return area;
}

// One, or one for each row that asks of the task. What is of none of these rows is of each area: no
// requirement is of none.
void add_areas(const SpacePart& space, const TaskPlace& place, std::vector<RoomArea>& areas) {
  std::vector<AskedRow> rows;  // {}: of no row
  std::size_t of_packs = 0;
  for (const AreaPart& part : place.parts) {
    if (!is_task(space, part)) continue;
    const AskedRow row = row_of(part.finding->requirement.origin);
    if (std::find(rows.begin(), rows.end(), row) != rows.end()) continue;
    rows.push_back(row);
    of_packs += row.pack.empty() ? 0 : 1;
  }
  if (rows.empty()) return;
  if (of_packs < 2) {
    areas.push_back(area_of_parts(space, place.workplace, place.parts));
    return;
  }
  for (const AskedRow& row : rows) {
    std::vector<AreaPart> parts;
    for (const AreaPart& part : place.parts) {
      const AskedRow own = row_of(part.finding->requirement.origin);
      const bool is_of_none = std::find(rows.begin(), rows.end(), own) == rows.end();
      if (own == row || is_of_none) parts.push_back(part);
    }
    areas.push_back(area_of_parts(space, place.workplace, parts));
    areas.back().is_one_of_uses = true;
  }
}

using FindingNames = std::set<std::pair<std::string, std::string>>;  // plane, requirement

FindingNames names_in(const RoomArea& area) {
  FindingNames names;
  for (const AreaPart& part : area.parts)
    names.emplace(part.plane->id, part.finding->requirement.id);
  return names;
}

bool is_about(const rules::AggregateFinding& aggregate, const FindingNames& names) {
  return std::any_of(aggregate.members.begin(), aggregate.members.end(), [&](const auto& member) {
    return std::any_of(member.of.begin(), member.of.end(), [&](const auto& name) {
      return names.contains({name.plane_id, name.id});
    });
  });
}

void add_aggregates(const std::vector<const rules::AggregateFinding*>& aggregates, RoomArea& area) {
  if (aggregates.empty()) return;
  const FindingNames names = names_in(area);
  for (const rules::AggregateFinding* aggregate : aggregates) {
    if (!is_about(*aggregate, names)) continue;
    if (aggregate->kind == rules::AggregateKind::row_class) area.classes.push_back(aggregate);
    const rules::Outcome outcome = outcome_of(*aggregate);
    area.outcome = graver(area.outcome, outcome);
    if (!rules::counts(outcome)) continue;
    ++area.required;
    area.met += aggregate->verdict == rules::Verdict::pass ? 1 : 0;
  }
}

// Of what its verdict is from; infinite where nothing has one.
double least_margin(const RoomArea& area) {
  double least = std::numeric_limits<double>::infinity();
  for (const AreaPart& part : area.parts) {
    const rules::Finding& finding = *part.finding;
    if (outcome_of(finding) == area.outcome && !std::isnan(finding.margin))
      least = std::min(least, finding.margin);
  }
  return least;
}

void sort_areas(std::vector<RoomArea>& areas) {
  std::vector<std::pair<double, RoomArea>> by_margin;
  by_margin.reserve(areas.size());
  for (RoomArea& area : areas) {
    const double margin = least_margin(area);
    by_margin.emplace_back(margin, std::move(area));
  }
  std::stable_sort(by_margin.begin(), by_margin.end(), [](const auto& a, const auto& b) {
    if (a.second.outcome != b.second.outcome) return a.second.outcome < b.second.outcome;
    return a.first < b.first;
  });
  for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = std::move(by_margin[i].second);
}

}  // namespace

bool RoomArea::has(const rules::Finding* finding) const {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Part& part) { return part.finding == finding; });
}

void add_to_values(const PlanePart& plane, const rules::Finding& finding, bool is_of_task,
                   KeyValues& values) {
  const rules::Outcome outcome = outcome_of(finding);
  if (outcome == rules::Outcome::nothing_asked) return;
  values.outcome = graver(values.outcome, outcome);
  if (!rules::counts(outcome)) return;
  ++values.required;
  values.met += finding.verdict == rules::Verdict::pass ? 1 : 0;
  const rules::Requirement& requirement = finding.requirement;
  if (is_glare(plane, requirement)) values.glare = worse(values.glare, finding);
  const bool is_average = requirement.metric == rules::Metric::average;
  if (is_average && plane.kernel == calc::ReceiverKernel::cylindrical) {
    values.cylindrical = worse(values.cylindrical, finding);
  }
  // A road is asked as such, not as the role of one of its planes.
  const bool is_road = rules::is_of_road(requirement.metric);
  if (!is_plain(plane) || !(is_road || is_of_task)) return;
  if (is_average || requirement.metric == rules::Metric::road_luminance)
    values.average = worse(values.average, finding);
  if (requirement.metric == rules::Metric::minimum) values.minimum = worse(values.minimum, finding);
  if (requirement.metric == rules::Metric::uniformity_min_avg ||
      requirement.metric == rules::Metric::road_uniformity) {
    values.uniformity = worse(values.uniformity, finding);
  }
}

void add_row(const rules::RuleOrigin& origin, std::vector<AskedRow>& rows) {
  if (origin.pack.empty() || origin.row.empty()) return;
  AskedRow row{origin.pack, origin.row, origin.is_user_supplied};
  if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
}

std::vector<RoomArea> room_areas(const SpacePart& space,
                                 const std::vector<const rules::AggregateFinding*>& aggregates) {
  std::vector<RoomArea> areas;
  for (const TaskPlace& place : places_of(space)) add_areas(space, place, areas);
  if (areas.size() < 2) return {};
  for (RoomArea& area : areas) add_aggregates(aggregates, area);
  sort_areas(areas);
  return areas;
}

}  // namespace report
