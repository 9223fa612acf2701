#include "calc/photometry/read/number_stream.h"

#include <gtest/gtest.h>

namespace calc::number_stream_test {
namespace {

TEST(NumberStream, ReadsTokensAcrossAnyDelimiterWithTheirLines) {
  NumberStream stream("1, 2\t3\r\n\r\n,4\r5\n 6", 10);
  const int lines[] = {11, 11, 11, 13, 14, 15};
  EXPECT_EQ(stream.count_remaining(), 6U);
  for (int i = 0; i < 6; ++i) {
    const auto token = stream.next();
    ASSERT_TRUE(token);
    EXPECT_EQ(token->text, std::string(1, static_cast<char>('1' + i)));
    EXPECT_EQ(token->line, lines[i]) << i;
  }
  EXPECT_FALSE(stream.next());
  EXPECT_EQ(stream.line(), 15);
  EXPECT_EQ(stream.count_remaining(), 0U);
}

TEST(NumberStream, NumbersAreLocaleFreeAndFinite) {
  EXPECT_EQ(parse_photometry_number("1.5"), 1.5);
  EXPECT_EQ(parse_photometry_number("+1.4568E+0010"), 1.4568e10);
  EXPECT_EQ(parse_photometry_number("2.5D2"), 250.0);
  EXPECT_EQ(parse_photometry_number("1d-3"), 1e-3);
  EXPECT_EQ(parse_photometry_number("-.5"), -0.5);
  for (const char* bad : {"", "nan", "inf", "0x10", "1,5", "12a", "0-5", "1e999", "d", "--1"}) {
    EXPECT_FALSE(parse_photometry_number(bad)) << bad;
  }
}

}  // namespace
}  // namespace calc::number_stream_test
