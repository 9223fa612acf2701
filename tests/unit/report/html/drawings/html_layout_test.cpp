// Plan and elevation of a room, against its own metres.
#include "report/html/drawings/html_layout.h"

#include "report/document/luminaire_labels.h"
#include "report/html/drawings/technical_drawing.h"

#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>
#include <vector>

namespace report::html_layout_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

// An L of 14 m by 9.5 m and 4 m height, a panel of 1.2 m by 0.6 m and a spot in it, one plane.
Document hall() {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.footprint_m = {{0, 0}, {14, 0}, {14, 9.5}, {11.6, 9.5}, {11.6, 2}, {0, 2}};
  space.floor_z_m = 3.0;
  space.height_m = 4.0;
  LuminaireMark panel{{3, 1, 6.9}, "panel"};
  panel.outline_m = {{2.4, 0.7}, {3.6, 0.7}, {3.6, 1.3}, {2.4, 1.3}};
  space.luminaires = {panel, {{12.5, 8, 5.5}, "spot"}};
  space.bodies = {{"desk", 3.0, 3.75, {{glm::dvec2(5, 0.5), glm::dvec2(6, 0.5)}}, "oak"}};
  space.planes[0].grid.origin_m = {0.5, 0.25, 3.8};
  return document;
}

std::string shown(Document document) {
  document.projects[0].luminaires.resize(2);
  document.projects[0].luminaires[0].type_id = "panel";
  document.projects[0].luminaires[1].type_id = "spot";
  label_luminaires(document.projects[0]);
  return html_layout({}, document.projects[0], document.projects[0].spaces[0]);
}

struct Drawing {
  explicit Drawing(const std::string& html) {
    EXPECT_TRUE(tree.load_string(html.c_str(), pugi::parse_full)) << html;
  }
  std::vector<std::string> texts() const {
    std::vector<std::string> found;
    for (const pugi::xpath_node& node : tree.select_nodes("//svg/text"))
      found.emplace_back(node.node().child_value());
    return found;
  }
  // Numbers of the k-th path of that kind.
  std::vector<double> numbers(const std::string& kind, std::size_t k = 0) const {
    const pugi::xpath_node_set paths = tree.select_nodes(("//path[@class='" + kind + "']").c_str());
    if (k >= paths.size()) return {};
    const std::string data = paths[k].node().attribute("d").value();
    std::vector<double> found;
    const std::regex number("-?[0-9.]+");
    for (auto i = std::sregex_iterator(data.begin(), data.end(), number);
         i != std::sregex_iterator(); ++i) {
      found.push_back(std::stod(i->str()));
    }
    return found;
  }
  pugi::xml_document tree;
};

TEST(DrawingScale, IsTheLargestUsualOneThatFits) {
  EXPECT_EQ(drawing_scale({12, 11}, {150, 140}), 100.0);
  EXPECT_EQ(drawing_scale({15, 1}, {150, 140}), 100.0);  // just fits
  EXPECT_EQ(drawing_scale({15.01, 1}, {150, 140}), 200.0);
  EXPECT_EQ(drawing_scale({31, 1}, {150, 140}), 250.0);
  EXPECT_EQ(drawing_scale({0.3, 0.3}, {150, 140}), 2.5);
  EXPECT_EQ(drawing_scale({0.01, 0.01}, {150, 140}), 1.0);
  EXPECT_EQ(drawing_scale({3000, 1}, {150, 140}), 20000.0);
}

TEST(HtmlLayout, IsToScale) {
  const std::string html = shown(hall());
  EXPECT_THAT(html, HasSubstr("1:100"));  // 14 m by 9.5 m + 4 m in 150 mm by 140 mm
  const std::vector<double> wall = Drawing(html).numbers("wall");
  ASSERT_EQ(wall.size(), 12U);
  EXPECT_NEAR(wall[2] - wall[0], 140.0, 0.02);
  EXPECT_NEAR(wall[3] - wall[5], 95.0, 0.02);  // y points down
  const std::vector<double> side = Drawing(html).numbers("wall", 1);
  ASSERT_EQ(side.size(), 8U);
  EXPECT_NEAR(side[2] - side[0], 140.0, 0.02);
  EXPECT_NEAR(side[1] - side[5], 40.0, 0.02);
}

