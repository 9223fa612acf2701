#include "calc/base/file_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace calc::file_reader_test {
namespace {

namespace fs = std::filesystem;

class DiskFiles : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "project/lamps");
    fs::create_directories(folder_ / "elsewhere");
    std::ofstream(folder_ / "project/lamps/MIREL_42925637.ldt") << "x";
    std::ofstream(folder_ / "elsewhere/MIREL_42925639.ldt") << "x";
  }
  std::string error_of(const std::string& name) const {
    const std::string project = (folder_ / "project").string();
    return DiskFileReader().read_within(project, project + "/" + name).error;
  }

  const test_support::ScratchFolder scratch_;
  const fs::path folder_ = fs::canonical(scratch_.path());
};

TEST_F(DiskFiles, NameOneThatIsSpeltAlike) {
  EXPECT_EQ(error_of("lamps/MIREL_42925637.ldt"), "");
  EXPECT_EQ(error_of("lamps/MIREL_4292563.ldt"),
            "No such file or directory; did you mean 'MIREL_42925637.ldt'?");
  EXPECT_EQ(error_of("lamps/other.ldt"), "No such file or directory");
  EXPECT_EQ(error_of("gone/MIREL_42925637.ldt"), "No such file or directory");
}

TEST_F(DiskFiles, NameTheOneThatDiffersInCaseOrSlashes) {
  fs::create_directories(folder_ / "project/a/B");
  std::ofstream(folder_ / "project/a/B/c.IES") << "x";
  for (const char* name : {"Lamps/mirel_42925637.LDT", "lamps\\MIREL_42925637.ldt",
                           "LAMPS\\mirel_42925637.ldt", ".\\lamps\\MIREL_42925637.ldt"}) {
    EXPECT_EQ(error_of(name), "No such file or directory; there is 'lamps/MIREL_42925637.ldt'")
        << name;
  }
  EXPECT_EQ(error_of("A/b\\C.ies"), "No such file or directory; there is 'a/B/c.IES'");
  EXPECT_EQ(error_of("A/b"), "No such file or directory");  // a folder is not a file
  // Without a folder to stay in the whole path is named.
  const std::string whole = (folder_ / "project/a/B/c.IES").string();
  EXPECT_EQ(DiskFileReader().read((folder_ / "project/A\\b/c.ies").string()).error,
            "No such file or directory; there is '" + whole + "'");
}

TEST_F(DiskFiles, NameNothingOutsideForAnotherSpelling) {
  fs::create_symlink(folder_ / "elsewhere", folder_ / "project/link");
  for (const char* name :
       {"Link/mirel_42925639.LDT", "lamps\\..\\..\\elsewhere\\x.ldt", "LINK\\MIREL_42925639.ldt"}) {
    EXPECT_EQ(error_of(name).find("42925639"), std::string::npos) << name;
    EXPECT_EQ(error_of(name).find("there is"), std::string::npos) << name;
  }
}

// Whoever may put links into a project must not learn what there is elsewhere.
TEST_F(DiskFiles, NameNothingOfAnotherFolder) {
  fs::create_symlink(folder_ / "elsewhere", folder_ / "project/link");
  EXPECT_EQ(error_of("link/MIREL_42925638.ldt").find("42925639"), std::string::npos);
}

TEST_F(DiskFiles, NeverNameALinkToNowhereItself) {
  fs::create_symlink("nowhere.ldt", folder_ / "project/lamp.ldt");
  EXPECT_EQ(error_of("lamp.ldt"), "No such file or directory");
}

}  // namespace
}  // namespace calc::file_reader_test
