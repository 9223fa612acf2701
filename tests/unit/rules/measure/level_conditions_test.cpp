// What conditions say of levels is what judging says of the light at these levels.

#include "rules/measure/level_conditions.h"

#include "rules/verdict/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace rules::level_conditions_test {
namespace {

const std::vector<std::string> kGroups{"a", "b"};

calc::SensorGrid row_of(std::size_t points) {
  calc::SensorGrid grid;
  grid.columns = static_cast<int>(points);
  grid.rows = 1;
  grid.spacing_u_m = grid.spacing_v_m = 1.0;
  for (std::size_t i = 0; i < points; ++i) {
    grid.position_m.emplace_back(static_cast<double>(i) + 0.5, 0.5, 0.0);
    grid.normal.emplace_back(0.0, 0.0, 1.0);
    grid.column.push_back(static_cast<int>(i));
    grid.row.push_back(0);
  }
  return grid;
}

// Exact light of two groups, and of luminaires without one, whose maintenance differs.
calc::PlaneField exact_field(const std::vector<double>& a_lx, const std::vector<double>& b_lx,
                             double others_lx = 0.0) {
  calc::PlaneField field;
  field.points = a_lx.size();
  field.replicates = 2;
  field.channels = {{"a", 0.8}, {"b", 0.5}, {"", 1.0}};
  for (const double lx : a_lx) field.direct_exact_lx.push_back(lx / 0.8);
  for (const double lx : b_lx) field.direct_exact_lx.push_back(lx / 0.5);
  for (std::size_t i = 0; i < a_lx.size(); ++i) field.direct_exact_lx.push_back(others_lx);
  return field;
}

Requirement required(Metric metric, Comparison comparison, double limit) {
  Requirement requirement;
  requirement.metric = metric;
  requirement.comparison = comparison;
  requirement.limit = limit;
  requirement.scene = "s";
  return requirement;
}

bool is_met(const LevelConditions& conditions, const std::vector<double>& level,
            double safety = 1.0) {
  return conditions.broken(level, safety, 1).empty();
}

Verdict judged(const Requirement& requirement, const calc::PlaneField& field,
               const std::vector<double>& level) {
  const std::vector<calc::LightScene> scenes{{"s", {{"a", level[0]}, {"b", level[1]}}, {}}};
  return judge_plane({requirement}, row_of(field.points), field, scenes, 0.95).front().verdict;
}

TEST(LevelConditions, ArePlainSumsOfExactLight) {
  const calc::PlaneField field = exact_field({400, 100}, {50, 250}, 10.0);
  const LevelConditions least(required(Metric::minimum, Comparison::at_least, 200), row_of(2),
                              field, kGroups, 0.95);
  ASSERT_EQ(least.problem(), "");
  const auto broken = least.broken({0.25, 0.25}, 1.0, 9);
  ASSERT_EQ(broken.size(), 2U);
  // Worst first: 100/4 + 250/4 + 10 = 97.5 at the second point, 122.5 at the first.
  EXPECT_EQ(broken[0].point, 1U);
  EXPECT_NEAR(broken[0].lack({0.25, 0.25}), 200 - 97.5, 1e-3);
  EXPECT_NEAR(broken[1].lack({0.25, 0.25}), 200 - 122.5, 1e-3);
  EXPECT_NEAR(broken[0].coefficient[0], 100, 1e-9);
  EXPECT_NEAR(broken[0].coefficient[1], 250, 1e-9);
  EXPECT_NEAR(broken[0].at_least, 190, 1e-3);
  EXPECT_EQ(least.broken({0.25, 0.25}, 1.0, 1).size(), 1U);
  EXPECT_TRUE(is_met(least, {0.4, 0.61}));
}

TEST(LevelConditions, SayWhatJudgingSays) {
  std::mt19937 random(7);
  const auto any = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() % 10001) / 10000.0;
  };
  const std::vector<Requirement> all{
      required(Metric::average, Comparison::at_least, 200),
      required(Metric::average, Comparison::at_most, 200),
      required(Metric::minimum, Comparison::more_than, 120),
      required(Metric::maximum, Comparison::at_most, 260),
      required(Metric::maximum, Comparison::less_than, 260),
      required(Metric::uniformity_min_avg, Comparison::at_least, 0.6),
      required(Metric::uniformity_min_max, Comparison::at_least, 0.4)};
  int passes = 0, fails = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<double> a, b;
    for (int i = 0; i < 6; ++i) {
      a.push_back(any(0, 400));
      b.push_back(any(50, 400));
    }
    const calc::PlaneField field = exact_field(a, b, any(0, 60));
    const std::vector<double> level{any(0, 1), any(0.05, 1)};
    for (const Requirement& requirement : all) {
      const LevelConditions conditions(requirement, row_of(6), field, kGroups, 0.95);
      ASSERT_EQ(conditions.problem(), "");
      const bool passes_judging = judged(requirement, field, level) == Verdict::pass;
      EXPECT_EQ(is_met(conditions, level), passes_judging)
          << calc::name_of(requirement.metric) << " in round " << round;
      ++(passes_judging ? passes : fails);
    }
  }
  EXPECT_GT(passes, 200);
  EXPECT_GT(fails, 200);
}

