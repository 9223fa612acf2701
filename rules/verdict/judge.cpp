#include "rules/verdict/judge.h"

#include "calc/base/elementary.h"
#include "calc/base/sentences.h"
#include "rules/measure/error_spending.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace rules {
namespace {

int sign(double x) { return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0); }

double rounded(double value, int digits) {
  const double scale = calc::pow(10.0, digits);
  return std::round(value * scale) / scale;
}

// Returns the digits after the point with which both ends are still on their own side of the limit.
int digits_for(const calc::Estimate& estimate, double limit, const Requirement& requirement) {
  const auto is_kept = [&](double value, int digits) {
    if (!std::isfinite(value)) return true;
    return sign(rounded(value, digits) - limit) == sign(value - limit);
  };
  constexpr int kMostDigits = 9;
  int digits = is_ratio(requirement.metric)
                   ? 2
                   : (estimate.high < 10.0 ? 2 : (estimate.high < 100.0 ? 1 : 0));
  while (digits < kMostDigits &&
         !(is_kept(estimate.low, digits) && is_kept(estimate.high, digits))) {
    ++digits;
  }
  return digits;
}

calc::Message undecided_text(const calc::Estimate& estimate, double limit,
                             const Requirement& requirement) {
  const int digits = digits_for(estimate, limit, requirement);
  const std::string unit =
      *unit_of(requirement) == '\0' ? "" : fmt::format(" {}", unit_of(requirement));
  const auto number = [&](double value, std::string_view behind) {
    return calc::Message::number(fmt::format("{:.{}f}{}", value, digits, behind));
  };
  const calc::Message required = calc::Message::number(fmt::format("{:.9g}{}", limit, unit));
  if (!std::isfinite(estimate.low)) {
    return calc::say<calc::Sentence::undecided_below>(number(estimate.high, unit), required);
  }
  if (!std::isfinite(estimate.high)) {
    return calc::say<calc::Sentence::undecided_above>(number(estimate.low, unit), required);
  }
  return calc::say<calc::Sentence::undecided>(number(estimate.low, ""), number(estimate.high, unit),
                                              required);
}

calc::Message doubt_text(const Measurement& measurement, const calc::SensorGrid& grid) {
  const std::size_t points = grid.position_m.size();
  return measurement.unseen_points > 0
             ? calc::say<calc::Sentence::unseen>(measurement.unseen_points, points)
             : calc::say<calc::Sentence::single_sample>(measurement.single_sample_points, points);
}

// Returns the factor on light paths that would move the limit out of the interval and settle the
// largest sample, at the same value: errors fall as the root of paths, or faster, samples as paths.
// infinite: no factor would.
double more_work(const Finding& finding, const Measurement& measurement) {
  const calc::Estimate& is = finding.measured;
  const double limit = finding.requirement.limit;
  const bool is_below = is.value < limit;
  const double error = is_below ? is.high - is.value : is.value - is.low;
  const double room = is_below ? limit - is.value : is.value - limit;
  double times = 1.0;
  if (is.low <= limit && limit <= is.high) {
    times = room > 0.0 ? (error / room) * (error / room) : kInfinity;
  }
  if (measurement.single_sample_points > 0) {
    times = std::max(times, static_cast<double>(measurement.largest_share / kLargestTrustedShare));
  }
  return times;
}

// Returns words for more work; "" if paths do not help, or their number is not known.
calc::Message more_work_text(const Finding& finding, const Measurement& measurement) {
  const bool is_unknown = measurement.unseen_points > 0 || !measurement.remark.empty() ||
                          measurement.is_cut_off || measurement.has_missing_light ||
                          (measurement.single_sample_points > 0 && measurement.largest_share <= 0);
  const bool is_sampled = !is_of_space(finding.requirement.metric);
  if (finding.verdict != Verdict::undecided || is_unknown || !is_sampled) return {};
  constexpr double kMostTimes = 65536.0;
  const double times = more_work(finding, measurement);
  if (!(times <= kMostTimes)) {
    return calc::say<calc::Sentence::too_close>();
  }
  double power = 2.0;
  while (power < times) power *= 2.0;
  return calc::say<calc::Sentence::more_paths>(power);
}

