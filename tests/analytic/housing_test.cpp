// Luminaires as things: what their housings take of the room's light, and that they take nothing of
// their own.
#include "calc/scene/housing.h"

#include "calc/base/statistics.h"
#include "calc/scene/luminaire_sums.h"
#include "tests/support/facet_grid.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace housing_test {
namespace {

using namespace test_support;

// A luminaire of this photometry with a housing.
calc::Project project_of(calc::PhotometricWeb web, double depth_m, double reflectance = 0.0) {
  calc::Project project;
  project.materials.push_back({"housing", reflectance, {}});
  project.webs.push_back(std::move(web));
  calc::LuminaireType type;
  type.id = "lamp";
  type.housing = calc::Housing{0, depth_m, {}};
  project.luminaire_types.push_back(type);
  return project;
}

void add_housing(const calc::Project& project, const calc::Luminaire& luminaire,
                 calc::PreparedScene& scene, const calc::HousingMesh* mesh = nullptr) {
  for (const calc::Body& body : calc::housing_bodies(project, luminaire, mesh)) {
    for (const glm::uvec3& t : body.triangle) {
      add_triangle(scene, body.vertex_m[t.x], body.vertex_m[t.y], body.vertex_m[t.z],
                   project.materials[0].reflectance);
    }
  }
}

void add_housing(const calc::Project& project, const glm::dvec3& at, calc::PreparedScene& scene,
                 const calc::HousingMesh* mesh = nullptr) {
  calc::Luminaire luminaire;
  luminaire.id = "l";
  luminaire.position_m = at;
  luminaire.world_from_luminaire = glm::dmat3(1.0);
  add_housing(project, luminaire, scene, mesh);
}

struct Ball {
  double mean_lx, direct_lx;  // mean over the sphere; Phi / A
  double share;               // area of the housing / area of the sphere
};

// A luminous ball in the middle of a sphere of 1 m.
Ball ball_in_sphere(double sphere_reflectance, double housing_reflectance,
                    const calc::HousingMesh* mesh = nullptr) {
  const calc::Project project =
      project_of(calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi}, {100.0, 100.0},
                                            {calc::OpeningShape::ellipsoid, 0.6, 0.6, 0.6}, {}),
                 0.0, housing_reflectance);
  calc::PreparedScene scene;
  add_sphere(scene, 1.0, 1, sphere_reflectance);
  const FacetGrid facets = facet_grid(scene);
  const double sphere_m2 = surface_area_m2(scene);
  add_housing(project, {0, 0, 0}, scene, mesh);
  const double housing_m2 = surface_area_m2(scene) - sphere_m2;
  add_luminaire(scene, project.webs[0], {0, 0, 0});
  set_extent(scene);
  const calc::SpaceSolution solution = solve_with_paths(scene, facets.grid, 5, 512);
  const calc::PlaneField& field = solution.fields[0];
  EXPECT_EQ(field.problem, "");
  return {facet_mean(facets, field).value, project.webs[0].flux_lm() / sphere_m2,
          housing_m2 / sphere_m2};
}

TEST(Housing, TakesNothingOfItsOwnLight) {
  const Ball ball = ball_in_sphere(0.0, 0.0);
  EXPECT_NEAR(ball.mean_lx / ball.direct_lx, 1.0, 2e-3);
}

// Each reflection loses the share of the sphere's light that meets the convex body in it: its area
// by the sphere's.
TEST(Housing, AnAbsorbingLampInAnIntegratingSphere) {
  for (const double rho : {0.5, 0.9}) {
    SCOPED_TRACE(rho);
    const Ball ball = ball_in_sphere(rho, 0.0);
    ASSERT_GT(ball.share, 0.08);
    const double expected_lx = ball.direct_lx / (1.0 - rho * (1.0 - ball.share));
    EXPECT_NEAR(ball.mean_lx / expected_lx, 1.0, 4e-3);
    EXPECT_LT(ball.mean_lx, 0.97 * ball.direct_lx / (1.0 - rho));  // without a body
  }
}

// As a file would have it: triangles of an icosphere.
calc::HousingMesh icosphere(double radius_m) {
  calc::PreparedScene scene;
  add_sphere(scene, radius_m, 2, 0.0);
  return {{scene.vertex_m.begin(), scene.vertex_m.end()}, scene.triangle, true};
}

