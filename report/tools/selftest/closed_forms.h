#pragma once
// Exact values of simple situations: closed forms only, no ray and no table. Lengths in m, factors
// are shares of a source's exitance. [Howell82], [Lambert1760].

#include <glm/glm.hpp>

#include <vector>

namespace cli::selftest {

// Of a polygon of even exitance for a small receiver at x with unit normal n: E = M x this. The
// part below the receiver's horizon is cut off. Flat and convex, seen from either side: the caller
// knows which one shines.  [Lambert1760: E = M / (2 pi) sum of angle_k n.(r_k x r_k+1) / |r_k x
// r_k+1|]
double polygon_factor(const glm::dvec3& x, const glm::dvec3& n,
                      const std::vector<glm::dvec3>& corners);
// The same for the rectangle corner, corner + u, corner + u + v, corner + v.
double rectangle_factor(const glm::dvec3& x, const glm::dvec3& n, const glm::dvec3& corner,
                        const glm::dvec3& u, const glm::dvec3& v);

// A disc of radius r at height h over the plane of the receiver, `offset` to the side of it.
double disc_factor_parallel(double r, double h, double offset);  // [Howell82, B-12]
// The receiver's normal is in its plane and points to the disc's axis; all of the disc in front of
// it: offset >= r.
double disc_factor_perpendicular(double r, double h, double offset);  // [Howell82, B-13]

// A sphere of radius r, distance d > r away, its centre at the angle t from the receiver's normal,
// wholly or partly above the horizon, 0 <= t <= pi: E = pi L x this.  [Howell82, B-38, B-39]
double sphere_factor(double r, double d, double t);

// From one surface to another, as a share of what the first one sends.
// Two equal rectangles a x b, opposite each other at distance c.  [Howell82, C-11]
double opposite_rectangles(double a, double b, double c);
// Two rectangles with a common edge of length l, at right angles: from the one of width w to the
// one of height h.  [Howell82, C-14]
double rectangles_with_edge(double l, double w, double h);

// Of a rectangle a x b seen from a point at height h over one of its corners (sr).
double corner_solid_angle(double a, double b, double h);

}  // namespace cli::selftest
