#include "calc/photometry/web_resample.h"

#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web_compare.h"
#include "calc/photometry/write/write_eulumdat.h"
#include "calc/photometry/write/write_lm63.h"
#include "tests/support/web_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

namespace calc::web_resample_test {
namespace {

using test_support::cos_deg;
using test_support::lateral_web;
using ::testing::HasSubstr;

// Brighter on one side of every axis, and dark at the edge of the table.
double floodlight(double v, double h) {
  return 1000.0 * std::pow(cos_deg(v) * cos_deg(h), 2) * (1.0 + 0.004 * v + 0.006 * h);
}

TEST(WebResample, SmoothLightStaysTheSame) {
  const PhotometricWeb web = lateral_web(floodlight);
  const std::optional<ResampledWeb> made = resampled_over_c_gamma(web);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->web.axis(), TableAxis::vertical);
  EXPECT_LT(made->largest_share, 0.005);
  EXPECT_NEAR(made->flux_ratio, 1.0, 1e-3);
  EXPECT_EQ(made->web.gamma_rad().back(), 0.5 * kPi) << "nothing above";
  double largest = 0.0;  // by directions that neither table holds
  for (double c = 0.01; c < 6.28; c += 0.0617) {
    for (double gamma = 0.003; gamma < 1.5; gamma += 0.0371) {
      largest = std::max(largest,
                         std::abs(made->web.intensity_cd(c, gamma) - web.intensity_cd(c, gamma)));
    }
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(largest, 1.05 * made->largest_share * web.max_intensity_cd());
}

TEST(WebResample, StepsBecomeFinerWhereTheLightNeedsIt) {
  const auto spot = [](double v, double h) { return v == 10 && h == 35 ? 1000.0 : 0.0; };
  const ResampledWeb fine = resampled_over_c_gamma(lateral_web(spot)).value();
  const ResampledWeb coarse = resampled_over_c_gamma(lateral_web(floodlight)).value();
  EXPECT_EQ(fine.c_step_deg, 1.0);
  EXPECT_EQ(fine.gamma_step_deg, 0.5);
  EXPECT_GE(fine.largest_share, 0.005);
  EXPECT_EQ(fine.web.c_rad().size(), 361u);
  EXPECT_GE(coarse.c_step_deg, 2.5);
  EXPECT_LT(coarse.web.c_rad().size(), 150u);
}

TEST(WebResample, BeamsThatFallBetweenAllAnglesAreRefused) {
  const double beam_rad = 1.0e-4;  // about the direction of V 10.3, H 35.2
  const double v = radians_from_degrees(10.3), gamma = radians_from_degrees(90 + 35.2);
  const PhotometricWeb web = PhotometricWeb::make(
      {0.0, v - beam_rad, v, v + beam_rad, 2.0 * kPi}, {gamma - beam_rad, gamma, gamma + beam_rad},
      {0, 0, 0, 0, 0, 0, 0, 900, 0, 0, 0, 0, 0, 0, 0}, {}, {}, TableAxis::lateral);
  EXPECT_FALSE(resampled_over_c_gamma(web));
  Diagnostics diagnostics;
  EXPECT_FALSE(write_lm63(web, "new", diagnostics));
  EXPECT_FALSE(write_eulumdat(web, "new", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2);
  EXPECT_THAT(test_support::diagnostics_text(diagnostics),
              HasSubstr("new: error[photometry-write-table]"));
}

TEST(WebResample, WritersSayWhatTheyChanged) {
  const PhotometricWeb web = lateral_web(floodlight);
  for (const auto writer : {&write_lm63, &write_eulumdat}) {
    Diagnostics diagnostics;
    const std::optional<std::string> text = writer(web, "new", diagnostics);
    ASSERT_TRUE(text);
    EXPECT_EQ(diagnostics.all().size(), 1u);
    EXPECT_THAT(test_support::diagnostics_text(diagnostics),
                HasSubstr("new: warning[photometry-write-resampled]: the light is tabulated about "
                          "another axis; for "));
    EXPECT_THAT(test_support::diagnostics_text(diagnostics), HasSubstr("% of the maximum, and "));
    const std::optional<PhotometricWeb> read = parse_photometry(*text, "new", diagnostics);
    ASSERT_TRUE(read);
    const WebComparison found = compare_webs(web, *read);
    EXPECT_TRUE(found.fits.front().turn == WebTurn{});
    EXPECT_LT(found.fits.front().largest, 0.006);
    EXPECT_GT(found.fits[found.alike].rms, 0.02);
    EXPECT_NEAR(found.flux_ratio, 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace calc::web_resample_test
