#pragma once
// Curves of drawings, and chords along them. In the coordinates of their entity; angles in radians.

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace cli {

// Limits, so that no file uses all memory or time.
inline constexpr int kMostChords = 4096;  // of an arc or ellipse
inline constexpr int kHighestSplineDegree = 25;
inline constexpr std::size_t kMostSplinePoints = 4096;  // control points of one
// Most points of an entity: beyond them a spline gets one chord for each span.
inline constexpr std::size_t kMostCurvePoints = 100'000;
// Smallest chord error of a spline, as a share of the size of its control polygon.
inline constexpr double kFinestOfSpline = 1.0e-6;

// centre + cos(t) x_axis + sin(t) y_axis for t from `from` to `from + angle`.
struct DxfEllipse {
  glm::dvec3 centre{0.0}, x_axis{1.0, 0.0, 0.0}, y_axis{0.0, 1.0, 0.0};
  double from = 0.0, angle = 0.0;
};
// A B-spline between its knots [degree] and [count of control points]: clamped or not, periodic
// ones with the points that they repeat.
struct DxfSpline {
  int degree = 0;
  std::vector<double> knot, weight;  // weight: empty: all are 1
  std::vector<glm::dvec3> control;
};
using DxfCurve = std::variant<DxfEllipse, DxfSpline>;

// Returns why the curve cannot be drawn, "" = it can; all functions below need a curve that can.
std::string curve_problem(const DxfCurve& curve);

glm::dvec3 curve_start(const DxfCurve& curve);
glm::dvec3 curve_end(const DxfCurve& curve);
// Returns an upper limit of its size, as the distance of two of its points.
double curve_size(const DxfCurve& curve);

// Returns the work of finding its chords, as a number of points with equal work.
std::size_t curve_work(const DxfCurve& curve);

// Appends the points strictly between its ends, so that the chords are at most `error` from it,
// unless a limit above is met. Returns the largest distance of the chords: above `error` if a limit
// was met.
double add_chords(const DxfCurve& curve, double error, std::vector<glm::dvec3>& points);

}  // namespace cli
