#include "report/tools/import/dxf_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace dxf_pairs_test {
namespace {

using ::testing::HasSubstr;

struct Read {
  std::vector<cli::DxfPair> pairs;
  std::string problem;
};
Read read(std::string_view bytes) {
  cli::DxfPairs pairs(bytes);
  Read read;
  for (cli::DxfPair pair; pairs.next(pair);) read.pairs.push_back(pair);
  read.problem = pairs.problem();
  return read;
}

TEST(DxfPairs, ReadsTextWithAnyLineEnds) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text =
        "  0" + end + "SECTION" + end + " 70 " + end + "   -3" + end + "0" + end + "EOF" + end;
    const Read found = read(text);
    EXPECT_EQ(found.problem, "");
    ASSERT_EQ(found.pairs.size(), 2u);
    EXPECT_EQ(found.pairs[0].text, "SECTION");
    EXPECT_EQ(found.pairs[1].code, 70);
    EXPECT_EQ(cli::dxf_integer(found.pairs[1]), -3);
    EXPECT_EQ(found.pairs[1].place, 3u);
  }
}

TEST(DxfPairs, PassesOverCommentsAndWhatFollowsTheEnd) {
  cli::DxfPairs pairs("999\nmade by me\n0\nSECTION\n0\nEOF\nrubbish\nmore");
  cli::DxfPair pair;
  ASSERT_TRUE(pairs.next(pair));
  EXPECT_EQ(pair.text, "SECTION");
  EXPECT_FALSE(pairs.next(pair));
  EXPECT_EQ(pairs.problem(), "");
  EXPECT_EQ(pairs.first_comment(), "made by me");
}

TEST(DxfPairs, SaysWhereAndWhyItStops) {
  EXPECT_THAT(read("0\nSECTION\nx\n1\n").problem, HasSubstr("line 3: a group code from 0 to 1071"));
  EXPECT_THAT(read("0\nSECTION\n").problem, HasSubstr("0 EOF: it is cut off"));
  EXPECT_THAT(read("").problem, HasSubstr("the file is empty"));
  EXPECT_THAT(read(std::string("AC1027\0\0\0", 9)).problem, HasSubstr("a DWG file"));
  EXPECT_THAT(read("\xFF\xFE"
                   "0")
                  .problem,
              HasSubstr("UTF-16"));
}

std::string little(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
  return text;
}

std::string binary(bool is_wide) {
  const auto code = [&](int number) {
    if (is_wide) return little(static_cast<std::uint64_t>(number), 2);
    return number < 255 ? little(static_cast<std::uint64_t>(number), 1)
                        : "\xFF" + little(static_cast<std::uint64_t>(number), 2);
  };
  std::string bytes("AutoCAD Binary DXF\r\n\x1A\0", 22);
  bytes += code(0) + std::string("LINE\0", 5);
  bytes += code(10) + little(std::bit_cast<std::uint64_t>(-2.5), 8);
  bytes += code(62) + little(0xFFFF, 2);
  bytes += code(1071) + little(7, 4);
  bytes += code(1004) + "\x03xyz";
  return bytes + code(0) + std::string("EOF\0", 4);
}

TEST(DxfPairs, ReadsBinaryFilesWithNarrowAndWideCodes) {
  for (const bool is_wide : {false, true}) {
    const std::string bytes = binary(is_wide);
    const Read found = read(bytes);
    EXPECT_EQ(found.problem, "");
    ASSERT_EQ(found.pairs.size(), 5u);
    EXPECT_EQ(found.pairs[0].text, "LINE");
    EXPECT_EQ(found.pairs[1].number, -2.5);
    EXPECT_EQ(cli::dxf_integer(found.pairs[2]), -1);
    EXPECT_EQ(cli::dxf_integer(found.pairs[3]), 7);
    // Cut anywhere, it is an error and never less of a drawing.
    for (std::size_t size = 22; size < bytes.size(); ++size) {
      EXPECT_THAT(read(std::string_view(bytes).substr(0, size)).problem, HasSubstr("it is cut off"))
          << size;
    }
  }
}

TEST(DxfTexts, GoByVersionAndCodePage) {
  cli::DxfTexts texts;
  texts.set("AC1015", "ANSI_1252");
  EXPECT_EQ(texts.decoded("B\xFCro"), "Büro");
  texts.set("AC1009", "ANSI_1251");
  EXPECT_EQ(texts.decoded("\xC7"), "З");
  texts.set("AC1032", "ANSI_1252");
  EXPECT_EQ(texts.decoded("Büro"), "Büro");
  EXPECT_EQ(texts.doubt(), "");
  EXPECT_EQ(texts.decoded("B\xFCro"), "Büro");
  EXPECT_THAT(texts.doubt(), HasSubstr("not UTF-8"));
}

TEST(DxfTexts, EscapesAreCharacters) {
  cli::DxfTexts texts;
  EXPECT_EQ(texts.decoded("B\\U+00FCro \\U+12"), "Büro \\U+12");
  EXPECT_EQ(texts.decoded("\\U+D83D\\U+DCA1"), "\xF0\x9F\x92\xA1");
  EXPECT_EQ(texts.decoded("\\U+D83D"), "\xEF\xBF\xBD");
}

TEST(DxfTexts, FormatsAreNoText) {
  EXPECT_EQ(cli::plain_dxf_text("%%uRoom%%u 20%%d %%c5 100%%%"), "Room 20° ⌀5 100%");
  EXPECT_EQ(cli::plain_dxf_mtext("{\\fArial|b0;101}\\PB\\{\\~x \\S1^2;"), "101 B{ x 1/2");
}

}  // namespace
}  // namespace dxf_pairs_test
