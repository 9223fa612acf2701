#include "calc/forecast/scene_plan.h"
#include "tests/unit/calc/proofs/proof_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scene_plan_test {
namespace {

using namespace proof_scenes;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const calc::SkipDecision& decision(const calc::ScenePlan& plan, calc::Skip skip) {
  return plan.skips.at(static_cast<std::size_t>(skip));
}

struct APlan : ::testing::Test {
  APlan() : web(test_support::lambert_web(300, 9)), work(work_plane(-1.5, 1.5, -0.75)) {
    test_support::add_box(scene, {-2, -2, -1.5}, {4, 4, 3}, 0.5);
    test_support::add_luminaire(scene, web, {0, 0, 1.5});
    test_support::set_extent(scene);
    tasks = {{"work", &work}};
    settings.jobs = 1;
    settings.first_paths = 256;
    settings.max_paths = 1024;
  }
  calc::ScenePlan plan() const { return calc::make_scene_plan(scene, tasks, settings); }
  calc::SkipState state(calc::Skip skip) const { return decision(plan(), skip).state; }

  calc::PhotometricWeb web;
  calc::SensorGrid work;
  calc::PreparedScene scene;
  std::vector<calc::PlaneTask> tasks;
  calc::RadiositySettings settings;
};

TEST_F(APlan, OfAnEmptyRoomSkipsShadowRaysOnly) {
  const calc::ScenePlan p = plan();
  ASSERT_EQ(p.skips.size(), calc::kSkips);
  for (std::size_t s = 0; s < calc::kSkips; ++s) {
    EXPECT_EQ(static_cast<std::size_t>(p.skips[s].skip), s);
    EXPECT_THAT(p.skips[s].why, ::testing::Not(IsEmpty()));
  }
  EXPECT_EQ(decision(p, calc::Skip::no_reflection).state, calc::SkipState::not_proved);
  EXPECT_EQ(decision(p, calc::Skip::behind_plane).state, calc::SkipState::not_proved);
  EXPECT_EQ(decision(p, calc::Skip::unlit_surfaces).state, calc::SkipState::not_proved);
  EXPECT_EQ(decision(p, calc::Skip::dark_pairs).state, calc::SkipState::not_proved);
  EXPECT_EQ(decision(p, calc::Skip::convex).state, calc::SkipState::applies);
  EXPECT_THAT(decision(p, calc::Skip::convex).planes, ElementsAre("work"));
  EXPECT_EQ(decision(p, calc::Skip::decided_points).state, calc::SkipState::while_calculating);
  EXPECT_TRUE(p.workload.planes[0].is_unobstructed);
  EXPECT_EQ(p.looks, 3);
  EXPECT_EQ(p.planes[0].seeing_points, 25u);
  EXPECT_EQ(p.planes[0].luminaires, 1u);
  EXPECT_EQ(p.first_look.work.direct_rays, 0.0);
  EXPECT_EQ(p.first_look.work.connection_rays, 0.0);
  EXPECT_GT(p.first_look.seconds.connect, 0.0);
  EXPECT_GT(p.last_look.seconds.total(), p.first_look.seconds.total());
}

TEST_F(APlan, OfABlackRoomIsExact) {
  std::fill(scene.reflectance.begin(), scene.reflectance.end(), 0.0);
  const calc::ScenePlan p = plan();
  EXPECT_EQ(decision(p, calc::Skip::no_reflection).state, calc::SkipState::applies);
  EXPECT_THAT(decision(p, calc::Skip::no_reflection).why, HasSubstr("black"));
  EXPECT_EQ(decision(p, calc::Skip::unlit_surfaces).state, calc::SkipState::not_needed);
  EXPECT_EQ(decision(p, calc::Skip::behind_plane).state, calc::SkipState::not_needed);
  EXPECT_EQ(decision(p, calc::Skip::hidden_nodes).state, calc::SkipState::not_needed);
  EXPECT_TRUE(p.planes[0].is_exact);
  EXPECT_EQ(p.looks, 0);
  EXPECT_EQ(p.last_look.work.pool_rays, 0.0);
}

TEST_F(APlan, HonoursForbiddenSkips) {
  settings.skips.forbid(calc::Skip::convex);
  const calc::ScenePlan p = plan();
  EXPECT_EQ(decision(p, calc::Skip::convex).state, calc::SkipState::forbidden);
  EXPECT_EQ(decision(p, calc::Skip::convex).why, "forbidden by --no-skip convex");
  EXPECT_FALSE(p.workload.planes[0].is_unobstructed);
  settings.skips.forbid_all();
  std::fill(scene.reflectance.begin(), scene.reflectance.end(), 0.0);
  for (const calc::SkipDecision& d : plan().skips) {
    EXPECT_EQ(d.state, calc::SkipState::forbidden) << calc::name_of(d.skip);
  }
  EXPECT_GT(plan().last_look.work.pool_rays, 0.0);
}

TEST_F(APlan, NamesThePlanesThatSeeNoReflection) {
  scene = {};
  test_support::add_quad(scene, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, 0.3);
  test_support::add_luminaire(scene, web, {0, 0, 6});
  test_support::set_extent(scene);
  const calc::SensorGrid flat = work_plane(-2, 2, 1.0);
  const calc::SensorGrid wall = square_grid({5, 0, 1}, {0, 2, 0}, {0, 0, 2}, {-1, 0, 0});
  tasks = {{"flat", &flat}, {"wall", &wall}};
  const calc::ScenePlan p = plan();
  EXPECT_EQ(decision(p, calc::Skip::behind_plane).state, calc::SkipState::applies);
  EXPECT_THAT(decision(p, calc::Skip::behind_plane).planes, ElementsAre("flat"));
  EXPECT_THAT(decision(p, calc::Skip::behind_plane).why, HasSubstr("25 of 50 points"));
  EXPECT_TRUE(p.planes[0].is_exact);
  EXPECT_FALSE(p.planes[1].is_exact);
}

TEST_F(APlan, SeesReflectionFromBehindByAnyKernelButThePlanar) {
  work = work_plane(-1.5, 1.5, 1.5);  // in the ceiling, facing up
  EXPECT_EQ(plan().planes[0].seeing_points, 0u);
  work.kernel = calc::ReceiverKernel::cylindrical;
  EXPECT_EQ(plan().planes[0].seeing_points, 25u);
  EXPECT_EQ(state(calc::Skip::behind_plane), calc::SkipState::not_proved);
}

TEST_F(APlan, CountsDarkPairsAndUnlitLuminaires) {
  const auto spot = spot_web(7, 8);
  scene.luminaires.clear();
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    scene.reflectance[t] = t < 2 ? 0.3 : 0.0;  // the floor only
  }
  test_support::add_luminaire(scene, web, {0, 0, 1.5});
  add_aimed(scene, spot, {0, 0, 0}, {0, 0, 1});
  settings.skips.forbid(calc::Skip::convex);  // it would trace no shadow ray at all
  const calc::ScenePlan p = plan();
  EXPECT_EQ(decision(p, calc::Skip::unlit_surfaces).luminaires, 1u);
  EXPECT_THAT(decision(p, calc::Skip::unlit_surfaces).why, HasSubstr("1 of 2 luminaires"));
  EXPECT_EQ(decision(p, calc::Skip::dark_pairs).luminaires, 1u);
  EXPECT_EQ(p.planes[0].luminaires, 1u);
  EXPECT_DOUBLE_EQ(p.first_look.work.direct_rays, 25.0);
}

