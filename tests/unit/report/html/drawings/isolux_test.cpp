#include "report/html/drawings/isolux.h"

#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace report::isolux_test {
namespace {

// columns x rows square cells; E(u, v) in metres from the grid's corner.
PlanePart field_plane(int columns, int rows, double spacing_m,
                      const std::function<double(double, double)>& lx) {
  PlanePart plane;
  plane.is_computed = true;
  plane.grid.columns = columns;
  plane.grid.rows = rows;
  plane.grid.spacing_u_m = plane.grid.spacing_v_m = spacing_m;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double u = (column + 0.5) * spacing_m, v = (row + 0.5) * spacing_m;
      plane.points.push_back(sample_point(column, row, {u, v, 0}, estimate(lx(u, v), 0), 0));
    }
  }
  return plane;
}

bool is_between_centres(const PlanePart& plane, const glm::dvec2& p) {
  const double half = 0.5 * plane.grid.spacing_u_m;
  return p.x >= half && p.y >= half && p.x <= (2 * plane.grid.columns - 1) * half &&
         p.y <= (2 * plane.grid.rows - 1) * half;
}

TEST(Isolux, LinearFieldIsMetExactly) {
  const auto lx = [](double u, double v) { return 100 + 31 * u - 17 * v; };
  const PlanePart plane = field_plane(13, 9, 0.7, lx);
  const std::vector<IsoluxLine> lines = isolux_lines(plane, 140);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].is_closed);
  EXPECT_GT(lines[0].points_m.size(), 10U);
  for (const glm::dvec2& p : lines[0].points_m) {
    if (!is_between_centres(plane, p)) continue;
    EXPECT_NEAR(lx(p.x, p.y), 140, 1e-9);
  }
}

// Straight on, as the colours of the outermost cells do.
TEST(Isolux, LinesReachTheEdgeOfTheGrid) {
  const PlanePart plane = field_plane(13, 9, 0.7, [](double u, double) { return 100 + 31 * u; });
  const std::vector<IsoluxLine> lines = isolux_lines(plane, 240);
  ASSERT_EQ(lines.size(), 1U);
  const std::vector<glm::dvec2>& line = lines[0].points_m;
  EXPECT_NEAR(std::min(line.front().y, line.back().y), 0.0, 1e-12);
  EXPECT_NEAR(std::max(line.front().y, line.back().y), 9 * 0.7, 1e-12);
  for (const glm::dvec2& p : line) EXPECT_NEAR(p.x, 140.0 / 31, 1e-9);
}

// A point source 2.5 m above the middle: E = I cos^3 / h^2, so that isolux lines are circles. On
// the side between two centres the error of linear interpolation is at most h^2 / 8 max|E''|.
TEST(Isolux, PointSourceGivesCirclesWithinWhatTheGridAllows) {
  constexpr double kHeight = 2.5, kIntensity = 3000, kMiddle = 4.0;
  const auto of_radius = [](double r) {
    return kIntensity * kHeight / std::pow(kHeight * kHeight + r * r, 1.5);
  };
  double last_error = 0;
  for (const int cells : {20, 40, 80}) {
    const double spacing = 2 * kMiddle / cells;
    const PlanePart plane = field_plane(cells, cells, spacing, [&](double u, double v) {
      return of_radius(std::hypot(u - kMiddle, v - kMiddle));
    });
    double worst = 0;
    for (const double level : {100.0, 150.0, 200.0, 350.0}) {
      const double radius =
          std::sqrt(std::pow(kIntensity * kHeight / level, 2.0 / 3.0) - kHeight * kHeight);
      // |E''| <= 3 I / h^4 anywhere; E' = -3 I h r / (h^2 + r^2)^(5/2). A side is nowhere steeper
      // across the line than along the radius: 1 / sqrt(2) at worst.
      const double curvature = 3 * kIntensity / std::pow(kHeight, 4);
      const double slope =
          3 * kIntensity * kHeight * radius / std::pow(kHeight * kHeight + radius * radius, 2.5);
      const double allowed = spacing * spacing / 8 * curvature / slope * 1.1;
      const std::vector<IsoluxLine> lines = isolux_lines(plane, level);
      ASSERT_EQ(lines.size(), 1U);
      EXPECT_TRUE(lines[0].is_closed);
      for (const glm::dvec2& p : lines[0].points_m) {
        const double error = std::abs(glm::distance(p, glm::dvec2(kMiddle)) - radius);
        EXPECT_LE(error, allowed) << cells << " cells, " << level << " lx";
        worst = std::max(worst, error);
      }
    }
    RecordProperty("worst_position_error_mm_" + std::to_string(cells),
                   std::to_string(1000 * worst));
    if (last_error > 0) {
      EXPECT_LT(worst, last_error / 3);  // second order: 4
    }
    last_error = worst;
  }
}

