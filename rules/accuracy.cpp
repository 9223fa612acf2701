#include "rules/accuracy.h"

#include "rules/measure.h"

#include <algorithm>

namespace rules {
namespace {

std::vector<Requirement> default_quantities() {
  Requirement average;
  average.metric = Metric::average;
  Requirement minimum;
  minimum.metric = Metric::minimum;
  return {average, minimum};
}

}  // namespace

bool is_accurate(const std::vector<Requirement>& requirements, const calc::SensorGrid& grid,
                 const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                 double tolerance, double confidence) {
  const std::vector<Requirement> judged =
      requirements.empty() ? default_quantities() : requirements;
  return std::all_of(judged.begin(), judged.end(), [&](const Requirement& requirement) {
    const Measurement measurement = measure(requirement, grid, field, scenes, confidence);
    if (measurement.unseen_points > 0) return false;
    if (!measurement.metric) return true;
    const calc::Estimate& estimate = measurement.metric->estimate;
    return estimate.half_width() <= tolerance * estimate.value;  // 0 <= 0 for an exact darkness
  });
}

}  // namespace rules
