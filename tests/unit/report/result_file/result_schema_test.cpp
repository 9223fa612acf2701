#include "report/result_file/result_schema.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace report::result_schema_test {
namespace {

using nlohmann::json;

// The published file is written by the program: 'luxgate schema --result > result.schema.json'.
TEST(ResultSchema, IsThePublishedFile) {
  std::ifstream file(LUXGATE_RESULT_SCHEMA, std::ios::binary);
  const std::string published((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(result_schema(), published);
}

// What a reader needs is required, and what only some results have is not.
TEST(ResultSchema, RequiresWhatEveryResultHas) {
  const json plane = json::parse(result_schema())["definitions"]["plane"];
  const auto requires_key = [](const json& list, const char* key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  EXPECT_TRUE(requires_key(plane["required"], "findings"));
  EXPECT_FALSE(requires_key(plane["required"], "points"));
  EXPECT_TRUE(requires_key(plane["then"]["required"], "points"));
  EXPECT_FALSE(requires_key(plane["then"]["required"], "by_luminaire"));
  EXPECT_EQ(plane["properties"]["statistics"]["anyOf"].size(), 2u);
}

TEST(ResultSchema, ListsNamesUnitsAndColumns) {
  const json definitions = json::parse(result_schema())["definitions"];
  const json& finding = definitions["finding"]["properties"];
  EXPECT_EQ(finding["unit"]["enum"],
            json({"lx", "", "W/m2", "W/m2/100lx", "kWh/m2/a", "cd/m2", "%", "cd", "m"}));
  EXPECT_EQ(finding["severity"]["enum"], json({"shall", "advice", "in-aggregate"}));
  EXPECT_EQ(definitions["aggregate"]["properties"]["severity"]["enum"], json({"shall", "advice"}));
  EXPECT_EQ(definitions["points"]["properties"]["columns"]["enum"][1][8], "ugr");
}

}  // namespace
}  // namespace report::result_schema_test
