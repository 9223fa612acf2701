#pragma once
// What some points prove of a plane, whatever the values of the others are: one point that is
// surely below a limit is enough for "every point", and no doubt about another point changes it.

#include "calc/base/field.h"
#include "rules/catalogue/requirement.h"
#include "rules/measure/derived_points.h"
#include "rules/measure/metrics.h"

#include <optional>

namespace rules {

// Of a lower limit the interval from the least that there can be up to an upper end, of an upper
// limit from a lower end to infinity. Of points whose value is not known (no sample has reached
// them, or they rest on a single one) nothing is taken but that no light is below 0 lx; the value
// and the place are those of the other points. So it may prove that a requirement fails, and never
// that it passes. Empty where the other points prove nothing: of quantities whose end on that side
// may be moved by any point (a lower limit of an average), or if too few points are known.
//
// The end holds at (1 - confidence) / 2, and for whichever of the points has it: all of them share
// that risk, since the doubtful ones were found in the same samples.
//
// requirement: its metric, percent and comparison are taken. points of `values`: at least one.
std::optional<MetricEstimate> despite_doubt(const PointValues& values,
                                            const Requirement& requirement, double confidence);

// The same of ratings and ratios of points: minimum, maximum, percentile.
std::optional<MetricEstimate> despite_doubt(const DerivedPoints& points,
                                            const Requirement& requirement, double confidence);

}  // namespace rules
