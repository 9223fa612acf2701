#include "report/result_file/read_json.h"

#include "report/html/page/html.h"
#include "report/images/exr.h"
#include "report/images/png.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"
#include "tests/support/sample_road.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace report::read_json_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

Document read_again(const Document& document) {
  std::string problem;
  std::optional<Document> read = read_json(rendered("json", document), problem);
  EXPECT_TRUE(read) << problem;
  return read.value_or(Document{});
}

// Everything that documents can hold, beyond the samples.
Document rich_document() {
  Document document = sample_document();
  ProjectPart& project = document.projects[0];
  project.times = {0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.6, 0.7, 2.8};
  project.about = {"A. Meier", "4711", "b", "2026-03-31", "Z", "Office", "Way 1", "draft", {}};
  project.north_deg = -30.0;
  project.maintenance_plan = {"clean office", "by the house", 12.0, 36.0, 50000.0, 2500.0};
  project.spaces[0].energy =
      calc::LightingEnergy{150.0, 8.0, {}, calc::Message::words("2500 h by day")};
  project.spaces[0].road = sample_road().road;
  project.about.logo = {"logo.svg", calc::LogoFormat::svg,
                        "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0h1v1z\"/></svg>"};
  project.spaces[0].balance.untraced_lm = 12.5;
  project.spaces[0].floor_z_m = -3.25;
  PlanePart& plane = project.spaces[0].planes[0];
  plane.kernel = plane.grid.kernel = calc::ReceiverKernel::hemispherical;
  plane.where = {"school/project.xml", 12, 3};
  plane.made_by =
      calc::Message::words("workplace desk, EN 12464-1:2021 34.2, task: the whole room");
  plane.changed = calc::Message::words("height 1.1 m instead of 0.75 m");
  project.spaces[0].notes = {calc::Message::words("workplace desk: left out: ceiling (open)"),
                             calc::Message::words("more")};
  plane.unseen_points = 1;
  plane.single_sample_points = 2;
  plane.holes_m = {{{1, 1}, {2, 1}, {2, 2}}};
  rules::Finding value = sample_finding(rules::Metric::value_at_point, 10, estimate(12, 1));
  value.requirement.arguments = rules::PointOfValue{glm::dvec3{1, 2, 3}, {}};
  value.requirement.origin = {"own:1", "middle", "1", {}, {}, {}, true};
  value.requirement.scene = "night";
  value.requirement.state = rules::LightState::initial;
  value.requirement.comparison = rules::Comparison::at_most;
  rules::Finding percentile = sample_finding(rules::Metric::percentile, 10, estimate(12, 1));
  percentile.requirement.arguments = rules::Percentile{5};
  rules::Finding share = sample_finding(rules::Metric::share, 0.9, estimate(0.8, 0.05));
  share.requirement.arguments = rules::ValueRange{300};
  share.requirement.comparison = rules::Comparison::more_than;
  share.requirement.state = rules::LightState::end_of_duration;
  share.requirement.note = calc::Message::words("unverified requirement");
  share.requirement.severity = rules::Severity::advice;
  share.requirement.mask.id = "inner";
  share.points_used = 12;
  share.requirement.direct_only = true;
  share.requirement.policy.tolerance = 0.05;
  share.requirement.policy.tolerance_reason = "agreed";
  share.requirement.policy.rounding = rules::Rounding::half_even;
  share.requirement.waiver = rules::Waiver{"old hall", "A. Client", "2030-12-31"};
  share.is_waived = true;
  for (rules::Finding* finding : {&value, &share}) judge_again(*finding);
  percentile.is_doubtful = true;
  percentile.verdict = rules::Verdict::undecided;
  percentile.reason = calc::Message::words("the result rests on single samples");
  percentile.is_close = false;
  plane.findings.push_back(share);
  plane.findings.push_back(value);
  plane.findings.push_back(percentile);
  plane.by_luminaire.largest = {
      {"L1", "panel", "row <1>", {1, 2, 3}, estimate(250, 3), 180, estimate(90, 2), 60}};
  plane.by_luminaire.others = 2;
  plane.by_luminaire.rest = {"", "", "", {}, estimate(150, 3), 70, estimate(40, 2), 20};
  plane.by_luminaire.minimum_at_m = {4, 5, 6};
  plane.groups = {{"row <1>", estimate(300, 3), 200}, {"", estimate(100, 1), 50}};
  PlaneLook look{1024, 4096, 12, estimate(400, 9), {}};
  for (const rules::Finding& finding : plane.findings)
    look.findings.push_back({finding.verdict, finding.measured});
  plane.looks = {look, look};
  plane.looks[1].paths = 2048;
  AskedLight& light = plane.asked_light.emplace();
  light.scene = "night";
  light.state = rules::LightState::end_of_duration;
  light.direct_only = true;
  for (const PointRow& point : plane.points) {
    light.points.push_back(
        {estimate(0.01 * point.measured.value, 0.5), 0.01 * point.measured.value, 0.0});
  }
  light.average = light.minimum = light.maximum = estimate(3, 0.5);
  light.uniformity_min_avg = light.uniformity_min_max = estimate(0.5, 0.1);
  project.luminaires.at(0).c0_cd.assign(2 * kPolarHalfSteps + 1, 120.5);
  project.luminaires.at(0).c90_cd.assign(2 * kPolarHalfSteps + 1, 90.25);
  LuminaireMark& mark = project.spaces[0].luminaires.at(0);
  mark.group = "row <1>";
  mark.outline_m = {{1, 1}, {2, 1}, {2, 1.5}};
  mark.c0 = {0.48, 0.64, 0.6};
  mark.axis = {0.36, 0.48, -0.8};
  project.luminaires.at(0).file_flux_lm = 1234.5;
  project.luminaires.at(0).file_power_w = 23.5;
  project.luminaires.at(0).stated_flux_lm = 1236.0;
  document.provenance.method = "--method instant-radiosity";
  project.spaces[0].finishes = {{"floor", "wood, tiles"}};
  project.spaces[0].bodies = {{"desk", 0, 0.75, {{glm::dvec2(1, 1), glm::dvec2(2, 1)}}, "wood"}};
  project.spaces[0].bodies_left_out = 3;
  const std::string& id = plane.findings.front().requirement.id;
  project.advice = {
      {"night <1>",
       AdviceOutcome::levels,
       {},
       CostUnit::watt,
       72.0,
       45.5,
       {{"row <1>", 2, 72.0, 2400.0, 12.5, 1.0, 0.625}, {"", 1, 0.0, 900.0, 0.0, 0.5, 0.5}},
       1,
       2,
       {{plane.id, id}},
       {"a class (fail)"},
       {}},
      {"",
       AdviceOutcome::contradiction,
       {},
       CostUnit::watt,
       0,
       0,
       {},
       0,
       0,
       {},
       {},
       {{plane.id, id}, {"gone", "Em"}}},
      {"day",
       AdviceOutcome::none_found,
       calc::Message::words("there are no luminaires"),
       CostUnit::lumen,
       0,
       0,
       {},
       0,
       0,
       {},
       {},
       {}}};
  document.provenance.timestamp = "2024-05-01T12:00:00Z";
  document.provenance.judged_on = "2024-05-01";
  document.provenance.goal = rules::Goal::accuracy;
  return document;
}

