#pragma once
// A quantity without each of its replicates in turn: what tells how two results that were made with
// the same random numbers differ, far better than their two intervals do.

#include "rules/measure/metrics.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace rules {

// [replicate]: the value of compute_metric() if that replicate had not been drawn; arguments as
// there. Empty: nothing was sampled, or a value is not defined.
std::vector<double> without_each_replicate(const PointValues& values, Metric metric, double percent,
                                           std::optional<std::size_t> point);

// The same of any other statistic: what it gives for the values of all replicates but one. Not for
// those that jump, as a share of points does: most of their jumps no single replicate shows.
std::vector<double> without_each_replicate(
    const PointValues& values,
    const std::function<std::optional<double>(const PointValues&)>& statistic);

// after - before at the two-sided level `confidence`, from what each would be without each
// replicate (the jackknife): replicate r of one may depend on replicate r of the other, as it does
// with equal seeds. As many of either, at least two. value: of the results themselves.  [Efron79]
calc::Estimate paired_difference(const std::vector<double>& before,
                                 const std::vector<double>& after, double value, double confidence);

}  // namespace rules
