#include "calc/scene/prepared_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace calc::prepared_scene_test {
namespace {

PhotometricWeb uniform_web(LuminousOpening opening = {}) {
  return PhotometricWeb::make({0.0}, {0.0, 3.141592653589793}, {100.0, 100.0}, opening, {});
}

Project project_with(std::vector<double> reflectances) {
  Project project;
  for (const double reflectance : reflectances) {
    project.materials.push_back({"m" + std::to_string(project.materials.size()), reflectance, {}});
  }
  return project;
}

void add_type(Project& project, double maintenance_factor, LuminousOpening opening = {}) {
  LuminaireType type;
  type.web = project.webs.size();
  type.flux_scale = 0.5;
  type.maintenance.product = maintenance_factor;
  project.webs.push_back(uniform_web(opening));
  project.luminaire_types.push_back(type);
}

Luminaire luminaire(std::size_t type, glm::dvec3 position_m, std::string group = "") {
  Luminaire made;
  made.type = type;
  made.position_m = position_m;
  made.world_from_luminaire = glm::dmat3(1.0);
  made.group = std::move(group);
  return made;
}

Body body(std::vector<glm::dvec3> vertices, std::vector<glm::uvec3> triangles,
          std::vector<std::uint32_t> materials) {
  Body made;
  made.vertex_m = std::move(vertices);
  made.triangle = std::move(triangles);
  made.material_of = std::move(materials);
  return made;
}

TEST(PreparedScene, AnEmptySpaceHasAnExtentOfOne) {
  const PreparedScene scene = prepare_scene(Project{}, Space{});
  EXPECT_EQ(scene.extent_m, 1.0);
  EXPECT_EQ(scene.origin_m, glm::dvec3(0.0));
  EXPECT_TRUE(scene.triangle.empty());
  EXPECT_TRUE(scene.channels.empty());
  EXPECT_GT(scene.ray_offset_m(), 0.0);
}

TEST(PreparedScene, OneLuminaireAloneIsTheOrigin) {
  Project project;
  add_type(project, 0.8);
  Space space;
  space.luminaires = {luminaire(0, {3, 4, 5})};
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.origin_m, glm::dvec3(3, 4, 5));
  EXPECT_EQ(scene.luminaires[0].position_m, glm::dvec3(0.0));
  EXPECT_EQ(scene.extent_m, 1.0);
}

TEST(PreparedScene, TheOriginIsTheCentreOfBodiesAndLuminaires) {
  Project project = project_with({0.5});
  add_type(project, 0.8);
  Space space;
  space.bodies = {body({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, {{0, 1, 2}}, {0})};
  space.luminaires = {luminaire(0, {2, 2, 7})};
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.origin_m, glm::dvec3(2, 2, 3.5));
  EXPECT_DOUBLE_EQ(scene.extent_m, 9.0);
  EXPECT_EQ(scene.vertex_m[0], glm::vec3(-2, -2, -3.5));
  EXPECT_EQ(scene.luminaires[0].position_m, glm::dvec3(0, 0, 3.5));
}

TEST(PreparedScene, FarFromTheOriginMicrometresAreKept) {
  Project project = project_with({0.5});
  add_type(project, 0.8);
  const glm::dvec3 far(1.0e6, -1.0e6, 1.0e6);
  const std::vector<glm::dvec3> corners = {
      {0.123456789, 0, 0}, {5.00001, 0, 0.3}, {5, 3.98765, 2.7}};
  Space space;
  space.bodies = {body({far + corners[0], far + corners[1], far + corners[2]}, {{0, 1, 2}}, {0})};
  space.luminaires = {luminaire(0, far + glm::dvec3(2.5, 2.0, 2.654321))};
  const PreparedScene scene = prepare_scene(project, space);
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double back =
          static_cast<double>(scene.vertex_m[i][axis]) + (scene.origin_m - far)[axis];
      EXPECT_NEAR(back, corners[i][axis], 1.0e-6);
    }
  }
  EXPECT_NEAR((scene.luminaires[0].position_m + scene.origin_m - far).z, 2.654321, 1.0e-6);
}

