#include "calc/base/names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace calc::names_test {
namespace {

enum class Tide { low, high, unnamed };

}  // namespace
}  // namespace calc::names_test

template <>
struct calc::EnumNames<calc::names_test::Tide> {
  using Tide = calc::names_test::Tide;
  static constexpr calc::EnumName<Tide> list[] = {{Tide::high, "high-tide"},
                                                  {Tide::low, "low-tide"}};
};

namespace calc::names_test {
namespace {

TEST(Names, OfAValueAndBack) {
  static_assert(name_of(Tide::low) == "low-tide");
  static_assert(find_value<Tide>("high-tide") == Tide::high);
  EXPECT_EQ(name_of(*find_value<Tide>("low-tide")), "low-tide");
}

TEST(Names, AreSpelledExactly) {
  EXPECT_FALSE(find_value<Tide>("High-tide"));
  EXPECT_FALSE(find_value<Tide>("high-tid"));
  EXPECT_FALSE(find_value<Tide>(""));
}

TEST(Names, ValuesOutsideTheListHaveNone) { EXPECT_EQ(name_of(Tide::unnamed), ""); }

TEST(Names, ComeInTheOrderOfTheList) {
  EXPECT_THAT(names_of<Tide>(), testing::ElementsAre("high-tide", "low-tide"));
}

}  // namespace
}  // namespace calc::names_test
