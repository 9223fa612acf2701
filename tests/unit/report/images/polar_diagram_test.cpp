#include "report/images/polar_diagram.h"

#include "tests/support/web_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <string>

namespace report::polar_diagram_test {
namespace {

using test_support::angle_steps;
using test_support::make_web;

const PolarLine& line_of(const PolarDrawing& drawing, PolarRole role) {
  return *std::find_if(drawing.lines.begin(), drawing.lines.end(), [&](const PolarLine& line) {
    return line.role == role && line.points.size() > 2;
  });
}

PolarDrawing spot_towards(double c_deg) {
  return draw_polar_diagram(
      make_web(angle_steps(0, 360, 90), angle_steps(0, 90, 10),
               [=](double c, double g) { return c == c_deg && g == 60 ? 1000.0 : 10.0; }),
      "x");
}

// The point furthest from the centre, against it.
PolarPoint peak_of(const PolarDrawing& drawing, PolarRole role) {
  const PolarPoint centre{0.5 * drawing.width, 0.0};
  PolarPoint best = centre;
  for (const PolarPoint& point : line_of(drawing, role).points) {
    if (std::abs(point.x - centre.x) > std::abs(best.x - centre.x)) best = point;
  }
  return {best.x - centre.x, best.y};
}

TEST(PolarDiagram, HasC0AndC90OnTheRight) {
  EXPECT_GT(peak_of(spot_towards(0), PolarRole::c0_c180).x, 150.0);
  EXPECT_LT(peak_of(spot_towards(180), PolarRole::c0_c180).x, -150.0);
  EXPECT_GT(peak_of(spot_towards(90), PolarRole::c90_c270).x, 150.0);
  EXPECT_LT(peak_of(spot_towards(270), PolarRole::c90_c270).x, -150.0);
}

TEST(PolarDiagram, HasNadirDown) {
  const PolarDrawing drawing = draw_polar_diagram(
      make_web({0}, {0, 90, 180}, [](double, double g) { return 180.0 - g; }), "x");
  const std::vector<PolarPoint>& points = line_of(drawing, PolarRole::c0_c180).points;
  const auto lowest = std::max_element(points.begin(), points.end(),
                                       [](PolarPoint a, PolarPoint b) { return a.y < b.y; });
  EXPECT_NEAR(lowest->x, 0.5 * drawing.width, 1e-6);
  EXPECT_GT(lowest->y, 0.5 * drawing.height);
}

TEST(PolarDiagram, LeavesADarkHalfOut) {
  const auto height = [](double first, double last) {
    return draw_polar_diagram(make_web({0}, {first, last}, [](double, double) { return 1.0; }), "x")
        .height;
  };
  EXPECT_LT(height(0, 90), 400.0);
  EXPECT_LT(height(90, 180), 400.0);
  EXPECT_GT(height(0, 180), 500.0);
}

TEST(PolarDiagram, HasRoundRings) {
  EXPECT_DOUBLE_EQ(polar_ring_step(1500.0), 500.0);
  EXPECT_DOUBLE_EQ(polar_ring_step(698.0), 200.0);
  EXPECT_DOUBLE_EQ(polar_ring_step(101.0), 20.0);
  for (double highest = 0.013; highest < 1.0e5; highest *= 1.07) {
    const double rings = highest / polar_ring_step(highest);
    EXPECT_GT(rings, 2.0) << highest;
    EXPECT_LE(rings, 6.0) << highest;
  }
}

TEST(PolarSvg, IsWellFormedWhateverTheNameHolds) {
  PolarDrawing drawing = draw_polar_diagram(
      make_web({0}, {0, 90}, [](double, double) { return 1.0; }), "<b>&\"\x1b[1m\xff");
  const std::string svg = render_polar_svg(drawing);
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(svg.c_str())) << svg;
  EXPECT_TRUE(std::string(xml.child("svg").child_value("title")).find("<b>&\"") !=
              std::string::npos);
  EXPECT_THAT(svg, ::testing::HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(svg, ::testing::HasSubstr("stroke-dasharray"));
  EXPECT_EQ(svg.find('\x1b'), std::string::npos);
}

TEST(PolarPng, IsAPngOfTwiceTheDrawing) {
  const PolarDrawing drawing = spot_towards(90);
  const std::string png = render_polar_png(drawing);
  ASSERT_GT(png.size(), 1000u);
  EXPECT_EQ(png.substr(0, 4), "\x89PNG");
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(png[i]); };
  EXPECT_EQ(byte(18) * 256 + byte(19), std::lround(2.0 * drawing.width));
}

}  // namespace
}  // namespace report::polar_diagram_test
