// What is left out changes nothing: every skip against the full path.
#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace skips_test {
namespace {

using namespace test_support;

struct Case {
  calc::PreparedScene scene;
  std::vector<calc::SensorGrid> grids;
};

calc::SpaceSolution solve(const Case& room, const calc::SkipSet& skips, int looks = 2) {
  calc::RadiositySettings settings;
  settings.first_paths = 128;
  settings.max_paths = 128u << (looks - 1);
  settings.skips = skips;
  std::vector<calc::PlaneTask> tasks;
  for (std::size_t p = 0; p < room.grids.size(); ++p) {
    tasks.push_back({"plane " + std::to_string(p), &room.grids[p]});
  }
  const auto gatherer = calc::make_cpu_gatherer();
  return calc::solve_illuminance(
      room.scene, tasks, settings, 0.95, *gatherer,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});
}

calc::SkipSet without(calc::Skip skip) {
  calc::SkipSet skips;
  skips.forbid(skip);
  return skips;
}

calc::SensorGrid points_at(double z_m, const glm::dvec3& normal, double from_m, double to_m) {
  calc::SensorGrid grid;
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 5; ++k) {
      const double step = (to_m - from_m) / 4;
      grid.position_m.emplace_back(from_m + step * i, from_m + step * k, z_m);
      grid.normal.push_back(normal);
    }
  }
  return grid;
}

std::uint64_t shadow_rays(const calc::PlaneField& field) {
  return field.counters.connection_rays + field.counters.direct_rays;
}

// Zeros may be stored or not stored at all.
void expect_same_values(const calc::PlaneField& a, const calc::PlaneField& b) {
  ASSERT_EQ(a.points, b.points);
  for (std::size_t r = 0; r < a.replicates; ++r) {
    for (std::size_t i = 0; i < a.points; ++i) EXPECT_EQ(total_lx(a, r, i), total_lx(b, r, i));
  }
}

class Skips : public testing::Test {
 protected:
  calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PhotometricWeb down = lambert_web(300.0, 18);

  Case box(double reflectance) {
    Case room;
    add_box(room.scene, {-2, -2, 0}, {4, 4, 3}, reflectance);
    add_luminaire(room.scene, web, {0.3, 0.2, 2.4});
    set_extent(room.scene);
    room.grids.push_back(points_at(0.8, {0, 0, 1}, -1.8, 1.8));
    return room;
  }
};

TEST_F(Skips, NoReflectionIsBitwise) {
  const Case room = box(0.0);
  const auto left_out = solve(room, {});
  calc::SkipSet none;  // black surfaces are also proved to light no plane
  none.forbid_all();
  const auto full = solve(room, none);
  EXPECT_EQ(left_out.pool_rays, 0u);
  EXPECT_GT(full.pool_rays, 0u);
  expect_same_values(left_out.fields[0], full.fields[0]);
}

TEST_F(Skips, ConvexIsBitwise) {
  const Case room = box(0.6);
  const auto left_out = solve(room, {});
  const auto full = solve(room, without(calc::Skip::convex));
  EXPECT_EQ(shadow_rays(left_out.fields[0]), 0u);
  EXPECT_GT(shadow_rays(full.fields[0]), 10000u);
  expect_same_values(left_out.fields[0], full.fields[0]);
}

TEST_F(Skips, ConvexIsTakenPerPlane) {
  Case room = box(0.6);
  const auto alone = solve(room, {});
  room.grids.push_back(points_at(-0.5, {0, 0, 1}, -1.8, 1.8));  // under the floor
  const auto both = solve(room, {});
  EXPECT_EQ(shadow_rays(both.fields[0]), 0u);
  EXPECT_GT(shadow_rays(both.fields[1]), 10000u);
  expect_same_values(both.fields[0], alone.fields[0]);
  expect_same_values(both.fields[1], solve(room, without(calc::Skip::convex)).fields[1]);
}

TEST_F(Skips, ConvexIsNotTakenWithAPillar) {
  Case room = box(0.6);
  add_box(room.scene, {0.5, 0.5, 0}, {0.3, 0.3, 3}, 0.4);
  const auto solution = solve(room, {});
  EXPECT_GT(shadow_rays(solution.fields[0]), 10000u);
}

TEST_F(Skips, BehindPlaneIsBitwise) {
  Case outdoors;
  add_quad(outdoors.scene, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 0.5);
  add_luminaire(outdoors.scene, web, {0, 0, 4});
  set_extent(outdoors.scene);
  outdoors.grids.push_back(points_at(0.0, {0, 0, 1}, -4, 4));
  const auto left_out = solve(outdoors, {});
  const auto full = solve(outdoors, without(calc::Skip::behind_plane));
  EXPECT_EQ(left_out.pool_rays, 0u);
  EXPECT_GT(full.pool_rays, 0u);
  expect_same_values(left_out.fields[0], full.fields[0]);
}

TEST_F(Skips, DarkPairsIsBitwise) {
  Case room = box(0.5);
  add_luminaire(room.scene, down, {-1, -1, 0.5});  // below the plane, and shines down
  const auto left_out = solve(room, {});
  const auto full = solve(room, without(calc::Skip::dark_pairs));
  expect_same_values(left_out.fields[0], full.fields[0]);
}

TEST_F(Skips, UnlitSurfacesGiveNoLight) {
  Case room;  // a white ceiling over black walls and floor; the only luminaire shines down
  add_box(room.scene, {-2, -2, 0}, {4, 4, 3}, 0.0);
  add_quad(room.scene, {-1, -1, 2.9}, {2, 0, 0}, {0, 2, 0}, 0.8);
  add_luminaire(room.scene, down, {0, 0, 2.0});
  set_extent(room.scene);
  room.grids.push_back(points_at(0.8, {0, 0, 1}, -1.8, 1.8));
  const auto left_out = solve(room, {});
  const auto full = solve(room, without(calc::Skip::unlit_surfaces));
  EXPECT_EQ(left_out.pool_rays, 0u);
  EXPECT_EQ(left_out.balance.untraced_lm, left_out.balance.emitted_lm);
  EXPECT_GT(full.pool_rays, 0u);
  expect_same_values(left_out.fields[0], full.fields[0]);
}

TEST_F(Skips, ClearDistanceIsBitwise) {
  Case room = box(0.7);
  room.grids.push_back(points_at(1.5, {0, 0, 1}, -0.3, 0.3));  // far from everything in front
  const auto left_out = solve(room, {});
  const auto full = solve(room, without(calc::Skip::clear_distance));
  EXPECT_LT(left_out.fields[1].counters.near_rays, full.fields[1].counters.near_rays);
  // Where it is not proved, as many short rays are a choice: only points proved clear are compared.
  expect_same_values(left_out.fields[1], full.fields[1]);
}

// Leaving hidden groups out changes which vertices are drawn, not what they add up to.
TEST_F(Skips, HiddenNodesAreUnbiased) {
  Case room = box(0.7);
  add_box(room.scene, {-1, -1, 0}, {1, 1, 0.7}, 0.5);
  const auto left_out = solve(room, {}, 4);
  const auto full = solve(room, without(calc::Skip::hidden_nodes), 4);
  for (std::size_t i = 0; i < room.grids[0].position_m.size(); ++i) {
    const auto a = calc::t_interval(replicates_at(left_out.fields[0], i), 0.9999);
    const auto b = calc::t_interval(replicates_at(full.fields[0], i), 0.9999);
    EXPECT_LT(a.low, b.high) << i;
    EXPECT_LT(b.low, a.high) << i;
  }
}

}  // namespace
}  // namespace skips_test
