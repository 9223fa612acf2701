#pragma once
// How much a plane stands for: of a wall, of the ceiling, of what is around another zone, of what
// another one stands for, too.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

// A flat wall or ceiling of a room.
struct RoomSurface {
  std::string id;                     // of its body: "r.wall2"
  glm::dvec3 origin_m, u, v;          // orthonormal axes
  std::vector<glm::dvec2> outline_m;  // in (u, v)
};

// Those whose body's id ends with the part, before its digits: ".wall", ".ceiling". In the order of
// the bodies. Empty for spaces that do not know their walls.
std::vector<RoomSurface> surfaces_of(const calc::Space& space, std::string_view part);

// Whether anything is left of the surface without a strip along its edges, in metres.
bool has_inside(const RoomSurface& surface, double strip_m);

struct CoveredSurface {
  std::string id;
  double area_m2 = 0.0;  // of the surface, without the strip along its edges
  double share = 0.0;    // of that, [0, 1]: covered by the area without its own strip
};

// Of the surfaces that the area lies on (within kLift_m, on either side) as far as something is
// left of them without a strip of strip_m along their edges. own_strip_m: along the outline of the
// area, which does not count; its holes do not, either. Measured at some thousand places of every
// surface.
std::vector<CoveredSurface> covered_surfaces(const calc::PlanarArea& area, double own_strip_m,
                                             const std::vector<RoomSurface>& surfaces,
                                             double strip_m);

// What a number about the surroundings of a zone is about: a band around it, and it if it belongs
// to that.
struct ZoneAround {
  const calc::PlanarArea* inner;
  double from_m = 0.0, to_m = 0.0;  // of the band, from the outline of the zone, in its plane
  bool has_inner = false;
};

// Whether the area, seen along the zone's normal, comes near what is around the zone: else it
// covers nothing of that.
bool comes_near(const calc::PlanarArea& area, const ZoneAround& around);

// What share the area without its own strip covers, [0, 1], of what is around the zone, as far as
// that is in the room, off the strip of strip_m along the walls, and in none of the others, which
// are zones beside it. The area is seen along the zone's normal, at any distance. own_strip_m as
// above. 1 where nothing of it is. Measured at some thousand places.
double covered_zone(const calc::PlanarArea& area, double own_strip_m, const ZoneAround& around,
                    std::span<const calc::PlanarArea* const> others, const calc::Space& space,
                    double strip_m);

// What is of both, m2: places that look the same way, seen along the normal of the first one, with
// less than a headroom between them. Holes are of neither.
double shared_area_m2(const calc::PlanarArea& area, const calc::PlanarArea& other);

}  // namespace rules
