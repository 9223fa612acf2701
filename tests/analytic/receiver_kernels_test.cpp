// Cylindrical, semicylindrical, hemispherical and scalar illuminance: closed forms of a point
// source, identities between them, uniform light, and a wall 5 mm away.
#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

namespace receiver_kernels_test {
namespace {

using namespace test_support;
using calc::ReceiverKernel;

constexpr std::array kAll{ReceiverKernel::planar, ReceiverKernel::cylindrical,
                          ReceiverKernel::semicylindrical, ReceiverKernel::hemispherical,
                          ReceiverKernel::scalar};

calc::SensorGrid grid_of(ReceiverKernel kernel, std::vector<glm::dvec3> positions_m,
                         std::vector<glm::dvec3> axes) {
  calc::SensorGrid grid;
  grid.kernel = kernel;
  grid.position_m = std::move(positions_m);
  grid.normal = std::move(axes);
  return grid;
}

double direct_lx(const calc::PreparedScene& scene, ReceiverKernel kernel,
                 const glm::dvec3& position_m, const glm::dvec3& axis) {
  const calc::SpaceSolution solution =
      solve_with_paths(scene, grid_of(kernel, {position_m}, {axis}), 1, 16);
  EXPECT_TRUE(solution.fields[0].is_exact());
  return solution.fields[0].direct_exact_lx[0];
}

// Indirect part of every replicate at point i.
std::vector<double> indirect_lx(const calc::PlaneField& field, std::size_t i) {
  std::vector<double> values;
  for (std::size_t r = 0; r < field.replicates; ++r) {
    values.push_back(field.indirect_lx[r * field.points + i]);
  }
  return values;
}

glm::dvec3 azimuth(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad), 0.0}; }

// eps: from the vertical; alpha: between the direction looked in and the light, seen from above.
TEST(ReceiverKernels, MatchTheClosedFormsOfAPointSource) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const glm::dvec3 receiver_m(1.0, -2.0, 0.5);
  const double look_rad = 0.7;
  for (const double eps : {0.2, 1.1, 1.9, 3.0}) {
    for (const double alpha : {0.0, 0.9, 2.0, 3.1, -1.3}) {
      for (const double d : {0.3, 4.0}) {
        const glm::dvec3 to_light =
            std::sin(eps) * azimuth(look_rad + alpha) + glm::dvec3(0, 0, std::cos(eps));
        calc::PreparedScene scene;
        add_luminaire(scene, web, receiver_m + d * to_light);
        set_extent(scene);
        const double e = 100.0 / (d * d);
        const auto ratio = [&](ReceiverKernel kernel, const glm::dvec3& axis, double expected) {
          return direct_lx(scene, kernel, receiver_m, axis) / expected;
        };
        const glm::dvec3 up(0, 0, 1), look = azimuth(look_rad);
        EXPECT_NEAR(ratio(ReceiverKernel::cylindrical, up, e * std::sin(eps) / calc::kPi), 1, 1e-9);
        EXPECT_NEAR(ratio(ReceiverKernel::semicylindrical, look,
                          e * (1.0 + std::cos(alpha)) * std::sin(eps) / calc::kPi),
                    1, 1e-9);
        EXPECT_NEAR(ratio(ReceiverKernel::hemispherical, up, e * (1.0 + std::cos(eps)) / 4.0), 1,
                    1e-9);
        EXPECT_NEAR(ratio(ReceiverKernel::scalar, look, e / 4.0), 1, 1e-9);
      }
    }
  }
}

// A cylinder that lies on its side: the angle counts from its axis.
TEST(ReceiverKernels, TheCylinderStandsAlongItsAxis) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 2});
  set_extent(scene);
  const auto lx = [&](const glm::dvec3& axis) {
    return direct_lx(scene, ReceiverKernel::cylindrical, {0, 0, 0}, axis);
  };
  EXPECT_NEAR(lx({1, 0, 0}), 25.0 / calc::kPi, 1e-9);
  EXPECT_NEAR(lx({0, 0.6, 0.8}), 25.0 * 0.6 / calc::kPi, 1e-9);
  EXPECT_EQ(lx({0, 0, 1}), 0.0);
}

