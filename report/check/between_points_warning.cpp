#include "report/check/between_points_warning.h"

#include "rules/catalogue/mask.h"
#include "rules/catalogue/requirement.h"
#include "rules/measure/measure.h"
#include "rules/measure/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace check {
namespace {

// Of even light what two places and a point differ by is 1 or 2 %; of wall washers on the grids of
// EN 12464-1 up to 7 %.
constexpr double kOfAverage = 0.05, kOfPlace = 0.20, kOfOthers = 0.10;

// [point], 1: the requirement's mask leaves it.
std::vector<std::uint8_t> asked_points(const rules::Requirement& requirement,
                                       const calc::SensorGrid& grid) {
  std::vector<std::uint8_t> is_asked(grid.position_m.size(), 0);
  for (const std::size_t point : rules::apply_mask(requirement.mask, grid).points)
    is_asked[point] = 1;
  return is_asked;
}

struct PointLight {
  double direct_lx = 0.0, all_lx = 0.0;
};

// direct_only: all of it is direct light.
PointLight light_at(const calc::PlaneField& field, std::size_t point,
                    const std::vector<double>& weights, bool direct_only) {
  PointLight light;
  const auto replicates = static_cast<double>(std::max<std::size_t>(field.replicates, 1));
  for (std::size_t c = 0; c < weights.size(); ++c) {
    double direct_lx = field.direct_exact_at(c, point), reflected_lx = 0.0;
    for (std::size_t r = 0; r < field.replicates; ++r) {
      direct_lx += field.direct_sampled_at(r, c, point) / replicates;
      reflected_lx += field.indirect_at(r, c, point) / replicates;
    }
    light.direct_lx += weights[c] * direct_lx;
    light.all_lx += weights[c] * (direct_only ? direct_lx : direct_lx + reflected_lx);
  }
  return light;
}

// A cell, or the mean of several: at its point, and with what it has between.
struct CellLight {
  std::size_t point = 0;
  double at_lx = 0.0, between_lx = 0.0, all_lx = 0.0;

  double without_flattery_lx() const { return all_lx - at_lx + between_lx; }
  double too_much() const { return (at_lx - between_lx) / all_lx; }
};

struct Light {
  CellLight mean;                // over the sample
  CellLight darkest, brightest;  // at their points
  CellLight lowest, highest;     // without flattery
};

class LightOfCells {
 public:
  LightOfCells(const PlaneJob& job, const calc::PlaneField& field,
               const calc::LightBetweenPoints& between, const std::vector<calc::LightScene>& scenes)
      : job_(job), field_(field), between_(between), scenes_(scenes) {}

  std::optional<Light> of(const rules::Requirement& requirement) const {
    const auto* levels = rules::levels_of(requirement.scene, scenes_);
    if (levels == nullptr) return std::nullopt;
    const std::vector<double> weights = rules::channel_weights(field_, requirement.state, *levels);
    const std::vector<std::uint8_t> is_asked = asked_points(requirement, *job_.grid);
    Light light;
    double samples = 0.0;
    bool is_first = true;
    for (const calc::LightBetweenPoints::Cell& cell : between_.cells) {
      if (is_asked[cell.point] == 0) continue;
      const CellLight one = cell_light(cell, weights, requirement.direct_only);
      if (cell.is_sample) {
        samples += 1.0;
        light.mean.at_lx += one.at_lx;
        light.mean.between_lx += one.between_lx;
        light.mean.all_lx += one.all_lx;
      }
      if (is_first || one.all_lx < light.darkest.all_lx) light.darkest = one;
      if (is_first || one.all_lx > light.brightest.all_lx) light.brightest = one;
      const double without_lx = one.without_flattery_lx();
      if (is_first || without_lx < light.lowest.without_flattery_lx()) light.lowest = one;
      if (is_first || without_lx > light.highest.without_flattery_lx()) light.highest = one;
      is_first = false;
    }
    if (samples == 0.0 && !is_covered()) return std::nullopt;
    if (samples > 0.0) {
      light.mean.at_lx /= samples;
      light.mean.between_lx /= samples;
      light.mean.all_lx /= samples;
    }
    if (is_covered()) light = covered(weights, requirement.direct_only);
    return light;
  }

  // Nothing is known between most points.
  bool is_covered() const {
    const auto samples =
        static_cast<std::size_t>(std::count_if(between_.cells.begin(), between_.cells.end(),
                                               [](const auto& cell) { return cell.is_sample; }));
    return between_.not_measured > samples;
  }

 private:
  CellLight cell_light(const calc::LightBetweenPoints::Cell& cell,
                       const std::vector<double>& weights, bool direct_only) const {
    const PointLight at = light_at(field_, cell.point, weights, direct_only);
    CellLight light{cell.point, at.direct_lx, 0.0, at.all_lx};
    for (std::size_t c = 0; c < weights.size(); ++c)
      light.between_lx += weights[c] * cell.direct_lx[c];
    return light;
  }

  // As if all were dark between the points.
  Light covered(const std::vector<double>& weights, bool direct_only) const {
    Light light;
    const std::size_t points = job_.grid->position_m.size();
    for (std::size_t i = 0; i < points; ++i) {
      const PointLight at = light_at(field_, i, weights, direct_only);
      light.mean.at_lx += at.direct_lx / static_cast<double>(points);
      light.mean.all_lx += at.all_lx / static_cast<double>(points);
    }
    light.darkest = light.lowest = light.mean;
    return light;
  }

