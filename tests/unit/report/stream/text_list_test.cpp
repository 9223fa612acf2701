#include "report/stream/text_list.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace report::text_list_test {
namespace {

TEST(TextList, ComesBackInItsOrder) {
  std::vector<std::string> texts{"", std::string("\0\n", 2), "a", std::string(200000, 'x'), ""};
  for (int i = 0; i < 10000; ++i) texts.push_back("line " + std::to_string(i));
  for (const std::size_t most : {std::size_t{100}, std::size_t{1} << 20}) {
    TextList list({testing::TempDir(), most});
    EXPECT_TRUE(TextListReader(list).is_at_end());
    for (const std::string& text : texts) list.add(text);
    TextListReader reader(list);
    for (const std::string& text : texts) {
      ASSERT_FALSE(reader.is_at_end());
      ASSERT_EQ(reader.next(), text);
    }
    EXPECT_TRUE(reader.is_at_end());
  }
}

}  // namespace
}  // namespace report::text_list_test
