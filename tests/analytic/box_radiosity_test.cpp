// A closed box of equal reflectance against classical radiosity on a fine mesh
// (report/tools/selftest/box_radiosity.h): no ray and no random number in common with the program.
#include "report/tools/selftest/box_radiosity.h"
#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace box_radiosity_test {
namespace {

using namespace test_support;
using cli::selftest::BoxReference;

TEST(BoxRadiosity, PointsOfARoomAgreeWithTheMatrixSolution) {
  const glm::dvec3 size(4.0, 3.0, 2.5);
  const glm::dvec3 source(1.4, 1.1, 1.9);
  const double rho = 0.6, intensity = 100.0;
  calc::SensorGrid grid;
  grid.position_m = {{2, 1.5, 0.75}, {0.005, 1.5, 0.75}, {0.005, 0.005, 0.005}, {3.9, 2.9, 2.0},
                     {2, 1.5, 0.0},  {0.2, 2.995, 1.2},  {0.3, 1.0, 1.25}};
  grid.normal = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}};

  const auto direct = cli::selftest::isotropic_light(intensity, source);
  const BoxReference reference(size, cli::selftest::same_on_all(rho), direct);

  const calc::PhotometricWeb web = isotropic_web(intensity);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, size, rho);
  add_luminaire(scene, web, source);
  set_extent(scene);
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 21, 8192);
  const calc::PlaneField& field = solution.fields[0];
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    SCOPED_TRACE(i);
    const auto [truth, known_to] = reference.indirect_lx(grid.position_m[i], grid.normal[i]);
    const double mesh_error = known_to * truth;
    std::vector<double> indirect;
    for (std::size_t r = 0; r < field.replicates; ++r) {
      indirect.push_back(total_lx(field, r, i) - field.direct_exact_lx[i]);
    }
    const calc::Estimate measured = calc::t_interval(indirect, 0.999);
    std::printf("point %zu: matrix %.4f +- %.2f %%, luxgate %.4f +- %.2f %%, ratio %.4f\n", i,
                truth, 100 * mesh_error / truth, measured.value,
                100 * measured.half_width() / measured.value, measured.value / truth);
    EXPECT_LE(measured.low, truth + mesh_error);
    EXPECT_GE(measured.high, truth - mesh_error);
    EXPECT_NEAR(measured.value / truth, 1.0, 0.02);
    EXPECT_LT(mesh_error / truth, 0.02);  // the test must be able to see errors
    EXPECT_NEAR(field.direct_exact_lx[i], direct(grid.position_m[i], grid.normal[i]),
                1e-5 * field.direct_exact_lx[i]);
  }
}

}  // namespace
}  // namespace box_radiosity_test
