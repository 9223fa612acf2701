// The panel of levels and what its script is given; what the script makes of it: tools/levels.py.
#include "report/html/room/html_levels.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace report::html_levels_test {
namespace {

using testing::HasSubstr;
using testing::Not;

// Three points of 100, 300 and 200 lx in two columns and two rows; two groups.
Document dimmed() {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.grid.columns = 2;
  plane.grid.rows = 2;
  plane.points = {sample_point(0, 0, {0, 0, 0}, estimate(100, 1), 0),
                  sample_point(1, 0, {1, 0, 0}, estimate(300, 1), 0),
                  sample_point(1, 1, {1, 1, 0}, estimate(200, 1), 0)};
  plane.groups = {{"window", estimate(150, 1), 0, {60, 240, 150}},
                  {"", estimate(50, 1), 0, {40, 60, 50}}};
  document.projects[0].scenes = {{"night", {{"window", 0.25}, {"other", 0.5}}}};
  return document;
}

std::string panel(const Document& document) {
  const ProjectPart& project = document.projects[0];
  return html_levels({}, project, level_groups(project.spaces[0]));
}

std::string attributes(const Document& document, const Texts& t = {}) {
  const ProjectPart& project = document.projects[0];
  const ColourScales scales(project, ScaleSharing::plane);
  return level_attributes(t, project.spaces[0], project.spaces[0].planes[0], scales,
                          level_groups(project.spaces[0]));
}

TEST(HtmlLevels, HasASliderForEachGroupAndAButtonForEachScene) {
  const std::string html = panel(dimmed());
  EXPECT_THAT(html, HasSubstr("<span>window</span>"));
  EXPECT_THAT(html, HasSubstr("<span>no group</span>"));
  EXPECT_THAT(html, HasSubstr("data-levels=\"0.25 1\">as in scene night"));
  EXPECT_THAT(html, HasSubstr("hidden=\"hidden\""));  // without a script nothing is seen of it
}

TEST(HtmlLevels, LightIsInTheOrderOfTheDrawing) {
  const std::string html = attributes(dimmed());
  // Darkest band first; the table has its upper row first.
  EXPECT_THAT(html, HasSubstr("data-light=\"0:150:60 150 240;1:50:40 50 60\""));
  EXPECT_THAT(html, HasSubstr("data-cells=\"2 1 3\""));
}

TEST(HtmlLevels, OneGroupIsThePlane) {
  Document document = dimmed();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.groups = {{"", estimate(200, 1), 0, {}}};
  plane.average = estimate(200, 1);
  EXPECT_THAT(attributes(document), HasSubstr("data-light=\"0:200:100 200 300\""));
  EXPECT_THAT(panel(document), HasSubstr("<span>All luminaires</span>"));
}

TEST(HtmlLevels, WhatCannotFollowHasNoPanel) {
  const auto expect_none = [](const Document& document, const char* what) {
    EXPECT_EQ(attributes(document), "") << what;
    EXPECT_EQ(panel(document), "") << what;
  };
  Document document = dimmed();
  document.projects[0].spaces[0].planes[0].groups[1].point_lx.clear();
  expect_none(document, "too many values");
  document = dimmed();
  document.projects[0].spaces[0].planes[0].groups.clear();
  expect_none(document, "an earlier version's result");
  document = dimmed();
  document.projects[0].spaces[0].planes[0].derived = calc::DerivedQuantity::ugr;
  expect_none(document, "a rating");
  document = dimmed();
  document.projects[0].spaces[0].planes[0].is_computed = false;
  expect_none(document, "not computed");
  document = dimmed();
  document.projects[0].spaces[0].planes[0].points[0].measured.value =
      std::numeric_limits<double>::quiet_NaN();
  expect_none(document, "a point without value");
}

TEST(HtmlLevels, NamesStayText) {
  Document document = dimmed();
  document.projects[0].spaces[0].planes[0].groups[0].group = "a\"<b>&";
  document.projects[0].scenes[0].id = "<script>";
  const std::string html = panel(document);
  EXPECT_THAT(html, Not(HasSubstr("<b>")));
  EXPECT_THAT(html, Not(HasSubstr("<script>")));
  // Of the line for the project: what is seen is what stands in the file.
  EXPECT_THAT(html, HasSubstr("data-group=\"a&amp;quot;&amp;lt;b&amp;gt;&amp;amp;\""));
}

TEST(HtmlLevels, LimitsAreThoseThatDigitsRespect) {
  EXPECT_EQ(limits_attribute({}), "");
  const Thresholds both(Threshold{500, rules::Comparison::at_least},
                        Threshold{0.5, rules::Comparison::less_than});
  EXPECT_EQ(limits_attribute(both), " data-limits=\"at_least 500;less_than 0.5\"");
}

TEST(HtmlLevels, MaintenanceIsOneFactorOrAllOfThem) {
  Document document = dimmed();
  std::vector<LuminaireRow>& rows = document.projects[0].luminaires;
  rows.assign(2, {});
  rows[0].count = rows[1].count = 1;
  rows[0].maintenance_factor = rows[1].maintenance_factor = 0.8;
  EXPECT_THAT(panel(document), HasSubstr("data-now=\"0.8\" data-is-common"));
  rows[1].maintenance_factor = 0.7;
  EXPECT_THAT(panel(document), HasSubstr("all maintenance factors"));
  EXPECT_THAT(panel(document), HasSubstr("data-now=\"1\""));
  rows[1].count = 0;  // of a type that is not used
  EXPECT_THAT(panel(document), HasSubstr("data-now=\"0.8\" data-is-common"));
}

}  // namespace
}  // namespace report::html_levels_test
