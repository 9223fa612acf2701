// GR outdoors: by hand, by a second calculation, and what its interval holds.
#include "calc/glare/field_glare.h"

#include "calc/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace calc::field_glare_test {
namespace {

const glm::dvec3 kEye(0.0, 0.0, kFieldEye_m);
const std::vector<glm::dvec3> kOrigin{{0.0, 0.0, 0.0}};

// Points of 60000 cd to all sides.
struct Site {
  Project project;

  explicit Site(const std::vector<glm::dvec3>& places_m, double cd = 60000.0) {
    project.webs.push_back(PhotometricWeb::make({0.0}, {0.0, kPi}, {cd, cd}, {}, {}));
    LuminaireType type;
    type.web = 0;
    project.luminaire_types.push_back(type);
    Space space;
    for (const glm::dvec3& place : places_m) {
      Luminaire luminaire;
      luminaire.position_m = place;
      luminaire.world_from_luminaire = glm::dmat3(1.0);
      luminaire.group = "g";
      space.luminaires.push_back(luminaire);
    }
    project.spaces.push_back(space);
  }

  Estimate veiling(const std::vector<glm::dvec3>& points_m = kOrigin,
                   const glm::dvec3& along = {1, 0, 0}, const LightScene* scene = nullptr) const {
    return field_veiling(project, project.spaces[0], scene, points_m, along);
  }
};

// Seen from the eye.
glm::dvec3 place(double azimuth_deg, double elevation_deg, double distance_m = 50.0) {
  const double a = radians_from_degrees(azimuth_deg), e = radians_from_degrees(elevation_deg);
  return kEye +
         distance_m * glm::dvec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
}

// By hand: 12 degrees from the line of sight, 23.4755 lx at the eye.
TEST(FieldGlare, IsTheFormula) {
  const Estimate veiling = Site({place(0.0, 10.0)}).veiling();
  EXPECT_NEAR(veiling.value, 1.6302, 5e-5);
  EXPECT_EQ(veiling.low, veiling.value);
  EXPECT_NEAR(veiling.high, veiling.value, 1e-12);
  EXPECT_NEAR(field_glare(1.6302, 200.0, 0.20), 39.68, 0.005);
  EXPECT_NEAR(field_glare(1.6302, 200.0, 0.25), 37.58, 0.005);
  // Dimmed by k, veil and field.
  EXPECT_NEAR(field_glare(0.8 * 1.6302, 0.8 * 200.0, 0.2) - field_glare(1.6302, 200.0, 0.2),
              2.4 * std::log10(0.8), 1e-12);
  EXPECT_EQ(field_glare(0.0, 200.0, 0.2), -std::numeric_limits<double>::infinity());
}

// The worst eye of all points, and of all directions that all sources together are worst in.
TEST(FieldGlare, IsOfTheWorstEye) {
  const double near = Site({place(0.0, 10.0)}).veiling().value;
  EXPECT_NEAR(Site({place(90.0, 10.0)}).veiling().value, near, 1e-9);
  EXPECT_NEAR(Site({place(0.0, 10.0), place(180.0, 10.0)}).veiling().value, near, 1e-9);
  EXPECT_NEAR(Site({place(0.0, 10.0), place(0.0, 10.0)}).veiling().value, 2.0 * near, 1e-9);
  const std::vector<glm::dvec3> two{{0, 0, 0}, {-500, 0, 0}};
  EXPECT_NEAR(Site({place(0.0, 10.0)}).veiling(two).value, near, 1e-9);
  // The first direction is along the field.
  const double c = std::cos(radians_from_degrees(20.0)), s = std::sin(radians_from_degrees(20.0));
  EXPECT_NEAR(Site({place(20.0, 10.0)}).veiling(kOrigin, {c, s, 0}).value, near, 1e-9);
  EXPECT_LT(Site({place(20.0, 10.0)}).veiling().value, 0.9 * near);
}

TEST(FieldGlare, HoldsAllReadings) {
  // Between two of eight directions, on one of 24.
  const Estimate between = Site({place(15.0, 10.0)}).veiling();
  EXPECT_LT(between.value, 0.7 * between.high);
  EXPECT_NEAR(between.high, Site({place(0.0, 10.0)}).veiling().value, 1e-9);
  // Beyond 60 degrees; behind the eye there is nothing.
  const Estimate high_up = Site({place(0.0, 70.0)}).veiling();
  EXPECT_EQ(high_up.value, 0.0);
  EXPECT_GT(high_up.high, 0.0);
  EXPECT_EQ(Site({place(0.0, 90.0)}).veiling().high, 0.0);
  // In the line of sight.
  const Estimate straight = Site({place(0.0, -1.0)}).veiling();
  EXPECT_NEAR(straight.high / straight.value, 2.25, 1e-6);
}

// What may stand between makes the lower end open.
TEST(FieldGlare, KnowsWhatMayHideLuminaires) {
  Site site({place(0.0, 10.0)});
  Body low;
  low.vertex_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, kFieldEye_m}};
  site.project.spaces[0].bodies.push_back(low);
  EXPECT_GT(site.veiling().low, 0.0);
  site.project.spaces[0].bodies[0].vertex_m[2].z = kFieldEye_m + 0.01;
  EXPECT_EQ(site.veiling().low, 0.0);
  EXPECT_GT(site.veiling().value, 0.0);
}