// A yard of 4 x 4 m below a luminaire, a house that is far off, and a hillside from here to there.
TEST(PreparedScene, FarGeometryMovesNoEndOfARay) {
  Project project = project_with({0.5});
  add_type(project, 0.8);
  Space space;
  space.bodies = {body({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}}, {{0, 1, 2}}, {0})};
  space.luminaires = {luminaire(0, {0, 0, 6})};
  PlanarArea yard;
  yard.outline_m = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  CalcPlane plane;
  plane.area = yard;
  space.planes = {plane};
  const double alone_m = prepare_scene(project, space).ray_offset_m();
  space.bodies.push_back(body({{3000, 0, 0}, {3010, 0, 0}, {3000, 10, 0}}, {{0, 1, 2}}, {0}));
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_LT(scene.ray_offset_m(), 8.0 * alone_m);
  EXPECT_LT(scene.extent_m, 100.0);
  EXPECT_GT(scene.whole_extent_m(), 3000.0);
  EXPECT_EQ(scene.triangle.size(), 2u) << "it is there, and lit";

  // Float rounding moves a surface here if one of its corners is far away and it is not level.
  space.bodies.push_back(
      body({{-3, -3, 0.1}, {3000.1, -3, 123.4}, {-3, 3000.3, 77.7}}, {{0, 1, 2}}, {0}));
  const PreparedScene hill = prepare_scene(project, space);
  EXPECT_GT(hill.rounding_m, 1e-6);
  EXPECT_GE(hill.ray_offset_m(), 8.0 * hill.rounding_m);
}

TEST(PreparedScene, WhatLiesBeyondAClosedRoomIsLeftOut) {
  Project project = project_with({0.5});
  add_type(project, 0.8);
  Space space;
  space.shell = RoomShell{{{0, 0}, {5, 0}, {5, 4}, {0, 4}}, 0.0, 3.0};
  space.luminaires = {luminaire(0, {2.5, 2, 2.9})};
  const auto wall = [](double x) {
    return body({{x, 0, 0}, {x, 4, 0}, {x, 4, 3}}, {{0, 1, 2}}, {0});
  };
  space.bodies = {wall(0), wall(5)};
  const PreparedScene alone = prepare_scene(project, space);
  EXPECT_EQ(alone.triangle.size(), 2u) << "its own walls are no nearer than it";
  space.bodies.push_back(wall(10000));
  space.bodies.push_back(wall(-0.1));
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.triangle.size(), 2u);
  EXPECT_LT(scene.ray_offset_m(), 16.0 * alone.ray_offset_m());
}

TEST(PreparedScene, TrianglesKnowTheirReflectanceAndBody) {
  const Project project = project_with({0.2, 0.7});
  Space space;
  space.bodies = {
      body({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {1}),
      body({{9, 9, 9}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{1, 2, 3}, {3, 2, 1}}, {0, 1})};
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.reflectance, (std::vector<double>{0.7, 0.2, 0.7}));
  EXPECT_EQ(scene.body, (std::vector<std::uint32_t>{0, 1, 1}));
  EXPECT_EQ(scene.triangle[1], glm::uvec3(4, 5, 6)) << "indices into the one list of vertices";
}

TEST(PreparedScene, DegenerateTrianglesAreCountedAndLeftOut) {
  const Project project = project_with({0.2, 0.7});
  Space space;
  space.bodies = {body({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                       {{0, 1, 2}, {0, 1, 1}, {1, 4, 3}, {0, 2, 3}}, {0, 0, 0, 1})};
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.degenerate_triangles, 3u);
  ASSERT_EQ(scene.triangle.size(), 1u);
  EXPECT_EQ(scene.triangle[0], glm::uvec3(0, 2, 3));
  EXPECT_EQ(scene.reflectance, std::vector<double>{0.7});
}

