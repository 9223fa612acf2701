#include "calc/radiosity/paths/path_tracing.h"

#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace path_tracing_test {
namespace {

using namespace test_support;

std::vector<double> indirect_averages(const calc::PlaneField& field) {
  std::vector<double> means(field.replicates, 0.0);
  const std::size_t per_replicate = field.indirect_lx.size() / field.replicates;
  for (std::size_t k = 0; k < field.indirect_lx.size(); ++k) {
    means[k / per_replicate] += field.indirect_lx[k] / static_cast<double>(field.points);
  }
  return means;
}

// Points on a sphere's facets, looking inwards.
calc::SensorGrid facet_centres(const calc::PreparedScene& scene, double highest_z) {
  calc::SensorGrid grid;
  for (const glm::uvec3& t : scene.triangle) {
    const glm::dvec3 a(scene.vertex_m[t.x]), b(scene.vertex_m[t.y]), c(scene.vertex_m[t.z]);
    const glm::dvec3 centre = (a + b + c) / 3.0;
    if (centre.z > highest_z) continue;
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    grid.position_m.push_back(centre);
    grid.normal.push_back(glm::dot(normal, centre) > 0.0 ? -normal : normal);
  }
  return grid;
}

// E_ind = Phi / (4 pi r^2) rho / (1 - rho); the tessellated sphere's area counts.
TEST(PathTracing, IntegratingSphere) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_sphere(scene, 1.5, 2, 0.8);
  add_luminaire(scene, web, {0, 0, 0});
  set_extent(scene);
  const calc::SensorGrid grid = facet_centres(scene, 2.0);
  const calc::Tracer tracer(scene);
  const calc::PlaneField field = calc::trace_from_points(tracer, "plane", grid, {16, 16, 3, {}});
  ASSERT_EQ(field.problem, "");
  const calc::Estimate mean = calc::t_interval(indirect_averages(field), 0.999);
  const double closed = web.flux_lm() / surface_area_m2(scene) * 0.8 / 0.2;
  EXPECT_NEAR(mean.value / closed, 1.0, 0.01);
  EXPECT_LT(mean.half_width() / closed, 0.02);
}

// About half a sphere, open above, a source in its centre: every part sees what is left with a form
// factor of f, its share of the sphere, so that E_ind = f rho E_0 / (1 - f rho).
TEST(PathTracing, OpenSphere) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene whole, scene;
  add_sphere(whole, 1.5, 3, 0.8);
  scene.vertex_m = whole.vertex_m;
  for (const glm::uvec3& t : whole.triangle) {
    const float z = whole.vertex_m[t.x].z + whole.vertex_m[t.y].z + whole.vertex_m[t.z].z;
    if (z >= 0.0f) continue;
    scene.triangle.push_back(t);
    scene.reflectance.push_back(0.8);
    scene.body.push_back(0);
  }
  const double f = surface_area_m2(scene) / surface_area_m2(whole);
  ASSERT_NEAR(f, 0.5, 0.05);
  add_luminaire(scene, web, {0, 0, 0});
  set_extent(scene);
  const calc::SensorGrid grid = facet_centres(scene, 0.0);
  const calc::Tracer tracer(scene);
  const calc::PlaneField field = calc::trace_from_points(tracer, "plane", grid, {8, 16, 4, {}});
  const calc::Estimate mean = calc::t_interval(indirect_averages(field), 0.999);
  const double direct_lx = web.flux_lm() / surface_area_m2(whole);
  EXPECT_NEAR(mean.value / (direct_lx * 0.8 * f / (1.0 - 0.8 * f)), 1.0, 0.02);  // facets: 1 %
}

// One reflecting floor, a source above, a point looking down: one reflection, a plain integral.
TEST(PathTracing, FloorAlone) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_quad(scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0.7);
  add_luminaire(scene, web, {0.4, 0, 1.2});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{-0.3, 0.2, 0.9}};
  grid.normal = {{0, 0, -1}};
  double expected = 0.0;
  constexpr int kCells = 400;
  for (int i = 0; i < kCells * kCells; ++i) {
    const glm::dvec3 y(-1.0 + 2.0 * (i % kCells + 0.5) / kCells,
                       -1.0 + 2.0 * (i / kCells + 0.5) / kCells, 0.0);
    const glm::dvec3 to_light = glm::dvec3(0.4, 0, 1.2) - y, to_point = grid.position_m[0] - y;
    const double direct_lx = 100.0 * to_light.z / std::pow(glm::length(to_light), 3);
    expected += 0.7 * direct_lx / calc::kPi * to_point.z * to_point.z /
                std::pow(glm::length(to_point), 4) * 4.0 / (kCells * kCells);
  }
  const calc::Tracer tracer(scene);
  const calc::PlaneField field = calc::trace_from_points(tracer, "plane", grid, {4096, 16, 5, {}});
  const calc::Estimate found = calc::t_interval(indirect_averages(field), 0.999);
  EXPECT_NEAR(found.value / expected, 1.0, 5e-3);
  EXPECT_LT(found.half_width() / expected, 5e-3);
  EXPECT_EQ(total_lx(field, 0, 0) - field.indirect_lx[0], field.direct_exact_lx[0]);
}

