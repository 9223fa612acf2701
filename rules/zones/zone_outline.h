#pragma once
// Outlines of zones in a room: turned, measured, and what the walls take from them.

#include <glm/glm.hpp>

#include <vector>

namespace rules {

using Polygon = std::vector<glm::dvec2>;

// Of the bounding rectangle; the outline has a corner.
glm::dvec2 size_of(const Polygon& outline);

// Coordinates along a unit axis and across it, and back.
Polygon along_axis(const Polygon& polygon, glm::dvec2 axis);
Polygon back_from(const Polygon& polygon, glm::dvec2 axis);

// Between a polygon and another one inside it, in metres; 0 where they touch.
double least_distance(const Polygon& inner, const Polygon& outer);

// What is nearer to a wall than the width, one piece for each wall; at corners that point inwards
// as sharp as the others.
std::vector<Polygon> wall_strips(const Polygon& room, double width_m);

// Area of the parts of a room that are too narrow to hold anything so far from the walls. Sampled.
double lost_to_margin_m2(const Polygon& room, double margin_m);

}  // namespace rules
