#include "tests/bench/scenes.h"

#include "calc/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

void add_lamp_grid(RoomModel& room, int columns, int rows, double height_m) {
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      room.lamps.push_back(
          {{(i + 0.5) * room.size_m.x / columns, (j + 0.5) * room.size_m.y / rows, height_m},
           0,
           false,
           ""});
    }
  }
}

RoomModel empty_room(int columns, int rows) {
  RoomModel room;
  room.name = "room";
  room.size_m = {8.0, 6.0, 2.8};
  room.webs = {wide_web(4000.0)};
  add_lamp_grid(room, 2, 2, 2.78);
  room.grid = {{0.0, 0.0, 0.8}, 8.0, 6.0, columns, rows};
  return room;
}

RoomModel corridor() {
  RoomModel room;
  room.name = "corridor";
  room.size_m = {20.0, 2.0, 2.8};
  room.floor = room.walls = room.ceiling = 0.9;
  room.webs = {wide_web(3000.0)};
  add_lamp_grid(room, 6, 1, 2.78);
  room.grid = {{0.0, 0.0, 0.02}, 20.0, 2.0, 30, 4};
  return room;
}

RoomModel narrow_room(const std::string& name) {
  RoomModel room;
  room.name = name;
  room.size_m = {8.0, 6.0, 3.0};
  room.grid = {{0.0, 0.0, 0.8}, 8.0, 6.0, 10, 7};
  if (name == "spots") {
    room.webs = {spot_web(900.0, 8.0)};
    add_lamp_grid(room, 4, 3, 2.98);
  } else if (name == "uplights") {
    room.webs = {spot_web(3000.0, 8.0)};
    add_lamp_grid(room, 2, 2, 1.8);
    for (Lamp& lamp : room.lamps) lamp.shines_up = true;
  } else {
    room.webs = {wide_web(2000.0)};
    for (int i = 0; i < 6; ++i) {
      room.lamps.push_back({{(i + 0.5) * 8.0 / 6.0, 0.03, 2.9}, 0, false, ""});
    }
  }
  return room;
}

// One desk with what belongs to it: 8 boxes. The seat is on the low-y side. Nothing but the
// screen's foot cuts the plane at 0.75 m.
void add_workplace(RoomModel& room, int number, double x, double y) {
  const auto add = [&](const char* part, glm::dvec3 low, glm::dvec3 size, double rho) {
    room.blocks.push_back(
        {fmt::format("w{}-{}", number, part), glm::dvec3(x, y, 0.0) + low, size, rho});
  };
  add("top", {0.0, 0.0, 0.71}, {1.6, 0.8, 0.03}, 0.45);
  add("left", {0.02, 0.05, 0.01}, {0.03, 0.7, 0.69}, 0.45);
  add("right", {1.55, 0.05, 0.01}, {0.03, 0.7, 0.69}, 0.45);
  add("drawers", {1.1, 0.15, 0.01}, {0.42, 0.55, 0.58}, 0.45);
  add("foot", {0.75, 0.6, 0.745}, {0.1, 0.06, 0.1}, 0.1);
  add("screen", {0.5, 0.6, 0.85}, {0.6, 0.04, 0.36}, 0.1);
  add("seat", {0.55, -0.55, 0.42}, {0.5, 0.5, 0.06}, 0.3);
  add("back", {0.55, -0.6, 0.5}, {0.5, 0.04, 0.24}, 0.3);
}

RoomModel small_room(const std::string& name, double rho) {
  RoomModel room;
  room.name = name;
  room.size_m = {4.0, 3.0, 2.5};
  room.floor = room.walls = room.ceiling = rho;
  room.webs = {wide_web(2000.0)};
  room.lamps = {{{2.0, 1.5, 2.48}, 0, false, ""}};
  room.points = {
      {{2.5, 2.2, 0.75}, {0, 0, 1}, "open"},          {{0.7, 0.6, 0.75}, {0, 0, 1}, "open"},
      {{0.005, 1.5, 0.75}, {0, 0, 1}, "wall .005"},   {{2.0, 2.95, 0.75}, {0, 0, 1}, "wall .05"},
      {{0.005, 0.005, 0.75}, {0, 0, 1}, "edge .005"}, {{3.98, 2.98, 0.02}, {0, 0, 1}, "corner .02"},
      {{3.2, 0.0, 1.2}, {0, 1, 0}, "on wall"}};
  return room;
}

RoomModel find_fixed(const std::string& name) {
  if (name == "room") return empty_room(12, 9);
  if (name == "room1000") return empty_room(40, 25);
  if (name == "office") return office(40, 25);
  if (name == "office126") return office(14, 9);
  if (name == "corridor") return corridor();
  if (name == "hall") return hall();
  if (name == "sphere") return sphere(0.9);
  if (name == "box") return box(0.9);
  if (name.starts_with("near-")) return near_room(name.substr(5));
  return narrow_room(name);
}

}  // namespace

