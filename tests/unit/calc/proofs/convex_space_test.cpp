#include "calc/proofs/convex_space.h"

#include "calc/scene/opening.h"
#include "tests/unit/calc/proofs/proof_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace convex_space_test {
namespace {

using namespace proof_scenes;
using test_support::add_box;
using test_support::add_luminaire;
using test_support::add_quad;
using test_support::set_extent;

calc::PreparedScene empty_room(double reflectance = 0.5) {
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, -1.5}, {4, 4, 3}, reflectance);
  set_extent(scene);
  return scene;
}

bool is_convex(const calc::PreparedScene& scene) {
  return calc::find_convex_space(scene).space.has_value();
}

bool holds(const calc::PreparedScene& scene, const calc::SensorGrid& grid,
           calc::ReceiverKernel kernel = calc::ReceiverKernel::planar) {
  const Points points(scene, grid, kernel);
  const calc::ConvexAnswer answer = calc::find_convex_space(scene);
  return answer.space && answer.space->holds(points.set, points.bounds);
}

void turn(calc::PreparedScene& scene, const glm::dmat3& rotation) {
  for (glm::vec3& v : scene.vertex_m) v = glm::vec3(rotation * glm::dvec3(v));
}

TEST(ConvexSpace, AnEmptyRoomIsConvexHoweverItIsTurned) {
  std::mt19937 random(1);
  for (int k = 0; k < 50; ++k) {
    calc::PreparedScene scene = empty_room();
    turn(scene, aimed(random_unit(random)));
    EXPECT_TRUE(is_convex(scene));
  }
}

TEST(ConvexSpace, NothingAtAllAndFlatGroundAreConvex) {
  EXPECT_TRUE(is_convex({}));
  const auto web = test_support::isotropic_web(1.0);
  calc::PreparedScene scene;
  add_quad(scene, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, 0.2);
  add_luminaire(scene, web, {0, 0, 4});
  set_extent(scene);
  EXPECT_TRUE(holds(scene, work_plane(-5, 5, 0.0)));
  EXPECT_TRUE(holds(scene, work_plane(-5, 5, 1.0)));
  EXPECT_FALSE(holds(scene, work_plane(-5, 5, -0.01)));  // under the ground
}

TEST(ConvexSpace, FlatGroundWithLightOnBothSidesIsNotProved) {
  const auto web = test_support::isotropic_web(1.0);
  calc::PreparedScene scene;
  add_quad(scene, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, 0.2);
  add_luminaire(scene, web, {0, 0, 4});
  add_luminaire(scene, web, {0, 0, -4});
  set_extent(scene);
  EXPECT_FALSE(is_convex(scene));
}

TEST(ConvexSpace, APillarAPartitionOrAnLShapeIsNotConvex) {
  calc::PreparedScene pillar = empty_room();
  add_box(pillar, {0, 0, -1.5}, {0.3, 0.3, 3}, 0.5);
  for (std::size_t t = 12; t < pillar.body.size(); ++t) pillar.body[t] = 4;
  const calc::ConvexAnswer answer = calc::find_convex_space(pillar);
  EXPECT_FALSE(answer.space.has_value());
  ASSERT_TRUE(answer.obstacle_body.has_value());
  EXPECT_EQ(*answer.obstacle_body, 4u);
  EXPECT_THAT(answer.why_not, ::testing::HasSubstr("both sides"));

  calc::PreparedScene partition = empty_room();
  add_quad(partition, {0, -2, -1.5}, {0, 4, 0}, {0, 0, 3}, 0.5);
  EXPECT_FALSE(is_convex(partition));

  calc::PreparedScene l_shape;
  add_box(l_shape, {0, 0, 0}, {4, 2, 3}, 0.5);
  add_box(l_shape, {0, 0, 0}, {2, 4, 3}, 0.5);
  set_extent(l_shape);
  EXPECT_FALSE(is_convex(l_shape));
}

