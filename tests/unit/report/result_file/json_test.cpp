#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace report::json_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(Json, SaysWhatItIs) {
  EXPECT_EQ(rendered("json", small_document()).substr(0, 58),
            "{\n \"format\": \"luxgate-result\",\n \"format_version\": 1,\n \"pro");
}

TEST(Json, HoldsFindingsWithIntervals) {
  const json result = json::parse(rendered("json", small_document()));
  const json& finding = result["projects"][0]["spaces"][0]["planes"][0]["findings"][1];
  EXPECT_EQ(finding["quantity"], "minimum");
  EXPECT_EQ(finding["unit"], "lx");
  EXPECT_EQ(finding["limit"], 450.0);
  EXPECT_EQ(finding["measured"]["value"], 424.5);
  EXPECT_EQ(finding["measured"]["low"], 420.25);
  EXPECT_EQ(finding["measured"]["high"], 428.75);
  EXPECT_EQ(finding["verdict"], "fail");
  EXPECT_EQ(finding["place_m"], json({2.75, 1.0, 0.8}));
  EXPECT_EQ(result["counts"]["fail"], 1);
}

TEST(Json, NamesWhatThePointsMeasure) {
  Document document = small_document();
  const auto quantity = [&document] {
    return json::parse(
        rendered("json", document))["projects"][0]["spaces"][0]["planes"][0]["quantity"];
  };
  EXPECT_EQ(quantity(), "planar");
  document.projects[0].spaces[0].planes[0].kernel = calc::ReceiverKernel::hemispherical;
  EXPECT_EQ(quantity(), "hemispherical");
}

TEST(Json, HoldsEveryPoint) {
  const json result = json::parse(rendered("json", sample_document()));
  const json& plane = result["projects"][0]["spaces"][1]["planes"][0];
  const auto& points = sample_document().projects[0].spaces[1].planes[0].points;
  ASSERT_EQ(plane["points"]["rows"].size(), points.size());
  EXPECT_EQ(plane["points"]["columns"].size(), plane["points"]["rows"][7].size());
  EXPECT_EQ(plane["points"]["rows"][7][8], points[7].measured.value);
}

TEST(Json, HoldsTheGoalTheLooksAndTheDoubts) {
  Document document = small_document();
  document.provenance.goal = rules::Goal::accuracy;
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.looks_planned = 9;
  plane.counters.active_points = {2, 2, 1};
  plane.unseen_points = 1;
  plane.single_sample_points = 2;
  const json result = json::parse(rendered("json", document));
  EXPECT_EQ(result["provenance"]["goal"], "accuracy");
  const json& found = result["projects"][0]["spaces"][0]["planes"][0];
  EXPECT_EQ(found["looks"], 3);
  EXPECT_EQ(found["looks_planned"], 9);
  EXPECT_EQ(found["unseen_points"], 1);
  EXPECT_EQ(found["single_sample_points"], 2);
}

TEST(Json, WhatWasNotJudgedHasNoNumbers) {
  const json result = json::parse(rendered("json", sample_document()));
  const json& finding = result["projects"][0]["spaces"][1]["planes"][2]["findings"][0];
  EXPECT_TRUE(finding["measured"].is_null());
  EXPECT_EQ(finding["verdict"], "not-judged");
  EXPECT_FALSE(result["projects"][1]["is_judged"]);
  EXPECT_EQ(result["projects"][1]["diagnostics"][0]["id"], "file-not-readable");
}

TEST(Json, TimeAppearsOnlyOnRequest) {
  Document document = small_document();
  EXPECT_THAT(rendered("json", document), Not(HasSubstr("timestamp")));
  EXPECT_THAT(rendered("json", document), Not(HasSubstr("total_s")));
  document.provenance.timestamp = "2024-01-02T03:04:05Z";
  document.projects[0].times.total_s = 1.5;
  const json result = json::parse(rendered("json", document));
  EXPECT_EQ(result["provenance"]["timestamp"], "2024-01-02T03:04:05Z");
  EXPECT_EQ(result["projects"][0]["times"]["total_s"], 1.5);
}

TEST(Json, BrokenTextAndNumbersStillParse) {
  Document document = small_document();
  document.projects[0].name = "M\xFCller";
  document.projects[0].spaces[0].planes[0].average.value = std::numeric_limits<double>::quiet_NaN();
  const json result = json::parse(rendered("json", document));
  EXPECT_EQ(result["projects"][0]["name"], "M\uFFFDller");
  EXPECT_TRUE(result["projects"][0]["spaces"][0]["planes"][0]["statistics"]["average_lx"]["value"]
                  .is_null());
}

// CI runners obey what looks like this anywhere in a line, terminals the first byte of an escape.
TEST(Json, GivesNoOrders) {
  Document document = sample_document();
  const std::string name = "##vso[task] ##[x] a[1] \xc2\x9b\xe2\x80\xae\x7f \xc3\xa4";
  document.projects[0].name = name;
  const std::string text = rendered("json", document);
  EXPECT_THAT(text, HasSubstr("##vso\\u005btask] ##\\u005bx] a[1] \\u009b\\u202e\\u007f \xc3\xa4"));
  EXPECT_EQ(nlohmann::json::parse(text)["projects"][0]["name"], name);
}

TEST(Json, SameDocumentSameBytes) {
  EXPECT_EQ(rendered("json", sample_document()), rendered("json", sample_document()));
}

TEST(Json, NumbersOfOnePointShareALine) {
  EXPECT_THAT(
      rendered("json", small_document()),
      HasSubstr("[1, 0, 2.75, 1.0, 0.8, 0.0, 0.0, 1.0, 424.5, 420.25, 428.75, 324.0, 100.5]"));
}

}  // namespace
}  // namespace report::json_test
