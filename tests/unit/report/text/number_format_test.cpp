#include "report/text/number_format.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <locale>
#include <string>

namespace report::number_format_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

calc::Estimate plus_minus(double value, double half) { return {value, value - half, value + half}; }
Threshold at_least(double limit) { return {limit, rules::Comparison::at_least}; }
Threshold at_most(double limit) { return {limit, rules::Comparison::at_most}; }

TEST(NumberFormat, DigitsFollowTheInterval) {
  EXPECT_EQ(format_measured(plus_minus(512.345, 4.1), "lx"), "512 ± 5 lx");
  EXPECT_EQ(format_measured(plus_minus(512.345, 41), "lx"), "512 ± 42 lx");
  EXPECT_EQ(format_measured(plus_minus(51.2345, 0.412), "lx"), "51.2 ± 0.5 lx");
  EXPECT_EQ(format_measured(plus_minus(5123.4, 410), "lx"), "5123 ± 411 lx");
}

// Data have units in ASCII.
TEST(NumberFormat, UnitsAreAsPeopleWriteThem) {
  EXPECT_EQ(format_measured(plus_minus(0.7512, 0), "cd/m2"), "0.751 cd/m²");
  EXPECT_EQ(format_required(at_most(7.5), "kWh/m2/a"), "≤ 7.5 kWh/m²/a");
}

// What is shown holds all of the interval, whatever its digits.
TEST(NumberFormat, AShownIntervalIsNeverNarrowerThanTheTrueOne) {
  for (int k = 1; k < 4000; ++k) {
    const double value = 0.37 * k, below = 0.0131 * (k % 97 + 1), above = 0.0173 * (k % 89 + 1);
    const calc::Estimate estimate{value, value - below, value + above};
    const std::string text = format_measured(estimate, "lx");
    double shown = 0, low = 0, high = 0;
    if (std::sscanf(text.c_str(), "%lf (%lf to %lf)", &shown, &low, &high) != 3) {
      double width = 0;
      ASSERT_EQ(std::sscanf(text.c_str(), "%lf ± %lf", &shown, &width), 2) << text;
      low = shown - width;
      high = shown + width;
    }
    constexpr double kNoise = 1e-9;
    EXPECT_LE(low, estimate.low + kNoise) << text;
    EXPECT_GE(high, estimate.high - kNoise) << text;
  }
}

TEST(NumberFormat, RoundedUpHalfWidthLosesADigit) {
  EXPECT_EQ(format_measured(plus_minus(512.345, 9.96), "lx"), "512 ± 11 lx");
}

TEST(NumberFormat, TinyHalfWidthIsNotShownAsZero) {
  EXPECT_EQ(format_measured(plus_minus(512.345, 0.0004), "lx"), "512 ± 1 lx");
  EXPECT_EQ(format_measured(plus_minus(0.612, 0.00002), ""), "0.61 ± 0.01");
}

TEST(NumberFormat, ExactValuesHaveNoHalfWidth) {
  EXPECT_EQ(format_measured(plus_minus(512.345, 0), "lx"), "512 lx");
  EXPECT_EQ(format_measured(plus_minus(0, 0), "lx"), "0.0 lx");
  EXPECT_EQ(format_interval(plus_minus(5, 0), "lx"), "exact");
}

TEST(NumberFormat, RatiosHaveTwoDecimals) {
  EXPECT_EQ(format_measured(plus_minus(0.61234, 0), ""), "0.61");
  EXPECT_EQ(format_measured(plus_minus(0.025123, 0), ""), "0.025");
  EXPECT_EQ(format_measured(plus_minus(0.61234, 0.0041), ""), "0.61 ± 0.01");
  // A UGR is no ratio.
  EXPECT_EQ(format_measured(plus_minus(24.302, 0), ""), "24.3");
  EXPECT_EQ(format_measured(plus_minus(24.302, 0.012), ""), "24.3 ± 0.1");
  EXPECT_EQ(format_measured(plus_minus(24.302, 0), "", at_most(24.3)), "24.302");
}

