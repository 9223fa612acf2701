// Short rays go where the variance of earlier looks was: the mean must not notice.
#include "calc/base/statistics.h"
#include "calc/radiosity/gather/plane_work.h"
#include "tests/analytic/extreme_reference.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace short_ray_share_test {
namespace {

using namespace test_support;
using extreme::OneReflection;
using extreme::points_of;

TEST(ShortRayShare, FollowsTheRatioOfVariances) {
  // As many rays as are best already: nothing changes.
  EXPECT_NEAR(calc::next_short_ray_factor(1.0, 1.0, 1.0, 64, 16), 1.0, 1e-12);
  EXPECT_NEAR(calc::next_short_ray_factor(1.0, 4.0, 1.0, 64, 16), 2.0, 1e-12);
  EXPECT_NEAR(calc::next_short_ray_factor(2.0, 1.0, 4.0, 64, 16), 1.0, 1e-12);
  // Many draws make each ray cheap.
  EXPECT_NEAR(calc::next_short_ray_factor(1.0, 1.0, 1.0, 256, 16), 2.0, 1e-12);
}

TEST(ShortRayShare, NeverVanishesAndNeverRunsAway) {
  EXPECT_EQ(calc::next_short_ray_factor(1.0, 1e-9, 1.0, 64, 16), 0.5);
  EXPECT_EQ(calc::next_short_ray_factor(1.0, 1.0, 1e-9, 64, 16), 8.0);
  EXPECT_EQ(calc::next_short_ray_factor(1.0, 1.0, 0.0, 64, 16), 8.0);
  // No ray has brought anything: that is no reason to look away.
  EXPECT_EQ(calc::next_short_ray_factor(4.0, 0.0, 1.0, 64, 16), 1.0);
  EXPECT_EQ(calc::next_short_ray_factor(0.5, 0.0, 0.0, 64, 16), 0.5);
}

TEST(ShortRayShare, RaysGrowWithIt) {
  EXPECT_EQ(calc::short_rays_per_point(256, 0.0, 1.0), 64u);
  EXPECT_EQ(calc::short_rays_per_point(256, 0.0, 1.0, 8.0), 512u);
  EXPECT_EQ(calc::short_rays_per_point(256, 0.0, 1.0, 0.5), 32u);
  EXPECT_EQ(calc::short_rays_per_point(16, 0.999, 1.0, 8.0), 2u);
}

struct WhiteWall {
  WhiteWall() {
    add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.0);
    scene.reflectance[8] = scene.reflectance[9] = 0.9;  // x = 0
    add_luminaire(scene, web, {1.4, 1.1, 1.9});
    set_extent(scene);
  }

  calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  calc::SensorGrid grid = points_of({{0.01, 1.5, 0.0}, {0.5, 1.0, 1.0}, {3, 1.5, 0.75}},
                                    {{0, 0, 1}, {-1, 0, 0}, {0, 0, 1}});
};

TEST(ShortRayShare, DoesNotMoveTheMean) {
  constexpr std::uint64_t kSeeds = 300;
  const WhiteWall room;
  const OneReflection wall(room.scene, {0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}, {1, 0, 0}, 0.9);
  std::vector<std::vector<double>> of_seed(room.grid.position_m.size());
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const calc::PlaneField field =
        solve_with_paths(room.scene, room.grid, seed, 256, 4, 5).fields[0];
    for (std::size_t i = 0; i < of_seed.size(); ++i) of_seed[i].push_back(field.mean_lx(i));
  }
  for (std::size_t i = 0; i < of_seed.size(); ++i) {
    const glm::dvec3 &x = room.grid.position_m[i], &n = room.grid.normal[i];
    const double truth_lx = extreme::direct_lx(room.scene.luminaires[0], x, n) + wall.lx(x, n);
    const calc::ReplicateMean mean = calc::replicate_mean(of_seed[i]);
    const double z = (mean.mean - truth_lx) / mean.standard_error;
    std::printf("point %zu: truth %.5g lx, mean off by %+.4f %% +- %.4f %%\n", i, truth_lx,
                100.0 * (mean.mean / truth_lx - 1.0), 100.0 * mean.standard_error / truth_lx);
    EXPECT_LT(std::abs(z), 4.0) << "point " << i;
    EXPECT_LT(mean.standard_error, 0.005 * truth_lx) << "point " << i;  // it can see errors
  }
}

// Five looks against one of as many paths.
TEST(ShortRayShare, HelpsAPointThatSeesLittleButAWall) {
  const WhiteWall room;
  const auto relative_error = [&](int looks) {
    const calc::PlaneField field =
        solve_with_paths(room.scene, room.grid, 3, 4096, 16, looks).fields[0];
    const calc::ReplicateMean mean = calc::replicate_mean(replicates_at(field, 1));
    return mean.standard_error / mean.mean;
  };
  EXPECT_LT(relative_error(5), 0.6 * relative_error(1));
}

}  // namespace
}  // namespace short_ray_share_test
