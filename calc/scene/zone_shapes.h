#pragma once
// Outlines of the zones of a room. Polygons are simple, counter-clockwise, in metres, of at most
// some hundred corners.

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// Every side moved outwards by `width_m`, inwards if it is negative; corners stay sharp. Empty if
// nothing simple comes out: sides would vanish or run into each other.
std::vector<glm::dvec2> moved_sides(const std::vector<glm::dvec2>& polygon, double width_m);

// Without what is outside the region's bounding rectangle, if that leaves one simple polygon; as it
// is, otherwise. Empty if nothing is left.
std::vector<glm::dvec2> within_bounds(const std::vector<glm::dvec2>& polygon,
                                      const std::vector<glm::dvec2>& region);

// The convex pieces of the polygon that lie outside the region. Slivers below 1e-9 of the polygon's
// area are dropped.
std::vector<std::vector<glm::dvec2>> pieces_outside(const std::vector<glm::dvec2>& polygon,
                                                    const std::vector<glm::dvec2>& region);

// What is left of an outline without the holes, m2; holes may overlap and reach beyond it.
double area_left(const std::vector<glm::dvec2>& outline,
                 const std::vector<std::vector<glm::dvec2>>& holes);

}  // namespace calc
