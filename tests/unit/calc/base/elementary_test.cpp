#include "calc/base/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace elementary_test {
namespace {

// In units of the last place of the expected value.
double off_by(double value, double expected) {
  if (value == expected) return 0.0;
  const double unit = std::nextafter(std::abs(expected), INFINITY) - std::abs(expected);
  return std::abs(value - expected) / unit;
}

// The C library is right within one unit; what calc::elementary.h promises comes on top of that.
TEST(Elementary, IsAsNearToTheCLibraryAsItSays) {
  double trigonometric = 0.0, others = 0.0;
  for (int k = -20000; k <= 20000; ++k) {
    const double x = 0.0031 * k, share = k / 20000.0, positive = std::exp2(0.0007 * k);
    for (const double off :
         {off_by(calc::sin(x), std::sin(x)), off_by(calc::cos(x), std::cos(x)),
          off_by(calc::tan(x), std::tan(x)), off_by(calc::asin(share), std::asin(share)),
          off_by(calc::acos(share), std::acos(share)), off_by(calc::atan(x), std::atan(x)),
          off_by(calc::atan2(x, share), std::atan2(x, share)),
          off_by(calc::atan2(share, -x), std::atan2(share, -x))}) {
      trigonometric = std::max(trigonometric, off);
    }
    for (const double off : {off_by(calc::exp(x), std::exp(x)), off_by(calc::exp2(x), std::exp2(x)),
                             off_by(calc::log(positive), std::log(positive)),
                             off_by(calc::log1p(positive), std::log1p(positive)),
                             off_by(calc::log2(positive), std::log2(positive)),
                             off_by(calc::log10(positive), std::log10(positive)),
                             off_by(calc::pow(positive, x), std::pow(positive, x))}) {
      others = std::max(others, off);
    }
  }
  EXPECT_LE(trigonometric, 4.5);
  EXPECT_LE(others, 2.0);
}

TEST(Elementary, TwoAnglesAtOnceAreThoseOneByOne) {
  for (int k = -2000; k <= 2000; ++k) {
    const double y = 0.0031 * k, x = 0.7 - 0.0007 * k;
    const std::array<double, 2> both = calc::atan2({y, x}, {x, -y});
    EXPECT_EQ(both[0], calc::atan2(y, x));
    EXPECT_EQ(both[1], calc::atan2(x, -y));
  }
}

TEST(Elementary, PowersOfTenAreExact) {
  double power = 1.0;
  for (int k = 0; k <= 22; ++k, power *= 10.0) {
    EXPECT_EQ(calc::pow(10.0, k), power) << k;
    EXPECT_EQ(calc::log10(power), k);
  }
  for (int k = -300; k <= 300; ++k) EXPECT_EQ(calc::log10(std::pow(10.0, k)), k);
}

TEST(Elementary, SpecialValuesAreThoseOfTheCLibrary) {
  const double pi = 3.141592653589793, infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(calc::sin(0.0), 0.0);
  EXPECT_EQ(calc::cos(0.0), 1.0);
  EXPECT_EQ(calc::cos(pi), -1.0);
  EXPECT_EQ(calc::acos(1.0), 0.0);
  EXPECT_EQ(calc::acos(-1.0), pi);
  EXPECT_EQ(calc::asin(1.0), pi / 2);
  EXPECT_EQ(calc::atan2(0.0, -1.0), pi);
  EXPECT_EQ(calc::atan2(-0.0, -1.0), -pi);
  EXPECT_EQ(calc::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(calc::atan2(1.0, 0.0), pi / 2);
  EXPECT_TRUE(std::isnan(calc::acos(1.1)));
  EXPECT_EQ(calc::log(0.0), -infinity);
  EXPECT_EQ(calc::exp(-infinity), 0.0);
  EXPECT_EQ(calc::exp(1000.0), infinity);
  EXPECT_EQ(calc::pow(0.0, 2.0), 0.0);
  EXPECT_EQ(calc::pow(-2.0, 3.0), -8.0);
  EXPECT_EQ(calc::hypot(3.0, -4.0), 5.0);
  EXPECT_EQ(calc::cos(0.0f), 1.0f);
  EXPECT_EQ(calc::acos(1.0f), 0.0f);
}

}  // namespace
}  // namespace elementary_test