TEST(ReadJson, EveryFormatOfWhatWasReadIsTheSame) {
  for (const Document& document : {small_document(), sample_document(), rich_document()}) {
    const Document again = read_again(document);
    EXPECT_EQ(rendered("json", again), rendered("json", document));
    EXPECT_EQ(rendered("text", again), rendered("text", document));
    EXPECT_EQ(rendered("csv", again), rendered("csv", document));
    EXPECT_EQ(rendered("points-csv", again), rendered("points-csv", document));
    EXPECT_EQ(render_html(again), render_html(document));
    EXPECT_EQ(rendered("junit", again), rendered("junit", document));
    EXPECT_EQ(rendered("sarif-all", again), rendered("sarif-all", document));
    EXPECT_EQ(rendered("github", again), rendered("github", document));
    EXPECT_EQ(rendered("gitlab", again), rendered("gitlab", document));
    EXPECT_EQ(rendered("markdown", again), rendered("markdown", document));
    const ProjectPart &a = document.projects[0], &b = again.projects[0];
    const auto picture = [](const ProjectPart& project) {
      const PlanePart& plane = project.spaces[0].planes[0];
      return render_heatmap_png(plane, scale_of(plane));
    };
    EXPECT_EQ(picture(a), picture(b));
    EXPECT_EQ(render_exr(document.provenance, a, a.spaces[0], a.spaces[0].planes[0]),
              render_exr(again.provenance, b, b.spaces[0], b.spaces[0].planes[0]));
  }
}

