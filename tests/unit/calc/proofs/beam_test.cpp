#include "calc/proofs/beam.h"

#include "calc/photometry/web_sampling.h"
#include "tests/unit/calc/proofs/proof_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace beam_test {
namespace {

using calc::kPi;
using namespace proof_scenes;

constexpr double kDegree = kPi / 180.0;

double angle_rad(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

calc::PlacedLuminaire at_origin(const calc::PhotometricWeb& web) {
  calc::PlacedLuminaire luminaire;
  luminaire.web = &web;
  luminaire.opening = web.opening();
  return luminaire;
}

bool misses(const calc::PhotometricWeb& web, std::vector<glm::dvec3> corners) {
  return calc::beam_misses(calc::beam_of(web), at_origin(web), corners, {1.0e-6, 1.0e-6});
}

// Lit for gamma in 40 to 50 degrees and C in from..to.
calc::PhotometricWeb patch_web(double from_c, double to_c) {
  std::vector<double> c_rad, gamma_rad, cd;
  for (int c = 0; c <= 360; c += 10) c_rad.push_back(c == 360 ? 2.0 * kPi : c * kDegree);
  for (int g = 0; g <= 180; g += 10) gamma_rad.push_back(g * kDegree);
  gamma_rad.back() = kPi;
  for (int c = 0; c <= 360; c += 10) {
    for (int g = 0; g <= 180; g += 10) {
      cd.push_back(c % 360 >= from_c && c % 360 <= to_c && g >= 40 && g <= 50 ? 100.0 : 0.0);
    }
  }
  return calc::PhotometricWeb::make(c_rad, gamma_rad, cd, {}, {});
}

TEST(Beam, ReachesToTheFirstDarkEntryNotToTheLastLitOne) {
  const calc::Beam beam = calc::beam_of(spot_web(8.0, 10.0));
  EXPECT_NEAR(beam.half_angle_rad, 10.0 * kDegree, 1e-12);
  EXPECT_EQ(beam.axis, glm::dvec3(0, 0, -1));
}

TEST(Beam, OfAnUplightPointsUp) {
  const auto web = calc::PhotometricWeb::make({0.0}, {0.0, kPi / 2, 150.0 * kDegree, kPi},
                                              {0.0, 0.0, 0.0, 50.0}, {}, {});
  const calc::Beam beam = calc::beam_of(web);
  EXPECT_EQ(beam.axis, glm::dvec3(0, 0, 1));
  EXPECT_NEAR(beam.half_angle_rad, 30.0 * kDegree, 1e-12);
}

TEST(Beam, OfAnIsotropicSourceIsTheSphere) {
  EXPECT_DOUBLE_EQ(calc::beam_of(test_support::isotropic_web(1.0)).half_angle_rad, kPi);
}

TEST(Beam, OfAOneSidedTableFollowsItsSide) {
  const calc::Beam beam = calc::beam_of(patch_web(80, 100));
  EXPECT_GT(beam.axis.y, 0.5);
  EXPECT_NEAR(beam.axis.x, 0.0, 1e-9);
  EXPECT_LT(beam.half_angle_rad, 30.0 * kDegree);
}

// The same patch in a table about the line of C90.
TEST(Beam, OfATableAboutAnotherAxisTurnsWithIt) {
  const calc::PhotometricWeb upright = patch_web(0, 30);
  std::vector<double> cd;
  for (std::size_t p = 0; p < upright.c_rad().size(); ++p) {
    for (std::size_t g = 0; g < upright.gamma_rad().size(); ++g) {
      cd.push_back(upright.table_cd(p, g));
    }
  }
  const auto lateral = calc::PhotometricWeb::make(upright.c_rad(), upright.gamma_rad(), cd, {}, {},
                                                  calc::TableAxis::lateral);
  const calc::Beam beam = calc::beam_of(lateral);
  EXPECT_NEAR(beam.half_angle_rad, calc::beam_of(upright).half_angle_rad, 1e-12);
  EXPECT_LT(beam.half_angle_rad, 0.5 * kPi);
  int lit = 0;
  for (int c = 0; c < 360; c += 3) {
    for (int g = 0; g <= 180; g += 3) {
      const auto d = calc::direction_of({c * kDegree, g * kDegree});
      if (lateral.intensity_cd(d) <= 0.0) continue;
      ++lit;
      EXPECT_LE(angle_rad(beam.axis, {d[0], d[1], d[2]}), beam.half_angle_rad) << c << " " << g;
    }
  }
  EXPECT_GT(lit, 20);
}

TEST(Beam, HoldsEveryDirectionWithLight) {
  std::mt19937 random(7);
  for (const auto& web : {patch_web(0, 40), patch_web(80, 100), patch_web(200, 350),
                          patch_web(30, 300), spot_web(8, 9), test_support::lambert_web(9, 18)}) {
    const calc::Beam beam = calc::beam_of(web);
    double widest = 0.0;
    for (int k = 0; k < 200000; ++k) {
      const glm::dvec3 d = random_unit(random);
      if (web.intensity_cd({d.x, d.y, d.z}) > 0.0)
        widest = std::max(widest, angle_rad(beam.axis, d));
    }
    EXPECT_LE(widest, beam.half_angle_rad);
    EXPECT_GT(widest, beam.half_angle_rad - 5.0 * kDegree);  // and is no wider than it must be
  }
}

TEST(Beam, HoldsEverySampledDirection) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const auto& web : {patch_web(0, 40), patch_web(200, 350), spot_web(8, 9)}) {
    const calc::Beam beam = calc::beam_of(web);
    const calc::WebSampler sampler(web);
    for (int k = 0; k < 20000; ++k) {
      const double u = k == 0   ? 0.0
                       : k == 1 ? 1.0
                                : uniform(random),
                   v = k % 7 == 0 ? 0.0 : uniform(random);
      const auto d = sampler.sample(u, v);
      ASSERT_LE(angle_rad(beam.axis, {d[0], d[1], d[2]}), beam.half_angle_rad + 1e-9);
    }
  }
}

