#include "rules/binding/requirement_attributes.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace rules::requirement_attributes_test {
namespace {

TEST(RequirementAttributes, WorkplaceHasItsOwnAndThoseOfRules) {
  EXPECT_EQ(calc::attribute_names(workplace_element()),
            (calc::Names{"id",        "name",   "was",           "tags",       "origin", "size",
                         "footprint", "height", "wall",          "along",      "face",   "heights",
                         "lean",      "glare",  "front-wall",    "task-place", "scene",  "pack",
                         "row",       "level",  "level-because", "facts"}));
}

TEST(RequirementAttributes, NoNameTwiceAndEachWithAMeaning) {
  std::set<std::string_view> names;
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    EXPECT_TRUE(names.insert(attribute.name).second) << attribute.name;
    EXPECT_FALSE(attribute.meaning.empty()) << attribute.name;
    EXPECT_EQ(attribute.type->words.empty(), attribute.kind != AttributeKind::words)
        << attribute.name;
    EXPECT_EQ(attribute.type->range.has_value(), attribute.kind == AttributeKind::number)
        << attribute.name;
  }
}

}  // namespace
}  // namespace rules::requirement_attributes_test