// Eyes: no unit, no average, an observer without rating, a share between plain numbers.
Document rated_document() {
  Document document = sample_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.power = {540.0, 96.0, 15, 1};
  PlanePart& plane = space.planes[0];
  plane.derived = plane.grid.derived = calc::DerivedQuantity::ugr;
  plane.remarks = {calc::Message::words("how it was rated")};
  plane.average = plane.uniformity_min_avg = plane.uniformity_min_max = no_estimate();
  plane.points[0].measured = no_estimate();
  rules::Finding maximum = sample_finding(rules::Metric::maximum, 19, estimate(18.5, 0.25));
  rules::Finding share = sample_finding(rules::Metric::share, 0.9, estimate(0.8, 0.05));
  share.requirement.arguments = rules::ValueRange{0, 19};
  plane.findings = {maximum, share};
  for (rules::Finding& finding : plane.findings) {
    finding.requirement.derived = plane.derived;
    judge_again(finding);
  }
  return document;
}

TEST(ReadJson, RatingsAreReadBack) {
  const Document document = rated_document();
  const Document again = read_again(document);
  EXPECT_EQ(rendered("json", again), rendered("json", document));
  EXPECT_EQ(rendered("text", again), rendered("text", document));
  EXPECT_EQ(render_html(again), render_html(document));
  EXPECT_EQ(rendered("points-csv", again), rendered("points-csv", document));
  const json plane =
      json::parse(rendered("json", document))["projects"][0]["spaces"][0]["planes"][0];
  EXPECT_EQ(plane["quantity"], "ugr");
  EXPECT_EQ(plane["findings"][0]["unit"], "");
  EXPECT_EQ(plane["findings"][1]["to"], 19.0);
  EXPECT_EQ(plane["points"]["columns"][8], "ugr");
  EXPECT_TRUE(plane["points"]["rows"][0][8].is_null());
  EXPECT_FALSE(plane["statistics"].contains("average_lx"));
  EXPECT_EQ(again.projects[0].spaces[0].power.without_power, 1);
}

// Of glare alone: no observer sees a luminaire, or its rating has an open end.
TEST(ReadJson, RatingsWithOpenEndsAreReadBack) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  struct Case {
    calc::Estimate measured;
    rules::Verdict verdict;
    const char* shown;
  };
  for (const Case& item : {Case{{-kOpen, -kOpen, -kOpen}, rules::Verdict::pass, "none"},
                           Case{{-kOpen, -kOpen, 18.5}, rules::Verdict::pass, "≤ 18.5"},
                           Case{{18.0, -kOpen, 18.5}, rules::Verdict::pass, "≤ 18.5"},
                           Case{{18.0, -kOpen, 19.5}, rules::Verdict::undecided, "≤ 19.5"},
                           Case{{20.0, 19.5, kOpen}, rules::Verdict::fail, "≥ 19.5"},
                           Case{{19.5, 18.5, kOpen}, rules::Verdict::undecided, "≥ 18.5"}}) {
    Document document = rated_document();
    PlanePart& plane = document.projects[0].spaces[0].planes[0];
    rules::Finding& finding = plane.findings[0];
    finding.requirement.comparison = rules::Comparison::at_most;
    finding.measured = item.measured;
    judge_again(finding);
    finding.reason = calc::Message::words("how it is known");
    EXPECT_EQ(finding.verdict, item.verdict) << item.shown;
    plane.looks.clear();
    settle_estimates(plane);
    const Document again = read_again(document);
    const rules::Finding& found = again.projects[0].spaces[0].planes[0].findings[0];
    EXPECT_EQ(found.measured.value, item.measured.value) << item.shown;
    EXPECT_EQ(found.measured.low, item.measured.low) << item.shown;
    EXPECT_EQ(found.measured.high, item.measured.high) << item.shown;
    EXPECT_EQ(rendered("json", again), rendered("json", document));
    EXPECT_EQ(render_html(again), render_html(document));
    EXPECT_EQ(rendered("csv", again), rendered("csv", document));
    EXPECT_THAT(rendered("text", again), HasSubstr(item.shown));
    EXPECT_THAT(rendered("text", again), HasSubstr("how it is known"));
    EXPECT_THAT(render_html(again), HasSubstr(item.shown));
    EXPECT_THAT(render_html(again), HasSubstr("ow it is known"));
    // Nobody makes a pass of what is open, or a fail.
    json changed = json::parse(rendered("json", document));
    const json::json_pointer verdict("/projects/0/spaces/0/planes/0/findings/0/verdict");
    for (const char* other : {"pass", "fail", "undecided"}) {
      if (changed[verdict] == other) continue;
      json wrong = changed;
      wrong[verdict] = other;
      std::string problem;
      EXPECT_FALSE(read_json(wrong.dump(), problem)) << item.shown << " " << other;
    }
  }
}

