#pragma once
// A street with figures that are easy to add up: two lanes, one of them oncoming, luminaires on
// both sides, a footway on the right.

#include "report/document/document.h"
#include "tests/support/sample_document.h"

#include <string>
#include <utility>
#include <vector>

namespace report {

inline PlanePart sample_road_plane(const std::string& id, const calc::Estimate& average_lx) {
  PlanePart plane;
  plane.id = id;
  plane.is_computed = true;
  plane.average = average_lx;
  return plane;
}

// Carriageway 7 m x 30 m at 20 lx, footway 2 m x 30 m at 10 lx, two luminaires of 75 W: the power
// density is 150 W / (20 lx 210 m2 + 10 lx 60 m2) = 150 / 4800 W / (lx m2).
inline SpacePart sample_road() {
  SpacePart space;
  space.id = "street";
  space.name = "School <street>";
  space.planes = {sample_road_plane("street", estimate(20.0, 1.0)),
                  sample_road_plane("path", estimate(10.0, 0.5))};
  space.planes[0].findings.push_back(sample_finding(rules::Metric::road_luminance, 0.75,
                                                    estimate(0.8, 0.0), "EN 13201-2:2015 M4"));
  space.planes[0].findings[0].requirement.origin.pack = "en13201-2:2015";
  RoadPart& road = space.road.emplace();
  road.spacing_m = 30.0;
  road.width_m = 7.0;
  road.surface = "R3";
  road.q0 = 0.07;
  road.rows = {{"east", "head", "", 8.0, 0.5, 0.0, 5.0, 75.0, 0.8},
               {"west", "head", "", 8.0, 7.25, 0.0, -5.0, 75.0, 0.8}};
  road.areas = {{"street", "School <street>", 0.0, 7.0}, {"path", "Path", -2.5, -0.5}};
  for (int i = 0; i < 10; ++i) road.light.grid.x_m.push_back(1.5 + 3.0 * i);
  for (int i = 0; i < 6; ++i) road.light.grid.y_m.push_back((i + 0.5) * 7.0 / 6.0);
  for (const int lane : {0, 1}) {
    calc::RoadObserver observer;
    observer.lane = lane;
    observer.is_oncoming = lane == 1;
    observer.eye_m = {lane == 0 ? -60.0 : 90.0, 1.75 + 3.5 * lane, 1.5};
    observer.average_cd_m2 = estimate(0.8 + 0.1 * lane, 0.0);
    observer.uo = estimate(0.5 - 0.05 * lane, 0.0);
    observer.ul = estimate(0.7, 0.0);
    observer.ti_percent = estimate(10.0 + lane, 0.0);
    for (int i = 0; i < 60; ++i) observer.cd_m2.push_back(0.5 + 0.01 * i + lane);
    road.light.observers.push_back(std::move(observer));
  }
  road.light.right_ratio = estimate(0.6, 0.0);
  road.light.left_ratio = estimate(0.4, 0.0);
  return space;
}

}  // namespace report
