#include "rules/pack/pack_elements.h"

#include "calc/base/file_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace rules::pack_elements_test {
namespace {

TEST(RulePackSchema, IsThePublishedFile) {
  const char* const kPath = "rules/pack/luxgate-rules-1.xsd";
  const calc::FileContent file =
      calc::DiskFileReader().read((std::filesystem::path(LUXGATE_SOURCE_DIR) / kPath).string());
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_TRUE(rule_pack_schema() == file.bytes)
      << "not what the tables say; renew it: luxgate rules schema > " << kPath;
}

}  // namespace
}  // namespace rules::pack_elements_test
