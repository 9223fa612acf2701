#include "calc/photometry/web_hermite.h"

#include "calc/photometry/web_sampling.h"
#include "tests/support/photometry_samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace calc::web_hermite_test {
namespace {

using test_support::angle_steps;
using test_support::batwing;
using test_support::cos_deg;
using test_support::Light;
using test_support::make_web;
using test_support::narrow_spot;
using test_support::sin_deg;
using test_support::wall_washer;

double rms_error(const PhotometricWeb& web, const Light& truth) {
  double sum = 0.0;
  int count = 0;
  for (double c = 0.5; c < 360.0; c += 7.3) {
    for (double gamma = 0.7; gamma < 89.0; gamma += 0.9) {
      const double off =
          web.intensity_cd(radians_from_degrees(c), radians_from_degrees(gamma)) - truth(c, gamma);
      sum += off * off;
      ++count;
    }
  }
  return std::sqrt(sum / count) / web.max_intensity_cd();
}

TEST(HermiteWeb, IsNearerToSmoothLightThanBilinear) {
  struct Case {
    Light light;
    std::vector<double> c_deg, gamma_deg;
  };
  const Light soft_spot = [](double, double g) { return 1000.0 * std::exp(-g * g / 200.0); };
  for (const Case& c : {Case{soft_spot, {0}, angle_steps(0, 90, 5)},
                        Case{batwing, angle_steps(0, 360, 15), angle_steps(0, 90, 5)}}) {
    const PhotometricWeb web = make_web(c.c_deg, c.gamma_deg, c.light);
    EXPECT_LT(rms_error(hermite_refined(web), c.light), 0.6 * rms_error(web, c.light));
  }
}

TEST(HermiteWeb, KeepsTheTabulatedValuesAndNeverOvershoots) {
  const PhotometricWeb web = make_web(angle_steps(0, 360, 30), angle_steps(0, 90, 10), wall_washer);
  const PhotometricWeb fine = hermite_refined(web);
  EXPECT_EQ(fine.max_intensity_cd(), web.max_intensity_cd());
  for (std::size_t p = 0; p < web.c_rad().size(); ++p) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) {
      EXPECT_EQ(fine.table_cd(4 * p, 8 * g), web.table_cd(p, g));
    }
  }
  for (std::size_t p = 0; p + 1 < web.c_rad().size(); ++p) {
    for (std::size_t g = 0; g < fine.gamma_rad().size(); ++g) {
      const double a = fine.table_cd(4 * p, g), b = fine.table_cd(4 * p + 4, g);
      for (std::size_t k = 1; k < 4; ++k) {
        EXPECT_GE(fine.table_cd(4 * p + k, g), std::min(a, b));
        EXPECT_LE(fine.table_cd(4 * p + k, g), std::max(a, b));
      }
    }
  }
}

TEST(HermiteWeb, IsSmoothThroughNadir) {
  const PhotometricWeb fine = hermite_refined(make_web({0}, angle_steps(0, 90, 5), narrow_spot));
  // Level at the top: the first part falls by far less than an eighth of the first step.
  const double first = fine.table_cd(0, 0) - fine.table_cd(0, 1);
  EXPECT_LT(first, 0.06 * (fine.table_cd(0, 0) - fine.table_cd(0, 8)));
}

TEST(HermiteWeb, FluxAndSamplerAgree) {
  for (const Light& light : {Light(narrow_spot), Light(wall_washer), Light(batwing)}) {
    const PhotometricWeb fine =
        hermite_refined(make_web(angle_steps(0, 360, 15), angle_steps(0, 90, 2.5), light));
    EXPECT_NEAR(WebSampler(fine).c_prefix().back(), fine.flux_lm(), 1e-9 * fine.flux_lm());
  }
}

TEST(HermiteWeb, DifferenceIsReported) {
  const PhotometricWeb coarse = make_web({0}, angle_steps(0, 90, 10), narrow_spot);
  const PhotometricWeb fine = make_web({0}, angle_steps(0, 90, 1), batwing);
  EXPECT_GT(interpolation_difference(coarse).largest_share, 0.05);
  EXPECT_LT(interpolation_difference(fine).largest_share, 1e-3);
  const PhotometricWeb even =
      make_web({0}, angle_steps(0, 180, 10), [](double, double) { return 100.0; });
  EXPECT_EQ(interpolation_difference(even).largest_share, 0.0);
  EXPECT_NEAR(interpolation_difference(even).flux_share, 0.0, 1e-12);
}

}  // namespace
}  // namespace calc::web_hermite_test
