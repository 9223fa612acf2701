#include "calc/base/encoding.h"
#include "calc/base/csv.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace calc::encoding_test {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

// Characters beyond U+FFFF as pairs.
std::string utf16(const std::string& utf8, bool is_big, bool has_mark) {
  std::string wide;
  const auto add = [&](char32_t unit) {
    const char high = static_cast<char>(unit >> 8u), low = static_cast<char>(unit & 0xFFu);
    wide += is_big ? high : low;
    wide += is_big ? low : high;
  };
  if (has_mark) add(0xFEFF);
  for (std::size_t i = 0; i < utf8.size();) {
    const Utf8Character next = first_character(std::string_view(utf8).substr(i));
    i += next.length;
    if (next.code < 0x10000) {
      add(next.code);
    } else {
      add(0xD800 + ((next.code - 0x10000) >> 10u));
      add(0xDC00 + ((next.code - 0x10000) & 0x3FFu));
    }
  }
  return wide;
}

const std::string kXml =
    "<?xml version='1.0' encoding='UTF-16'?>\r\n<a n='Gr\u00FC\u00DFe \U0001F4A1'>\r\n <b/></a>";

TEST(Encoding, Utf16IsDecodedInBothOrdersWithAndWithoutMark) {
  for (const bool is_big : {false, true}) {
    for (const bool has_mark : {false, true}) {
      const std::string wide = utf16(kXml, is_big, has_mark);
      EXPECT_EQ(encoding_of(wide), is_big ? TextEncoding::utf16_be : TextEncoding::utf16_le);
      EXPECT_EQ(decoded_text(wide).utf8, kXml);
      Diagnostics diagnostics;
      const auto root = parse_xml(wide, "x", diagnostics);
      ASSERT_TRUE(root) << format_diagnostic(diagnostics.all().at(0));
      EXPECT_EQ(root->attributes.at(0).value, "Gr\u00FC\u00DFe \U0001F4A1");
      EXPECT_EQ(root->children.at(0).where.line, 3);
      EXPECT_EQ(root->children.at(0).where.column, 2);
    }
  }
}

TEST(Encoding, BrokenUtf16IsAProblem) {
  const std::string wide = utf16("ab", false, true);
  EXPECT_EQ(decoded_text(wide).problem, "");
  EXPECT_NE(decoded_text(wide + "c").problem, "");
  const DecodedText half = decoded_text(wide + "\x00\xD8"s + "d\0"s);
  EXPECT_EQ(half.utf8, "ab");
  EXPECT_NE(half.problem, "");
  EXPECT_NE(decoded_text(wide + "\x00\xDC"s).problem, "");
  EXPECT_NE(decoded_text("\xFF\xFE\0\0a\0\0\0"s).problem, "");
}

TEST(Encoding, FewOrOddBytesAreNoUtf16) {
  EXPECT_EQ(encoding_of("IESNA"), TextEncoding::utf8);
  EXPECT_EQ(encoding_of("\0\0\0\0"s), TextEncoding::utf8);
  EXPECT_EQ(encoding_of(""), TextEncoding::utf8);
}

std::string xml_problem(const std::string& bytes) {
  Diagnostics diagnostics;
  const auto root = parse_xml(bytes, "x", diagnostics);
  EXPECT_EQ(!root, diagnostics.has_errors());
  return root ? "" : format_diagnostic(diagnostics.all().at(0));
}

TEST(Encoding, DeclaredCodePagesAreRead) {
  const auto name_in = [](const std::string& encoding, const std::string& bytes) {
    Diagnostics diagnostics;
    const auto root =
        parse_xml("<?xml version='1.0' encoding='" + encoding + "'?><a n='" + bytes + "'/>", "x",
                  diagnostics);
    return root ? root->attributes.at(0).value : format_diagnostic(diagnostics.all().at(0));
  };
  EXPECT_EQ(name_in("ISO-8859-1", "B\xFCro"), "B\u00FCro");
  EXPECT_EQ(name_in("Windows-1252", "5 \x80"), "5 \u20AC");
  EXPECT_THAT(name_in("UTF-8", "B\xFCro"), HasSubstr("is not valid UTF-8"));
  EXPECT_THAT(name_in("KOI8-R", "a"), HasSubstr("x:1:31: error[xml-encoding]"));
}

TEST(Encoding, DeclarationsThatContradictTheBytesAreRefused) {
  EXPECT_THAT(xml_problem("<?xml version='1.0' encoding='utf-16'?><a/>"),
              HasSubstr("the declaration says 'utf-16', but the file is not UTF-16"));
  EXPECT_THAT(xml_problem(utf16("<?xml version='1.0' encoding='utf-8'?><a/>", false, true)),
              HasSubstr("the declaration says 'utf-8', but the file is UTF-16"));
  EXPECT_THAT(xml_problem("\xEF\xBB\xBF<?xml version='1.0' encoding='latin1'?><a/>"),
              HasSubstr("byte order mark of UTF-8"));
  EXPECT_EQ(xml_problem(utf16("<a/>", true, false)), "");
  EXPECT_THAT(xml_problem(utf16("<a>\n<b></a>", false, true)), HasSubstr("x:2:"));
}

TEST(Encoding, XmlIsToldByItsBeginning) {
  EXPECT_TRUE(looks_like_xml(utf16("  <a/>", false, false)));
  EXPECT_TRUE(looks_like_xml("\xEF\xBB\xBF\n<!-- c --><a/>"));
  EXPECT_FALSE(looks_like_xml("< 3"));
  EXPECT_FALSE(looks_like_xml("a<b>"));
  EXPECT_EQ(first_element_name("<?xml?><!-- <c> --><!DOCTYPE d><p:name x='1'/>"), "name");
  EXPECT_TRUE(has_first_element(utf16("<gbXML>", true, true), "gbXML"));
}

TEST(Encoding, TablesAreReadInOtherEncodings) {
  const auto first_cell = [](const std::string& bytes) {
    CsvReader table(bytes);
    const auto record = table.next();
    return record ? record->cells.at(0).text : "problem: " + table.problem()->what;
  };
  EXPECT_EQ(first_cell(utf16("B\u00FCro,1\n", false, true)), "B\u00FCro");
  EXPECT_EQ(first_cell("B\xFCro,1\n"), "B\u00FCro");
  EXPECT_EQ(first_cell("B\u00FCro,1\n"), "B\u00FCro");
  EXPECT_THAT(first_cell(utf16("a,1", false, true) + "x"),
              HasSubstr("problem: the UTF-16 text has an incomplete character"));
  EXPECT_THAT(first_cell("PK\x03\x04....xl/workbook.xml"),
              HasSubstr("it is an Excel workbook; a table of comma-separated values (CSV)"));
}

}  // namespace
}  // namespace calc::encoding_test