// "21.4 ± 0.7" would say that 22 may be passed, and the interval ends before.
TEST(NumberFormat, ALopsidedIntervalIsShownByItsEnds) {
  EXPECT_EQ(format_measured({21.35, 20.67, 21.95}, "", Threshold{22, rules::Comparison::at_most}),
            "21.4 (20.6 to 22.0)");
  EXPECT_EQ(format_measured({100.0, 95.0, 101.0}, "lx"), "100 (95 to 101) lx");
  EXPECT_EQ(format_measured({100.0, 95.0, 101.0}, "lx", {}, "bis"), "100 (95 bis 101) lx");
  EXPECT_EQ(format_measured({0.5, 0.5, 0.6}, ""), "0.50 (0.50 to 0.60)");
  // Both ends stay on their side of the limit, as all digits do.
  EXPECT_EQ(format_measured({505.0, 499.96, 520.0}, "lx", at_least(500)), "505 (499 to 520) lx");
  // Not seen in these digits.
  EXPECT_EQ(format_measured({512.3, 508.2004, 516.4}, "lx"), "512 ± 5 lx");
  EXPECT_EQ(format_interval({100.0, 95.0, 101.0}, "lx"), "95 – 101 lx");
}

TEST(NumberFormat, ShownValueStaysOnItsSideOfTheLimit) {
  EXPECT_EQ(format_measured(plus_minus(499.6, 0), "lx", at_least(500)), "499.6 lx");
  EXPECT_EQ(format_measured(plus_minus(499.96, 0), "lx", at_least(500)), "499.96 lx");
  EXPECT_EQ(format_measured(plus_minus(499.6, 40), "lx", at_least(500)), "499.6 ± 40.0 lx");
  EXPECT_EQ(format_measured(plus_minus(0.5996, 0), "", at_least(0.6)), "0.5996");
  EXPECT_EQ(format_measured(plus_minus(500.004, 0), "lx", at_most(500)), "500.004 lx");
}

TEST(NumberFormat, ValueOnTheLimitNeedsNoMoreDigits) {
  EXPECT_EQ(format_measured(plus_minus(500, 0), "lx", at_least(500)), "500 lx");
  EXPECT_EQ(format_measured(plus_minus(500.04, 0), "lx", at_least(500)), "500 lx");
}

TEST(NumberFormat, ShownIntervalStaysOnItsSideOfTheLimit) {
  // 500.44 - 0.443 < 500: "500.44 ± 0.44" would read as met.
  EXPECT_EQ(format_measured(plus_minus(500.44, 0.443), "lx", at_least(500)), "500 ± 1 lx");
}

TEST(NumberFormat, MissesBelowNineDecimalsAreStillShown) {
  const double value = 0.6 * (1 - 1e-8);
  const EstimateText text = format_estimate(plus_minus(value, 0), "", at_least(0.6));
  EXPECT_LT(std::stod(text.value), 0.6);
}

TEST(NumberFormat, NotANumberIsADash) {
  EXPECT_EQ(format_fixed(kNan, 2), "–");
  EXPECT_EQ(format_measured({kNan, kNan, kNan}, "lx"), "–");
  EXPECT_EQ(format_measured({5.0, -kInfinity, kInfinity}, "lx"), "5.00 ± – lx");
  EXPECT_EQ(format_interval({5.0, kNan, kNan}, "lx"), "–");
  EXPECT_EQ(format_margin(kInfinity), "–");
  EXPECT_EQ(format_cell(kNan), "–");
  EXPECT_EQ(format_shortest(kNan), "");
  EXPECT_EQ(format_shortest(-kInfinity), "");
}

TEST(NumberFormat, ZeroHasNoMinus) {
  EXPECT_EQ(format_fixed(-0.0004, 2), "0.00");
  EXPECT_EQ(format_shortest(-0.0), "0");
}

