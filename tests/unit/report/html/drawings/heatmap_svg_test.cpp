#include "report/html/drawings/heatmap_svg.h"

#include "tests/support/hostile_document.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <set>
#include <sstream>
#include <string>

namespace report::heatmap_svg_test {
namespace {

using testing::HasSubstr;
using testing::Not;

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  const auto result = document.load_buffer(svg.data(), svg.size());
  EXPECT_TRUE(result) << result.description() << " at " << result.offset;
  return document;
}

std::string svg_of(const Document& document) {
  const SpacePart& space = document.projects[0].spaces[0];
  return render_heatmap_svg({}, space, space.planes[0], {own_scale(space.planes[0])});
}

// A viewer of SVG files knows neither our page's style nor its variables.
TEST(HeatmapSvg, StandsAlone) {
  const std::string svg = svg_of(small_document());
  EXPECT_THAT(svg, HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(svg, Not(HasSubstr("var(")));
  EXPECT_THAT(svg, Not(HasSubstr("currentColor")));
  const pugi::xml_document document = parsed(svg);
  const std::string style = document.child("svg").child_value("style");
  const std::set<std::string> plain{"plan", "unit", "missed"};
  for (const auto& node : document.select_nodes("//@class")) {
    std::istringstream words(node.attribute().value());
    for (std::string word; words >> word;) {
      EXPECT_TRUE(plain.contains(word) || style.find("." + word) != std::string::npos) << word;
    }
  }
}

TEST(HeatmapSvg, HoldsACellForEachPointAndTheColourBar) {
  const Document document = small_document();
  const pugi::xml_document svg = parsed(svg_of(document));
  EXPECT_EQ(svg.select_nodes("//g[@class='cells']/path").size(),
            document.projects[0].spaces[0].planes[0].points.size());
  EXPECT_EQ(svg.select_nodes("//svg[@class='colour-bar']").size(), 1u);
  EXPECT_EQ(svg.select_nodes("//path[@class='min-mark']").size(), 1u);
}

TEST(HeatmapSvg, SaysAmongWhomItsScaleIsShared) {
  const Document document = small_document();
  const SpacePart& space = document.projects[0].spaces[0];
  EXPECT_THAT(svg_of(document), HasSubstr(">The colour scale belongs to this plane alone.</text>"));
  EXPECT_THAT(render_heatmap_svg({}, space, space.planes[0],
                                 {own_scale(space.planes[0]), ScaleSharing::room}),
              HasSubstr(">One colour scale for all planes of this room or area.</text>"));
}

// Each limit takes a line above the bar.
TEST(HeatmapSvg, HasRoomForManyLimits) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  for (int i = 0; i < 12; ++i) {
    plane.findings.push_back(
        sample_finding(rules::Metric::average, 300.0 + 10.0 * i, estimate(310, 5)));
  }
  const pugi::xml_document svg = parsed(svg_of(document));
  const pugi::xml_node root = svg.child("svg");
  const pugi::xml_node bar = svg.select_node("//svg[@class='colour-bar']").node();
  const std::string place = bar.parent().attribute("transform").value();  // translate(x y)
  const double top = std::stod(place.substr(place.find(' ')));
  EXPECT_LE(top + bar.attribute("height").as_double(), root.attribute("height").as_double());
}

TEST(HeatmapSvg, NothingEscapesFromNames) {
  const pugi::xml_document svg = parsed(svg_of(hostile_document()));
  EXPECT_EQ(svg.select_nodes("//script").size(), 0u);
  EXPECT_EQ(svg.select_nodes("//@onerror").size(), 0u);
}

}  // namespace
}  // namespace report::heatmap_svg_test
