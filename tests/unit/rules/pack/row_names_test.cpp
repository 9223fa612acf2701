#include "rules/pack/row_names.h"

#include <gtest/gtest.h>

namespace rules {
namespace {

TEST(RowNames, AreThoseOfThePacks) {
  const RowName* name = builtin_row_name("en12464-1:2021", "34.2");
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->title, "EN 12464-1:2021");
  EXPECT_EQ(name->name, "office desk work");
  EXPECT_EQ(name->name_de, "Schreibtischarbeit");
  const RowName* german_rule = builtin_row_name("asr-a3-4:undated", "tills");
  ASSERT_NE(german_rule, nullptr);
  EXPECT_EQ(german_rule->name_de, "Kassen");
  EXPECT_EQ(builtin_row_name("en12464-1:2021", "99.9"), nullptr);
  EXPECT_EQ(builtin_row_name("en12464-1", "34.2"), nullptr) << "editions number rows differently";
}

}  // namespace
}  // namespace rules
