#include "calc/proofs/predicates.h"

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/scene/opening.h"
#include "tests/unit/calc/proofs/proof_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace predicates_test {
namespace {

using namespace proof_scenes;
using test_support::add_box;
using test_support::add_luminaire;
using test_support::add_quad;
using test_support::set_extent;

// A black room of 4 x 4 x 3 m about the local origin, furnished with a box.
calc::PreparedScene black_room(double furniture_reflectance) {
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, -1.5}, {4, 4, 3}, 0.0);
  add_box(scene, {-1, -1, -1.5}, {0.8, 0.8, 0.7}, furniture_reflectance);
  set_extent(scene);
  return scene;
}

bool is_unlit(const calc::PreparedScene& scene) {
  return calc::find_unlit_surfaces(scene, calc::beams_of(scene)).at(0) != 0;
}

bool is_dark(const calc::PreparedScene& scene, const calc::SensorGrid& grid,
             calc::ReceiverKernel kernel = calc::ReceiverKernel::planar) {
  const Points points(scene, grid, kernel);
  return calc::find_dark_luminaires(scene, calc::beams_of(scene), points.bounds).at(0) != 0;
}

TEST(NoReflection, HoldsForABlackFurnishedRoomAndForNothingAtAll) {
  EXPECT_TRUE(calc::no_reflection(black_room(0.0)));
  EXPECT_TRUE(calc::no_reflection({}));
}

TEST(NoReflection, OneReflectingTriangleIsEnough) {
  calc::PreparedScene scene = black_room(0.0);
  scene.reflectance.back() = 1e-12;
  EXPECT_FALSE(calc::no_reflection(scene));
}

struct OverGround : ::testing::Test {
  OverGround() {
    add_quad(scene, {-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, 0.3);
    set_extent(scene);
  }
  calc::ReflectionView view(const calc::SensorGrid& grid,
                            calc::ReceiverKernel kernel = calc::ReceiverKernel::planar) {
    const Points points(scene, grid, kernel);
    return calc::find_reflection_view(scene, points.set);
  }
  calc::PreparedScene scene;
};

auto seeing(const calc::ReflectionView& view) {
  return std::count(view.sees_reflection.begin(), view.sees_reflection.end(), 1);
}

TEST_F(OverGround, UpwardPointsSeeNoReflection) {
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 1.0))), 0);
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 0.0))), 0);  // in the ground
}

TEST_F(OverGround, PointsUnderTheGroundOrTiltedPointsSeeIt) {
  EXPECT_EQ(seeing(view(work_plane(-5, 5, -0.001))), 25);
  calc::SensorGrid tilted = work_plane(-5, 5, 1.0);
  for (glm::dvec3& n : tilted.normal) n = glm::normalize(glm::dvec3(0.3, 0, 1));
  EXPECT_EQ(seeing(view(tilted)), 25);
}

TEST_F(OverGround, EachPointHasItsOwnAnswer) {
  calc::SensorGrid grid = work_plane(-5, 5, 1.0);
  grid.normal[7] = {0, 0, -1};
  const calc::ReflectionView answer = view(grid);
  EXPECT_EQ(seeing(answer), 1);
  EXPECT_EQ(answer.sees_reflection[7], 1);
}

TEST_F(OverGround, OnlyPlanarReceiversHaveABack) {
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 1.0), calc::ReceiverKernel::cylindrical)), 25);
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 1.0), calc::ReceiverKernel::scalar)), 25);
}

TEST_F(OverGround, OneReflectingCornerAMillimetreInFrontIsSeen) {
  test_support::add_triangle(scene, {0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 1.001}, 0.1);
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 1.0))), 25);
  scene.reflectance.back() = 0.0;
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 1.0))), 0);
}

TEST_F(OverGround, WorldPositionsAreShiftedByTheOrigin) {
  scene.origin_m = {1000, 2000, 300};
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 1.0))), 25);  // 299 m below the ground
  EXPECT_EQ(seeing(view(work_plane(-5, 5, 301.0))), 0);
}

