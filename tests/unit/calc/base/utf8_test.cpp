#include "calc/base/utf8.h"

#include <gtest/gtest.h>

namespace calc::utf8_test {
namespace {

TEST(Utf8, AcceptsOneToFourBytes) {
  EXPECT_FALSE(first_invalid_utf8("a\xC3\xBC\xE2\x82\xAC\xF0\x9F\x92\xA1"));
}

TEST(Utf8, FindsTheFirstBadByte) {
  EXPECT_EQ(first_invalid_utf8("ab\xFC"), 2u);            // Latin-1
  EXPECT_EQ(first_invalid_utf8("a\x80"), 1u);             // continuation without lead
  EXPECT_EQ(first_invalid_utf8("a\xE2\x82"), 1u);         // cut off
  EXPECT_EQ(first_invalid_utf8("\xC0\xAF"), 0u);          // overlong
  EXPECT_EQ(first_invalid_utf8("\xE0\x80\xAF"), 0u);      // overlong
  EXPECT_EQ(first_invalid_utf8("\xED\xA0\x80"), 0u);      // surrogate
  EXPECT_EQ(first_invalid_utf8("\xF4\x90\x80\x80"), 0u);  // above U+10FFFF
}

TEST(Utf8, DecodesWhatItEncodes) {
  for (const char32_t code : {0x41u, 0x7Fu, 0x80u, 0x7FFu, 0x800u, 0xFFFDu, 0x10000u, 0x10FFFFu}) {
    const std::string text = utf8_from_code_point(code);
    const Utf8Character first = first_character(text + "x");
    EXPECT_EQ(first.code, code);
    EXPECT_EQ(first.length, text.size());
  }
  EXPECT_EQ(first_character("\xC3").length, 0u);
}

TEST(Utf8, ByteOrderMarks) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFx"), "x");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBBx"), "\xEF\xBBx");
  EXPECT_TRUE(has_utf16_mark("\xFF\xFEx"));
  EXPECT_TRUE(has_utf16_mark("\xFE\xFF"));
  EXPECT_FALSE(has_utf16_mark("\xFF"));
}

TEST(Utf8, EncodesCodePointsOfAllLengths) {
  EXPECT_EQ(utf8_from_code_point('A'), "A");
  EXPECT_EQ(utf8_from_code_point(0xFC), "\xC3\xBC");
  EXPECT_EQ(utf8_from_code_point(0x20AC), "\xE2\x82\xAC");
  EXPECT_EQ(utf8_from_code_point(0x1F4A1), "\xF0\x9F\x92\xA1");
}

TEST(Utf8, WhatIsShownHasNoCommandForCiRunners) {
  EXPECT_EQ(printable("a##[set-output name=b]c###[##"), "a## [set-output name=b]c### [##");
  EXPECT_EQ(printable("a##vso[task.complete]##teamcity[x] #a[1] ##"),
            "a##vso [task.complete]##teamcity [x] #a[1] ##");
  EXPECT_EQ(printable("\xC2\xA0 \xC3\x9B \xC2"), "\xC2\xA0 \xC3\x9B \xEF\xBF\xBD");
}

TEST(Utf8, ShortensByCharacters) {
  EXPECT_EQ(shorten_utf8("\xC3\xBC\xC3\xBC\xC3\xBC", 2), "\xC3\xBC\xC3\xBC...");
  EXPECT_EQ(shorten_utf8("\xC3\xBC\xC3\xBC", 2), "\xC3\xBC\xC3\xBC");
}

}  // namespace
}  // namespace calc::utf8_test
