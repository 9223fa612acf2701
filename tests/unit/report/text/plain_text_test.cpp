#include "report/text/plain_text.h"

#include <gtest/gtest.h>

#include <string_view>

namespace report::plain_text_test {
namespace {

TEST(PlainText, GoodTextIsKept) {
  EXPECT_EQ(printable("Büro – 2. OG 照明 💡"), "Büro – 2. OG 照明 💡");
}

TEST(PlainText, ControlCharactersBecomeBlanks) {
  EXPECT_EQ(printable("a\x1b[31mb\nc\td\x7f"), "a [31mb c d ");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a b");
  EXPECT_EQ(printable("a\xE2\x80\xAE"
                      "b"),
            "a b");  // U+202E, right-to-left override
  EXPECT_EQ(printable("a\xEF\xBF\xBF"
                      "b"),
            "a b");  // U+FFFF, not allowed in XML
}

TEST(PlainText, BrokenBytesAreReplacedOneByOne) {
  EXPECT_EQ(printable("M\xFCller"), "M\uFFFDller");            // Latin-1
  EXPECT_EQ(printable("\xE2\x82"), "\uFFFD\uFFFD");            // cut short
  EXPECT_EQ(printable("\xC0\xAF"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // surrogate
}

TEST(PlainText, WidthCountsColumns) {
  EXPECT_EQ(display_width("Büro"), 4U);
  EXPECT_EQ(display_width("照明"), 4U);
  EXPECT_EQ(display_width("e\u0301"), 1U);
}

TEST(PlainText, ShorteningKeepsTheEnd) {
  EXPECT_EQ(shorten_start("Office / Work plane", 40), "Office / Work plane");
  EXPECT_EQ(shorten_start("Office / Work plane", 11), "…Work plane");
  EXPECT_EQ(shorten_start("照明照明", 4), "…明");
  EXPECT_EQ(shorten_start("abc", 1), "…");
}

TEST(PlainText, LongNamesLoseTheirMiddle) {
  EXPECT_EQ(shorten_middle("Office / Work plane", 13), "Office /…lane");
  EXPECT_EQ(shorten_middle("Office", 13), "Office");
  EXPECT_EQ(shorten_name("Registry, north wing, shelf 12", 16), "Registry, …lf 12");
  EXPECT_EQ(shorten_name("Registry, north wing", 12), "Registry, n…");
  EXPECT_EQ(shorten_name("照明照明照明照明照明照明照明", 12), "照明照明…明");
  for (std::size_t columns = 1; columns < 30; ++columns) {
    EXPECT_LE(display_width(shorten_name("Registry, 照明 wing, shelf 12", columns)), columns);
  }
}

TEST(PlainText, NamesAreInTheOrderOfTheirNumbers) {
  EXPECT_TRUE(comes_before("Room 9", "Room 10"));
  EXPECT_FALSE(comes_before("Room 10", "Room 9"));
  EXPECT_FALSE(comes_before("Room 10", "Room 010"));
  EXPECT_TRUE(comes_before("1.02 Hall", "1.10 Attic"));
  EXPECT_TRUE(comes_before("Room", "Room 1"));
}

}  // namespace
}  // namespace report::plain_text_test
