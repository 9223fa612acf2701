#pragma once
// Bounds a luminaire's light: a cone that holds every direction of its intensity table that is not
// dark, and tests whether a thing is outside it.

#include "calc/photometry/web.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace calc {

// All directions within half_angle_rad of the axis. Beyond pi / 2 everything but a cone is lit.
struct Beam {
  glm::dvec3 axis{0.0, 0.0, -1.0};  // unit
  double half_angle_rad = 0.0;      // [0, pi]
};

// Returns the beam in the luminaire's frame. Between a dark and a lit entry of the table the
// interpolated intensity is > 0: every cell of the table with a lit corner counts as a whole, and
// the cone holds the whole cell, not only its corners. The axes nadir, zenith and mean direction
// are tried; the narrowest cone is taken.
Beam beam_of(const PhotometricWeb& web);

// Returns one beam per luminaire in local scene axes; each distinct web is searched once.
std::vector<Beam> beams_of(const PreparedScene& scene);

// The distances that a body must keep: from the plane of an opening that lights one half-space, and
// from the side of a narrower (or the dark cone of a wider) beam.
struct BeamClearance {
  double plane_m;
  double side_m;
};

// Returns true only if no straight line from any point of the opening, in a direction of the beam,
// comes near the convex hull of `corners` (local). Proof: for a beam of at most a half-space there
// is a plane with the opening and the whole beam on one side and all corners, thus their hull, on
// the other; for a wider beam every corner is inside the dark cone, which is convex, and farther
// from its surface than any opening point is from its tip.
bool beam_misses(const Beam& beam, const PlacedLuminaire& luminaire,
                 std::span<const glm::dvec3> corners, const BeamClearance& clearance);

// Returns max of dot(direction, p - centre) over the opening's bounding box, for a unit direction.
double opening_support_m(const PlacedLuminaire& luminaire, const glm::dvec3& direction);

}  // namespace calc