std::vector<std::string> room_names() {
  return {"room",      "room1000",     "office",     "office126", "corridor",
          "hall",      "spots",        "uplights",   "washers",   "near-12",
          "near-1000", "near-washers", "near-spots", "sphere",    "box"};
}

RoomModel find_room(const std::string& name) {
  const std::vector<std::string> names = room_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::runtime_error(
        fmt::format("no scene '{}'; there are: {}", name, fmt::join(names, ", ")));
  }
  RoomModel room = find_fixed(name);
  room.name = name;
  return room;
}

RoomModel office(int columns, int rows) {
  RoomModel room;
  room.name = "office";
  room.size_m = {12.0, 8.0, 2.8};
  for (int k = 0; k < 8; ++k) {
    add_workplace(room, k + 1, 1.1 + 2.8 * (k % 4), 1.9 + 3.2 * (k / 4));
  }
  for (int k = 0; k < 5; ++k) {
    room.blocks.push_back(
        {fmt::format("cabinet{}", k + 1), {1.5 + 1.9 * k, 7.54, 0.01}, {1.2, 0.42, 1.6}, 0.5});
  }
  room.webs = {wide_web(3600.0), asymmetric_web(3600.0)};
  add_lamp_grid(room, 4, 3, 2.78);
  for (std::size_t i = 0; i < room.lamps.size(); ++i) {
    const bool is_at_window = i < 4;
    room.lamps[i].group = is_at_window ? "window" : "core";
    room.lamps[i].web = is_at_window ? 1 : 0;
  }
  room.grid = {{0.5, 0.5, 0.75}, 11.0, 7.0, columns, rows};
  return room;
}

RoomModel hall() {
  RoomModel room;
  room.name = "hall";
  room.size_m = {40.0, 25.0, 6.0};
  for (int k = 0; k < 40; ++k) {  // 40 x 12,288 triangles
    room.blocks.push_back({fmt::format("shelf{}", k + 1),
                           {2.0 + 3.6 * (k % 10), 1.5 + 3.0 * (k / 10), 0.05},
                           {2.8, 0.8, 3.0},
                           0.4,
                           32});
  }
  for (int k = 0; k < 25; ++k) {  // 25 x 20,480 triangles
    room.balls.push_back({{3.0 + 3.5 * (k % 10), 15.0 + 3.5 * (k / 10), 1.2}, 1.0, 0.3, 5});
  }
  room.webs = {wide_web(20000.0)};
  add_lamp_grid(room, 8, 5, 5.9);
  room.grid = {{0.45, 0.45, 0.8}, 39.0, 24.0, 40, 30};  // no point in a shelf's face
  return room;
}

RoomModel box(double reflectance) {
  RoomModel room;
  room.name = fmt::format("box {}", reflectance);
  room.size_m = {4.0, 4.0, 4.0};
  room.floor = room.walls = room.ceiling = reflectance;
  room.webs = {wide_web(1000.0)};
  room.lamps = {{{1.7, 2.2, 3.5}, 0, false, ""}};
  room.grid = {{0.0, 0.0, 0.8}, 4.0, 4.0, 8, 8};
  return room;
}

RoomModel sphere(double reflectance) {
  RoomModel room;
  room.name = fmt::format("sphere {}", reflectance);
  constexpr double kRadius_m = 2.0;
  room.balls = {{{0, 0, 0}, kRadius_m, reflectance, 4}};
  room.webs = {wide_web(1000.0)};
  room.lamps = {{{0.5, 0.2, 0.7}, 0, false, ""}};
  const BenchScene surface = make_scene(room);
  for (std::size_t t = 0; t < surface.scene.triangle.size(); t += 83) {  // 62 of 5,120
    const glm::uvec3 corner = surface.scene.triangle[t];
    const glm::dvec3 a(surface.scene.vertex_m[corner.x]), b(surface.scene.vertex_m[corner.y]),
        c(surface.scene.vertex_m[corner.z]);
    const glm::dvec3 centre = (a + b + c) / 3.0 + surface.scene.origin_m;
    glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    if (glm::dot(normal, centre) > 0.0) normal = -normal;
    room.points.push_back({centre, normal, ""});
  }
  return room;
}

