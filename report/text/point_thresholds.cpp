#include "report/text/point_thresholds.h"

#include "rules/catalogue/compare.h"

#include <cmath>

namespace report {

bool is_about_points(const PlanePart& plane, const rules::Requirement& requirement) {
  const bool is_asked = plane.asked_light && plane.asked_light->is_shown;
  const AskedLight light = is_asked ? *plane.asked_light : AskedLight{};
  return light.is_asked_by(requirement) && requirement.mask.id.empty() &&
         requirement.mask.operations.empty();
}

std::optional<Threshold> point_threshold(const PlanePart& plane, PointSide side) {
  const bool is_minimum = side == PointSide::from_below;
  const rules::Metric metric = is_minimum ? rules::Metric::minimum : rules::Metric::maximum;
  std::optional<Threshold> strictest;
  for (const rules::Finding& finding : plane.findings) {
    const rules::Requirement& r = finding.requirement;
    if (r.metric != metric || rules::is_lower_limit(r.comparison) != is_minimum) continue;
    if (!is_about_points(plane, r) || std::isnan(r.limit)) continue;
    const Threshold threshold{r.limit, r.comparison};
    // Of equal limits the one that the limit itself misses.
    if (!strictest || (is_minimum ? r.limit > strictest->limit : r.limit < strictest->limit) ||
        (r.limit == strictest->limit && misses(threshold, r.limit))) {
      strictest = threshold;
    }
  }
  return strictest;
}

bool misses(const std::optional<Threshold>& threshold, double value) {
  return threshold && !rules::meets(value, threshold->comparison, threshold->limit);
}

Thresholds statistic_thresholds(const PlanePart& plane, rules::Metric metric) {
  Thresholds thresholds;
  for (const rules::Finding& finding : plane.findings) {
    const rules::Requirement& r = finding.requirement;
    if (r.metric == metric && is_about_points(plane, r) && !std::isnan(r.limit))
      thresholds.add(Threshold{r.limit, r.comparison});
  }
  return thresholds;
}

Thresholds point_thresholds(const PlanePart& plane) {
  return {point_threshold(plane, PointSide::from_below),
          point_threshold(plane, PointSide::from_above)};
}

}  // namespace report
