#include "report/text/base64.h"

#include <gtest/gtest.h>

#include <string>

namespace report::base64_test {
namespace {

TEST(Base64, IsReadBack) {
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("f"), "Zg==");
  std::string bytes;
  for (int i = 0; i < 600; ++i) {
    EXPECT_EQ(bytes_of_base64(base64(bytes)), bytes);
    bytes += static_cast<char>(i * 7);
  }
}

TEST(Base64, OnlyWhatItWritesItselfIsRead) {
  for (const char* text :
       {"Z", "Zg", "Zg=", "Zh==", "Zg===", "Z===", "Zm 9", "Zm9v\n", "Zm9-", "="}) {
    EXPECT_FALSE(bytes_of_base64(text)) << text;
  }
  EXPECT_EQ(bytes_of_base64(""), "");
}

}  // namespace
}  // namespace report::base64_test
