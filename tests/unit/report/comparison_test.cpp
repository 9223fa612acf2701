#include "report/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

report::Comparison two_points(double second_b) {
  report::Comparison comparison;
  comparison.replicates = 16;
  report::ComparedPlane plane;
  plane.id = "p";
  plane.points = {{{0, 0, 0}, 0, 0, {100.0, 3.0}, {104.0, 4.0}},
                  {{1, 0, 0}, 1, 0, {200.0, 0.0}, {second_b, 0.0}}};
  comparison.planes.push_back(plane);
  report::compare_points(comparison);
  return comparison;
}

TEST(Comparison, CombinesBothErrors) {
  const report::Comparison comparison = two_points(200.0);
  const report::ComparedPlane& plane = comparison.planes[0];
  EXPECT_DOUBLE_EQ(plane.points[0].interval_lx(), 5.0);
  EXPECT_EQ(plane.held, 2u);
  EXPECT_EQ(plane.beyond, 0u);
  EXPECT_DOUBLE_EQ(plane.average_a_lx, 150.0);
  EXPECT_DOUBLE_EQ(plane.average_b_lx, 152.0);
  EXPECT_DOUBLE_EQ(plane.bias, -2.0 / 152.0);
  EXPECT_DOUBLE_EQ(plane.rms, std::sqrt(8.0) / 152.0);
  EXPECT_DOUBLE_EQ(plane.uo_b, 104.0 / 152.0);
  // t(0.9875) / t(0.975) at 15 degrees of freedom: two points at 5 % together.
  EXPECT_NEAR(comparison.widening, 2.4899 / 2.1314, 1e-3);
}

TEST(Comparison, ExactValuesThatDifferAreBeyond) {
  const report::Comparison comparison = two_points(200.01);
  EXPECT_EQ(comparison.beyond(), 1u);
  EXPECT_EQ(report::worst_points(comparison.planes[0], 1), (std::vector<std::size_t>{1}));
  EXPECT_NE(report::render_comparison_text(comparison, 1).find("DIFFERENT"), std::string::npos);
}

TEST(Comparison, NamesAreEscapedInHtml) {
  report::Comparison comparison = two_points(200.0);
  comparison.planes[0].id = "<b>";
  comparison.notes = {"<i>"};
  const std::string html = report::render_comparison_html(comparison, 2);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_EQ(html.find("<i>"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
}

}  // namespace
