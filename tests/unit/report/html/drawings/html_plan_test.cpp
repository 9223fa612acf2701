// What a plan has on paper: words that are read there, and values that keep apart.
#include "report/html/drawings/html_plan.h"

#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace report::html_plan_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kPoint_mm = 25.4 / 72;

struct Case {
  double width_m, depth_m;  // of the room
  double part;              // of it that the plane takes, from its corner
  int columns, rows;
  double lx;
};

SpacePart room_of(const Case& c) {
  SpacePart space;
  space.id = "a";
  space.footprint_m = {{0, 0}, {c.width_m, 0}, {c.width_m, c.depth_m}, {0, c.depth_m}};
  space.height_m = 3;
  PlanePart plane;
  plane.id = "p";
  plane.is_computed = true;
  calc::SensorGrid& grid = plane.grid;
  grid.origin_m = {0.1, 0.1, 0.75};
  grid.u = {1, 0, 0};
  grid.v = {0, 1, 0};
  grid.columns = c.columns;
  grid.rows = c.rows;
  grid.spacing_u_m = (c.width_m - 0.2) * c.part / c.columns;
  grid.spacing_v_m = (c.depth_m - 0.2) * c.part / c.rows;
  for (int row = 0; row < c.rows; ++row) {
    for (int column = 0; column < c.columns; ++column) {
      const glm::dvec3 at(0.1 + (column + 0.5) * grid.spacing_u_m,
                          0.1 + (row + 0.5) * grid.spacing_v_m, 0.75);
      plane.points.push_back(sample_point(column, row, at, estimate(c.lx + column + row, 1), 0));
    }
  }
  space.planes = {plane};
  return space;
}

// "--name:12.5px" of a style; 0 = it has none.
double length_in(const std::string& style, const std::string& name) {
  const std::size_t at = style.find("--" + name + ":");
  return at == std::string::npos ? 0.0 : std::atof(style.c_str() + at + name.size() + 3);
}

struct Printed {
  double points = 0.0;  // size of values
  double width_mm = 0.0, height_mm = 0.0;
  std::vector<glm::dvec2> middle_mm;  // of values
  std::vector<double> value_width_mm;
  std::string html;
};

// As the style sheet of paper has it.
Printed print(const Case& c, Paper paper) {
  const SpacePart space = room_of(c);
  Printed printed;
  printed.html = html_plan({}, space, space.planes[0], {own_scale(space.planes[0])}, "x",
                           place_beside_tables(paper));
  pugi::xml_document tree;
  EXPECT_TRUE(tree.load_string(printed.html.c_str()));
  const pugi::xml_node svg = tree.select_node("//svg[@class='plan']").node();
  const std::string style = svg.attribute("style").value();
  const double mm_by_px = length_in(style, "width") / svg.attribute("width").as_double();
  printed.width_mm = length_in(style, "width");
  printed.height_mm = mm_by_px * svg.attribute("height").as_double();
  EXPECT_NEAR(length_in(style, "px") * mm_by_px, 25.4 / 96, 0.02 * 25.4 / 96);
  const bool is_of_paper = length_in(style, "number") == 0.0;
  const char* path =
      is_of_paper ? "//g[@class='paper-numbers']/text" : "//g[@class='numbers']/text[not(@class)]";
  for (const pugi::xpath_node& node : tree.select_nodes(path)) {
    const double on_screen_px = node.node().parent().attribute("font-size").as_double();
    const double size_px = is_of_paper ? on_screen_px : length_in(style, "number");
    const double lower_px = is_of_paper ? 0.0 : length_in(style, "lower");
    EXPECT_NEAR(lower_px, 0.36 * (size_px - on_screen_px), 0.02);
    printed.points = size_px * mm_by_px / kPoint_mm;
    const double y = node.node().attribute("y").as_double() + lower_px - 0.36 * size_px;
    printed.middle_mm.push_back(mm_by_px * glm::dvec2(node.node().attribute("x").as_double(), y));
    const std::string words = node.node().text().get();
    printed.value_width_mm.push_back(0.58 * size_px * mm_by_px * static_cast<double>(words.size()));
  }
  return printed;
}

