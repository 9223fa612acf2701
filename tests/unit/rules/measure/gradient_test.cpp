// Metric::gradient: the largest ratio between neighbouring points of a grid.

#include "rules/measure/measure.h"
#include "tests/support/normal_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace rules::gradient_test {
namespace {

// Cells of a square metre, row by row.
calc::SensorGrid grid_of(int columns, int rows) {
  calc::SensorGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.spacing_u_m = grid.spacing_v_m = 1.0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      grid.position_m.emplace_back(column + 0.5, row + 0.5, 0.0);
      grid.column.push_back(column);
      grid.row.push_back(row);
    }
  }
  return grid;
}

calc::PlaneField exact_field(const std::vector<double>& values_lx) {
  calc::PlaneField field;
  field.points = values_lx.size();
  field.replicates = 1;
  field.channels = {{"", 1.0}};
  field.direct_exact_lx = values_lx;
  return field;
}

Requirement gradient_at_most(double limit) {
  Requirement requirement;
  requirement.metric = Metric::gradient;
  requirement.comparison = Comparison::at_most;
  requirement.limit = limit;
  return requirement;
}

Measurement gradient_of(const calc::SensorGrid& grid, const calc::PlaneField& field) {
  return measure(gradient_at_most(2.0), grid, field, {}, 0.95);
}

// 10 30 20
// 11 12 90: 7.5 beside each other; the step of 9 from the other corner does not count.
TEST(Gradient, IsTheLargestRatioAcrossASideOfACell) {
  const Measurement result =
      gradient_of(grid_of(3, 2), exact_field({10.0, 30.0, 20.0, 11.0, 12.0, 90.0}));
  ASSERT_TRUE(result.metric.has_value());
  EXPECT_DOUBLE_EQ(result.metric->estimate.value, 7.5);  // 90 / 12
  EXPECT_EQ(result.metric->estimate.low, result.metric->estimate.high);
  EXPECT_EQ(result.metric->point, 5u);  // the brighter one
}

TEST(Gradient, WithoutAReplicateIsThatOfTheOthers) {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 3;
  field.channels = {{"", 1.0}};
  field.direct_exact_lx = {0.0, 0.0};
  field.indirect_lx = {10.0, 20.0, 12.0, 18.0, 8.0, 22.0};
  const Measurement result = gradient_of(grid_of(2, 1), field);
  ASSERT_EQ(result.without_replicate.size(), 3u);
  EXPECT_DOUBLE_EQ(result.without_replicate[0], 40.0 / 20.0);
  EXPECT_DOUBLE_EQ(result.without_replicate[2], 38.0 / 22.0);
}

TEST(Gradient, IsTheSameInBothDirectionsAndOneWhereAllIsAlike) {
  EXPECT_DOUBLE_EQ(gradient_of(grid_of(2, 1), exact_field({10, 25})).metric->estimate.value, 2.5);
  EXPECT_DOUBLE_EQ(gradient_of(grid_of(2, 1), exact_field({25, 10})).metric->estimate.value, 2.5);
  EXPECT_DOUBLE_EQ(gradient_of(grid_of(1, 3), exact_field({7, 7, 7})).metric->estimate.value, 1.0);
}

// A scene that is off is not even.
TEST(Gradient, OfADarkPlaneIsUndefined) {
  const Measurement result = gradient_of(grid_of(2, 2), exact_field({0, 0, 0, 0}));
  EXPECT_FALSE(result.metric.has_value());
  EXPECT_THAT(result.reason.english(), testing::HasSubstr("all points are 0 lx"));
}

TEST(Gradient, KnowsNoNeighboursBeyondTheMaskOrInLists) {
  Requirement requirement = gradient_at_most(2.0);
  requirement.mask = {"inner", {{MaskStep::inset, 0.6, 0, 0}}};
  const Measurement inner = measure(requirement, grid_of(4, 3),
                                    exact_field({1, 9, 1, 9, 1, 20, 30, 1, 9, 1, 9, 1}), {}, 0.95);
  ASSERT_TRUE(inner.metric.has_value());
  EXPECT_DOUBLE_EQ(inner.metric->estimate.value, 1.5);
  EXPECT_EQ(inner.points_used, 2u);

  calc::SensorGrid list = grid_of(2, 1);
  list.columns = list.rows = 0;
  EXPECT_EQ(gradient_of(list, exact_field({1, 2})).reason,
            "the plane has no two neighbouring points");
}

TEST(Gradient, HasNoLimitBesideAPointThatIsDark) {
  const Measurement result = gradient_of(grid_of(3, 1), exact_field({10.0, 10.0, 0.0}));
  EXPECT_FALSE(result.metric.has_value());
  EXPECT_THAT(result.reason.english(), testing::HasSubstr("may be dark"));
}

// 400 lx and 300 lx side by side in a plane of 300 .. 310 lx, known to 1 % each.
TEST(Gradient, IntervalsHoldTheTruth) {
  constexpr int kExperiments = 400;
  constexpr std::size_t kReplicates = 16;
  std::vector<double> truth_lx;
  for (int i = 0; i < 20; ++i) truth_lx.push_back(300.0 + 0.5 * i);
  truth_lx[7] = 400.0;
  const calc::SensorGrid grid = grid_of(5, 4);
  const double truth = gradient_of(grid, exact_field(truth_lx)).metric->estimate.value;
  NormalNumbers normal(20261122);
  int held = 0;
  double width = 0.0;
  for (int experiment = 0; experiment < kExperiments; ++experiment) {
    calc::PlaneField field = exact_field(std::vector<double>(20, 0.0));
    field.replicates = kReplicates;
    for (std::size_t r = 0; r < kReplicates; ++r) {
      for (const double lx : truth_lx) {
        field.indirect_lx.push_back(lx * (1.0 + 0.04 * normal.next()));
      }
    }
    const Measurement result = gradient_of(grid, field);
    ASSERT_TRUE(result.metric.has_value()) << result.reason;
    const calc::Estimate& found = result.metric->estimate;
    if (found.low <= truth && truth <= found.high) ++held;
    width += (found.high - found.low) / kExperiments;
  }
  EXPECT_GE(held, 375);    // 95 % would be 380 +- 4.4; the ends are conservative
  EXPECT_LT(width, 0.20);  // of 1.32: no interval that says nothing
  EXPECT_GT(width, 0.02);
}

}  // namespace
}  // namespace rules::gradient_test
