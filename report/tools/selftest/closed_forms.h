#pragma once
// Exact values of simple situations: closed forms only, no ray and no table. Lengths in m, factors
// are shares of a source's exitance. [Howell82], [Lambert1760].

#include <glm/glm.hpp>

#include <vector>

namespace cli::selftest {

// Returns the factor of a polygon of even exitance for a small receiver at x with unit normal n: E
// = M x this. The part below the receiver's horizon is cut off. Flat and convex, seen from either
// side: the caller knows which side emits.  [Lambert1760: E = M / (2 pi) sum of angle_k n.(r_k x
// r_k+1) / |r_k x r_k+1|]
double polygon_factor(const glm::dvec3& x, const glm::dvec3& n,
                      const std::vector<glm::dvec3>& corners);
// Returns the same for the rectangle corner, corner + u, corner + u + v, corner + v.
double rectangle_factor(const glm::dvec3& x, const glm::dvec3& n, const glm::dvec3& corner,
                        const glm::dvec3& u, const glm::dvec3& v);

// Returns the factor of a disc of radius r at height h over the plane of the receiver, `offset` to
// its side.
double disc_factor_parallel(double r, double h, double offset);  // [Howell82, B-12]
// Returns the factor for a receiver whose normal is in its plane and points to the disc's axis; all
// of the disc is in front of it: offset >= r.
double disc_factor_perpendicular(double r, double h, double offset);  // [Howell82, B-13]

// Returns the factor of a sphere of radius r, distance d > r away, its centre at the angle t from
// the receiver's normal, wholly or partly above the horizon, 0 <= t <= pi: E = pi L x this.
// [Howell82, B-38, B-39]
double sphere_factor(double r, double d, double t);

// Returns the share of the first surface's light that reaches the other, for two equal rectangles a
// x b, opposite each other at distance c.  [Howell82, C-11]
double opposite_rectangles(double a, double b, double c);
// Returns the share for two rectangles at right angles with a common edge of length l: from the
// rectangle of width w to that of height h.  [Howell82, C-14]
double rectangles_with_edge(double l, double w, double h);

// Returns the solid angle of a rectangle a x b from a point at height h over one of its corners
// (sr).
double corner_solid_angle(double a, double b, double h);

}  // namespace cli::selftest
