#include "report/shell/options/project_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace cli::project_options_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> parsed(const std::string& bytes) {
  std::string problem;
  std::vector<std::string> projects = parse_project_list(bytes, problem);
  EXPECT_EQ(problem, "");
  return projects;
}

std::string problem_of(const std::string& bytes) {
  std::string problem;
  EXPECT_THAT(parse_project_list(bytes, problem), IsEmpty());
  return problem;
}

TEST(ProjectList, HasAPathALine) {
  EXPECT_THAT(parsed("a.xml\n b c.xml \n\n#d.xml"), ElementsAre("a.xml", " b c.xml ", "#d.xml"));
}

TEST(ProjectList, MayComeFromWindows) {
  EXPECT_THAT(parsed("\xef\xbb\xbf"
                     "a.xml\r\nb.xml\r\n"),
              ElementsAre("a.xml", "b.xml"));
  EXPECT_EQ(problem_of(std::string("\xff\xfe"
                                   "a\0",
                                   4)),
            "it is UTF-16; UTF-8 is allowed");
}

TEST(ProjectList, MayHaveZerosBehindPaths) {
  EXPECT_THAT(parsed(std::string("a\nb.xml\0c.xml\r\0", 15)), ElementsAre("a\nb.xml", "c.xml\r"));
}

TEST(ProjectList, ThatIsEmptyIsAnError) {
  for (const std::string text : {"", "\n\n", "\r\n"}) {
    EXPECT_EQ(problem_of(text), "it names no project");
  }
}

TEST(ProjectList, IsReadAsItIsWritten) {
  const std::vector<std::string> plain = {"a.xml", "it's $HOME.xml"}, odd = {"a\nb.xml", "c.xml"};
  EXPECT_EQ(render_project_list(plain), "a.xml\nit's $HOME.xml\n");
  EXPECT_EQ(parsed(render_project_list(plain)), plain);
  EXPECT_EQ(parsed(render_project_list(odd)), odd);
}

TEST(ProjectOptions, TakeTheListBehindTheOthers) {
  const test_support::ScratchFolder folder;
  const std::string file = folder.path() / "projects.txt";
  std::ofstream(file) << "b.xml\nc.xml\n";
  ProjectOptions options{{"a.xml"}, file, {}, {}};
  EXPECT_EQ(complete_projects(options), "");
  EXPECT_THAT(options.projects, ElementsAre("a.xml", "b.xml", "c.xml"));
}

TEST(ProjectOptions, SayWhatIsWrong) {
  ProjectOptions none;
  EXPECT_EQ(complete_projects(none), "no project: PROJECT.xml or --files-from is needed");
  ProjectOptions twice{{"a/b.xml", "c.xml", "a/./b.xml"}, "", {}, {}};
  EXPECT_EQ(complete_projects(twice), "project 'a/./b.xml' is given twice");
  ProjectOptions id{{"light-leaves-room"}, "", {}, {}};
  EXPECT_THAT(complete_projects(id), testing::HasSubstr("write --strict="));
  ProjectOptions absent{{}, "/nowhere.txt", {}, {}};
  EXPECT_EQ(complete_projects(absent),
            "--files-from: cannot read '/nowhere.txt': No such file or directory");
  ProjectOptions folder{{}, testing::TempDir(), {}, {}};
  EXPECT_THAT(complete_projects(folder), testing::HasSubstr("Is a directory"));
}

}  // namespace
}  // namespace cli::project_options_test
