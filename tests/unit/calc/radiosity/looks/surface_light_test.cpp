#include "calc/radiosity/looks/surface_light.h"

#include "calc/base/statistics.h"
#include "calc/radiosity/direct/emission.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surface_light_test {
namespace {

using namespace test_support;

std::vector<calc::SurfaceSide> sides_of(const calc::PreparedScene& scene, const glm::dvec3& eye_m) {
  return calc::cut_away(calc::Tracer(scene), eye_m, false).shown;
}

// E = I h / d^3 on a black floor; between corners of the mesh, linear.
TEST(SurfaceLight, IsThatOfAPointSource) {
  const calc::PhotometricWeb web = isotropic_web(200.0);
  calc::PreparedScene scene;
  add_quad(scene, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0.0);
  add_luminaire(scene, web, {0.5, 0.2, 1.5});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::LitSurfaces lit =
      calc::light_surfaces(scene, sides_of(scene, {0, 0, 9}), {}, *gatherer);
  ASSERT_EQ(lit.problem, "");
  EXPECT_GT(lit.lx.size(), 1000u);
  EXPECT_EQ(lit.error_share, 0.0);
  for (std::size_t i = 0; i < lit.lx.size(); ++i) {
    const double d = glm::distance(glm::dvec3(lit.position_m[i]), glm::dvec3(0.5, 0.2, 1.5));
    // Corners on the rim are estimated up to 1 cm inside.
    EXPECT_NEAR(static_cast<double>(lit.lx[i]) / (200.0 * 1.5 / (d * d * d)), 1.0, 0.03);
  }
  for (const glm::uvec3& t : lit.triangle) {
    const glm::vec3 turn = glm::cross(lit.position_m[t.y] - lit.position_m[t.x],
                                      lit.position_m[t.z] - lit.position_m[t.x]);
    EXPECT_GT(turn.z, 0.0f);
  }
}

// No gaps: the mesh has the floor's area, and every inner edge two triangles.
TEST(SurfaceLight, MeshIsWhole) {
  const calc::PhotometricWeb web = lambert_web(500.0, 18);
  calc::PreparedScene scene;
  add_quad(scene, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0.3);
  add_quad(scene, {-0.3, -0.3, 0.5}, {0.6, 0, 0}, {0, 0.6, 0}, 0.3);
  add_luminaire(scene, web, {0.1, 0.2, 2.0});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  const auto sides = sides_of(scene, {0, 0, 9});
  const calc::LitSurfaces lit = calc::light_surfaces(scene, sides, {}, *gatherer);
  ASSERT_EQ(lit.problem, "");
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double area = 0.0;
  ASSERT_EQ(lit.side.size(), lit.triangle.size());
  for (const glm::uvec3& t : lit.triangle) {
    area += 0.5 *
            static_cast<double>(glm::length(glm::cross(lit.position_m[t.y] - lit.position_m[t.x],
                                                       lit.position_m[t.z] - lit.position_m[t.x])));
    for (int k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
  }
  EXPECT_NEAR(area, 16.0 + 0.36, 1e-3);
  for (const auto& [edge, count] : edges) {
    ASSERT_LE(count, 2);
    if (count == 2) continue;
    const glm::vec3 m = 0.5f * (lit.position_m[edge.first] + lit.position_m[edge.second]);
    const float reach = std::max(std::abs(m.x), std::abs(m.y));
    EXPECT_NEAR(reach, m.z > 0.1f ? 0.3f : 2.0f, 1e-4f);
  }
  // Right below the plate there is its shadow, and the mesh is finer at the shadow's edge.
  for (std::size_t i = 0; i < lit.lx.size(); ++i) {
    const glm::vec3& p = lit.position_m[i];
    if (p.z < 0.1f && std::abs(p.x) < 0.2f && std::abs(p.y) < 0.2f) {
      EXPECT_LT(lit.lx[i], 20.0f);
    }
  }
}

// Inside a sphere all light is as bright everywhere: E = I / r^2 (1 + rho / (1 - rho)).
TEST(SurfaceLight, HasTheIndirectPart) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_sphere(scene, 1.0, 2, 0.5);
  add_luminaire(scene, web, {0, 0, 0});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::Cutaway cut = calc::cut_away(calc::Tracer(scene), {0, -9, 5}, true);
  EXPECT_GT(cut.shown.size(), 100u);
  EXPECT_GT(cut.removed.size(), 100u);
  const calc::LitSurfaces lit = calc::light_surfaces(scene, cut.shown, {}, *gatherer);
  ASSERT_EQ(lit.problem, "");
  double sum = 0.0;
  for (const float lx : lit.lx) sum += static_cast<double>(lx);
  EXPECT_NEAR(sum / static_cast<double>(lit.lx.size()), 200.0, 8.0);
  EXPECT_GT(lit.error_share, 0.0);
  EXPECT_LT(lit.error_share, 0.1);
}

// Against the light of planes at many paths: corners that the mesh was refined by, at the edge of a
// shadow, have their indirect light from their neighbours.
TEST(SurfaceLight, IsThatOfPlanesAtRefinedCornersToo) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 18, {calc::OpeningShape::rectangle, 0.6, 0.6});
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.8}, 0.6);
  add_box(scene, {1.2, 0.9, 0.7}, {1.4, 0.8, 0.04}, 0.4);
  add_luminaire(scene, web, {1.6, 1.2, 2.7});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::LitSurfaces lit =
      calc::light_surfaces(scene, sides_of(scene, {2, 1.5, 40}), {}, *gatherer);
  ASSERT_EQ(lit.problem, "");
  calc::SensorGrid grid;
  std::vector<double> lx;
  for (std::size_t i = 0; i < lit.lx.size(); ++i) {  // of the floor
    const glm::dvec3 p(lit.position_m[i]);
    if (p.z > 1e-3 || p.x < 0.1 || p.x > 3.9 || p.y < 0.1 || p.y > 2.9) continue;
    grid.position_m.push_back(p);
    grid.normal.emplace_back(0, 0, 1);
    lx.push_back(static_cast<double>(lit.lx[i]));
  }
  ASSERT_GT(lx.size(), 400u);
  const calc::SpaceSolution reference = solve_with_paths(scene, grid, 7, 1024, 8);
  const calc::PlaneField& field = reference.fields.front();
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < lx.size(); ++i) {
    const double off = lx[i] / calc::replicate_mean(replicates_at(field, i)).mean - 1.0;
    mean += off / static_cast<double>(lx.size());
    square += off * off / static_cast<double>(lx.size());
  }
  EXPECT_NEAR(mean, 0.0, 0.02);  // 4 times 512 paths know the average to 0.7 %
  EXPECT_LT(std::sqrt(square), 0.06);
}