TEST(UnlitSurfaces, ASpotAimedAwayLightsNothingThatReflects) {
  const auto spot = spot_web(7.0, 8.0);
  calc::PreparedScene scene = black_room(0.7);
  add_aimed(scene, spot, {1.0, 1.0, 1.0}, {0, 0, -1});
  EXPECT_TRUE(is_unlit(scene));
  scene.luminaires[0].world_from_luminaire = aimed(glm::dvec3(-1.5, -1.5, -2));
  EXPECT_FALSE(is_unlit(scene));
}

TEST(UnlitSurfaces, ARecessedDownlightDoesNotLightItsCeiling) {
  const auto web =
      test_support::lambert_web(100, 9, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0});
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, -1.5}, {4, 4, 3}, 0.0);
  add_quad(scene, {-2, -2, 1.5}, {4, 0, 0}, {0, 4, 0}, 0.8);
  add_luminaire(scene, web, {0.3, 0.2, 1.5});
  set_extent(scene);
  EXPECT_TRUE(is_unlit(scene));
  scene.luminaires[0].position_m.z = 1.501;  // the ceiling is now in front of it
  EXPECT_FALSE(is_unlit(scene));
  scene.luminaires[0].position_m.z = 1.4;
  EXPECT_TRUE(is_unlit(scene));
  scene.luminaires[0].world_from_luminaire = aimed({0.01, 0, -1});
  EXPECT_TRUE(is_unlit(scene));
  scene.luminaires[0].world_from_luminaire = aimed({0.1, 0, -1});  // grazes the ceiling 1 m away
  EXPECT_FALSE(is_unlit(scene));
}

TEST(UnlitSurfaces, NoReflectingSurfaceIsLitByNobody) {
  const auto web = test_support::isotropic_web(1.0);
  calc::PreparedScene scene = black_room(0.0);
  add_luminaire(scene, web, {0, 0, 1});
  EXPECT_TRUE(is_unlit(scene));
}

// Emitter rays of a luminaire proved unlit never meet a reflecting triangle first.
TEST(UnlitSurfaces, EmittedRaysNeverContradictAProof) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const calc::PhotometricWeb webs[] = {
      spot_web(7, 8), spot_web(40, 50, {calc::OpeningShape::disk, 0.2, 0.2, 0.0}),
      test_support::lambert_web(9, 9, {calc::OpeningShape::rectangle, 0.5, 0.1, 0.0})};
  int proved = 0;
  for (int trial = 0; trial < 300; ++trial) {
    calc::PreparedScene scene = black_room(0.5);
    const glm::dvec3 place(3.6 * uniform(random) - 1.8, 3.6 * uniform(random) - 1.8,
                           2.0 * uniform(random) - 0.6);
    add_aimed(scene, webs[trial % 3], place, random_unit(random));
    if (!is_unlit(scene)) continue;
    ++proved;
    const calc::Tracer tracer(scene);
    const calc::Emitter emitter(scene);
    for (int k = 0; k < 500; ++k) {
      const calc::EmittedRay ray =
          emitter.emit(0, {uniform(random), uniform(random)}, {uniform(random), uniform(random)},
                       tracer.offset_m());
      calc::SurfaceHit hit;
      if (!tracer.closest_hit(ray.origin_m, ray.direction, 100.0, hit)) continue;
      ASSERT_EQ(scene.reflectance[hit.triangle], 0.0) << trial;
    }
  }
  EXPECT_GT(proved, 30);
}

TEST(DarkLuminaires, ASpotThatMissesThePlaneIsDark) {
  const auto spot = spot_web(7.0, 8.0);
  calc::PreparedScene scene;
  add_luminaire(scene, spot, {0, 0, 3});
  scene.extent_m = 10.0;
  const double edge = 2.0 * std::tan(8.0 * calc::kPi / 180.0);  // on the plane at 1 m
  const auto beside = [&](double gap_m) {  // one column of points at edge + gap
    return square_grid({edge + gap_m, -1, 1}, {0, 0, 0}, {0, 2, 0}, {0, 0, 1});
  };
  EXPECT_TRUE(is_dark(scene, beside(0.001)));
  EXPECT_FALSE(is_dark(scene, beside(-0.001)));
}

