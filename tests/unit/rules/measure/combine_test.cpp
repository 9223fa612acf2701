#include "rules/measure/metrics.h"

#include <gtest/gtest.h>

#include <utility>

namespace rules::combine_test {
namespace {

// Two channels, two points, two replicates.
calc::PlaneField sample_field() {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 2;
  field.channels = {{"row1", 0.8}, {"", 0.5}};
  field.direct_exact_lx = {100, 200, 10, 20};
  field.indirect_lx = {1, 2, 3, 4,   //
                       5, 6, 7, 8};  // [replicate][channel][point]
  return field;
}

TEST(CombineChannels, AddsExactPartToEveryReplicate) {
  const PointValues values = combine_channels(sample_field(), LightState::initial, {});
  EXPECT_EQ(values.points, 2u);
  EXPECT_EQ(values.replicates, 2u);
  EXPECT_FALSE(values.is_exact());
  EXPECT_DOUBLE_EQ(values.at(0, 0), 100 + 1 + 10 + 3);
  EXPECT_DOUBLE_EQ(values.at(0, 1), 200 + 2 + 20 + 4);
  EXPECT_DOUBLE_EQ(values.at(1, 0), 100 + 5 + 10 + 7);
  EXPECT_DOUBLE_EQ(values.at(1, 1), 200 + 6 + 20 + 8);
}

TEST(CombineChannels, MultipliesByMaintenanceFactorWhenMaintained) {
  const PointValues values = combine_channels(sample_field(), LightState::maintained, {});
  EXPECT_DOUBLE_EQ(values.at(0, 0), 0.8 * 101 + 0.5 * 13);
  EXPECT_DOUBLE_EQ(values.at(1, 1), 0.8 * 206 + 0.5 * 28);
}

TEST(CombineChannels, MultipliesByLevelOfTheGroup) {
  const PointValues values =
      combine_channels(sample_field(), LightState::maintained, {{"row1", 0.25}, {"other", 0.0}});
  EXPECT_DOUBLE_EQ(values.at(0, 0), 0.25 * 0.8 * 101 + 0.5 * 13);
}

TEST(CombineChannels, AddsSampledDirectLight) {
  calc::PlaneField field = sample_field();
  field.direct_sampled_lx = {1000, 0, 0, 2000, 0, 0, 0, 0};
  const PointValues values = combine_channels(field, LightState::initial, {});
  EXPECT_DOUBLE_EQ(values.at(0, 0), 114 + 1000);
  EXPECT_DOUBLE_EQ(values.at(0, 1), 226 + 2000);
  EXPECT_DOUBLE_EQ(values.at(1, 0), 122);
}

// What one sample is of all light together may be most of a scene that leaves little of it.
TEST(CombineChannels, ASamplesShareGrowsWhereAScenesLightIsLess) {
  calc::PlaneField field = sample_field();
  field.largest_share = {0.01f, 0.01f};
  const PointValues full = combine_channels(field, LightState::initial, {});
  EXPECT_FLOAT_EQ(full.largest_share[0], 0.01f);
  const PointValues dimmed = combine_channels(field, LightState::initial, {{"row1", 0.0}});
  // Point 0: 118 lx in all (means 103 and 15), 15 of them left.
  EXPECT_FLOAT_EQ(dimmed.largest_share[0], 0.01f * 118.0f / 15.0f);
}

// Panels that are out beside emergency luminaires, which are points: no sample of theirs is
// missing.
TEST(CombineChannels, DirectLightThatIsNotSampledIsNotUnseen) {
  calc::PlaneField field = sample_field();
  field.channels[1].may_sample_direct = false;
  field.direct_sampled_lx = {1000, 0, 0, 0, 1000, 0, 0, 0};
  field.unseen = {1, 1};
  const auto unseen = [&](double level) {
    const PointValues values =
        combine_channels(field, LightState::initial, {{"row1", level}}, LightParts::direct);
    return std::pair(values.is_unseen(0), values.is_unseen(1));
  };
  EXPECT_EQ(unseen(0.0), std::pair(false, false));
  EXPECT_EQ(unseen(0.5), std::pair(false, true)) << "the panel's light may be missed at point 1";
  field.channels[1].may_sample_direct = true;
  EXPECT_EQ(unseen(0.0), std::pair(true, true));
}

TEST(CombineChannels, OfAnExactFieldHasOneReplicate) {
  calc::PlaneField field = sample_field();
  field.indirect_lx.clear();
  const PointValues values = combine_channels(field, LightState::initial, {});
  EXPECT_TRUE(values.is_exact());
  ASSERT_EQ(values.value_lx.size(), 2u);
  EXPECT_DOUBLE_EQ(values.at(0, 1), 220);
}

TEST(CombineChannels, WithoutLuminairesIsExactDarkness) {
  calc::PlaneField field;
  field.points = 3;
  field.replicates = 16;
  const PointValues values = combine_channels(field, LightState::maintained, {});
  EXPECT_TRUE(values.is_exact());
  EXPECT_EQ(values.value_lx, std::vector<double>(3, 0.0));
}

}  // namespace
}  // namespace rules::combine_test
