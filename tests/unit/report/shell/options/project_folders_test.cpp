#include "report/shell/options/project_folders.h"

#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cli::project_folders_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ProjectFolder, WhatMayBeAProjectIsToldByItsRoot) {
  EXPECT_TRUE(may_be_project("<luxgate version='1'/>"));
  EXPECT_TRUE(may_be_project("<Luxgate>")) << "refused by the reader, with words";
  EXPECT_FALSE(may_be_project("\xef\xbb\xbf<?xml version='1.0'?>\n<!-- <a> -- -->\r\n<b/>"));
  EXPECT_FALSE(may_be_project("<rule-pack/>"));
  // Where it cannot be told, no design must be lost.
  using namespace std::string_literals;
  for (const std::string& text :
       {""s, "  "s, "text"s, "<!-- no end"s, "<lux"s, "<?xml"s, "<!"s, "\xff\xfe<"s,
        "<!DOCTYPE x [<!ENTITY a '> <b>'>]><luxgate/>"s, "<\0b\0 \0/\0>\0"s, "\0<\0b\0 "s}) {
    EXPECT_TRUE(may_be_project(text)) << text;
  }
}

TEST(ProjectFolder, StandsForItsProjectsInOrder) {
  const test_support::ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path();
  const auto write = [&](const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  };
  write("b.xml", "<luxgate/>");
  write("a/z.xml", "<?xml version='1.0'?><luxgate/>");
  write("a/broken.xml", "<luxgate");
  write("a/pack.xml", "<rule-pack/>");
  write("a/notes.txt", "<luxgate/>");
  write(".git/c.xml", "<luxgate/>");
  write(".hidden.xml", "<luxgate/>");
  write("none/pack.xml", "<rule-pack/>");
  const std::string here = folder.string();
  std::vector<std::string> projects{"x.xml", here, "y.xml"};
  EXPECT_EQ(expand_folders(projects), "");
  EXPECT_THAT(projects, ElementsAre("x.xml", here + "/a/broken.xml", here + "/a/z.xml",
                                    here + "/b.xml", "y.xml"));
  std::filesystem::create_symlink("b.xml", folder / "c.xml");
  std::vector<std::string> linked{here};
  EXPECT_EQ(expand_folders(linked), "");
  EXPECT_EQ(linked.back(), here + "/c.xml");
  std::filesystem::create_symlink("../b.xml", folder / "a" / "link.xml");
  std::vector<std::string> within{here};
  EXPECT_EQ(expand_folders(within), "");
  std::vector<std::string> none{here + "/none"};
  EXPECT_THAT(expand_folders(none), HasSubstr("no project (*.xml) in the folder '"));
}

// What looks like a design stands among the projects: it is judged, or an error names it.
TEST(ProjectFolder, LeavesNoDesignOutInSilence) {
  const test_support::ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "designs", elsewhere = scratch.path() / "e";
  std::filesystem::create_directories(folder / "own");
  std::filesystem::create_directories(elsewhere / "with" / "deep");
  std::filesystem::create_directories(elsewhere / "without");
  std::ofstream(folder / "own" / "OFFICE.XML") << "<luxgate/>";
  std::ofstream(folder / "other.xml") << "<Luxgate/>";
  std::ofstream(folder / "unmarked.xml") << std::string("<\0l\0u\0x\0 \0", 10);
  std::ofstream(elsewhere / "with" / "deep" / "a.xml") << "<luxgate/>";
  std::ofstream(elsewhere / "without" / "lamp.ies") << "IESNA";
  std::filesystem::create_symlink("own", folder / "again");  // judged as own/
  std::filesystem::create_symlink("nowhere.xml", folder / "dangling.xml");
  std::filesystem::create_symlink("../e/with/deep/a.xml", folder / "out.xml");
  std::filesystem::create_symlink("../e/with", folder / "storey");
  std::filesystem::create_symlink("../e/without", folder / "photometry");
  std::vector<std::string> projects{folder.string()};
  EXPECT_EQ(expand_folders(projects), "");
  const std::string here = folder.string();
  EXPECT_THAT(projects,
              ElementsAre(here + "/dangling.xml", here + "/other.xml", here + "/out.xml",
                          here + "/own/OFFICE.XML", here + "/storey", here + "/unmarked.xml"));
}

}  // namespace
}  // namespace cli::project_folders_test