// Who writes "nothing" beside a number makes no pass of it, and there is no margin to it.
TEST(ReadJson, NothingHasNoNumbers) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  Document document = rated_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.findings[0].requirement.comparison = rules::Comparison::at_most;
  plane.findings[0].measured = {-kOpen, -kOpen, 18.0};
  judge_again(plane.findings[0]);
  plane.looks.clear();
  settle_estimates(plane);
  const json good = json::parse(rendered("json", document));
  const std::string finding = "/projects/0/spaces/0/planes/0/findings/0";
  std::string problem;
  EXPECT_TRUE(read_json(good.dump(), problem)) << problem;
  for (const auto& [key, number] : {std::pair{"/measured/value", 25.0},
                                    std::pair{"/measured/low", 25.0}, std::pair{"/margin", 0.1}}) {
    json changed = good;
    changed[json::json_pointer(finding + key)] = number;
    EXPECT_FALSE(read_json(changed.dump(), problem)) << key;
  }
}

TEST(ReadJson, WhatIsNotFiniteStaysSo) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[0];
  finding.measured.high = std::numeric_limits<double>::infinity();
  finding.verdict = rules::Verdict::undecided;
  const Document again = read_again(document);
  EXPECT_FALSE(std::isfinite(again.projects[0].spaces[0].planes[0].findings[0].measured.high));
}

// Files have no infinity: before and after one the pages are the same, and no drawing gets a place
// that is no number.
TEST(ReadJson, OpenIntervalsAreShownTheSameAgain) {
  const double open = std::numeric_limits<double>::infinity();
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const calc::Estimate& measured :
       {calc::Estimate{512, 500, open}, calc::Estimate{512, -open, 520},
        calc::Estimate{512, none, 520}, calc::Estimate{512, none, none},
        calc::Estimate{open, 500, open}, calc::Estimate{-open, -open, -open}}) {
    Document document = small_document();
    PlanePart& plane = document.projects[0].spaces[0].planes[0];
    plane.findings[0].measured = plane.average = plane.points[0].measured = measured;
    plane.findings[0].verdict = rules::Verdict::undecided;
    plane.groups = {{"row", measured, 200}, {"", estimate(100, 1), 50}};
    PlaneLook look{1024, 4096, 2, measured, {}};
    for (const rules::Finding& finding : plane.findings)
      look.findings.push_back({finding.verdict, finding.measured});
    plane.looks = {look, look};
    settle_estimates(plane);
    const Document again = read_again(document);
    const std::string html = render_html(document);
    EXPECT_EQ(render_html(again), html);
    EXPECT_EQ(rendered("json", again), rendered("json", document));
    EXPECT_EQ(rendered("text", again), rendered("text", document));
    EXPECT_EQ(rendered("junit", again), rendered("junit", document));
    const std::string drawn = html.substr(0, html.find("<script>"));
    for (const char* wrong : {"NaN", "nan ", "nan\"", "inf ", "inf\"", "M–", "H–", "L–", "\"–\""})
      EXPECT_THAT(drawn, Not(HasSubstr(wrong))) << wrong;
  }
}

