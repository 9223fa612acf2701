#include "calc/radiosity/looks/solve.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace solve_test {
namespace {

using namespace test_support;

calc::LookAnswer go_on(std::size_t, const calc::PlaneField&, calc::Look) { return {}; }

calc::SensorGrid one_point(const glm::dvec3& position_m) {
  calc::SensorGrid grid;
  grid.position_m = {position_m};
  grid.normal = {{0, 0, 1}};
  return grid;
}

class SolveIlluminance : public testing::Test {
 protected:
  calc::SpaceSolution solve(double cube_m, const std::vector<calc::PlaneTask>& tasks,
                            const calc::LookTest& test, const calc::ProgressSink& progress) {
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, {cube_m, cube_m, cube_m}, 0.5);
    add_luminaire(scene, web, {0.3 * cube_m, 0.5 * cube_m, 0.8 * cube_m});
    set_extent(scene);
    calc::RadiositySettings settings;
    settings.first_paths = 64;
    settings.max_paths = 256;
    const auto gatherer = calc::make_cpu_gatherer();
    return calc::solve_illuminance(scene, tasks, settings, 0.95, *gatherer, test, progress);
  }

  calc::PhotometricWeb web = isotropic_web(100.0);
};

TEST_F(SolveIlluminance, InterruptedBeforeTheFirstResultKeepsWhatIsExact) {
  const calc::SensorGrid inside = one_point({1, 1, 1});
  const calc::SensorGrid above = one_point({1, 1, 50});  // nothing is in front of it
  const calc::SpaceSolution solution = solve(4.0, {{"inside", &inside}, {"above", &above}}, go_on,
                                             [](const calc::SolveProgress&) { return false; });
  EXPECT_NE(solution.fields[0].problem, "");
  EXPECT_EQ(solution.fields[1].problem, "");
  EXPECT_EQ(solution.fields[1].stop, calc::StopReason::exact);
  EXPECT_EQ(solution.balance.absorbed_lm.value, 0.0);  // not known, rather than a part of it
  EXPECT_EQ(solution.balance.absorbed_lm.high, 0.0);
}

TEST_F(SolveIlluminance, NoShortRaysWhereNothingIsNear) {
  for (const double cube_m : {2.7, 3.1, 4.0, 5.3, 6.1, 7.7}) {
    const calc::SensorGrid centre = one_point(glm::dvec3(0.5 * cube_m));
    const calc::SpaceSolution solution = solve(cube_m, {{"centre", &centre}}, go_on, {});
    EXPECT_EQ(solution.fields[0].counters.near_rays, 0u) << cube_m;
    EXPECT_GT(solution.fields[0].indirect_lx.front(), 0.0);
  }
}

TEST_F(SolveIlluminance, PointsLeftOutKeepTheirEstimate) {
  calc::SensorGrid grid = one_point({1, 1, 1});
  grid.position_m.push_back({3, 2, 1});
  grid.normal.push_back({0, 0, 1});
  std::vector<std::vector<double>> values;
  std::vector<float> shares;
  const calc::SpaceSolution solution =
      solve(4.0, {{"plane", &grid}},
            [&](std::size_t, const calc::PlaneField& field, calc::Look) {
              values.push_back(field.indirect_lx);
              shares.push_back(field.largest_share[0]);
              calc::LookAnswer answer;
              answer.active = {0, 1};
              return answer;
            },
            {});
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(solution.fields[0].counters.active_points, (std::vector<std::size_t>{2, 1, 1}));
  EXPECT_EQ(solution.fields[0].looks_planned, 3);
  for (std::size_t r = 0; r < 16; ++r) {
    EXPECT_EQ(values[2][2 * r], values[0][2 * r]);
    EXPECT_NE(values[2][2 * r + 1], values[0][2 * r + 1]);
  }
  EXPECT_EQ(shares[2], shares[0]);
}

// A panel over a black floor, seen whole or past an edge that leaves a hundredth of it.
TEST_F(SolveIlluminance, FewSamplesOfAnOpeningAreMarked) {
  const calc::PhotometricWeb panel =
      lambert_web(500.0, 45, {calc::OpeningShape::rectangle, 1.0, 1.0, 0.0});
  calc::PreparedScene scene;
  add_quad(scene, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 0.0);
  add_luminaire(scene, panel, {0, 0, 3});
  const calc::SensorGrid grid = one_point({0, 0, 1});
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = 1;
  settings.replicates = 4;
  const auto share = [&] {
    set_extent(scene);
    const auto gatherer = calc::make_cpu_gatherer();
    const calc::SpaceSolution solution =
        calc::solve_illuminance(scene, {{"plane", &grid}}, settings, 0.95, *gatherer, go_on, {});
    EXPECT_EQ(solution.fields[0].unseen[0], 0);
    return solution.fields[0].largest_share[0];
  };
  EXPECT_EQ(share(), 0.0f);
  add_quad(scene, {-2, -0.24, 2}, {4, 0, 0}, {0, 4, 0}, 0.0);
  EXPECT_GT(share(), 0.1f);
}

}  // namespace
}  // namespace solve_test