int digits_of(const Requirement& requirement) {
  // A modelling ratio is printed as all ratios are, as is the luminance of a road, a glare rating
  // as other numbers.
  const bool is_of_two = is_ratio(requirement.metric) ||
                         requirement.metric == Metric::road_luminance ||
                         requirement.derived == calc::DerivedQuantity::modelling;
  return requirement.policy.digits(
      is_in_lux(requirement) ? Dimension::illuminance : Dimension::plain, is_of_two);
}

// Returns a failure that a single point proves; the doubt about other points is reported
// nevertheless.
std::optional<Finding> failed_despite_doubt(const Requirement& requirement,
                                            const Measurement& measurement,
                                            const calc::SensorGrid& grid) {
  const std::optional<MetricEstimate>& known = measurement.despite_doubt;
  const bool is_doubtful = measurement.has_doubtful_points();
  if (!known || (measurement.metric && !is_doubtful)) return std::nullopt;
  const calc::Estimate& estimate = known->estimate;
  if (!calc::is_finite(estimate) && !has_open_ends(requirement, estimate)) return std::nullopt;
  const Decision decision = decide(requirement, estimate);
  if (decision.verdict != Verdict::fail) return std::nullopt;
  Finding finding;
  finding.requirement = requirement;
  finding.verdict = decision.verdict;
  finding.measured = estimate;
  finding.is_close = decision.is_close;
  finding.by_tolerance = decision.by_tolerance;
  finding.margin = margin_of(requirement, estimate, finding.verdict);
  finding.points_used = measurement.points_used;
  if (known->point) finding.place_m = grid.position_m[*known->point];
  finding.reason = is_doubtful ? doubt_text(measurement, grid) : measurement.reason;
  return finding;
}

// Returns whether more light only makes the verdict surer.
bool holds_with_more_light(const Requirement& requirement, Verdict verdict) {
  const Metric metric = requirement.metric;
  const bool grows = !is_ratio(metric) && (is_in_lux(requirement) ||
                                           (is_of_space(metric) && metric_row(metric).is_linear));
  const bool falls = metric == Metric::power_per_100_lx;
  if (!grows && !falls) return false;
  return verdict ==
         (is_lower_limit(requirement.comparison) == grows ? Verdict::pass : Verdict::fail);
}

void make_doubtful(Finding& finding) {
  finding.verdict = Verdict::undecided;
  finding.is_doubtful = true;
  finding.is_close = false;
  finding.by_tolerance = false;
}

}  // namespace

bool has_open_ends(const Requirement& requirement, const calc::Estimate& measured) {
  const bool is_open_above = std::isfinite(measured.low) && std::isfinite(measured.value) &&
                             measured.low <= measured.value && measured.high == kInfinity;
  if (is_open_above && !is_lower_limit(requirement.comparison) &&
      decide(requirement, measured).verdict == Verdict::fail) {
    return true;
  }
  const bool is_rating = requirement.derived == calc::DerivedQuantity::ugr ||
                         requirement.metric == Metric::ugr_table ||
                         requirement.metric == Metric::glare_rating;
  return is_rating && measured.low <= measured.value && measured.value <= measured.high &&
         !calc::is_finite(measured);
}

Decision decide(const Requirement& requirement, const calc::Estimate& measured) {
  const double limit = requirement.limit;
  return decide({measured, requirement.comparison, {limit, limit, limit}, digits_of(requirement)},
                requirement.policy);
}

double margin_of(const Requirement& requirement, const calc::Estimate& measured, Verdict verdict) {
  const double of_value = margin(measured, requirement.comparison, requirement.limit);
  const bool reads_as_good = verdict == Verdict::fail && of_value >= 0.0;
  return reads_as_good ? std::numeric_limits<double>::quiet_NaN() : of_value;
}

