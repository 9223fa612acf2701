#include "calc/base/text.h"

#include <gtest/gtest.h>

namespace calc {
namespace {

TEST(Text, ListsNameAFewAndCountTheRest) {
  EXPECT_EQ(list_names({}, 3), "");
  EXPECT_EQ(list_names({"a"}, 3), "a");
  EXPECT_EQ(list_names({"a", "b", "c"}, 3), "a, b, c");
  EXPECT_EQ(list_names({"a", "b", "c", "d"}, 3), "a, b, c and 1 more");
  EXPECT_EQ(and_more(12, "rooms"), "and 12 more rooms");
}

}  // namespace
}  // namespace calc
