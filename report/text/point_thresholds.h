#pragma once
// Which limits the values of a plane's points are held against, wherever these are shown.

#include "report/document/document.h"
#include "report/text/number_format.h"

#include <optional>

namespace report {

// Whether a requirement is about the points as they are shown: all of them, in the light that is
// shown.
bool is_about_points(const PlanePart& plane, const rules::Requirement& requirement);

// The strictest limit that single points must meet: of minima at least or more than something, of
// maxima at most or less than something. Only requirements that is_about_points() holds for.
enum class PointSide { from_below, from_above };
std::optional<Threshold> point_threshold(const PlanePart& plane, PointSide side);

// Whether the value misses the threshold, if there is one.
bool misses(const std::optional<Threshold>& threshold, double value);

// All limits of that statistic of the plane as the report shows it: what its digits must respect.
Thresholds statistic_thresholds(const PlanePart& plane, rules::Metric metric);
// Those of single points, both sides.
Thresholds point_thresholds(const PlanePart& plane);

}  // namespace report
