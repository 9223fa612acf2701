#include "report/stream/json_list.h"

#include "report/text/json_layout.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace report::json_list_test {
namespace {

using Json = nlohmann::ordered_json;

// The same file, with its list filled in item by item.
std::string filled(const std::vector<Json>& items, const std::vector<Json>& more) {
  const Json frame = {{"a", 1}, {"b", {{"c", {1, 2}}, {"list", json_gap()}}}, {"d", "e"}};
  JsonList list({testing::TempDir(), 10}, 2), rest({testing::TempDir(), 10}, 2);
  for (const Json& item : items) list.add(item);
  for (const Json& item : more) rest.add(item);
  const std::vector<std::string> pieces = json_layout_around_gaps(frame, 0);
  EXPECT_EQ(pieces.size(), 2U);
  TextSink sink;
  list.copy_to(sink, &rest);
  return pieces.at(0) + sink.text + pieces.at(1) + "\n";
}

TEST(JsonList, IsLaidOutAsIfItHadBeenThereAtOnce) {
  const Json flat = {{"x", 1}}, deep = {{"x", {{"y", Json::array()}}}, {"z", {1, {2}}}};
  const std::vector<std::vector<Json>> lists{{}, {flat}, {deep, flat}, {flat, deep, deep}};
  for (const std::vector<Json>& items : lists) {
    for (const std::vector<Json>& more : lists) {
      Json all = Json::array();
      for (const Json& item : items) all.push_back(item);
      for (const Json& item : more) all.push_back(item);
      const Json whole = {{"a", 1}, {"b", {{"c", {1, 2}}, {"list", all}}}, {"d", "e"}};
      EXPECT_EQ(filled(items, more), json_layout(whole));
    }
  }
}

}  // namespace
}  // namespace report::json_list_test
