#include "calc/base/element_table.h"

#include "calc/base/diagnostics.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_reader.h"
#include "calc/base/xml_schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>

namespace calc::element_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const ValueType kColour{.name = "colour", .base = &kAnyText, .words = {"red", "green"}};
const ValueType kWidth{
    .name = "width", .base = &kAnyDouble, .range = NumberRange{0.0, 1.0e9, true, ""}};
const ElementRow kLeaf{.type = "leaf", .attributes = {{"width", &kWidth, Presence::required}}};
const ElementGroup kPlants{"plants", {{"leaf", &kLeaf}, {"blade", &kLeaf}}};
const ElementRow kTree{.type = "tree",
                       .attributes = {{"colour", &kColour, Presence::optional, "Of all.", "red"}},
                       .children = {{.group = &kPlants}}};

std::size_t errors_of(const std::string& xml, const ElementRow& row) {
  Diagnostics diagnostics;
  const std::optional<XmlElement> root = parse_xml(xml, "x.xml", diagnostics);
  EXPECT_TRUE(root);
  ElementReader(*root, diagnostics).allow(row);
  return diagnostics.error_count();
}

TEST(ElementTable, ReaderAllowsWhatTheRowHas) {
  EXPECT_EQ(errors_of("<tree colour='red'><leaf/><blade/></tree>", kTree), 0u);
  EXPECT_EQ(errors_of("<tree width='1'><root/></tree>", kTree), 2u);
}

TEST(ElementTable, SchemaHasWhatTheRowHas) {
  const std::string schema = xml_schema({"a test", "A tree.", {"tree", &kTree}});
  EXPECT_THAT(schema, HasSubstr("<xs:attribute name=\"colour\" type=\"colour\" default=\"red\">"));
  EXPECT_THAT(schema, HasSubstr("<xs:attribute name=\"width\" type=\"width\" use=\"required\"/>"));
  EXPECT_THAT(schema, HasSubstr("<xs:documentation>Of all.</xs:documentation>"));
  EXPECT_THAT(schema, HasSubstr("<xs:element name=\"blade\" type=\"leaf\"/>"));
  EXPECT_THAT(schema, HasSubstr("<xs:minExclusive value=\"0\"/>"));
  EXPECT_THAT(schema, HasSubstr("<xs:enumeration value=\"green\"/>"));
}

TEST(ElementTable, RowsOfAnotherModuleStandForThoseOfTheSameType) {
  const ElementRow leaf{.type = "leaf", .attributes = {{"stalk", &kWidth}}};
  const std::string schema = xml_schema({"a test", "A tree.", {"tree", &kTree}, {leaf}});
  EXPECT_THAT(schema, HasSubstr("name=\"stalk\""));
  EXPECT_THAT(schema, Not(HasSubstr("name=\"width\" type")));
}

TEST(ElementTable, EitherOfTwoFormsHasTheNamesOfBothOnce) {
  const ElementRow both = either_of(kTree, {.type = "tree",
                                            .attributes = {{"colour", &kColour}, {"age", &kWidth}},
                                            .children = {{.group = &kPlants}, {"nest", &kLeaf}}});
  EXPECT_EQ(attribute_names(both), (Names{"colour", "age"}));
  EXPECT_EQ(child_names(both), (Names{"leaf", "blade", "nest"}));
}

}  // namespace
}  // namespace calc::element_table_test