const std::vector<Case> kCases{
    {5, 4, 1, 10, 8, 480},   {5, 4, 0.4, 10, 8, 480},     {3, 3, 1, 4, 4, 900},
    {60, 40, 1, 60, 40, 90}, {60, 40, 0.5, 80, 60, 1240}, {30, 2, 1, 40, 3, 110},
    {2, 20, 1, 3, 30, 110},  {8, 6, 1, 1, 1, 500},        {100, 100, 1, 120, 120, 20},
};

TEST(PlanOnPaper, ValuesHaveSixAndAHalfPointsAndKeepApart) {
  for (const Paper paper : {Paper::a4, Paper::letter}) {
    for (const Case& c : kCases) {
      SCOPED_TRACE(testing::Message() << c.width_m << " x " << c.depth_m << " m, " << c.columns
                                      << " x " << c.rows << ", " << c.lx << " lx");
      const Printed printed = print(c, paper);
      EXPECT_LE(printed.width_mm, 74.01);
      // Widths are written in hundredths.
      EXPECT_LE(printed.height_mm, 43.0 * (1.0 + 0.005 / printed.width_mm) + 0.01);
      ASSERT_FALSE(printed.middle_mm.empty());
      EXPECT_GE(printed.points, 6.49);
      EXPECT_LE(printed.points, 8.01);
      const double line_mm = printed.points * kPoint_mm;
      for (std::size_t i = 0; i < printed.middle_mm.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          const glm::dvec2 apart = glm::abs(printed.middle_mm[i] - printed.middle_mm[k]);
          const double width = 0.5 * (printed.value_width_mm[i] + printed.value_width_mm[k]);
          EXPECT_TRUE(apart.x > width || apart.y > line_mm) << i << ", " << k;
        }
      }
    }
  }
}

TEST(PlanOnPaper, SaysWhereValuesAreLeftOut) {
  const Printed all = print(kCases[2], Paper::a4), some = print(kCases[1], Paper::a4);
  EXPECT_EQ(all.middle_mm.size(), 16U);
  EXPECT_THAT(all.html, Not(HasSubstr("Printed: one value")));
  EXPECT_LT(some.middle_mm.size(), 40U);
  EXPECT_GE(some.middle_mm.size(), 6U);
  EXPECT_THAT(some.html, HasSubstr("Printed: one value for "));
}

// A corridor of 24 m at the full width of a page.
TEST(PlanInPieces, ALongPlaneIsCutUntilItsValuesAreReadAndAllAreThere) {
  const SpacePart space = room_of({24.2, 2.2, 1.0, 48, 4, 100});
  const auto drawn = [&](int pieces) {
    return html_plan({}, space, space.planes[0], {own_scale(space.planes[0])}, "x",
                     {{180, 92}, pieces});
  };
  const auto count = [](const std::string& html, const std::string& words) {
    std::size_t times = 0;
    for (std::size_t at = html.find(words); at != std::string::npos; at = html.find(words, at + 1))
      ++times;
    return times;
  };
  const std::string whole = drawn(1), cut = drawn(5);
  EXPECT_THAT(whole, HasSubstr("Printed"));
  EXPECT_EQ(count(whole, "<use "), 0u);
  EXPECT_THAT(cut, HasSubstr("id=\"x-plan\""));
  EXPECT_GE(count(cut, "<use href=\"#x-plan\"/>"), 1u);
  EXPECT_EQ(count(cut, "viewBox=\"0 0 "), count(whole, "viewBox=\"0 0 "))
      << "of the pieces the first one alone begins at 0";
  EXPECT_LT(count(cut, "unprinted"), count(whole, "unprinted") + 1);
  EXPECT_LT(length_in(cut, "px"), length_in(whole, "px")) << "all is larger on paper";
}

TEST(PlanInPieces, ASquareOneStaysWhole) {
  const SpacePart space = room_of({5.2, 5.2, 1.0, 10, 10, 100});
  const std::string html =
      html_plan({}, space, space.planes[0], {own_scale(space.planes[0])}, "x", {{180, 92}, 1});
  EXPECT_THAT(html, Not(HasSubstr("<use ")));
}

}  // namespace
}  // namespace report::html_plan_test
