#include "report/tools/converge/converge_statistics.h"

#include "calc/base/elementary.h"
#include "calc/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace report {
namespace {

constexpr double kDarkShare = 1e-6;  // of the average
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double uo_of(std::span<const double> lx) {
  const double average = mean(lx);
  return average > 0.0 ? *std::min_element(lx.begin(), lx.end()) / average : 0.0;
}

// [point] of one replicate's place, over replicates.
std::vector<double> column(const std::vector<std::vector<double>>& replicates, std::size_t point) {
  std::vector<double> values;
  for (const std::vector<double>& replicate : replicates) values.push_back(replicate[point]);
  return values;
}

double reference_variance(ConvergeMetric metric, const ConvergeTruth& truth) {
  const auto squared = [](double error, double value) {
    return value > 0.0 ? (error / value) * (error / value) : 0.0;
  };
  switch (metric) {
    case ConvergeMetric::rms: {
      const double error = relative_error(truth);
      return error * error;
    }
    case ConvergeMetric::average:
      return squared(truth.average_error_lx, truth.average_lx);
    case ConvergeMetric::uniformity:
      return squared(truth.uo_error, truth.uo);
    case ConvergeMetric::maximum:
      break;
  }
  return 0.0;
}

struct Line {
  double exponent, at_one;  // log y = log at_one + exponent log x
};

std::optional<Line> fitted_line(std::span<const double> x, std::span<const double> y) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0.0) || !(y[i] > 0.0) || !std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    const double lx = calc::log(x[i]), ly = calc::log(y[i]);
    n += 1.0;
    sx += lx;
    sy += ly;
    sxx += lx * lx;
    sxy += lx * ly;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 3.0 || !(spread > 1e-12 * std::max(1.0, n * sxx))) return std::nullopt;
  const double exponent = (n * sxy - sx * sy) / spread;
  return Line{exponent, calc::exp((sy - exponent * sx) / n)};
}

bool holds(std::span<const double> values, double truth, double error, double confidence,
           ConvergeCoverage& coverage) {
  const calc::ReplicateMean known = calc::replicate_mean(values);
  if (!(known.standard_error > 0.0)) return false;
  const double t =
      calc::student_t_quantile(0.5 + 0.5 * confidence, static_cast<int>(values.size()) - 1);
  ++coverage.tried;
  const bool is_held = std::abs(known.mean - truth) <= t * calc::hypot(known.standard_error, error);
  if (is_held) ++coverage.held;
  return is_held;
}

}  // namespace

double ConvergeTruth::lowest_lx() const { return kDarkShare * average_lx; }

ConvergeTruth truth_of(const std::vector<std::vector<double>>& replicates) {
  ConvergeTruth truth;
  const std::size_t points = replicates.front().size();
  for (std::size_t i = 0; i < points; ++i) {
    const calc::ReplicateMean known = calc::replicate_mean(column(replicates, i));
    truth.lx.push_back(known.mean);
    truth.error_lx.push_back(known.standard_error);
  }
  std::vector<double> averages, ratios;
  const auto darkest = static_cast<std::size_t>(std::min_element(truth.lx.begin(), truth.lx.end()) -
                                                truth.lx.begin());
  for (const std::vector<double>& replicate : replicates) {
    averages.push_back(mean(replicate));
    if (averages.back() > 0.0) ratios.push_back(replicate[darkest] / averages.back());
  }
  truth.average_lx = mean(truth.lx);
  truth.average_error_lx = calc::replicate_mean(averages).standard_error;
  truth.uo = uo_of(truth.lx);
  if (ratios.size() > 1) truth.uo_error = calc::replicate_mean(ratios).standard_error;
  return truth;
}

ConvergeTruth truth_of(std::vector<double> lx, std::vector<double> error_lx) {
  ConvergeTruth truth;
  const auto n = static_cast<double>(lx.size());
  truth.average_lx = mean(lx);
  truth.uo = uo_of(lx);
  double squares = 0.0;
  for (const double error : error_lx) squares += error * error;
  truth.average_error_lx = std::sqrt(squares) / n;
  const auto darkest =
      static_cast<std::size_t>(std::min_element(lx.begin(), lx.end()) - lx.begin());
  if (truth.average_lx > 0.0) {
    truth.uo_error =
        calc::hypot(error_lx[darkest], truth.uo * truth.average_error_lx) / truth.average_lx;
  }
  truth.lx = std::move(lx);
  truth.error_lx = std::move(error_lx);
  return truth;
}

