#include "rules/measure/level_conditions.h"

#include "calc/base/sentences.h"
#include "rules/catalogue/mask.h"
#include "rules/measure/derived_points.h"
#include "rules/measure/error_spending.h"
#include "rules/measure/metrics.h"
#include "rules/measure/replicate_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

namespace rules {
namespace {

using calc::say;
using calc::Sentence;

// Room beyond every limit, as a share of the largest coefficient: it also meets "more than", and
// covers the solver's rounding. Far below the differences between lamps.
constexpr double kRoom = 1e-6;

double scale_of(const LevelCondition& condition) {
  double scale = 0.0;
  for (const double c : condition.coefficient) scale = std::max(scale, std::abs(c));
  return scale;
}

// Returns the condition with room. most: limits the room where only darkness meets an upper limit.
LevelCondition with_room(LevelCondition condition,
                         double most = std::numeric_limits<double>::infinity()) {
  condition.at_least += std::min(kRoom * scale_of(condition), most);
  return condition;
}

// Returns the values of the chosen points from one group alone, at its full output.
PointValues light_of(const Requirement& requirement, const calc::SensorGrid& grid,
                     const calc::PlaneField& field,
                     const std::vector<std::pair<std::string, double>>& levels,
                     const std::vector<std::size_t>& points) {
  PointValues values =
      combine_channels(field, requirement.state, levels,
                       requirement.direct_only ? LightParts::direct : LightParts::all);
  if (grid.derived == calc::DerivedQuantity::four_planes) values = mean_of_four_planes(values);
  return select_points(values, points);
}

// Returns why the requirement gives no linear conditions; then only the verdict at other levels
// tells.
calc::Message why_not(const Requirement& requirement, const calc::SensorGrid& grid) {
  if (!requirement.problem.empty()) return requirement.problem;
  if (calc::is_plain_number(grid.derived)) return say<Sentence::condition_is_rating>();
  if (requirement.any_one_unit_out) return say<Sentence::condition_with_one_out>();
  const bool is_lower = is_lower_limit(requirement.comparison);
  switch (requirement.metric) {
    case Metric::average:
    case Metric::value_at_point:
      return {};
    case Metric::minimum:
    case Metric::uniformity_min_avg:
    case Metric::uniformity_min_max:
      return is_lower ? calc::Message() : say<Sentence::condition_on_least>();
    case Metric::maximum:
      return is_lower ? say<Sentence::condition_on_greatest>() : calc::Message();
    default:
      return say<Sentence::condition_no_sum>();
  }
}

}  // namespace

double LevelCondition::lack(const std::vector<double>& level) const {
  double sum = 0.0;
  for (std::size_t g = 0; g < coefficient.size(); ++g) sum += coefficient[g] * level[g];
  return at_least - sum;
}

LevelConditions::LevelConditions(const Requirement& requirement, const calc::SensorGrid& grid,
                                 const calc::PlaneField& field,
                                 const std::vector<std::string>& groups, double confidence)
    : is_upper_(!is_lower_limit(requirement.comparison)),
      limit_(requirement.limit),
      groups_(groups.size()),
      problem_(why_not(requirement, grid)) {
  if (!problem_.empty()) return;
  const MaskedPoints masked = apply_mask(requirement.mask, grid);
  problem_ = masked.problem;
  if (!problem_.empty()) return;
  if (masked.points.empty()) {
    problem_ = say<Sentence::condition_no_point>();
    return;
  }
  std::vector<std::size_t> points = masked.points;
  if (requirement.metric == Metric::value_at_point) {
    // The nearest, as judging takes it; where that refuses, nothing passes.
    const glm::dvec3 wanted_m = std::get<PointOfValue>(requirement.arguments).point_m.value();
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](std::size_t a, std::size_t b) {
          return glm::length(grid.position_m[a] - wanted_m) <
                 glm::length(grid.position_m[b] - wanted_m);
        });
    points = {*nearest};
  }
  const double level = look_confidence(confidence, field);
  // One level for each group alone, the last for what no level changes.
  std::vector<PointValues> of_group;
  for (std::size_t g = 0; g <= groups.size(); ++g) {
    std::vector<std::pair<std::string, double>> levels;
    for (std::size_t other = 0; other < groups.size(); ++other) {
      levels.emplace_back(groups[other], other == g ? 1.0 : 0.0);
    }
    if (g < groups.size()) {
      for (const calc::LightChannel& channel : field.channels) {
        if (std::find(groups.begin(), groups.end(), channel.group) == groups.end()) {
          levels.emplace_back(channel.group, 0.0);
        }
      }
    }
    of_group.push_back(light_of(requirement, grid, field, levels, points));
  }
  const auto add = [&](std::size_t g, Light& light, const Limits& limits, const Limits& sure) {
    for (std::vector<double>* lx : {&light.lx, &light.below_lx, &light.above_lx,
                                    &light.sure_below_lx, &light.sure_above_lx}) {
      lx->resize(groups_ + 1);
    }
    light.lx[g] = limits.value;
    light.below_lx[g] = limits.value - limits.low;
    light.above_lx[g] = limits.high - limits.value;
    light.sure_below_lx[g] = sure.value - sure.low;
    light.sure_above_lx[g] = sure.high - sure.value;
  };
  switch (requirement.metric) {
    case Metric::average:
      kind_ = Kind::average;
      break;
    case Metric::uniformity_min_avg:
      kind_ = Kind::of_average;
      break;
    case Metric::uniformity_min_max:
      kind_ = Kind::of_maximum;
      break;
    default:
      kind_ = Kind::each_point;
  }
  light_.resize(kind_ == Kind::average ? 1 : points.size());
  if (kind_ != Kind::average) point_ = points;
  if (kind_ == Kind::of_average) average_lx_.resize(groups_ + 1);
  for (std::size_t g = 0; g < of_group.size(); ++g) {
    PointValues& values = of_group[g];
    const double t = one_sided_t(values.replicates, 0.5 * (1.0 - level));
    const auto together = static_cast<double>(light_.size() * of_group.size());
    const double sure_t = one_sided_t(values.replicates, 0.5 * (1.0 - level) / together);
    if (kind_ == Kind::of_average) {
      // Point less its share of the average, replicate by replicate: what both have in common
      // does not count twice.
      const ReplicateSample own = summarize(values, 0, values.replicates);
      average_lx_[g] = plane_limits(own, t).value;
      for (std::size_t i = 0; i < values.points; ++i) {
        light_[i].own_lx.resize(groups_ + 1);
        light_[i].own_lx[g] = point_limits(own, i, t).value;
      }
      const std::vector<double> means = plane_means(values);
      for (std::size_t r = 0; r < values.replicates; ++r) {
        for (std::size_t i = 0; i < values.points; ++i) {
          values.value_lx[r * values.points + i] -= limit_ * means[r];
        }
      }
    }
    const ReplicateSample sample = summarize(values, 0, values.replicates);
    if (kind_ == Kind::average) {
      add(g, light_[0], plane_limits(sample, t), plane_limits(sample, sure_t));
      continue;
    }
    for (std::size_t i = 0; i < values.points; ++i) {
      add(g, light_[i], point_limits(sample, i, t), point_limits(sample, i, sure_t));
    }
  }
  if (kind_ == Kind::of_average) limit_ = 0.0;
}

