#include "report/tools/import/dxf_curve.h"

#include "calc/base/elementary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cli {
namespace {

constexpr int kDeepestHalving = 12;  // of a span of a spline
constexpr double kRounding = 1.001;

glm::dvec3 point_at(const DxfEllipse& ellipse, double t) {
  return ellipse.centre + calc::cos(t) * ellipse.x_axis + calc::sin(t) * ellipse.y_axis;
}

double add_ellipse(const DxfEllipse& ellipse, double error, std::vector<glm::dvec3>& points) {
  // It is a stretched circle: chords of equal steps are at most as far away as those of the circle
  // about it.
  const double radius = std::max(glm::length(ellipse.x_axis), glm::length(ellipse.y_axis));
  const double share = std::clamp(1.0 - error / radius, -1.0, 1.0);
  const double step = 2.0 * calc::acos(share);
  const double wanted = step > 0.0 ? std::ceil(std::fabs(ellipse.angle) / step) : kMostChords;
  const int count = static_cast<int>(std::clamp(wanted, 1.0, double{kMostChords}));
  for (int i = 1; i < count; ++i) {
    points.push_back(point_at(ellipse, ellipse.from + ellipse.angle * i / count));
  }
  // The height of an arc over its chord; where no limit was met its rounding does not count.
  const double half = calc::sin(std::fabs(ellipse.angle) / count / 4.0);
  const double reached = 2.0 * radius * half * half;
  return reached <= error * kRounding ? error : reached;
}

// With weights as the fourth coordinate: (w x, w y, w z, w).
using Poles = std::vector<glm::dvec4>;

glm::dvec3 projected(const glm::dvec4& pole) { return glm::dvec3(pole) / pole.w; }

// The span from knot[at] to knot[at + 1] as a Bezier curve: its poles are the values of the
// spline's polar form with the ends of the span as arguments.
Poles bezier_of_span(const DxfSpline& spline, std::size_t at) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  const double low = spline.knot[at], high = spline.knot[at + 1];
  Poles bezier;
  for (std::size_t pole = 0; pole <= degree; ++pole) {
    Poles left;
    for (std::size_t i = at - degree; i <= at; ++i) {
      const double weight = spline.weight.empty() ? 1.0 : spline.weight[i];
      left.emplace_back(weight * spline.control[i], weight);
    }
    for (std::size_t level = 1; level <= degree; ++level) {
      const double t = level <= pole ? high : low;
      for (std::size_t i = 0; i + level <= degree; ++i) {
        const std::size_t first = at - degree + level + i;
        const double begin = spline.knot[first], end = spline.knot[at + 1 + i];
        const double share = (t - begin) / (end - begin);  // the span is within: end > begin
        left[i] = (1.0 - share) * left[i] + share * left[i + 1];
      }
    }
    bezier.push_back(left[0]);
  }
  return bezier;
}

double distance_to_chord(const glm::dvec3& at, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 chord = to - from;
  const double length2 = glm::dot(chord, chord);
  const double share =
      length2 > 0.0 ? std::clamp(glm::dot(at - from, chord) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(at, from + share * chord);
}

// Weights are positive, so the curve stays in the hull of its poles: where these are near the chord
// it is, too. How far they are at most.
double add_bezier(const Poles& poles, double error, int depth, std::vector<glm::dvec3>& points) {
  const glm::dvec3 from = projected(poles.front()), to = projected(poles.back());
  double farthest = 0.0;
  for (const glm::dvec4& pole : poles) {
    farthest = std::max(farthest, distance_to_chord(projected(pole), from, to));
  }
  if (farthest <= error || depth == 0 || points.size() >= kMostCurvePoints) return farthest;
  Poles first, second(poles.size()), left = poles;
  for (std::size_t level = 0; level < poles.size(); ++level) {
    first.push_back(left.front());
    second[poles.size() - 1 - level] = left.back();
    for (std::size_t i = 0; i + 1 < left.size(); ++i) left[i] = 0.5 * (left[i] + left[i + 1]);
    left.pop_back();
  }
  const double before = add_bezier(first, error, depth - 1, points);
  points.push_back(projected(second.front()));
  return std::max(before, add_bezier(second, error, depth - 1, points));
}

// Knots [at] < [at + 1] within the curve.
std::vector<std::size_t> spans_of(const DxfSpline& spline) {
  std::vector<std::size_t> spans;
  for (auto at = static_cast<std::size_t>(spline.degree); at < spline.control.size(); ++at) {
    if (spline.knot[at] < spline.knot[at + 1]) spans.push_back(at);
  }
  return spans;
}

double add_spline(const DxfSpline& spline, double error, std::vector<glm::dvec3>& points) {
  const double least = std::max(error, kFinestOfSpline * curve_size(spline));
  const std::vector<std::size_t> spans = spans_of(spline);
  double reached = error;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Poles bezier = bezier_of_span(spline, spans[i]);
    if (i > 0) points.push_back(projected(bezier.front()));
    reached = std::max(reached, add_bezier(bezier, least, kDeepestHalving, points));
  }
  return reached;
}

