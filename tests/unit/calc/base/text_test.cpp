#include "calc/base/text.h"

#include <gtest/gtest.h>

namespace calc::text_test {
namespace {

TEST(Text, ListsNameAFewAndCountTheRest) {
  EXPECT_EQ(list_names({}, 3), "");
  EXPECT_EQ(list_names({"a"}, 3), "a");
  EXPECT_EQ(list_names({"a", "b", "c"}, 3), "a, b, c");
  EXPECT_EQ(list_names({"a", "b", "c", "d"}, 3), "a, b, c and 1 more");
  EXPECT_EQ(and_more(12, "rooms"), "and 12 more rooms");
}

}  // namespace
TEST(Suggestion, IsTheClosestNameWithinAThirdOfItsLength) {
  EXPECT_EQ(suggestion("reflectanse", {"reflectance", "position"}),
            "; did you mean 'reflectance'?");
  EXPECT_EQ(suggestion("roon", {"plane", "room", "rooms"}), "; did you mean 'room'?");
  EXPECT_EQ(suggestion("x", {"", "position"}), "");
  EXPECT_EQ(suggestion("posxyzon", {"position"}), "");
  // One that is too far from itself hides no other that is not.
  EXPECT_EQ(suggestion("maintenanze-factr", {"ma", "maintenance-factor"}),
            "; did you mean 'maintenance-factor'?");
  EXPECT_EQ(suggestion(std::string(1000, 'a'), {"a", "aaaa"}), "");
}

}  // namespace calc::text_test
