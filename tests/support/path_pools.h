#pragma once
// Two pools of light vertices that should be one: by the CPU and by OpenGL.

#include "calc/radiosity/paths/light_vertex.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace test_support {

struct PoolDifference {
  std::size_t matched = 0, unmatched = 0;  // unmatched: of both pools
  double largest_m = 0.0;                  // distance of matched vertices
  double largest_flux = 0.0;               // relative
  std::size_t same_bits = 0;               // of the matched
  double unmatched_share() const {
    return static_cast<double>(unmatched) / static_cast<double>(2 * matched + unmatched);
  }
};

struct PoolTolerance {
  double position_m;
  double flux = 1e-6;
};

inline bool is_same_vertex(const calc::LightVertex& a, const calc::LightVertex& b,
                           const PoolTolerance& tolerance) {
  return glm::distance(glm::dvec3(a.position_m), glm::dvec3(b.position_m)) <=
             tolerance.position_m &&
         std::abs(static_cast<double>(a.flux_lm - b.flux_lm)) <=
             tolerance.flux * static_cast<double>(a.flux_lm) &&
         glm::distance(a.normal, b.normal) <= 1e-6f && a.channel == b.channel;
}

// In order; where one pool has vertices that the other lacks, the two are aligned again.
inline PoolDifference compare_pools(const calc::LightVertices& a, const calc::LightVertices& b,
                                    const PoolTolerance& tolerance) {
  constexpr std::size_t kFarthest = 300;  // more than a chunk has paths
  PoolDifference result;
  std::size_t i = 0, j = 0;
  const auto resynchronise = [&] {
    for (std::size_t skipped = 1; skipped <= 2 * kFarthest; ++skipped) {
      for (std::size_t left = skipped > kFarthest ? skipped - kFarthest : 0;
           left <= std::min(skipped, kFarthest); ++left) {
        const std::size_t right = skipped - left;
        if (i + left >= a.size() || j + right >= b.size()) continue;
        if (!is_same_vertex(a[i + left], b[j + right], tolerance)) continue;
        i += left;
        j += right;
        result.unmatched += skipped;
        return true;
      }
    }
    return false;
  };
  while (i < a.size() && j < b.size()) {
    if (!is_same_vertex(a[i], b[j], tolerance) && !resynchronise()) break;
    ++result.matched;
    if (a[i].position_m == b[j].position_m && a[i].flux_lm == b[j].flux_lm &&
        a[i].normal == b[j].normal) {
      ++result.same_bits;
    }
    const glm::dvec3 pa(a[i].position_m), pb(b[j].position_m);
    result.largest_m = std::max(result.largest_m, glm::distance(pa, pb));
    const auto fa = static_cast<double>(a[i].flux_lm), fb = static_cast<double>(b[j].flux_lm);
    result.largest_flux = std::max(result.largest_flux, std::abs(fa - fb) / fa);
    ++i;
    ++j;
  }
  result.unmatched += a.size() - i + b.size() - j;
  return result;
}

}  // namespace test_support
