#include "rules/measure/measure.h"

#include "calc/base/glare_limits.h"
#include "calc/base/sentences.h"
#include "calc/glare/field_glare.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/polygon.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/mask.h"
#include "rules/measure/candidates.h"
#include "rules/measure/derived_metrics.h"
#include "rules/measure/despite_doubt.h"
#include "rules/measure/leave_one_out.h"
#include "rules/measure/neighbour_pairs.h"
#include "rules/measure/outage.h"
#include "rules/measure/share.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <variant>

namespace rules {
namespace {

constexpr double kListPointToleranceMetres =
    1e-3;  // point lists have no cells: the point itself must be named

calc::Message direction_text(const glm::dvec3& way) {
  return calc::Message::number(fmt::format("({:.3g} {:.3g} {:.3g})", way.x, way.y, way.z));
}

calc::Message point_text(const glm::dvec3& p) {
  return calc::Message::number(fmt::format("({:.3f}, {:.3f}, {:.3f}) m", p.x, p.y, p.z));
}

constexpr double kSameStep_m = 0.1;  // of a route's points: not a tread further up or down

// Returns whether the place is in the cell of the point, or on its edge.
bool is_in_cell(const calc::SensorGrid& grid, const calc::RouteCells& cells, std::size_t point,
                const glm::dvec3& place_m) {
  return std::abs(grid.position_m[point].z - place_m.z) <= kSameStep_m &&
         calc::contains_point(cells.corners_m(grid.column[point], grid.row[point]),
                              glm::dvec2(place_m));
}

// Returns the point of the cell with the place. Cells at bends are not rectangles, so the nearest
// centre may be that of the next cell.
std::size_t point_at(const calc::SensorGrid& grid, const glm::dvec3& wanted_m) {
  if (grid.route) {
    const calc::RouteCells cells = grid.route->cells(grid.rows);
    for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
      if (is_in_cell(grid, cells, i, wanted_m)) return i;
    }
  }
  const auto distance = [&](const glm::dvec3& p) { return glm::length(p - wanted_m); };
  const auto nearest = std::min_element(
      grid.position_m.begin(), grid.position_m.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - grid.position_m.begin());
}

// Largest distance of a place from a plane in which it is meant to lie, after measuring and
// rounding.
constexpr double kSamePlane_m = 0.05;

// Returns the distance of the place from the plane of the point.
double distance_across_m(const calc::SensorGrid& grid, std::size_t point,
                         const glm::dvec3& wanted_m) {
  return std::abs(glm::dot(grid.position_m[point] - wanted_m, glm::cross(grid.u, grid.v)));
}

// Returns whether the place is within half a cell along the plane's axes, and hardly off the plane;
// for a route in the cell itself.
bool is_near(const calc::SensorGrid& grid, std::size_t point, const glm::dvec3& wanted_m) {
  if (grid.route) return is_in_cell(grid, grid.route->cells(grid.rows), point, wanted_m);
  const glm::dvec3 offset_m = grid.position_m[point] - wanted_m;
  if (grid.columns == 0) return glm::length(offset_m) <= kListPointToleranceMetres;
  constexpr double kBinaryNoise_m = 1e-9;  // a place midway between two points is near both
  const double half_u = 0.5 * grid.spacing_u_m + kBinaryNoise_m;
  const double half_v = 0.5 * grid.spacing_v_m + kBinaryNoise_m;
  return std::abs(glm::dot(offset_m, grid.u)) <= half_u &&
         std::abs(glm::dot(offset_m, grid.v)) <= half_v &&
         distance_across_m(grid, point, wanted_m) <= kSamePlane_m + kBinaryNoise_m;
}

constexpr double kSameLook = 0.9998;  // cosine: about a degree

// Returns the point at the place of point `nearest` with the required direction; only a list has
// several there. Empty, with the reason: there is none, or no direction is stated.
std::optional<std::size_t> point_facing(const calc::SensorGrid& grid, std::size_t nearest,
                                        const PointOfValue& asked, calc::Message& reason) {
  if (grid.columns > 0 && !asked.facing) return nearest;
  const glm::dvec3& wanted_m = asked.point_m.value();
  const auto looks_like = [&](std::size_t i, const glm::dvec3& look) {
    return grid.kernel == calc::ReceiverKernel::scalar ||
           glm::dot(grid.normal[i], look) >= kSameLook;
  };
  const glm::dvec3 look = asked.facing.value_or(grid.normal[nearest]);
  std::vector<std::size_t> there{nearest};
  for (std::size_t i = 0; grid.columns == 0 && i < grid.position_m.size(); ++i) {
    if (i != nearest && is_near(grid, i, wanted_m)) there.push_back(i);
  }
  calc::Message looks;
  bool is_clear = true;
  for (const std::size_t i : there) {
    if (!looks_like(i, look)) is_clear = false;
    append(looks, direction_text(grid.normal[i]), ", ");
  }
  const auto found =
      std::find_if(there.begin(), there.end(), [&](std::size_t i) { return looks_like(i, look); });
  if (is_clear || (asked.facing && found != there.end())) return *found;
  reason = asked.facing
               ? calc::say<calc::Sentence::no_such_look>(point_text(wanted_m), direction_text(look),
                                                         looks)
               : calc::say<calc::Sentence::looks_differ>(there.size(), point_text(wanted_m), looks);
  return std::nullopt;
}

calc::Message near_text(const calc::SensorGrid& grid) {
  if (grid.columns == 0) {
    return calc::Message::number(fmt::format("{} m", kListPointToleranceMetres));
  }
  if (grid.route) return calc::say<calc::Sentence::within_route>(kSameStep_m);
  return calc::say<calc::Sentence::within_cell>(0.5 * grid.spacing_u_m, 0.5 * grid.spacing_v_m,
                                                kSamePlane_m);
}

// Returns words for a place off the plane, which three coordinates hide easily.
calc::Message off_plane_text(const calc::SensorGrid& grid, std::size_t point,
                             const glm::dvec3& wanted_m) {
  if (grid.columns == 0 || grid.route) return {};
  const double across_m = distance_across_m(grid, point, wanted_m);
  if (!(across_m > kSamePlane_m)) return {};
  return ", " + calc::say<calc::Sentence::off_plane>(across_m);
}

calc::Message undefined_text(Metric metric) {
  return metric == Metric::uniformity_min_max ? calc::say<calc::Sentence::maximum_is_zero>()
                                              : calc::say<calc::Sentence::average_is_zero>();
}

// Returns marks of selected points as marks of all points.
std::vector<std::uint8_t> spread_marks(const std::vector<std::uint8_t>& marks,
                                       const std::vector<std::size_t>& points, std::size_t all) {
  std::vector<std::uint8_t> spread(all, 0);
  for (std::size_t i = 0; i < marks.size(); ++i) spread[points[i]] = marks[i];
  return spread;
}

// Returns the place of a point of the grid among the chosen points.
std::optional<std::size_t> place_among(const std::vector<std::size_t>& chosen,
                                       std::optional<std::size_t> point) {
  if (!point) return std::nullopt;
  const auto found = std::find(chosen.begin(), chosen.end(), *point);
  if (found == chosen.end()) return std::nullopt;
  return static_cast<std::size_t>(found - chosen.begin());
}

// Replaces a point among the masked ones by the point of the grid.
void place_in_grid(const MaskedPoints& masked, std::optional<MetricEstimate>& metric) {
  if (metric && metric->point) metric->point = masked.points[*metric->point];
}

Measurement nothing_to_measure(const calc::Message& reason) {
  Measurement result;
  result.reason = reason;
  return result;
}

// Returns marks of points, repeated for all receivers of each point.
std::vector<std::uint8_t> repeated(const std::vector<std::uint8_t>& marks, std::size_t times) {
  std::vector<std::uint8_t> all;
  for (std::size_t k = 0; k < times; ++k) all.insert(all.end(), marks.begin(), marks.end());
  return all;
}

// Returns the measurement if no observer sees a glare source.
Measurement no_glare_source(std::size_t observers) {
  Measurement result;
  result.metric = MetricEstimate{{-kInfinity, -kInfinity, -kInfinity}, std::nullopt};
  result.points_used = observers;
  result.nothing_there = calc::say<calc::Sentence::no_glare_source>();
  return result;
}

struct DerivedRequest {
  const Requirement& requirement;
  std::optional<std::size_t> point;  // among the masked ones
  double confidence;
  Goal goal;
  calc::DerivedQuantity derived;
};

Measurement measure_derived(const DerivedPoints& points, const DerivedRequest& request) {
  Measurement result;
  result.points_used = points.points();
  Requirement requirement = request.requirement;
  // Ratings below 0 exist; a range without a lower end holds them.
  auto* range = std::get_if<ValueRange>(&requirement.arguments);
  if (range != nullptr && !(range->from > 0.0)) {
    range->from = -std::numeric_limits<double>::infinity();
  }
  const auto limit =
      request.goal == Goal::verdict ? std::optional<double>(requirement.limit) : std::nullopt;
  const auto found = compute_derived(points, requirement, request.point, limit, request.confidence);
  if (!found) return no_glare_source(points.points());
  result.active = found->active;
  result.unseen_points = found->unseen_points;
  result.single_sample_points = found->single_sample_points;
  const calc::Estimate& estimate = found->estimate;
  if (found->unseen_points + found->single_sample_points > 0 || !calc::is_finite(estimate)) {
    result.despite_doubt = despite_doubt(points, requirement, request.confidence);
  }
  if (std::isfinite(estimate.low) && std::isfinite(estimate.high)) {
    result.metric = MetricEstimate{estimate, found->point};
    return result;
  }
  // More samples may help, except for a low end that has no source to stand on.
  const bool is_glare = request.derived == calc::DerivedQuantity::ugr;
  if (!std::isfinite(estimate.high) && points.replicates() > 1) {
    result.unseen_points = std::max<std::size_t>(1, result.unseen_points);
  }
  if (is_glare && !std::isfinite(estimate.high)) {
    result.reason = calc::say<calc::Sentence::background_unknown>();
  } else if (is_glare) {
    result.metric = MetricEstimate{estimate, found->point};
  } else {
    result.reason = calc::say<calc::Sentence::ratio_unknown>();
  }
  return result;
}

// Returns whether the sums of the sources alone leave the limit open, for any sampled light in its
// interval.
bool is_open_by_sources(const GlarePoints& points, const DerivedRequest& request) {
  const Requirement& requirement = request.requirement;
  if (requirement.metric != Metric::maximum && !request.point) return false;
  const double t = one_sided_t(points.replicates(), 0.5 * (1.0 - request.confidence));
  double low = -kInfinity, high = -kInfinity;
  for (std::size_t i = 0; i < points.points(); ++i) {
    if (request.point && *request.point != i) continue;
    const Limits limits = points.limits(i, -t);
    low = std::max(low, limits.low);
    high = std::max(high, limits.high);
  }
  return meets(low, requirement.comparison, requirement.limit) !=
         meets(high, requirement.comparison, requirement.limit);
}

// Returns the value without each replicate. make_points: derived points of values.
template <class MakePoints>
std::vector<double> without_each_replicate(const PointValues& values, const MakePoints& make_points,
                                           const DerivedRequest& request) {
  if (request.requirement.metric == Metric::share) return {};
  return without_each_replicate(values, [&](const PointValues& of) -> std::optional<double> {
    const auto found = compute_derived(make_points(of), request.requirement, request.point,
                                       std::nullopt, request.confidence);
    if (!found) return std::nullopt;
    return found->estimate.value;
  });
}

Measurement measure_modelling(const PointValues& receivers, const MaskedPoints& masked,
                              const DerivedRequest& request) {
  const auto points_of = [&masked](const PointValues& of) {
    return ModellingPoints(of, masked.points);
  };
  const ModellingPoints points = points_of(receivers);
  if (points.dark_points() > 0) {
    return nothing_to_measure(
        calc::say<calc::Sentence::points_are_dark>(points.dark_points(), points.points()));
  }
  Measurement result = measure_derived(points, request);
  result.without_replicate = without_each_replicate(receivers, points_of, request);
  return result;
}

Measurement measure_glare(const calc::PlaneField& field, const std::vector<double>& weights,
                          const PointValues& indirect, const MaskedPoints& masked,
                          const DerivedRequest& request) {
  const auto points_of = [&](const PointValues& of) {
    return GlarePoints(of, field.glare, weights, masked.points);
  };
  const GlarePoints points = points_of(indirect);
  for (std::size_t i = 0; i < points.points(); ++i) {
    if (!points.sees_source(i) || !points.has_black_background(i)) continue;
    return nothing_to_measure(calc::say<calc::Sentence::background_black>(masked.points[i] + 1));
  }
  bool has_source = false;
  for (std::size_t i = 0; i < points.points(); ++i)
    has_source = has_source || points.sees_source(i);
  if (!has_source && points.points() > 0 && points.has_black_background(0)) {
    return nothing_to_measure(calc::say<calc::Sentence::background_black>(masked.points[0] + 1));
  }
  Measurement result = measure_derived(points, request);
  if (!points.has_inexact_sources()) {
    result.without_replicate = without_each_replicate(indirect, points_of, request);
    return result;
  }
  const GlareDoubts doubts = glare_doubts(field.glare, weights, masked.points);
  result.remark = doubts.points > 0
                      ? doubts.first
                      : calc::say<calc::Sentence::sources_inexact>(calc::kSmallestGlareSource_m2);
  if (!result.metric || request.requirement.metric == Metric::share) return result;
  const auto sampled = compute_derived(points.without_doubts(), request.requirement, request.point,
                                       std::nullopt, request.confidence);
  if (sampled) result.by_samples = sampled->estimate;
  result.is_open_for_good = is_open_by_sources(points, request);
  return result;
}

// Measures the largest ratio between neighbours among the masked points.
Measurement measure_gradient(const PointValues& values, const MaskedPoints& masked,
                             const calc::SensorGrid& grid, const DerivedRequest& request) {
  const NeighbourPairs pairs(values, grid, masked.points);
  if (pairs.points() == 0) return nothing_to_measure(calc::say<calc::Sentence::no_neighbours>());
  const bool is_lit = std::any_of(values.value_lx.begin(), values.value_lx.end(),
                                  [](double lx) { return lx > 0.0; });
  if (!is_lit) {
    Measurement dark = nothing_to_measure(calc::say<calc::Sentence::all_dark>());
    dark.unseen_points = static_cast<std::size_t>(
        std::count(values.unseen.begin(), values.unseen.end(), std::uint8_t{1}));
    return dark;
  }
  Requirement largest = request.requirement;
  largest.metric = Metric::maximum;
  const auto limit =
      request.goal == Goal::verdict ? std::optional<double>(largest.limit) : std::nullopt;
  const auto found = compute_derived(pairs, largest, std::nullopt, limit, request.confidence);
  Measurement result;
  result.points_used = values.points;
  std::vector<std::uint8_t> active(values.points, 0);
  for (std::size_t i = 0; i < pairs.points(); ++i) {
    if (found->active[i] == 0) continue;
    for (const std::size_t place : pairs.pair(i)) active[place] = 1;
  }
  result.active = spread_marks(active, masked.points, grid.position_m.size());
  result.unseen_points = found->unseen_points;
  result.single_sample_points = found->single_sample_points;
  if (found->unseen_points + found->single_sample_points > 0 || !calc::is_finite(found->estimate)) {
    result.despite_doubt = despite_doubt(pairs, request.requirement, request.confidence);
  }
  if (result.despite_doubt) {
    const std::size_t of = pairs.pair(result.despite_doubt->point.value())[0];
    result.despite_doubt->point = masked.points[of];
  }
  if (std::isfinite(found->estimate.high)) {
    const std::size_t of = pairs.pair(found->point.value())[0];
    result.metric = MetricEstimate{found->estimate, masked.points[of]};
    const auto pairs_of = [&](const PointValues& of_some) {
      return NeighbourPairs(of_some, grid, masked.points);
    };
    result.without_replicate = without_each_replicate(
        values, pairs_of,
        {largest, std::nullopt, request.confidence, request.goal, request.derived});
    return result;
  }
  result.reason = calc::say<calc::Sentence::neighbour_dark>();
  if (pairs.replicates() > 1) result.unseen_points = std::max<std::size_t>(1, result.unseen_points);
  return result;
}

// Returns why an interval exists although nothing was sampled.
calc::Message readings_words(const calc::Estimate& readings) {
  if (!(readings.low < readings.high)) return {};
  return calc::say<calc::Sentence::readings_differ>();
}

// Returns a value of the space, whatever its light.
Measurement known_of_space(const Requirement& requirement, const calc::SensorGrid& grid) {
  Measurement result;
  result.metric = MetricEstimate{requirement.of_space, std::nullopt};
  if (requirement.metric == Metric::ugr_table && calc::is_nothing(requirement.of_space)) {
    result.nothing_there = calc::say<calc::Sentence::ugr_table_nothing>();
  }
  if (is_of_road(requirement.metric)) result.remark = readings_words(requirement.of_space);
  result.is_open_for_good = true;  // no sample is in it
  result.points_used = grid.position_m.size();
  result.active.assign(grid.position_m.size() * calc::receivers_per_point(grid.derived), 0);
  return result;
}

// A value that falls with the average illuminance: the ends of the average's interval give its
// ends, the highest from the lowest average.
struct OfAverage {
  std::function<double(double)> lowest, value, highest;
};

Measurement measure_of_average(const Requirement& requirement, const calc::SensorGrid& grid,
                               const calc::PlaneField& field,
                               const std::vector<calc::LightScene>& scenes, double confidence,
                               Goal goal, const OfAverage& of_average) {
  Requirement average = requirement;
  average.metric = Metric::average;
  Measurement result = measure(average, grid, field, scenes, confidence, goal);
  result.despite_doubt.reset();  // of the average
  if (!result.metric) return result;
  const calc::Estimate lx = result.metric->estimate;
  result.metric.reset();
  if (!(lx.low > 0.0)) {
    result.reason = requirement.metric == Metric::glare_rating
                        ? calc::say<calc::Sentence::no_field_average>()
                        : calc::say<calc::Sentence::average_unknown>();
    if (lx.high > 0.0) result.unseen_points = std::max<std::size_t>(1, result.unseen_points);
    return result;
  }
  result.metric = MetricEstimate{
      {of_average.value(lx.value), of_average.lowest(lx.high), of_average.highest(lx.low)},
      std::nullopt};
  const calc::Estimate& all = result.metric->estimate;
  const calc::Estimate samples{all.value, of_average.value(lx.high), of_average.value(lx.low)};
  if (samples.low != all.low || samples.high != all.high) {
    result.by_samples = samples;
    // At every average that may be, the rest of the interval lies on both sides of the limit.
    result.is_open_for_good = of_average.lowest(lx.low) < requirement.limit &&
                              of_average.highest(lx.high) > requirement.limit;
  }
  for (double& value : result.without_replicate) value = of_average.value(value);
  return result;
}

OfAverage power_per_100_lx(const SpacePower& power) {
  const auto at = [power](double average_lx) {
    return calc::power_per_100_lx_w_m2(power.density_w_m2, average_lx);
  };
  return {at, at, at};
}

OfAverage field_glare(const LitField& field) {
  const auto at = [reflectance = field.reflectance](double veiling_cd_m2) {
    return [reflectance, veiling_cd_m2](double average_lx) {
      return calc::field_glare(veiling_cd_m2, average_lx, reflectance);
    };
  };
  const calc::Estimate& veiling = field.veiling_cd_m2;
  return {at(veiling.low), at(veiling.value), at(veiling.high)};
}

// Returns the rating without a veil, whatever the average is.
Measurement no_veil(const calc::SensorGrid& grid) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  Measurement result;
  result.metric = MetricEstimate{{kNone, kNone, kNone}, std::nullopt};
  result.nothing_there = calc::say<calc::Sentence::no_veil>();
  result.points_used = grid.position_m.size();
  result.active.assign(grid.position_m.size(), 0);
  return result;
}