RoomModel box_surface(double reflectance) {
  RoomModel room = box(reflectance);
  room.name = fmt::format("box surface {}", reflectance);
  room.grid = {};
  constexpr int kCells = 12;
  const double size = room.size_m.x;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 1.0}) {
      for (int k = 0; k < kCells * kCells; ++k) {
        Point point;
        point.position_m[axis] = side * size;
        point.position_m[(axis + 1) % 3] = (k % kCells + 0.5) / kCells * size;
        point.position_m[(axis + 2) % 3] = (k / kCells + 0.5) / kCells * size;
        point.normal = glm::dvec3(0.0);
        point.normal[axis] = side == 0.0 ? 1.0 : -1.0;
        room.points.push_back(point);
      }
    }
  }
  return room;
}

RoomModel near_room(const std::string& kind) {
  RoomModel room;
  room.name = "near-" + kind;
  room.size_m = {8.0, 6.0, 2.8};
  if (kind == "washers") {
    room.webs = {wide_web(2000.0)};
    for (int i = 0; i < 6; ++i) {
      room.lamps.push_back({{(i + 0.5) * 8.0 / 6.0, 0.03, 2.7}, 0, false, ""});
    }
  } else if (kind == "spots") {
    room.webs = {spot_web(900.0, 8.0)};
    add_lamp_grid(room, 4, 3, 2.78);
  } else if (kind == "1000") {
    room.webs = {wide_web(32.0)};
    add_lamp_grid(room, 40, 25, 2.78);
  } else {
    room.webs = {wide_web(32000.0 / 12.0)};
    add_lamp_grid(room, 4, 3, 2.78);
  }
  for (const double d : {0.005, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    for (const double x : {1.3, 3.1, 4.7, 6.2}) {  // the wall at y = 0
      room.points.push_back({{x, d, 0.0}, {0, 0, 1}, fmt::format("wall {}", d)});
    }
  }
  for (const double d : {0.005, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    for (const double x : {d, 8.0 - d}) {
      for (const double y : {d, 6.0 - d}) {
        room.points.push_back({{x, y, 0.0}, {0, 0, 1}, fmt::format("corner {}", d)});
      }
    }
  }
  return room;
}

RoomModel scaling_room(const ScalingSize& size) {
  RoomModel room;
  room.name = fmt::format("scaling {} {} {} {}", size.points, size.luminaires, size.cells,
                          size.reflectance);
  room.size_m = {24.0, 16.0, 3.0};
  room.floor = room.walls = room.ceiling = size.reflectance;
  room.cells = size.cells;
  for (int k = 0; k < 8; ++k) {
    room.blocks.push_back({fmt::format("block{}", k + 1),
                           {2.0 + 5.5 * (k % 4), 4.0 + 6.0 * (k / 4), 0.05},
                           {2.0, 1.5, 0.7},
                           size.reflectance,
                           size.cells});
  }
  room.webs = {wide_web(60000.0 / size.luminaires)};
  const double aspect = room.size_m.x / room.size_m.y;
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(size.luminaires / aspect))));
  const int columns = (size.luminaires + rows - 1) / rows;
  add_lamp_grid(room, columns, rows, 2.98);
  room.lamps.resize(static_cast<std::size_t>(size.luminaires), room.lamps.front());
  const int point_rows =
      std::max(1, static_cast<int>(std::lround(std::sqrt(size.points / aspect))));
  room.grid = {
      {0.3, 0.3, 0.8}, 23.4, 15.4, (size.points + point_rows - 1) / point_rows, point_rows};
  return room;
}

std::vector<RoomModel> coverage_rooms() {
  RoomModel plain = small_room("plain", 0.5);
  RoomModel furnished = small_room("furnished", 0.6);
  furnished.blocks = {{"table", {1.0, 1.0, 0.66}, {1.2, 0.6, 0.04}, 0.4},
                      {"shelf", {3.6, 0.2, 0.01}, {0.35, 1.2, 1.8}, 0.5}};
  furnished.points.push_back({{0.99, 1.3, 0.68}, {0, 0, 1}, "beside table"});
  furnished.points.push_back({{1.5, 1.3, 0.1}, {0, 0, 1}, "below table"});
  furnished.points.push_back({{3.59, 0.8, 0.75}, {0, 0, 1}, "beside shelf"});
  RoomModel stiff = small_room("stiff .95", 0.95);
  RoomModel washed = small_room("washer", 0.5);
  washed.lamps[0].position_m = {2.0, 0.03, 2.3};
  RoomModel spots = small_room("spots", 0.5);
  spots.webs = {spot_web(900.0, 8.0)};
  spots.lamps = {{{1.0, 1.0, 2.48}, 0, false, ""}, {{3.0, 2.0, 2.48}, 0, false, ""}};
  RoomModel uplight = small_room("uplight", 0.5);
  uplight.webs = spots.webs;
  uplight.lamps = {{{1.5, 1.2, 1.6}, 0, true, ""}};
  return {plain, furnished, stiff, washed, spots, uplight};
}

}  // namespace bench