double LevelConditions::Light::lower_lx(std::size_t g, double half_widths) const {
  return lx[g] - half_widths * (half_widths < 0.0 ? sure_above_lx[g] : below_lx[g]);
}

double LevelConditions::Light::upper_lx(std::size_t g, double half_widths) const {
  return lx[g] + half_widths * (half_widths < 0.0 ? sure_below_lx[g] : above_lx[g]);
}

std::vector<double> LevelConditions::light_lx(const LevelCondition& condition,
                                              const std::vector<double>& level) const {
  std::size_t index = 0;
  if (kind_ != Kind::average) {
    index = static_cast<std::size_t>(std::find(point_.begin(), point_.end(), condition.point) -
                                     point_.begin());
  }
  const Light& light = light_.at(index);
  std::vector<double> lx = light.own_lx.empty() ? light.lx : light.own_lx;
  for (std::size_t g = 0; g < groups_; ++g) lx[g] *= level[g];
  return lx;
}

double LevelConditions::lx_per_limit(const std::vector<double>& level) const {
  const auto sum_of = [&](const std::vector<double>& lx) {
    double sum = lx[groups_];
    for (std::size_t g = 0; g < groups_; ++g) sum += level[g] * lx[g];
    return sum;
  };
  switch (kind_) {
    case Kind::of_average:
      return sum_of(average_lx_);
    case Kind::of_maximum: {
      double greatest = 0.0;
      for (const Light& light : light_) greatest = std::max(greatest, sum_of(light.lx));
      return greatest;
    }
    default:
      return is_upper_ ? -1.0 : 1.0;
  }
}

