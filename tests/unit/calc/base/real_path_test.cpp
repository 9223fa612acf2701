#include "calc/base/real_path.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace calc::real_path_test {
namespace {

namespace fs = std::filesystem;

class RealPath : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "a/b");
    std::ofstream(folder_ / "a/file") << "x";
  }
  void link(const std::string& name, const fs::path& to) const {
    fs::create_symlink(to, folder_ / name);
  }
  std::string of(const std::string& name) const { return real_path(folder_ / name).string(); }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }

  const test_support::ScratchFolder scratch_;
  const fs::path folder_ = fs::canonical(scratch_.path());
};

TEST_F(RealPath, IsTheCanonicalOneOfWhatIsThere) {
  link("to_file", "a/file");
  link("to_folder", folder_ / "a");
  for (const char* name :
       {"a/file", "a/b/../file", "to_file", "to_folder/b/./../file", "a//file"}) {
    EXPECT_EQ(of(name), fs::canonical(folder_ / name).string()) << name;
  }
  EXPECT_EQ(real_path("."), fs::current_path());
  EXPECT_EQ(real_path("/../.."), fs::path("/"));
}

TEST_F(RealPath, FollowsLinksToWhatIsNotThere) {
  link("to_nothing", "a/none");
  link("chain", "to_nothing");
  link("away", "/nowhere/at/all");
  EXPECT_EQ(of("to_nothing"), at("a/none"));
  EXPECT_EQ(of("chain"), at("a/none"));
  EXPECT_EQ(of("chain/x"), at("a/none/x"));
  EXPECT_EQ(of("away/x"), "/nowhere/at/all/x");
  EXPECT_EQ(of("missing/../x"), at("x"));
}

TEST_F(RealPath, EndsInACircle) {
  link("one", "two");
  link("two", "one");
  const std::string path = of("one");
  EXPECT_TRUE(path == at("one") || path == at("two")) << path;
}

}  // namespace
}  // namespace calc::real_path_test
