#include "rules/binding/project_schema.h"

#include "calc/base/file_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace rules {
namespace {

TEST(ProjectSchema, IsThePublishedFile) {
  const char* const kPath = "calc/project/luxgate-project-1.xsd";
  const calc::FileContent file =
      calc::DiskFileReader().read((std::filesystem::path(LUXGATE_SOURCE_DIR) / kPath).string());
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_EQ(project_schema(), file.bytes) << "renew it: luxgate schema > " << kPath;
}

}  // namespace
}  // namespace rules
