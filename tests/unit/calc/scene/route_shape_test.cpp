#include "calc/scene/route_shape.h"

#include "calc/scene/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace calc::route_shape_test {
namespace {

using testing::HasSubstr;

constexpr double kNoise = 1e-12;

RouteLine line_of(std::vector<glm::dvec3> corner_m, double width_m) {
  return {std::move(corner_m), width_m};
}

RouteCells cells_of(const RouteLine& line, double spacing_m, int rows) {
  const std::vector<double> stations = route_stations(line, spacing_m);
  return {line, {stations.begin(), stations.end()}, rows};
}

double sum_of_areas(const RouteCells& cells) {
  double sum = 0.0;
  for (int row = 0; row < cells.rows(); ++row) {
    for (int column = 0; column < cells.columns(); ++column) sum += cells.area_m2(column, row);
  }
  return sum;
}

const RouteLine kL = line_of({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 1.2);

// What a mitre takes from one side of the line it gives to the other.
TEST(RouteShape, CellsAddUpToWidthTimesLength) {
  const std::vector<RouteLine> lines{
      line_of({{1, 2, 0}, {4, 6, 0}}, 1.5), kL,
      line_of({{0, 0, 0}, {4, 0, 0}, {4, 1.2, 0}, {0, 1.2, 0}}, 1.2),         // U: edges touch
      line_of({{0, 0, 0}, {4, 0, 0}, {6, 2, 0}, {9, 2, 0}, {9, -3, 1}}, 1.4)  // Z, then down
  };
  for (const RouteLine& line : lines) {
    EXPECT_EQ(route_fault(line), "");
    const double whole_m2 = route_length_m(line) * line.width_m;
    for (const int rows : {1, 5}) {
      EXPECT_NEAR(sum_of_areas(cells_of(line, 0.3, rows)), whole_m2, 1e-9 * whole_m2);
    }
    EXPECT_NEAR(signed_area(route_outline_m(line)), whole_m2, 1e-9 * whole_m2);
  }
}

TEST(RouteShape, RowsKeepTheirDistanceFromTheLine) {
  const RouteCells cells = cells_of(kL, 0.3, 3);
  EXPECT_DOUBLE_EQ(cells.offset_m(0), -0.4);
  EXPECT_DOUBLE_EQ(cells.offset_m(1), 0.0);
  EXPECT_DOUBLE_EQ(cells.offset_m(2), 0.4);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < cells.columns(); ++column) {
      const glm::dvec3 at = cells.centre_m(column, row);
      const bool is_first = cells.station_m(column) < 4.0;
      EXPECT_NEAR(is_first ? at.y : 4.0 - at.x, cells.offset_m(row), kNoise);
    }
  }
}

// A right angle: the row at the offset o ends at 4 - o, where the next one begins at y = o.
TEST(RouteShape, StationsRunFromMitreToMitre) {
  const RouteCells cells{kL, {4, 3}, 3};
  EXPECT_EQ(cells.columns(), 7);
  EXPECT_NEAR(cells.centre_m(0, 2).x, (4.0 - 0.4) / 8.0, kNoise);  // inside
  EXPECT_NEAR(cells.centre_m(0, 0).x, (4.0 + 0.4) / 8.0, kNoise);  // outside
  EXPECT_NEAR(cells.centre_m(4, 2).y, 0.4 + (3.0 - 0.4) / 6.0, kNoise);
  EXPECT_NEAR(cells.centre_m(4, 0).y, -0.4 + (3.0 + 0.4) / 6.0, kNoise);
  EXPECT_NEAR(cells.station_m(0), 0.5, kNoise);
  EXPECT_NEAR(cells.station_m(4), 4.5, kNoise);
  // The outer corner of the bend belongs to a cell.
  EXPECT_TRUE(contains_point(cells.corners_m(3, 0), {4.55, -0.58}));
  EXPECT_TRUE(contains_point(cells.corners_m(4, 0), {4.58, -0.55}));
}

TEST(RouteShape, BendsToEitherSideMirrorEachOther) {
  const RouteCells left{kL, {4, 3}, 5};
  const RouteCells right{line_of({{0, 0, 0}, {4, 0, 0}, {4, -3, 0}}, 1.2), {4, 3}, 5};
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      const glm::dvec3 a = left.centre_m(column, row), b = right.centre_m(column, 4 - row);
      EXPECT_NEAR(a.x, b.x, kNoise);
      EXPECT_NEAR(a.y, -b.y, kNoise);
      EXPECT_NEAR(left.area_m2(column, row), right.area_m2(column, 4 - row), kNoise);
    }
  }
}

TEST(RouteShape, NoPointIsInTwoCells) {
  const RouteCells cells =
      cells_of(line_of({{0, 0, 0}, {4, 0, 0}, {6, 2, 0}, {9, 2, 0}}, 1.4), 0.5, 3);
  for (int a = 0; a < cells.columns() * 3; ++a) {
    const glm::dvec2 centre(cells.centre_m(a / 3, a % 3));
    int holders = 0;
    for (int b = 0; b < cells.columns() * 3; ++b) {
      if (contains_point(cells.corners_m(b / 3, b % 3), centre)) ++holders;
    }
    EXPECT_EQ(holders, 1);
  }
}

