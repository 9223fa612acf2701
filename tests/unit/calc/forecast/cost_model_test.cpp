#include "calc/forecast/cost_model.h"

#include "calc/radiosity/gather/plane_work.h"

#include <gtest/gtest.h>

namespace cost_model_test {
namespace {

calc::SpaceWorkload one_plane() {
  calc::SpaceWorkload load;
  load.planes.push_back({100, 80, 20.0, 400.0, 0.0});
  load.rays_per_path = 3.0;
  load.vertices_per_path = 2.5;
  load.triangles = 12;
  return load;
}

calc::RadiositySettings settings() {
  calc::RadiositySettings s;
  s.replicates = 10;
  s.first_paths = 256;
  s.max_paths = 1024;
  return s;
}

TEST(CostModel, CountsTheWorkOfAllLooks) {
  const calc::Prediction p = calc::predict(one_plane(), {1024}, settings(), 1);
  EXPECT_DOUBLE_EQ(p.work.light_paths, 10240.0);
  EXPECT_DOUBLE_EQ(p.work.pool_rays, 30720.0);
  EXPECT_DOUBLE_EQ(p.work.direct_rays, 400.0);
  // Looks bring 256, 256 and 512 new paths: their connections at most, and not much fewer.
  const double connections =
      2.0 * calc::draws_per_point(256, 100) + calc::draws_per_point(512, 100);
  EXPECT_LE(p.work.connection_rays, 80.0 * 10.0 * connections);
  EXPECT_GT(p.work.connection_rays, 0.5 * 80.0 * 10.0 * connections);
}

TEST(CostModel, ALookOnlyAddsNewPaths) {
  calc::RadiositySettings one_look = settings();
  one_look.first_paths = 512;
  const auto rays = [](std::uint64_t paths, const calc::RadiositySettings& s) {
    return calc::predict(one_plane(), {paths}, s, 1).work;
  };
  EXPECT_NEAR(rays(1024, settings()).connection_rays - rays(512, settings()).connection_rays,
              rays(512, one_look).connection_rays, 1e-6);
  EXPECT_NEAR(rays(1024, settings()).near_rays - rays(512, settings()).near_rays,
              rays(512, one_look).near_rays, 1e-6);
}

TEST(CostModel, InstantRadiosityConnectsToEveryVertexAndHasNoNearField) {
  calc::RadiositySettings s = settings();
  s.method = calc::Method::instant_radiosity;
  const calc::Work work = calc::predict(one_plane(), {1024}, s, 1).work;
  EXPECT_LE(work.connection_rays, 80.0 * 10.0 * 1024.0 * 2.5);
  EXPECT_GT(work.connection_rays, 0.5 * 80.0 * 10.0 * 1024.0 * 2.5);
  EXPECT_EQ(work.near_rays, 0.0);
}

TEST(CostModel, ShortRaysAreOnlyTracedFromPointsNearASurface) {
  calc::SpaceWorkload clear = one_plane();
  clear.planes[0].near_points = 0.0;
  EXPECT_EQ(calc::predict(clear, {1024}, settings(), 1).work.near_rays, 0.0);
  EXPECT_GT(calc::predict(one_plane(), {1024}, settings(), 1).work.near_rays, 0.0);
}

TEST(CostModel, APlaneWithoutIndirectLightCostsDirectRaysOnly) {
  calc::SpaceWorkload load = one_plane();
  load.planes[0].seeing_points = 0;
  const calc::Prediction p = calc::predict(load, {1024}, settings(), 1);
  EXPECT_EQ(p.work.light_paths, 0.0);
  EXPECT_EQ(p.work.connection_rays, 0.0);
  EXPECT_EQ(p.work.near_rays, 0.0);
  EXPECT_EQ(p.work.direct_rays, 400.0);
}

TEST(CostModel, ThePoolIsSharedByPlanes) {
  calc::SpaceWorkload load = one_plane();
  load.planes.push_back(load.planes[0]);
  const calc::Prediction one = calc::predict(one_plane(), {1024}, settings(), 1);
  const calc::Prediction two = calc::predict(load, {1024, 512}, settings(), 1);
  EXPECT_EQ(two.work.pool_rays, one.work.pool_rays);
  EXPECT_GT(two.work.connection_rays, one.work.connection_rays);
  EXPECT_LT(two.work.connection_rays, 2.0 * one.work.connection_rays);
}

TEST(CostModel, ThreadsShareTheWorkAndConvexSpacesSaveShadowRays) {
  const calc::Prediction one = calc::predict(one_plane(), {1024}, settings(), 1);
  const calc::Prediction four = calc::predict(one_plane(), {1024}, settings(), 4);
  EXPECT_NEAR(four.seconds.connect, one.seconds.connect / 4.0, 1e-12);
  calc::SpaceWorkload convex = one_plane();
  convex.planes[0].is_unobstructed = true;
  EXPECT_LT(calc::predict(convex, {1024}, settings(), 1).seconds.connect, one.seconds.connect);
}

}  // namespace
}  // namespace cost_model_test
