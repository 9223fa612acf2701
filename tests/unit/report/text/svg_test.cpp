#include "report/text/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace report::svg_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RoundTicks, AreMultiplesOfRoundSteps) {
  EXPECT_THAT(round_ticks(417.8, 657.5, 8), ElementsAre(450, 500, 550, 600, 650));
  EXPECT_THAT(round_ticks(-10.2, 10.2, 7), ElementsAre(-10, -5, 0, 5, 10));
  EXPECT_THAT(round_ticks(0.0, 0.31, 4), ElementsAre(0.0, 0.1, 0.2, 0.3));
  EXPECT_THAT(round_ticks(-3e-7, 3e-7, 3), ElementsAre(-2e-7, 0.0, 2e-7));
  EXPECT_THAT(round_ticks(1e5, 9e5, 9), ElementsAre(1e5, 2e5, 3e5, 4e5, 5e5, 6e5, 7e5, 8e5, 9e5));
}

TEST(RoundTicks, AreNeverMoreThanWanted) {
  for (double high = 1.0; high < 1e6; high *= 1.37) {
    for (int most = 2; most < 12; ++most) {
      const std::vector<double> ticks = round_ticks(-0.3 * high, high, most);
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(most));
      EXPECT_GE(ticks.size(), static_cast<std::size_t>(most) / 3);
      for (const double tick : ticks) EXPECT_FALSE(tick == 0.0 && std::signbit(tick));
    }
  }
}

TEST(RoundTicks, NeedARange) {
  EXPECT_THAT(round_ticks(1.0, 1.0, 5), IsEmpty());
  EXPECT_THAT(round_ticks(2.0, 1.0, 5), IsEmpty());
  EXPECT_THAT(round_ticks(0.0, std::numeric_limits<double>::infinity(), 5), IsEmpty());
}

}  // namespace
}  // namespace report::svg_test
