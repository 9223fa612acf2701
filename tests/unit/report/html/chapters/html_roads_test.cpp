#include "report/html/chapters/html_roads.h"

#include "tests/support/sample_document.h"
#include "tests/support/sample_road.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace report::html_roads_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

ProjectPart project_with(const SpacePart& space) {
  ProjectPart project = small_document().projects[0];
  project.spaces.push_back(space);
  return project;
}

pugi::xml_document parsed(const std::string& html) {
  pugi::xml_document tree;
  EXPECT_TRUE(tree.load_string(("<r>" + html + "</r>").c_str(), pugi::parse_full)) << html;
  return tree;
}

// Head and cells of each row of all tables, "a | b | c".
std::vector<std::string> table_rows(const std::string& html) {
  const pugi::xml_document tree = parsed(html);
  std::vector<std::string> rows;
  for (const pugi::xpath_node& row : tree.select_nodes("//tbody/tr")) {
    std::string words;
    for (const pugi::xml_node& cell : row.node().children())
      words += (words.empty() ? "" : " | ") + std::string(cell.text().get());
    rows.push_back(words);
  }
  return rows;
}

TEST(HtmlRoads, AreNothingWithoutAStreet) {
  EXPECT_EQ(html_roads({}, small_document().projects[0], 0), "");
}

TEST(HtmlRoads, StateWhatIsThere) {
  const std::string html = html_roads({}, project_with(sample_road()), 0);
  EXPECT_THAT(html, HasSubstr("<h3 id=\"roads1\">Roads</h3>"));
  const std::vector<std::string> rows = table_rows(html);
  EXPECT_THAT(rows, Contains("Carriageway | 7.00 m wide, lanes: 2, each 3.50 m, of these towards "
                             "−x: 1"));
  EXPECT_THAT(rows, Contains("Road surface | R3, Q0 = 0.07"));
  EXPECT_THAT(rows, Contains("Arrangement | both sides, opposite"));
  EXPECT_THAT(rows, Contains("Setback of poles, length of arms | not stated"));
  EXPECT_THAT(rows, Contains("west | head | left | 8.00 | −0.25 | 5 | 0.00 | 75.0 W | 0.80"));
  EXPECT_THAT(rows, Contains("Carriageway | EN 13201-2:2015 M4 | 7.00 | 210.0 | 20.0 ± 1.0 lx"));
}

TEST(HtmlRoads, TellPowerAndEnergy) {
  ProjectPart project = project_with(sample_road());
  std::vector<std::string> rows = table_rows(html_roads({}, project, 0));
  EXPECT_THAT(rows, Contains("Power in 30.00 m, P | 150.0 W"));
  EXPECT_THAT(rows, Contains("Power by length | 5000 W/km"));
  EXPECT_THAT(rows, Contains(HasSubstr("| 0.0312 (0.0297 to 0.0329) W/(lx·m²)")));
  EXPECT_THAT(rows, Contains(HasSubstr("| not computed: the project states no hours of use; 0.56 "
                                       "kWh/m² for each 1000 h")));
  project.maintenance_plan.use_h = 4000.0;
  EXPECT_THAT(table_rows(html_roads({}, project, 0)),
              Contains(HasSubstr("| 2.22 kWh/m², 4000 h a year at full output")));
  project.spaces.back().planes[1].is_computed = false;
  EXPECT_THAT(table_rows(html_roads({}, project, 0)),
              Contains(HasSubstr("| not known: the illuminance of an area was not calculated")));
}

// 0.748 would be 0.75 with the usual digits, and so look as if it met the limit.
TEST(HtmlRoads, DigitsNeverContradictWhatIsRequired) {
  SpacePart space = sample_road();
  EXPECT_THAT(html_roads({}, project_with(space), 0), HasSubstr("<strong>0.80</strong>"));
  space.road->light.observers[0].average_cd_m2 = estimate(0.748, 0.0);
  EXPECT_THAT(html_roads({}, project_with(space), 0), HasSubstr("<strong>0.748</strong>"));
}

TEST(HtmlRoads, WhatDriversSeeHasItsInterval) {
  SpacePart space = sample_road();
  space.road->light.observers[0].average_cd_m2 = estimate(0.748, 0.01);
  space.road->light.observers[1].ti_percent = estimate(11.0, 0.25);
  const std::string html = html_roads({}, project_with(space), 0);
  EXPECT_THAT(html, HasSubstr("<strong>0.748 ± 0.010</strong>"));
  EXPECT_THAT(html, HasSubstr("<strong>11.0 ± 0.3</strong>"));
}

TEST(HtmlRoads, SayWhyIndicatorsAreNotKnown) {
  SpacePart space = sample_road();
  space.road->areas[1].to_y_m = 0.5;
  EXPECT_THAT(table_rows(html_roads({}, project_with(space), 0)),
              Contains(HasSubstr("PDI = P / Σ(Ē · A) | not known: areas overlap")));
  space = sample_road();
  space.road->rows[0].power_w = 1e308;
  space.road->spacing_m = 1e-3;
  const std::string html = html_roads({}, project_with(space), 0);
  EXPECT_THAT(table_rows(html), Contains("Power by length | not known"));
  EXPECT_THAT(html, Not(HasSubstr(">inf")));
}