// The mean of max(cos, 0) over all azimuths is 1 / pi, so that the mean of the vertical planar
// illuminances around a point is the cylindrical one: Ez = 1 / (2 pi) * integral of Ev. With 720
// directions the sum of a cosine's half wave is off by pi^2 / (3 * 720^2) = 6e-6 at most.
TEST(ReceiverKernels, CylindricalIsTheMeanOfTheVerticalOnes) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {1.0, 0.5, 2.0});
  add_luminaire(scene, web, {-2.0, 1.5, 2.6});
  add_luminaire(scene, web, {0.2, -3.0, 1.4});
  set_extent(scene);
  constexpr std::size_t kDirections = 720;
  calc::SensorGrid around;
  for (std::size_t k = 0; k < kDirections; ++k) {
    around.position_m.emplace_back(0.1, 0.0, 1.2);
    around.normal.push_back(azimuth(2.0 * calc::kPi * static_cast<double>(k) / kDirections));
  }
  const calc::SpaceSolution solution = solve_with_paths(scene, around, 1, 16);
  double mean = 0.0;
  for (const double lx : solution.fields[0].direct_exact_lx) mean += lx / kDirections;
  const double ez = direct_lx(scene, ReceiverKernel::cylindrical, {0.1, 0.0, 1.2}, {0, 0, 1});
  ASSERT_GT(ez, 10.0);
  EXPECT_NEAR(mean / ez, 1.0, 1e-5);
}

TEST(ReceiverKernels, FrontAndBackHalvesAverageToTheWhole) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {1.0, 0.5, 2.0});
  add_luminaire(scene, web, {-2.0, 1.5, 2.6});
  set_extent(scene);
  const glm::dvec3 p(0.1, 0.0, 1.2), up(0, 0, 1), tilted = glm::normalize(glm::dvec3(1, 2, 3));
  const auto lx = [&](ReceiverKernel kernel, const glm::dvec3& axis) {
    return direct_lx(scene, kernel, p, axis);
  };
  const double ez = lx(ReceiverKernel::cylindrical, up);
  for (const double angle : {0.0, 1.0, 2.5}) {
    const double front = lx(ReceiverKernel::semicylindrical, azimuth(angle));
    const double back = lx(ReceiverKernel::semicylindrical, -azimuth(angle));
    EXPECT_NEAR(0.5 * (front + back) / ez, 1.0, 1e-12);
    EXPECT_GT(std::abs(front - back), 0.01 * ez);
  }
  EXPECT_NEAR(
      0.5 *
          (lx(ReceiverKernel::hemispherical, tilted) + lx(ReceiverKernel::hemispherical, -tilted)) /
          lx(ReceiverKernel::scalar, up),
      1.0, 1e-12);
}

// An isotropic source in the centre of a diffuse sphere makes the same radiance come from all
// sides, to any point: each kernel then gives pi L = Phi / A rho / (1 - rho). 320 facets leave it
// uniform within 0.5 %.
TEST(ReceiverKernels, AllAgreeInUniformLight) {
  constexpr double kReflectance = 0.9;
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_sphere(scene, 1.5, 2, kReflectance);
  add_luminaire(scene, web, {0, 0, 0});
  set_extent(scene);
  const double expected =
      web.flux_lm() / surface_area_m2(scene) * kReflectance / (1.0 - kReflectance);
  for (const ReceiverKernel kernel : kAll) {
    const calc::SpaceSolution solution = solve_with_paths(
        scene, grid_of(kernel, {{0.1, 0, 0}, {0.4, -0.5, 0.6}}, {{0.6, 0.8, 0}, {0.6, -0.8, 0}}), 7,
        1024);
    for (std::size_t i = 0; i < 2; ++i) {
      const calc::Estimate e = calc::t_interval(indirect_lx(solution.fields[0], i), 0.999);
      EXPECT_LT(e.low, 1.005 * expected)
          << calc::quantity_name(kernel, calc::DerivedQuantity::none) << i;
      EXPECT_GT(e.high, 0.995 * expected)
          << calc::quantity_name(kernel, calc::DerivedQuantity::none) << i;
      EXPECT_NEAR(e.value / expected, 1.0, 0.02)
          << calc::quantity_name(kernel, calc::DerivedQuantity::none) << i;
      EXPECT_LT(e.half_width() / e.value, 0.03)
          << calc::quantity_name(kernel, calc::DerivedQuantity::none) << i;
    }
  }
}

