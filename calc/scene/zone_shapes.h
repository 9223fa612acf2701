#pragma once
// Makes outlines of the zones of a room. Polygons are simple, counter-clockwise, in metres, of at
// most some hundred corners.

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// Moves every side outwards by `width_m`, inwards if it is negative; corners stay sharp. Empty if
// the result is not simple: sides would vanish or run into each other.
std::vector<glm::dvec2> moved_sides(const std::vector<glm::dvec2>& polygon, double width_m);

// Returns the polygon within the region's bounding rectangle, if that is one simple polygon, else
// unchanged. Empty if nothing is left.
std::vector<glm::dvec2> within_bounds(const std::vector<glm::dvec2>& polygon,
                                      const std::vector<glm::dvec2>& region);

// Returns the convex pieces of the polygon outside the region. Slivers below 1e-9 of the polygon's
// area are dropped.
std::vector<std::vector<glm::dvec2>> pieces_outside(const std::vector<glm::dvec2>& polygon,
                                                    const std::vector<glm::dvec2>& region);

// Returns the area of an outline without the holes, m2; holes may overlap and reach beyond it.
double area_left(const std::vector<glm::dvec2>& outline,
                 const std::vector<std::vector<glm::dvec2>>& holes);

}  // namespace calc
