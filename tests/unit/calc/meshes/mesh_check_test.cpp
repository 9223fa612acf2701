#include "calc/meshes/mesh_check.h"

#include <gtest/gtest.h>

#include <limits>

namespace calc::mesh_check_test {
namespace {

// A box of the given size without the faces named in `without` (pairs of triangles, 0 to 5).
SurfaceModel box(const glm::dvec3& size, std::size_t without = 6, const glm::dvec3& at = {}) {
  const std::vector<glm::uvec3> triangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                          {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                          {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  SurfaceModel model;
  for (unsigned i = 0; i < 8; ++i) {
    model.vertex_m.push_back(at + size * glm::dvec3(i & 1u, (i >> 1u) & 1u, (i >> 2u) & 1u));
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t / 2 == without) continue;
    model.triangle.push_back(triangles[t]);
    model.object_of.push_back(0);
    model.material_of.push_back(t < 2 ? 1 : 0);
  }
  model.object_name = {"box"};
  model.material_name = {"sides", "bottom"};
  return model;
}

std::string warnings(const SurfaceModel& model) {
  Diagnostics diagnostics;
  warn_about_surface(check_surface(model), {"m", 0, 0}, diagnostics);
  std::string text;
  for (const Diagnostic& d : diagnostics.all()) text += diagnostic_name(d.id) + " ";
  return text;
}

TEST(MeshCheck, AClosedBoxHasNothingWrong) {
  const SurfaceFindings found = check_surface(box({2, 3, 4}));
  EXPECT_EQ(found.triangles, 12u);
  EXPECT_DOUBLE_EQ(found.area_m2, 52.0);
  EXPECT_EQ(found.edges, 18u);
  EXPECT_EQ(found.open_edges + found.crowded_edges + found.duplicates + found.degenerate, 0u);
  EXPECT_TRUE(found.is_watertight);
  EXPECT_EQ(found.bounds_m.upper, glm::dvec3(2, 3, 4));
  ASSERT_EQ(found.materials.size(), 2u);
  EXPECT_DOUBLE_EQ(found.materials[1].area_m2, 6.0);
  EXPECT_EQ(found.materials[1].triangles, 2u);
  EXPECT_EQ(found.objects[0].triangles, 12u);
  EXPECT_EQ(warnings(box({2, 3, 4})), "");
}

TEST(MeshCheck, AMissingFaceOpensFourEdges) {
  const SurfaceFindings found = check_surface(box({2, 3, 4}, 1));
  EXPECT_EQ(found.open_edges, 4u);
  EXPECT_FALSE(found.is_watertight);
}

TEST(MeshCheck, CornersAtTheSamePlaceAreOne) {
  SurfaceModel model = box({2, 3, 4});
  SurfaceModel apart = model;
  apart.vertex_m.clear();
  for (glm::uvec3& t : apart.triangle) {
    for (glm::uvec3::length_type i = 0; i < 3; ++i) {
      apart.vertex_m.push_back(model.vertex_m[t[i]]);
      t[i] = static_cast<unsigned>(apart.vertex_m.size() - 1);
    }
  }
  EXPECT_TRUE(check_surface(apart).is_watertight);
}

TEST(MeshCheck, DuplicatesAreFoundWhateverTheirFirstCorner) {
  SurfaceModel model = box({2, 3, 4});
  model.triangle.emplace_back(3, 2, 0);
  model.object_of.push_back(0);
  model.material_of.push_back(0);
  const SurfaceFindings found = check_surface(model);
  EXPECT_EQ(found.duplicates, 1u);
  EXPECT_EQ(found.crowded_edges, 3u);
  EXPECT_FALSE(found.is_watertight);
  EXPECT_EQ(warnings(model), "surface-duplicates surface-crowded-edges ");
}

TEST(MeshCheck, TrianglesWithoutAreaOrWithNanAreCounted) {
  SurfaceModel model = box({2, 3, 4});
  model.faces_left_out = 2;
  model.triangle[0] = {0, 1, 1};
  model.vertex_m.emplace_back(std::numeric_limits<double>::quiet_NaN());
  model.triangle[1] = {0, 1, 8};
  const SurfaceFindings found = check_surface(model);
  EXPECT_EQ(found.degenerate, 3u);
  EXPECT_EQ(found.not_finite, 1u);
  EXPECT_DOUBLE_EQ(found.area_m2, 46.0);
  EXPECT_EQ(warnings(model), "surface-not-finite surface-degenerate ");
}

TEST(MeshCheck, SuspectUnitsAndFarOriginsAreWarnedOf) {
  EXPECT_EQ(warnings(box({4000, 3000, 2800})), "surface-too-large surface-far-away ");
  EXPECT_EQ(warnings(box({0.004, 0.003, 0.0028})), "surface-too-small ");
  EXPECT_EQ(warnings(box({4, 3, 2.8}, 6, {14678, 0, 9600})), "surface-far-away ");
  EXPECT_EQ(warnings(box({290, 0.01, 0.01}, 6, {1000, 0, 0})), "");
  EXPECT_NEAR(check_surface(box({1, 1, 1}, 6, {16383, 0, 0})).float_step_m, 0.00195, 1e-5);
}

TEST(MeshCheck, MeshesBecomeMetresWithZUp) {
  TriangleMesh mesh;
  mesh.vertex = {{1, 2, 3}, {0, 0, 0}, {1, 0, 0}};
  mesh.triangle = {{0, 1, 2}};
  mesh.material_of = mesh.object_of = {0};
  mesh.material_name = mesh.object_name = {"m"};
  EXPECT_EQ(surface_of(mesh, 0.5, true).vertex_m[0], glm::dvec3(0.5, -1.5, 1.0));
  EXPECT_EQ(surface_of(mesh, 2.0, false).vertex_m[0], glm::dvec3(2, 4, 6));
}

}  // namespace
}  // namespace calc::mesh_check_test
