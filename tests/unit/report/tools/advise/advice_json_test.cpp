#include "report/tools/advise/advice.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace cli::advice_json_test {
namespace {

// The published file is written by the program: 'luxgate schema --advice > advice.schema.json'.
TEST(AdviceSchema, IsThePublishedFile) {
  std::ifstream file(LUXGATE_ADVICE_SCHEMA, std::ios::binary);
  const std::string published((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(advice_schema(), published);
}

}  // namespace
}  // namespace cli::advice_json_test