TEST(ReadJson, ACutFileIsCalledIncomplete) {
  std::string problem;
  EXPECT_FALSE(read_json("{\"projects\": [", problem));
  EXPECT_EQ(problem, "it ends too early; it is an incomplete JSON file");
  EXPECT_FALSE(read_json("{\"projects\": x]}", problem));
  EXPECT_EQ(problem, "it is not JSON; the first error is at byte 14");
}

TEST(ReadJson, OnlyWhatIsNotJudgedMayLackItsLimit) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[0];
  finding.requirement.limit = std::numeric_limits<double>::quiet_NaN();
  std::string problem;
  EXPECT_FALSE(read_json(rendered("json", document), problem));
  EXPECT_EQ(problem, "/projects/0/spaces/0/planes/0/findings/0/limit: a number is needed");
  finding.verdict = rules::Verdict::not_judged;
  const Document again = read_again(document);
  EXPECT_TRUE(std::isnan(again.projects[0].spaces[0].planes[0].findings[0].requirement.limit));
}

std::string problem_with(const json& changed) {
  std::string problem;
  EXPECT_FALSE(read_json(changed.dump(), problem));
  return problem;
}

TEST(ReadJson, SaysWhereSomethingIsWrong) {
  const json good = json::parse(rendered("json", small_document()));
  const auto with = [&](const char* pointer, const json& value) {
    json changed = good;
    changed[json::json_pointer(pointer)] = value;
    return problem_with(changed);
  };
  EXPECT_EQ(with("/format", "other"), "/format: 'luxgate-result' is needed");
  EXPECT_EQ(with("/format_version", 2), "/format_version: a whole number from 1 to 1 is needed");
  EXPECT_EQ(with("/projects", 3), "/projects: an array is needed");
  EXPECT_EQ(with("/projects/0/path", 3), "/projects/0/path: a text is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/height_m", nullptr),
            "/projects/0/spaces/0/height_m: a number is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/findings/0/verdict", "good"),
            "/projects/0/spaces/0/planes/0/findings/0/verdict: one of 'pass', 'fail', 'undecided', "
            "'not-judged' is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/findings/0/quantity", "mean"),
            "/projects/0/spaces/0/planes/0/findings/0/quantity: unknown quantity");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/points/rows/1/0", 2),
            "/projects/0/spaces/0/planes/0/points/rows/1: the cell is outside the grid");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/points/rows/1", json::array({1})),
            "/projects/0/spaces/0/planes/0/points/rows/1: an array of 13 is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/grid/columns", 2'000'000'000),
            "/projects/0/spaces/0/planes/0/grid/columns: the grid has too many cells")
      << "with one row";
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/grid/spacing_u_m", 0),
            "/projects/0/spaces/0/planes/0/grid/spacing_u_m: a number above 0 is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/grid/spacing_v_m", -1),
            "/projects/0/spaces/0/planes/0/grid/spacing_v_m: a number above 0 is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/counters/paths", -1),
            "/projects/0/spaces/0/planes/0/counters/paths: a whole number of at least 0 is needed");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/findings/0/waiver",
                 {{"reason", "r"}, {"owner", "o"}, {"until", "2030-01-01"}, {"applies", true}}),
            "/projects/0/spaces/0/planes/0/findings/0/waiver/applies: only 'fail' and 'undecided' "
            "can be waived");
  EXPECT_EQ(with("/projects/0/spaces/0/planes/0/findings/0/point_m", nullptr),
            "/projects/0/spaces/0/planes/0/findings/0/point_m: an array is needed");
  EXPECT_EQ(with("/provenance/confidence", 1),
            "/provenance/confidence: a number above 0 and below 1 is needed");
  EXPECT_EQ(with("/provenance/numbers_version", 0),
            "/provenance/numbers_version: a whole number from 1 to 2147483647 is needed");
  json without = good;
  without["provenance"].erase("seed");
  EXPECT_EQ(problem_with(without), "/provenance: the key 'seed' is missing");
}

