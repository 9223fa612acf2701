#pragma once
// From a requirement and a plane's results to the quantity that it limits, with its interval.

#include "calc/field.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/metrics.h"
#include "rules/requirement.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// metric is empty if the quantity does not exist; `reason` then says why, in words.
struct Measurement {
  std::optional<MetricEstimate> metric;
  std::string reason;
  // Points whose value is not known to be what was measured, because no sampled light has reached
  // them although some may; only as far as they matter for this quantity. While there are any,
  // neither pass nor fail is proved.
  std::size_t unseen_points = 0;
};

Measurement measure(const Requirement& requirement, const calc::SensorGrid& grid,
                    const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                    double confidence);

}  // namespace rules
