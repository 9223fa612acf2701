#pragma once
// Failures that some points prove, whatever the values of the others: a single point surely below a
// limit fails "every point", and doubt about another point does not change that.

#include "calc/base/field.h"
#include "rules/catalogue/requirement.h"
#include "rules/measure/derived_points.h"
#include "rules/measure/metrics.h"

#include <optional>

namespace rules {

// Returns the interval that the reliable points prove. For a lower limit it runs from the least
// possible value to an upper end; for an upper limit from a lower end to infinity. Points whose
// value is not known (reached by no sample, or resting on a single sample) contribute only that no
// light is below 0 lx; value and place are those of the other points. So the interval may prove
// that a requirement fails, and never that it passes. Empty where the other points prove nothing:
// any point may move that end (a lower limit of an average), or too few points are known.
//
// The end holds at (1 - confidence) / 2, for any of the points: all share that risk, because the
// doubtful points were found in the same samples.
//
// requirement: its metric, percent and comparison are used. `values` has at least one point.
std::optional<MetricEstimate> despite_doubt(const PointValues& values,
                                            const Requirement& requirement, double confidence);

// Returns the interval for ratings and ratios of points: minimum, maximum, percentile.
std::optional<MetricEstimate> despite_doubt(const DerivedPoints& points,
                                            const Requirement& requirement, double confidence);

}  // namespace rules
