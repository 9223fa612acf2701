#include "report/git/lfs_pointer.h"

#include <gtest/gtest.h>

#include <string>

namespace lfs_pointer_test {
namespace {

const std::string kHead = "version https://git-lfs.github.com/spec/v1\n";
const std::string kHash(64, 'a');

TEST(LfsPointer, IsRead) {
  const auto pointer =
      git::parse_lfs_pointer(kHead + "ext-0-x sha256:1\noid sha256:" + kHash + "\nsize 12345\n");
  ASSERT_TRUE(pointer);
  EXPECT_EQ(pointer->sha256, kHash);
  EXPECT_EQ(pointer->size_bytes, 12345u);
}

TEST(LfsPointer, NeedsAHashAndASize) {
  for (const std::string& rest :
       {std::string(), "oid sha256:" + kHash + "\n", std::string("size 1\n"),
        "oid sha256:" + kHash + "a\nsize 1\n", "oid sha256:../" + kHash.substr(3) + "\nsize 1\n",
        "oid md5:" + kHash + "\nsize 1\n", "oid sha256:" + kHash + "\nsize -1\n",
        "oid sha256:" + kHash + "\nsize 1x\n",
        "oid sha256:" + kHash + "\nsize 99999999999999999999\n"}) {
    EXPECT_TRUE(git::is_lfs_pointer(kHead + rest)) << rest;
    EXPECT_FALSE(git::parse_lfs_pointer(kHead + rest)) << rest;
  }
}

TEST(LfsPointer, IsShortAndSaysSo) {
  EXPECT_FALSE(git::is_lfs_pointer("IESNA:LM-63-2002\n"));
  EXPECT_FALSE(git::is_lfs_pointer(kHead + std::string(1024, ' ')));
  EXPECT_FALSE(git::is_lfs_pointer(""));
}

}  // namespace
}  // namespace lfs_pointer_test
