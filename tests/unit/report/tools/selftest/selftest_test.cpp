#include "report/tools/selftest/closed_forms.h"
#include "report/tools/selftest/judge.h"

#include "calc/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace selftest_test {
namespace {

using namespace cli::selftest;

// Printed digits of the literature.
TEST(ClosedForms, GiveThePrintedNumbers) {
  EXPECT_NEAR(opposite_rectangles(1, 1, 1), 0.199824895698387, 1e-14);
  EXPECT_NEAR(opposite_rectangles(1, 1, 10), 0.00316205683876, 1e-12);
  EXPECT_NEAR(rectangles_with_edge(1, 1, 1), 0.200043776075403, 1e-14);
  EXPECT_NEAR(3000.0 * calc::kPi *
                  rectangle_factor({0, 0, 0}, {0, 0, 1}, {0, 0, 2.05}, {0, 1.2, 0}, {0.6, 0, 0}),
              403.152371146, 1e-8);
  EXPECT_NEAR(
      3000.0 * calc::kPi *
          rectangle_factor({1, 2, 0.5}, {-0.6, 0, 0.8}, {0, 0, 2.05}, {0, 1.2, 0}, {0.6, 0, 0}),
      248.939053673, 1e-8);
  EXPECT_NEAR(5000.0 * calc::kPi * disc_factor_parallel(0.5, 2, 0.5), 829.166902934, 1e-8);
  EXPECT_NEAR(5000.0 * calc::kPi * disc_factor_perpendicular(0.5, 1, 1), 913.517112972, 1e-8);
  EXPECT_NEAR(8000.0 * calc::kPi * sphere_factor(0.2, 1.0, 0.5 * calc::kPi), 43.1899309414, 1e-8);
  EXPECT_EQ(sphere_factor(0.2, 1.0, 2.0), 0.0);
}

Measured number(double exact, std::vector<double> replicates) {
  Measured m;
  m.exact = exact;
  m.replicates = std::move(replicates);
  m.widest = 0.05;
  return m;
}

TEST(Judge, HoldsExactNumbersToRounding) {
  EXPECT_EQ(judge(number(100.0, {100.00009})).verdict, Verdict::right);
  EXPECT_EQ(judge(number(100.0, {100.0002})).verdict, Verdict::wrong);
  EXPECT_EQ(judge(number(0.0, {1e-12})).verdict, Verdict::wrong);
  EXPECT_EQ(judge(number(0.0, {std::nan("")})).verdict, Verdict::wrong);
}

TEST(Judge, NeitherWrongNorVagueIntervalsPass) {
  std::vector<double> narrow, wide;
  for (int r = 0; r < kReplicates; ++r) {
    narrow.push_back(100.0 + (r % 2 == 0 ? 0.1 : -0.1));
    wide.push_back(100.0 + (r % 2 == 0 ? 20.0 : -20.0));
  }
  EXPECT_EQ(judge(number(100.1, narrow)).verdict, Verdict::right);
  EXPECT_EQ(judge(number(101.0, narrow)).verdict, Verdict::wrong);
  EXPECT_EQ(judge(number(100.1, wide)).verdict, Verdict::too_vague);
}

// By turns above and below 100, so that the mean and the spread are known.
std::vector<double> around_100(double spread) {
  std::vector<double> values;
  for (int r = 0; r < kReplicates; ++r) values.push_back(100.0 + (r % 2 == 0 ? spread : -spread));
  return values;
}

TEST(Judge, OneUnluckyWidthIsNotTooVagueManyAre) {
  const Measured lucky = number(100.0, around_100(5.0)), unlucky = number(100.0, around_100(12.0));
  EXPECT_EQ(judge(unlucky).verdict, Verdict::right) << "6.6 % where 5 % are wanted";
  EXPECT_EQ(judge({unlucky, lucky, lucky}).verdict, Verdict::right);
  EXPECT_EQ(judge({unlucky, unlucky, lucky}).verdict, Verdict::too_vague) << "the middle one";
}

TEST(Judge, NothingBesideLightIsKnownAsWellAsAShareOfTheLight) {
  std::vector<double> once(kReplicates, 0.0);
  once[3] = 0.001;
  Measured dark = number(0.0, once);
  EXPECT_EQ(judge(dark).verdict, Verdict::too_vague);
  dark.scale = 0.2;
  EXPECT_EQ(judge(dark).verdict, Verdict::right);
  dark.scale = 0.001;
  EXPECT_EQ(judge(dark).verdict, Verdict::too_vague);
}

TEST(Judge, SeedsTogetherSeeABiasThatNoneSees) {
  const Measured biased = number(100.7, around_100(1.0));
  EXPECT_EQ(judge(biased).verdict, Verdict::right) << "0.53 at 95 %, but far more at the level";
  const JudgedNumber many = judge(std::vector<Measured>(100, biased));
  EXPECT_EQ(many.verdict, Verdict::wrong);
  EXPECT_EQ(many.seeds, 100);
  EXPECT_EQ(many.held, 0);
  EXPECT_EQ(judge(std::vector<Measured>(100, number(100.2, around_100(1.0)))).held, 100);
}

TEST(Judge, ResultsOfSeedsMustBeOfTheSameNumbers) {
  CaseResult one, two;
  one.measured = {number(100.0, around_100(1.0))};
  two.measured = {one.measured[0], one.measured[0]};
  EXPECT_EQ(judge(SelftestCase{}, std::vector<CaseResult>{one, one}).verdict, Verdict::right);
  EXPECT_EQ(judge(SelftestCase{}, std::vector<CaseResult>{one, two}).verdict, Verdict::wrong);
  two = one;
  two.problem = "not computed";
  EXPECT_EQ(judge(SelftestCase{}, std::vector<CaseResult>{one, two}).verdict, Verdict::wrong);
}

TEST(Judge, RoundingDoesNotChooseTheWorst) {
  JudgedCase judged;
  for (const double value : {100.0, 100.0 * (1.0 + 1e-15), 100.0 * (1.0 + 3e-12)}) {
    judged.numbers.push_back(judge(number(100.0, {value})));
  }
  EXPECT_EQ(judged.worst(), &judged.numbers[0]);
  judged.numbers.push_back(judge(number(100.0, {100.0 * (1.0 + 1e-11)})));
  EXPECT_EQ(judged.worst(), &judged.numbers[3]);
}

TEST(Judge, WhatIsNotRefusedIsWrong) {
  CaseResult result;
  result.refused.push_back({"a room", "no steady state", ""});
  EXPECT_EQ(judge(SelftestCase{}, result).verdict, Verdict::wrong);
  result.refused[0].said = "there is no steady state";
  EXPECT_EQ(judge(SelftestCase{}, result).verdict, Verdict::refused);
  EXPECT_EQ(judge(SelftestCase{}, CaseResult{}).verdict, Verdict::wrong);
}

TEST(SelftestCases, HaveNamesOfTheirOwnAndKnownKinds) {
  std::set<std::string> names, known;
  for (const Kind& kind : kinds()) known.insert(kind.name);
  for (const SelftestCase& item : all_cases()) {
    EXPECT_TRUE(names.insert(item.name).second) << item.name;
    EXPECT_FALSE(known.contains(item.name)) << item.name;
    EXPECT_TRUE(known.contains(item.kind)) << item.name;
    EXPECT_FALSE(item.title.empty() || item.source.empty()) << item.name;
  }
}

}  // namespace
}  // namespace selftest_test
