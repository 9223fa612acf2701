#pragma once
// The arithmetic behind convergence curves.

#include "report/tools/converge/converge_document.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace report {

// The true values of a plane's points, with their standard errors; 0 = exact.
struct ConvergeTruth {
  std::vector<double> lx, error_lx;  // [point]
  double average_lx = 0.0, average_error_lx = 0.0;
  double uo = 0.0, uo_error = 0.0;
  double lowest_lx() const;  // below it a point counts as dark and is left out of relative errors
};
// Returns the truth from replicates [replicate][point], at least two of them and one point.
ConvergeTruth truth_of(const std::vector<std::vector<double>>& replicates);
// Returns the truth from values and their standard errors, taken to be independent of each other.
ConvergeTruth truth_of(std::vector<double> lx, std::vector<double> error_lx);

// Returns the RMS over points of the truth's relative standard error.
double relative_error(const ConvergeTruth& truth);

// Returns the relative errors of a run, >= 0; NaN where the truth is 0.
std::array<double, kConvergeMetrics> errors_of(std::span<const double> lx,
                                               const ConvergeTruth& truth);

// Pools the seeds' errors of a metric. E (X - T')^2 = E (X - T)^2 + var T', for a truth T' that is
// independent of X: the second term is subtracted, except from maxima, whose distribution is not
// known. The rest must be more than a third of the variance subtracted, else it counts as below.
ConvergeError pool_errors(ConvergeMetric metric, std::span<const double> of_seeds,
                          const ConvergeTruth& truth);

// Returns the exponent of y over x, by least squares of logarithms over steps with finite positive
// values; none for fewer than three steps or equal x.
std::optional<double> fitted_exponent(std::span<const double> x, std::span<const double> y);

// Returns x where y falls to `target`, log-log: from the first step from which y stays at or below
// it and the step before; else along the slope of the last (or first) four steps, if it is below
// -1/4, up to a factor of 4 beyond the measured range. x, y > 0; steps with y not finite are
// omitted.
ConvergeTarget find_crossing(std::span<const double> x, std::span<const double> y, double target);

// Returns how often stated intervals contain the truth: |mean - T| <= t sqrt(s^2 / R + error^2). A
// value that never varies (light that is not sampled) is not counted. [replicate][point]
ConvergeCoverage coverage_of(const std::vector<std::vector<double>>& replicates,
                             const ConvergeTruth& truth, double confidence);
ConvergeCoverage average_coverage_of(const std::vector<std::vector<double>>& replicates,
                                     const ConvergeTruth& truth, double confidence);

double median(std::vector<double> values);  // not empty

}  // namespace report
