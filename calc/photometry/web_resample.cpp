#include "calc/photometry/web_resample.h"

#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr double kSameEnough = 0.005;  // of the maximum
constexpr double kDark = 1.0e-12;      // of the maximum: rounding of cosines

struct Steps {
  int per_quarter_of_c, per_quarter_of_gamma;
};
constexpr Steps kSteps[] = {{18, 36}, {36, 90}, {90, 180}};

double quarters_rad(int steps, int per_quarter) {
  return steps == 4 * per_quarter ? 2.0 * kPi : 0.5 * kPi * steps / per_quarter;
}

// Empty if there is no light at any of the angles.
std::optional<PhotometricWeb> sampled(const PhotometricWeb& web, const Steps& steps) {
  std::vector<double> c_rad, gamma_rad;
  for (int i = 0; i <= 4 * steps.per_quarter_of_c; ++i) {
    c_rad.push_back(quarters_rad(i, steps.per_quarter_of_c));
  }
  for (int i = 0; i < 2 * steps.per_quarter_of_gamma; ++i) {
    gamma_rad.push_back(quarters_rad(i, steps.per_quarter_of_gamma));
  }
  gamma_rad.push_back(kPi);
  const std::size_t columns = gamma_rad.size();
  std::vector<double> table;
  table.reserve(c_rad.size() * columns);
  std::size_t lit = 0;  // columns up to the last one with light
  for (std::size_t p = 0; p + 1 < c_rad.size(); ++p) {
    for (std::size_t g = 0; g < columns; ++g) {
      table.push_back(web.intensity_cd(c_rad[p], gamma_rad[g]));
      if (table.back() > kDark * web.max_intensity_cd()) lit = std::max(lit, g + 1);
    }
  }
  table.insert(table.end(), table.begin(), table.begin() + static_cast<std::ptrdiff_t>(columns));
  if (lit == 0) return std::nullopt;
  const auto horizon = static_cast<std::size_t>(steps.per_quarter_of_gamma);
  if (lit <= horizon + 1) {
    std::vector<double> below;
    for (std::size_t p = 0; p < c_rad.size(); ++p) {
      const auto row = table.begin() + static_cast<std::ptrdiff_t>(p * columns);
      below.insert(below.end(), row, row + static_cast<std::ptrdiff_t>(horizon) + 1);
    }
    table = std::move(below);
    gamma_rad.resize(horizon + 1);
  }
  return PhotometricWeb::make(std::move(c_rad), std::move(gamma_rad), std::move(table),
                              web.opening(), web.source());
}

double largest_difference_cd(const PhotometricWeb& web, const PhotometricWeb& made) {
  double largest = 0.0;
  const auto compare = [&](const std::array<double, 3>& direction) {
    largest =
        std::max(largest, std::abs(web.intensity_cd(direction) - made.intensity_cd(direction)));
  };
  for (const double c : web.c_rad()) {
    for (const double gamma : web.gamma_rad()) {
      compare(web.from_table(direction_of({c, gamma})));
    }
  }
  for (std::size_t p = 0; p + 1 < made.c_rad().size(); ++p) {
    for (std::size_t g = 0; g + 1 < made.gamma_rad().size(); ++g) {
      compare(direction_of({0.5 * (made.c_rad()[p] + made.c_rad()[p + 1]),
                            0.5 * (made.gamma_rad()[g] + made.gamma_rad()[g + 1])}));
    }
  }
  return largest;
}

}  // namespace

std::optional<ResampledWeb> resampled_over_c_gamma(const PhotometricWeb& web) {
  std::optional<ResampledWeb> result;
  for (const Steps& steps : kSteps) {
    std::optional<PhotometricWeb> made = sampled(web, steps);
    if (!made) continue;
    const double share = largest_difference_cd(web, *made) / web.max_intensity_cd();
    const double flux_ratio = made->flux_lm() / web.flux_lm();
    result = {std::move(*made), 90.0 / steps.per_quarter_of_c, 90.0 / steps.per_quarter_of_gamma,
              share, flux_ratio};
    if (share < kSameEnough) break;
  }
  return result;
}

}  // namespace calc
