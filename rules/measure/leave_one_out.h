#pragma once
// Computes a quantity without each of its replicates in turn. With equal random numbers this shows
// the difference of two results far better than their two intervals do.

#include "rules/measure/metrics.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace rules {

// Returns [replicate]: compute_metric() without that replicate; arguments as there. Empty: nothing
// was sampled, or a value is not defined.
std::vector<double> without_each_replicate(const PointValues& values, Metric metric, double percent,
                                           std::optional<std::size_t> point);

// Returns any other statistic for all replicates but one. Not for statistics that jump, such as a
// share of points: no single replicate shows most of their jumps.
std::vector<double> without_each_replicate(
    const PointValues& values,
    const std::function<std::optional<double>(const PointValues&)>& statistic);

// Returns after - before at the two-sided level `confidence`, from the values without each
// replicate (the jackknife): replicate r of one result may depend on replicate r of the other, as
// with equal seeds. Both have the same number, at least two. value: difference of the full results.
// [Efron79]
calc::Estimate paired_difference(const std::vector<double>& before,
                                 const std::vector<double>& after, double value, double confidence);

}  // namespace rules
