#include "rules/pack/pack_elements.h"

#include "calc/base/file_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace rules {
namespace {

TEST(RulePackSchema, IsThePublishedFile) {
  const char* const kPath = "rules/pack/luxgate-rules-1.xsd";
  const calc::FileContent file =
      calc::DiskFileReader().read((std::filesystem::path(LUXGATE_SOURCE_DIR) / kPath).string());
  ASSERT_TRUE(file.ok()) << file.error;
  EXPECT_EQ(rule_pack_schema(), file.bytes) << "renew it: luxgate rules schema > " << kPath;
}

}  // namespace
}  // namespace rules