TEST(HtmlLayout, HasDimensionsNumbersAndHeights) {
  const std::vector<std::string> texts = Drawing(shown(hall())).texts();
  EXPECT_THAT(texts, IsSupersetOf({"11.60", "2.40", "14.00", "2.00", "7.50", "9.50"}));
  // Over the floor: room, luminaires and the plane.
  EXPECT_THAT(texts, IsSupersetOf({"0.00", "4.00", "3.90", "2.50", "0.80"}));
  for (const char* sign : {"A1", "B1", "A"})
    EXPECT_EQ(std::count(texts.begin(), texts.end(), sign), 1) << sign;
  EXPECT_THAT(texts, IsSupersetOf({"↖ x = 0.00, y = 0.00", "Elevation, seen towards +y"}));
}

TEST(HtmlLayout, LooksAtTheLongerSide) {
  Document document = hall();
  for (glm::dvec2& corner : document.projects[0].spaces[0].footprint_m)
    corner = {corner.y, corner.x};
  EXPECT_THAT(shown(document), HasSubstr("Elevation, seen towards −x"));
}

// Ahead of the arrow is its first corner, behind it the middle of the second and the fourth.
TEST(HtmlLayout, NorthIsDrawnWhereTheProjectSays) {
  Document document = hall();
  EXPECT_THAT(shown(document), Not(HasSubstr("north")));
  for (const auto& [north_deg, ahead] :
       {std::pair{90.0, glm::dvec2(0, -1)}, std::pair{0.0, glm::dvec2(1, 0)},
        std::pair{-135.0, glm::dvec2(-0.7071, 0.7071)}}) {
    document.projects[0].north_deg = north_deg;
    const std::vector<double> arrow = Drawing(shown(document)).numbers("north");
    ASSERT_EQ(arrow.size(), 8U);
    const glm::dvec2 tip(arrow[0], arrow[1]);
    const glm::dvec2 foot(0.5 * (arrow[2] + arrow[6]), 0.5 * (arrow[3] + arrow[7]));
    const glm::dvec2 way = glm::normalize(tip - foot);
    EXPECT_NEAR(way.x, ahead.x, 0.01) << north_deg;
    EXPECT_NEAR(way.y, ahead.y, 0.01) << north_deg;
  }
}

TEST(HtmlLayout, PlanesOfOneOutlineShareALetter) {
  Document document = hall();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes.push_back(planes[0]);
  planes[1].name = "Faces";
  planes[1].grid.origin_m.z = 4.2;
  planes.push_back(planes[0]);
  planes[2].name = "Beside";
  planes[2].grid.origin_m.x += 1.0;
  const std::string html = shown(document);
  EXPECT_THAT(html, HasSubstr("<b>A</b> Work plane (0.80 m), Faces (1.20 m)</li>"));
  EXPECT_THAT(html, HasSubstr("<b>B</b> Beside (0.80 m)</li>"));
}

// Numbers and letters do not cover each other as long as there is a place.
TEST(HtmlLayout, LabelsOfOnePlaceStandApart) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  space.luminaires.assign(4, {{5, 1, 6.9}, "spot"});
  const Drawing drawing(shown(document));
  std::vector<glm::dvec2> places;
  for (const pugi::xpath_node& node : drawing.tree.select_nodes("//text[@class='number']")) {
    places.emplace_back(node.node().attribute("x").as_double(),
                        node.node().attribute("y").as_double());
  }
  ASSERT_EQ(places.size(), 4U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(glm::distance(places[i], places[k]), 2.0);
  }
}

TEST(HtmlLayout, WhatIsTooMuchIsTold) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  space.luminaires.assign(201, {{5, 1, 6.9}, "spot"});
  space.planes[0].points.assign(1201, space.planes[0].points[0]);
  space.bodies_left_out = 3;
  const std::string html = shown(document);
  for (const char* words : {"Too many luminaires for marks", "Too many points to be drawn", "3 "})
    EXPECT_THAT(html, HasSubstr(words));
  EXPECT_THAT(html, Not(HasSubstr("class=\"number\"")));
  EXPECT_THAT(html, Not(HasSubstr("class=\"points\"")));
}

// Every label looks at all others: thousands of them would take minutes.
TEST(HtmlLayout, ThousandsOfPlanesHaveNoLetters) {
  Document document = hall();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes.resize(5000, planes[0]);
  for (std::size_t k = 0; k < planes.size(); ++k)
    planes[k].grid.origin_m.x = 0.002 * static_cast<double>(k);
  const std::string html = shown(document);
  EXPECT_THAT(html, HasSubstr("Too many planes for letters."));
  EXPECT_THAT(html, Not(HasSubstr("class=\"letter\"")));
  EXPECT_THAT(html, Not(HasSubstr("layout-key")));
  EXPECT_THAT(html, HasSubstr("class=\"area\""));
}

