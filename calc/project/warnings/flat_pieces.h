#pragma once
// Flat pieces of triangles of bodies, which others in the same plane cut.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

inline constexpr double kSamePlane_m = 1.0e-6;

using Corners3 = std::array<glm::dvec3, 3>;

Corners3 corners_of(const Body& body, std::size_t triangle);

// A triangle's plane with axes in it.
struct PlaneFrame {
  glm::dvec3 origin_m, u, v, normal;
  bool is_valid = false;  // the triangle is no needle

  explicit PlaneFrame(const Corners3& t);
  double height_m(const glm::dvec3& p) const { return glm::dot(normal, p - origin_m); }
  bool holds(const Corners3& t, double tolerance_m) const;
  glm::dvec2 flat(const glm::dvec3& p) const {
    return {glm::dot(u, p - origin_m), glm::dot(v, p - origin_m)};
  }
  std::array<glm::dvec2, 3> flat(const Corners3& t) const {
    return {flat(t[0]), flat(t[1]), flat(t[2])};
  }
  glm::dvec3 raised(const glm::dvec2& p) const { return origin_m + p.x * u + p.y * v; }
};

// Returns whether one of two triangles lies in the plane of the other; frame: that of `one`.
bool lie_in_one_plane(const PlaneFrame& frame, const Corners3& one, const Corners3& other,
                      double tolerance_m);

using FlatPiece = std::vector<glm::dvec2>;  // convex

double twice_area_m2(const FlatPiece& piece);

// The rest of `piece` outside the triangle, and what they share; empty if they share no area.
struct PieceCut {
  std::vector<FlatPiece> outside;
  FlatPiece shared;
};
PieceCut cut_by(FlatPiece piece, std::array<glm::dvec2, 3> triangle);

// Adds the piece's triangles to a body.
void append_fan(Body& body, const PlaneFrame& frame, const FlatPiece& piece,
                std::uint32_t material);
// Removes the triangle; the body's last one gets its place.
void remove_triangle(Body& body, std::size_t triangle);

}  // namespace calc
