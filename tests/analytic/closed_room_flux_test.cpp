// Energy: in a closed room everything emitted is absorbed, sum over surfaces of (1 - rho) E A =
// Phi.
#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace closed_room_flux_test {
namespace {

using namespace test_support;

// Midpoint grid on each face of a box, normals inwards, equal cells per face.
struct FaceGrid {
  calc::SensorGrid grid;
  std::vector<double> area_m2;
};

FaceGrid face_grid(const glm::dvec3& size, int n) {
  FaceGrid faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const int side : {0, 1}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          glm::dvec3 p(0.0), normal(0.0);
          p[axis] = side * size[axis];
          p[a] = (i + 0.5) / n * size[a];
          p[b] = (j + 0.5) / n * size[b];
          normal[axis] = side == 0 ? 1.0 : -1.0;
          faces.grid.position_m.push_back(p);
          faces.grid.normal.push_back(normal);
          faces.area_m2.push_back(size[a] * size[b] / (n * n));
        }
      }
    }
  }
  return faces;
}

TEST(ClosedRoom, AbsorbedFluxEqualsEmittedFlux) {
  const glm::dvec3 size(5, 4, 3);
  const calc::PhotometricWeb web = isotropic_web(50.0);
  for (const double rho : {0.3, 0.9}) {
    SCOPED_TRACE(rho);
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, size, rho);
    add_luminaire(scene, web, {2.2, 1.7, 1.6});
    set_extent(scene);
    const FaceGrid faces = face_grid(size, 8);
    const calc::SpaceSolution solution = solve_with_paths(scene, faces.grid, 5, 256);
    const calc::PlaneField& field = solution.fields[0];
    std::vector<double> absorbed(field.replicates, 0.0);
    for (std::size_t r = 0; r < field.replicates; ++r) {
      for (std::size_t i = 0; i < field.points; ++i) {
        absorbed[r] += (1.0 - rho) * total_lx(field, r, i) * faces.area_m2[i];
      }
    }
    const calc::Estimate sum = calc::t_interval(absorbed, 0.999);
    // The 8 x 8 midpoint rule itself is off by about 0.2 % in this room (direct part).
    EXPECT_LE(sum.low, web.flux_lm() * 1.003);
    EXPECT_GE(sum.high, web.flux_lm() * 0.997);
    EXPECT_NEAR(sum.value / web.flux_lm(), 1.0, 5e-3);

    EXPECT_NEAR(solution.balance.emitted_lm, web.flux_lm(), 1e-9 * web.flux_lm());
    EXPECT_EQ(solution.balance.escaped_lm.value, 0.0);
    // Twice the 95 % half-width is the 99.9 % one for 16 replicates.
    EXPECT_NEAR(solution.balance.absorbed_lm.value, web.flux_lm(),
                2.0 * solution.balance.absorbed_lm.half_width());
    EXPECT_NEAR(solution.balance.absorbed_lm.value / web.flux_lm(), 1.0, 2e-3);
  }
}

TEST(OpenModel, EscapedAndAbsorbedFluxAddUp) {
  const calc::PhotometricWeb web = isotropic_web(50.0);
  calc::PreparedScene scene;
  add_quad(scene, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0.5);
  add_luminaire(scene, web, {0, 0, 1});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0, 0, 0.5}};
  grid.normal = {{0, 0, -1}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 5, 1024);
  const double sum = solution.balance.absorbed_lm.value + solution.balance.escaped_lm.value;
  EXPECT_NEAR(sum / web.flux_lm(), 1.0, 1e-3);
  EXPECT_GT(solution.balance.escaped_lm.value, 0.5 * web.flux_lm());
}

TEST(ClosedRoom, WithoutAbsorptionThereIsNoSteadyState) {
  const calc::PhotometricWeb web = isotropic_web(50.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1}, 1.0);
  add_luminaire(scene, web, {0.5, 0.5, 0.5});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0.2, 0.2, 0.2}};
  grid.normal = {{0, 0, 1}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 5, 16, 4);
  EXPECT_NE(solution.fields[0].problem.english().find("no steady state"), std::string::npos);
}

// Whether such a room is refused hangs on the room, not on the luck of a path.
TEST(ClosedRoom, IsRefusedOrNotWhateverTheSeed) {
  const calc::PhotometricWeb web = isotropic_web(50.0);
  for (const double absorbed : {1e-4, 5e-5}) {
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, {1, 1, 1}, 1.0 - absorbed);
    add_luminaire(scene, web, {0.5, 0.5, 0.5});
    set_extent(scene);
    calc::SensorGrid grid;
    grid.position_m = {{0.2, 0.2, 0.2}};
    grid.normal = {{0, 0, 1}};
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
      const calc::SpaceSolution solution = solve_with_paths(scene, grid, seed, 16, 4);
      EXPECT_EQ(solution.fields[0].problem.empty(), absorbed > 9e-5) << absorbed << " " << seed;
      if (absorbed < 9e-5) continue;
      const double ratio = solution.balance.absorbed_lm.value / web.flux_lm();
      EXPECT_NEAR(ratio, 1.0, 0.5);
    }
  }
}

}  // namespace
}  // namespace closed_room_flux_test
