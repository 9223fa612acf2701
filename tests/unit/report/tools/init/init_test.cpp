#include "report/tools/init/init.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/scratch_folder.h"

namespace init_test {
namespace {

namespace fs = std::filesystem;

TEST(Init, WritesNothingWhenOneOfItsFilesExists) {
  const test_support::ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  std::ofstream(folder / "project.xml") << "mine";

  const cli::InitResult result = cli::write_starter_project(folder.string());
  EXPECT_THAT(result.error, ::testing::HasSubstr("exists already"));
  EXPECT_FALSE(fs::exists(folder / "photometry"));
  EXPECT_EQ(fs::file_size(folder / "project.xml"), 4u);
}

}  // namespace
}  // namespace init_test
