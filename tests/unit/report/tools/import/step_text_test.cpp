#include "report/tools/import/step_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace step_text_test {
namespace {

using cli::StepProblem;
using cli::StepText;
using cli::StepValue;
using ::testing::HasSubstr;

std::string file(const std::string& data) {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
         "FILE_NAME('a','b',('c'),('d'),'pre','Hand 1.0','');\nFILE_SCHEMA(('Ifc4'));\nENDSEC;\n"
         "DATA;\n" +
         data + "\nENDSEC;\nEND-ISO-10303-21;\n";
}

std::string problem_of(const std::string& bytes) {
  StepProblem problem;
  if (StepText::open(bytes, problem)) return "";
  return std::to_string(problem.line) + ": " + problem.what;
}

// The arguments of #1.
std::vector<StepValue> arguments(std::string text_of_file) {
  static std::deque<std::string> kept;  // values are slices of it
  const std::string& bytes = kept.emplace_back(std::move(text_of_file));
  StepProblem problem;
  const auto text = StepText::open(bytes, problem);
  EXPECT_TRUE(text) << problem.line << ": " << problem.what;
  if (!text || !text->find(1)) return {};
  return text->arguments(*text->find(1));
}

TEST(StepText, KnowsItsHeaderAndFindsInstances) {
  const std::string bytes = file("#20=IFCWALL();\n/* ; ' */ #3 = ifcwall ( $ , * ) ;#7=A(#20);");
  StepProblem problem;
  const auto text = StepText::open(bytes, problem);
  ASSERT_TRUE(text) << problem.what;
  EXPECT_EQ(text->schema(), std::vector<std::string>{"IFC4"});
  ASSERT_EQ(text->size(), 3u);
  EXPECT_EQ(text->of_name("IFCWALL").size(), 2u);
  EXPECT_EQ(text->number(text->of_name("IFCWALL")[0]), 3u);  // by number
  EXPECT_TRUE(text->of_name("IFCDOOR").empty());
  EXPECT_FALSE(text->find(4));
  EXPECT_EQ(text->line(*text->find(20)), 8u);
  EXPECT_EQ(text->line(*text->find(3)), 9u);
  const auto reference = text->arguments(*text->find(7));
  ASSERT_EQ(reference.size(), 1u);
  EXPECT_EQ(text->name(text->find(reference[0]).value()), "IFCWALL");
}

TEST(StepText, ReadsEveryKindOfValue) {
  const auto a = arguments(
      file("#1=A($,*,-1.5E-1,3,0.,'x',.Metre.,\"0FF\",#12,(1,(2,3),()),IfcLabel ('y'),B(1,2));"));
  ASSERT_EQ(a.size(), 12u);
  EXPECT_TRUE(a[0].is_null());
  EXPECT_EQ(a[1].kind(), StepValue::Kind::derived);
  EXPECT_EQ(a[2].number(), -0.15);
  EXPECT_EQ(a[3].number(), 3.0);
  EXPECT_EQ(a[4].number(), 0.0);
  EXPECT_EQ(a[5].text(), "x");
  EXPECT_FALSE(a[5].number());
  EXPECT_EQ(a[6].enumeration(), "METRE");
  EXPECT_EQ(a[7].kind(), StepValue::Kind::binary);
  EXPECT_EQ(a[8].reference(), 12u);
  ASSERT_EQ(a[9].items().size(), 3u);
  EXPECT_EQ(a[9].items()[1].items()[1].number(), 3.0);
  EXPECT_TRUE(a[9].items()[2].items().empty());
  EXPECT_EQ(a[10].type_name(), "IFCLABEL");
  EXPECT_EQ(a[10].untyped().text(), "y");
  EXPECT_TRUE(a[11].untyped().is_null());  // two arguments are not one
}

TEST(StepText, InstancesThatAreSeveralAtOnceHaveNoName) {
  const std::string bytes = file("#1=(A(1)B('x;'));#2=C();");
  StepProblem problem;
  const auto text = StepText::open(bytes, problem);
  ASSERT_TRUE(text) << problem.what;
  EXPECT_EQ(text->name(0), "");
  EXPECT_TRUE(text->arguments(0).empty());
  EXPECT_EQ(text->name(1), "C");
}

TEST(StepText, ResolvesEscapes) {
  const auto text = [](std::string_view raw) { return cli::step_string(raw); };
  EXPECT_EQ(text("it''s"), "it's");
  EXPECT_EQ(text("a\\\\b"), "a\\b");
  EXPECT_EQ(text("B\\X2\\00FC\\X0\\ro"), "Büro");
  EXPECT_EQ(text("\\X2\\004200FC\\X0\\"), "Bü");
  EXPECT_EQ(text("\\X2\\D83DDE00\\X0\\"), "😀");
  EXPECT_EQ(text("\\X4\\0001F600\\X0\\"), "😀");
  EXPECT_EQ(text("B\\X\\FCro"), "Büro");
  EXPECT_EQ(text("B\\S\\|ro"), "Büro");
  EXPECT_EQ(text("\\PE\\\\S\\;"), "Л");
  EXPECT_EQ(text("a\r\n b"), "a b");
  EXPECT_EQ(text("C:\\dir"), "C:\\dir");
}

TEST(StepText, KnowsTheAlphabetsOfIso8859) {
  // The letters 0xBF, 0xC1, 0xE6 and 0xFE of each.
  const auto text = [](char page) {
    return cli::step_string(std::string("\\P") + page + "\\\\S\\?\\S\\A\\S\\f\\S\\~");
  };
  EXPECT_EQ(text('A'), "¿Áæþ");
  EXPECT_EQ(text('B'), "żÁćţ");
  EXPECT_EQ(text('C'), "żÁĉŝ");
  EXPECT_EQ(text('D'), "ŋÁæū");
  EXPECT_EQ(text('E'), "ПСцў");
  EXPECT_EQ(text('F'), "\u061F\u0621\u0646\uFFFD");
  EXPECT_EQ(text('G'), "ΏΑζώ");
  EXPECT_EQ(text('H'), "\uFFFD\uFFFD\u05D6\u200F");
  EXPECT_EQ(text('I'), "¿Áæş");
  // A page holds until the next one, and not beyond its string.
  EXPECT_EQ(cli::step_string("\\PB\\\\S\\f\\PA\\\\S\\f"), "ćæ");
  EXPECT_EQ(cli::step_string("\\PX\\\\S\\f"), "\\PX\\\uFFFD");
}

TEST(StepText, SaysWhereLettersAreGuessed) {
  const auto sure = [](std::string_view raw) {
    bool is_sure = true;
    cli::step_string(raw, &is_sure);
    return is_sure;
  };
  EXPECT_TRUE(sure("B\xC3\xBCro \\X2\\00FC\\X0\\"));
  EXPECT_FALSE(sure("B\xFCro"));
  EXPECT_EQ(cli::step_string("B\xFCro"), "Büro");
  EXPECT_TRUE(sure("\\PG\\\\S\\a"));
  EXPECT_FALSE(sure("\\PG\\\\S\\."));  // nothing in ISO 8859-7
  EXPECT_FALSE(sure("\\PX\\\\S\\a"));
  EXPECT_FALSE(sure("\\X2\\D83D\\X0\\"));  // half of a pair
  EXPECT_FALSE(sure("\\X2\\DE00D83D\\X0\\"));
  EXPECT_FALSE(sure("\\X2\\00FC"));
  EXPECT_FALSE(sure("\\X2\\00G0\\X0\\"));
  EXPECT_FALSE(sure("\\X4\\00110000\\X0\\"));
}

TEST(StepText, AQuoteAfterTheEscapeOfAByteBelongsToIt) {
  const auto a = arguments(file("#1=A('x\\S\\'y','z');"));
  ASSERT_EQ(a.size(), 2u);
  EXPECT_EQ(a[0].text(), "x§y");
  const auto b = arguments(file("#1=A('C:\\\\S\\\\','z');"));
  ASSERT_EQ(b.size(), 2u);
  EXPECT_EQ(b[0].text(), "C:\\S\\");
}

TEST(StepText, BrokenFilesAreRefusedWithTheirLine) {
  EXPECT_THAT(problem_of(""), HasSubstr("1: ISO-10303-21 is expected"));
  EXPECT_THAT(problem_of("PK\x03\x04zip"), HasSubstr("ZIP"));
  EXPECT_THAT(problem_of("<?xml?>"), HasSubstr("XML"));
  EXPECT_THAT(problem_of("solid a"), HasSubstr("ISO-10303-21"));
  EXPECT_EQ(problem_of(file("#1=A('x);")), "8: a string that is never closed");
  EXPECT_EQ(problem_of(file("\n#1=A(1;")), "9: ',' or ')' is expected, but ';' found");
  EXPECT_EQ(problem_of(file("#1=A(1,);")), "8: a value is expected, but ')' found");
  EXPECT_EQ(problem_of(file("#1=A(1..2);")), "8: '1..2' is not a finite number");
  EXPECT_EQ(problem_of(file("#1=A(1.E999);")), "8: '1.E999' is not a finite number");
  EXPECT_EQ(problem_of(file("#1=A(.B);")), "8: '.B)' is not an enumeration such as .METRE.");
  EXPECT_EQ(problem_of(file("#1=A(#);")), "8: '#' without a number");
  EXPECT_EQ(problem_of(file("#1=A(#1234567890123456789);")),
            "8: the number of an instance has more than 18 digits");
  EXPECT_EQ(problem_of(file("#1=A();\n#1=B();")), "9: #1 is given twice, first in line 8");
  EXPECT_EQ(problem_of(file("#1=A(NAN);")), "8: a value is expected, but 'NAN' found");
  EXPECT_EQ(problem_of(file("#1=A();/*")), "8: a comment that is never closed");
  EXPECT_EQ(problem_of(file("WALL();")),
            "8: an instance (#12=...) or ENDSEC is expected, but 'WALL' found");
  EXPECT_EQ(problem_of("ISO-10303-21;HEADER;ENDSEC;\nANCHOR;ENDSEC;"),
            "2: the section 'ANCHOR' is not read; only HEADER and DATA are");
}

TEST(StepText, AFileThatIsCutAnywhereIsRefused) {
  const std::string whole =
      file("#1=A('it''s \\X2\\00FC\\X0\\',(1.5,.B.),C(#2));/* c */\n#2=D($);");
  const std::size_t end = whole.rfind(';');
  for (std::size_t length = 0; length <= end; ++length) {
    EXPECT_NE(problem_of(whole.substr(0, length)), "") << length;
  }
  EXPECT_EQ(problem_of(whole), "");
}

TEST(StepText, NestingHasALimit) {
  const auto nested = [](std::size_t depth) {
    return file("#1=A(" + std::string(depth, '(') + std::string(depth, ')') + ");");
  };
  EXPECT_EQ(problem_of(nested(60)), "");
  EXPECT_THAT(problem_of(nested(100)), HasSubstr("nested more than 64 deep"));
  EXPECT_THAT(problem_of(nested(1000000)), HasSubstr("nested more than 64 deep"));
}

TEST(StepText, TooManyNamesAreNoIfc) {
  std::string data;
  for (int i = 1; i <= 10001; ++i) {
    data += "#" + std::to_string(i) + "=A" + std::to_string(i) + "();\n";
  }
  EXPECT_THAT(problem_of(file(data)), HasSubstr("different names"));
}

TEST(StepText, WhatIsWrittenReadsBack) {
  for (const char* text :
       {"", "plain", "it's \\ \\X2\\", "Büro 101 – Zürich", "a😀b", "/* no comment */"}) {
    const std::string literal = cli::step_literal(text);
    EXPECT_EQ(cli::step_string(std::string_view(literal).substr(1, literal.size() - 2)), text);
    EXPECT_EQ(literal.find("/*"), std::string::npos);
    for (const char c : literal) EXPECT_LT(static_cast<unsigned char>(c), 0x80);
  }
  EXPECT_EQ(cli::step_literal("Bü"), "'B\\X2\\00FC\\X0\\'");
  EXPECT_EQ(cli::step_literal("a\xFF"), "'a\\X2\\FFFD\\X0\\'");
  EXPECT_EQ(cli::step_real(500), "500.");
  EXPECT_EQ(cli::step_real(0.5), "0.5");
  EXPECT_EQ(cli::step_real(-1e-7), "-1.E-07");
  EXPECT_EQ(cli::step_real(1.5e300), "1.5E+300");
}

TEST(StepText, KnowsWhereItsDataEnd) {
  const std::string bytes =
      "\xEF\xBB\xBFISO-10303-21;HEADER;ENDSEC;DATA;#1=A('ENDSEC;');ENDSEC ;"
      "END-ISO-10303-21;";
  cli::StepProblem problem;
  const auto text = cli::StepText::open(bytes, problem);
  ASSERT_TRUE(text) << problem.what;
  EXPECT_EQ(text->data_end(), bytes.find("ENDSEC ;"));
}

}  // namespace
}  // namespace step_text_test
