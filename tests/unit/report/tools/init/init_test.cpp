#include "report/tools/init/init.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;

TEST(Init, WritesNothingWhenOneOfItsFilesExists) {
  const fs::path folder = fs::path(::testing::TempDir()) / "luxgate_init_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::ofstream(folder / "project.xml") << "mine";

  const cli::InitResult result = cli::write_starter_project(folder.string());
  EXPECT_THAT(result.error, ::testing::HasSubstr("exists already"));
  EXPECT_FALSE(fs::exists(folder / "photometry"));
  EXPECT_EQ(fs::file_size(folder / "project.xml"), 4u);
  fs::remove_all(folder);
}

}  // namespace