TEST(Isolux, SaddleIsResolvedByItsMean) {
  const auto corner = [](double u, double v) { return (u < 1) == (v < 1) ? 300.0 : 100.0; };
  const PlanePart plane = field_plane(2, 2, 1.0, corner);  // mean 200
  for (const double level : {199.0, 201.0}) {
    const std::vector<IsoluxLine> lines = isolux_lines(plane, level);
    ASSERT_EQ(lines.size(), 2U);
    // The middle is above 199: lines keep away from the low corners' diagonal, one for each.
    const bool is_joined = level < 200;
    for (const IsoluxLine& line : lines) {
      std::vector<glm::dvec2> inner;
      for (const glm::dvec2& p : line.points_m) {
        if (is_between_centres(plane, p)) inner.push_back(p);
      }
      ASSERT_EQ(inner.size(), 2U);
      const glm::dvec2 middle = 0.5 * (inner[0] + inner[1]);
      const bool is_by_low_corner = (middle.x < 1) != (middle.y < 1);
      EXPECT_EQ(is_by_low_corner, is_joined);
    }
  }
}

TEST(Isolux, MissingPointsEndTheLine) {
  PlanePart plane = field_plane(9, 9, 1.0, [](double u, double) { return u; });
  std::erase_if(plane.points, [](const PointRow& p) { return p.column == 4 && p.row == 4; });
  const std::vector<IsoluxLine> lines = isolux_lines(plane, 4.75);
  ASSERT_EQ(lines.size(), 2U);
  for (const IsoluxLine& line : lines) {
    for (const glm::dvec2& p : line.points_m) {
      EXPECT_NEAR(p.x, 4.75, 1e-12);
      EXPECT_TRUE(p.y <= 3.5 + 1e-12 || p.y >= 5.5 - 1e-12);
    }
  }
}

TEST(Isolux, EvenFieldHasNone) {
  EXPECT_TRUE(isolux_lines(field_plane(5, 5, 1, [](double, double) { return 300; }), 300).empty());
}

TEST(Isolux, SingleRowHasOneAcrossIt) {
  const std::vector<IsoluxLine> lines =
      isolux_lines(field_plane(9, 1, 1, [](double u, double) { return u; }), 4);
  ASSERT_EQ(lines.size(), 1U);
  for (const glm::dvec2& p : lines[0].points_m) EXPECT_NEAR(p.x, 4.0, 1e-12);
  EXPECT_NEAR(glm::distance(lines[0].points_m.front(), lines[0].points_m.back()), 1.0, 1e-12);
}

TEST(Isolux, TooManyCornersAreLeftOutTheRequiredLevelLast) {
  const PlanePart plane = field_plane(40, 40, 1, [](double u, double) { return 100 * u; });
  std::vector<IsoluxLevel> levels{{1000, false, {}}, {2000, true, {}}, {3000, false, {}}};
  std::vector<IsoluxLevel> few = levels;
  EXPECT_TRUE(trace_isolux(plane, 1000, levels));
  EXPECT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].lines.at(0).points_m.size(), 42U);  // centres and both edges
  EXPECT_FALSE(trace_isolux(plane, 60, few));
  ASSERT_EQ(few.size(), 1U);
  EXPECT_TRUE(few[0].is_required);
}

TEST(IsoluxLevels, AreRoundAndHoldTheLimit) {
  const PlanePart plane = field_plane(10, 2, 1, [](double u, double) { return 100 * u; });
  const ColourScale scale = make_colour_scale(50, 950);  // steps of 100 from 0
  std::vector<double> lx;
  for (const IsoluxLevel& level : isolux_levels(plane, scale, {{"average ≥ 500 lx", 500}}, 4)) {
    lx.push_back(level.value);
    EXPECT_EQ(level.is_required, level.value == 500);
  }
  EXPECT_EQ(lx, (std::vector<double>{200, 400, 500, 600, 800}));
  EXPECT_EQ(isolux_levels(plane, scale, {{"average ≥ 5000 lx", 5000}}, 9).size(), 9U);
}

// The value is the number of the column: the line between two stations of the first leg lies where
// they meet, on all rows, and that of the mitre runs through the corner.
TEST(Isolux, OfARouteFollowItsCells) {
  const Document document = route_document();
  const PlanePart& plane = document.projects[0].spaces[0].planes[0];
  const calc::RouteCells cells = plane.grid.route->cells(plane.grid.rows);
  const std::vector<IsoluxLine> lines = isolux_lines(plane, 102.5);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].points_m.size(), 3U);
  for (const glm::dvec2& p : lines[0].points_m) {
    const glm::dvec2 world_m = p + glm::dvec2(plane.grid.origin_m);
    const int row = world_m.y < 0.8 ? 0 : world_m.y < 1.2 ? 1 : 2;
    EXPECT_NEAR(world_m.y - 1.0, cells.offset_m(row), 1e-12);
    EXPECT_NEAR(world_m.x, 0.5 * (cells.centre_m(2, row).x + cells.centre_m(3, row).x), 1e-12);
  }
}

}  // namespace
}  // namespace report::isolux_test
