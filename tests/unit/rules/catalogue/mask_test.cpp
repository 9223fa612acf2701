#include "rules/catalogue/mask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace rules::mask_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// columns x rows points of a plane of this size in metres, without `margin_m` along its outline.
calc::SensorGrid grid_of(double u_m, double v_m, int columns, int rows, double margin_m = 0.0) {
  calc::SensorGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.margin_m = margin_m;
  grid.spacing_u_m = (u_m - 2 * margin_m) / columns;
  grid.spacing_v_m = (v_m - 2 * margin_m) / rows;
  grid.origin_m = {10.0, 20.0, 0.0};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      grid.position_m.push_back(grid.origin_m + glm::dvec3((column + 0.5) * grid.spacing_u_m,
                                                           (row + 0.5) * grid.spacing_v_m, 0.0));
      grid.column.push_back(column);
      grid.row.push_back(row);
    }
  }
  return grid;
}

std::set<int> rows_of(const MaskedPoints& masked, const calc::SensorGrid& grid) {
  std::set<int> rows;
  for (const std::size_t point : masked.points) rows.insert(grid.row[point]);
  return rows;
}

Mask mask_of(MaskStep step, double metres = 0, double share = 0, double up_to = 0) {
  return {"m", {{step, metres, share, up_to}}};
}

TEST(Mask, WithoutOperationsCountsEverything) {
  EXPECT_EQ(apply_mask({}, grid_of(4, 2, 4, 2)).points.size(), 8u);
}

TEST(Mask, InsetLeavesOutAStripAlongAllSides) {
  const calc::SensorGrid grid = grid_of(4, 3, 4, 3);  // points 0.5 m from the outline
  EXPECT_EQ(apply_mask(mask_of(MaskStep::inset, 0.5), grid).points.size(), 12u);  // on the edge
  EXPECT_THAT(apply_mask(mask_of(MaskStep::inset, 0.6), grid).points, ElementsAre(5, 6));
}

