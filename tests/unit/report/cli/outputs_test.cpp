#include "report/cli/outputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Outputs : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("luxgate_outputs_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    options_.projects = {path("project.xml")};
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void add(cli::FormatKind kind, const std::string& name) {
    options_.formats.push_back({kind, path(name)});
  }

  fs::path folder_;
  cli::Options options_;
};

TEST_F(Outputs, FolderMeansFourFilesBesideTheNamedOnes) {
  options_.formats = {{cli::FormatKind::json, ""}, {cli::FormatKind::csv, "own.csv"}};
  options_.output_folder = "out";
  std::vector<std::string> names;
  for (const cli::OutputFormat& file : cli::planned_files(options_)) names.push_back(file.file);
  EXPECT_THAT(names, ::testing::ElementsAre("own.csv", "out/results.csv", "out/points.csv",
                                            "out/result.json", "out/report.html"));
}

TEST_F(Outputs, NewFoldersAreFineAndNotMadeByChecking) {
  options_.output_folder = path("a/b");
  EXPECT_EQ(cli::check_outputs(options_), "");
  EXPECT_FALSE(fs::exists(path("a")));
}

TEST_F(Outputs, NeverOverwritesAnInput) {
  add(cli::FormatKind::csv, "sub/../project.xml");
  EXPECT_THAT(cli::check_outputs(options_), HasSubstr("is an input"));
}

TEST_F(Outputs, RefusesTheSameFileTwice) {
  options_.output_folder = path("");
  add(cli::FormatKind::json, "result.json");
  EXPECT_THAT(cli::check_outputs(options_), HasSubstr("written twice"));
}

TEST_F(Outputs, RefusesAFolderWhereAFileShouldBe) {
  fs::create_directories(path("taken"));
  add(cli::FormatKind::html, "taken");
  EXPECT_THAT(cli::check_outputs(options_), HasSubstr("it is a folder"));
}

TEST_F(Outputs, RefusesAFileWhereAFolderShouldBe) {
  std::ofstream(path("file")) << "x";
  add(cli::FormatKind::html, "file/report.html");
  EXPECT_THAT(cli::check_outputs(options_), HasSubstr("is not a folder"));
}

TEST_F(Outputs, ImageNamesAreSafeFileNames) {
  report::ProjectPart project;
  project.path = "some/where/my office.xml";
  report::PlanePart plane;
  plane.id = "desk:1/é";
  EXPECT_EQ(cli::image_stem(project, plane),
            "my_office-desk_1__");  // one _ per character, however many bytes it has
}

}  // namespace
