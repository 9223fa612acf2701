#pragma once
// Computes the quantity that a requirement limits, with its interval, from a plane's results.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/goal.h"
#include "rules/catalogue/requirement.h"
#include "rules/measure/metrics.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rules {

// metric is empty if the quantity does not exist; `reason` then says why, in words.
struct Measurement {
  std::optional<MetricEstimate> metric;
  calc::Message reason;
  std::size_t points_used = 0;  // that the requirement's mask leaves
  // Points with an unreliable value that matter for this quantity. While there are any, a pass is
  // not proved, and a fail only by `despite_doubt`.
  std::size_t unseen_points = 0;         // no sampled light has reached them, although some may
  std::size_t single_sample_points = 0;  // a single sample is too large a share of their value
  float largest_share = 0.0F;            // of those single samples, the largest; 0: not known
  // If there are such points, or no finite interval: what the other points prove, see
  // despite_doubt.h.
  std::optional<MetricEstimate> despite_doubt;
  // A remark to read with an interval that leaves the verdict open; or "".
  calc::Message remark;
  // Why nothing has this quantity, in words; or "". The value is then exactly -infinity, below
  // every limit.
  calc::Message nothing_there;
  // For an interval not made of samples alone: the interval by samples alone, and whether the rest
  // contains the limit, so that no number of samples decides.
  std::optional<calc::Estimate> by_samples;
  bool is_open_for_good = false;
  // [point of the field]: 1 where more samples would serve the goal; empty: everywhere.
  std::vector<std::uint8_t> active;
  // The value without each replicate, see leave_one_out.h; empty: exact, or a quantity that does
  // not come from the points' illuminances alone.
  std::vector<double> without_replicate;

  // The light is too low by an unknown amount, see PlaneField::is_cut_off.
  bool is_cut_off = false;
  // The light may differ from the calculation, see Requirement::missing_light and unsure_light.
  bool has_missing_light = false;

  bool has_doubtful_points() const { return unseen_points > 0 || single_sample_points > 0; }
};

// Returns the levels of a scene's groups; none for "", where all are at 1. Null: unknown scene.
const std::vector<std::pair<std::string, double>>* levels_of(
    const std::string& scene, const std::vector<calc::LightScene>& scenes);

// Returns the measurement of a requirement. goal: verdict, if only the requirement's limit counts;
// accuracy, if the quantity itself is wanted. confidence: level of the interval.
Measurement measure(const Requirement& requirement, const calc::SensorGrid& grid,
                    const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                    double confidence, Goal goal = Goal::verdict);

}  // namespace rules