// A result is a stranger's file, too.
TEST(ReadJson, AKeyThatStandsTwiceIsNoResult) {
  std::string problem;
  EXPECT_EQ(read_json(R"({"luxgate_result": 1, "outcome": "fail", "outcome": "pass"})", problem),
            std::nullopt);
  EXPECT_THAT(problem, testing::HasSubstr("the key 'outcome' is given twice in one object"));
  EXPECT_EQ(read_json(R"({"a": [{"b": 1}, {"b": 2}], "c": {"a": {}, "b": 1}})", problem),
            std::nullopt);
  EXPECT_THAT(problem, testing::Not(testing::HasSubstr("twice")));
}

TEST(ReadJson, ALogoIsCheckedAgain) {
  const auto problem_with = [](const char* key, const char* value) {
    json changed = json::parse(rendered("json", rich_document()));
    json& about = changed["projects"][0]["about"];
    (about.contains(key) ? about : about["logo"])[key] = value;
    std::string problem;
    EXPECT_FALSE(read_json(changed.dump(), problem));
    return problem;
  };
  // <svg xmlns="http://www.w3.org/2000/svg"><script/></svg>
  EXPECT_THAT(problem_with("base64",
                           "PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciPjxzY3Jp"
                           "cHQvPjwvc3ZnPg=="),
              HasSubstr("/about/logo/base64: a picture that 'luxgate check' lets into reports"));
  EXPECT_THAT(problem_with("base64", "no bytes"), HasSubstr("/about/logo/base64: a picture"));
  EXPECT_THAT(problem_with("format", "png"), HasSubstr("/about/logo/base64: a picture"));
  EXPECT_THAT(problem_with("format", "gif"), HasSubstr("/about/logo/format: one of"));
  EXPECT_THAT(problem_with("date", "soon"), HasSubstr("/about/date: a day"));
}

TEST(ReadJson, NorthAndMaintenanceAreCheckedAgain) {
  const auto problem_with = [](const std::string& part, const json& value) {
    json changed = json::parse(rendered("json", rich_document()));
    json::json_pointer at("/projects/0/" + part);
    changed[at] = value;
    std::string problem;
    EXPECT_FALSE(read_json(changed.dump(), problem)) << part;
    return problem;
  };
  EXPECT_THAT(problem_with("north_deg", 4500),
              HasSubstr("/north_deg: a number from -360 to 360 (degrees) is needed"));
  EXPECT_THAT(problem_with("north_deg", "up"), HasSubstr("/north_deg"));
  for (const int months : {-1, 0}) {
    EXPECT_THAT(problem_with("maintenance_plan/clean_luminaires_months", months),
                HasSubstr("/clean_luminaires_months: a number above 0"));
  }
  EXPECT_THAT(problem_with("maintenance_plan/use_h", 8761), HasSubstr("/use_h: a number from 0"));
  EXPECT_THAT(problem_with("spaces/0/energy/leni_kwh_m2", -1), HasSubstr("/leni_kwh_m2"));
  EXPECT_THAT(problem_with("spaces/0/road/spacing_m", 0),
              HasSubstr("/spacing_m: a number above 0"));
  EXPECT_THAT(problem_with("spaces/0/road/areas/1/to_y_m", -9), HasSubstr("above from_y_m"));
  for (const char* key : {"observers/1/lane", "observers/0/cd_m2", "observers", "x_m", "y_m"}) {
    const json wrong = key == std::string("observers/1/lane") ? json(2) : json::array();
    EXPECT_THAT(problem_with("spaces/0/road/" + std::string(key), wrong),
                HasSubstr("each lane needs an observer"));
  }
  EXPECT_THAT(problem_with("spaces/0/road_energy/area_m2", 1),
              HasSubstr("but its other values give"));
}

TEST(ReadJson, EveryLookIsOfEveryFinding) {
  json changed = json::parse(rendered("json", rich_document()));
  json& look = changed["projects"][0]["spaces"][0]["planes"][0]["look_results"][1];
  look["findings"].erase(0);
  EXPECT_EQ(problem_with(changed),
            "/projects/0/spaces/0/planes/0/look_results: each look needs as many findings as the "
            "plane has");
}