// Adds the parts of a field's rating that do not come from the average.
void add_readings(const calc::Estimate& veiling, Measurement& result) {
  if (calc::is_nothing(result.metric->estimate)) result.without_replicate.clear();
  if (!(veiling.low < veiling.high)) return;
  result.remark = veiling.low > 0.0 ? readings_words(veiling)
                                    : calc::say<calc::Sentence::luminaires_may_be_hidden>();
}

}  // namespace

const std::vector<std::pair<std::string, double>>* levels_of(
    const std::string& scene, const std::vector<calc::LightScene>& scenes) {
  static const std::vector<std::pair<std::string, double>> kFullOutput;
  if (scene.empty()) return &kFullOutput;
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const calc::LightScene& s) { return s.id == scene; });
  return found == scenes.end() ? nullptr : &found->level_of_group;
}

namespace {

Measurement measure_space_and_light(const Requirement& requirement, const calc::SensorGrid& grid,
                                    const calc::PlaneField& field,
                                    const std::vector<calc::LightScene>& scenes, double confidence,
                                    Goal goal) {
  const auto of_average = [&](const OfAverage& with) {
    return measure_of_average(requirement, grid, field, scenes, confidence, goal, with);
  };
  if (const auto* power = std::get_if<SpacePower>(&requirement.arguments)) {
    return of_average(power_per_100_lx(*power));
  }
  const auto& lit = std::get<LitField>(requirement.arguments);
  const bool is_all_there = requirement.origin.pack.empty() || !(grid.missed_m2 > 0.0);
  if (is_all_there && lit.veiling_cd_m2.high == 0.0) return no_veil(grid);
  Measurement result = of_average(field_glare(lit));
  if (result.metric) add_readings(lit.veiling_cd_m2, result);
  return result;
}

// Of the masked points, and of their values: `active` is of one receiver per point.
using MeasureOfValues = Measurement (*)(const PointValues& values, const MaskedPoints& masked,
                                        const calc::SensorGrid& grid,
                                        const DerivedRequest& request);

Measurement measure_share(const PointValues& values, const MaskedPoints& masked,
                          const calc::SensorGrid& grid, const DerivedRequest& request) {
  const ShareEstimate share = compute_share(
      values, std::get<ValueRange>(request.requirement.arguments), request.confidence);
  Measurement result;
  result.points_used = values.points;
  result.metric = MetricEstimate{share.estimate, std::nullopt};
  result.active = spread_marks(share.open, masked.points, grid.position_m.size());
  return result;
}

Measurement measure_statistic(const PointValues& values, const MaskedPoints& masked,
                              const calc::SensorGrid& grid, const DerivedRequest& request) {
  const auto& [requirement, point, confidence, goal, derived] = request;
  const Metric metric = requirement.metric;
  const double percent = argument_of<Percentile>(requirement).percent;
  const bool is_uniformity =
      metric == Metric::uniformity_min_avg || metric == Metric::uniformity_min_max;
  if (is_uniformity && values.points == 1) {
    return nothing_to_measure(calc::say<calc::Sentence::one_point>());
  }
  Measurement result;
  result.points_used = values.points;
  result.metric = compute_metric(values, metric, percent, point, confidence);
  if (!result.metric) {
    result.reason = undefined_text(metric);
    result.unseen_points = static_cast<std::size_t>(
        std::count(values.unseen.begin(), values.unseen.end(), std::uint8_t{1}));
    return result;
  }
  result.without_replicate = without_each_replicate(values, metric, percent, point);
  const auto limit =
      goal == Goal::verdict ? std::optional<double>(requirement.limit) : std::nullopt;
  Candidates candidates =
      find_candidates(values, metric, percent, point, result.metric->estimate, limit, confidence);
  const DoubtfulPoints doubtful = count_doubtful(values, metric, candidates.matters);
  result.unseen_points = doubtful.unseen;
  result.single_sample_points = doubtful.single_sample;
  result.largest_share = doubtful.largest_share;
  if (doubtful.unseen + doubtful.single_sample > 0) {
    result.despite_doubt = despite_doubt(values, requirement, confidence);
  }
  result.active = spread_marks(candidates.active, masked.points, grid.position_m.size());
  place_in_grid(masked, result.metric);
  place_in_grid(masked, result.despite_doubt);
  return result;
}

Measurement measure_points(const Requirement& requirement, const calc::SensorGrid& grid,
                           const calc::PlaneField& field,
                           const std::vector<calc::LightScene>& scenes, double confidence,
                           Goal goal, MeasureOfValues measure_values) {
  if (requirement.any_one_unit_out) {
    return measure_any_one_out(requirement, grid, field, scenes, confidence, goal);
  }
  // What a rule requires of an area it requires of all of it.
  if (!requirement.origin.pack.empty() && grid.missed_m2 > 0.0) {
    return nothing_to_measure(calc::say<calc::Sentence::area_missed>(grid.missed_m2));
  }
  const auto* levels = levels_of(requirement.scene, scenes);
  if (levels == nullptr) {
    return nothing_to_measure(calc::say<calc::Sentence::no_scene>(requirement.scene));
  }
  std::optional<std::size_t> point;
  if (requirement.metric == Metric::value_at_point) {
    const auto& asked = std::get<PointOfValue>(requirement.arguments);
    const glm::dvec3 wanted_m = asked.point_m.value();
    point = point_at(grid, wanted_m);
    const glm::dvec3& nearest_m = grid.position_m[*point];
    if (!is_near(grid, *point, wanted_m)) {
      return nothing_to_measure(calc::say<calc::Sentence::no_point_near>(
          near_text(grid), point_text(wanted_m),
          point_text(nearest_m) + off_plane_text(grid, *point, wanted_m)));
    }
    calc::Message reason;
    point = point_facing(grid, *point, asked, reason);
    if (!point) return nothing_to_measure(reason);
  }
  const MaskedPoints masked = apply_mask(requirement.mask, grid);
  if (!masked.problem.empty()) return nothing_to_measure(masked.problem);
  if (point) {
    point = place_among(masked.points, point);
    if (!point) return nothing_to_measure(calc::say<calc::Sentence::masked_out>());
  }
  PointValues receivers =
      combine_channels(field, requirement.state, *levels,
                       requirement.direct_only ? LightParts::direct : LightParts::all);
  if (!is_metric_of(requirement.metric, grid.derived)) {
    return nothing_to_measure(calc::say<calc::Sentence::no_statistic>());
  }
  const DerivedRequest request{requirement, point, confidence, goal, grid.derived};
  Measurement result;
  if (calc::is_plain_number(grid.derived)) {
    result = grid.derived == calc::DerivedQuantity::ugr
                 ? measure_glare(field, channel_weights(field, requirement.state, *levels),
                                 receivers, masked, request)
                 : measure_modelling(receivers, masked, request);
    place_in_grid(masked, result.metric);
    place_in_grid(masked, result.despite_doubt);
    if (!result.active.empty()) {
      result.active = spread_marks(result.active, masked.points, grid.position_m.size());
    }
  } else {
    if (grid.derived == calc::DerivedQuantity::four_planes) {
      receivers = mean_of_four_planes(receivers);
    }
    result = measure_values(select_points(receivers, masked.points), masked, grid, request);
  }
  result.active = repeated(result.active, calc::receivers_per_point(grid.derived));
  return result;
}

Measurement measure_as_sampled(const Requirement& requirement, const calc::SensorGrid& grid,
                               const calc::PlaneField& field,
                               const std::vector<calc::LightScene>& scenes, double confidence,
                               Goal goal) {
  if (!requirement.problem.empty()) return nothing_to_measure(requirement.problem);
  const auto of_points = [&](MeasureOfValues measure_values) {
    return measure_points(requirement, grid, field, scenes, confidence, goal, measure_values);
  };
  switch (metric_row(requirement.metric).source) {
    case MetricSource::values:
      return of_points(measure_statistic);
    case MetricSource::counted_values:
      return of_points(measure_share);
    case MetricSource::neighbours:
      if (!requirement.any_one_unit_out) return of_points(measure_gradient);
      return nothing_to_measure(calc::say<calc::Sentence::neighbours_in_outage>());
    case MetricSource::space:
    case MetricSource::space_in_scene:
    case MetricSource::road:
    case MetricSource::luminaires:
      return known_of_space(requirement, grid);
    case MetricSource::space_and_light:
      break;
  }
  return measure_space_and_light(requirement, grid, field, scenes, confidence, goal);
}

}  // namespace

Measurement measure(const Requirement& requirement, const calc::SensorGrid& grid,
                    const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                    double confidence, Goal goal) {
  Measurement result = measure_as_sampled(requirement, grid, field, scenes, confidence, goal);
  result.is_cut_off =
      field.is_cut_off && !requirement.direct_only && !is_of_space(requirement.metric);
  if (result.is_cut_off) result.despite_doubt.reset();  // it could prove too little light
  result.has_missing_light =
      !requirement.missing_light.empty() || !requirement.unsure_light.empty();
  return result;
}

}  // namespace rules