TEST(NumberFormat, ShortestReadsBackTheSame) {
  for (const double value : {0.1, 1.0 / 3.0, 512.3456789012345, 1e-300, 123456789.0}) {
    EXPECT_EQ(std::stod(format_shortest(value)), value);
  }
  EXPECT_EQ(format_shortest(500.0), "500");
}

TEST(NumberFormat, LimitsKeepTheirDigits) {
  EXPECT_EQ(format_required(at_least(500), "lx"), "≥ 500 lx");
  EXPECT_EQ(format_required(at_most(0.6), ""), "≤ 0.60");
  EXPECT_EQ(format_required(at_least(0.125), ""), "≥ 0.125");
  EXPECT_EQ(format_required(at_least(1), ""), "≥ 1.00");
}

TEST(NumberFormat, LevelsAreWithoutBinaryDust) {
  EXPECT_EQ(format_level(3 * 0.1), "0.3");
  EXPECT_EQ(format_level(69 * 0.005), "0.345");
  EXPECT_EQ(format_level(300), "300");
}

TEST(NumberFormat, LimitsInFootCandlesAndUnknownOnes) {
  EXPECT_EQ(format_limit(10.763910416709722, "lx"), "10.7639104 lx");
  EXPECT_EQ(format_limit(6.5659853541929305, "W/m2"), "6.56598535 W/m²");  // 0.61 W/ft2
  EXPECT_EQ(format_required(at_most(19), ""), "≤ 19");                     // a rating, no ratio
  EXPECT_EQ(format_required({kNan, rules::Comparison::at_least}, "lx"), "unknown limit");
}

TEST(NumberFormat, MarginIsNeverRoundedToZero) {
  EXPECT_EQ(format_margin(0.0246), "+2.5 %");
  EXPECT_EQ(format_margin(-0.0008), "-0.1 %");
  EXPECT_EQ(format_margin(-0.000012), "-0.001 %");
  EXPECT_EQ(format_margin(0.0), "+0.0 %");
}

// Of a limit of 19, 0.281 of it are 5.3.
TEST(NumberFormat, MarginsOfRatingsAreDifferences) {
  EXPECT_EQ(format_rating_margin(-0.281, 19.0, "UGR"), "-5.3 UGR");
  EXPECT_EQ(format_rating_margin(0.1, 50.0, "GR"), "+5.0 GR");
  EXPECT_EQ(format_rating_margin(-0.001, 19.0, "UGR"), "-0.02 UGR");
  EXPECT_EQ(format_rating_margin(kInfinity, 19.0, "UGR"), "–");
}

TEST(NumberFormat, CellsAreShortAndOnTheirSideOfTheLimit) {
  EXPECT_EQ(format_cell(1240.4), "1240");
  EXPECT_EQ(format_cell(51.24), "51.2");
  EXPECT_EQ(format_cell(0.01234), "0.012");
  EXPECT_EQ(format_cell(0.0), "0.0");
  EXPECT_EQ(format_cell(499.7, at_least(500)), "499.7");
  EXPECT_EQ(format_cell(499.2, at_least(500)), "499");
}

// As it is printed, not as 100 times it would round.
TEST(NumberFormat, AFewDigitsReadAlikeOnTheSideOfTheLimit) {
  EXPECT_EQ(format_fixed(0.595, 2), "0.59");
  EXPECT_TRUE(reads_alike(0.595, 2, at_least(0.6)));
  EXPECT_FALSE(reads_alike(0.596, 2, at_least(0.6)));
  EXPECT_TRUE(reads_alike(0.604, 2, at_least(0.6)));
  EXPECT_FALSE(reads_alike(0.604, 2, at_most(0.6)));
}

