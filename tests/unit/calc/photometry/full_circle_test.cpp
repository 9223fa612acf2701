#include "calc/photometry/full_circle.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace calc::full_circle_test {
namespace {

// (C, stored plane) of the result, for the cases without blending.
using Pairs = std::vector<std::pair<double, std::size_t>>;

Pairs pairs(const std::vector<CirclePlane>& planes) {
  Pairs list;
  for (const CirclePlane& plane : planes) {
    EXPECT_EQ(plane.weight, 0.0);
    list.emplace_back(plane.c_deg, plane.first);
  }
  return list;
}

TEST(FullCircle, AxialIsOnePlaneAtZeroWhateverItsAngle) {
  EXPECT_EQ(pairs(full_circle({205}, PlaneSymmetry::axial)), (Pairs{{0, 0}}));
}

TEST(FullCircle, QuadrantIsMirroredTwice) {
  EXPECT_EQ(
      pairs(full_circle({0, 30, 90}, PlaneSymmetry::quadrant)),
      (Pairs{
          {0, 0}, {30, 1}, {90, 2}, {150, 1}, {180, 0}, {210, 1}, {270, 2}, {330, 1}, {360, 0}}));
}

TEST(FullCircle, HalfIsMirroredAtC0C180) {
  EXPECT_EQ(pairs(full_circle({0, 45, 180}, PlaneSymmetry::c0_c180)),
            (Pairs{{0, 0}, {45, 1}, {180, 2}, {315, 1}, {360, 0}}));
}

TEST(FullCircle, HalfFrom90To270IsMirroredAtC90C270) {
  EXPECT_EQ(
      pairs(full_circle({90, 120, 180, 225, 270}, PlaneSymmetry::c90_c270)),
      (Pairs{
          {0, 2}, {60, 1}, {90, 0}, {120, 1}, {180, 2}, {225, 3}, {270, 4}, {315, 3}, {360, 2}}));
}

TEST(FullCircle, HalfFromMinus90To90IsMirroredAtC90C270) {
  EXPECT_EQ(pairs(full_circle({-90, -30, 0, 90}, PlaneSymmetry::c90_c270)),
            (Pairs{{0, 2}, {90, 3}, {180, 2}, {210, 1}, {270, 0}, {330, 1}, {360, 2}}));
}

TEST(FullCircle, AMissingPlaneAtZeroLiesBetweenItsNeighbours) {
  const std::vector<CirclePlane> planes = full_circle({90, 170, 200, 270}, PlaneSymmetry::c90_c270);
  ASSERT_EQ(planes.size(), 8U);  // 0 10 90 170 200 270 340 360
  EXPECT_EQ(planes.front().c_deg, 0.0);
  EXPECT_EQ(planes.front().first, 2U);   // C 340 = plane at 200
  EXPECT_EQ(planes.front().second, 1U);  // C 10 = plane at 170
  EXPECT_NEAR(planes.front().weight, 2.0 / 3.0, 1e-12);
  EXPECT_EQ(planes.back().c_deg, 360.0);
  EXPECT_EQ(planes.back().weight, planes.front().weight);
}

TEST(FullCircle, StoredPlanes0And360AreAveraged) {
  const std::vector<CirclePlane> planes = full_circle({0, 180, 360}, PlaneSymmetry::none);
  ASSERT_EQ(planes.size(), 3U);
  EXPECT_EQ(planes[0].first, 0U);
  EXPECT_EQ(planes[0].second, 2U);
  EXPECT_EQ(planes[0].weight, 0.5);
  EXPECT_EQ(planes[1].first, 1U);
  EXPECT_EQ(planes[2].second, 2U);
}

TEST(FullCircle, AllButTheLastStepIsClosed) {
  EXPECT_EQ(pairs(full_circle({0, 120, 240}, PlaneSymmetry::none)).size(),
            0U);  // 120 > 90: planes missing
  EXPECT_EQ(pairs(full_circle({0, 90, 180, 270}, PlaneSymmetry::none)).back(),
            (std::pair{360.0, std::size_t{0}}));
  EXPECT_TRUE(full_circle({0, 45, 90, 135}, PlaneSymmetry::none).empty());
  EXPECT_TRUE(full_circle({0, 45, 90, 135, 180, 225, 270}, PlaneSymmetry::none).empty());
}

TEST(FullCircle, RangesOfLm63TellTheSymmetry) {
  EXPECT_EQ(symmetry_of_range({205}), PlaneSymmetry::axial);
  EXPECT_EQ(symmetry_of_range({0, 90}), PlaneSymmetry::quadrant);
  EXPECT_EQ(symmetry_of_range({0, 45, 180}), PlaneSymmetry::c0_c180);
  EXPECT_EQ(symmetry_of_range({90, 180, 270}), PlaneSymmetry::c90_c270);
  EXPECT_EQ(symmetry_of_range({0, 180, 360}), PlaneSymmetry::none);
  EXPECT_EQ(symmetry_of_range({0, 180, 345}), PlaneSymmetry::none);
}

}  // namespace
}  // namespace calc::full_circle_test