TEST(ConvexSpace, APictureOnTheWallKeepsItConvexUnlessItStandsOff) {
  calc::PreparedScene scene = empty_room();
  add_quad(scene, {-2, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.1);
  EXPECT_TRUE(is_convex(scene));
  calc::PreparedScene off = empty_room();
  add_quad(off, {-1.999, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.1);
  EXPECT_FALSE(is_convex(off));
}

TEST(ConvexSpace, OneCornerAMillimetreInwardIsNotConvex) {
  for (const std::size_t v : {std::size_t{0}, std::size_t{7}, std::size_t{20}}) {
    calc::PreparedScene scene = empty_room();
    scene.vertex_m[v] *= 0.9995f;  // every corner is its triangle's own
    EXPECT_FALSE(is_convex(scene)) << v;
  }
}

TEST(ConvexSpace, ANeedleInAWallDoesNotSpoilTheProof) {
  calc::PreparedScene scene = empty_room();
  turn(scene, aimed({0.3, 0.5, 0.8}));
  const auto on_wall = [&](float s, float t) {  // first triangle's plane
    return scene.vertex_m[0] + s * (scene.vertex_m[1] - scene.vertex_m[0]) +
           t * (scene.vertex_m[2] - scene.vertex_m[0]);
  };
  const glm::dvec3 a(on_wall(0.1f, 0.1f)), b(on_wall(0.10001f, 0.10001f)),
      c(on_wall(0.1f, 0.100001f));
  test_support::add_triangle(scene, a, b, c, 0.5);
  EXPECT_TRUE(is_convex(scene));
}

TEST(ConvexSpace, LuminairesMustBeInside) {
  const auto point = test_support::isotropic_web(1.0);
  for (const auto& [z, expected] : {std::pair{1.4, true}, {1.5, true}, {1.501, false}}) {
    calc::PreparedScene scene = empty_room();
    add_luminaire(scene, point, {0, 0, z});
    EXPECT_EQ(is_convex(scene), expected) << z;
  }
  const auto panel =
      test_support::lambert_web(1.0, 9, {calc::OpeningShape::rectangle, 1.0, 1.0, 0.0});
  for (const auto& [x, expected] : {std::pair{1.5, true}, {1.51, false}}) {
    calc::PreparedScene scene = empty_room();
    add_luminaire(scene, panel, {x, 0, 1.5});
    EXPECT_EQ(is_convex(scene), expected) << x;
  }
}

TEST(ConvexSpace, ATiltedLuminaireInAWallIsNotProved) {
  const auto point = test_support::isotropic_web(1.0);
  calc::PreparedScene scene = empty_room();
  add_aimed(scene, point, {0, 0, 1.5}, {0.5, 0, -1});
  EXPECT_FALSE(is_convex(scene));
  scene.luminaires[0].position_m.z = 1.499;
  EXPECT_TRUE(is_convex(scene));
}

TEST(ConvexSpace, PointsMustBeInside) {
  const calc::PreparedScene scene = empty_room();
  EXPECT_TRUE(holds(scene, work_plane(-2, 2, 0.0)));
  EXPECT_TRUE(holds(scene, work_plane(-2, 2, -1.5)));  // on the floor, facing in
  EXPECT_FALSE(holds(scene, work_plane(-2, 2, 1.5)));  // on the ceiling, facing out
  EXPECT_FALSE(holds(scene, work_plane(-2, 2, -1.501)));
  EXPECT_FALSE(holds(scene, work_plane(0, 4, 0.0)));  // half of it outside
}

TEST(ConvexSpace, SemicylindricalPointsInASurfaceMayBeOnEitherSide) {
  const calc::PreparedScene scene = empty_room();
  calc::SensorGrid grid = work_plane(-2, 2, -1.5);
  for (glm::dvec3& look : grid.normal) look = {1, 0, 0};
  EXPECT_TRUE(holds(scene, grid));
  EXPECT_FALSE(holds(scene, grid, calc::ReceiverKernel::semicylindrical));
  for (glm::dvec3& position_m : grid.position_m) position_m.z = 0.0;
  EXPECT_TRUE(holds(scene, grid, calc::ReceiverKernel::semicylindrical));
}

TEST(ConvexSpace, PointsInAHexagonNeedNoBoxInside) {
  calc::PreparedScene scene;
  for (int k = 0; k < 6; ++k) {
    const auto corner = [](int i) {
      return glm::dvec3(3 * std::cos(i * calc::kPi / 3), 3 * std::sin(i * calc::kPi / 3), -1);
    };
    add_quad(scene, corner(k), corner(k + 1) - corner(k), {0, 0, 2}, 0.5);
    test_support::add_triangle(scene, {0, 0, -1}, corner(k), corner(k + 1), 0.5);
    test_support::add_triangle(scene, {0, 0, 1}, corner(k) + glm::dvec3(0, 0, 2),
                               corner(k + 1) + glm::dvec3(0, 0, 2), 0.5);
  }
  set_extent(scene);
  calc::SensorGrid grid = work_plane(-2.9, 2.9, 0.0, 20);
  std::erase_if(grid.position_m, [](const glm::dvec3& p) {
    return std::abs(p.y) > 2.55 || std::abs(p.x) + std::abs(p.y) / std::sqrt(3.0) > 2.95;
  });
  grid.normal.resize(grid.position_m.size());
  EXPECT_TRUE(holds(scene, grid));
  EXPECT_TRUE(holds(scene, grid, calc::ReceiverKernel::semicylindrical));
  grid.position_m.emplace_back(2.9, 2.0, 0.0);  // beyond a side
  grid.normal.emplace_back(0, 0, 1);
  EXPECT_FALSE(holds(scene, grid));
}

TEST(ConvexSpace, GivesUpOnASphereOfTooManyFacets) {
  calc::PreparedScene fine;
  test_support::add_sphere(fine, 1.0, 4, 0.5);  // 5120 facets
  set_extent(fine);
  EXPECT_FALSE(is_convex(fine));
  EXPECT_THAT(calc::find_convex_space(fine).why_not, ::testing::HasSubstr("too many"));
  calc::PreparedScene coarse;
  test_support::add_sphere(coarse, 1.0, 2, 0.5);
  set_extent(coarse);
  EXPECT_TRUE(is_convex(coarse));
}

// No shadow ray between points inside, on walls or at luminaires is ever blocked.
TEST(ConvexSpace, ShadowRaysNeverContradictAProof) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto disk = test_support::lambert_web(1.0, 9, {calc::OpeningShape::disk, 0.6, 0.6, 0.0});
  const auto box = test_support::lambert_web(1.0, 9, {calc::OpeningShape::box, 0.6, 0.4, 0.3});
  for (int trial = 0; trial < 20; ++trial) {
    const calc::PhotometricWeb& web = trial % 4 < 2 ? disk : box;
    calc::PreparedScene scene;
    if (trial % 2 == 0) {
      scene = empty_room();
      // The disk in the ceiling, the box below it.
      add_luminaire(scene, web, {0.2, -0.4, web.opening().is_body() ? 1.3 : 1.5});
    } else {
      test_support::add_sphere(scene, 2.0, 2, 0.5);
      add_luminaire(scene, web, {0.2, -0.4, 1.0});
    }
    const glm::dmat3 rotation = aimed(random_unit(random));
    turn(scene, rotation);
    for (calc::PlacedLuminaire& l : scene.luminaires) {
      l.position_m = rotation * l.position_m;
      l.world_from_luminaire = rotation * l.world_from_luminaire;
    }
    set_extent(scene);
    scene.extent_m *= 1.01;
    ASSERT_TRUE(is_convex(scene));
    const calc::Tracer tracer(scene);
    const auto on_surface = [&] {
      const auto t =
          static_cast<std::size_t>(uniform(random) * static_cast<double>(scene.triangle.size()));
      const glm::uvec3 corner = scene.triangle[t];
      const glm::dvec3 a(scene.vertex_m[corner.x]), b(scene.vertex_m[corner.y]),
          c(scene.vertex_m[corner.z]);
      double u = uniform(random), v = uniform(random);
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      const glm::dvec3 p = a + u * (b - a) + v * (c - a);
      glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
      if (glm::dot(n, p) > 0.0) n = -n;  // the origin is inside
      return tracer.lift(p, n);
    };
    for (int k = 0; k < 5000; ++k) {
      const glm::dvec3 from = on_surface(), to = on_surface();
      ASSERT_FALSE(tracer.is_blocked(from, to)) << trial;
      const calc::PlacedLuminaire& luminaire = scene.luminaires[0];
      const calc::OpeningView view(luminaire, glm::normalize(from - luminaire.position_m));
      const calc::OpeningView::Point source = view.point(uniform(random), uniform(random));
      const glm::dvec3 lifted =
          luminaire.opening.is_body()
              ? source.position_m + tracer.offset_m() * source.normal
              : calc::lifted_source_m(luminaire, source.position_m, from, tracer.offset_m());
      ASSERT_FALSE(tracer.is_blocked(from, lifted)) << trial;
    }
  }
}

}  // namespace
}  // namespace convex_space_test