TEST(NumberFormat, DigitsRespectSeveralLimits) {
  const Thresholds both(at_least(500), at_most(600));
  EXPECT_EQ(format_cell(499.96, both), "499.96");
  EXPECT_EQ(format_cell(600.04, both), "600.04");
  EXPECT_EQ(format_cell(550.04, both), "550");
  EXPECT_EQ(format_measured({600.04, 590.04, 610.04}, "lx", both), "600.04 ± 10.00 lx");
  EXPECT_EQ(format_interval({510, 499.96, 520.04}, "lx", both), "499 – 521 lx");
}

TEST(NumberFormat, OpenIntervalsAreNoExactOnes) {
  const double open = std::numeric_limits<double>::infinity();
  EXPECT_EQ(format_measured({512, 500, open}, "lx"), "≥ 500 lx");
  EXPECT_EQ(format_measured({512, -open, 520}, "lx"), "≤ 520 lx");
  EXPECT_EQ(format_measured({512, kNan, 520}, "lx"), "≤ 520 lx");
  EXPECT_EQ(format_measured({512, 500, kNan}, "lx"), "≥ 500 lx");
  EXPECT_EQ(format_measured({512, -open, open}, "lx"), "512 ± – lx");
}

// The end that is shown stays on its side of the limit.
TEST(NumberFormat, WhatIsNothingIsNone) {
  const double open = std::numeric_limits<double>::infinity();
  EXPECT_EQ(format_measured({-open, -open, -open}, ""), "none");
  EXPECT_EQ(format_measured({-open, -open, 18.99996}, "", {{19, rules::Comparison::less_than}}),
            "≤ 18.99996");
  EXPECT_EQ(format_margin(open), "–");
}

TEST(NumberFormat, LengthsCountsAndTimes) {
  EXPECT_EQ(format_metres(0.8), "0.80");
  EXPECT_EQ(format_metres(0.125), "0.125");
  EXPECT_EQ(format_position({1, -2.5, 0}), "(1.00, -2.50, 0.00)");
  EXPECT_EQ(format_count(4194304), "4\u202F194\u202F304");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_share(0.784), "78 %");
  EXPECT_EQ(format_percent(0.95), "95 %");
  EXPECT_EQ(format_percent(0.999), "99.9 %");
  EXPECT_EQ(format_percent(0.07), "7 %");
  EXPECT_EQ(format_lumens(4200.4), "4200");
  EXPECT_EQ(format_seconds(12.34), "12.3");
}

// A locale that writes 1.512,3; made here, since the machine may have none installed.
struct CommaPoint : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(NumberFormat, LocaleDoesNotMatter) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
  EXPECT_EQ(format_measured(plus_minus(1512.345, 4.1), "lx"), "1512 ± 5 lx");
  EXPECT_EQ(format_shortest(1512.345), "1512.345");
  std::locale::global(before);
}

TEST(NumberFormat, UgrBelowItsScaleHasNoNumber) {
  const auto at_most = [](double limit) { return Threshold{limit, rules::Comparison::at_most}; };
  EXPECT_EQ(format_ugr({-20.28, -20.28, -20.28}, at_most(19)), "< 10");
  EXPECT_EQ(format_ugr({9.5, 9.0, 9.9}, at_most(10)), "< 10");
  EXPECT_EQ(format_ugr({9.5, 9.0, 10.5}, at_most(19)),
            format_measured({9.5, 9.0, 10.5}, "", at_most(19)));
  EXPECT_EQ(format_ugr({9.5, 9.0, 9.9}, at_most(9.2)),
            format_measured({9.5, 9.0, 9.9}, "", at_most(9.2)))
      << "it fails, and must be seen to";
  EXPECT_EQ(format_ugr({16.4, 16.4, 16.4}, at_most(19)), "16.4");
  EXPECT_FALSE(is_below_ugr_scale({9.0, 9.0, 9.0}, at_least(16))) << "it fails by so much";
}

}  // namespace
}  // namespace report::number_format_test
