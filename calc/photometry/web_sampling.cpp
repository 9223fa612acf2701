#include "calc/photometry/web_sampling.h"

#include "calc/base/elementary.h"
#include "calc/base/turns.h"
#include "calc/base/units.h"
#include "calc/photometry/sine_segment.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

SineSegment segment_at(const PhotometricWeb& web, std::size_t below, std::size_t above,
                       double fraction, std::size_t gamma) {
  const std::vector<double>& nodes = web.gamma_rad();
  return {nodes[gamma], nodes[gamma + 1] - nodes[gamma],
          std::lerp(web.table_cd(below, gamma), web.table_cd(above, gamma), fraction),
          std::lerp(web.table_cd(below, gamma + 1), web.table_cd(above, gamma + 1), fraction)};
}

// The last i with prefix(i) <= target < prefix(i + 1) among `count` ascending sums; when rounding
// put the target at or above the total, the last interval that holds anything. Never an interval of
// no mass, unless all are.
template <class Prefix>
std::size_t interval_with_mass(std::size_t count, double target, Prefix prefix) {
  std::size_t low = 0;  // prefix(low) <= target
  std::size_t high = count - 1;
  if (!(target < prefix(high))) {
    const double total = prefix(high);
    while (high > 1 && !(prefix(high - 1) < total)) --high;
    return high - 1;
  }
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (prefix(middle) <= target ? low : high) = middle;
  }
  return low;
}

}  // namespace

WebSampler::WebSampler(const PhotometricWeb& web) : web_(web) {
  const std::size_t planes = web.c_rad().size();
  const std::size_t gammas = web.gamma_rad().size();
  gamma_prefix_.reserve(planes * gammas);
  for (std::size_t plane = 0; plane < planes; ++plane) {
    gamma_prefix_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < gammas; ++i) {
      gamma_prefix_.push_back(gamma_prefix_.back() +
                              integral(segment_at(web, plane, plane, 0.0, i)));
    }
  }
  c_prefix_.push_back(0.0);
  if (web.is_axial()) c_prefix_.push_back(2.0 * kPi * plane_total(0));
  for (std::size_t plane = 0; plane + 1 < planes; ++plane) {
    const double width = web.c_rad()[plane + 1] - web.c_rad()[plane];
    c_prefix_.push_back(c_prefix_.back() +
                        0.5 * width * (plane_total(plane) + plane_total(plane + 1)));
  }
}

std::array<double, 3> WebSampler::sample(double u0, double u1) const {
  double c_turns = u0;
  double gamma = 0.0;
  if (web_.is_axial()) {
    gamma = sample_gamma_rad({0, 0, 0.0}, u1);
  } else {
    const double target = u0 * c_prefix_.back();
    const std::size_t i =
        interval_with_mass(c_prefix_.size(), target, [&](std::size_t k) { return c_prefix_[k]; });
    const double share = (target - c_prefix_[i]) / (c_prefix_[i + 1] - c_prefix_[i]);
    const double fraction =
        invert_linear_density(plane_total(i), plane_total(i + 1), std::clamp(share, 0.0, 1.0));
    c_turns = std::lerp(web_.c_rad()[i], web_.c_rad()[i + 1], fraction) / (2.0 * kPi);
    Plane plane{i, i + 1, fraction};
    // On a dark plane next to a lit one the limit of gamma's distribution is that of the lit one.
    if (prefix(plane, web_.gamma_rad().size() - 1) <= 0.0)
      plane.fraction = plane_total(i) > 0.0 ? 0.0 : 1.0;
    gamma = sample_gamma_rad(plane, u1);
  }
  const double across = calc::sin(gamma);
  const SineCosine c = sine_cosine_of_turns(c_turns);
  return web_.from_table({across * c.cosine, across * c.sine, -calc::cos(gamma)});
}

double WebSampler::prefix(const Plane& plane, std::size_t gamma) const {
  const std::size_t columns = web_.gamma_rad().size();
  return std::lerp(gamma_prefix_[plane.below * columns + gamma],
                   gamma_prefix_[plane.above * columns + gamma], plane.fraction);
}

double WebSampler::plane_total(std::size_t plane) const {
  return gamma_prefix_[(plane + 1) * web_.gamma_rad().size() - 1];
}

double WebSampler::sample_gamma_rad(const Plane& plane, double u) const {
  const std::size_t count = web_.gamma_rad().size();
  const double target = u * prefix(plane, count - 1);
  const std::size_t i =
      interval_with_mass(count, target, [&](std::size_t k) { return prefix(plane, k); });
  const SineSegment segment = segment_at(web_, plane.below, plane.above, plane.fraction, i);
  return segment.gamma_rad + invert_integral(segment, target - prefix(plane, i));
}

}  // namespace calc