TEST(SurfaceLight, IsTheSameForAnyNumberOfThreads) {
  const calc::PhotometricWeb web = lambert_web(500.0, 18);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {2, 3, 2}, 0.5);
  add_luminaire(scene, web, {0.7, 0.9, 1.9});
  set_extent(scene);
  const auto sides = sides_of(scene, {1, 1, 1});
  calc::SurfaceLightSettings settings;
  settings.points = 300;
  settings.jobs = 1;
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::LitSurfaces one = calc::light_surfaces(scene, sides, settings, *gatherer);
  settings.jobs = 4;
  const calc::LitSurfaces four = calc::light_surfaces(scene, sides, settings, *gatherer);
  EXPECT_EQ(one.lx, four.lx);
  EXPECT_EQ(one.error_share, four.error_share);
}

TEST(SurfaceLight, SaysWhyThereIsNone) {
  const calc::PhotometricWeb web = lambert_web(500.0, 18);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {2, 3, 2}, 0.5);
  add_luminaire(scene, web, {0.7, 0.9, 1.9});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  calc::SurfaceLightSettings settings;
  settings.most_points = 10;
  const auto sides = sides_of(scene, {1, 1, 1});
  EXPECT_EQ(calc::light_surfaces(scene, sides, settings, *gatherer).problem,
            "the room has too many surfaces for a picture");
  settings.most_points = 60'000;
  settings.points = 300;
  settings.go_on = [] { return false; };
  EXPECT_NE(calc::light_surfaces(scene, sides, settings, *gatherer).problem, "");
}

// A luminaire without size in the ceiling: its corner takes a neighbour's value, nothing fails.
TEST(SurfaceLight, PassesOverPointsAtALuminaire) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_quad(scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0.3);
  add_luminaire(scene, web, {0, 0, 0});
  set_extent(scene);
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::LitSurfaces lit =
      calc::light_surfaces(scene, sides_of(scene, {0, 0, 9}), {}, *gatherer);
  ASSERT_EQ(lit.problem, "");
  for (const float lx : lit.lx) EXPECT_TRUE(std::isfinite(lx));
}

}  // namespace
}  // namespace surface_light_test
