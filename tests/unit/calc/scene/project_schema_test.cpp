// The schema in the library, and the reader on the corpus that xmllint checks against the schema
// (tests/schema).

#include "calc/scene/project_xml.h"
#include "tests/unit/calc/scene/project_xml_support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace calc::testing {
namespace {

const std::filesystem::path kSource = LUXGATE_SOURCE_DIR;

TEST(ProjectSchema, IsTheFileInTheSourceTree) {
  const FileContent file =
      DiskFileReader().read((kSource / "calc/scene/luxgate-project-1.xsd").string());
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_EQ(project_schema(), file.bytes);
}

TEST(ProjectSchema, ReaderAgreesOnTheCorpus) {
  std::size_t valid = 0, invalid = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "tests/schema/corpus")) {
    const std::string name = entry.path().filename().string();
    const FileContent file = DiskFileReader().read(entry.path().string());
    ASSERT_TRUE(file.ok()) << name << ": " << file.error;
    const Loaded loaded = load(file.bytes);
    const bool should_be_valid = name.starts_with("valid-");
    ASSERT_TRUE(should_be_valid || name.starts_with("invalid-")) << name;
    EXPECT_EQ(loaded.project.has_value(), should_be_valid) << name << '\n' << loaded.messages;
    ++(should_be_valid ? valid : invalid);
  }
  EXPECT_GE(valid, 5u);
  EXPECT_GE(invalid, 15u);
}

}  // namespace
}  // namespace calc::testing
