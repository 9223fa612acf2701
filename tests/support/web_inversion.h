#pragma once
// WebSampler backwards, from its sums: for round trips.

#include "calc/base/units.h"
#include "calc/photometry/sine_segment.h"
#include "calc/photometry/web_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace calc {

class WebInversion {
 public:
  // The sampler must outlive it.
  explicit WebInversion(const WebSampler& sampler) : sampler_(sampler), web_(sampler.web()) {}

  // The (u0, u1) that sample() turns into this direction. Directions outside the table give u1 = 0
  // or 1; a pole of the table counts as C = 0; u1 = 0 where nothing is emitted at that C.
  std::array<double, 2> operator()(const std::array<double, 3>& direction) const {
    const WebAngles angles = angles_of(web_.to_table(direction));
    if (web_.is_axial())
      return {angles.c_rad / (2.0 * kPi), invert_gamma({0, 0, 0.0}, angles.gamma_rad)};
    const std::vector<double>&c = web_.c_rad(), &sums = sampler_.c_prefix();
    const std::size_t i = interval_of(c, angles.c_rad), last = web_.gamma_rad().size() - 1;
    const double width = c[i + 1] - c[i];
    const double fraction = std::clamp((angles.c_rad - c[i]) / width, 0.0, 1.0);
    const double start = prefix({i, i, 0.0}, last), middle = prefix({i, i + 1, fraction}, last);
    const double below = sums[i] + 0.5 * width * fraction * (start + middle);
    return {below / sums.back(), invert_gamma({i, i + 1, fraction}, angles.gamma_rad)};
  }

 private:
  // Between two planes of the table, so far from the one below to the one above.
  struct Plane {
    std::size_t below, above;
    double fraction;
  };

  double prefix(const Plane& plane, std::size_t gamma) const {
    const std::size_t columns = web_.gamma_rad().size();
    const std::vector<double>& sums = sampler_.gamma_prefix();
    return std::lerp(sums[plane.below * columns + gamma], sums[plane.above * columns + gamma],
                     plane.fraction);
  }
  double between_cd(const Plane& plane, std::size_t gamma) const {
    return std::lerp(web_.table_cd(plane.below, gamma), web_.table_cd(plane.above, gamma),
                     plane.fraction);
  }
  double invert_gamma(const Plane& plane, double gamma_rad) const {
    const std::vector<double>& nodes = web_.gamma_rad();
    const double total = prefix(plane, nodes.size() - 1);
    if (!(total > 0.0) || gamma_rad <= nodes.front()) return 0.0;
    if (gamma_rad >= nodes.back()) return 1.0;
    const std::size_t i = interval_of(nodes, gamma_rad);
    const SineSegment segment{nodes[i], nodes[i + 1] - nodes[i], between_cd(plane, i),
                              between_cd(plane, i + 1)};
    return (prefix(plane, i) + integral_to(segment, gamma_rad - nodes[i])) / total;
  }

  const WebSampler& sampler_;
  const PhotometricWeb& web_;
};

}  // namespace calc
