#include "calc/radiosity/direct/emission.h"

#include "calc/scene/opening.h"

#include "calc/radiosity/direct/direct.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace emission_test {
namespace {

using namespace test_support;

TEST(Emitter, ChoosesLuminairesInProportionToTheirFlux) {
  const calc::PhotometricWeb weak = isotropic_web(10.0), strong = isotropic_web(30.0);
  calc::PreparedScene scene;
  add_luminaire(scene, weak, {0, 0, 0});
  add_luminaire(scene, strong, {1, 0, 0});
  add_luminaire(scene, weak, {2, 0, 0});
  scene.luminaires[2].flux_scale = 2.0;
  const calc::Emitter emitter(scene);
  EXPECT_NEAR(emitter.flux_lm(), 60.0 * 4 * calc::kPi, 1e-9);
  EXPECT_EQ(emitter.choose_luminaire(0.0), 0u);
  EXPECT_EQ(emitter.choose_luminaire(0.1666), 0u);
  EXPECT_EQ(emitter.choose_luminaire(0.1667), 1u);
  EXPECT_EQ(emitter.choose_luminaire(0.6666), 1u);
  EXPECT_EQ(emitter.choose_luminaire(0.6667), 2u);
  EXPECT_EQ(emitter.choose_luminaire(0x1.fffffffffffffp-1), 2u);
}

TEST(Emitter, EmitsAlongTheLuminairesOwnAxes) {
  // All light within 5 degrees of gamma = 90, C = 0.
  const auto deg = calc::kRadiansPerDegree;
  const calc::PhotometricWeb web = calc::PhotometricWeb::make(
      {0, 5 * deg, 355 * deg, 360 * deg}, {0, 85 * deg, 90 * deg, 95 * deg, calc::kPi},
      {0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 9, 0, 0}, {}, {});
  calc::PreparedScene scene;
  add_luminaire(scene, web, {1, 2, 3});
  scene.luminaires[0].world_from_luminaire =
      glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0));
  const calc::Emitter emitter(scene);
  for (const double u : {0.01, 0.5, 0.99}) {
    const calc::EmittedRay ray = emitter.emit(0, {u, 1.0 - u}, {0.5, 0.5}, 1e-6);
    EXPECT_GT(ray.direction.y, 0.99);  // C0 is world y here
    EXPECT_NEAR(glm::length(ray.origin_m - glm::dvec3(1, 2, 3)), 0.0, 2e-6);
  }
}

TEST(Opening, PointsFillRectangleAndDiskEvenly) {
  const calc::PhotometricWeb web = isotropic_web(1.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 0});
  calc::PlacedLuminaire& luminaire = scene.luminaires[0];
  for (const auto shape : {calc::OpeningShape::rectangle, calc::OpeningShape::disk}) {
    luminaire.opening = {shape, 2.0, 1.0, 0.0};
    double x2 = 0, y2 = 0;
    constexpr int kSide = 200;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const glm::dvec3 p = calc::opening_point_m(luminaire, (i + 0.5) / kSide, (j + 0.5) / kSide);
        EXPECT_LE(std::abs(p.x), 1.0);
        EXPECT_LE(std::abs(p.y), 0.5);
        EXPECT_EQ(p.z, 0.0);
        x2 += p.x * p.x / (kSide * kSide);
        y2 += p.y * p.y / (kSide * kSide);
      }
    }
    // Second moments: a^2 / 12 for a rectangle's side a, a^2 / 16 for an ellipse's diameter a.
    const double divisor = shape == calc::OpeningShape::rectangle ? 12.0 : 16.0;
    EXPECT_NEAR(x2, 4.0 / divisor, 1e-3);
    EXPECT_NEAR(y2, 1.0 / divisor, 1e-3);
  }
}

TEST(OpeningCells, CoverTheOpeningAndGrowTowardsThePoint) {
  const calc::PhotometricWeb web = isotropic_web(1.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 0});
  calc::PlacedLuminaire& luminaire = scene.luminaires[0];
  for (const auto shape : {calc::OpeningShape::rectangle, calc::OpeningShape::disk}) {
    luminaire.opening = {shape, 0.6, 0.6, 0.0};
    const auto far = calc::opening_cells(luminaire, {0, 0, -1e6});
    ASSERT_EQ(far.size(), 1u);
    EXPECT_EQ(far[0].samples, 1u);
    EXPECT_EQ(calc::opening_cells(luminaire, {0, 0, -0.9}).size(), 1u);
    for (const double h : {0.3, 0.01, 0.0}) {
      const auto cells = calc::opening_cells(luminaire, {0.1, 0.05, -h});
      double area = 0.0;
      for (const calc::OpeningCell& cell : cells) area += cell.size_s * cell.size_t;
      EXPECT_NEAR(area, 1.0, 1e-12);
      EXPECT_GT(cells.size(), 3u);
      EXPECT_LT(cells.size(), 1000u);
    }
  }
}

}  // namespace
}  // namespace emission_test
