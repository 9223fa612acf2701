#include "calc/base/day.h"

#include <gtest/gtest.h>

namespace calc::day_test {
namespace {

TEST(Day, IsOneOfTheCalendar) {
  for (const char* day : {"2027-06-30", "2028-02-29", "2000-02-29", "0001-01-01", "9999-12-31"}) {
    EXPECT_TRUE(is_day(day)) << day;
  }
  for (const char* text : {"2027-02-29", "1900-02-29", "2027-13-01", "2027-00-10", "2027-04-31",
                           "2027-04-00", "0000-01-01", "2027-1-1", "2027-01-1x", "2027/01/01",
                           " 2027-01-01", "-027-01-01", "soon", ""}) {
    EXPECT_FALSE(is_day(text)) << text;
  }
}

TEST(Day, DaysBetween) {
  EXPECT_EQ(days_between("2026-12-31", "2026-12-31"), 0);
  EXPECT_EQ(days_between("2026-12-31", "2027-01-01"), 1);
  EXPECT_EQ(days_between("2028-02-28", "2028-03-01"), 2);
  EXPECT_EQ(days_between("2027-01-01", "2026-12-01"), -31);
}

}  // namespace
}  // namespace calc::day_test
