#include "calc/photometry/read/xml_query.h"

#include "tests/support/photometry_samples.h"

#include <gtest/gtest.h>

namespace calc::xml_query_test {
namespace {

XmlElement parse(const std::string& text) {
  Diagnostics diagnostics;
  return parse_xml(text, "f.xml", diagnostics, XmlText::keep).value();
}

TEST(XmlQuery, TextIsKeptWithReferencesAndSectionsResolved) {
  const XmlElement root = parse("<a>\n one &lt;<b> 2 </b><!-- no --><![CDATA[&amp;]]>\n</a>");
  EXPECT_EQ(text_of(&root), "one <&amp;");
  EXPECT_EQ(text_of(child_of(root, "b")), "2");
  EXPECT_EQ(text_of(child_of(root, "c")), "");
}

TEST(XmlQuery, TextOutsideTheRootIsStillAnError) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml("<a/>x", "f.xml", diagnostics, XmlText::keep));
}

TEST(XmlQuery, PrefixesOfNamespacesAreIgnored) {
  const XmlElement root = parse("<n:a><n:b n:x='1  2'><c>7</c></n:b><b x='3'/></n:a>");
  EXPECT_EQ(local_name(root.name), "a");
  EXPECT_EQ(children_of(root, "b").size(), 2u);
  EXPECT_EQ(attribute_of(*child_of(root, "b"), "x"), "1 2");
  EXPECT_EQ(attribute_of(*child_of(root, "b"), "y"), "");
  EXPECT_EQ(text_of(descend(root, {"b", "c"})), "7");
  EXPECT_EQ(descend(root, {"b", "d", "e"}), nullptr);
  EXPECT_EQ(child_of(root, {"none", "b"}), child_of(root, "b"));
}

TEST(XmlQuery, NumbersAreStrict) {
  const XmlElement root = parse("<a><b> 2.5e1\n</b><c>1,5</c><d/><e>true</e><f>0</f></a>");
  Diagnostics diagnostics;
  EXPECT_EQ(number_in(child_of(root, "b"), diagnostics), 25.0);
  EXPECT_FALSE(number_in(nullptr, diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_FALSE(number_in(child_of(root, "c"), diagnostics));
  EXPECT_FALSE(number_in(child_of(root, "d"), diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2u);
  EXPECT_EQ(format_diagnostic(diagnostics.all()[0]),
            "f.xml:2:5: error[photometry-number]: <c>: '1,5' is not a number; allowed: digits with "
            "a decimal point and an exponent");
  EXPECT_EQ(flag_in(child_of(root, "e")), true);
  EXPECT_EQ(flag_in(child_of(root, "f")), false);
  EXPECT_FALSE(flag_in(child_of(root, "b")));
}

TEST(XmlQuery, LettersIgnoreBlanksMarksAndCase) {
  EXPECT_EQ(letters_of("CIE _ C"), "ciec");
  EXPECT_EQ(letters_of("Symm _ Bi _90"), "symmbi90");
}

}  // namespace
}  // namespace calc::xml_query_test
