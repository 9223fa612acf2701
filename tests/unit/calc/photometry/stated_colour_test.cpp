#include "calc/photometry/stated_colour.h"

#include <gtest/gtest.h>

#include <optional>

namespace calc::stated_colour_test {
namespace {

void expect_ra(const char* text, double low, double high) {
  const std::optional<StatedRa> ra = stated_ra(text);
  ASSERT_TRUE(ra) << text;
  EXPECT_EQ(ra->low, low) << text;
  EXPECT_EQ(ra->high, high) << text;
}

TEST(StatedRa, NumbersRangesAndGroups) {
  for (const char* text : {"80", " 80 ", "80.0", "Ra 80", "CRI 80", "cri=80", "Ra:80"}) {
    expect_ra(text, 80, 80);
  }
  expect_ra("82.5", 82.5, 82.5);
  for (const char* text : {">80", ">= 80", "Ra>80", "Ra ≥ 80", "CRI>=80"}) expect_ra(text, 80, 100);
  for (const char* text : {"80-89", "Ra80-89", "1B", "1b", "R1b", "Ra 1B"}) {
    expect_ra(text, 80, 89);
  }
  expect_ra("1A", 90, 100);
  expect_ra("2A", 70, 79);
  expect_ra("2B", 60, 69);
  expect_ra("3", 40, 59);
  expect_ra("4", 20, 39);
}

// A number that nobody can read for certain must make nothing pass.
TEST(StatedRa, AnythingElseIsNotStated) {
  for (const char* text : {"",
                           "0",
                           "1",
                           "2",
                           "5",
                           "8",
                           "101",
                           "180",
                           "830",
                           "8080",
                           "80%",
                           "80,5",
                           "80 +",
                           "<80",
                           "-80",
                           "80-",
                           "89-80",
                           "> 80-89",
                           "80/89",
                           "R80",
                           "R9",
                           "R 3",
                           "Ra 3",
                           "Rf 80",
                           "80.",
                           ".8",
                           "8O",
                           "= 80",
                           "80 Ra",
                           "1C",
                           "1BB",
                           "unknown",
                           "good",
                           "9 0",
                           "8 5",
                           "1 A",
                           "80 80 80 x",
                           "80\n90",
                           "Ra",
                           "nan",
                           "1e2",
                           "0x50",
                           "99999999999999999999"}) {
    EXPECT_FALSE(stated_ra(text)) << text;
  }
}

TEST(StatedColourTemperature, KelvinAloneOrWithItsUnit) {
  for (const char* text : {"4000", "4000K", "4000 K", " 4000 k"}) {
    EXPECT_EQ(stated_colour_temperature_k(text).value_or(0.0), 4000.0) << text;
  }
  for (const char* text :
       {"", "0", "840", "Unknown", "4000 F", "3000-4000", "warm 3000", "30000"}) {
    EXPECT_FALSE(stated_colour_temperature_k(text)) << text;
  }
}

}  // namespace
}  // namespace calc::stated_colour_test
