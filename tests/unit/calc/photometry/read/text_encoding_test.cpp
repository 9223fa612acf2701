#include "calc/photometry/read/text_encoding.h"

#include <gtest/gtest.h>

#include <string>

namespace calc::text_encoding_test {
namespace {

using namespace std::string_literals;

TEST(TextEncoding, Utf8IsKept) {
  EXPECT_EQ(utf8_from_file_text("L\xC3\xA4nge \xE2\x82\xAC \xF0\x9F\x92\xA1"),
            "L\xC3\xA4nge \xE2\x82\xAC \xF0\x9F\x92\xA1");
}

TEST(TextEncoding, OtherBytesAreWindows1252) {
  EXPECT_EQ(utf8_from_file_text("L\xE4nge"), "L\xC3\xA4nge");
  EXPECT_EQ(utf8_from_file_text("\x80"), "\xE2\x82\xAC");
  EXPECT_EQ(utf8_from_file_text("\xC0\x80"), "\xC3\x80\xE2\x82\xAC");  // overlong zero is no UTF-8
  EXPECT_EQ(utf8_from_file_text("\xED\xA0\x80"),
            "\xC3\xAD\xC2\xA0\xE2\x82\xAC");                             // nor is a surrogate
  EXPECT_EQ(utf8_from_file_text("a\xE2\x82"), "a\xC3\xA2\xE2\x80\x9A");  // nor a cut sequence
}

TEST(TextEncoding, ControlCharactersBecomeBlanks) {
  EXPECT_EQ(utf8_from_file_text("a\tb\x1B[0m\0c"s), "a b [0m c");
}

TEST(TextEncoding, QuotesAreCutBetweenCharacters) {
  EXPECT_EQ(quotable("short"), "short");
  EXPECT_EQ(quotable(std::string(50, 'x')), std::string(40, 'x') + "...");
  EXPECT_EQ(quotable(std::string(39, 'x') + "\xC3\xA4yyy"), std::string(39, 'x') + "...");
}

}  // namespace
}  // namespace calc::text_encoding_test
