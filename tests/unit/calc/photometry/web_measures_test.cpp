#include "calc/photometry/web_measures.h"

#include "tests/support/web_changes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace calc::web_measures_test {
namespace {

using test_support::angle_steps;
using test_support::make_web;

double deg(double rad) { return degrees_from_radians(rad); }

using test_support::lateral_web;

TEST(PeakOf, FindsTheBrightestTableAngle) {
  const Peak peak =
      peak_of(make_web(angle_steps(0, 360, 15), angle_steps(0, 90, 5),
                       [](double c, double g) { return c == 210 && g == 35 ? 9 : 2; }));
  EXPECT_DOUBLE_EQ(peak.intensity_cd, 9.0);
  EXPECT_NEAR(deg(peak.c_rad), 210.0, 1e-9);
  EXPECT_NEAR(deg(peak.gamma_rad), 35.0, 1e-9);
}

TEST(PeakOf, TakesTheSmallestAnglesOfEqualOnes) {
  const Peak peak =
      peak_of(make_web(angle_steps(0, 360, 90), angle_steps(0, 90, 10), [](double c, double g) {
        return (c == 90 || c == 270) && (g == 40 || g == 60) ? 5 : 1;
      }));
  EXPECT_NEAR(deg(peak.c_rad), 90.0, 1e-9);
  EXPECT_NEAR(deg(peak.gamma_rad), 40.0, 1e-9);
}

TEST(PeakOf, HasNoCAtAPole) {
  const Peak peak = peak_of(make_web(angle_steps(0, 360, 45), angle_steps(0, 180, 10),
                                     [](double, double g) { return g; }));
  EXPECT_DOUBLE_EQ(peak.c_rad, 0.0);
  EXPECT_NEAR(deg(peak.gamma_rad), 180.0, 1e-9);
}

// Linear from 100 at nadir to 0 at 80 degrees: half at 40, a tenth at 72.
TEST(BeamWidth, IsExactForALinearBeam) {
  const PhotometricWeb web =
      make_web({0}, {0, 80, 90}, [](double, double g) { return g < 80 ? 100.0 - 1.25 * g : 0.0; });
  const BeamWidth beam = beam_width(web, 0.0, 0.5);
  EXPECT_EQ(beam.lobes, 1);
  EXPECT_NEAR(deg(beam.lobe_rad), 80.0, 1e-9);
  EXPECT_NEAR(deg(beam.span_rad), 80.0, 1e-9);
  EXPECT_NEAR(deg(beam.from_rad), -40.0, 1e-9);
  EXPECT_NEAR(deg(beam_width(web, 1.0, 0.1).span_rad), 144.0, 1e-9);
}

// The other plane pair is brighter, and its own maximum counts in each.
TEST(BeamWidth, TakesTheMaximumOfItsOwnPlanePair) {
  const PhotometricWeb web =
      make_web(angle_steps(0, 360, 90), {0, 30, 60, 90}, [](double c, double g) {
        const bool across = c == 90 || c == 270;
        if (g == 0) return 100.0;
        if (g == 30) return across ? 1000.0 : 50.0;
        return 0.0;
      });
  EXPECT_NEAR(deg(beam_width(web, 0.0, 0.5).span_rad), 60.0, 1e-9);
  const BeamWidth across = beam_width(web, 0.5 * kPi, 0.5);
  EXPECT_EQ(across.lobes, 2);  // 100 at nadir is less than 500
  const double inner = 30.0 * 400.0 / 900.0;
  EXPECT_NEAR(deg(across.lobe_rad), 45.0 - inner, 1e-9);
  EXPECT_NEAR(deg(across.span_rad), 90.0, 1e-9);
  EXPECT_NEAR(deg(across.from_rad), inner, 1e-9);
}

TEST(BeamWidth, CountsAnAsymmetricBeamOnBothSidesOfNadir) {
  const PhotometricWeb web =  // C0: half at 30; C180: half at 10
      make_web(angle_steps(0, 360, 180), {0, 10, 20, 60, 90}, [](double c, double g) {
        if (c == 180) return g == 0 ? 100.0 : g == 10 ? 50.0 : 0.0;
        return g == 0 ? 100.0 : g == 10 ? 250.0 / 3 : g == 20 ? 200.0 / 3 : 0.0;
      });
  const BeamWidth beam = beam_width(web, 0.0, 0.5);
  EXPECT_NEAR(deg(beam.from_rad), -10.0, 1e-9);
  EXPECT_NEAR(deg(beam.to_rad), 30.0, 1e-9);
}

TEST(BeamWidth, EndsWhereTheTableIsCutOff) {
  const PhotometricWeb web = make_web({0}, {0, 65}, [](double, double) { return 10.0; });
  EXPECT_NEAR(deg(beam_width(web, 0.0, 0.5).span_rad), 130.0, 1e-9);
}

TEST(BeamWidth, OfAnUplightLiesAroundTheZenith) {
  const PhotometricWeb web = make_web({0}, {90, 140, 180}, [](double, double g) {
    return g == 180 ? 100.0 : g == 140 ? 50.0 : 0.0;
  });
  const BeamWidth beam = beam_width(web, 0.0, 0.5);
  EXPECT_EQ(beam.lobes, 1);
  EXPECT_NEAR(deg(beam.lobe_rad), 80.0, 1e-9);
  EXPECT_NEAR(deg(beam.from_rad), 140.0, 1e-9);
  EXPECT_NEAR(deg(beam.to_rad), 220.0, 1e-9);
}

TEST(BeamWidth, OfLightEverywhereIsTheFullCircle) {
  const PhotometricWeb web = make_web({0}, {0, 180}, [](double, double) { return 3.0; });
  EXPECT_NEAR(deg(beam_width(web, 0.0, 0.5).span_rad), 360.0, 1e-9);
}

TEST(BeamWidth, OfADarkPlanePairHasNoLobe) {
  const PhotometricWeb web = make_web(angle_steps(0, 360, 45), {10, 60},
                                      [](double c, double) { return c == 45 ? 1.0 : 0.0; });
  EXPECT_EQ(beam_width(web, 0.0, 0.5).lobes, 0);
  EXPECT_EQ(beam_width(web, 0.5 * kPi, 0.5).span_rad, 0.0);
}

TEST(SymmetryFit, FindsEachSymmetryAndNoHigherOne) {
  const auto found = [](const test_support::Light& light) {
    return symmetry_within(
        symmetry_fit(make_web(angle_steps(0, 360, 15), angle_steps(0, 90, 10), light)),
        kExactSymmetry);
  };
  using test_support::crooked_light;
  const auto about_c0 = test_support::symmetric_about_c0(crooked_light);
  const auto about_c90 = test_support::symmetric_about_c90(crooked_light);
  EXPECT_EQ(found(crooked_light), PlaneSymmetry::none);
  EXPECT_EQ(found(about_c0), PlaneSymmetry::c0_c180);
  EXPECT_EQ(found(about_c90), PlaneSymmetry::c90_c270);
  EXPECT_EQ(found(test_support::batwing), PlaneSymmetry::quadrant);
  EXPECT_EQ(found(test_support::narrow_spot), PlaneSymmetry::axial);
}

TEST(SymmetryFit, IsTheLargestDifferenceOverTheMaximum) {
  const SymmetryFit fit = symmetry_fit(
      make_web(angle_steps(0, 360, 30), angle_steps(0, 90, 10), [](double c, double g) {
        return (g == 40 ? 100.0 : 80.0) - (c == 30 && g == 40 ? 2.0 : 0.0);
      }));
  EXPECT_NEAR(fit.axial, 0.02, 1e-12);
  EXPECT_NEAR(fit.c0_c180, 0.02, 1e-12);
  EXPECT_EQ(symmetry_within(fit, 0.019), PlaneSymmetry::none);
  EXPECT_EQ(symmetry_within(fit, 0.021), PlaneSymmetry::axial);
}

TEST(DownwardShare, IsTheFluxBelowTheHorizon) {
  EXPECT_NEAR(downward_share(make_web({0}, {0, 180}, [](double, double) { return 7.0; })), 0.5,
              1e-12);
  EXPECT_DOUBLE_EQ(downward_share(make_web({0}, {0, 90}, [](double, double) { return 7.0; })), 1.0);
  EXPECT_DOUBLE_EQ(downward_share(make_web({0}, {90, 180}, [](double, double) { return 7.0; })),
                   0.0);
}

TEST(MeasureAngles, AreTheTablesOwnWithoutTheSecondC0) {
  const MeasureAngles angles =
      measure_angles(make_web(angle_steps(0, 360, 90), {0, 20, 90}, test_support::batwing));
  EXPECT_EQ(angles.c_rad.size(), 4u);
  EXPECT_EQ(angles.gamma_rad.size(), 3u);
}

// Type B: one direction, H -10 V 20, stands out; it is between whole degrees of C and gamma.
TEST(PeakOf, IsThatOfTheTableAboutAnotherAxis) {
  const PhotometricWeb web =
      lateral_web([](double v, double h) { return v == 20 && h == -10 ? 900.0 : 100.0; });
  const Peak peak = peak_of(web);
  EXPECT_NEAR(peak.intensity_cd, 900.0, 1e-9);
  EXPECT_NEAR(std::cos(peak.gamma_rad), test_support::cos_deg(10) * test_support::cos_deg(20),
              1e-9);
  EXPECT_NEAR(std::tan(peak.c_rad),
              test_support::sin_deg(10) / (test_support::cos_deg(10) * test_support::sin_deg(20)),
              1e-9);
}

TEST(PeakOf, IsNadirWithoutCForAnotherAxis) {
  const Peak peak =
      peak_of(lateral_web([](double v, double h) { return v == 0 && h == 0 ? 900.0 : 100.0; }));
  EXPECT_EQ(peak.intensity_cd, 900.0);
  EXPECT_EQ(peak.gamma_rad, 0.0);
  EXPECT_EQ(peak.c_rad, 0.0);
}

// Across the planes of type B the table's own angle V is that of the plane C0-C180, and H that of
// C90-C270.
TEST(BeamWidth, OfATableAboutAnotherAxis) {
  const PhotometricWeb web = lateral_web([](double v, double h) {
    return std::max(0.0, 1.0 - std::abs(v) / 40.0) * std::max(0.0, 1.0 - std::abs(h) / 20.0);
  });
  EXPECT_NEAR(deg(beam_width(web, 0.0, 0.5).span_rad), 40.0, 0.01);
  EXPECT_NEAR(deg(beam_width(web, 0.5 * kPi, 0.5).span_rad), 20.0, 0.01);
  EXPECT_NEAR(downward_share(web), 1.0, 1e-9);
  const SymmetryFit fit = symmetry_fit(web);
  EXPECT_LT(fit.c0_c180, 1e-9);
  EXPECT_LT(fit.c90_c270, 1e-9);
  EXPECT_GT(fit.axial, 0.1);
}

double narrowest(const std::vector<double>& c_deg, const std::vector<double>& gamma_deg,
                 const std::function<double(double, double)>& cd) {
  return deg(narrowest_beam_rad(make_web(c_deg, gamma_deg, cd)));
}

TEST(NarrowestBeam, OfWideLightIsNone) {
  const auto gamma = angle_steps(0, 90, 5);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(
      narrowest({0}, gamma, [](double, double g) { return std::cos(radians_from_degrees(g)); }),
      inf);
  EXPECT_EQ(narrowest({0}, gamma, [](double, double g) { return g <= 60 ? 1.0 : 0.0; }), inf)
      << "a sharp edge is no narrow beam";
  EXPECT_EQ(narrowest({0}, gamma, [](double, double g) { return g == 20 ? 1.0005 : 1.0; }), inf);
}

TEST(NarrowestBeam, IsAboutItsHalfWidth) {
  for (const double half : {0.5, 1.0, 2.0, 5.0, 8.0}) {
    const auto top_hat = [half](double, double g) { return g <= half ? 1.0 : 0.0; };
    const double found = narrowest({0}, angle_steps(0, 90, 0.1), top_hat);
    EXPECT_GT(found, 0.5 * half);
    EXPECT_LT(found, 1.2 * half);
  }
}

TEST(NarrowestBeam, OfASpikeInWideLightIsTheSpikes) {
  const double along_gamma = narrowest({0}, angle_steps(0, 90, 0.5), [](double, double g) {
    return std::abs(g - 40.0) <= 1.0 ? 10.0 : 1.0;
  });
  EXPECT_LT(along_gamma, 4.0);
  const double along_c =
      narrowest(angle_steps(0, 360, 2), angle_steps(0, 90, 5),
                [](double c, double g) { return c == 90 && g > 20 ? 10.0 : 1.0; });
  EXPECT_LT(along_c, 4.0);
  EXPECT_GT(along_c, 0.25);
}

}  // namespace
}  // namespace calc::web_measures_test