  const PlaneJob& job_;
  const calc::PlaneField& field_;
  const calc::LightBetweenPoints& between_;
  const std::vector<calc::LightScene>& scenes_;
};

struct Doubt {
  CellLight light;
  bool is_of_place = false;
};

std::optional<Doubt> doubt_of_mean(const rules::Requirement& requirement, const Light& light,
                                   double least_share) {
  const bool is_lower = rules::is_lower_limit(requirement.comparison);
  const double share = is_lower ? light.mean.too_much() : -light.mean.too_much();
  if (!(share > least_share)) return std::nullopt;
  if (requirement.metric == rules::Metric::average) {
    const double without_lx = light.mean.without_flattery_lx();
    const bool is_met =
        is_lower ? without_lx >= requirement.limit : without_lx <= requirement.limit;
    if (is_met) return std::nullopt;
  }
  return Doubt{light.mean};
}

std::optional<Doubt> doubt_of(const rules::Requirement& requirement, const Light& light,
                              bool is_covered) {
  using enum rules::Metric;
  const bool is_lower = rules::is_lower_limit(requirement.comparison);
  if (requirement.metric == average) return doubt_of_mean(requirement, light, kOfAverage);
  const double kept = 1.0 - kOfPlace;
  const double lowest_lx = light.lowest.without_flattery_lx();
  if (is_lower && requirement.metric == minimum) {
    const bool is_flattered = lowest_lx < kept * light.darkest.all_lx;
    if (!is_flattered || lowest_lx >= requirement.limit) return std::nullopt;
    return Doubt{light.lowest, !is_covered};
  }
  const bool is_uo = requirement.metric == uniformity_min_avg;
  if (is_lower && (is_uo || requirement.metric == uniformity_min_max)) {
    // The darkest place alone: that points miss bright ones is no flattery of an average.
    const double whole_lx = is_uo ? light.mean.all_lx : light.brightest.all_lx;
    const bool is_flattered = lowest_lx < kept * light.darkest.all_lx;
    if (!is_flattered || !(lowest_lx < requirement.limit * whole_lx)) return std::nullopt;
    return Doubt{light.lowest, !is_covered};
  }
  if (!is_lower && requirement.metric == maximum) {
    const double highest_lx = light.highest.without_flattery_lx();
    const bool is_flattered = highest_lx * kept > light.brightest.all_lx;
    if (!is_flattered || highest_lx <= requirement.limit) return std::nullopt;
    return Doubt{light.highest, true};
  }
  return doubt_of_mean(requirement, light, kOfOthers);
}

}  // namespace

bool counts(const rules::Requirement& requirement) {
  return requirement.problem.empty() && requirement.severity != rules::Severity::advice &&
         !rules::is_of_space(requirement.metric);
}

bool is_asked_of_points(const PlaneJob& job) {
  return job.grid && job.grid->columns > 0 && job.grid->derived == calc::DerivedQuantity::none &&
         std::any_of(job.requirements.begin(), job.requirements.end(), counts);
}

std::vector<std::size_t> telling_points(const PlaneJob& job, const calc::PlaneField& field,
                                        const std::vector<calc::LightScene>& scenes) {
  constexpr std::size_t kLowest = 16, kHighest = 4;
  std::vector<std::size_t> telling;
  for (const rules::Requirement& requirement : job.requirements) {
    if (!counts(requirement)) continue;
    const auto* levels = rules::levels_of(requirement.scene, scenes);
    if (levels == nullptr) continue;
    const std::vector<double> weights = rules::channel_weights(field, requirement.state, *levels);
    std::vector<std::pair<double, std::size_t>> points;
    const std::vector<std::uint8_t> is_asked = asked_points(requirement, *job.grid);
    for (std::size_t i = 0; i < job.grid->position_m.size(); ++i) {
      if (is_asked[i] != 0)
        points.emplace_back(light_at(field, i, weights, requirement.direct_only).all_lx, i);
    }
    std::sort(points.begin(), points.end());
    for (std::size_t k = 0; k < std::min(kLowest, points.size()); ++k)
      telling.push_back(points[k].second);
    for (std::size_t k = 0; k < std::min(kHighest, points.size()); ++k)
      telling.push_back(points[points.size() - 1 - k].second);
  }
  std::sort(telling.begin(), telling.end());
  telling.erase(std::unique(telling.begin(), telling.end()), telling.end());
  return telling;
}

std::optional<FlatteringPoints> flattering_points(const PlaneJob& job,
                                                  const calc::PlaneField& field,
                                                  const calc::LightBetweenPoints& between,
                                                  const std::vector<calc::LightScene>& scenes) {
  const LightOfCells cells(job, field, between, scenes);
  for (const rules::Requirement& requirement : job.requirements) {
    if (!counts(requirement)) continue;
    const std::optional<Light> light = cells.of(requirement);
    if (!light) continue;
    const std::optional<Doubt> doubt = doubt_of(requirement, *light, cells.is_covered());
    if (!doubt) continue;
    FlatteringPoints flattering{
        doubt->light.at_lx, doubt->light.between_lx, doubt->light.all_lx, {}};
    if (doubt->is_of_place) {
      const glm::dvec3& at = job.grid->position_m[doubt->light.point];
      flattering.where += fmt::format(" at ({:.4g}, {:.4g}, {:.4g}) m", at.x, at.y, at.z);
    }
    if (cells.is_covered()) flattering.where += ", where surfaces are and nothing can be measured,";
    if (!requirement.scene.empty())
      flattering.where += fmt::format(" in scene '{}'", requirement.scene);
    return flattering;
  }
  return std::nullopt;
}

}  // namespace check
