#include "calc/forecast/drawing_cost.h"

#include "calc/forecast/device_cost.h"

#include <gtest/gtest.h>

namespace drawing_cost_test {
namespace {

// Pictures of so many small rooms.
calc::DrawingWork rooms(double count) {
  calc::DrawingWork work;
  work.rooms = count;
  work.pixels = 4e6 * count;
  work.triangles = 1.2e4 * count;
  return work;
}

calc::DeviceRates opened_in(double open_s) {
  calc::DeviceRates rates = calc::kAssumedRates;
  rates.open_s = open_s;
  return rates;
}

bool takes_hardware(const calc::DrawingWork& work, double open_s, int threads = 2) {
  return calc::is_hardware_to_draw(work, calc::weigh_drawing(work, opened_in(open_s), threads));
}

TEST(DrawingCost, HardwareIsOpenedForManyRoomsOnly) {
  EXPECT_FALSE(takes_hardware(rooms(1), 0.4));
  EXPECT_TRUE(takes_hardware(rooms(24), 0.4));
  bool was_taken = false;
  for (double count = 0.0; count < 1000.0; ++count) {
    const bool is_taken = takes_hardware(rooms(count), 0.4);
    EXPECT_TRUE(is_taken || !was_taken) << count;
    was_taken = is_taken;
  }
}

TEST(DrawingCost, WhatOpensLaterGetsFewerRooms) {
  const auto first_room = [](double open_s) {
    double count = 0.0;
    while (!takes_hardware(rooms(count), open_s)) ++count;
    return count;
  };
  EXPECT_LT(first_room(0.2), first_room(0.4));
  EXPECT_LT(first_room(0.4), first_room(0.8));
  const calc::DrawingCost cost = calc::weigh_drawing(rooms(3), opened_in(0.4), 2);
  EXPECT_EQ(cost.open_s, 0.4);
  EXPECT_GT(cost.hardware_s, 0.4);
}

TEST(DrawingCost, TheSoonerOneDraws) {
  const calc::DrawingWork work = rooms(2);
  EXPECT_TRUE(calc::is_hardware_to_draw(work, {0.5, 0.4, 0.499}));
  EXPECT_FALSE(calc::is_hardware_to_draw(work, {0.5, 0.4, 0.5}));
  EXPECT_FALSE(calc::is_hardware_to_draw(work, {0.5, 0.4, 0.501}));
}

// They would be missing.
TEST(DrawingCost, RoomsThatSoftwareDoesNotDrawAreForHardware) {
  EXPECT_FALSE(takes_hardware(rooms(calc::kMostRoomsOnSoftware), 1000.0));
  EXPECT_TRUE(takes_hardware(rooms(calc::kMostRoomsOnSoftware + 1), 1000.0));
}

TEST(DrawingCost, NoHardwareIsSoonerThanTheIdealOne) {
  for (const double count : {0.0, 1.0, 5.0, 24.0, 100.0}) {
    for (const int threads : {1, 16, 192}) {
      const calc::DrawingWork work = rooms(count);
      const calc::DrawingCost ideal = calc::weigh_ideal_drawing(work, threads);
      const calc::DrawingCost cost =
          calc::weigh_drawing(work, opened_in(calc::kLeastOpen_s), threads);
      EXPECT_EQ(ideal.software_s, cost.software_s);
      EXPECT_LE(ideal.hardware_s, cost.hardware_s);
      EXPECT_LE(cost.software_s, calc::weigh_drawing(work, opened_in(0.4), 1).software_s);
    }
  }
}

struct Room {
  calc::SpaceWorkload space;
  calc::Prediction prediction;

  Room() {
    space.triangles = 200;
    space.vertices_per_path = 2.0;
    prediction.work.light_paths = 1000.0;
    calc::PlaneWorkload& plane = space.planes.emplace_back();
    plane.points = plane.seeing_points = 50;
  }
  calc::DrawingWork maps(double texels) const {
    calc::DrawingWork work;
    work.add_shadow_maps(prediction, space, texels);
    return work;
  }
};

TEST(DrawingCost, AShadowMapHasFiveFaces) {
  const calc::DrawingWork work = Room().maps(64.0);
  EXPECT_EQ(work.map_texels, 2000.0 * 5.0 * 64.0 * 64.0);
  EXPECT_EQ(work.map_triangles, 2000.0 * 5.0 * 200.0);
  EXPECT_EQ(work.lookups, 2000.0 * 50.0);
  EXPECT_EQ(work.rooms, 0.0);
}

// Points that are proved to see every vertex are summed without maps.
TEST(DrawingCost, NothingIsDrawnForPointsWithoutShadows) {
  Room room;
  room.space.planes[0].is_unobstructed = true;
  EXPECT_EQ(room.maps(64.0).map_texels, 0.0);
  EXPECT_EQ(room.maps(64.0).lookups, 2000.0 * 50.0);
  calc::PlaneWorkload& obstructed = room.space.planes.emplace_back();
  EXPECT_EQ(room.maps(64.0).map_texels, 0.0);  // without a point
  obstructed.seeing_points = 1;
  EXPECT_GT(room.maps(64.0).map_texels, 0.0);
}

TEST(DrawingCost, LargerMapsAndMoreVerticesMoveToHardware) {
  Room room;
  room.prediction.work.light_paths = 30.0;
  EXPECT_FALSE(takes_hardware(room.maps(16.0), 0.4));
  EXPECT_TRUE(takes_hardware(room.maps(1024.0), 0.4));
  room.prediction.work.light_paths = 1e5;
  EXPECT_TRUE(takes_hardware(room.maps(16.0), 0.4));
}

TEST(DrawingCost, WorkCountsShadowMapsWhereTheyAreWanted) {
  const Room room;
  calc::RadiositySettings settings;
  calc::DeviceWork work;
  work.add(room.prediction, room.space, settings, 1);
  EXPECT_EQ(work.drawing.lookups, 0.0);
  settings.shadow_map_texels = 64;
  work.add(room.prediction, room.space, settings, 1);
  work.add(room.prediction, room.space, settings, 1);
  EXPECT_EQ(work.drawing.map_texels, 2.0 * room.maps(64.0).map_texels);
}

}  // namespace
}  // namespace drawing_cost_test
