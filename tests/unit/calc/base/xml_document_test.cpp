#include "calc/base/xml_document.h"

#include "calc/base/diagnostic_ids.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace calc::xml_document_test {
namespace {

TEST(XmlDocument, TellsLineAndColumnOfElementsAndAttributes) {
  Diagnostics diagnostics;
  const auto root = parse_xml("<a>\n  <b  x='1'\n     y='2'/>\n</a>", "f.xml", diagnostics);
  ASSERT_TRUE(root);
  const XmlElement& b = root->children.at(0);
  EXPECT_EQ(b.where.file, "f.xml");
  EXPECT_EQ(b.where.line, 2);
  EXPECT_EQ(b.where.column, 3);
  EXPECT_EQ(b.find("x")->where.line, 2);
  EXPECT_EQ(b.find("x")->where.column, 7);
  EXPECT_EQ(b.find("y")->where.line, 3);
  EXPECT_EQ(b.find("y")->where.column, 6);
}

// The parser ends names by writing over what follows them, which may be the end of a line.
TEST(XmlDocument, TellsPlacesInLongFilesAndLongLines) {
  std::string text = "<a>";
  std::vector<SourceLocation> expected;
  int line = 1, column = 4;
  for (int k = 0; k < 6000; ++k) {
    expected.push_back({"f.xml", line, column});
    const bool is_broken = k % 7 == 0, is_row_end = k % 1500 == 1499;
    text += is_broken ? "<b\nx='\xC3\xA4'/>" : "<b x='\xC3\xA4'/>";
    line += is_broken ? 1 : 0;
    column = is_broken ? 8 : column + 10;
    if (!is_row_end) continue;
    text += std::string(9000, '\n');
    line += 9000;
    column = 1;
  }
  Diagnostics diagnostics;
  const auto root = parse_xml(text + "</a>", "f.xml", diagnostics);
  ASSERT_TRUE(root);
  ASSERT_EQ(root->children.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const SourceLocation& where = root->children[k].where;
    ASSERT_EQ(std::pair(where.line, where.column), std::pair(expected[k].line, expected[k].column))
        << k;
  }
}

TEST(XmlDocument, CountsCharactersNotBytesAndSkipsTheByteOrderMark) {
  Diagnostics diagnostics;
  const auto root =
      parse_xml("\xEF\xBB\xBF<a n='\xC3\xA4\xE2\x82\xAC' x='1'/>", "f.xml", diagnostics);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->where.column, 1);
  EXPECT_EQ(root->find("x")->where.column, 11);
}

TEST(XmlDocument, AcceptsCarriageReturns) {
  Diagnostics diagnostics;
  const auto root =
      parse_xml("<?xml version='1.0'?>\r\n<a>\r\n <b/>\r\n</a>\r\n", "f.xml", diagnostics);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->children.at(0).where.line, 3);
  EXPECT_EQ(root->children.at(0).where.column, 2);
}

TEST(XmlDocument, ResolvesReferencesAndNormalizesBlanks) {
  Diagnostics diagnostics;
  const auto root =
      parse_xml("<a x='&lt;&amp;&gt;&quot;&apos;&#65;&#x20AC;\n.\t.'/>", "f", diagnostics);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->find("x")->value, "<&>\"'A\xE2\x82\xAC . .");
}

TEST(XmlDocument, RefusesReferencesToForbiddenCharacters) {
  for (const char* reference : {"&#0;", "&#xD800;", "&#x110000;", "&#;", "&#x;", "&#-1;", "&;"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_xml("<a x='" + std::string(reference) + "'/>", "f", diagnostics))
        << reference;
    EXPECT_EQ(diagnostics.error_count(), 1u) << reference;
  }
}

TEST(XmlDocument, SkipsCommentsAndProcessingInstructions) {
  Diagnostics diagnostics;
  const auto root =
      parse_xml("<?p q?><!-- c --><a><!-- text --><?p q?></a><!----><?z?>", "f", diagnostics);
  ASSERT_TRUE(root);
  EXPECT_TRUE(root->children.empty());
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(XmlDocument, RefusesCharacterData) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml("<a><![CDATA[text]]></a>", "f", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].id, DiagnosticId::xml_text);
}

TEST(XmlDocument, ReportsAllProblems) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml("<a x='1' x='2'>text<b y='&no;'/></a>", "f", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 3u);
}

TEST(XmlDocument, AcceptsTheDepthLimitAndRefusesOneMore) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<a>";
    for (int i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_xml(nested(kXmlDepthLimit), "f", diagnostics));
  EXPECT_FALSE(parse_xml(nested(kXmlDepthLimit + 1), "f", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].id, DiagnosticId::xml_too_deep);
}

TEST(XmlDocument, SurvivesAHundredThousandLevels) {
  std::string open, close;
  for (int i = 0; i < 100000; ++i) {
    open += "<a>";
    close += "</a>";
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml(open + close, "f", diagnostics));
  EXPECT_FALSE(parse_xml(open, "f", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2u);
}

TEST(XmlDocument, RefusesAnElementWithTooManyAttributes) {
  std::string text = "<a";
  for (std::size_t i = 0; i <= kXmlAttributeLimit; ++i) text += " x" + std::to_string(i) + "='1'";
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml(text + "/>", "f", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].id, DiagnosticId::xml_too_many_attributes);
}

TEST(XmlDocument, RefusesALateDeclaration) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml("<!-- c -->\n<?xml version='1.0'?><a/>", "f", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].where.line, 2);
}

TEST(XmlDocument, RefusesBadDeclarations) {
  for (const char* declaration :
       {"<?xml?>", "<?xml version=1?>", "<?xml version='1.0' encoding='UTF-8'",
        "<?xml encoding='UTF-8'?>", "<?xml version='1.0' encoding='utf-16'?>",
        "<?xml version='1.0' n='1'?>"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_xml(std::string(declaration) + "<a/>", "f", diagnostics)) << declaration;
    EXPECT_EQ(diagnostics.error_count(), 1u) << declaration;
  }
}

TEST(XmlDocument, RefusesASingleCharacterBehindTheRoot) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_xml("<a/>x", "f", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 1u);
}

// Every prefix of a good file is a truncated file: an error, never a crash.
TEST(XmlDocument, RefusesEveryTruncation) {
  const std::string text = "<?xml version='1.0'?><!-- c --><a x='&amp;'><b y=\"2\"/></a>";
  for (std::size_t length = 0; length < text.size(); ++length) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_xml(text.substr(0, length), "f", diagnostics)) << length;
    EXPECT_TRUE(diagnostics.has_errors()) << length;
  }
}

}  // namespace
}  // namespace calc::xml_document_test
