#include "rules/binding/requirement_attributes.h"

#include "calc/project/project_xml.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/builtin_packs.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace rules {
namespace {

using testing::HasSubstr;

std::string enumeration(const calc::Names& words) {
  std::string text;
  for (const std::string_view word : words) {
    text += fmt::format("      <xs:enumeration value=\"{}\"/>\n", word);
  }
  return text;
}

// A type of the schema's own for words and for ranges that no other element has.
std::string schema_type(const RequirementAttribute& attribute) {
  std::string base, contents;
  if (attribute.kind == AttributeKind::words) {
    base = "xs:string";
    contents = enumeration(attribute.words);
  } else if (attribute.kind == AttributeKind::date) {
    base = "xs:date";
    contents = "      <xs:pattern value=\"[0-9]{4}-[0-9]{2}-[0-9]{2}\"/>\n";
  } else if (attribute.kind == AttributeKind::number && attribute.schema_type != "nonNegative") {
    base = "decimal";
    contents = fmt::format(
        "      <xs:minInclusive value=\"{}\"/>\n      <xs:maxInclusive value=\"{}\"/>\n",
        attribute.range.low, attribute.range.high);
  }
  if (contents.empty()) return {};
  return fmt::format(
      "  <xs:simpleType name=\"{}\">\n    <xs:restriction base=\"{}\">\n{}    </xs:restriction>\n"
      "  </xs:simpleType>\n",
      attribute.schema_type, base, contents);
}

// What the schema says of <require>.
std::string schema_of_require() {
  std::string types, attributes;
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    types += schema_type(attribute);
    attributes += fmt::format(
        "    <xs:attribute name=\"{}\" type=\"{}\">\n"
        "      <xs:annotation><xs:documentation>{}</xs:documentation></xs:annotation>\n"
        "    </xs:attribute>\n",
        attribute.name, attribute.schema_type, attribute.meaning);
  }
  return types +
         "  <xs:complexType name=\"requirement\">\n"
         "    <xs:annotation><xs:documentation>What the plane must meet; see rules/README.md for "
         "the meaning of the attributes.</xs:documentation></xs:annotation>\n" +
         attributes + "  </xs:complexType>\n";
}

std::string_view type_in_schema(std::string_view name) {
  const std::string_view schema = calc::project_schema();
  const std::size_t begin = schema.find(fmt::format("<xs:complexType name=\"{}\">", name));
  EXPECT_NE(begin, std::string_view::npos) << name;
  return schema.substr(begin, schema.find("</xs:complexType>\n\n", begin) - begin);
}

TEST(RequirementAttributes, SchemaSaysWhatTheTableSays) {
  // After a change of the table this is what belongs between <!-- Calculation planes --> and the
  // type gridRounding of calc/project/luxgate-project-1.xsd.
  const std::string expected = schema_of_require();
  EXPECT_NE(calc::project_schema().find(expected), std::string_view::npos) << expected;
}

TEST(RequirementAttributes, WorkplaceHasTheSameTypes) {
  const std::string workplace(type_in_schema("workplace"));
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    if (!attribute.is_of_workplace) continue;
    EXPECT_THAT(workplace, HasSubstr(fmt::format("<xs:attribute name=\"{}\" type=\"{}\"",
                                                 attribute.name, attribute.schema_type)));
  }
  EXPECT_EQ(workplace_rule_names(), (calc::Names{"scene", "pack", "row", "level", "facts"}));
}

TEST(RequirementAttributes, NumbersOfTheSchemasOwnTypeAreNotNegative) {
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    if (attribute.schema_type != "nonNegative") continue;
    EXPECT_EQ(attribute.range.low, calc::kNonNegative.low) << attribute.name;
    EXPECT_EQ(attribute.range.high, calc::kNonNegative.high) << attribute.name;
    EXPECT_FALSE(attribute.range.is_open) << attribute.name;
  }
}

TEST(RequirementAttributes, NoNameTwiceAndEachWithAMeaning) {
  std::set<std::string_view> names;
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    EXPECT_TRUE(names.insert(attribute.name).second) << attribute.name;
    EXPECT_FALSE(attribute.meaning.empty()) << attribute.name;
    EXPECT_EQ(attribute.words.empty(), attribute.kind != AttributeKind::words) << attribute.name;
  }
}

// The words that a requirement and a check of a rule pack share.
TEST(RequirementAttributes, SchemaOfRulePacksHasTheSameStatisticsAndLight) {
  const std::string_view schema = rule_pack_schema();
  const auto words_of = [&](const std::string& attribute) {
    std::size_t at = schema.find("<xs:attribute name=\"" + attribute + "\"");
    EXPECT_NE(at, std::string_view::npos) << attribute;
    const std::size_t end = schema.find("</xs:attribute>", at);
    std::set<std::string_view> words;
    constexpr std::string_view kBefore = "enumeration value=\"";
    while ((at = schema.find(kBefore, at)) < end) {
      at += kBefore.size();
      words.insert(schema.substr(at, schema.find('"', at) - at));
    }
    return words;
  };
  const calc::Names statistics = metric_names();
  EXPECT_EQ(words_of("statistic"),
            std::set<std::string_view>(statistics.begin(), statistics.end()));
  const calc::Names& light = requirement_attribute("light").words;
  EXPECT_EQ(words_of("light"), std::set<std::string_view>(light.begin(), light.end()));
  for (const std::string_view state : requirement_attribute("state").words) {
    EXPECT_TRUE(words_of("state").contains(state)) << state;
  }
}

}  // namespace
}  // namespace rules
