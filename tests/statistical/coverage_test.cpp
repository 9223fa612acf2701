// Do the 95 % intervals hold the truth in 95 % of runs? 240 independent seeds, points in the open,
// 5 mm from a wall and in a corner, and the plane average; the truth is a run with 256 times the
// paths under other seeds.
#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace {

using namespace test_support;

constexpr int kSeeds = 240;

struct Case {
  const char* name;
  double reflectance;
  glm::dvec3 source;
  bool is_extended;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Coverage : public testing::TestWithParam<Case> {};

TEST_P(Coverage, OfPointsAndAverageIsNominal) {
  const Case& test = GetParam();
  const calc::LuminousOpening panel{calc::OpeningShape::rectangle, 0.6, 0.6, 0.0};
  const calc::PhotometricWeb web =
      lambert_web(500.0, 45, test.is_extended ? panel : calc::LuminousOpening{});
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, test.reflectance);
  add_box(scene, {1.0, 1.0, 0}, {1.2, 0.6, 0.6}, 0.4);
  add_luminaire(scene, web, test.source);
  set_extent(scene);
  calc::SensorGrid grid;
  grid.position_m = {{2.5, 2.2, 0.75},   {0.7, 0.6, 0.75},     {0.005, 1.5, 0.75},
                     {2.0, 2.995, 0.75}, {0.005, 0.005, 0.75}, {3.995, 2.995, 0.005},
                     {0.995, 1.3, 0.3},  {1.5, 1.2, 0.6}};
  grid.normal.assign(grid.position_m.size(), {0, 0, 1});
  const std::size_t points = grid.position_m.size();

  // Truth: 64 replicates of 16384 paths against 16 of 256.
  std::vector<double> truth(points + 1, 0.0);
  const calc::SpaceSolution reference = solve_with_paths(scene, grid, 999999, 16384, 64);
  for (std::size_t i = 0; i < points; ++i) {
    truth[i] = calc::replicate_mean(replicates_at(reference.fields[0], i)).mean;
  }
  truth[points] = calc::replicate_mean(replicate_averages(reference.fields[0])).mean;

  std::vector<int> covered(points + 1, 0);
  std::vector<double> mean(points + 1, 0.0), mean_square(points + 1, 0.0);
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const calc::SpaceSolution run =
        solve_with_paths(scene, grid, static_cast<std::uint64_t>(seed), 256);
    for (std::size_t i = 0; i <= points; ++i) {
      const std::vector<double> replicates =
          i < points ? replicates_at(run.fields[0], i) : replicate_averages(run.fields[0]);
      const calc::Estimate estimate = calc::t_interval(replicates, 0.95);
      if (estimate.low <= truth[i] && truth[i] <= estimate.high) ++covered[i];
      mean[i] += estimate.value / kSeeds;
      mean_square[i] += estimate.value * estimate.value / kSeeds;
    }
  }
  int all_points = 0;
  for (std::size_t i = 0; i <= points; ++i) {
    const double spread = std::sqrt(std::max(0.0, mean_square[i] - mean[i] * mean[i]));
    const double bias = mean[i] - truth[i];
    std::printf("%s %zu: truth %.3f lx, sd of a run %.2f %%, bias %.3f %%, coverage %.1f %%\n",
                test.name, i, truth[i], 100 * spread / truth[i], 100 * bias / truth[i],
                100.0 * covered[i] / kSeeds);
    if (i < points) all_points += covered[i];
    // 240 runs at 95 %: P(covered < 216) = 0.05 %, over 9 quantities 0.4 %.
    EXPECT_GE(covered[i], 216) << i;
    // Bias: four standard errors of the mean of 240 runs, and the reference's own error (1/16 of a
    // run's).
    EXPECT_LT(std::abs(bias), 4.0 * spread * (1.0 / std::sqrt(kSeeds) + 1.0 / 16.0)) << i;
  }
  const double share = static_cast<double>(all_points) / static_cast<double>(points * kSeeds);
  EXPECT_GE(share, 0.92);
  EXPECT_LE(share, 0.985);
}

INSTANTIATE_TEST_SUITE_P(Rooms, Coverage,
                         testing::Values(Case{"mid", 0.5, {2.0, 1.5, 2.5}, false},
                                         Case{"bright", 0.8, {2.0, 1.5, 2.5}, true},
                                         Case{"wall-washed", 0.5, {0.03, 1.5, 1.6}, false}));

}  // namespace