LevelCondition LevelConditions::condition(const Light& light, double safety) const {
  LevelCondition result;
  const auto coefficient = [&](std::size_t g) {
    return is_upper_ ? -light.upper_lx(g, safety) : light.lower_lx(g, safety);
  };
  for (std::size_t g = 0; g < groups_; ++g) result.coefficient.push_back(coefficient(g));
  result.at_least = (is_upper_ ? -limit_ : limit_) - coefficient(groups_);
  return is_upper_ ? with_room(std::move(result), 0.5 * std::abs(limit_))
                   : with_room(std::move(result));
}

// Returns the condition that the least point has the required share of the greatest.
LevelCondition LevelConditions::pair_condition(std::size_t least, std::size_t greatest,
                                               double safety) const {
  LevelCondition result;
  const auto coefficient = [&](std::size_t g) {
    return light_[least].lower_lx(g, safety) - limit_ * light_[greatest].upper_lx(g, safety);
  };
  for (std::size_t g = 0; g < groups_; ++g) result.coefficient.push_back(coefficient(g));
  result.at_least = -coefficient(groups_);
  result.point = point_[least];
  return with_room(std::move(result));
}

std::vector<LevelCondition> LevelConditions::all(const std::vector<double>& level,
                                                 double safety) const {
  std::vector<LevelCondition> conditions;
  if (kind_ != Kind::of_maximum) {
    for (std::size_t i = 0; i < light_.size(); ++i) {
      conditions.push_back(condition(light_[i], safety));
      if (kind_ != Kind::average) conditions.back().point = point_[i];
    }
    return conditions;
  }
  // Whichever points may be the greatest: the pairs that matter are those with the one that is.
  const auto upper_lx = [&](const Light& light) {
    double sum = light.upper_lx(groups_, safety);
    for (std::size_t g = 0; g < groups_; ++g) sum += level[g] * light.upper_lx(g, safety);
    return sum;
  };
  std::size_t greatest = 0;
  for (std::size_t i = 1; i < light_.size(); ++i) {
    if (upper_lx(light_[i]) > upper_lx(light_[greatest])) greatest = i;
  }
  for (std::size_t i = 0; i < light_.size(); ++i) {
    if (i != greatest) conditions.push_back(pair_condition(i, greatest, safety));
  }
  return conditions;
}

std::vector<LevelCondition> LevelConditions::broken(const std::vector<double>& level, double safety,
                                                    std::size_t most) const {
  std::vector<std::pair<double, std::size_t>> lacks;
  std::vector<LevelCondition> conditions = all(level, safety);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const LevelCondition& one = conditions[i];
    // Half of the room is for the solver's rounding.
    const double lack = one.lack(level);
    if (lack > 0.5 * kRoom * scale_of(one)) lacks.emplace_back(-lack, i);
  }
  std::sort(lacks.begin(), lacks.end());
  std::vector<LevelCondition> worst;
  for (std::size_t i = 0; i < std::min(most, lacks.size()); ++i) {
    worst.push_back(std::move(conditions[lacks[i].second]));
  }
  return worst;
}

}  // namespace rules
