#pragma once
// Integrals over rectangles for exact values that have no closed form.

#include <glm/glm.hpp>

#include <array>
#include <functional>
#include <vector>

namespace cli::selftest {

// Gauss-Legendre on [0, 1]: exact for polynomials of degree 2 n - 1. n >= 1.
struct GaussRule {
  std::vector<double> at, weight;  // weights add up to 1
};
GaussRule gauss_rule(int n);

struct Rectangle {
  glm::dvec3 corner, u, v;  // u and v at right angles
  glm::dvec3 normal;        // unit, of the side that counts
  double area_m2() const { return glm::length(glm::cross(u, v)); }
};

// Returns the faces of the box [low, low + size] seen from inside, in the order x0, x1, y0, ...
std::array<Rectangle, 6> faces_of_box(const glm::dvec3& low, const glm::dvec3& size);

// A point of a rule over a rectangle; the weights of one rectangle add up to its area.
struct AreaPoint {
  glm::dvec3 position_m, normal;
  double area_m2;
};
std::vector<AreaPoint> points_on(const Rectangle& rectangle, int n);

// Returns the exitance or illuminance at a point of a surface.
using SurfaceValue = std::function<double(const glm::dvec3& position_m)>;

// Illuminance at x with unit normal n of a diffuse rectangle of exitance M(y), nothing between:
//   E = integral of M(y) / pi cos cos / d^2 dA.
// 4 x 4 Gauss points in cells at most 0.4 times as long as their distance from x and from each of
// `hot` (places near which M changes quickly): relative error below 1e-6 where M is that of point
// sources at `hot`.
double reflected_lx(const Rectangle& source, const SurfaceValue& exitance,
                    const std::vector<glm::dvec3>& hot, const glm::dvec3& x, const glm::dvec3& n);

}  // namespace cli::selftest