Finding judge_measurement(const Requirement& requirement, const Measurement& measurement,
                          const calc::SensorGrid& grid) {
  if (auto failed = failed_despite_doubt(requirement, measurement, grid)) return *failed;
  Finding finding;
  finding.requirement = requirement;
  if (!measurement.metric) {
    finding.reason = measurement.reason;
    return finding;
  }
  const calc::Estimate& estimate = measurement.metric->estimate;
  if (!calc::is_finite(estimate) && !has_open_ends(requirement, estimate)) {
    finding.reason = calc::say<calc::Sentence::not_finite>();
    return finding;
  }
  const double limit = requirement.limit;
  finding.measured = estimate;
  const Decision decision = decide(requirement, estimate);
  finding.verdict = decision.verdict;
  finding.is_close = decision.is_close;
  finding.by_tolerance = decision.by_tolerance;
  finding.margin = margin_of(requirement, estimate, finding.verdict);
  finding.points_used = measurement.points_used;
  finding.without_replicate = measurement.without_replicate;
  if (measurement.metric->point) finding.place_m = grid.position_m[*measurement.metric->point];
  finding.reason = measurement.nothing_there;
  if (finding.verdict == Verdict::undecided) {
    finding.reason = undecided_text(finding.measured, limit, requirement);
    append(finding.reason, measurement.remark);
  }
  if (!measurement.has_doubtful_points()) {
    if (measurement.is_cut_off && !holds_with_more_light(requirement, finding.verdict)) {
      make_doubtful(finding);
      finding.reason = calc::say<calc::Sentence::cut_off>();
    } else if (measurement.has_missing_light && finding.verdict != Verdict::undecided) {
      const bool is_unsure = !requirement.unsure_light.empty();
      if (!is_unsure && holds_with_more_light(requirement, finding.verdict)) return finding;
      // What fails fails as the project is, but the light that is missing is the first to mend.
      if (finding.verdict == Verdict::pass) make_doubtful(finding);
      finding.reason = is_unsure ? requirement.unsure_light : requirement.missing_light;
    }
    return finding;
  }
  if (measurement.unseen_points > 0 || finding.verdict != Verdict::undecided) {
    finding.reason = doubt_text(measurement, grid);
  }
  make_doubtful(finding);
  // What nobody has seen may be as large as everything known leaves room for.
  const std::optional<MetricEstimate>& known = measurement.despite_doubt;
  if (measurement.unseen_points > 0 && known && calc::is_finite(known->estimate)) {
    finding.measured.low = std::min(finding.measured.low, known->estimate.low);
    finding.measured.high = std::max(finding.measured.high, known->estimate.high);
  }
  return finding;
}

Finding judge_measurement(const Requirement& requirement, const Measurement& measurement,
                          const calc::SensorGrid& grid, const calc::PlaneField& field) {
  Finding finding = judge_measurement(requirement, measurement, grid);
  if (!field.is_exact()) append(finding.reason, more_work_text(finding, measurement));
  return finding;
}

std::vector<Finding> judge_plane(const std::vector<Requirement>& requirements,
                                 const calc::SensorGrid& grid, const calc::PlaneField& field,
                                 const std::vector<calc::LightScene>& scenes, double confidence) {
  if (!field.problem.empty()) return not_judged_plane(requirements, field.problem);
  const double level = look_confidence(confidence, field);
  std::vector<Finding> findings;
  findings.reserve(requirements.size());
  for (const Requirement& requirement : requirements) {
    findings.push_back(judge_measurement(
        requirement, measure(requirement, grid, field, scenes, level), grid, field));
  }
  return findings;
}

std::vector<Finding> not_judged_plane(const std::vector<Requirement>& requirements,
                                      const calc::Message& reason) {
  std::vector<Finding> findings;
  for (const Requirement& requirement : requirements) {
    Finding finding;
    finding.requirement = requirement;
    finding.reason = reason;
    findings.push_back(finding);
  }
  return findings;
}

}  // namespace rules
