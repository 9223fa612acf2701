#pragma once
// How much a plane covers: of a wall, of the ceiling, of the surroundings of a zone, or of another
// plane.

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

// Returns the bodies whose id ends with the part before its digits (".wall", ".ceiling"), in their
// order. Empty for spaces that do not know their walls.
std::vector<RoomSurface> surfaces_of(const calc::Space& space, std::string_view part);

// Returns whether anything is left of the surface without a strip along its edges, in metres.
bool has_inside(const RoomSurface& surface, double strip_m);

struct CoveredSurface {
  std::string id;
  double area_m2 = 0.0;  // of the surface, without the strip along its edges
  double share = 0.0;    // of that, [0, 1]: covered by the area without its own strip
};

// Returns the surfaces that the area lies on (within kLift_m, on either side), if anything is left
// of them without a strip of strip_m along their edges. own_strip_m: along the area's outline;
// neither this strip nor the area's holes cover anything. Measured at some thousand places of every
// surface.
std::vector<CoveredSurface> covered_surfaces(const calc::PlanarArea& area, double own_strip_m,
                                             const std::vector<RoomSurface>& surfaces,
                                             double strip_m);

// The surroundings of a zone that a number is about: a band, with the zone itself if it belongs to
// them.
struct ZoneAround {
  const calc::PlanarArea* inner;
  double from_m = 0.0, to_m = 0.0;  // of the band, from the outline of the zone, in its plane
  bool has_inner = false;
};

// Returns whether the area, seen along the zone's normal, comes near the surroundings of the zone;
// if not, it covers none of them.
bool comes_near(const calc::PlanarArea& area, const ZoneAround& around);

// Returns the share, [0, 1], of the surroundings that the area without its own strip covers. Only
// surroundings in the room count, off the strip of strip_m along the walls and outside `others`,
// the zones beside it. The area is seen along the zone's normal, at any distance; own_strip_m as
// above. Returns 1 if there are no such surroundings. Measured at some thousand places.
double covered_zone(const calc::PlanarArea& area, double own_strip_m, const ZoneAround& around,
                    std::span<const calc::PlanarArea* const> others, const calc::Space& space,
                    double strip_m);

// Returns the area that both share, in m2: places that face the same way, seen along the normal of
// the first, with less than a headroom between them. Holes belong to neither.
double shared_area_m2(const calc::PlanarArea& area, const calc::PlanarArea& other);

}  // namespace rules
