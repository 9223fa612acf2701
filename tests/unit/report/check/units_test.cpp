#include "report/check/units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace check::units_test {
namespace {

// A project of one space whose planes are alike.
ProjectPlan planned(const std::string& path, std::size_t planes) {
  constexpr std::size_t kPoints = 100;
  SpacePlan space;
  space.id = "hall";
  for (std::size_t p = 0; p < planes; ++p) {
    calc::PlanePlan plane;
    plane.plane_id = "p" + std::to_string(p);
    plane.points = kPoints;
    space.plan.planes.push_back(plane);
    calc::PlaneWorkload load;
    load.points = load.seeing_points = kPoints;
    load.sampled_direct_rays = 1e6;
    space.plan.workload.planes.push_back(load);
  }
  ProjectPlan project;
  project.path = path;
  project.is_planned = true;
  project.spaces = {space};
  return project;
}

Unit unit_of(double seconds) {
  Unit unit;
  unit.first_look_s = seconds;
  return unit;
}

std::vector<double> loads_of(const std::vector<Unit>& units, std::size_t count) {
  std::vector<double> loads(count, 0.0);
  const std::vector<std::size_t> shards = shards_of(units, count);
  for (std::size_t u = 0; u < units.size(); ++u) loads.at(shards.at(u)) += units[u].first_look_s;
  return loads;
}

TEST(Units, ASpaceIsOne) {
  const std::vector<Unit> units = units_of({planned("a.xml", 3), planned("b.xml", 1)}, {}, 1e9);
  ASSERT_EQ(units.size(), 2U);
  EXPECT_EQ(unit_name(units[0]), "a.xml: hall");
  EXPECT_THAT(units[0].planes, testing::ElementsAre("p0", "p1", "p2"));
  EXPECT_EQ(units[0].points, 300U);
  EXPECT_TRUE(units[0].is_whole_space);
  EXPECT_GT(units[0].first_look_s, units[1].first_look_s);
}

TEST(Units, ALargeSpaceIsSplitBetweenPlanesAndLosesNone) {
  const ProjectPlan hall = planned("a.xml", 5);
  const double all_s = units_of({hall}, {}, 1e9).front().first_look_s;
  const double one_s = units_of({planned("a.xml", 1)}, {}, 1e9).front().first_look_s;
  const double two_s = units_of({planned("a.xml", 2)}, {}, 1e9).front().first_look_s;
  ASSERT_LT(two_s, all_s);
  const std::vector<Unit> pairs = units_of({hall}, {}, two_s);
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(unit_name(pairs[0]), "a.xml: hall (p0, p1)");
  EXPECT_EQ(unit_name(pairs[2]), "a.xml: hall (p4)");
  EXPECT_FALSE(pairs[0].is_whole_space);
  // A plane that is too large for itself stays whole.
  EXPECT_EQ(units_of({hall}, {}, 0.5 * one_s).size(), 5U);
}

TEST(Units, ASpaceWithoutPointsHasNone) {
  EXPECT_TRUE(units_of({planned("a.xml", 0)}, {}, 1e9).empty());
}

TEST(Shards, EveryUnitIsInOne) {
  std::vector<Unit> units;
  for (int u = 0; u < 50; ++u) units.push_back(unit_of(1.0 + u % 7));
  for (const std::size_t count : {1U, 2U, 3U, 16U, 50U, 200U}) {
    const std::vector<std::size_t> shards = shards_of(units, count);
    ASSERT_EQ(shards.size(), units.size());
    EXPECT_LT(*std::max_element(shards.begin(), shards.end()), count);
  }
  EXPECT_TRUE(shards_of({}, 3).empty());
}

// No shard has more than the mean, and half a unit more at each end.
TEST(Shards, AreBalancedByCost) {
  std::vector<Unit> units;
  for (int u = 0; u < 200; ++u) units.push_back(unit_of(0.1 + (u * 7919 % 101) * 0.05));
  units.push_back(unit_of(30.0));
  for (const std::size_t count : {2U, 5U, 11U}) {
    const std::vector<double> loads = loads_of(units, count);
    const double all = std::accumulate(loads.begin(), loads.end(), 0.0);
    const double mean = all / static_cast<double>(count);
    for (std::size_t s = 0; s < count; ++s) {
      const bool has_large = shards_of(units, count).back() == s;
      const double over = has_large ? 0.5 * (5.1 + 30.0) : 5.1;
      EXPECT_LE(loads[s], mean + over) << s << " of " << count;
    }
    EXPECT_LE(*std::max_element(loads.begin(), loads.end() - 1), mean + 5.1) << count;
  }
}

TEST(Shards, KeepTheOrderOfTheList) {
  std::vector<Unit> units;
  for (int u = 0; u < 200; ++u) units.push_back(unit_of(0.1 + (u * 7919 % 101) * 0.05));
  for (const std::size_t count : {2U, 7U, 200U}) {
    const std::vector<std::size_t> shards = shards_of(units, count);
    EXPECT_TRUE(std::is_sorted(shards.begin(), shards.end())) << count;
  }
}

TEST(Shards, OfEqualUnitsHaveEqualNumbers) {
  EXPECT_THAT(shards_of(std::vector<Unit>(6, unit_of(1.0)), 3),
              testing::ElementsAre(0, 0, 1, 1, 2, 2));
  EXPECT_THAT(shards_of(std::vector<Unit>(3, unit_of(2.0)), 3), testing::ElementsAre(0, 1, 2));
  // Where nothing is known of their costs, too.
  EXPECT_THAT(shards_of(std::vector<Unit>(4, unit_of(0.0)), 2), testing::ElementsAre(0, 0, 1, 1));
}

}  // namespace
}  // namespace check::units_test
