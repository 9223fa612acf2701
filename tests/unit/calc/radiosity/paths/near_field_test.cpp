#include "calc/radiosity/paths/near_field.h"

#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace near_field_test {
namespace {

using namespace test_support;

TEST(GeometryTerm, IsCosinesOverSquaredDistance) {
  EXPECT_DOUBLE_EQ(calc::geometry_term({0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}), 0.25);
  EXPECT_EQ(calc::geometry_term({0, 0, 0}, {0, 0, -1}, {0, 0, 2}, {0, 0, -1}), 0.0);
  EXPECT_EQ(calc::geometry_term({0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 1}), 0.0);
  EXPECT_EQ(calc::geometry_term({0, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}), 0.0);
}

// A receiver 10 um before a wall, whose vertices are stored 7 um before it.
TEST(GeometryTerm, IsThatOfTheTruePlaceOfALiftedVertex) {
  const glm::dvec3 x(1e-5, 0, 0), up(0, 0, 1), y(0, 0.2, 0.3), normal(1, 0, 0);
  constexpr double kLift_m = 7e-6;
  const double expected = calc::geometry_term(x, up, y, normal);
  const auto planar = calc::ReceiverKernel::planar;
  const glm::dvec3 w = y + kLift_m * normal - x;
  EXPECT_DOUBLE_EQ(calc::lifted_connection_geometry(planar, up, normal, w, kLift_m), expected);
  EXPECT_NEAR(static_cast<double>(calc::lifted_connection_geometry(
                  planar, glm::vec3(up), glm::vec3(normal), glm::vec3(w), 7e-6f)) /
                  expected,
              1.0, 1e-4);
  // What lies in the wall is not lit by it, whatever rounding does to its place.
  const glm::dvec3 in_wall = y + kLift_m * normal - glm::dvec3(1e-7, 0, 0);
  EXPECT_EQ(calc::lifted_connection_geometry(planar, up, normal, in_wall, kLift_m), 0.0);
}

TEST(GeometryBound, FollowsTheLightOnASurface) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
  add_luminaire(scene, web, {0.03, 1.5, 1.5});
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const calc::Emitter emitter(scene);
  const calc::GeometryBound bound(tracer, emitter, 1024);
  const double hot = bound.at({0, 1.5, 1.5}, {1, 0, 0});
  const double cold = bound.at({4, 1.5, 1.5}, {-1, 0, 0});
  // N E / Phi kappa with E = I / d^2 = 111,111 lx and Phi = 4 pi 100 lm, beside a small ambient
  // part.
  EXPECT_NEAR(hot, 0.01 * 1024 * (100.0 / 0.0009) / (400.0 * calc::kPi), 0.01 * hot);
  EXPECT_LT(cold, 3.0);
  EXPECT_GE(cold, bound.smallest());
  EXPECT_NEAR(bound.smallest() * bound.reach_m() * bound.reach_m(), 1.0, 1e-12);
  EXPECT_GT(calc::GeometryBound(tracer, emitter, 4096).at({0, 1.5, 1.5}, {1, 0, 0}), 3.9 * hot);
}

// Two techniques, one sum: whatever the number of paths (and with it the bound), the mean must not
// move.
TEST(NearField, TheBoundShiftsWorkButNotTheResult) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.7);
  add_luminaire(scene, web, {0.4, 1.5, 1.5});
  set_extent(scene);
  calc::SensorGrid grid;
  // The third looks straight at a wall from where short rays do part of the work with few paths and
  // none with many.
  grid.position_m = {{0.005, 1.4, 1.2}, {0.005, 0.005, 1.2}, {3.6, 2.0, 1.2}};
  grid.normal = {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}};
  const calc::SpaceSolution few = solve_with_paths(scene, grid, 4, 128, 64);
  const calc::SpaceSolution many = solve_with_paths(scene, grid, 5, 16384, 16);
  for (std::size_t i = 0; i < 3; ++i) {
    const calc::Estimate a = calc::t_interval(replicates_at(few.fields[0], i), 0.999);
    const calc::Estimate b = calc::t_interval(replicates_at(many.fields[0], i), 0.999);
    EXPECT_LT(a.low, b.high);
    EXPECT_LT(b.low, a.high);
    EXPECT_LT(a.half_width() / a.value, 0.1);
    EXPECT_LT(b.half_width() / b.value, 0.06);
  }
}

}  // namespace
}  // namespace near_field_test