TEST(HtmlLayout, ManyRoomsHaveSmallDrawings) {
  Document document = hall();
  document.projects[0].spaces.resize(9, document.projects[0].spaces[0]);
  EXPECT_THAT(shown(document), HasSubstr("1:200"));  // 9.5 m + 4 m in 78 mm
  // Beside each other where that is as large.
  for (SpacePart& space : document.projects[0].spaces)
    space.footprint_m = {{0, 0}, {12, 0}, {12, 9.5}, {0, 9.5}};
  document.projects[0].spaces[0].luminaires.clear();
  const Drawing drawing(shown(document));
  EXPECT_NEAR(drawing.numbers("wall")[5], drawing.numbers("wall", 1)[5], 60.0);
  EXPECT_GT(drawing.numbers("wall", 1)[0], drawing.numbers("wall")[2]);
}

// At 45 degrees an opening of 0.6 m is as high as it is deep.
TEST(HtmlLayout, TiltedLuminairesAreTiltedInTheElevation) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  LuminaireMark& mark = space.luminaires[0];
  mark.axis = glm::normalize(glm::dvec3(1, 0, -1));
  space.luminaires.resize(1);
  const std::vector<double> flat = Drawing(shown(document)).numbers("luminaire");
  const std::vector<double> side = Drawing(shown(document)).numbers("luminaire", 1);
  ASSERT_EQ(side.size(), 8U);
  EXPECT_NEAR(side[2] - side[0], 12.0, 0.02);            // 1.2 m at 1:100
  EXPECT_NEAR(std::abs(side[3] - side[1]), 12.0, 0.02);  // and as high
  EXPECT_LT(side[3], side[1]);                           // light goes to +x: up there
  EXPECT_NEAR(flat[2] - flat[0], 12.0, 0.02);
}

TEST(HtmlLayout, HighRoomsKeepTheirHeading) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  space.footprint_m = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  space.height_m = 25.0;
  space.luminaires.clear();
  space.planes.clear();
  const Drawing drawing(shown(document));
  EXPECT_GT(drawing.tree.select_node("//svg").node().attribute("width").as_double(), 54.0);
}

TEST(HtmlLayout, OpenSpacesAreDrawnByWhatIsInThem) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  space.footprint_m.clear();
  const std::string html = shown(document);
  EXPECT_THAT(html, Not(HasSubstr("class=\"wall\"")));
  EXPECT_THAT(html, HasSubstr("class=\"luminaire\""));
  space.luminaires.clear();
  space.bodies.clear();
  space.planes.clear();
  EXPECT_EQ(shown(document), "");
}

TEST(HtmlLayout, NamesAreText) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  space.name = "<b>\"&";
  space.planes[0].name = "<script>";
  const std::string html = shown(document);
  EXPECT_TRUE(pugi::xml_document().load_string(html.c_str())) << html;
  EXPECT_THAT(html, Not(HasSubstr("<script>")));
}

// A post in a corner and a beam: nothing else says how large the room is.
TEST(HtmlLayout, RoomsFromFilesAreDrawnByTheLinesOfTheirSurfaces) {
  Document document = hall();
  SpacePart& space = document.projects[0].spaces[0];
  EXPECT_THAT(shown(document), Not(HasSubstr("class=\"surface\"")));
  space.footprint_m.clear();
  space.surface_lines_m = {{20, 0, 3}, {20, 0, 7}, {0, 0, 7}, {20, 0, 7}};
  const std::string html = shown(document);
  const Drawing drawing(html);
  // From above the post is a point; the elevation has both.
  EXPECT_EQ(drawing.numbers("surface", 0).size(), 4U);
  EXPECT_EQ(drawing.numbers("surface", 1).size(), 8U);
  EXPECT_THAT(html, HasSubstr("bends and ends"));
  EXPECT_THAT(html, HasSubstr("heights are above z = 0."));
  EXPECT_THAT(shown(hall()), Not(HasSubstr("z = 0")));
  EXPECT_THAT(html, Not(HasSubstr("of these lines")));
  space.surface_lines_left_out = 7;
  EXPECT_THAT(shown(document), HasSubstr("The 7 shortest of these lines"));
}

}  // namespace
}  // namespace report::html_layout_test
