// E = I cos(theta) / d^2 from a tabulated isotropic point source; tolerance 1e-6 relative.
#include "calc/radiosity/looks/solve.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace inverse_square_cosine_test {
namespace {

using namespace test_support;

TEST(InverseSquareCosine, HoldsForTiltedReceiversAtAnyDistance) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0.3, -0.2, 2.5});
  set_extent(scene);
  calc::SensorGrid grid;
  const std::vector<glm::dvec3> positions{
      {0, 0, 0}, {2, 1, 0.75}, {0.3, -0.2, 2.49}, {-800, 300, 1}};
  const std::vector<glm::dvec3> normals{{0, 0, 1},
                                        glm::normalize(glm::dvec3(-1, 0.5, 2)),
                                        {0, 0, 1},
                                        glm::normalize(glm::dvec3(1, 0.1, 0.1))};
  grid.position_m = positions;
  grid.normal = normals;
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 1, 16);
  const calc::PlaneField& field = solution.fields[0];
  EXPECT_TRUE(field.is_exact());
  EXPECT_EQ(field.counters.connection_rays, 0u);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 w = scene.luminaires[0].position_m - positions[i];
    const double d = glm::length(w);
    const double expected = 100.0 * glm::dot(normals[i], w) / (d * d * d);
    ASSERT_GT(expected, 0.0);
    EXPECT_NEAR(field.direct_exact_lx[i] / expected, 1.0, 1e-6) << "point " << i;
  }
}

TEST(InverseSquareCosine, IsZeroBehindTheReceiverAndBehindAnOccluder) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_quad(scene, {-0.5, -0.5, 1.0}, {1, 0, 0}, {0, 1, 0}, 0.0);
  add_luminaire(scene, web, {0, 0, 2});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0, 0, 0}, {0, 0, 1.5}, {3, 0, 0}};
  grid.normal = {{0, 0, 1}, {0, 0, -1}, {0, 0, 1}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 1, 16);
  EXPECT_EQ(solution.fields[0].direct_exact_lx[0], 0.0);
  EXPECT_EQ(solution.fields[0].direct_exact_lx[1], 0.0);
  EXPECT_GT(solution.fields[0].direct_exact_lx[2], 0.0);
}

TEST(InverseSquareCosine, ALuminaireFlushWithTheCeilingIsNotHiddenByIt) {
  const calc::PhotometricWeb web = lambert_web(1000.0, 90);
  calc::PreparedScene scene;
  add_quad(scene, {-7, -5, 2.8}, {14, 0, 0}, {0, 10, 0}, 0.0);
  add_luminaire(scene, web, {0.1, 0.2, 2.8});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0, 0, 0}, {6.9, 4.0, 2.79}, {-6.0, -4.9, 2.7999}};  // grazing ones too
  grid.normal = {{0, 0, 1}, {-1, 0, 0}, {1, 0, 0}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 1, 16);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(solution.fields[0].direct_exact_lx[i], 0.0) << "point " << i;
  }
}

TEST(InverseSquareCosine, APointAtALuminaireIsRefused) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 1});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{5, 0, 0}, {0, 0, 1}};
  grid.normal = {{0, 0, 1}, {0, 0, 1}};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 1, 16);
  EXPECT_EQ(solution.fields[0].problem,
            "the point (0 0 1) is at a luminaire without size, where illuminance has no bound");
}

}  // namespace
}  // namespace inverse_square_cosine_test
