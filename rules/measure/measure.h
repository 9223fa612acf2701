#pragma once
// From a requirement and a plane's results to the quantity that it limits, with its interval.

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
  // Points whose value is not known to be what was measured, only as far as they matter for this
  // quantity. While there are any, a pass is not proved, and a fail by `despite_doubt` only.
  std::size_t unseen_points = 0;         // no sampled light has reached them, although some may
  std::size_t single_sample_points = 0;  // a single sample is too large a share of their value
  float largest_share = 0.0F;            // of those single samples, the largest; 0: not known
  // Where there are such points, or no finite interval: what the others prove, see
  // despite_doubt.h.
  std::optional<MetricEstimate> despite_doubt;
  // What must be read with the interval where it leaves the verdict open; or "".
  calc::Message remark;
  // Nothing is there that the quantity could be of, and so it is less than every limit: its value
  // is -infinity, exactly. In words; or "".
  calc::Message nothing_there;
  // Of an interval that is not of samples alone: that of samples alone, and whether the rest of it
  // holds the limit, so that no number of samples decides.
  std::optional<calc::Estimate> by_samples;
  bool is_open_for_good = false;
  // [point of the field]: 1 where more samples would serve the goal; empty: everywhere.
  std::vector<std::uint8_t> active;
  // The value without each replicate, see leave_one_out.h; empty: exact, or of quantities that do
  // not come from the points' illuminances alone.
  std::vector<double> without_replicate;

  // The light that it is of is too little by nobody knows how much, see PlaneField::is_cut_off.
  bool is_cut_off = false;
  // It may be other than is calculated, see Requirement::missing_light and unsure_light.
  bool has_missing_light = false;

  bool has_doubtful_points() const { return unseen_points > 0 || single_sample_points > 0; }
};

// The levels of a scene's groups; of "", where all are at 1, none. Null: there is no such scene.
const std::vector<std::pair<std::string, double>>* levels_of(
    const std::string& scene, const std::vector<calc::LightScene>& scenes);

// goal: verdict, if only the requirement's limit counts; accuracy, if its quantity is wanted for
// its own sake. confidence: level of the interval itself.
Measurement measure(const Requirement& requirement, const calc::SensorGrid& grid,
                    const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                    double confidence, Goal goal = Goal::verdict);

}  // namespace rules