struct Comparison {
  const char* name;
  calc::ReceiverKernel kernel;
  bool is_open, is_extended;
};

class PathTracingAndTheCore : public testing::TestWithParam<Comparison> {};

TEST_P(PathTracingAndTheCore, AgreeWithinTheirIntervals) {
  const Comparison& what = GetParam();
  const calc::PhotometricWeb web =
      what.is_extended ? lambert_web(300.0, 36, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0})
                       : lambert_web(300.0, 36);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
  if (what.is_open) {  // without its lid
    scene.triangle.erase(scene.triangle.begin() + 2, scene.triangle.begin() + 4);
    scene.reflectance.resize(10);
    scene.body.resize(10);
  }
  add_box(scene, {1.6, 0.8, 0}, {0.8, 0.8, 0.7}, 0.3);  // furniture
  add_luminaire(scene, web, {1, 1.5, 2.3});
  add_luminaire(scene, web, {3, 1.0, 2.3});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.kernel = what.kernel;
  for (const glm::dvec3& p : {glm::dvec3(0.5, 0.5, 0.8), glm::dvec3(2.6, 1.2, 0.3),
                              glm::dvec3(3.9, 2.9, 0.8), glm::dvec3(2.0, 0.02, 1.1)}) {
    grid.position_m.push_back(p);
    grid.normal.emplace_back(0, 0, 1);
  }
  const calc::Tracer tracer(scene);
  const calc::PlaneField paths = calc::trace_from_points(tracer, "plane", grid, {1024, 16, 6, {}});
  ASSERT_EQ(paths.problem, "");
  const calc::PlaneField core = solve_with_paths(scene, grid, 7, 2048).fields[0];
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    const calc::ReplicateMean a = calc::replicate_mean(replicates_at(paths, i));
    const calc::ReplicateMean b = calc::replicate_mean(replicates_at(core, i));
    const double error = std::hypot(a.standard_error, b.standard_error);
    EXPECT_NEAR(a.mean, b.mean, 4.5 * error) << i;  // 1 in 2,000 for 15 degrees of freedom
    EXPECT_LT(error / b.mean, 0.01) << i;
    EXPECT_GT(a.standard_error, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rooms, PathTracingAndTheCore,
    testing::Values(Comparison{"closed", calc::ReceiverKernel::planar, false, false},
                    Comparison{"open", calc::ReceiverKernel::planar, true, false},
                    Comparison{"extended", calc::ReceiverKernel::planar, false, true},
                    Comparison{"cylindrical", calc::ReceiverKernel::cylindrical, false, false}),
    [](const auto& room) { return std::string(room.param.name); });

TEST(PathTracing, SameBitsForAnyOrderAndOtherBitsForOtherSeeds) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {3, 3, 3}, 0.5);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0.5, 0.5, 0.8}, {2.0, 1.0, 0.8}};
  grid.normal = {{0, 0, 1}, {0, 0, 1}};
  const calc::Tracer tracer(scene);
  const auto lx = [&](std::uint64_t seed) {
    return calc::trace_from_points(tracer, "plane", grid, {32, 4, seed, {}}).indirect_lx;
  };
  EXPECT_EQ(lx(1), lx(1));
  EXPECT_NE(lx(1), lx(2));
}

TEST(PathTracing, StopsWhenAsked) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {3, 3, 3}, 0.5);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0.5, 0.5, 0.8}};
  grid.normal = {{0, 0, 1}};
  const calc::Tracer tracer(scene);
  const calc::PlaneField field =
      calc::trace_from_points(tracer, "plane", grid, {1u << 30, 64, 1, [] { return false; }});
  EXPECT_EQ(field.stop, calc::StopReason::interrupted);
  EXPECT_NE(field.problem, "");
  EXPECT_EQ(field.counters.near_rays, 0u);
}

TEST(PathTracing, SaysWhenAPathNeverEnds) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {3, 3, 3}, 1.0);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{0.5, 0.5, 0.8}};
  grid.normal = {{0, 0, 1}};
  const calc::Tracer tracer(scene);
  EXPECT_NE(calc::trace_from_points(tracer, "plane", grid, {1, 2, 1, {}}).problem, "");
}

}  // namespace
}  // namespace path_tracing_test