TEST(Mask, AcrossLeavesOutTheLongSidesOnly) {
  const calc::SensorGrid wide = grid_of(10, 3, 10, 6);  // rows at 0.25, 0.75, ... m
  EXPECT_THAT(rows_of(apply_mask(mask_of(MaskStep::across, 0.5), wide), wide),
              ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(apply_mask(mask_of(MaskStep::across, 0.5), wide).points.size(), 40u);
  const calc::SensorGrid turned = grid_of(3, 10, 6, 10);
  EXPECT_EQ(apply_mask(mask_of(MaskStep::across, 0.5), turned).points.size(), 40u);
}

// EN 1838:2024: a quarter of the width up to 2 m, 0.5 m beyond.
TEST(Mask, ShareHoldsUpToItsWidth) {
  const Mask mask = mask_of(MaskStep::across, 0.5, 0.25, 2.0);
  const calc::SensorGrid narrow = grid_of(10, 1.2, 10, 12);  // rows at 0.05, 0.15, ... m
  EXPECT_THAT(rows_of(apply_mask(mask, narrow), narrow), ElementsAre(3, 4, 5, 6, 7, 8));
  const calc::SensorGrid two_metres = grid_of(10, 2.0, 10, 8);
  EXPECT_THAT(rows_of(apply_mask(mask, two_metres), two_metres), ElementsAre(2, 3, 4, 5));
  const calc::SensorGrid wider = grid_of(10, 4.0, 10, 8);  // rows at 0.25, 0.75, ...
  EXPECT_THAT(rows_of(apply_mask(mask, wider), wider), ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(Mask, CentreLineIsTheMiddleRowOrTheTwoBesideTheMiddle) {
  const Mask mask = mask_of(MaskStep::centre_line);
  const calc::SensorGrid odd = grid_of(10, 3, 10, 5);
  EXPECT_THAT(rows_of(apply_mask(mask, odd), odd), ElementsAre(2));
  const calc::SensorGrid even = grid_of(10, 3, 10, 6);
  EXPECT_THAT(rows_of(apply_mask(mask, even), even), ElementsAre(2, 3));
}

TEST(Mask, CentreLineMayBeForNarrowPlanesOnly) {
  const Mask mask = mask_of(MaskStep::centre_line, 0, 0, 2.0);
  const calc::SensorGrid narrow = grid_of(10, 2, 10, 5);
  EXPECT_THAT(rows_of(apply_mask(mask, narrow), narrow), ElementsAre(2));
  const MaskedPoints wide = apply_mask(mask, grid_of(12, 8, 12, 9));
  EXPECT_TRUE(wide.points.empty());
  EXPECT_EQ(wide.problem,
            "mask 'm' needs a plane at most 2 m wide; this plane is 8 m wide, so divide it into "
            "strips");
}

TEST(Mask, MeasuresFromTheOutlineNotFromTheGrid) {
  const calc::SensorGrid grid = grid_of(10, 4, 10, 3, 0.5);  // rows at 1, 2 and 3 m
  EXPECT_THAT(rows_of(apply_mask(mask_of(MaskStep::across, 0.9), grid), grid),
              ElementsAre(0, 1, 2));
  EXPECT_THAT(rows_of(apply_mask(mask_of(MaskStep::across, 1.1), grid), grid), ElementsAre(1));
}

TEST(Mask, NeedsEveryOperation) {
  Mask mask = mask_of(MaskStep::inset, 0.6);
  mask.operations.push_back({MaskStep::centre_line, 0, 0, 0});
  calc::SensorGrid grid = grid_of(4, 4, 4, 4);
  grid.travel = {1.0, 0.0, 0.0};
  EXPECT_THAT(apply_mask(mask, grid).points, ElementsAre(5, 6, 9, 10));
}

// A piece 2 m long and 3 m wide is not crossed the long way.
TEST(Mask, FollowsTheWayThatPeopleGo) {
  const Mask mask = mask_of(MaskStep::across, 0.5, 0.25, 2.0);
  calc::SensorGrid grid = grid_of(2, 3, 4, 6);
  EXPECT_EQ(apply_mask(mask, grid).problem,
            "mask 'm' needs the walking direction, which a plane of 3 m x 2 m does not show; add "
            "travel=\"x y 0\"");
  grid.travel = {1.0, 0.0, 0.0};  // 3 m wide: 0.5 m of each side are left out, all along
  EXPECT_THAT(rows_of(apply_mask(mask, grid), grid), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(apply_mask(mask, grid).points.size(), 16u);
  grid.travel = {0.0, -1.0, 0.0};  // 2 m wide: a quarter of each side
  EXPECT_THAT(rows_of(apply_mask(mask, grid), grid), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(apply_mask(mask, grid).points.size(), 12u);
}

TEST(Mask, TakesTheLongerSideWhereThatIsClear) {
  const Mask mask = mask_of(MaskStep::across, 0.5, 0.25, 2.0);
  const calc::SensorGrid twice = grid_of(4, 2, 8, 4), less = grid_of(3.99, 2, 8, 4);
  EXPECT_THAT(rows_of(apply_mask(mask, twice), twice), ElementsAre(1, 2));
  EXPECT_NE(apply_mask(mask, less).problem, "");
}

// The grid of a route, as make_sensor_grid() makes it, with spacings of the cells at most.
calc::SensorGrid route_grid(std::vector<glm::dvec3> corner_m, double width_m, double along_m,
                            double across_m) {
  calc::EscapeRoute route;
  route.line = {std::move(corner_m), width_m};
  route.spacing = {along_m, across_m, {}};
  route.is_spacing_given = true;
  calc::CalcPlane plane;
  plane.area = route;
  calc::Diagnostics diagnostics;
  return calc::make_sensor_grid(plane, calc::Space{}, diagnostics).value();
}

// The same piece as above: its line says the way, 3 m wide and 2 m long, or the other way round.
TEST(Mask, OfARouteGoesByItsLine) {
  const Mask mask = mask_of(MaskStep::across, 0.5, 0.25, 2.0);
  const calc::SensorGrid wide = route_grid({{0, 0, 0}, {2, 0, 0}}, 3.0, 0.5, 0.45);  // 7 rows
  EXPECT_THAT(rows_of(apply_mask(mask, wide), wide), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_EQ(apply_mask(mask, wide).points.size(), 5u * 4u);
  const calc::SensorGrid narrow = route_grid({{0, 0, 0}, {0, 3, 0}}, 2.0, 0.5, 0.3);  // 7 rows
  EXPECT_THAT(rows_of(apply_mask(mask, narrow), narrow), ElementsAre(2, 3, 4));
  EXPECT_EQ(apply_mask(mask, narrow).points.size(), 3u * 6u);
}

TEST(Mask, OfARouteGoesRoundCorners) {
  const calc::SensorGrid grid = route_grid({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 1.5, 0.5, 0.3);
  ASSERT_EQ(grid.rows, 5);
  const MaskedPoints line = apply_mask(mask_of(MaskStep::centre_line, 0, 0, 2.0), grid);
  EXPECT_THAT(rows_of(line, grid), ElementsAre(2));
  EXPECT_EQ(line.points.size(), static_cast<std::size_t>(grid.columns));
  for (const std::size_t i : line.points) {
    const glm::dvec3& p = grid.position_m[i];
    EXPECT_NEAR(std::min(std::abs(p.y), std::abs(p.x - 4.0)), 0.0, 1e-12);
  }
  const MaskedPoints half = apply_mask(mask_of(MaskStep::across, 0.0, 0.25, 2.0), grid);
  EXPECT_THAT(rows_of(half, grid), ElementsAre(1, 2, 3));
}

TEST(Mask, OfARouteTakesBothEndsWithAnInset) {
  const calc::SensorGrid grid = route_grid({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 2.5, 0.5, 0.5);
  const MaskedPoints inner = apply_mask(mask_of(MaskStep::inset, 0.6), grid);
  EXPECT_THAT(rows_of(inner, grid), ElementsAre(1, 2, 3));
  for (const std::size_t i : inner.points) {
    EXPECT_TRUE(grid.position_m[i].x >= 0.6 && grid.position_m[i].y <= 2.4);
  }
  // Of the middle row, 11 + 9 points 0.36 m and 0.33 m apart, each end loses two.
  EXPECT_EQ(std::count_if(inner.points.begin(), inner.points.end(),
                          [&](std::size_t i) { return grid.row[i] == 2; }),
            grid.columns - 4);
}

TEST(Mask, OfAWideRouteHasNoCentreLine) {
  const calc::SensorGrid grid = route_grid({{0, 0, 0}, {4, 0, 0}}, 2.5, 0.5, 0.5);
  EXPECT_EQ(apply_mask(mask_of(MaskStep::centre_line, 0, 0, 2.0), grid).problem,
            "mask 'm' needs a route at most 2 m wide; this route is 2.5 m wide, so divide it "
            "into strips");
}

TEST(Mask, OfARouteWithLostPointsStaysWhatItIs) {
  calc::SensorGrid grid = route_grid({{0, 0, 0}, {4, 0, 0}}, 1.5, 0.5, 0.3);
  grid.dropped.push_back({{}, 0, 0, calc::DropReason::outside_area, ""});
  EXPECT_EQ(apply_mask(mask_of(MaskStep::centre_line), grid).points.size(), 8u);
}

TEST(Mask, SaysWhenNothingIsLeft) {
  const MaskedPoints masked = apply_mask(mask_of(MaskStep::inset, 3), grid_of(4, 4, 4, 4));
  EXPECT_THAT(masked.points, IsEmpty());
  EXPECT_EQ(masked.problem, "mask 'm' leaves none of 16 points");
}

// The plane is a strip along the wall x = 10 of a room of 10 x 5 m.
TEST(Mask, WallsAreThoseOfTheRoomNotThePlanesOwnEdges) {
  calc::SensorGrid grid = grid_of(3, 5, 3, 5);  // from (10, 20); points 0.5 m from its outline
  const Mask mask = mask_of(MaskStep::walls, 0.6);
  EXPECT_EQ(apply_mask(mask, grid).points.size(), 15u) << "in the open space";
  grid.room_m = {{3, 20}, {13, 20}, {13, 25}, {3, 25}};
  EXPECT_THAT(apply_mask(mask, grid).points, ElementsAre(3, 4, 6, 7, 9, 10));
  EXPECT_EQ(apply_mask(mask_of(MaskStep::walls, 0.5), grid).points.size(), 15u) << "on the edge";
  // A band with a hole is judged, too.
  grid.dropped.push_back({{}, 0, 0, calc::DropReason::outside_area, ""});
  EXPECT_EQ(apply_mask(mask, grid).points.size(), 6u);
  grid.room_m.clear();
  grid.has_unknown_walls = true;
  EXPECT_EQ(apply_mask(mask, grid).problem,
            "mask 'm' needs the walls, but the building file has no outline of this room");
}

// A border is of the room, and of the plane's own outline only where nobody knows a wall.
TEST(Mask, ABorderIsOfWallsWhereTheyAreKnown) {
  calc::SensorGrid grid = grid_of(3, 5, 3, 5);  // from (10, 20); points 0.5 m from its outline
  const Mask mask = mask_of(MaskStep::border, 0.6);
  EXPECT_THAT(apply_mask(mask, grid).points, ElementsAre(4, 7, 10)) << "in the open space";
  grid.has_unknown_walls = true;
  EXPECT_THAT(apply_mask(mask, grid).points, ElementsAre(4, 7, 10)) << "in a mesh";
  grid.has_unknown_walls = false;
  grid.room_m = {{3, 20}, {13, 20}, {13, 25}, {3, 25}};
  EXPECT_THAT(apply_mask(mask, grid).points, ElementsAre(3, 4, 6, 7, 9, 10));
}

TEST(Mask, InsetWorksForEveryOutline) {
  calc::SensorGrid grid = grid_of(4, 4, 4, 4);
  // An L: without the corner beyond (2, 2).
  grid.outline_m = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  grid.dropped.push_back({{}, 2, 2, calc::DropReason::outside_area, ""});
  for (const std::size_t point : {15, 14, 11, 10}) {
    grid.position_m.erase(grid.position_m.begin() + static_cast<std::ptrdiff_t>(point));
  }
  // Of the twelve points only (1.5, 1.5) is farther than 0.6 m from every side.
  EXPECT_THAT(apply_mask(mask_of(MaskStep::inset, 0.6), grid).points, ElementsAre(5));
  EXPECT_EQ(apply_mask(mask_of(MaskStep::inset, 0.6, 0.1, 2.0), grid).problem,
            "mask 'm' needs a rectangular plane, or a <route>");
}

TEST(Mask, IsForRectanglesOnly) {
  calc::SensorGrid list = grid_of(4, 4, 4, 4);
  list.columns = list.rows = 0;
  EXPECT_EQ(apply_mask(mask_of(MaskStep::inset, 1), list).problem,
            "mask 'm' needs a rectangular plane, or a <route>");
  calc::SensorGrid polygon = grid_of(4, 4, 4, 4);
  polygon.dropped.push_back({{}, 0, 0, calc::DropReason::outside_area, ""});
  EXPECT_EQ(apply_mask(mask_of(MaskStep::inset, 1), polygon).problem,
            "mask 'm' needs a rectangular plane, or a <route>");
  EXPECT_EQ(apply_mask({}, list).points.size(), 16u);
}

TEST(Mask, WordsTellAllThatItDoes) {
  EXPECT_EQ(mask_words({"all", {}}), "");
  EXPECT_EQ(mask_words(mask_of(MaskStep::inset, 0.5)),
            "without a strip of 0.5 m along the outline");
  Mask mask = mask_of(MaskStep::across, 0.5, 0.25, 2);
  mask.operations.push_back({MaskStep::walls, 0.3, 0, 0});
  const std::string words =
      "without a strip along the long sides: 0.25 of the width (planes up to 2 m wide), "
      "otherwise 0.5 m, without points nearer than 0.3 m to a wall of the room";
  EXPECT_EQ(mask_words(mask), words);
  EXPECT_EQ(mask_words(mask, {0, 1, 0}), words + ", walking direction (0 1 0)");
  EXPECT_EQ(mask_words(mask_of(MaskStep::inset, 0.5), {0, 1, 0}),
            mask_words(mask_of(MaskStep::inset, 0.5)));
}

}  // namespace
}  // namespace rules::mask_test
