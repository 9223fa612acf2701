#include "report/images/tone_map.h"

#include "calc/base/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace report {
namespace {

constexpr double kKey = 0.36;                   // what the average becomes
constexpr double kWhite = 16.0;                 // averages: the least luminance that is white
constexpr double kLeastAverage = 1e-3;          // cd/m2
constexpr double kTint[] = {1.0, 0.975, 0.93};  // of red, green and blue
constexpr int kSteps = 4096;

double encoded(double linear) {  // sRGB
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * calc::pow(linear, 1.0 / 2.4) - 0.055;
}

std::uint8_t channel(double linear, double tint) {
  return static_cast<std::uint8_t>(std::lround(255.0 * tint * encoded(linear)));
}

}  // namespace

double log_average(std::span<const float> cd_m2) {
  double sum = 0.0;
  std::size_t seen = 0;
  for (const float value : cd_m2) {
    if (!(value >= 0.0F) || std::isinf(value)) continue;
    sum += calc::log(std::max(static_cast<double>(value), kLeastAverage));
    ++seen;
  }
  return seen > 0 ? calc::exp(sum / static_cast<double>(seen)) : 0.0;
}

Rgb toned(double cd_m2, double average) {
  const double white = kKey * kWhite;
  // Far above white all is white; beyond, the squares below would have no number.
  const double key = std::min(2.0 * white, kKey * cd_m2 / std::max(average, kLeastAverage));
  const double linear = std::clamp(key * (1.0 + key / (white * white)) / (1.0 + key), 0.0, 1.0);
  return {channel(linear, kTint[0]), channel(linear, kTint[1]), channel(linear, kTint[2])};
}

Palette tone_palette(double average) {
  const double step = kWhite * std::max(average, kLeastAverage) / (kSteps - 1);
  Palette palette{{}, static_cast<float>(step)};
  for (int k = 0; k < kSteps; ++k) palette.colour.push_back(toned(k * step, average));
  return palette;
}

}  // namespace report
