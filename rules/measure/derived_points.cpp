#include "rules/measure/derived_points.h"

#include "calc/base/elementary.h"
#include "calc/base/glare_limits.h"
#include "calc/base/sentences.h"
#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "rules/measure/candidates.h"
#include "rules/measure/replicate_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rules {
namespace {

bool has_mark(const std::vector<std::uint8_t>& marks, std::size_t i) {
  return !marks.empty() && marks[i] != 0;
}

std::vector<double> column_of(const PointValues& values, std::size_t i) {
  std::vector<double> column;
  for (std::size_t r = 0; r < values.replicates; ++r) column.push_back(values.at(r, i));
  return column;
}

// Returns the covariance of the means of both.
double covariance_of(const std::vector<double>& a, double mean_a, const std::vector<double>& b,
                     double mean_b) {
  if (a.size() < 2) return 0.0;
  double products = 0.0;
  for (std::size_t r = 0; r < a.size(); ++r) products += (a[r] - mean_a) * (b[r] - mean_b);
  return products / (static_cast<double>(a.size() - 1) * static_cast<double>(a.size()));
}

double ugr_of(double sum, double background_lx) {
  if (!(sum > 0.0)) return -kInfinity;
  if (!(background_lx > 0.0)) return kInfinity;
  return 8.0 * calc::log10(0.25 * calc::kPi * sum / background_lx);
}

// Returns an upper bound, see calc::kLuminousCeiling_lx; never less than UGR.
double luminous_ceiling(double sum, double background_lx) {
  if (!(sum > 0.0)) return -kInfinity;
  if (!(background_lx > 0.0)) return kInfinity;
  return 8.0 *
         calc::log10(2.0 * sum * std::max(1.0 / background_lx, 1.0 / calc::kLuminousCeiling_lx));
}

calc::Message doubt_text(const calc::GlareDoubt& doubt) {
  const calc::Message place =
      calc::Message::number(fmt::format("({:.3f}, {:.3f}, {:.3f})", doubt.luminaire_m[0],
                                        doubt.luminaire_m[1], doubt.luminaire_m[2]));
  const std::size_t observer = doubt.point + 1;
  switch (doubt.problem) {
    case calc::GlareProblem::below_sight:
      return calc::say<calc::Sentence::glare_below_sight>(place, observer);
    case calc::GlareProblem::too_large:
      return calc::say<calc::Sentence::glare_too_large>(place, observer, doubt.number,
                                                        calc::kLargestGlareSource_sr);
    case calc::GlareProblem::no_area:
      break;
  }
  return calc::say<calc::Sentence::glare_no_area>(place, observer, calc::kSmallestGlareSource_m2);
}

// Returns receivers part * points + i of a plane with several receivers per point.
PointValues receivers_of_part(const PointValues& all, std::size_t part, std::size_t parts) {
  const std::size_t points = all.points / parts;
  std::vector<std::size_t> chosen(points);
  for (std::size_t i = 0; i < points; ++i) chosen[i] = part * points + i;
  return select_points(all, chosen);
}

}  // namespace

ModellingPoints::ModellingPoints(const PointValues& receivers,
                                 const std::vector<std::size_t>& points) {
  replicates_ = receivers.replicates;
  const std::size_t all = receivers.points / 2;
  for (const std::size_t i : points) {
    const std::vector<double> cylinder = column_of(receivers, i);
    const std::vector<double> plane = column_of(receivers, all + i);
    const calc::ReplicateMean a = calc::replicate_mean(cylinder), b = calc::replicate_mean(plane);
    cylinder_.push_back(
        {a.mean, a.standard_error * a.standard_error, receivers.largest_sample_at(i)});
    plane_.push_back(
        {b.mean, b.standard_error * b.standard_error, receivers.largest_sample_at(all + i)});
    covariance_.push_back(covariance_of(cylinder, a.mean, plane, b.mean));
    const bool is_unseen = has_mark(receivers.unseen, i) || has_mark(receivers.unseen, all + i);
    unseen_.push_back(is_unseen ? 1 : 0);
    single_sample_.push_back(receivers.is_untrusted(i) || receivers.is_untrusted(all + i) ? 1 : 0);
    if (!is_unseen && !(a.mean > 0.0) && !(b.mean > 0.0)) ++dark_points_;
  }
}

Limits ModellingPoints::limits(std::size_t point, double t) const {
  const Mean& a = cylinder_[point];
  const Mean& b = plane_[point];
  Limits limits = fieller_limits({a.value, b.value, a.variance, covariance_[point], b.variance,
                                  a.largest_sample, b.largest_sample},
                                 t);
  if (!(b.value > 0.0)) limits.value = a.value > 0.0 ? kInfinity : 0.0;
  limits.low = std::clamp(limits.low, 0.0, limits.value);
  limits.high = std::max(limits.high, limits.value);
  return limits;
}

