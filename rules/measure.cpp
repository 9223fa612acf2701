#include "rules/measure.h"

#include "rules/candidates.h"
#include "rules/mask.h"
#include "rules/share.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rules {
namespace {

constexpr double kListPointToleranceMetres =
    1e-3;  // point lists have no cells: the point itself must be named

std::string point_text(const glm::dvec3& p) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f}) m", p.x, p.y, p.z);
}

std::size_t nearest_point(const calc::SensorGrid& grid, const glm::dvec3& wanted_m) {
  const auto distance = [&](const glm::dvec3& p) { return glm::length(p - wanted_m); };
  const auto nearest = std::min_element(
      grid.position_m.begin(), grid.position_m.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - grid.position_m.begin());
}

// Within half a cell along the plane's axes and, across the plane, half of the cell's shorter side.
bool is_near(const calc::SensorGrid& grid, const glm::dvec3& offset_m) {
  if (grid.columns == 0) return glm::length(offset_m) <= kListPointToleranceMetres;
  constexpr double kBinaryNoise_m = 1e-9;  // a place midway between two points is near both
  const double half_u = 0.5 * grid.spacing_u_m + kBinaryNoise_m;
  const double half_v = 0.5 * grid.spacing_v_m + kBinaryNoise_m;
  return std::abs(glm::dot(offset_m, grid.u)) <= half_u &&
         std::abs(glm::dot(offset_m, grid.v)) <= half_v &&
         std::abs(glm::dot(offset_m, glm::cross(grid.u, grid.v))) <= std::min(half_u, half_v);
}

std::string near_text(const calc::SensorGrid& grid) {
  if (grid.columns == 0) return fmt::format("{} m", kListPointToleranceMetres);
  return fmt::format("half a cell ({:.3f} x {:.3f} m)", 0.5 * grid.spacing_u_m,
                     0.5 * grid.spacing_v_m);
}

const std::vector<std::pair<std::string, double>>* levels_of(
    const std::string& scene, const std::vector<calc::LightScene>& scenes) {
  static const std::vector<std::pair<std::string, double>> kFullOutput;
  if (scene.empty()) return &kFullOutput;
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const calc::LightScene& s) { return s.id == scene; });
  return found == scenes.end() ? nullptr : &found->level_of_group;
}

std::string undefined_text(Metric metric) {
  return fmt::format("{} is 0 lx: uniformity is undefined",
                     metric == Metric::uniformity_min_max ? "maximum" : "average");
}

// Marks of selected points as marks of all.
std::vector<std::uint8_t> spread_marks(const std::vector<std::uint8_t>& marks,
                                       const std::vector<std::size_t>& points, std::size_t all) {
  std::vector<std::uint8_t> spread(all, 0);
  for (std::size_t i = 0; i < marks.size(); ++i) spread[points[i]] = marks[i];
  return spread;
}

Measurement nothing_to_measure(const std::string& reason) {
  Measurement result;
  result.reason = reason;
  return result;
}

}  // namespace

Measurement measure(const Requirement& requirement, const calc::SensorGrid& grid,
                    const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                    double confidence, Goal goal) {
  if (!requirement.problem.empty()) return nothing_to_measure(requirement.problem);
  const auto* levels = levels_of(requirement.scene, scenes);
  if (levels == nullptr) {
    return nothing_to_measure(fmt::format("there is no scene '{}'", requirement.scene));
  }
  std::optional<std::size_t> point;
  if (requirement.metric == Metric::value_at_point) {
    const glm::dvec3 wanted_m = requirement.point_m.value();
    point = nearest_point(grid, wanted_m);
    const glm::dvec3& nearest_m = grid.position_m[*point];
    if (!is_near(grid, nearest_m - wanted_m)) {
      return nothing_to_measure(
          fmt::format("no calculation point within {} of {}; nearest is at {}", near_text(grid),
                      point_text(wanted_m), point_text(nearest_m)));
    }
  }
  const MaskedPoints masked = apply_mask(requirement.mask, grid);
  if (!masked.problem.empty()) return nothing_to_measure(masked.problem);
  const PointValues values = select_points(
      combine_channels(field, requirement.state, *levels,
                       requirement.direct_only ? LightParts::direct : LightParts::all),
      masked.points);
  Measurement result;
  result.points_used = values.points;
  const Metric metric = requirement.metric;
  if (metric == Metric::share) {
    const ShareEstimate share = compute_share(values, requirement.range, confidence);
    result.metric = MetricEstimate{share.estimate, std::nullopt};
    result.active = spread_marks(share.open, masked.points, grid.position_m.size());
    return result;
  }
  result.metric = compute_metric(values, metric, requirement.percent, point, confidence);
  if (!result.metric) {
    result.reason = undefined_text(metric);
    result.unseen_points = static_cast<std::size_t>(
        std::count(values.unseen.begin(), values.unseen.end(), std::uint8_t{1}));
    return result;
  }
  const auto limit =
      goal == Goal::verdict ? std::optional<double>(requirement.limit) : std::nullopt;
  Candidates candidates = find_candidates(values, metric, requirement.percent, point,
                                          result.metric->estimate, limit, confidence);
  const DoubtfulPoints doubtful = count_doubtful(values, metric, candidates.matters);
  result.unseen_points = doubtful.unseen;
  result.single_sample_points = doubtful.single_sample;
  result.active = spread_marks(candidates.active, masked.points, grid.position_m.size());
  if (result.metric->point) result.metric->point = masked.points[*result.metric->point];
  return result;
}

}  // namespace rules
