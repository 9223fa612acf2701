#include "rules/accuracy.h"

#include <gtest/gtest.h>

namespace rules {
namespace {

calc::SensorGrid two_points() {
  calc::SensorGrid grid;
  grid.position_m = {{0, 0, 0}, {1, 0, 0}};
  return grid;
}

// Point 0 always has 100 lx; point 1 has 200 lx -+ spread in four replicates.
calc::PlaneField field_with_spread(double spread_lx) {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 4;
  field.channels = {{"night", 1.0}};
  for (const double sign : {-1.0, 1.0, 1.0, -1.0}) {
    field.indirect_lx.push_back(100);
    field.indirect_lx.push_back(200 + sign * spread_lx);
  }
  return field;
}

Requirement judged(Metric metric) {
  Requirement requirement;
  requirement.metric = metric;
  return requirement;
}

bool is_accurate_to(double tolerance, const std::vector<Requirement>& requirements,
                    const calc::PlaneField& field,
                    const std::vector<calc::LightScene>& scenes = {}) {
  return is_accurate(requirements, two_points(), field, scenes, tolerance, 0.95);
}

// Average: half-width = 3.1824 * (10 / 2) * sqrt(4 / 3) / 2 = 9.187 lx of 150 lx, 6.12 %.
TEST(Accuracy, ComparesHalfWidthWithTheToleranceOfTheValue) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_TRUE(is_accurate_to(0.0613, {judged(Metric::average)}, field));
  EXPECT_FALSE(is_accurate_to(0.0612, {judged(Metric::average)}, field));
}

TEST(Accuracy, LooksAtJudgedQuantitiesOnly) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_TRUE(is_accurate_to(1e-9, {judged(Metric::minimum)}, field));
  EXPECT_FALSE(is_accurate_to(0.05, {judged(Metric::minimum), judged(Metric::maximum)}, field));
}

TEST(Accuracy, WithoutRequirementsIsThatOfAverageAndMinimum) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_TRUE(is_accurate_to(0.0613, {}, field));  // the maximum would need 9.2 %
  EXPECT_FALSE(is_accurate_to(0.0612, {}, field));
  calc::PlaneField swapped = field;  // 100 lx -+ 10 at the minimum, too: 18 %
  for (std::size_t r = 0; r < 4; ++r)
    swapped.indirect_lx[2 * r] = field.indirect_lx[2 * r + 1] - 100;
  EXPECT_FALSE(is_accurate_to(0.15, {}, swapped));
  EXPECT_TRUE(is_accurate_to(0.15, {judged(Metric::average)}, swapped));
}

TEST(Accuracy, UsesTheSceneOfTheRequirement) {
  Requirement requirement = judged(Metric::average);
  requirement.scene = "off";
  const std::vector<calc::LightScene> scenes{{"off", {{"night", 0.0}}, {}}};
  EXPECT_TRUE(is_accurate_to(1e-9, {requirement}, field_with_spread(10), scenes));
}

TEST(Accuracy, OfExactDarknessIsReached) {
  calc::PlaneField dark = field_with_spread(0);
  for (double& value : dark.indirect_lx) value = 0.0;
  EXPECT_TRUE(is_accurate_to(0.02, {}, dark));
  EXPECT_TRUE(is_accurate_to(0.02, {judged(Metric::uniformity_min_avg)}, dark));
}

TEST(Accuracy, OfAPlaceOutsideTheGridIsReached) {
  Requirement requirement = judged(Metric::value_at_point);
  requirement.point_m = glm::dvec3(50, 50, 50);
  EXPECT_TRUE(is_accurate_to(0.02, {requirement}, field_with_spread(100)));
}

}  // namespace
}  // namespace rules
