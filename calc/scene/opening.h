#pragma once
// A luminaire's luminous opening seen from outside: points on it, and the share of the luminaire's
// light that each sends in a direction.

#include "calc/photometry/web_sketch.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace calc {

// Maps (s, t) of the unit square to the unit disk, evenly.
glm::dvec2 unit_disk(double s, double t);

// Returns the point of a flat opening at (s, t) of the unit square, mapped evenly; for a body the
// centre. Local coordinates.
glm::dvec3 opening_point_m(const PlacedLuminaire& luminaire, double s, double t);

// Returns whether the point is inside a luminous body, or on it up to `distance_m`.
bool is_inside_opening(const PlacedLuminaire& luminaire, const glm::dvec3& point_m,
                       double distance_m);

// Returns the intensities (cd) towards the point from places of the opening within radius_m of the
// given place, as far as the table's angles gamma tell.
WebSketch::Band intensities_towards(const PlacedLuminaire& luminaire, const glm::dvec3& place_m,
                                    double radius_m, const glm::dvec3& point_m);

// Returns the area (m2) of the opening's outline seen from far away in the unit direction
// `towards`: 0 for a point, and for a flat opening edge-on.
double seen_opening_m2(const PlacedLuminaire& luminaire, const glm::dvec3& towards);

// The opening seen along one direction. The luminaire's intensity I(w) is spread evenly over what
// an observer far away in direction w sees of it: a flat opening's whole area, a body's outline.
// For a receiver nearer by, dE = I(w_x) k / d^2 times the share of x's surface element in the
// outline along w_x: each point x has its own direction w_x to the receiver.
//
// The unit square (s, t) fills the outline along `towards` evenly. Every point of a body that a
// receiver outside sees is in its outline as seen from the centre towards that receiver: outward
// normals have n.(p - x) > 0 and n.x >= 0, thus n.p > 0.
class OpeningView {
 public:
  // towards: unit, from the luminaire's centre.
  OpeningView(const PlacedLuminaire& luminaire, const glm::dvec3& towards);

  struct Point {
    glm::dvec3 position_m;
    glm::dvec3 normal;  // unit, outward, on the visible side
  };
  Point point(double s, double t) const;

  // Returns the weight of light towards the unit direction, per unit of (s, t): 1 along `towards`
  // and for flat openings, 0 behind the point's surface.
  double weight(const Point& at, const glm::dvec3& direction) const;

  // Returns where the square's first coordinate passes from one face of a body to the next: from 0
  // to 1, ascending. point() is continuous between.
  std::span<const double> piece_ends() const { return {end_.data(), pieces_ + 1}; }

 private:
  struct LocalPoint {
    glm::dvec3 position_m, normal;
  };
  LocalPoint box_point(std::size_t piece, double s, double t) const;
  LocalPoint cylinder_point(std::size_t piece, double s, double t) const;
  LocalPoint ellipsoid_point(double s, double t) const;

  const PlacedLuminaire& luminaire_;
  bool is_flat_;
  glm::dvec3 towards_, local_towards_;  // world and luminaire axes
  glm::dvec3 half_m_;                   // half sizes along the luminaire's axes
  double outline_m2_ = 1.0;             // of a body, along towards_
  static constexpr std::size_t kMostPieces = 4;
  std::size_t pieces_ = 1;
  std::array<double, kMostPieces + 1> end_{0.0, 1.0};
  // [piece]: the axis perpendicular to its face, or kSide; kNothing: the body shows no area.
  std::array<int, kMostPieces> face_{kNothing};

  static constexpr int kSide = 3;  // of a cylinder, or all of an ellipsoid
  static constexpr int kNothing = -1;
};

}  // namespace calc
