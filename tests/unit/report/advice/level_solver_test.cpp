#include "report/advice/level_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace cli::level_solver_test {
namespace {

using rules::LevelCondition;

BrokenConditions broken_of(const std::vector<LevelCondition>& all) {
  return [all](const std::vector<double>& level) {
    std::vector<LevelCondition> broken;
    for (const LevelCondition& one : all) {
      if (one.lack(level) > 1e-6) broken.push_back(one);
    }
    if (broken.size() > 1) broken.resize(1);  // one at a time is enough
    return broken;
  };
}

LevelProblem two_groups(int steps, double a_w = 100.0, double b_w = 100.0) {
  return {{a_w, b_w}, {{0.0, 1.0}, {0.0, 1.0}}, steps};
}

// Two luminaires, two points: 400 a + 100 b >= 300, 100 a + 400 b >= 300 meet at a = b = 0.6.
const std::vector<LevelCondition> kTwoPoints{{{400, 100}, 300, 0}, {{100, 400}, 300, 1}};

TEST(LevelSolver, FindsTheCornerOfTwoConditions) {
  const LevelAnswer answer = least_levels(two_groups(0), broken_of(kTwoPoints));
  ASSERT_TRUE(answer.levels);
  EXPECT_NEAR(answer.levels->level[0], 0.6, 1e-6);
  EXPECT_NEAR(answer.levels->level[1], 0.6, 1e-6);
  EXPECT_NEAR(answer.levels->cost, 120.0, 1e-4);
}

TEST(LevelSolver, TakesTheCheaperGroup) {
  const LevelAnswer answer = least_levels(two_groups(0, 10.0, 100.0), broken_of(kTwoPoints));
  ASSERT_TRUE(answer.levels);
  EXPECT_NEAR(answer.levels->level[0], 1.0, 1e-6);  // 100 + 400 b >= 300
  EXPECT_NEAR(answer.levels->level[1], 0.5, 1e-6);
}

// Both hold the least cost up alike: 120 W = 0.2 W/lx * (300 + 300) lx.
TEST(LevelSolver, SaysWhatHoldsTheLeastCostUp) {
  const LevelAnswer both = least_levels(two_groups(0), broken_of(kTwoPoints));
  ASSERT_EQ(both.levels->price.size(), 2U);
  for (const ConditionPrice& one : both.levels->price) EXPECT_NEAR(one.cost_per_lx, 0.2, 1e-6);
  // One group is at full output: only the other point is left to save at.
  const LevelAnswer one = least_levels(two_groups(10, 10.0, 100.0), broken_of(kTwoPoints));
  ASSERT_EQ(one.levels->price.size(), 1U);
  EXPECT_EQ(one.levels->price[0].condition.point, 1U);
  EXPECT_NEAR(one.levels->price[0].cost_per_lx, 0.25, 1e-6);
  EXPECT_TRUE(least_levels(two_groups(0), broken_of({})).levels->price.empty());
}

// Each price against the cost of a condition that asks for a little less and a little more.
TEST(LevelSolver, HasPricesThatTheCostFollows) {
  std::mt19937 random(5);
  const auto any = [&](int from, int to) {
    return static_cast<double>(from +
                               static_cast<int>(random() % static_cast<unsigned>(to - from)));
  };
  constexpr double kLittle_lx = 1e-3;
  int priced = 0;
  for (int round = 0; round < 40; ++round) {
    const LevelProblem problem{{any(10, 90), any(10, 90), any(10, 90)}, {{}, {}, {}}, 0};
    std::vector<LevelCondition> all;
    for (std::size_t p = 0; p < 5; ++p) {
      all.push_back({{any(1, 300), any(1, 300), any(1, 300)}, any(50, 300) + 0.5, p});
    }
    const LevelAnswer answer = least_levels(problem, broken_of(all));
    if (!answer.levels) continue;
    for (LevelCondition& one : all) {
      double price = 0.0;
      for (const ConditionPrice& of : answer.levels->price) {
        if (of.condition.point == one.point) price += of.cost_per_lx;
      }
      const double asked = one.at_least;
      one.at_least = asked - kLittle_lx;
      const double less = least_levels(problem, broken_of(all)).levels->cost;
      one.at_least = asked + kLittle_lx;
      const LevelAnswer more = least_levels(problem, broken_of(all));
      one.at_least = asked;
      if (!more.levels) continue;
      // Where levels change over, the price is of one side.
      EXPECT_GE(price, (answer.levels->cost - less) / kLittle_lx - 2e-3) << "in round " << round;
      EXPECT_LE(price, (more.levels->cost - answer.levels->cost) / kLittle_lx + 2e-3)
          << "in round " << round;
      priced += price > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(priced, 30);
}

TEST(LevelSolver, KeepsToItsSteps) {
  const LevelAnswer answer = least_levels(two_groups(8), broken_of(kTwoPoints));
  ASSERT_TRUE(answer.levels);
  // One step less in any group lacks light at one of the points.
  EXPECT_EQ(answer.levels->level, (std::vector<double>{5.0 / 8.0, 5.0 / 8.0}));
  EXPECT_LE(answer.levels->least_cost, answer.levels->cost);
}

TEST(LevelSolver, KnowsWhatCannotBe) {
  std::vector<LevelCondition> dark = kTwoPoints;
  dark.push_back({{-400, -400}, -300, 2});  // at most 300 lx where both add up
  const LevelAnswer answer = least_levels(two_groups(100), broken_of(dark));
  EXPECT_FALSE(answer.levels);
  EXPECT_TRUE(answer.is_proven_none);
}

TEST(LevelSolver, KnowsThatNoStepIsBetween) {
  // 0.4 <= a <= 0.45 has no tenth but 0.4; 0.41 <= a <= 0.45 has none.
  const auto between = [](double low, double high) {
    return std::vector<LevelCondition>{{{1, 0}, low, 0}, {{-1, 0}, -high, 0}};
  };
  EXPECT_TRUE(least_levels(two_groups(10), broken_of(between(0.399, 0.45))).levels);
  const LevelAnswer none = least_levels(two_groups(10), broken_of(between(0.41, 0.45)));
  EXPECT_FALSE(none.levels);
  EXPECT_TRUE(none.is_proven_none);
  EXPECT_TRUE(least_levels(two_groups(0), broken_of(between(0.41, 0.45))).levels);
}

TEST(LevelSolver, SaysNothingWhenItIsStopped) {
  for (const int steps : {0, 10}) {
    LevelProblem problem = two_groups(steps);
    problem.is_stopped = [] { return true; };
    const LevelAnswer answer = least_levels(problem, broken_of(kTwoPoints));
    EXPECT_FALSE(answer.levels);
    EXPECT_FALSE(answer.is_proven_none);
  }
}

TEST(LevelSolver, NeedsNothingForNothing) {
  const LevelAnswer answer = least_levels(two_groups(100), broken_of({}));
  ASSERT_TRUE(answer.levels);
  EXPECT_EQ(answer.levels->level, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(answer.levels->cost, 0.0);
}

// Every combination of tenths by hand.
TEST(LevelSolver, IsNeverDearerThanAllCombinations) {
  std::mt19937 random(11);
  const auto any = [&](int from, int to) {
    return static_cast<double>(from +
                               static_cast<int>(random() % static_cast<unsigned>(to - from)));
  };
  int feasible = 0;
  for (int round = 0; round < 60; ++round) {
    LevelProblem problem{{any(10, 90), any(10, 90), any(10, 90)}, {{}, {}, {}}, 10};
    std::vector<LevelCondition> all;
    for (std::size_t p = 0; p < 5; ++p) {
      all.push_back({{any(0, 300), any(0, 300), any(0, 300)}, any(50, 350) + 0.5, p});
    }
    all.push_back({{-any(0, 300), -any(0, 300), -any(0, 300)}, -any(300, 600) - 0.5, 9});
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 11 * 11 * 11; ++i) {
      const std::vector<double> level{0.1 * (i % 11), 0.1 * (i / 11 % 11), 0.1 * (i / 121)};
      if (std::any_of(all.begin(), all.end(),
                      [&](const LevelCondition& one) { return one.lack(level) > 1e-6; })) {
        continue;
      }
      best = std::min(best, problem.cost[0] * level[0] + problem.cost[1] * level[1] +
                                problem.cost[2] * level[2]);
    }
    const LevelAnswer answer = least_levels(problem, broken_of(all));
    ASSERT_NE(answer.levels.has_value(), answer.is_proven_none);
    ASSERT_EQ(answer.levels.has_value(), best < std::numeric_limits<double>::infinity());
    if (!answer.levels) continue;
    ++feasible;
    EXPECT_NEAR(answer.levels->cost, best, 1e-6 * best) << "in round " << round;
    for (const LevelCondition& one : all) EXPECT_LE(one.lack(answer.levels->level), 1e-6);
  }
  EXPECT_GT(feasible, 15);
}

}  // namespace
}  // namespace cli::level_solver_test