// A class or an aggregate is in no other one.
TEST(ReadJson, AggregatesCountByThemselvesOrNotAtAll) {
  Document document = small_document();
  document.projects[0].aggregates.resize(1);
  json changed = json::parse(rendered("json", document));
  changed["projects"][0]["aggregates"][0]["severity"] = "in-aggregate";
  EXPECT_EQ(problem_with(changed),
            "/projects/0/aggregates/0/severity: one of 'shall', 'advice' is needed");
}

TEST(ReadJson, ARouteIsWrittenAndReadAgain) {
  const Document document = route_document();
  EXPECT_EQ(rendered("json", read_again(document)), rendered("json", document));
  EXPECT_EQ(render_html(read_again(document)), render_html(document));
}

// Pictures are made from its cells.
TEST(ReadJson, RefusesARouteWithoutItsCells) {
  const json good = json::parse(rendered("json", route_document()));
  const std::string at = "/projects/0/spaces/0/planes/0/grid/route";
  const auto with = [&](const std::string& key, const json& value) {
    json changed = good;
    changed[json::json_pointer(at + key)] = value;
    return problem_with(changed);
  };
  const std::string needs = at + "/stations: each leg needs its columns of the grid";
  EXPECT_EQ(with("/stations", {10, 9}), needs);
  EXPECT_EQ(with("/stations", {18}), needs);
  EXPECT_EQ(with("/stations", {18, 0}), needs);
  EXPECT_EQ(with("/stations", json::array()), needs);
  EXPECT_EQ(with("/width_m", 0), at + "/width_m: a number above 0 is needed");
  EXPECT_EQ(with("/width_m", 7), at + "/line_m: it is not the line of a route");
}

TEST(ReadJson, SurvivesAnyReplacedValueOfARoute) {
  const json good = json::parse(rendered("json", route_document()));
  std::string problem;
  const json flat = good["projects"][0]["spaces"][0]["planes"][0]["grid"].flatten();
  for (const auto& item : flat.items()) {
    for (const json& value : {json(), json(-1), json(1e300), json("x"), json::array(),
                              json::object(), json(true), json(std::uint64_t{1} << 63)}) {
      json changed = good;
      changed["projects"][0]["spaces"][0]["planes"][0]["grid"][json::json_pointer(item.key())] =
          value;
      const std::optional<Document> read = read_json(changed.dump(), problem);
      if (read) {
        EXPECT_FALSE(render_html(*read).empty());
      }
    }
  }
}

TEST(ReadJson, RefusesWhatIsNoJson) {
  std::string problem;
  for (const char* text :
       {"", "{", "[1,2", "<html>", "\xff\xfe", "{\"format\":\"luxgate-result\"}"}) {
    EXPECT_FALSE(read_json(text, problem)) << text;
    EXPECT_FALSE(problem.empty());
  }
  EXPECT_FALSE(read_json(std::string(1'000'000, '['), problem));
}

TEST(ReadJson, PassesOverKeysOfLaterVersions) {
  json later = json::parse(rendered("json", small_document()));
  later["projects"][0]["spaces"][0]["planes"][0]["colour"] = "blue";
  std::string problem;
  EXPECT_TRUE(read_json(later.dump(), problem)) << problem;
}

// Every value of a result replaced by each of some others: read or refused, never a crash.
TEST(ReadJson, SurvivesAnyReplacedValue) {
  const json good = json::parse(rendered("json", small_document()));
  std::string problem;
  std::size_t refused = 0, tried = 0;
  const json flat = good.flatten();
  for (const auto& item : flat.items()) {
    for (const json& value : {json(), json(-1), json(1e300), json("x"), json::array(),
                              json::object(), json(true), json(std::uint64_t{1} << 63)}) {
      json changed = good;
      changed[json::json_pointer(item.key())] = value;
      ++tried;
      std::optional<Document> read = read_json(changed.dump(), problem);
      if (!read) ++refused;
      if (read) {
        EXPECT_FALSE(render_html(*read).empty());
      }
    }
  }
  EXPECT_GT(tried, 500u);
  EXPECT_GT(refused, tried / 2);
}

}  // namespace
}  // namespace report::read_json_test