TEST_F(APlan, NamesTheBodyInTheWay) {
  test_support::add_box(scene, {0, 0, -1.5}, {0.2, 0.2, 1}, 0.5);
  for (std::size_t t = 12; t < scene.body.size(); ++t) scene.body[t] = 3;
  const calc::ScenePlan p = plan();
  EXPECT_EQ(decision(p, calc::Skip::convex).state, calc::SkipState::not_proved);
  EXPECT_EQ(decision(p, calc::Skip::convex).body, std::optional<std::uint32_t>(3));
}

// Above all points nothing stands before the panel; a beam below it hides parts of it.
TEST_F(APlan, ExtendedOpeningsAreSampledWhereNothingIsProved) {
  const auto panel =
      test_support::lambert_web(300, 9, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0});
  scene.luminaires.clear();
  test_support::add_luminaire(scene, panel, {0, 0, 1.5});
  std::fill(scene.reflectance.begin(), scene.reflectance.end(), 0.0);
  settings.skips.forbid(calc::Skip::convex);
  const calc::ScenePlan p = plan();
  EXPECT_FALSE(p.planes[0].is_exact);
  EXPECT_EQ(p.first_look.work.direct_rays, 0.0);
  EXPECT_EQ(p.workload.planes[0].known_openings, 25.0);
  EXPECT_EQ(p.workload.planes[0].known_points, 25.0);
  EXPECT_EQ(p.workload.planes[0].obstructed_openings, 0.0);
  EXPECT_GT(p.first_look.seconds.direct, 0.0);

  test_support::add_box(scene, {-0.1, -1, 1.2}, {0.2, 2, 0.1}, 0.0);
  const calc::ScenePlan beam = plan();
  EXPECT_GE(beam.first_look.work.direct_rays, settings.replicates);
  EXPECT_LT(beam.workload.planes[0].known_openings, 25.0);
  EXPECT_GT(beam.workload.planes[0].obstructed_openings, 0.0);
}

}  // namespace
}  // namespace scene_plan_test
