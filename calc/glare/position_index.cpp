#include "calc/glare/position_index.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

constexpr double kBinaryNoise = 1.0e-9;
constexpr glm::dvec3 kUp{0.0, 0.0, 1.0};

}  // namespace

SeenAt::SeenAt(const glm::dvec3& to_source, const glm::dvec3& look)
    : along_m(glm::dot(to_source, look)),
      sideways(glm::length(glm::cross(look, to_source - to_source.z * kUp)) / along_m),
      upwards(to_source.z / along_m) {}

bool SeenAt::is_in_field() const {
  return along_m > 0.0 && sideways <= kWidestSource + kBinaryNoise &&
         upwards < kHighestSource - kBinaryNoise && upwards >= -kHighestSource - kBinaryNoise;
}

bool SeenAt::is_on_table() const {
  return is_in_field() && !is_below() &&
         upwards <= highest_on_table(sideways + kBinaryNoise) + kBinaryNoise;
}

double SeenAt::share_of_field() const {
  return std::max(sideways / kWidestSource, std::abs(upwards) / kHighestSource);
}

bool SeenAt::is_below() const { return along_m > 0.0 && upwards < -kBinaryNoise; }

double highest_on_table(double sideways) {
  if (sideways < 0.4) return 1.7;
  return sideways < 0.9 ? 1.8 : 1.9;
}

std::optional<double> guth_index(const glm::dvec3& to_source, const glm::dvec3& look) {
  const SeenAt seen(to_source, look);
  if (!seen.is_in_field() || seen.is_below()) return std::nullopt;
  const double upwards = std::max(0.0, seen.upwards);
  const double s = degrees_from_radians(calc::atan(calc::hypot(seen.sideways, upwards)));
  const double t = degrees_from_radians(calc::atan2(seen.sideways, upwards));
  return calc::exp((35.2 - 0.31889 * t - 1.22 * calc::exp(-2.0 * t / 9.0)) * 1.0e-3 * s +
                   (21.0 + 0.26667 * t - 0.002963 * t * t) * 1.0e-5 * s * s);
}

std::optional<double> iwata_index(const glm::dvec3& to_source, const glm::dvec3& look) {
  constexpr double kSteeper = 0.6, kFarthest = 3.0;
  const SeenAt seen(to_source, look);
  if (!seen.is_in_field() || !seen.is_below()) return std::nullopt;
  const double r = std::min(kFarthest, calc::hypot(seen.sideways, seen.upwards));
  return 1.0 + (r > kSteeper ? 1.2 : 0.8) * r;
}

}  // namespace calc