double relative_error(const ConvergeTruth& truth) {
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < truth.lx.size(); ++i) {
    if (!(truth.lx[i] > truth.lowest_lx())) continue;
    squares += calc::pow(truth.error_lx[i] / truth.lx[i], 2);
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

std::array<double, kConvergeMetrics> errors_of(std::span<const double> lx,
                                               const ConvergeTruth& truth) {
  double squares = 0.0, count = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < lx.size(); ++i) {
    if (!(truth.lx[i] > truth.lowest_lx())) continue;
    const double error = std::abs(lx[i] - truth.lx[i]) / truth.lx[i];
    squares += error * error;
    largest = std::max(largest, error);
    count += 1.0;
  }
  std::array<double, kConvergeMetrics> errors{kNaN, kNaN, kNaN, kNaN};
  if (count > 0.0) {
    errors[0] = std::sqrt(squares / count);
    errors[1] = largest;
  }
  if (truth.average_lx > 0.0) errors[2] = std::abs(mean(lx) - truth.average_lx) / truth.average_lx;
  if (truth.uo > 0.0) errors[3] = std::abs(uo_of(lx) - truth.uo) / truth.uo;
  return errors;
}

ConvergeError pool_errors(ConvergeMetric metric, std::span<const double> of_seeds,
                          const ConvergeTruth& truth) {
  ConvergeError pooled;
  if (of_seeds.empty()) return pooled;
  double squares = 0.0;
  pooled.low = pooled.high = of_seeds.front();
  for (const double error : of_seeds) {
    if (!std::isfinite(error)) return {};
    squares += error * error;
    pooled.low = std::min(pooled.low, error);
    pooled.high = std::max(pooled.high, error);
  }
  const double reference = reference_variance(metric, truth);
  const double left = squares / static_cast<double>(of_seeds.size()) - reference;
  pooled.is_below = reference > 0.0 && left <= reference / 3.0;
  pooled.value = std::sqrt(pooled.is_below ? reference : std::max(0.0, left));
  return pooled;
}

std::optional<double> fitted_exponent(std::span<const double> x, std::span<const double> y) {
  const std::optional<Line> line = fitted_line(x, y);
  return line ? std::optional<double>(line->exponent) : std::nullopt;
}

ConvergeTarget find_crossing(std::span<const double> x, std::span<const double> y, double target) {
  constexpr double kFarthest = 4.0;  // in y, beyond what was measured
  constexpr std::size_t kEnd = 4;    // steps that tell how the curve goes on
  constexpr double kStillFalls = -0.25;
  std::vector<double> xs, ys;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0.0) || !(y[i] > 0.0) || !std::isfinite(y[i])) continue;
    xs.push_back(x[i]);
    ys.push_back(y[i]);
  }
  if (xs.empty()) return {};
  std::size_t first = xs.size();  // from here on all errors are small enough
  while (first > 0 && ys[first - 1] <= target) --first;
  if (first > 0 && first < xs.size()) {
    const double share = calc::log(ys[first - 1] / target) / calc::log(ys[first - 1] / ys[first]);
    return {xs[first - 1] * calc::pow(xs[first] / xs[first - 1], share), false};
  }
  const double nearest = first == 0 ? ys.front() : ys.back();
  const double ratio = first == 0 ? target / nearest : nearest / target;
  // The end of the curve tells how it goes on: a bias may have stopped it.
  const std::size_t count = std::min(kEnd, xs.size());
  const std::size_t begin = first == 0 ? 0 : xs.size() - count;
  const std::optional<Line> line =
      fitted_line(std::span(xs).subspan(begin, count), std::span(ys).subspan(begin, count));
  if (!line || !(line->exponent < kStillFalls) || ratio > kFarthest) return {};
  const std::size_t from = first == 0 ? 0 : xs.size() - 1;
  return {xs[from] * calc::pow(target / ys[from], 1.0 / line->exponent), true};
}

ConvergeCoverage coverage_of(const std::vector<std::vector<double>>& replicates,
                             const ConvergeTruth& truth, double confidence) {
  ConvergeCoverage coverage;
  for (std::size_t i = 0; i < truth.lx.size(); ++i) {
    holds(column(replicates, i), truth.lx[i], truth.error_lx[i], confidence, coverage);
  }
  return coverage;
}

ConvergeCoverage average_coverage_of(const std::vector<std::vector<double>>& replicates,
                                     const ConvergeTruth& truth, double confidence) {
  ConvergeCoverage coverage;
  std::vector<double> averages;
  for (const std::vector<double>& replicate : replicates) averages.push_back(mean(replicate));
  holds(averages, truth.average_lx, truth.average_error_lx, confidence, coverage);
  return coverage;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace report