// The same identities in the reflected light of an uneven room, where 32 directions are plenty.
TEST(ReceiverKernels, IdentitiesHoldForReflectedLight) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
  add_luminaire(scene, web, {0.4, 1.2, 1.7});
  set_extent(scene);
  const glm::dvec3 p(1.0, 2.0, 1.2);
  const auto estimate = [&](ReceiverKernel kernel, const std::vector<glm::dvec3>& axes) {
    const std::vector<glm::dvec3> at(axes.size(), p);
    const calc::SpaceSolution solution =
        solve_with_paths(scene, grid_of(kernel, at, axes), 3, 4096, 16);
    const calc::PlaneField& field = solution.fields[0];
    std::vector<double> means(field.replicates, 0.0);
    for (std::size_t i = 0; i < field.points; ++i) {
      const std::vector<double> here = indirect_lx(field, i);
      for (std::size_t r = 0; r < means.size(); ++r) {
        means[r] += here[r] / static_cast<double>(field.points);
      }
    }
    return calc::t_interval(means, 0.999);
  };
  const auto expect_equal = [](const calc::Estimate& a, const calc::Estimate& b, const char* what) {
    EXPECT_LE(std::abs(a.value - b.value), std::hypot(a.half_width(), b.half_width())) << what;
    EXPECT_LT(a.half_width() / a.value, 0.02) << what;
    EXPECT_LT(b.half_width() / b.value, 0.02) << what;
  };
  std::vector<glm::dvec3> around;
  for (int k = 0; k < 32; ++k) around.push_back(azimuth(calc::kPi * k / 16.0));
  const calc::Estimate cylinder = estimate(ReceiverKernel::cylindrical, {{0, 0, 1}});
  expect_equal(estimate(ReceiverKernel::planar, around), cylinder, "planar");
  const glm::dvec3 look = azimuth(2.9);
  expect_equal(estimate(ReceiverKernel::semicylindrical, {look, -look}), cylinder, "halves");
  expect_equal(estimate(ReceiverKernel::hemispherical, {look, -look}),
               estimate(ReceiverKernel::scalar, {look}), "half spheres");
  // They are not all the same number.
  EXPECT_GT(estimate(ReceiverKernel::semicylindrical, {look}).low, 1.1 * cylinder.high);
}

// One wall, x = 0, does not light itself: its radiance is rho / pi * I cos / d^2, and the
// receiver's value an integral over the directions that meet it.
double wall_lx(const glm::dvec3& receiver_m, const glm::dvec3& source_m, double intensity_cd,
               double reflectance, double half_size_m,
               const std::function<double(const glm::dvec3&)>& kernel) {
  constexpr int kRings = 1500, kSectors = 1500;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double cosine = (i + 0.5) / kRings, sine = std::sqrt(1.0 - cosine * cosine);
    for (int j = 0; j < kSectors; ++j) {
      const double angle = 2.0 * calc::kPi * (j + 0.5) / kSectors;
      const glm::dvec3 w(-cosine, sine * std::cos(angle), sine * std::sin(angle));
      const glm::dvec3 y = receiver_m + receiver_m.x / cosine * w;
      if (std::max(std::abs(y.y), std::abs(y.z)) > half_size_m) continue;
      const glm::dvec3 s = source_m - y;
      const double d = glm::length(s);
      sum += kernel(w) * reflectance / calc::kPi * intensity_cd * s.x / (d * d * d);
    }
  }
  return sum * 2.0 * calc::kPi / (static_cast<double>(kRings) * kSectors);
}

struct NearWall {
  const char* name;
  ReceiverKernel kernel;
  glm::dvec3 axis;
  std::function<double(const glm::dvec3&)> formula;  // of a unit direction
};

