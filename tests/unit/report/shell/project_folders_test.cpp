#include "report/shell/project_folders.h"

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

TEST(ProjectFolder, RootElementBehindWhatMayStandBeforeIt) {
  EXPECT_EQ(root_element("<luxgate version='1'/>"), "luxgate");
  EXPECT_EQ(root_element("\xef\xbb\xbf<?xml version='1.0'?>\n<!-- <a> -- -->\r\n<b/>"), "b");
  EXPECT_EQ(root_element("<luxgate>"), "luxgate");
  for (const std::string text : {"", "  ", "text", "<!-- no end", "<lux", "<?xml", "<!",
                                 "\xff\xfe<", "<!DOCTYPE x [<!ENTITY a '> <b>'>]><luxgate/>"}) {
    EXPECT_EQ(root_element(text), "") << text;
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
  std::vector<std::string> out{here + "/a"};
  EXPECT_THAT(expand_folders(out),
              HasSubstr("/a/link.xml' is a link that leads out of the folder"));
  std::vector<std::string> none{here + "/none"};
  EXPECT_THAT(expand_folders(none), HasSubstr("no project (*.xml) in the folder '"));
}

}  // namespace
}  // namespace cli::project_folders_test