// A luminaire below the eye is hidden by what is lower, too, and one in the eye is worst of all.
TEST(FieldGlare, KnowsLuminairesThatAreNotAbove) {
  Site site({place(0.0, -5.0, 10.0)});
  Body low;
  low.vertex_m = {{5, 0, 0}, {5, 1, 0}, {5, 0, kFieldEye_m - 0.1}};
  site.project.spaces[0].bodies.push_back(low);
  EXPECT_EQ(site.veiling().low, 0.0);
  EXPECT_GT(site.veiling().value, 0.0);
  EXPECT_EQ(Site({kEye}).veiling().high, std::numeric_limits<double>::infinity());
}

TEST(FieldGlare, FollowsScenesAndFlux) {
  Site site({place(0.0, 10.0)});
  const double full = site.veiling().value;
  LightScene half;
  half.level_of_group = {{"g", 0.5}};
  EXPECT_NEAR(site.veiling(kOrigin, {1, 0, 0}, &half).value, 0.5 * full, 1e-12);
  half.level_of_group = {{"g", 0.0}};
  EXPECT_EQ(site.veiling(kOrigin, {1, 0, 0}, &half).high, 0.0);
  site.project.luminaire_types[0].flux_scale = 2.0;
  EXPECT_NEAR(site.veiling().value, 2.0 * full, 1e-12);
}

// Once more from angles alone, for fields at random.
TEST(FieldGlare, AgreesWithASecondCalculation) {
  std::mt19937 random(112);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random);
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<glm::dvec3> places_m, points_m;
    for (int i = 0; i < 6; ++i)
      places_m.emplace_back(between(-60, 60), between(-60, 60), between(8, 25));
    for (int i = 0; i < 5; ++i) points_m.emplace_back(between(-30, 30), between(-30, 30), 0.0);
    double expected = 0.0;
    for (const glm::dvec3& point : points_m) {
      for (int turn = 0; turn < 360; turn += 45) {
        double sum = 0.0;
        for (const glm::dvec3& source : places_m) {
          const double x = source.x - point.x, y = source.y - point.y, z = source.z - kFieldEye_m;
          const double azimuth = std::atan2(y, x) - turn * kPi / 180.0;
          const double elevation = std::atan2(z, std::hypot(x, y));
          const double down = kFieldLook_deg * kPi / 180.0;
          // Spherical law of cosines.
          const double theta = std::acos(std::sin(elevation) * std::sin(-down) +
                                         std::cos(elevation) * std::cos(-down) * std::cos(azimuth));
          const double theta_deg = theta * 180.0 / kPi;
          if (theta_deg > 60.0) continue;
          sum += 10.0 * 60000.0 * std::cos(theta) / (x * x + y * y + z * z) /
                 std::pow(std::max(1.5, theta_deg), 2);
        }
        expected = std::max(expected, sum);
      }
    }
    const Estimate veiling = Site(places_m).veiling(points_m);
    EXPECT_NEAR(veiling.value, expected, 1e-9 * expected) << round;
    EXPECT_LE(veiling.value, veiling.high);
  }
}

}  // namespace
}  // namespace calc::field_glare_test
