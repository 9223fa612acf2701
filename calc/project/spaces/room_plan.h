#pragma once
// A room's prism while it is read: corners in file order, from which walls are numbered.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace calc {

// A rectangle in the world; u and v are its full sides, perpendicular, u x v faces into the room.
struct Rectangle {
  glm::dvec3 origin_m, u_m, v_m;
};

// corners_m: simple polygon in room coordinates (x, y), either direction; wall k runs from corner k
// to corner k + 1 (both counted from 0; wall 0 is "wall1" in files). The floor is at origin_m.z.
struct RoomPlan {
  std::vector<glm::dvec2> corners_m;
  bool is_clockwise = false;
  glm::dvec3 origin_m{0.0};
  double height_m = 0.0;

  // Returns the shell in world coordinates, counter-clockwise.
  RoomShell shell() const;
  // Returns the outline in room coordinates, counter-clockwise.
  std::vector<glm::dvec2> outline() const;
  Rectangle wall(std::size_t index) const;
};

// Materials: indices into Project::materials, one per wall.
struct ShellMaterials {
  std::uint32_t floor = 0, ceiling = 0;
  std::vector<std::uint32_t> walls;
};

// Returns floor, ceiling and walls, facing into the room, with ids "<id>.floor", "<id>.ceiling",
// "<id>.wall1" ...
std::vector<Body> make_shell_bodies(const RoomPlan& plan, const ShellMaterials& materials,
                                    const std::string& room_id, const SourceLocation& where);

}  // namespace calc