GlarePoints::GlarePoints(const PointValues& indirect, const calc::GlareField& glare,
                         const std::vector<double>& channel_weights,
                         const std::vector<std::size_t>& points) {
  replicates_ = indirect.replicates;
  std::vector<std::uint8_t> sees_large(indirect.points, 0);
  for (const calc::GlareDoubt& doubt : glare.doubts) {
    const bool is_large = doubt.problem == calc::GlareProblem::too_large;
    if (is_large && channel_weights[doubt.channel] > 0.0) sees_large[doubt.point] = 1;
  }
  for (const std::size_t i : points) {
    const calc::ReplicateMean mean = calc::replicate_mean(column_of(indirect, i));
    Eye eye{0.0,
            0.0,
            0.0,
            mean.mean,
            mean.standard_error,
            indirect.largest_sample_at(i),
            sees_large[i] != 0};
    for (std::size_t c = 0; c < channel_weights.size(); ++c) {
      const double square = channel_weights[c] * channel_weights[c];
      const std::size_t k = c * indirect.points + i;
      eye.sum += square * glare.value[k];
      eye.low_sum += square * glare.low[k];
      eye.high_sum += square * glare.high[k];
    }
    eye_.push_back(eye);
    unseen_.push_back(has_mark(indirect.unseen, i) ? 1 : 0);
    single_sample_.push_back(indirect.is_untrusted(i) ? 1 : 0);
  }
}

GlarePoints GlarePoints::without_doubts() const {
  GlarePoints points = *this;
  for (Eye& eye : points.eye_) {
    eye.low_sum = eye.high_sum = eye.sum;
    eye.is_large_seen = false;
  }
  return points;
}

Limits GlarePoints::limits(std::size_t point, double t) const {
  const Eye& eye = eye_[point];
  const double most_lx = eye.mean_lx + t * std::sqrt(variance_with(eye.error_lx * eye.error_lx,
                                                                   eye.largest_sample_lx));
  const double least_lx = eye.mean_lx - t * eye.error_lx;
  const double high =
      eye.is_large_seen ? luminous_ceiling(eye.high_sum, least_lx) : ugr_of(eye.high_sum, least_lx);
  return {ugr_of(eye.low_sum, most_lx), ugr_of(eye.sum, eye.mean_lx), high};
}

bool GlarePoints::has_inexact_sources() const {
  return std::any_of(eye_.begin(), eye_.end(), [](const Eye& eye) {
    return eye.low_sum < eye.high_sum || eye.is_large_seen;
  });
}

GlareDoubts glare_doubts(const calc::GlareField& glare, const std::vector<double>& channel_weights,
                         const std::vector<std::size_t>& points) {
  std::map<std::size_t, const calc::GlareDoubt*> of_point;  // the first of each
  for (const calc::GlareDoubt& doubt : glare.doubts) {
    if (channel_weights[doubt.channel] > 0.0) of_point.emplace(doubt.point, &doubt);
  }
  GlareDoubts doubts;
  for (const std::size_t point : points) {
    const auto found = of_point.find(point);
    if (found != of_point.end() && ++doubts.points == 1) doubts.first = doubt_text(*found->second);
  }
  return doubts;
}

PointValues mean_of_four_planes(const PointValues& receivers) {
  constexpr std::size_t kParts = calc::receivers_per_point(calc::DerivedQuantity::four_planes);
  constexpr std::size_t kPlanes = kParts - 1;
  PointValues mean;
  mean.points = receivers.points / kParts;
  mean.replicates = receivers.replicates;
  mean.value_lx.assign(mean.replicates * mean.points, 0.0);
  if (!receivers.even_lx.empty()) mean.even_lx = mean.value_lx;
  if (!receivers.unseen.empty()) mean.unseen.assign(mean.points, 0);
  if (!receivers.largest_share.empty()) mean.largest_share.assign(mean.points, 0.0F);
  if (!receivers.largest_sample_lx.empty()) mean.largest_sample_lx.assign(mean.points, 0.0);
  for (std::size_t part = 1; part < kParts; ++part) {
    for (std::size_t i = 0; i < mean.points; ++i) {
      const std::size_t receiver = part * mean.points + i;
      for (std::size_t r = 0; r < mean.replicates; ++r) {
        const std::size_t at = r * mean.points + i;
        mean.value_lx[at] += receivers.at(r, receiver) / static_cast<double>(kPlanes);
        if (mean.even_lx.empty()) continue;
        mean.even_lx[at] += receivers.even_at(r, receiver) / static_cast<double>(kPlanes);
      }
      // A sample's share of the mean is at most its share of the plane that it belongs to.
      if (!mean.unseen.empty()) mean.unseen[i] |= receivers.unseen[receiver];
      if (!mean.largest_share.empty()) {
        mean.largest_share[i] = std::max(mean.largest_share[i], receivers.largest_share[receiver]);
      }
      if (!mean.largest_sample_lx.empty()) {
        mean.largest_sample_lx[i] +=
            receivers.largest_sample_lx[receiver] / static_cast<double>(kPlanes);
      }
    }
  }
  return mean;
}

PointValues true_cylinders(const PointValues& receivers) {
  return receivers_of_part(receivers, 0,
                           calc::receivers_per_point(calc::DerivedQuantity::four_planes));
}

}  // namespace rules
