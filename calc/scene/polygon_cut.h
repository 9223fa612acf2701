#pragma once
// Divides polygons into pieces: the rest of an area when others are cut out of it.

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// A convex polygon, corners counter-clockwise.
using ConvexPiece = std::vector<glm::dvec2>;

// Returns triangles of a simple polygon of either direction; empty if it is not simple.
std::vector<ConvexPiece> convex_pieces(const std::vector<glm::dvec2>& polygon);

// Returns the pieces without `hole`, as convex pieces that do not overlap if the given ones do not.
// Slivers below 1e-12 of the pieces' area are dropped.
std::vector<ConvexPiece> cut_out(const std::vector<ConvexPiece>& pieces, const ConvexPiece& hole);

double area(const std::vector<ConvexPiece>& pieces);

}  // namespace calc
