#include "rules/measure/outage.h"

#include "calc/base/sentences.h"
#include "calc/scene/scene_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace rules {
namespace {

// Returns the groups of the field's light that the scene lights.
std::vector<std::string> lit_groups(const calc::PlaneField& field, const calc::LightScene& scene) {
  std::set<std::string> groups;
  for (const calc::LightChannel& channel : field.channels) {
    if (calc::level_in_scene(&scene, channel.group) > 0.0) groups.insert(channel.group);
  }
  return {groups.begin(), groups.end()};
}

calc::LightScene without(calc::LightScene scene, const std::string& group) {
  std::erase_if(scene.level_of_group, [&](const auto& item) { return item.first == group; });
  scene.level_of_group.emplace_back(group, 0.0);
  return scene;
}

// Returns the worse of two estimates, end by end, because each end holds for its own result.
MetricEstimate worse_of(const MetricEstimate& one, const MetricEstimate& next,
                        bool is_lower_worse) {
  const calc::Estimate &a = one.estimate, &b = next.estimate;
  const auto worse = [&](double x, double y) {
    return is_lower_worse ? std::min(x, y) : std::max(x, y);
  };
  return {{worse(a.value, b.value), worse(a.low, b.low), worse(a.high, b.high)},
          worse(a.value, b.value) != a.value ? next.point : one.point};
}

// Returns what a result proves whatever the values of its doubtful points.
std::optional<MetricEstimate> known_of(const Measurement& result) {
  return result.has_doubtful_points() ? result.despite_doubt : result.metric;
}

// Returns the worse proof of both results: one that is surely bad is enough, whatever the other is.
std::optional<MetricEstimate> worse_known(const Measurement& a, const Measurement& b,
                                          bool is_lower_worse) {
  const std::optional<MetricEstimate> of_a = known_of(a), of_b = known_of(b);
  std::optional<MetricEstimate> worst =
      of_a && of_b ? worse_of(*of_a, *of_b, is_lower_worse) : (of_a ? of_a : of_b);
  if (!worst) return std::nullopt;
  calc::Estimate& estimate = worst->estimate;
  if (is_lower_worse) {
    estimate.low = std::min(estimate.low, 0.0);
  } else {
    estimate.high = kInfinity;
  }
  return worst;
}

// Keeps the lower of two results, or for an upper limit the higher.
void take_worse(Measurement& worst, const Measurement& next, bool is_lower_worse) {
  const auto worse = [&](double x, double y) {
    return is_lower_worse ? std::min(x, y) : std::max(x, y);
  };
  if (worst.has_doubtful_points() || next.has_doubtful_points()) {
    worst.despite_doubt = worse_known(worst, next, is_lower_worse);
  }
  worst.metric = worse_of(*worst.metric, *next.metric, is_lower_worse);
  if (worst.without_replicate.size() != next.without_replicate.size()) {
    worst.without_replicate.clear();  // one of them is exact, or has none
  }
  for (std::size_t r = 0; r < worst.without_replicate.size(); ++r) {
    worst.without_replicate[r] = worse(worst.without_replicate[r], next.without_replicate[r]);
  }
  worst.unseen_points = std::max(worst.unseen_points, next.unseen_points);
  worst.single_sample_points = std::max(worst.single_sample_points, next.single_sample_points);
  worst.largest_share = std::max(worst.largest_share, next.largest_share);
  if (worst.remark.empty()) worst.remark = next.remark;
  if (worst.active.empty() || next.active.empty()) {
    worst.active.clear();  // everywhere
  } else {
    for (std::size_t i = 0; i < worst.active.size(); ++i) worst.active[i] |= next.active[i];
  }
}

}  // namespace

Measurement measure_any_one_out(const Requirement& requirement, const calc::SensorGrid& grid,
                                const calc::PlaneField& field,
                                const std::vector<calc::LightScene>& scenes, double confidence,
                                Goal goal) {
  Measurement none;
  const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const auto& s) { return s.id == requirement.scene; });
  if (scene == scenes.end()) {
    none.reason = calc::say<calc::Sentence::no_scene>(requirement.scene);
    return none;
  }
  const std::vector<std::string> groups = lit_groups(field, *scene);
  if (groups.empty()) {
    none.reason = calc::say<calc::Sentence::nothing_to_put_out>(scene->id);
    return none;
  }
  Requirement one = requirement;
  one.any_one_unit_out = false;
  const double level = 1.0 - (1.0 - confidence) / static_cast<double>(groups.size());
  std::optional<Measurement> worst;
  for (const std::string& group : groups) {
    Measurement next = measure(one, grid, field, {without(*scene, group)}, level, goal);
    if (!next.metric) {
      next.reason = calc::say<calc::Sentence::with_one_out>(group, next.reason);
      return next;
    }
    if (worst) {
      take_worse(*worst, next, is_lower_limit(requirement.comparison));
    } else {
      worst = std::move(next);
    }
  }
  return *worst;
}

}  // namespace rules
