// Same input, same bits: for any number of threads, any order of planes and any other planes.
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace same_bits_test {
namespace {

using namespace test_support;

struct Room {
  calc::PhotometricWeb web = lambert_web(500.0, 18, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0});
  calc::PreparedScene scene;
  calc::SensorGrid task, wall;

  Room() {
    add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.6);
    add_box(scene, {1, 1, 0}, {1, 0.8, 0.7}, 0.4);
    add_quad(scene, {0, 0, 0}, {4, 0, 0}, {0, 3, 0},
             0.2);  // a floor twice: a tie for every ray that meets it
    add_luminaire(scene, web, {1.5, 1.5, 2.5});
    add_luminaire(scene, web, {3.0, 1.5, 2.5});
    scene.channels.push_back({"second", 0.8});
    scene.luminaires[1].channel = 1;
    set_extent(scene);
    for (int i = 0; i < 20; ++i) {
      task.position_m.emplace_back(0.1 + 0.19 * i, 0.3 + 0.12 * i, 0.75);
      task.normal.emplace_back(0, 0, 1);
      wall.position_m.emplace_back(0.0, 0.1 + 0.14 * i, 1.2);
      wall.normal.emplace_back(1, 0, 0);
    }
  }

  calc::SpaceSolution solve(const std::vector<calc::PlaneTask>& tasks, int jobs) const {
    calc::RadiositySettings settings;
    settings.first_paths = 64;
    settings.max_paths = 256;
    settings.jobs = jobs;
    const auto gatherer = calc::make_cpu_gatherer();
    // "wall" stops a look earlier than "task", so that planes drop out at different times.
    return calc::solve_illuminance(
        scene, tasks, settings, 0.95, *gatherer,
        [&](std::size_t t, const calc::PlaneField& field, calc::Look) {
          calc::LookAnswer answer;
          if (tasks[t].plane_id == "wall" && field.counters.paths >= 128 * 16) {
            answer.finished = calc::StopReason::accurate;
          }
          return answer;
        },
        {});
  }
};

void expect_same_bits(const calc::PlaneField& a, const calc::PlaneField& b) {
  EXPECT_EQ(a.plane_id, b.plane_id);
  EXPECT_EQ(a.direct_exact_lx, b.direct_exact_lx);
  EXPECT_EQ(a.direct_sampled_lx, b.direct_sampled_lx);
  EXPECT_EQ(a.indirect_lx, b.indirect_lx);
  EXPECT_EQ(a.counters.connection_rays, b.counters.connection_rays);
  EXPECT_EQ(a.stop, b.stop);
}

TEST(SameBits, ForAnyNumberOfThreads) {
  const Room room;
  const std::vector<calc::PlaneTask> tasks{{"task", &room.task}, {"wall", &room.wall}};
  const calc::SpaceSolution one = room.solve(tasks, 1);
  ASSERT_FALSE(one.fields[0].indirect_lx.empty());
  ASSERT_FALSE(one.fields[0].direct_sampled_lx.empty());
  for (const int jobs : {2, 8}) {
    const calc::SpaceSolution many = room.solve(tasks, jobs);
    expect_same_bits(one.fields[0], many.fields[0]);
    expect_same_bits(one.fields[1], many.fields[1]);
    EXPECT_EQ(one.balance.absorbed_lm.value, many.balance.absorbed_lm.value);
  }
}

TEST(SameBits, WhenPlanesAreReorderedOrOneIsRemoved) {
  const Room room;
  const calc::SpaceSolution both = room.solve({{"task", &room.task}, {"wall", &room.wall}}, 2);
  const calc::SpaceSolution turned = room.solve({{"wall", &room.wall}, {"task", &room.task}}, 2);
  const calc::SpaceSolution alone = room.solve({{"task", &room.task}}, 2);
  EXPECT_EQ(both.fields[1].stop, calc::StopReason::accurate);
  EXPECT_EQ(both.fields[0].stop, calc::StopReason::path_limit);
  expect_same_bits(both.fields[0], turned.fields[1]);
  expect_same_bits(both.fields[1], turned.fields[0]);
  expect_same_bits(both.fields[0], alone.fields[0]);
}

// Two closed boxes: no path from the one can reach the point in the other, but only its reflecting
// walls are known to the program, so its zeros stay unproved. With black walls nothing can be
// reflected: a proved 0.
TEST(Unseen, MarksPointsThatSamplesMayReachButDidNot) {
  for (const double rho : {0.5, 0.0}) {
    const calc::PhotometricWeb web = isotropic_web(100.0);
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, {2, 2, 2}, 0.5);
    add_box(scene, {5, 0, 0}, {2, 2, 2}, rho);
    add_luminaire(scene, web, {1, 1, 1});
    set_extent(scene);
    calc::SensorGrid grid;
    grid.position_m = {{6, 1, 1}, {0.5, 0.5, 0.5}};
    grid.normal = {{1, 0, 0}, {0, 0, 1}};
    const calc::PlaneField field = solve_with_paths(scene, grid, 1, 64).fields[0];
    ASSERT_EQ(field.unseen.size(), 2u);
    EXPECT_EQ(field.unseen[0], rho > 0.0 ? 1 : 0);
    EXPECT_EQ(field.unseen[1], 0);
  }
}

TEST(SameBits, AnotherSeedGivesOtherBits) {
  const Room room;
  const calc::SpaceSolution a = solve_with_paths(room.scene, room.task, 1, 64);
  const calc::SpaceSolution b = solve_with_paths(room.scene, room.task, 2, 64);
  EXPECT_NE(a.fields[0].indirect_lx, b.fields[0].indirect_lx);
}

}  // namespace
}  // namespace same_bits_test
