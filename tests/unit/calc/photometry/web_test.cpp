#include "calc/photometry/web.h"

#include "tests/support/photometry_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace calc::web_test {
namespace {

using test_support::angle_steps;
using test_support::cos_deg;
using test_support::make_web;

TEST(PhotometricWeb, FluxOfAnIsotropicSourceIsFourPiI) {
  EXPECT_NEAR(make_web({0}, {0, 180}, [](double, double) { return 100.0; }).flux_lm(), 400.0 * kPi,
              1e-10);
  EXPECT_NEAR(make_web(angle_steps(0, 360, 45), angle_steps(0, 180, 7.5),
                       [](double, double) { return 100.0; })
                  .flux_lm(),
              400.0 * kPi, 1e-10);
}

TEST(PhotometricWeb, FluxOfALambertianTableNearsPiI) {
  // A chord of cos lies below it: with steps of h rad the table holds 1 - h^2 / 12 of the light, up
  // to h^4.
  const auto lambert = [](double, double gamma_deg) {
    return gamma_deg < 90 ? cos_deg(gamma_deg) : 0.0;
  };
  for (const double step_deg : {5.0, 1.0, 0.25}) {
    const double h = radians_from_degrees(step_deg);
    const double flux = make_web({0}, angle_steps(0, 90, step_deg), lambert).flux_lm();
    EXPECT_NEAR(flux / kPi, 1.0 - h * h / 12.0, h * h * h * h) << step_deg;
  }
}

TEST(PhotometricWeb, FluxOfACosinePowerNearsItsClosedForm) {
  const auto beam = [](double, double gamma_deg) {
    return gamma_deg < 90 ? 1000.0 * std::pow(cos_deg(gamma_deg), 20) : 0.0;
  };
  EXPECT_NEAR(make_web({0}, angle_steps(0, 90, 0.1), beam).flux_lm() / (2.0 * kPi * 1000.0 / 21.0),
              1.0, 1e-5);
}

TEST(PhotometricWeb, FluxWeighsUnequalPlanesByTheirAngle) {
  // Linear in C between planes at 0, 30, 180, 360: mean over C = (30 * 50 + 150 * 50 + 180 * 0) /
  // 360.
  const auto cd = [](double c_deg, double) { return c_deg == 30.0 ? 100.0 : 0.0; };
  EXPECT_NEAR(make_web({0, 30, 180, 360}, {0, 90, 180}, cd).flux_lm(), 4.0 * kPi * 25.0, 1e-10);
}

TEST(PhotometricWeb, ZonalFluxesAddUp) {
  const PhotometricWeb web =
      make_web(angle_steps(0, 360, 15), angle_steps(0, 180, 10), test_support::batwing);
  const double sum =
      web.zonal_flux_lm(0.0, 0.4) + web.zonal_flux_lm(0.4, 1.7) + web.zonal_flux_lm(1.7, kPi);
  EXPECT_NEAR(sum / web.flux_lm(), 1.0, 1e-13);
  const PhotometricWeb even = make_web({0}, {0, 180}, [](double, double) { return 1.0; });
  EXPECT_NEAR(even.zonal_flux_lm(0.5, 1.0), 2.0 * kPi * (std::cos(0.5) - std::cos(1.0)), 1e-13);
}

// All four main planes differ, so that an exchanged or mirrored axis shows.
PhotometricWeb four_planes() {
  return make_web({0, 90, 180, 270, 360}, {0, 90, 180}, [](double c_deg, double gamma_deg) {
    return gamma_deg == 90.0 ? 10.0 + c_deg / 9.0 : gamma_deg == 0.0 ? 5.0 : 7.0;
  });
}

TEST(PhotometricWeb, AxesAreThoseOfTheConventions) {
  const PhotometricWeb web = four_planes();
  EXPECT_DOUBLE_EQ(web.intensity_cd({1, 0, 0}), 10.0);   // C 0
  EXPECT_DOUBLE_EQ(web.intensity_cd({0, 1, 0}), 20.0);   // C 90
  EXPECT_DOUBLE_EQ(web.intensity_cd({-1, 0, 0}), 30.0);  // C 180
  EXPECT_DOUBLE_EQ(web.intensity_cd({0, -1, 0}), 40.0);  // C 270
  EXPECT_DOUBLE_EQ(web.intensity_cd({0, 0, -1}), 5.0);   // gamma 0, nadir
  EXPECT_DOUBLE_EQ(web.intensity_cd({0, 0, 1}), 7.0);    // gamma 180, zenith
}

TEST(PhotometricWeb, InterpolatesLinearlyInBothAngles) {
  const PhotometricWeb web = four_planes();
  EXPECT_NEAR(web.intensity_cd(radians_from_degrees(45), kPi / 2), 15.0, 1e-12);
  EXPECT_NEAR(web.intensity_cd(radians_from_degrees(315), kPi / 2), 25.0,
              1e-12);  // between 270 and 360
  EXPECT_NEAR(web.intensity_cd(radians_from_degrees(90), radians_from_degrees(30)), 10.0, 1e-12);
  EXPECT_NEAR(web.intensity_cd(radians_from_degrees(45), radians_from_degrees(45)), 10.0, 1e-12);
}

TEST(PhotometricWeb, AnglesAndDirectionsAgree) {
  const PhotometricWeb web = four_planes();
  for (const double c : {0.1, 1.7, 3.0, 4.0, 6.2}) {
    for (const double gamma : {0.01, 0.6, 1.8, 3.1}) {
      const std::array<double, 3> direction{std::sin(gamma) * std::cos(c),
                                            std::sin(gamma) * std::sin(c), -std::cos(gamma)};
      EXPECT_NEAR(web.intensity_cd(direction), web.intensity_cd(c, gamma), 1e-12);
    }
  }
}

TEST(PhotometricWeb, WrapsAnyC) {
  const PhotometricWeb web = four_planes();
  EXPECT_NEAR(web.intensity_cd(-kPi / 2, kPi / 2), 40.0, 1e-12);
  EXPECT_NEAR(web.intensity_cd(2.0 * kPi + 1.0, 1.0), web.intensity_cd(1.0, 1.0), 1e-12);
  EXPECT_DOUBLE_EQ(web.intensity_cd(2.0 * kPi, kPi / 2), 10.0);
}

TEST(PhotometricWeb, TheLastAngleBelongsToTheTableAndNothingBehindIt) {
  const PhotometricWeb web =
      make_web({0}, {20, 60}, [](double, double gamma_deg) { return gamma_deg; });
  EXPECT_DOUBLE_EQ(web.intensity_cd(0.0, radians_from_degrees(60)), 60.0);
  EXPECT_DOUBLE_EQ(web.intensity_cd(0.0, radians_from_degrees(20)), 20.0);
  const double gamma = radians_from_degrees(60);
  EXPECT_NEAR(web.intensity_cd({std::sin(gamma), 0.0, -std::cos(gamma)}), 60.0, 1e-12);
  EXPECT_EQ(web.intensity_cd(0.0, radians_from_degrees(60.000001)), 0.0);
  EXPECT_EQ(web.intensity_cd(0.0, radians_from_degrees(19.999999)), 0.0);
  EXPECT_EQ(web.intensity_cd({0, 0, -1}), 0.0);
}

TEST(PhotometricWeb, ATableEndingAt90LightsTheHorizontal) {
  const PhotometricWeb web = make_web({0}, {0, 90}, [](double, double) { return 8.0; });
  EXPECT_DOUBLE_EQ(web.intensity_cd({1, 0, 0}), 8.0);
  EXPECT_EQ(web.intensity_cd({0.8, 0, 0.6}), 0.0);
}

TEST(PhotometricWeb, PolesOfDisagreeingPlanesGiveTheMeanOverC) {
  const PhotometricWeb web = make_web(
      {0, 30, 180, 360}, {0, 90}, [](double c_deg, double) { return c_deg == 30.0 ? 100.0 : 0.0; });
  EXPECT_NEAR(web.intensity_cd({0, 0, -1}), 25.0, 1e-12);
  EXPECT_NEAR(web.intensity_cd({0, -0.0, -1}), 25.0, 1e-12);
}

TEST(PhotometricWeb, RefusesTablesThatReadersMustNotMake) {
  const auto make = [](std::vector<double> c, std::vector<double> gamma, std::vector<double> cd) {
    return PhotometricWeb::make(std::move(c), std::move(gamma), std::move(cd), {}, {});
  };
  EXPECT_NO_THROW(make({0}, {0, 1}, {1, 1}));
  EXPECT_THROW(make({}, {0, 1}, {}), std::logic_error);
  EXPECT_THROW(make({0.1}, {0, 1}, {1, 1}), std::logic_error);
  EXPECT_THROW(make({0}, {0}, {1}), std::logic_error);
  EXPECT_THROW(make({0}, {0, 4}, {1, 1}), std::logic_error);
  EXPECT_THROW(make({0}, {1, 1}, {1, 1}), std::logic_error);
  EXPECT_THROW(make({0}, {0, 1}, {1, 1, 1}), std::logic_error);
  EXPECT_THROW(make({0}, {0, 1}, {1, -1}), std::logic_error);
  EXPECT_THROW(make({0}, {0, 1}, {0, 0}), std::logic_error);
  EXPECT_THROW(make({0}, {0, 1}, {1, std::numeric_limits<double>::infinity()}), std::logic_error);
  EXPECT_THROW(make({0, 1}, {0, 1}, {1, 1, 1, 1}), std::logic_error);
  EXPECT_THROW(make({0, 1, 2 * kPi}, {0, 1}, {1, 1, 1, 1, 1, 2}), std::logic_error);
}

}  // namespace
}  // namespace calc::web_test
