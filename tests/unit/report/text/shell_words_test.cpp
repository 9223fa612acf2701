#include "report/text/shell_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>

namespace report::shell_words_test {
namespace {

using testing::ElementsAre;

TEST(ShellWords, OnlyWhatIsSpecialIsQuoted) {
  EXPECT_EQ(shell_quoted("a/b-c_1.xml"), "a/b-c_1.xml");
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("my room"), "'my room'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
}

TEST(ShellWords, ReadsBackWhatItQuotes) {
  const std::vector<std::string> words = {"luxgate", "",      "a b",    "it's", "''",
                                          "\\",      "$HOME", "a\tb\n", " x "};
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_quoted(word);
  EXPECT_EQ(shell_words(line), words);
}

TEST(ShellWords, ReadsOtherLines) {
  EXPECT_THAT(shell_words("  a   b\\ c 'd e' "), ElementsAre("a", "b c", "d e"));
  EXPECT_THAT(shell_words("a 'b c"), ElementsAre("a", "b c"));
  EXPECT_THAT(shell_words("a\\"), ElementsAre("a\\"));
  EXPECT_THAT(shell_words(""), ElementsAre());
}

}  // namespace
}  // namespace report::shell_words_test