// With noise the conditions ask for more room than judging: half widths of groups are added up.
TEST(LevelConditions, NeverPromiseWhatJudgingLeavesOpen) {
  std::mt19937 random(3);
  const auto noise = [&] { return static_cast<double>(random() % 2001) / 100.0 - 10.0; };
  int met = 0;
  for (int round = 0; round < 100; ++round) {
    calc::PlaneField field = exact_field({300, 200, 250}, {150, 250, 200});
    field.replicates = 8;
    for (std::size_t i = 0; i < field.replicates * 3 * field.points; ++i) {
      field.indirect_lx.push_back(40.0 + noise());
    }
    field.unseen.assign(field.points, 0);
    field.largest_share.assign(field.points, 0.0F);
    const std::vector<double> level{0.01 * static_cast<double>(random() % 101),
                                    0.01 * static_cast<double>(random() % 101)};
    for (const Requirement& requirement : {required(Metric::average, Comparison::at_least, 300),
                                           required(Metric::minimum, Comparison::at_least, 280),
                                           required(Metric::maximum, Comparison::at_most, 400)}) {
      const LevelConditions conditions(requirement, row_of(3), field, kGroups, 0.95);
      if (!is_met(conditions, level)) continue;
      ++met;
      EXPECT_EQ(judged(requirement, field, level), Verdict::pass)
          << calc::name_of(requirement.metric) << " in round " << round;
    }
  }
  EXPECT_GT(met, 30);
}

// Against conditions whose limit is a little greater.
TEST(LevelConditions, SayWhatALimitAsksForAndWhatGivesTheLight) {
  const calc::PlaneField field = exact_field({400, 100}, {50, 250}, 10.0);
  const std::vector<double> level{0.5, 0.2};  // 220 and 110 lx
  for (const Requirement& asked :
       {required(Metric::average, Comparison::at_least, 400),
        required(Metric::maximum, Comparison::at_most, 100),
        required(Metric::uniformity_min_avg, Comparison::at_least, 0.9),
        required(Metric::uniformity_min_max, Comparison::at_least, 0.9)}) {
    constexpr double kLittle = 1e-3;
    Requirement more = asked;
    more.limit += kLittle;
    const LevelConditions conditions(asked, row_of(2), field, kGroups, 0.95);
    const auto broken = conditions.broken(level, 0.0, 1);
    const auto of_more =
        LevelConditions(more, row_of(2), field, kGroups, 0.95).broken(level, 0.0, 1);
    ASSERT_EQ(broken.size() + of_more.size(), 2U) << calc::name_of(asked.metric);
    EXPECT_NEAR(of_more[0].lack(level) - broken[0].lack(level),
                kLittle * conditions.lx_per_limit(level), 1e-6)
        << calc::name_of(asked.metric);
  }
  const LevelConditions average(required(Metric::average, Comparison::at_least, 400), row_of(2),
                                field, kGroups, 0.95);
  EXPECT_THAT(average.light_lx(average.broken(level, 0.0, 1)[0], level),
              testing::Pointwise(testing::DoubleNear(1e-9), {125.0, 30.0, 10.0}));
  for (const Metric metric : {Metric::uniformity_min_avg, Metric::uniformity_min_max}) {
    const LevelConditions share(required(metric, Comparison::at_least, 0.9), row_of(2), field,
                                kGroups, 0.95);
    const auto broken = share.broken(level, 0.0, 1);
    EXPECT_EQ(broken[0].point, 1U);
    EXPECT_THAT(share.light_lx(broken[0], level),
                testing::Pointwise(testing::DoubleNear(1e-9), {50.0, 50.0, 10.0}));
  }
}

TEST(LevelConditions, SafetyIsRoom) {
  calc::PlaneField field = exact_field({300}, {0});
  field.indirect_lx = {20, 0, 0, 40, 0, 0};  // two replicates: 30 -+ 10
  const LevelConditions conditions(required(Metric::average, Comparison::at_least, 300), row_of(1),
                                   field, kGroups, 0.95);
  EXPECT_TRUE(is_met(conditions, {1.0, 0.0}, 0.0));
  EXPECT_FALSE(is_met(conditions, {1.0, 0.0}, 1.0));
  EXPECT_FALSE(is_met(conditions, {0.9, 0.0}, 0.0));
}

