#include "report/tools/compare/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace comparison_test {
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

report::Comparison hundred_points(double offset_lx, std::optional<double> average_half_width_lx) {
  report::Comparison comparison;
  report::ComparedPlane plane;
  plane.id = "p";
  for (int k = 0; k < 100; ++k) {
    plane.points.push_back({{k, 0, 0}, k, 0, {100.0 + offset_lx, 5.0}, {100.0, 5.0}});
  }
  plane.average_half_width_a_lx = average_half_width_lx;
  plane.average_half_width_b_lx = 0.3;
  comparison.planes.push_back(plane);
  report::compare_points(comparison);
  return comparison;
}

TEST(Comparison, SeesACommonBiasByTheAverage) {
  const report::Comparison biased = hundred_points(3.0, 0.4);
  EXPECT_EQ(biased.beyond(), 0u);
  EXPECT_EQ(biased.planes[0].held, 100u);
  EXPECT_DOUBLE_EQ(biased.planes[0].average_interval_lx().value(), 0.5);
  EXPECT_EQ(biased.averages_beyond(), 1u);
  EXPECT_FALSE(biased.is_alike());
  EXPECT_NE(report::render_comparison_text(biased, 0).find("DIFFERENT: 0 of 100 points and 1 of 1"),
            std::string::npos);
  EXPECT_NE(report::render_comparison_json(biased).find("\"is_average_beyond\": true"),
            std::string::npos);
  EXPECT_TRUE(hundred_points(0.5, 0.4).is_alike());
}

TEST(Comparison, AnAverageOfUnknownIntervalIsNotJudgedAndSaysSo) {
  const report::Comparison comparison = hundred_points(3.0, std::nullopt);
  EXPECT_EQ(comparison.averages_judged(), 0u);
  EXPECT_TRUE(comparison.is_alike());
  EXPECT_NE(report::render_comparison_text(comparison, 0).find("not judged"), std::string::npos);
  EXPECT_NE(report::render_comparison_json(comparison).find("\"average_interval_lx\": null"),
            std::string::npos);
}

TEST(Comparison, NoNumberIsAlikeNoNumberOnly) {
  const double nothing = std::nan("");
  report::Comparison comparison = two_points(200.0);
  auto& points = comparison.planes[0].points;
  points.push_back({{2, 0, 0}, 2, 0, {nothing, nothing}, {nothing, nothing}});
  report::compare_points(comparison);
  EXPECT_EQ(comparison.beyond(), 0u);
  EXPECT_DOUBLE_EQ(comparison.planes[0].average_a_lx, 150.0);
  points.push_back({{3, 0, 0}, 3, 0, {nothing, nothing}, {5.0, 0.1}});
  report::compare_points(comparison);
  EXPECT_EQ(comparison.beyond(), 1u);
  EXPECT_EQ(report::worst_points(comparison.planes[0], 4), (std::vector<std::size_t>{3, 0, 1, 2}));
  EXPECT_NE(report::render_comparison_html(comparison, 4).find("<svg"), std::string::npos);
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

TEST(Comparison, PageIsInTheReadersLanguage) {
  report::Comparison comparison = two_points(200.0);
  comparison.notes = {"a note"};
  report::compare_points(comparison);
  const std::string html = report::render_comparison_html(
      comparison, 2, report::Texts(report::Language::german, true), report::Paper::letter);
  for (const char* words : {"<html lang=\"de\">", "Mittelwert von A", "size: letter;",
                            "<span lang=\"en\">a note</span>"}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(html.find("Average"), std::string::npos);
}

}  // namespace
}  // namespace comparison_test
