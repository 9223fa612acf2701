// Lambertian openings over a point, against closed forms; tolerance 0.1 %.
#include "calc/base/statistics.h"
#include "calc/radiosity/direct/direct.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert_area_source_test {
namespace {

using namespace test_support;

// Configuration factor of a rectangle a x b from a point at distance h under one corner, receiver
// parallel. [e.g. Howell, catalog of configuration factors, B-3]
double corner_factor(double a, double b, double h) {
  const double x = a / h, y = b / h;
  return (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
          y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
         (2.0 * calc::kPi);
}

struct Measured {
  calc::Estimate lx;
  double expected_lx;
};

Measured rectangle_at(double a, double b, double h, const glm::dvec2& offset, double factor) {
  const double luminance = 2000.0;  // cd/m2
  calc::LuminousOpening opening{calc::OpeningShape::rectangle, a, b, 0.0};
  const calc::PhotometricWeb web = lambert_web(luminance * a * b, 900, opening);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, h});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{offset.x, offset.y, 0.0}};
  grid.normal = {{0, 0, 1}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 7, 256, 16, 4);
  return {calc::t_interval(replicates_at(solution.fields[0], 0), 0.999),
          calc::kPi * luminance * factor};
}

void expect_match(const Measured& m) {
  EXPECT_NEAR(m.lx.value / m.expected_lx, 1.0, 1e-3);
  EXPECT_LE(m.lx.low, m.expected_lx * (1 + 2e-6));  // 2e-6: the table's own interpolation error
  EXPECT_GE(m.lx.high, m.expected_lx * (1 - 2e-6));
  EXPECT_LT(m.lx.half_width() / m.expected_lx, 2e-3);
}

TEST(LambertRectangle, UnderItsCentreNearAndFar) {
  for (const double h : {0.3, 1.0, 2.0, 12.0}) {
    SCOPED_TRACE(h);
    expect_match(rectangle_at(0.6, 1.2, h, {0, 0}, 4.0 * corner_factor(0.3, 0.6, h)));
  }
}

TEST(LambertRectangle, UnderItsCornerAndOutside) {
  const double h = 1.0;
  expect_match(rectangle_at(0.6, 1.2, h, {0.3, 0.6}, corner_factor(0.6, 1.2, h)));
  // Outside: the four corner rectangles with their signs.
  const double outside =
      0.5 * (2.0 * corner_factor(1.3, 0.6, h) - 2.0 * corner_factor(0.7, 0.6, h)) * 2.0;
  expect_match(rectangle_at(0.6, 1.2, h, {1.0, 0.0}, outside));
}

TEST(LambertRectangle, VeryNearIsNeitherSingularNorClamped) {
  const double h = 0.01;  // a panel 60 times larger than its distance
  expect_match(rectangle_at(0.6, 0.6, h, {0, 0}, 4.0 * corner_factor(0.3, 0.3, h)));
}

TEST(LambertDisk, UnderItsCentre) {
  const double radius = 0.5, luminance = 1000.0;
  const calc::LuminousOpening opening{calc::OpeningShape::disk, 2 * radius, 2 * radius, 0.0};
  const calc::PhotometricWeb web =
      lambert_web(luminance * calc::kPi * radius * radius, 900, opening);
  for (const double h : {0.1, 0.5, 3.0}) {
    calc::PreparedScene scene;
    add_luminaire(scene, web, {0, 0, h});
    set_extent(scene);
    calc::SensorGrid grid;
    grid.position_m = {{0, 0, 0}};
    grid.normal = {{0, 0, 1}};
    const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 256, 16, 4);
    const double expected = calc::kPi * luminance * radius * radius / (radius * radius + h * h);
    expect_match({calc::t_interval(replicates_at(solution.fields[0], 0), 0.999), expected});
  }
}

TEST(ExtendedSource, HalfHiddenOpeningGivesHalfTheLight) {
  const calc::LuminousOpening opening{calc::OpeningShape::rectangle, 1.0, 1.0, 0.0};
  const calc::PhotometricWeb web = lambert_web(1000.0, 900, opening);
  calc::PreparedScene scene;
  add_quad(scene, {0.0, -5.0, 1.0}, {5, 0, 0}, {0, 10, 0}, 0.0);  // edge straight above the point
  add_luminaire(scene, web, {0, 0, 2});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0, 0, 0}};
  grid.normal = {{0, 0, 1}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 256, 16, 4);
  const double full = calc::kPi * 1000.0 * 4.0 * corner_factor(0.5, 0.5, 2.0);
  const calc::Estimate lx = calc::t_interval(replicates_at(solution.fields[0], 0), 0.999);
  EXPECT_GT(lx.high, full / 2);
  EXPECT_LT(lx.low, full / 2);
  EXPECT_LT(lx.half_width(), 0.02 * full);
}

}  // namespace
}  // namespace lambert_area_source_test
