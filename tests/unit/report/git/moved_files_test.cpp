#include "report/git/moved_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

namespace moved_files_test {
namespace {

using testing::ElementsAre;
using Match = std::optional<std::size_t>;

TEST(MatchMoved, TakesTheMostSimilarFirst) {
  EXPECT_THAT(
      git::match_moved({"a\nb\nc\nd\n", "a\nb\nc\nx\n"}, {"a\nb\nc\nx\n", "a\nb\nc\nd\n", "q\n"}),
      ElementsAre(Match(1), Match(0)));
  // The second is the same as the one that is gone, and the first only like it.
  EXPECT_THAT(git::match_moved({"a\nb\nc\nd\n", "a\nb\nc\nx\n"}, {"a\nb\nc\nx\n"}),
              ElementsAre(std::nullopt, Match(0)));
}

TEST(MatchMoved, NeedsHalfOfTheLines) {
  EXPECT_THAT(git::match_moved({"a\nb\nx\ny\n"}, {"d\na\ne\nb\n"}), ElementsAre(Match(0)));
  EXPECT_THAT(git::match_moved({"a\nx\ny\n"}, {"a\nb\nc\n"}), ElementsAre(std::nullopt));
  EXPECT_THAT(git::match_moved({"a\n"}, {"a\nb\nc\n"}), ElementsAre(std::nullopt));
  EXPECT_THAT(git::match_moved({"a\n"}, {}), ElementsAre(std::nullopt));
}

TEST(MatchMoved, TakesEqualOnesInOrder) {
  EXPECT_THAT(git::match_moved({"a\n", "a\n", "a\n"}, {"a\n", "a\n"}),
              ElementsAre(Match(0), Match(1), std::nullopt));
}

}  // namespace
}  // namespace moved_files_test
