#pragma once
// Outlines of zones in a room: turning and measuring them, and cutting off the strips at walls.

#include <glm/glm.hpp>

#include <vector>

namespace rules {

using Polygon = std::vector<glm::dvec2>;

// Returns the size of the bounding rectangle; the outline must have a corner.
glm::dvec2 size_of(const Polygon& outline);

// Return coordinates along a unit axis and across it, and back.
Polygon along_axis(const Polygon& polygon, glm::dvec2 axis);
Polygon back_from(const Polygon& polygon, glm::dvec2 axis);

// Returns the least distance between a polygon and another one inside it, in metres; 0 if they
// touch.
double least_distance(const Polygon& inner, const Polygon& outer);

// Returns the parts nearer to a wall than the width, one piece for each wall; corners that point
// inwards stay as sharp as the others.
std::vector<Polygon> wall_strips(const Polygon& room, double width_m);

// Returns the area of the parts of a room that are too narrow to hold anything at this distance
// from the walls. Sampled.
double lost_to_margin_m2(const Polygon& room, double margin_m);

}  // namespace rules
