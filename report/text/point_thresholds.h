#pragma once
// The limits for the values of a plane's points, wherever these are shown.

#include "report/document/document.h"
#include "report/text/number_format.h"

#include <optional>

namespace report {

// Returns whether a requirement is about the points as shown: all of them, in the shown light.
bool is_about_points(const PlanePart& plane, const rules::Requirement& requirement);

// The strictest limits for single points: lower limits of minima, upper limits of maxima. Only from
// requirements with is_about_points().
enum class PointSide { from_below, from_above };
std::optional<Threshold> point_threshold(const PlanePart& plane, PointSide side);

// Returns whether the value misses the threshold, if there is one.
bool misses(const std::optional<Threshold>& threshold, double value);

// Returns all limits on that statistic of the plane as the report shows it: its digits must respect
// them.
Thresholds statistic_thresholds(const PlanePart& plane, rules::Metric metric);
// Returns the limits for single points, both sides.
Thresholds point_thresholds(const PlanePart& plane);

}  // namespace report