TEST(DarkLuminaires, FromBehindIsDarkForPlanarReceiversOnly) {
  const auto web = test_support::isotropic_web(1.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 0.5});
  scene.extent_m = 10.0;
  EXPECT_TRUE(is_dark(scene, work_plane(-1, 1, 0.501)));
  EXPECT_FALSE(is_dark(scene, work_plane(-1, 1, 0.5)));  // in the plane: not proved
  EXPECT_FALSE(is_dark(scene, work_plane(-1, 1, 0.499)));
  EXPECT_FALSE(is_dark(scene, work_plane(-1, 1, 0.501), calc::ReceiverKernel::cylindrical));
}

TEST(DarkLuminaires, OnePointThatFacesTheLightIsEnough) {
  const auto web = test_support::isotropic_web(1.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 0.5});
  scene.extent_m = 10.0;
  calc::SensorGrid grid = work_plane(-1, 1, 1.0);
  EXPECT_TRUE(is_dark(scene, grid));
  grid.normal[3] = {0, 0, -1};
  EXPECT_FALSE(is_dark(scene, grid));
}

TEST(DarkLuminaires, AnOpeningThatReachesInFrontOfThePlaneIsNotDark) {
  calc::PreparedScene scene;
  const auto web = calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi}, {1.0, 1.0},
                                              {calc::OpeningShape::rectangle, 1.0, 1.0, 0.0}, {});
  add_aimed(scene, web, {0, 0, 0.4}, {1, 0, 0});  // stands upright, up to 0.9 m
  scene.extent_m = 10.0;
  EXPECT_TRUE(is_dark(scene, work_plane(-1, 1, 0.91)));
  EXPECT_FALSE(is_dark(scene, work_plane(-1, 1, 0.89)));
}

TEST(DarkLuminaires, MoreNormalsThanGroupsAreNotProvedByFacing) {
  const auto web = test_support::isotropic_web(1.0);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, -5});
  scene.extent_m = 10.0;
  calc::SensorGrid grid = work_plane(-1, 1, 1.0, 10);
  for (std::size_t i = 0; i < grid.normal.size(); ++i) {
    grid.normal[i] = glm::normalize(glm::dvec3(1e-3 * static_cast<double>(i), 0, 1));
  }
  EXPECT_FALSE(is_dark(scene, grid));
  for (std::size_t i = calc::kMostNormalGroups; i < grid.normal.size(); ++i) {
    grid.normal[i] = {0, 0, 1};
  }
  EXPECT_TRUE(is_dark(scene, grid));
}

// Direct light of a luminaire proved dark is 0 in every bit, at every point, from any part of it.
TEST(DarkLuminaires, DirectLightNeverContradictsAProof) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const calc::PhotometricWeb webs[] = {
      spot_web(7, 8),
      spot_web(40, 50, {calc::OpeningShape::disk, 0.2, 0.2, 0.0}),
      test_support::lambert_web(9, 9, {calc::OpeningShape::rectangle, 0.5, 0.1, 0.0}),
      spot_web(100, 110),
      spot_web(30, 40, {calc::OpeningShape::cylinder_c0, 0.8, 0.1, 0.1}),
      test_support::lambert_web(9, 9, {calc::OpeningShape::box, 0.5, 0.3, 0.4})};
  int proved = 0;
  for (int trial = 0; trial < 900; ++trial) {
    calc::PreparedScene scene;
    scene.extent_m = 5.0;
    const glm::dvec3 place(4.0 * uniform(random) - 2.0, 4.0 * uniform(random) - 2.0,
                           4.0 * uniform(random) - 2.0);
    add_aimed(scene, webs[trial % 6], place, random_unit(random));
    const calc::SensorGrid grid = work_plane(-1, 1, 0.0);
    if (!is_dark(scene, grid)) continue;
    ++proved;
    for (int k = 0; k < 200; ++k) {
      const auto i = static_cast<std::size_t>(k) % grid.position_m.size();
      const calc::PlacedLuminaire& luminaire = scene.luminaires[0];
      const calc::OpeningView view(luminaire,
                                   glm::normalize(grid.position_m[i] - luminaire.position_m));
      const glm::dvec3 source = view.point(uniform(random), uniform(random)).position_m;
      ASSERT_EQ(calc::point_illuminance_lx(scene.luminaires[0], source,
                                           {grid.position_m[i], grid.normal[i]}),
                0.0)
          << trial;
    }
  }
  EXPECT_GT(proved, 300);
}

}  // namespace
}  // namespace predicates_test