TEST(PreparedScene, TrianglesThatFloatCannotHoldAreCounted) {
  const Project project = project_with({0.5});
  Space space;  // 100 m away from the centre a float step is 7.6e-6 m
  space.bodies = {body({{-100, 0, 0}, {100, 0, 0}, {100, 1e-7, 0}, {100, 0, 1e-7}, {100, 0.1, 0}},
                       {{1, 2, 3}, {0, 1, 4}}, {0, 0})};
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.degenerate_triangles, 0u) << "near y = z = 0 it can";
  space.bodies[0].vertex_m.push_back({-100, 200, 200});
  const PreparedScene shifted = prepare_scene(project, space);
  EXPECT_EQ(shifted.degenerate_triangles, 1u);
  EXPECT_EQ(shifted.triangle.size(), 1u);
}

TEST(PreparedScene, NeedlesAndTinyTrianglesAreKept) {
  const Project project = project_with({0.5});
  Space space;
  space.bodies = {
      body({{0, 0, 0}, {50, 0, 0}, {50, 1e-4, 0}, {1, 1, 1}, {1.0001, 1, 1}, {1, 1.0001, 1}},
           {{0, 1, 2}, {3, 4, 5}}, {0, 0})};
  const PreparedScene scene = prepare_scene(project, space);
  EXPECT_EQ(scene.degenerate_triangles, 0u);
  EXPECT_EQ(scene.triangle.size(), 2u);
}

TEST(PreparedScene, ChannelsAreGroupsTimesMaintenanceFactorsInOrderOfUse) {
  Project project;
  add_type(project, 0.8);
  add_type(project, 0.7);
  add_type(project, 0.8);
  Space space;
  space.luminaires = {luminaire(1, {0, 0, 3}, "window"), luminaire(0, {1, 0, 3}, "wall"),
                      luminaire(0, {2, 0, 3}, "window"), luminaire(2, {3, 0, 3}, "wall"),
                      luminaire(1, {4, 0, 3}, "window"), luminaire(0, {5, 0, 3})};
  const PreparedScene scene = prepare_scene(project, space);
  ASSERT_EQ(scene.channels.size(), 4u);
  const std::vector<std::string> groups = {"window", "wall", "window", ""};
  const std::vector<double> factors = {0.7, 0.8, 0.8, 0.8};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.channels[i].group, groups[i]);
    EXPECT_EQ(scene.channels[i].maintenance_factor, factors[i]);
  }
  std::vector<std::uint32_t> used;
  for (const PlacedLuminaire& placed : scene.luminaires) used.push_back(placed.channel);
  EXPECT_EQ(used, (std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3}));
}

TEST(PreparedScene, LuminairesCarryTheirTypesData) {
  Project project;
  add_type(project, 0.8);
  add_type(project, 0.8, {OpeningShape::rectangle, 1.2, 0.3, 0.0});
  Space space;
  Luminaire turned = luminaire(1, {0, 0, 3});
  turned.world_from_luminaire = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1);
  space.luminaires = {turned};
  const PreparedScene scene = prepare_scene(project, space);
  const PlacedLuminaire& placed = scene.luminaires[0];
  EXPECT_EQ(placed.web, &project.webs[1]);
  EXPECT_EQ(placed.flux_scale, 0.5);
  EXPECT_EQ(placed.opening.shape, OpeningShape::rectangle);
  EXPECT_EQ(placed.opening.along_c0_m, 1.2);
  EXPECT_EQ(placed.world_from_luminaire, turned.world_from_luminaire);
}

TEST(PreparedScene, TheRayOffsetCoversFloatRoundingAtAnySize) {
  for (const double extent_m : {1e-3, 1.0, 7.0, 12.0, 900.0, 1e5}) {
    PreparedScene scene;
    scene.extent_m = extent_m;
    const auto corner = static_cast<float>(0.5 * extent_m);
    const double ulp = static_cast<double>(std::nextafter(corner, 2.0F * corner) - corner);
    EXPECT_GE(scene.ray_offset_m(), 32.0 * ulp);
    EXPECT_GE(scene.ray_offset_m(), 1e-6 * extent_m);
    EXPECT_LE(scene.ray_offset_m(), 4e-6 * extent_m) << "not larger than needed";
  }
}

}  // namespace
}  // namespace calc::prepared_scene_test
