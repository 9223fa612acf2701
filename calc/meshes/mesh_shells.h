#pragma once
// Finds the shells of a mesh: what its triangles enclose, and where they leave gaps. Nothing here
// traces light.

#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// The direction of a closed shell's faces, by the order of their corners. unclear: triangles meet
// at some of its edges in such a way that it does not have two sides.
enum class FacesLook { inward, outward, mixed, unclear };

// Triangles connected by their edges, where corners at exactly the same position are the same. Two
// shells that only touch along an edge are two.
struct MeshShell {
  std::vector<std::uint32_t> triangle;  // ascending; at least one
  BoundingBox bounds;
  bool is_closed = false;  // each of its edges has an even number of its triangles
  // Values of a closed shell; else unclear, 0 and 0.
  FacesLook faces = FacesLook::unclear;
  std::size_t outward = 0;  // of its triangles; 0 if that is unclear
  double volume = 0.0;      // by the divergence theorem, >= 0; 0 if the faces are unclear
};

// Returns the shells in the order of their first triangles, without triangles with two equal
// corners. O(n log n).
std::vector<MeshShell> find_shells(const std::vector<glm::dvec3>& vertex,
                                   const std::vector<glm::uvec3>& triangle);

// Edges with an odd number of triangles.
struct OpenEdges {
  std::size_t count = 0;
  double length = 0.0;  // of all together
  double longest = 0.0;
  glm::dvec3 at{0.0};  // where the longest begins
};
OpenEdges open_edges(const std::vector<glm::dvec3>& vertex,
                     const std::vector<glm::uvec3>& triangle);

// Returns whether there is a place from which at least 18 of 26 directions, spread evenly, meet a
// triangle, among 27 places of the box around them. A flat sheet or a tray encloses nothing; a room
// without a ceiling or with large openings does. O(27 * 26 * triangles) at most.
bool encloses_something(const std::vector<glm::dvec3>& vertex,
                        const std::vector<glm::uvec3>& triangle);

// The floor: the triangles at the lowest height of the shell, within a millimetre.
struct MeshFloor {
  std::vector<glm::dvec2> outline;  // counter-clockwise, simple; empty: not one polygon, see below
  double z = 0.0, height = 0.0;     // up to the highest corner
  double above = 0.0;  // area, seen from above, of what looks up elsewhere; of closed shells only
};
// Returns the floor of a mesh in metres. It has no outline if those triangles are not a single
// polygon without holes, or if other surfaces that look up have, seen from above, more than a
// twentieth of their area: then the room has several floors, and the right one is not known.
MeshFloor find_floor(const std::vector<glm::dvec3>& vertex_m,
                     const std::vector<glm::uvec3>& triangle);

}  // namespace calc
