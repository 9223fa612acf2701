#include "report/document/road_facts.h"

#include "rules/catalogue/metric.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace report {
namespace {

// Of numbers that are equal but for rounding.
constexpr double kRounding = 1.0e-9;

bool is_equal(double a, double b) {
  return std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b));
}

// A results file may hold any numbers.
std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

const PlanePart* plane_of(const SpacePart& space, const RoadAreaPart& area) {
  const auto found =
      std::find_if(space.planes.begin(), space.planes.end(),
                   [&](const PlanePart& plane) { return plane.id == area.plane_id; });
  return found == space.planes.end() ? nullptr : &*found;
}

// Marks of trust are of single requirements, which are listed elsewhere: of a row the clause with
// the fewest words.
std::vector<calc::Message> classes_of(const PlanePart& plane) {
  using Row = std::pair<std::string, std::string>;  // pack, row
  std::vector<Row> rows;
  std::vector<calc::Message> classes;
  for (const rules::Finding& finding : plane.findings) {
    const calc::Message& clause = finding.requirement.clause;
    const rules::RuleOrigin& origin = finding.requirement.origin;
    if (clause.empty() || origin.pack.empty()) continue;
    const Row row{origin.pack, origin.row};
    const auto at = std::find(rows.begin(), rows.end(), row) - rows.begin();
    if (at == std::ssize(rows)) {
      rows.push_back(row);
      classes.push_back(clause);
    }
    calc::Message& known = classes[static_cast<std::size_t>(at)];
    if (clause.english().size() < known.english().size()) known = clause;
  }
  return classes;
}

RoadFacts::Area facts_of(const SpacePart& space, const RoadAreaPart& area) {
  RoadFacts::Area facts;
  facts.area = &area;
  facts.plane = plane_of(space, area);
  facts.m2 = (area.to_y_m - area.from_y_m) * space.road->spacing_m;
  if (facts.plane == nullptr) return facts;
  facts.classes = classes_of(*facts.plane);
  const bool is_known = facts.plane->is_computed && calc::is_finite(facts.plane->average);
  if (is_known) facts.average_lx = facts.plane->average;
  return facts;
}

RoadArrangement arrangement_of(const RoadPart& road) {
  const auto on_left = static_cast<std::size_t>(
      std::count_if(road.rows.begin(), road.rows.end(),
                    [&](const RoadRowPart& row) { return is_on_the_left(road, row); }));
  if (road.rows.size() == 1) return on_left == 1 ? RoadArrangement::left : RoadArrangement::right;
  if (road.rows.size() != 2 || on_left != 1) return RoadArrangement::other;
  // Of a luminaire to the nearest one on the other side.
  const double behind_m =
      first_shift_m(road.rows[1].shift_m - road.rows[0].shift_m, road.spacing_m);
  const double apart_m = std::min(behind_m, road.spacing_m - behind_m);
  if (apart_m <= kRounding * road.spacing_m) return RoadArrangement::opposite;
  return is_equal(apart_m, 0.5 * road.spacing_m) ? RoadArrangement::staggered
                                                 : RoadArrangement::other;
}

std::optional<double> power_of(const RoadPart& road) {
  double power_w = 0.0;
  for (const RoadRowPart& row : road.rows) {
    if (!(row.power_w > 0.0)) return std::nullopt;
    power_w += row.power_w;
  }
  return road.rows.empty() ? std::nullopt : if_finite(power_w);
}

// Of the areas along the road each place once.
double shared_once_m2(const RoadPart& road) {
  std::vector<RoadAreaPart> areas = road.areas;
  std::sort(areas.begin(), areas.end(),
            [](const RoadAreaPart& a, const RoadAreaPart& b) { return a.from_y_m < b.from_y_m; });
  double m = 0.0, reached_m = -std::numeric_limits<double>::infinity();
  for (const RoadAreaPart& area : areas) {
    m += std::max(0.0, area.to_y_m - std::max(area.from_y_m, reached_m));
    reached_m = std::max(reached_m, area.to_y_m);
  }
  return m * road.spacing_m;
}

std::optional<calc::Estimate> power_density(const RoadFacts& facts) {
  if (!facts.power_w || facts.areas.empty() || facts.do_areas_overlap) return std::nullopt;
  calc::Estimate light;  // lx m2
  for (const RoadFacts::Area& area : facts.areas) {
    if (!area.average_lx) return std::nullopt;
    light.value += area.average_lx->value * area.m2;
    light.low += area.average_lx->low * area.m2;
    light.high += area.average_lx->high * area.m2;
  }
  if (!(light.low > 0.0) || !calc::is_finite(light)) return std::nullopt;
  const calc::Estimate density{*facts.power_w / light.value, *facts.power_w / light.high,
                               *facts.power_w / light.low};
  return calc::is_finite(density) ? std::optional(density) : std::nullopt;
}

// At an edge where there is only one lane, the lower of the two.
std::optional<calc::Estimate> edge_ratio_of(const calc::RoadLight& light, std::size_t lane) {
  std::optional<calc::Estimate> ratio;
  const auto add = [&](const std::optional<calc::Estimate>& edge) {
    if (edge && (!ratio || edge->value < ratio->value)) ratio = edge;
  };
  if (lane == 0) add(light.right_ratio);
  if (lane + 1 == light.observers.size()) add(light.left_ratio);
  return ratio;
}