TEST(RouteShape, StationsAreNowhereFartherApart) {
  // 4 m and 0.6 m more at the outer edge: 10 cells of 0.5 m; 3.6 m: 8.
  EXPECT_THAT(route_stations(kL, 0.5), testing::ElementsAre(10, 8));
  EXPECT_THAT(route_stations(line_of({{0, 0, 0}, {3, 0, 0}}, 2), 0.5), testing::ElementsAre(6));
  EXPECT_THAT(route_stations(line_of({{0, 0, 0}, {3.0000000001, 0, 0}}, 2), 0.5),
              testing::ElementsAre(6));
}

TEST(RouteShape, HeightGoesAlongTheLegAndStaysBeyondItsEnds) {
  const RouteCells cells{line_of({{0, 0, 1}, {4, 0, 1}, {4, 2, 2}}, 2.0), {4, 8}, 3};
  EXPECT_NEAR(cells.centre_m(4, 1).z, 1.0625, kNoise);
  // Right row of the second leg: it begins at y = -2/3.
  EXPECT_NEAR(cells.centre_m(4, 0).y, -0.5, kNoise);
  EXPECT_NEAR(cells.centre_m(4, 0).z, 1.0, kNoise);
}

TEST(RouteShape, EndsAreMeasuredAlongTheFirstAndTheLastLeg) {
  const RouteCells cells{kL, {4, 3}, 3};
  EXPECT_NEAR(cells.from_begin_m(0, 1), 0.5, kNoise);
  EXPECT_TRUE(std::isinf(cells.from_begin_m(4, 1)));
  EXPECT_NEAR(cells.from_end_m(6, 1), 0.5, kNoise);
  EXPECT_TRUE(std::isinf(cells.from_end_m(3, 1)));
}

TEST(RouteShape, RefusesWhatIsNoLine) {
  const auto fault = [](std::vector<glm::dvec3> corners, double width_m = 1.2) {
    return route_fault(line_of(std::move(corners), width_m));
  };
  EXPECT_EQ(fault({{0, 0, 0}}), "the line has fewer than 2 corners");
  EXPECT_EQ(fault({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}}),
            "corners 2 and 3 are the same point; give each corner once");
  EXPECT_THAT(fault({{0, 0, 0}, {2, 0, 0}, {2, 0, 3}}),
              HasSubstr("corner 3 is straight above or below corner 2"));
  EXPECT_EQ(fault({{0, 0, 0}, {4, 0, 0}, {0, 0.1, 0}}),
            "the line turns by 178.6 degrees at corner 2; at most 120 degrees are allowed. Replace "
            "it by two corners");
  EXPECT_THAT(fault({{0, 0, 0}, {4, 0, 0}, {0, 0, 0}}), HasSubstr("turns by 180 degrees"));
  EXPECT_EQ(fault({{0, 0, 0}, {4, 0, 0}, {4, 1.1, 0}, {0, 1.1, 0}}),
            "the leg from corner 2 to corner 3 is 1.1 m long, too short for its turns: with a "
            "width of 1.2 m at least 1.2 m are needed");
  EXPECT_THAT(fault({{0, 0, 0}, {0.5, 0, 0}, {0.5, 3, 0}}), HasSubstr("corner 1 to corner 2"));
  // One turn to the left and one to the right: no edge is shorter than the line.
  EXPECT_EQ(fault({{0, 0, 0}, {4, 0, 0}, {4, 0.7, 0}, {8, 0.7, 0}}), "");
}

TEST(RouteShape, TurnsOfUpTo120DegreesAreFine) {
  const double c = std::cos(119.9 * std::numbers::pi / 180), s = std::sqrt(1 - c * c);
  EXPECT_EQ(route_fault(line_of({{0, 0, 0}, {4, 0, 0}, {4 + 4 * c, 4 * s, 0}}, 1.2)), "");
}

TEST(RouteShape, RefusesToCoverAPlaceTwice) {
  const std::vector<glm::dvec3> crossing{{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {3, 4, 0}, {3, -4, 0}};
  EXPECT_THAT(route_fault(line_of(crossing, 1.0)),
              HasSubstr("the legs from corner 1 to 2 and from corner 4 to 5 overlap at"));
  const std::vector<glm::dvec3> loop{{0, 0, 0}, {6, 0, 0}, {4.6, 2.94, 0}, {1.8, -1, 0}};
  EXPECT_THAT(route_fault(line_of(loop, 1.0)), HasSubstr("corner 1 to 2 and from corner 3 to 4"));
  // The lines are 1.5 m apart, the edges overlap by 0.1 m.
  const std::vector<glm::dvec3> beside{{0, 0, 0}, {6, 0, 0},   {6, 4, 0},
                                       {3, 4, 0}, {3, 1.5, 0}, {0, 1.5, 0}};
  EXPECT_THAT(route_fault(line_of(beside, 1.6)), HasSubstr("corner 1 to 2"));
  EXPECT_EQ(route_fault(line_of(beside, 1.5)), "");  // they touch
}

// Flights of a stair: the third lies above the first.
TEST(RouteShape, StairsMayLeadOverThemselves) {
  const auto stair = [](double storey_m) {
    const double h = storey_m / 2;
    return line_of({{0, 0, 0},
                    {3, 0, h},
                    {3, 1.2, h},
                    {0, 1.2, 2 * h},
                    {-1.2, 1.2, 2 * h},
                    {-1.2, 0, 2 * h},
                    {0, 0, 2 * h},
                    {3, 0, 3 * h}},
                   1.2);
  };
  EXPECT_EQ(route_fault(stair(2.8)), "");
  EXPECT_THAT(route_fault(stair(1.4)), HasSubstr("unless one part is 1.5 m above the other"));
}

}  // namespace
}  // namespace calc::route_shape_test
