#pragma once
// The rooms of the benchmarks, by name.

#include "tests/bench/room_model.h"

#include <string>
#include <vector>

namespace bench {

// Throws std::runtime_error, with all names, if there is none of that name.
RoomModel find_room(const std::string& name);
// "room", "office", ...
std::vector<std::string> room_names();

// An office of 12 x 8 x 2.8 m: 8 workplaces, 5 cabinets, 840 triangles, 12 luminaires in 2 groups.
RoomModel office(int columns, int rows);
// 40 x 25 x 6 m with shelves and machines of about a million triangles.
RoomModel hall();
// A cube of 4 m with one luminaire in its upper half and a plane at 0.8 m.
RoomModel box(double reflectance);
// Radius 2 m, points on its surface.
RoomModel sphere(double reflectance);
// The box with points spread over all of its surface, the same share of the area for each.
RoomModel box_surface(double reflectance);

// Floor points at 5 mm to 1 m from a wall ("wall 0.005") and from a corner ("corner 0.005"). kind:
// "12", "1000" luminaires, "washers", "spots".
RoomModel near_room(const std::string& kind);

// 24 x 16 x 3 m with 8 blocks, for growth in one quantity: everything else stays the same.
struct ScalingSize {
  int points = 1000, luminaires = 12;
  int cells = 1;  // every face in cells x cells squares: 108 cells^2 triangles
  double reflectance = 0.5;
};
RoomModel scaling_room(const ScalingSize& size);

// Small rooms with awkward points, for many seeds.
std::vector<RoomModel> coverage_rooms();

}  // namespace bench