std::string spline_problem(const DxfSpline& spline) {
  if (spline.control.empty()) return "it has no control points";
  if (spline.degree < 1 || spline.degree > kHighestSplineDegree) {
    return fmt::format("its degree is not 1 to {}", kHighestSplineDegree);
  }
  if (spline.control.size() > kMostSplinePoints) {
    return fmt::format("it has more than {} control points", kMostSplinePoints);
  }
  const auto degree = static_cast<std::size_t>(spline.degree);
  if (spline.control.size() <= degree || spline.knot.size() != spline.control.size() + degree + 1) {
    return "its numbers of knots and control points do not match";
  }
  if (!std::is_sorted(spline.knot.begin(), spline.knot.end()))
    return "its knots are not in ascending order";
  if (!(spline.knot[degree] < spline.knot[spline.control.size()])) return "its knots are all equal";
  for (std::size_t i = degree + 1; i + degree < spline.control.size(); ++i) {
    if (spline.knot[i] == spline.knot[i + degree]) return "a repeated knot splits it";
  }
  if (!spline.weight.empty() && spline.weight.size() != spline.control.size()) {
    return "the counts of its weights and control points differ";
  }
  constexpr double kLeast = 1.0e-9, kMost = 1.0e9;
  if (!std::all_of(spline.weight.begin(), spline.weight.end(),
                   [&](double weight) { return weight >= kLeast && weight <= kMost; })) {
    return "one of its weights is not above 0";
  }
  return "";
}

}  // namespace

std::string curve_problem(const DxfCurve& curve) {
  if (const auto* spline = std::get_if<DxfSpline>(&curve)) return spline_problem(*spline);
  const auto& ellipse = std::get<DxfEllipse>(curve);
  const bool is_one = glm::length(ellipse.x_axis) > 0.0 && glm::length(ellipse.y_axis) > 0.0 &&
                      ellipse.angle != 0.0;
  return is_one ? "" : "it has no length";
}

glm::dvec3 curve_start(const DxfCurve& curve) {
  if (const auto* ellipse = std::get_if<DxfEllipse>(&curve)) {
    return point_at(*ellipse, ellipse->from);
  }
  const auto& spline = std::get<DxfSpline>(curve);
  return projected(bezier_of_span(spline, spans_of(spline).front()).front());
}

glm::dvec3 curve_end(const DxfCurve& curve) {
  if (const auto* ellipse = std::get_if<DxfEllipse>(&curve)) {
    return point_at(*ellipse, ellipse->from + ellipse->angle);
  }
  const auto& spline = std::get<DxfSpline>(curve);
  return projected(bezier_of_span(spline, spans_of(spline).back()).back());
}

double curve_size(const DxfCurve& curve) {
  if (const auto* ellipse = std::get_if<DxfEllipse>(&curve)) {
    return 2.0 * std::max(glm::length(ellipse->x_axis), glm::length(ellipse->y_axis));
  }
  const auto& spline = std::get<DxfSpline>(curve);
  glm::dvec3 low = spline.control.front(), high = low;
  for (const glm::dvec3& point : spline.control) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return glm::distance(low, high);
}

std::size_t curve_work(const DxfCurve& curve) {
  const auto* spline = std::get_if<DxfSpline>(&curve);
  if (spline == nullptr) return 1;
  const auto degree = static_cast<std::size_t>(spline->degree);
  return spline->control.size() * (1 + degree * degree / 8);
}

double add_chords(const DxfCurve& curve, double error, std::vector<glm::dvec3>& points) {
  if (const auto* ellipse = std::get_if<DxfEllipse>(&curve)) {
    return add_ellipse(*ellipse, error, points);
  }
  return add_spline(std::get<DxfSpline>(curve), error, points);
}

}  // namespace cli