// The lamp is smaller than the luminous ball around it: what counts is its own area.
TEST(Housing, AnAbsorbingMeshInAnIntegratingSphere) {
  for (const double radius_m : {0.29, 0.2}) {
    SCOPED_TRACE(radius_m);
    const calc::HousingMesh mesh = icosphere(radius_m);
    const Ball ball = ball_in_sphere(0.9, 0.0, &mesh);
    ASSERT_NEAR(ball.share, radius_m * radius_m, 0.07 * radius_m * radius_m);
    const double expected_lx = ball.direct_lx / (1.0 - 0.9 * (1.0 - ball.share));
    EXPECT_NEAR(ball.mean_lx / expected_lx, 1.0, 4e-3);
    // Without a body it would be more, by more than the tolerance.
    EXPECT_LT(ball.mean_lx, 0.8 * ball.direct_lx / (1.0 - 0.9));
  }
}

// A white one gives back what it takes: the sphere's balance is that without it.
TEST(Housing, AWhiteLampTakesNothing) {
  const Ball ball = ball_in_sphere(0.8, 1.0);
  EXPECT_NEAR(ball.mean_lx * (1.0 - 0.8) / ball.direct_lx, 1.0, 4e-3);
}

double centre_factor(double half_m, double height_m) {
  const double x = half_m / height_m, root = std::sqrt(1.0 + x * x);
  return 4.0 / calc::kPi * x / root * std::atan(x / root);
}

// A black disk between a large luminous ceiling and a point: the ceiling less what the disk hides
// of it, and the disk's own light.
TEST(Housing, ADiskOverAPlaneHidesWhatItCovers) {
  constexpr double kCeiling_m = 3.0, kDisk_m = 1.5, kHalf_m = 3.0, kRadius_m = 0.4;
  constexpr double kCeilingLuminance = 100.0, kDiskLuminance = 700.0;
  const double disk_m2 = calc::kPi * kRadius_m * kRadius_m;
  const double disk_factor = kRadius_m * kRadius_m / (kRadius_m * kRadius_m + kDisk_m * kDisk_m);
  for (const double depth_m : {0.0, 0.2}) {
    SCOPED_TRACE(depth_m);
    const calc::Project project =
        project_of(lambert_web(kDiskLuminance * disk_m2, 900,
                               {calc::OpeningShape::disk, 2 * kRadius_m, 2 * kRadius_m, 0.0}),
                   depth_m);
    const double ceiling_m2 = 4.0 * kHalf_m * kHalf_m;
    const calc::PhotometricWeb ceiling =
        lambert_web(kCeilingLuminance * ceiling_m2, 900,
                    {calc::OpeningShape::rectangle, 2 * kHalf_m, 2 * kHalf_m, 0.0});
    calc::PreparedScene scene;
    add_housing(project, {0, 0, kDisk_m}, scene);
    add_luminaire(scene, ceiling, {0, 0, kCeiling_m});
    add_luminaire(scene, project.webs[0], {0, 0, kDisk_m});
    set_extent(scene);
    calc::SensorGrid grid;
    grid.position_m = {{0.0, 0.0, 0.0}};
    grid.normal = {{0, 0, 1}};
    const calc::SpaceSolution solution = solve_with_paths(scene, grid, 7, 256, 16, 4);
    const calc::Estimate lx = calc::t_interval(replicates_at(solution.fields[0], 0), 0.999);
    // The depth hides nothing more: its upper rim lies within the cone of the lower one.
    const double expected_lx =
        calc::kPi * (kCeilingLuminance * (centre_factor(kHalf_m, kCeiling_m) - disk_factor) +
                     kDiskLuminance * disk_factor);
    EXPECT_NEAR(lx.value / expected_lx, 1.0, 3e-3);
    EXPECT_LT(lx.low, expected_lx * 1.001);
    EXPECT_GT(lx.high, expected_lx * 0.999);
  }
}

// The corners of a box and its triangles, in an order of its own.
calc::HousingMesh box_mesh(const glm::dvec3& low_m, const glm::dvec3& high_m) {
  calc::HousingMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertex_m.emplace_back((i & 4u) != 0 ? high_m.x : low_m.x,
                               (i & 2u) != 0 ? high_m.y : low_m.y,
                               (i & 1u) != 0 ? high_m.z : low_m.z);
  }
  mesh.triangle = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                   {2, 3, 7}, {2, 7, 6}, {1, 5, 7}, {1, 7, 3}, {0, 2, 6}, {0, 6, 4}};
  mesh.is_closed = true;
  return mesh;
}

