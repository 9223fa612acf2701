// The schema in the library. On what is a project it is compared with the readers by
// unit/rules/binding/judged_project_test.cpp, since part of the grammar is in rules/.

#include "calc/project/project_xml.h"

#include "calc/base/file_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace calc::testing {
namespace {

const std::filesystem::path kSource = LUXGATE_SOURCE_DIR;

TEST(ProjectSchema, IsTheFileInTheSourceTree) {
  const FileContent file =
      DiskFileReader().read((kSource / "calc/project/luxgate-project-1.xsd").string());
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_EQ(project_schema(), file.bytes);
}

}  // namespace
}  // namespace calc::testing