// The eye at the other end sees what this one sees, turned by half a turn.
bool is_turned(const calc::RoadObserver& one, const calc::RoadObserver& other) {
  return one.is_oncoming != other.is_oncoming && one.cd_m2.size() == other.cd_m2.size() &&
         std::equal(one.cd_m2.begin(), one.cd_m2.end(), other.cd_m2.rbegin(), is_equal);
}

std::vector<RoadFacts::Observer> observers_of(const calc::RoadLight& light) {
  std::vector<RoadFacts::Observer> facts(light.observers.size());
  for (std::size_t i = 0; i < facts.size(); ++i) {
    facts[i].edge_ratio = edge_ratio_of(light, i);
    for (std::size_t k = 0; k < i && !facts[i].same_as; ++k) {
      if (is_turned(light.observers[k], light.observers[i])) facts[i].same_as = k;
    }
  }
  // sign: 1 where the lowest value decides, -1 where the highest one does.
  const auto mark = [&](bool RoadFacts::Observer::*decides, double sign, const auto& value_of) {
    std::optional<double> worst;
    for (std::size_t i = 0; i < facts.size(); ++i) {
      const std::optional<calc::Estimate> estimate = value_of(i);
      if (estimate && (!worst || sign * estimate->value < sign * *worst)) worst = estimate->value;
    }
    for (std::size_t i = 0; i < facts.size(); ++i) {
      const std::optional<calc::Estimate> estimate = value_of(i);
      facts[i].*decides = estimate && is_equal(estimate->value, *worst);
    }
  };
  const std::vector<calc::RoadObserver>& seen = light.observers;
  using Observer = RoadFacts::Observer;
  mark(&Observer::of_average, 1.0,
       [&](std::size_t i) { return std::optional(seen[i].average_cd_m2); });
  mark(&Observer::of_uo, 1.0, [&](std::size_t i) { return seen[i].uo; });
  mark(&Observer::of_ul, 1.0, [&](std::size_t i) { return seen[i].ul; });
  mark(&Observer::of_ti, -1.0, [&](std::size_t i) { return seen[i].ti_percent; });
  mark(&Observer::of_edge_ratio, 1.0, [&](std::size_t i) { return facts[i].edge_ratio; });
  return facts;
}

}  // namespace

std::optional<double> RoadFacts::power_w_km(const RoadPart& road) const {
  constexpr double kMetres = 1000.0;
  return power_w ? if_finite(*power_w * kMetres / road.spacing_m) : std::nullopt;
}

std::optional<double> RoadFacts::energy_kwh_m2(double hours) const {
  constexpr double kWatts = 1000.0;
  const bool is_known = power_w && m2 > 0.0 && std::isfinite(m2);
  return is_known ? if_finite(*power_w * hours / (kWatts * m2)) : std::nullopt;
}

bool is_on_the_left(const RoadPart& road, const RoadRowPart& row) {
  return row.y_m > 0.5 * road.width_m;
}

double overhang_m(const RoadPart& road, const RoadRowPart& row) {
  return is_on_the_left(road, row) ? road.width_m - row.y_m : row.y_m;
}

double street_tilt_deg(const RoadPart& road, const RoadRowPart& row) {
  return is_on_the_left(road, row) ? 0.0 - row.tilt_deg : row.tilt_deg;
}

double first_shift_m(double shift_m, double spacing_m) {
  const double behind_m = std::fmod(shift_m, spacing_m);
  const double first_m = behind_m < 0.0 ? behind_m + spacing_m : behind_m + 0.0;  // no -0
  return first_m < spacing_m ? first_m : 0.0;  // of a hair below 0
}

const rules::Requirement* road_requirement(const RoadFacts& facts, rules::Metric metric) {
  const rules::Requirement* strictest = nullptr;
  if (facts.areas.empty() || facts.areas.front().plane == nullptr) return nullptr;
  for (const rules::Finding& finding : facts.areas.front().plane->findings) {
    const rules::Requirement& asked = finding.requirement;
    if (asked.metric != metric || !std::isfinite(asked.limit)) continue;
    const double sign = metric == rules::Metric::threshold_increment ? -1.0 : 1.0;
    if (strictest == nullptr || sign * asked.limit > sign * strictest->limit) strictest = &asked;
  }
  return strictest;
}

RoadFacts road_facts(const SpacePart& space) {
  RoadFacts facts;
  if (!space.road) return facts;
  const RoadPart& road = *space.road;
  facts.arrangement = arrangement_of(road);
  facts.luminaires = static_cast<int>(road.rows.size());
  facts.power_w = power_of(road);
  for (const RoadAreaPart& area : road.areas) {
    facts.areas.push_back(facts_of(space, area));
    facts.m2 += facts.areas.back().m2;
  }
  // Ends that are calculated differ by rounding.
  constexpr double kLeastOverlap_m2 = 1e-6;
  const double once_m2 = shared_once_m2(road);
  facts.do_areas_overlap = facts.m2 - once_m2 > std::max(kLeastOverlap_m2, kRounding * facts.m2);
  if (facts.do_areas_overlap) facts.m2 = once_m2;
  facts.observers = observers_of(road.light);
  facts.power_density_w_lx_m2 = power_density(facts);
  return facts;
}

}  // namespace report