TEST(Beam, ASpotMissesWhatIsJustOutsideItsCone) {
  const auto web = spot_web(8.0, 10.0);
  const double edge = std::tan(10.0 * kDegree);
  const auto triangle = [&](double x) {
    return std::vector<glm::dvec3>{{x, -5, -1}, {x, 5, -1}, {x + 5, 0, -1}};
  };
  EXPECT_TRUE(misses(web, triangle(1.001 * edge)));
  EXPECT_FALSE(misses(web, triangle(0.999 * edge)));
}

TEST(Beam, ASpotSeesATriangleWhoseCornersAreAllOutsideItsCone) {
  EXPECT_FALSE(misses(spot_web(8.0, 10.0), {{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}}));
}

TEST(Beam, ABigTriangleBesideTheConeIsMissedThoughItsSphereIsNot) {
  EXPECT_TRUE(misses(spot_web(8.0, 10.0), {{0.3, -50, -1}, {0.3, 50, -1}, {90, 0, -1}}));
}

TEST(Beam, AWideBeamMissesOnlyWhatLiesInItsDarkCone) {
  const auto web = spot_web(110.0, 120.0);  // dark within 60 degrees of the zenith
  EXPECT_TRUE(misses(web, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}));
  EXPECT_FALSE(misses(web, {{0, 0, 1}, {1.8, 0, 1}, {0, 1, 1}}));
  EXPECT_FALSE(misses(web, {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}));
}

TEST(Beam, AnOpeningIsLitFromEveryPointOfIt) {
  const double edge = std::tan(10.0 * kDegree);
  const std::vector<glm::dvec3> beside{{edge + 0.45, -1, -1}, {edge + 0.45, 1, -1}, {9, 0, -1}};
  EXPECT_TRUE(misses(spot_web(8, 10), beside));
  const calc::LuminousOpening opening{calc::OpeningShape::rectangle, 1.0, 0.2, 0.0};
  EXPECT_FALSE(misses(spot_web(8, 10, opening), beside));
  const calc::LuminousOpening across{calc::OpeningShape::rectangle, 0.2, 1.0, 0.0};
  EXPECT_TRUE(misses(spot_web(8, 10, across), beside));
}

// Whatever is called missed is missed by all lines from the opening along lit directions.
TEST(Beam, RandomRaysNeverContradictAProof) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const calc::LuminousOpening disk{calc::OpeningShape::disk, 0.3, 0.3, 0.0};
  const calc::PhotometricWeb webs[] = {spot_web(30, 40),    spot_web(8, 10, disk),
                                       patch_web(80, 100),  spot_web(100, 110, disk),
                                       patch_web(200, 350), test_support::lambert_web(10, 9, disk)};
  int proved = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const calc::PhotometricWeb& web = webs[trial % 6];
    calc::PreparedScene scene;
    std::vector<glm::dvec3> corners;
    for (int k = 0; k < 3; ++k) {
      corners.emplace_back(
          glm::vec3(3.0 * glm::dvec3(uniform(random), uniform(random), uniform(random))));
    }
    test_support::add_triangle(scene, corners[0], corners[1], corners[2], 0.5);
    add_aimed(scene, web, {0, 0, 0}, random_unit(random));
    scene.extent_m = 6.0;
    const calc::Beam beam = calc::beams_of(scene)[0];
    if (!calc::beam_misses(beam, scene.luminaires[0], corners, {1e-5, 1e-5})) continue;
    ++proved;
    const calc::Tracer tracer(scene);
    const calc::Emitter emitter(scene);
    for (int k = 0; k < 200; ++k) {
      const auto u = [&] { return 0.5 + 0.5 * uniform(random); };
      const calc::EmittedRay ray = emitter.emit(0, {u(), u()}, {u(), u()}, 0.0);
      calc::SurfaceHit hit;
      ASSERT_FALSE(tracer.closest_hit(ray.origin_m, ray.direction, 100.0, hit)) << trial;
    }
  }
  EXPECT_GT(proved, 500);
}

}  // namespace
}  // namespace beam_test