// A grey box on a lamp in a grey sphere, made by its depth and as a mesh.
TEST(Housing, AMeshOfABoxIsTheBox) {
  const calc::LuminousOpening opening{calc::OpeningShape::rectangle, 0.6, 0.4, 0.0};
  const calc::Project project = project_of(lambert_web(100.0, 90, opening), 0.3, 0.2);
  const calc::HousingMesh mesh = box_mesh({-0.3, -0.2, 0.0}, {0.3, 0.2, 0.3});
  const auto mean_lx = [&](const calc::HousingMesh* of_file) {
    calc::PreparedScene scene;
    add_sphere(scene, 1.0, 1, 0.7);
    const FacetGrid facets = facet_grid(scene);
    add_housing(project, {0, 0, 0}, scene, of_file);
    add_luminaire(scene, project.webs[0], {0, 0, 0});
    set_extent(scene);
    const calc::SpaceSolution solution = solve_with_paths(scene, facets.grid, 5, 256);
    EXPECT_EQ(solution.fields[0].problem, "");
    return facet_mean(facets, solution.fields[0]).value;
  };
  const double of_box_lx = mean_lx(nullptr);
  EXPECT_NEAR(mean_lx(&mesh) / of_box_lx, 1.0, 1e-3);
  const calc::HousingMesh half = box_mesh({-0.3, -0.2, 0.0}, {0.3, 0.2, 0.15});
  EXPECT_GT(mean_lx(&half) / of_box_lx, 1.01);
}

// Of a rectangle over a corner of it, at this height over the point and parallel to it.
double corner_factor(double x_m, double y_m, double height_m) {
  const double a = x_m / height_m, b = y_m / height_m;
  const double of_a = std::sqrt(1.0 + a * a), of_b = std::sqrt(1.0 + b * b);
  return (a / of_a * std::atan(b / of_a) + b / of_b * std::atan(a / of_b)) / (2.0 * calc::kPi);
}

// Two openings side by side below a luminous ceiling: without a depth their faces hide a part of it
// each, and the ceiling shines through between; the box hides that, too.
TEST(Housing, ABoxAroundTwoOpeningsHidesWhatIsBetween) {
  constexpr double kCeiling_m = 3.0, kLamp_m = 1.5, kHalf_m = 3.0;
  constexpr double kCeilingLuminance = 100.0, kLampLuminance = 700.0;
  constexpr double kNear_m = 0.3, kFar_m = 0.6, kAside_m = 0.4;  // of the openings, from the middle
  for (const double depth_m : {0.0, 0.15}) {
    SCOPED_TRACE(depth_m);
    const calc::LuminousOpening opening{calc::OpeningShape::rectangle, kFar_m - kNear_m,
                                        2 * kAside_m, 0.0};
    calc::Project project = project_of(
        lambert_web(kLampLuminance * opening.along_c0_m * opening.along_c90_m, 900, opening),
        depth_m);
    const double at_m = 0.5 * (kNear_m + kFar_m);
    project.luminaire_types[0].emitters = {{0, {{-at_m, 0, 0}, glm::dmat3(1.0)}},
                                           {1, {{at_m, 0, 0}, glm::dmat3(1.0)}}};
    project.luminaire_types.push_back(project.luminaire_types[0]);
    project.luminaire_types[1].id = "lamp/2";
    project.luminaire_types[1].emitters.clear();
    project.luminaire_types[1].is_further_emitter = true;
    calc::Luminaire whole;
    whole.id = "l";
    whole.position_m = {0, 0, kLamp_m};
    whole.world_from_luminaire = glm::dmat3(1.0);
    calc::PreparedScene scene;
    const calc::PhotometricWeb ceiling =
        lambert_web(kCeilingLuminance * 4.0 * kHalf_m * kHalf_m, 900,
                    {calc::OpeningShape::rectangle, 2 * kHalf_m, 2 * kHalf_m, 0.0});
    add_luminaire(scene, ceiling, {0, 0, kCeiling_m});
    for (const calc::Luminaire& one : calc::with_all_emitters(project, {whole})) {
      add_housing(project, one, scene);
      add_luminaire(scene, project.webs[0], one.position_m);
    }
    set_extent(scene);
    calc::SensorGrid grid;
    grid.position_m = {{0.0, 0.0, 0.0}};
    grid.normal = {{0, 0, 1}};
    const calc::SpaceSolution solution = solve_with_paths(scene, grid, 7, 256, 16, 4);
    const calc::Estimate lx = calc::t_interval(replicates_at(solution.fields[0], 0), 0.999);
    const double gap = 4.0 * corner_factor(kNear_m, kAside_m, kLamp_m);
    const double lamps = 4.0 * corner_factor(kFar_m, kAside_m, kLamp_m) - gap;
    const double hidden = depth_m > 0.0 ? lamps + gap : lamps;
    ASSERT_GT(gap, 0.03);
    const double expected_lx =
        calc::kPi * (kCeilingLuminance * (centre_factor(kHalf_m, kCeiling_m) - hidden) +
                     kLampLuminance * lamps);
    EXPECT_NEAR(lx.value / expected_lx, 1.0, 3e-3);
  }
}

}  // namespace
}  // namespace housing_test
