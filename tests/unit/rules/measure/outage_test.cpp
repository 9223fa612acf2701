#include "rules/measure/outage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rules::outage_test {
namespace {

// Two points under two luminaires, each a group: 10 and 1 lx from a, 2 and 8 lx from b.
calc::PlaneField field_of_two() {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 1;
  field.channels = {{"a", 1.0}, {"b", 1.0}};
  field.direct_exact_lx = {10.0, 1.0, 2.0, 8.0};
  return field;
}

calc::SensorGrid grid_of_two() {
  calc::SensorGrid grid;
  grid.columns = 2;
  grid.rows = 1;
  grid.spacing_u_m = grid.spacing_v_m = 1.0;
  grid.position_m = {{0.5, 0.5, 0.0}, {1.5, 0.5, 0.0}};
  return grid;
}

Requirement any_one_out() {
  Requirement requirement;
  requirement.metric = Metric::minimum;
  requirement.state = LightState::initial;
  requirement.scene = "night";
  requirement.any_one_unit_out = true;
  requirement.limit = 1.5;
  return requirement;
}

Measurement measured(const calc::LightScene& scene) {
  return measure(any_one_out(), grid_of_two(), field_of_two(), {scene}, 0.95);
}

TEST(Outage, TheWorstLuminaireCounts) {
  const Measurement result = measured({"night", {{"a", 1.0}, {"b", 1.0}}, {}});
  ASSERT_TRUE(result.metric.has_value()) << result.reason;
  EXPECT_DOUBLE_EQ(result.metric->estimate.value, 1.0);  // with b out, 2 with a out
  EXPECT_EQ(result.metric->point, 1u);
}

TEST(Outage, TheSceneDimsTheOthers) {
  const Measurement result = measured({"night", {{"a", 0.1}, {"b", 1.0}}, {}});
  ASSERT_TRUE(result.metric.has_value()) << result.reason;
  EXPECT_DOUBLE_EQ(result.metric->estimate.value, 0.1);
}

TEST(Outage, WhatIsDarkAnywayIsNotPutOut) {
  const Measurement result = measured({"night", {{"a", 1.0}, {"b", 0.0}}, {}});
  ASSERT_TRUE(result.metric.has_value()) << result.reason;
  EXPECT_DOUBLE_EQ(result.metric->estimate.value, 0.0);  // a, the only one, out
}

TEST(Outage, NeedsASceneThatLightsSomething) {
  EXPECT_EQ(measured({"day", {}, {}}).reason, "there is no scene 'night'");
  EXPECT_EQ(measured({"night", {{"a", 0.0}, {"b", 0.0}}, {}}).reason,
            "scene 'night' has no lit luminaire that could be out");
}

// Reflected light in replicates: each end of the interval belongs to the worst result at that end,
// and is wider than for one luminaire alone.
TEST(Outage, TheIntervalHoldsForAllOutages) {
  calc::PlaneField field = field_of_two();
  field.replicates = 4;
  field.direct_exact_lx.assign(4, 0.0);
  for (const double noise : {-1.0, 1.0, -0.5, 0.5}) {
    for (const double mean : {10.0, 7.0, 9.0, 8.0}) field.indirect_lx.push_back(mean + noise);
  }
  const std::vector<calc::LightScene> scenes{{"night", {{"a", 1.0}, {"b", 1.0}}, {}}};
  const Measurement result = measure(any_one_out(), grid_of_two(), field, scenes, 0.95);
  Requirement alone = any_one_out();
  alone.any_one_unit_out = false;
  const std::vector<calc::LightScene> b_out{{"night", {{"a", 1.0}, {"b", 0.0}}, {}}};
  const Measurement one = measure(alone, grid_of_two(), field, b_out, 0.95);
  ASSERT_TRUE(result.metric && one.metric);
  EXPECT_DOUBLE_EQ(result.metric->estimate.value, one.metric->estimate.value);
  EXPECT_LT(result.metric->estimate.low, one.metric->estimate.low);
}

// Without a replicate the worst luminaire may be another one.
TEST(Outage, WithoutAReplicateTheWorstLuminaireCountsToo) {
  calc::PlaneField field = field_of_two();
  field.replicates = 3;
  field.direct_exact_lx.assign(4, 0.0);
  // Of a and b at both points: with a out 8, 10 and 9, with b out 10, 7 and 9.5.
  for (const auto& [a, b] : {std::pair{10.0, 8.0}, {7.0, 10.0}, {9.5, 9.0}}) {
    for (const double lx : {a, a, b, b}) field.indirect_lx.push_back(lx);
  }
  const std::vector<calc::LightScene> scenes{{"night", {{"a", 1.0}, {"b", 1.0}}, {}}};
  const Measurement result = measure(any_one_out(), grid_of_two(), field, scenes, 0.95);
  ASSERT_EQ(result.without_replicate.size(), 3u);
  EXPECT_DOUBLE_EQ(result.without_replicate[0], 8.25);  // b out, (7 + 9.5) / 2
  EXPECT_DOUBLE_EQ(result.without_replicate[1], 8.5);   // a out, (8 + 9) / 2
  EXPECT_DOUBLE_EQ(result.without_replicate[2], 8.5);   // b out, (10 + 7) / 2
}

}  // namespace
}  // namespace rules::outage_test
