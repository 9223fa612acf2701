#include "report/shell/output/outputs.h"

#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "tests/support/scratch_folder.h"

namespace outputs_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Outputs : public ::testing::Test {
 protected:
  void SetUp() override {
    inputs_ = {path("project.xml")};
    options_.quiet = true;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void add(const char* format, const std::string& name) {
    options_.formats.push_back({report::find_format(format), path(name)});
  }

  const test_support::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  cli::OutputOptions options_;
  std::vector<std::string> inputs_;
};

TEST_F(Outputs, FolderMeansItsFilesBesideTheNamedOnes) {
  options_.formats = {{report::find_format("json"), ""}, {report::find_format("csv"), "own.csv"}};
  options_.folder = "out";
  std::vector<std::string> names;
  for (const cli::OutputFormat& file : cli::planned_files(options_)) names.push_back(file.file);
  EXPECT_THAT(names,
              ::testing::ElementsAre("own.csv", "out/results.csv", "out/points.csv",
                                     "out/luminaires.csv", "out/result.json", "out/report.html"));
}

TEST_F(Outputs, NewFoldersAreFineAndNotMadeByChecking) {
  options_.folder = path("a/b");
  EXPECT_EQ(cli::check_outputs(options_, inputs_), "");
  EXPECT_FALSE(fs::exists(path("a")));
}

TEST_F(Outputs, NeverOverwritesAnInput) {
  add("csv", "sub/../project.xml");
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("is an input"));
}

TEST_F(Outputs, RefusesTheSameFileTwice) {
  options_.folder = path("");
  add("json", "result.json");
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("written twice"));
}

TEST_F(Outputs, RefusesAFolderWhereAFileShouldBe) {
  fs::create_directories(path("taken"));
  add("html", "taken");
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("it is a folder"));
}

TEST_F(Outputs, RefusesAFileWhereAFolderShouldBe) {
  std::ofstream(path("file")) << "x";
  add("html", "file/report.html");
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("is not a folder"));
}

TEST_F(Outputs, PagesOfRoomsAreInFoldersOfTheirOwn) {
  options_.html_split = true;
  add("html", "büro.html");
  add("html", "bäro.html");
  add("html", "bäro.htm");
  EXPECT_EQ(cli::check_outputs(options_, inputs_), "");
  report::Document document;
  document.projects.resize(1);
  document.projects[0].spaces.resize(1);
  EXPECT_TRUE(cli::write_results(options_, {}, document, {}));
  for (const char* page :
       {"büro.html-rooms/p1s1.html", "bäro.html-rooms/p1s1.html", "bäro.htm-rooms/p1s1.html"}) {
    EXPECT_TRUE(fs::exists(path(page))) << page;
  }
  std::ifstream index(path("büro.html"));
  const std::string html((std::istreambuf_iterator<char>(index)), {});
  EXPECT_THAT(html, HasSubstr("href=\"b%C3%BCro.html-rooms/p1s1.html\""));
}

TEST_F(Outputs, PagesOfRoomsArePlannedFiles) {
  options_.html_split = true;
  add("html", "r.html");
  add("json", "r.html-rooms/p1s2-3.html");
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("written twice"));
  options_.formats.back().file = path("r.html-rooms/result.json");
  EXPECT_EQ(cli::check_outputs(options_, inputs_), "");
  inputs_ = {path("sub/../r.html-rooms/p1s1.html")};
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("is an input"));
  options_.html_split = false;
  EXPECT_EQ(cli::check_outputs(options_, inputs_), "");
  options_.html_split = true;
  inputs_ = {path("project.xml")};
  std::ofstream(path("r.html-rooms")) << "x";
  options_.formats.pop_back();
  EXPECT_THAT(cli::check_outputs(options_, inputs_), HasSubstr("is not a folder"));
}

// Nothing but pages is removed, and no input.
TEST_F(Outputs, PagesOfAnEarlierRunAreRemoved) {
  options_.html_split = true;
  add("html", "r.html");
  fs::create_directories(path("r.html-rooms/p9s9.html"));
  for (const char* name : {"p1s1.html", "p1s2.html", "p12s3-4.html", "p2s1.html", "notes.html",
                           "p1s.html", "p1s2-.html", "p1s2.html.bak", "xp1s2.html"})
    std::ofstream(path("r.html-rooms/") + name) << "old";
  report::Document document;
  document.projects.resize(1);
  document.projects[0].spaces.resize(1);
  EXPECT_TRUE(cli::write_results(options_, {}, document, {path("r.html-rooms/p2s1.html")}));
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(path("r.html-rooms")))
    left.insert(entry.path().filename().string());
  EXPECT_EQ(left, (std::set<std::string>{"p1s1.html", "p2s1.html", "p9s9.html", "notes.html",
                                         "p1s.html", "p1s2-.html", "p1s2.html.bak", "xp1s2.html"}));
}

TEST_F(Outputs, ImageNamesAreSafeFileNames) {
  report::ProjectPart project;
  project.path = "some/where/my office.xml";
  report::PlanePart plane;
  plane.id = "desk:1/é";
  EXPECT_EQ(cli::image_stem(project, plane),
            "my_office-desk_1__");  // one _ per character, however many bytes it has
}

TEST_F(Outputs, LanguageIsForReadersAlone) {
  const report::Document document = report::sample_document();
  const report::Texts german(report::Language::german, true);
  const std::set<std::string_view> for_people = {"dxf", "html", "pdf", "markdown", "text", "xlsx"};
  for (const report::Format& format : report::formats()) {
    const std::string in_german = format.render(document, {{}, german});
    const std::string in_english = format.render(document, {});
    if (!for_people.contains(format.name)) {
      EXPECT_EQ(in_german, in_english) << format.name;
      continue;
    }
    EXPECT_NE(in_german, in_english) << format.name;
    if (format.name == "xlsx") continue;  // compressed
    EXPECT_THAT(in_german, HasSubstr("nicht bewertet"));
    EXPECT_THAT(in_english, ::testing::Not(HasSubstr("nicht bewertet")));
  }
}

TEST_F(Outputs, FilesAndSplitPagesAreInTheLanguageOfTheOptions) {
  options_.language = report::Language::german;
  const auto file_text = [this](const std::string& name) {
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  add("html", "report.html");
  add("csv", "results.csv");
  const report::Document document = report::sample_document();
  EXPECT_TRUE(cli::write_results(options_, {}, document, {}));
  EXPECT_THAT(file_text("report.html"), HasSubstr("<html lang=\"de\">"));
  EXPECT_EQ(file_text("results.csv"), report::rendered("csv", document));
  options_.html_split = true;
  EXPECT_TRUE(cli::write_results(options_, {}, document, {}));
  EXPECT_THAT(file_text("report.html"), HasSubstr("Anforderungen"));
  EXPECT_THAT(file_text("report.html-rooms/p1s1.html"), HasSubstr("<html lang=\"de\">"));
}

}  // namespace
}  // namespace outputs_test