// What not even the favourable ends of all intervals meet surely cannot be met: these are wider
// than those of verdicts, as they are to hold together.
TEST(LevelConditions, ByTheWholeIntervalMuchCanBeMet) {
  calc::PlaneField field = exact_field({300, 150}, {0, 0});
  field.replicates = 8;
  for (std::size_t r = 0; r < field.replicates; ++r) {
    const double noise = static_cast<double>(r % 4) - 1.5;
    field.indirect_lx.insert(field.indirect_lx.end(), {40 + 2 * noise, 30 - noise, 0, 0, 0, 0});
  }
  const std::vector<double> full{1.0, 1.0};
  const auto can_be_met = [&](Metric metric, Comparison comparison, double limit) {
    return is_met(
        LevelConditions(required(metric, comparison, limit), row_of(2), field, kGroups, 0.95), full,
        -1.0);
  };
  const auto measured = [&](Metric metric, Comparison comparison) {
    const std::vector<calc::LightScene> scenes{{"s", {{"a", 1.0}, {"b", 1.0}}, {}}};
    return judge_plane({required(metric, comparison, 1.0)}, row_of(2), field, scenes, 0.95)
        .front()
        .measured;
  };
  for (const Metric metric : {Metric::average, Metric::minimum}) {
    const auto its = measured(metric, Comparison::at_least);
    const double half_width = its.high - its.value;
    ASSERT_GT(half_width, 0.2);
    EXPECT_TRUE(can_be_met(metric, Comparison::at_least, its.value + 0.99 * half_width))
        << calc::name_of(metric);
    EXPECT_FALSE(can_be_met(metric, Comparison::at_least, its.value + 3 * half_width))
        << calc::name_of(metric);
  }
  for (const Metric metric : {Metric::average, Metric::maximum}) {
    const auto its = measured(metric, Comparison::at_most);
    const double half_width = its.value - its.low;
    ASSERT_GT(half_width, 0.2);
    EXPECT_TRUE(can_be_met(metric, Comparison::at_most, its.value - 0.99 * half_width))
        << calc::name_of(metric);
    EXPECT_FALSE(can_be_met(metric, Comparison::at_most, its.value - 3 * half_width))
        << calc::name_of(metric);
  }
  // Of shares of the greatest both ends count.
  const auto share = measured(Metric::uniformity_min_max, Comparison::at_least);
  const double half_width = share.high - share.value;
  EXPECT_TRUE(
      can_be_met(Metric::uniformity_min_max, Comparison::at_least, share.value + 0.9 * half_width));
  EXPECT_FALSE(
      can_be_met(Metric::uniformity_min_max, Comparison::at_least, share.value + 4 * half_width));
}

TEST(LevelConditions, DarknessMeetsALimitOfNothing) {
  const calc::PlaneField field = exact_field({300, 200}, {100, 50});
  for (const double limit : {0.0, 1e-12, 1e-9}) {
    for (const Metric metric : {Metric::average, Metric::maximum}) {
      const LevelConditions conditions(required(metric, Comparison::at_most, limit), row_of(2),
                                       field, kGroups, 0.95);
      EXPECT_TRUE(is_met(conditions, {0.0, 0.0})) << limit;
      EXPECT_FALSE(is_met(conditions, {0.0, 0.01})) << limit;
    }
  }
}

TEST(LevelConditions, SayWhatTheyAreNotFor) {
  const calc::PlaneField field = exact_field({300, 200}, {0, 10});
  const auto problem = [&](const Requirement& requirement) {
    return LevelConditions(requirement, row_of(2), field, kGroups, 0.95).problem();
  };
  EXPECT_NE(problem(required(Metric::minimum, Comparison::at_most, 3)), "");
  EXPECT_NE(problem(required(Metric::maximum, Comparison::at_least, 3)), "");
  EXPECT_NE(problem(required(Metric::uniformity_min_avg, Comparison::at_most, 0.3)), "");
  EXPECT_NE(problem(required(Metric::percentile, Comparison::at_least, 3)), "");
  EXPECT_NE(problem(required(Metric::gradient, Comparison::at_most, 3)), "");
  Requirement out = required(Metric::average, Comparison::at_least, 3);
  out.any_one_unit_out = true;
  EXPECT_NE(problem(out), "");
  out.any_one_unit_out = false;
  out.problem = calc::Message::words("no such thing");
  EXPECT_EQ(problem(out), "no such thing");
}

}  // namespace
}  // namespace rules::level_conditions_test