const std::array<NearWall, 5> kNearWall{
    {{"cylinder",
      ReceiverKernel::cylindrical,
      {0, 0, 1},
      [](const glm::dvec3& w) { return std::hypot(w.x, w.y) / calc::kPi; }},
     {"half cylinder to the wall",
      ReceiverKernel::semicylindrical,
      {-0.8, 0.6, 0},
      [](const glm::dvec3& w) {
        return (std::hypot(w.x, w.y) - 0.8 * w.x + 0.6 * w.y) / calc::kPi;
      }},
     {"half cylinder off the wall",
      ReceiverKernel::semicylindrical,
      {1, 0, 0},
      [](const glm::dvec3& w) { return (std::hypot(w.x, w.y) + w.x) / calc::kPi; }},
     {"half sphere",
      ReceiverKernel::hemispherical,
      {0, 0, 1},
      [](const glm::dvec3& w) { return 0.25 * (1.0 + w.z); }},
     {"sphere", ReceiverKernel::scalar, {0, 0, 1}, [](const glm::dvec3&) { return 0.25; }}}};

calc::PreparedScene one_wall(const calc::PhotometricWeb& web, const glm::dvec3& source_m) {
  calc::PreparedScene scene;
  add_quad(scene, {0, -2, -2}, {0, 4, 0}, {0, 0, 4}, 0.6);
  add_luminaire(scene, web, source_m);
  set_extent(scene);
  return scene;
}

TEST(ReceiverKernels, AWallFiveMillimetresAwayIsSeenInFull) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const glm::dvec3 source_m(1.0, 0.5, 0.3), receiver_m(0.005, 0.2, -0.1);
  const calc::PreparedScene scene = one_wall(web, source_m);
  for (const NearWall& wall : kNearWall) {
    const double expected = wall_lx(receiver_m, source_m, 100.0, 0.6, 2.0, wall.formula);
    const calc::SpaceSolution solution =
        solve_with_paths(scene, grid_of(wall.kernel, {receiver_m}, {wall.axis}), 21, 1024, 64);
    const calc::Estimate e = calc::t_interval(indirect_lx(solution.fields[0], 0), 0.999);
    EXPECT_GT(solution.fields[0].counters.near_rays, 0u);
    EXPECT_LT(e.low, expected) << wall.name;
    EXPECT_GT(e.high, expected) << wall.name;
    EXPECT_LT(e.half_width() / e.value, 0.02) << wall.name;
  }
}

// In the wall itself: from behind it they would miss the wall and its light.
TEST(ReceiverKernels, APointInASurfaceIsRefused) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = one_wall(web, {1.0, 0.5, 0.3});
  for (const NearWall& wall : kNearWall) {
    const calc::SpaceSolution solution =
        solve_with_paths(scene, grid_of(wall.kernel, {{0.0, 0.2, -0.1}}, {wall.axis}), 21, 64, 4);
    EXPECT_NE(solution.fields[0].problem, "") << wall.name;
  }
}

// As make_sensor_grid() has them measured: a hair off, on one of its sides.
TEST(ReceiverKernels, APointInASurfaceIsMeasuredFromOffIt) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const glm::dvec3 source_m(1.0, 0.5, 0.3), receiver_m(0.0, 0.2, -0.1);
  const calc::PreparedScene scene = one_wall(web, source_m);
  for (const NearWall& wall : kNearWall) {
    calc::SensorGrid grid = grid_of(wall.kernel, {receiver_m}, {wall.axis});
    grid.shift_m = {{3.0 * scene.ray_offset_m(), 0, 0}};
    const double expected = wall_lx({1e-5, 0.2, -0.1}, source_m, 100.0, 0.6, 2.0, wall.formula);
    const calc::SpaceSolution front = solve_with_paths(scene, grid, 21, 1024, 64);
    const calc::Estimate e = calc::t_interval(indirect_lx(front.fields[0], 0), 0.999);
    EXPECT_LT(e.low, 1.001 * expected) << wall.name;
    EXPECT_GT(e.high, 0.999 * expected) << wall.name;
    EXPECT_LT(e.half_width() / e.value, 0.02) << wall.name;
    EXPECT_GT(front.fields[0].direct_exact_lx[0], 0.0) << wall.name;
    grid.shift_m = {{-3.0 * scene.ray_offset_m(), 0, 0}};  // the wall hides the lamp
    const calc::SpaceSolution behind = solve_with_paths(scene, grid, 21, 1024, 4);
    EXPECT_EQ(behind.fields[0].direct_exact_lx[0], 0.0) << wall.name;
    for (const double lx : indirect_lx(behind.fields[0], 0)) EXPECT_EQ(lx, 0.0) << wall.name;
  }
}

}  // namespace
}  // namespace receiver_kernels_test
