#include "calc/base/line_cursor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::line_cursor_test {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  LineCursor cursor(text);
  std::vector<std::string> lines;
  while (const auto line = cursor.next()) lines.emplace_back(*line);
  EXPECT_EQ(cursor.line(), static_cast<int>(lines.size()));
  return lines;
}

TEST(LineCursor, SplitsAtEveryKindOfLineEnd) {
  EXPECT_THAT(lines_of("a\nb\r\nc\rd"), testing::ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(lines_of("a\r\n\r\nb\n"), testing::ElementsAre("a", "", "b"));
  EXPECT_THAT(lines_of("\n"), testing::ElementsAre(""));
  EXPECT_THAT(lines_of(""), testing::IsEmpty());
}

TEST(LineCursor, CountsWhatIsLeftWithoutBlankLinesAtTheEnd) {
  LineCursor cursor("a\n\nb\n \n\r\n");
  EXPECT_EQ(cursor.count_remaining(), 3U);
  cursor.next();
  EXPECT_EQ(cursor.count_remaining(), 2U);
  EXPECT_EQ(cursor.rest(), "\nb\n \n\r\n");
}

}  // namespace
}  // namespace calc::line_cursor_test
