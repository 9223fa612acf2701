#include "rules/binding/project_schema.h"

#include "calc/base/file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace rules::project_schema_test {
namespace {

using testing::HasSubstr;

void expect_published(const char* path, const std::string& text, const char* command) {
  const calc::FileContent file =
      calc::DiskFileReader().read((std::filesystem::path(LUXGATE_SOURCE_DIR) / path).string());
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_TRUE(text == file.bytes) << "not what the tables say; renew it: " << command << " > "
                                  << path;
}

TEST(ProjectSchema, IsThePublishedFile) {
  expect_published("calc/project/luxgate-project-1.xsd", project_schema(), "luxgate schema");
}

TEST(ProjectReference, IsThePublishedFile) {
  expect_published("calc/project/project-format.md", project_reference(),
                   "luxgate schema --markdown");
}

TEST(ProjectReference, HasEveryElementWithItsParentsAndAttributes) {
  const std::string page = project_reference();
  EXPECT_THAT(page, HasSubstr("\n## `<plane>`\n"));
  EXPECT_THAT(page, HasSubstr("\n| `reflectance` (needed) | "));
  EXPECT_THAT(page, HasSubstr("| `m`, `cm`, `mm`, `in`, `ft`"));
  for (const calc::ElementRow& row : rows_about_rules()) {
    for (const calc::AttributeRow& attribute : row.attributes) {
      EXPECT_THAT(page, HasSubstr("\n| `" + std::string(attribute.name) + "`")) << row.type;
    }
  }
}

}  // namespace
}  // namespace rules::project_schema_test
