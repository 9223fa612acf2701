#include "calc/project/reading/project_files.h"
#include "calc/base/relative_path.h"

#include <gtest/gtest.h>

namespace calc::project_files_test {
namespace {

TEST(NormalizeRelativePath, RemovesDotsAndDoubleSlashes) {
  EXPECT_EQ(normalize_relative_path("a.ies"), "a.ies");
  EXPECT_EQ(normalize_relative_path("./a//b/./c.ies"), "a/b/c.ies");
  EXPECT_EQ(normalize_relative_path("a/../b.ies"), "b.ies");
  EXPECT_EQ(normalize_relative_path("a/b/../../c.ies"), "c.ies");
  EXPECT_EQ(normalize_relative_path("..a/b..ies"), "..a/b..ies");
}

TEST(NormalizeRelativePath, RefusesWhatLeavesTheFolder) {
  for (const char* path :
       {"..", "../a", "a/../../b", "./../a", "/a", "\\a", "C:\\a", "c:/a", "//a"}) {
    EXPECT_FALSE(normalize_relative_path(path)) << path;
  }
}

}  // namespace
}  // namespace calc::project_files_test