TEST(HtmlRoads, DrawTwelveChartsAtMost) {
  SpacePart space = sample_road();
  calc::RoadLight& light = space.road->light;
  light.grid.y_m.assign(15 * 3, 1.0);
  light.observers.resize(1);
  light.observers[0].cd_m2.assign(450, 1.0);
  light.observers[0].cd_m2[0] = 2.0;
  for (int lane = 1; lane < 15; ++lane) {
    light.observers.push_back(light.observers[0]);
    light.observers.back().lane = lane;
    light.observers.back().average_cd_m2 = estimate(1.0 - 0.01 * lane, 0.0);
    light.observers.back().uo = light.observers.back().ul = estimate(0.9, 0.0);
    light.observers.back().ti_percent = estimate(5.0, 0.0);
  }
  const std::string html = html_roads({}, project_with(space), 0);
  const pugi::xml_document tree = parsed(html);
  EXPECT_EQ(tree.select_nodes("//div[@class='road-charts']//svg[@class='layout road']").size(),
            12U);
  EXPECT_THAT(html, HasSubstr("<p class=\"quiet\">3 more observers have no chart;"));
  EXPECT_THAT(html, HasSubstr("<h5>Lane 15, towards +x, decides"));
}

TEST(HtmlRoads, NameDriversAndWhatTheyDecide) {
  SpacePart space = sample_road();
  std::string html = html_roads({}, project_with(space), 0);
  EXPECT_THAT(html, HasSubstr("<h5>Lane 1, towards +x, decides L, Ul: luminance in cd/m²</h5>"));
  EXPECT_THAT(html, HasSubstr("<h5>Lane 2, towards −x, decides Uo, Ul, TI, REI: luminance"));
  EXPECT_THAT(html, Not(HasSubstr("half a turn")));
  std::vector<calc::RoadObserver>& seen = space.road->light.observers;
  seen[1].cd_m2.assign(seen[0].cd_m2.rbegin(), seen[0].cd_m2.rend());
  html = html_roads({}, project_with(space), 0);
  EXPECT_THAT(html, HasSubstr("the chart of Lane 1, towards +x, turned by half a turn"));
}

// Each point once in each chart, in words that are at least 6 points (2.12 mm) high on paper, on
// drawings that are no wider than a page.
TEST(HtmlRoads, ChartsHaveEveryValueLegibly) {
  SpacePart space = sample_road();
  RoadPart& road = *space.road;
  road.spacing_m = 120.0;
  calc::RoadLight& light = road.light;
  light.grid.x_m.clear();
  for (int i = 0; i < 40; ++i) light.grid.x_m.push_back(1.5 + 3.0 * i);
  for (calc::RoadObserver& observer : light.observers) observer.cd_m2.assign(40 * 6, 1.0);
  light.observers[0].cd_m2[7] = 12.34;
  light.observers[1].cd_m2[7] = 0.07;
  const pugi::xml_document tree = parsed(html_roads({}, project_with(space), 0));
  const auto charts = tree.select_nodes("//div[@class='road-charts']//svg[@class='layout road']");
  ASSERT_EQ(charts.size(), 2U);
  for (const pugi::xpath_node& chart : charts) {
    const auto numbers = chart.node().select_nodes(".//g/text");
    EXPECT_EQ(numbers.size(), 240U);
    EXPECT_LE(chart.node().attribute("width").as_double(), 182.0);
    for (const pugi::xpath_node& group : chart.node().select_nodes(".//g"))
      EXPECT_GE(group.node().attribute("font-size").as_double(), 2.12);
    double last_mm = 0.0;
    for (const pugi::xpath_node& number : numbers)
      last_mm = std::max(last_mm, number.node().attribute("y").as_double());
    const std::string box = chart.node().attribute("viewBox").value();
    EXPECT_LT(last_mm, std::strtod(box.substr(box.rfind(' ')).c_str(), nullptr));
  }
  const auto has_text = [](const pugi::xpath_node& chart, const char* words) {
    return !chart.node()
                .select_nodes((".//g/text[.='" + std::string(words) + "']").c_str())
                .empty();
  };
  EXPECT_TRUE(has_text(charts[0], "12.3"));
  EXPECT_TRUE(has_text(charts[1], "0.07"));
}

// Heights and widths of the section are its dimensions at its scale: 8 m at 1:100 are 80 mm.
TEST(HtmlRoads, SectionIsToScale) {
  const std::string html = html_roads({}, project_with(sample_road()), 0);
  EXPECT_THAT(html, HasSubstr("cross-section, 1:100"));
  EXPECT_THAT(html, HasSubstr("V5"));  // of the height, from 85 mm
  EXPECT_THAT(html, HasSubstr(">8.00</text>"));
  EXPECT_THAT(html, HasSubstr("Overhang −0.25 m"));
  EXPECT_THAT(html, HasSubstr("Tilt 5°"));
  EXPECT_THAT(html, Not(HasSubstr("School <street>")));
}

TEST(HtmlRoads, SayWhyThereIsNoSection) {
  SpacePart space = sample_road();
  EXPECT_THAT(html_roads({}, project_with(space), 0), Not(HasSubstr("No cross-section")));
  space.road->areas[1].from_y_m = -1e300;
  EXPECT_THAT(html_roads({}, project_with(space), 0), HasSubstr("No cross-section is drawn:"));
}

TEST(HtmlRoads, SpeakGerman) {
  const Texts german(Language::german, true);
  const std::string html = html_roads(german, project_with(sample_road()), 0);
  EXPECT_THAT(html, HasSubstr("Fahrstreifen 1, Richtung +x"));
  EXPECT_THAT(html, HasSubstr("0,0312 (0,0297 bis 0,0329) W/(lx·m²)"));
}

}  // namespace
}  // namespace report::html_roads_test
