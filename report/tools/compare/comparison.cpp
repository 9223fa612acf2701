#include "report/tools/compare/comparison.h"

#include "calc/base/elementary.h"
#include "calc/base/statistics.h"
#include "report/revision/gate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace report {
namespace {

constexpr double kFamilyError = 0.05;
constexpr double kRounding = 1e-9;  // a share of the value: numbers written and read again

double slack_lx(const ComparedPoint& point) { return kRounding * std::abs(point.b.lx); }

bool are_both_nothing(const ComparedPoint& point) {
  return std::isnan(point.a.lx) && std::isnan(point.b.lx);
}

// How much of its interval, or of B where there is none, a difference takes; never NaN.
double severity(const ComparedPoint& point) {
  if (are_both_nothing(point)) return 0.0;
  if (std::isnan(point.difference_lx()) || std::isnan(point.interval_lx())) return HUGE_VAL;
  return std::abs(point.difference_lx()) /
         std::max({point.interval_lx(), 1e-6 * std::abs(point.b.lx), 1e-300});
}

}  // namespace

double ComparedPoint::interval_lx() const { return calc::hypot(a.half_width_lx, b.half_width_lx); }

std::size_t Comparison::points() const {
  std::size_t sum = 0;
  for (const ComparedPlane& plane : planes) sum += plane.points.size();
  return sum;
}

std::size_t Comparison::beyond() const {
  std::size_t sum = 0;
  for (const ComparedPlane& plane : planes) sum += plane.beyond;
  return sum;
}

std::size_t Comparison::averages_judged() const {
  std::size_t sum = 0;
  for (const ComparedPlane& plane : planes) sum += plane.average_interval_lx() ? 1 : 0;
  return sum;
}

std::size_t Comparison::averages_beyond() const {
  std::size_t sum = 0;
  for (const ComparedPlane& plane : planes) sum += plane.is_average_beyond ? 1 : 0;
  return sum;
}

bool Comparison::is_alike() const {
  return are_values_alike() && !(revised && is_judged_otherwise(*revised->revision));
}

std::optional<double> ComparedPlane::average_interval_lx() const {
  if (!average_half_width_a_lx || !average_half_width_b_lx) return std::nullopt;
  return calc::hypot(*average_half_width_a_lx, *average_half_width_b_lx);
}

void compare_points(Comparison& comparison) {
  const int freedom = std::max(1, comparison.replicates - 1);
  const double each = kFamilyError / static_cast<double>(std::max<std::size_t>(
                                         1, comparison.points() + comparison.averages_judged()));
  const double stated = calc::student_t_quantile(0.5 + 0.5 * comparison.confidence, freedom);
  comparison.widening = std::max(1.0, calc::student_t_quantile(1.0 - 0.5 * each, freedom) / stated);
  for (ComparedPlane& plane : comparison.planes) {
    const auto nothing = std::count_if(plane.points.begin(), plane.points.end(), are_both_nothing);
    const auto n =
        std::max(1.0, static_cast<double>(plane.points.size()) - static_cast<double>(nothing));
    double low_a = 1e300, low_b = 1e300, sum = 0.0, squares = 0.0;
    plane.average_a_lx = plane.average_b_lx = 0.0;
    plane.held = plane.beyond = 0;
    for (const ComparedPoint& point : plane.points) {
      if (are_both_nothing(point)) {
        ++plane.held;
        continue;
      }
      const double d = point.difference_lx();
      plane.average_a_lx += point.a.lx / n;
      plane.average_b_lx += point.b.lx / n;
      low_a = std::min(low_a, point.a.lx);
      low_b = std::min(low_b, point.b.lx);
      sum += d / n;
      squares += d * d / n;
      if (std::abs(d) <= point.interval_lx() + slack_lx(point)) ++plane.held;
      const double allowed = comparison.widening * point.interval_lx() +
                             comparison.tolerance * std::abs(point.b.lx) + slack_lx(point);
      if (!(std::abs(d) <= allowed)) ++plane.beyond;
    }
    const double scale = plane.average_b_lx;
    if (const std::optional<double> interval = plane.average_interval_lx()) {
      const double allowed =
          comparison.widening * *interval + (comparison.tolerance + kRounding) * std::abs(scale);
      plane.is_average_beyond = !(std::abs(plane.average_a_lx - scale) <= allowed);
    }
    plane.uo_a = plane.average_a_lx > 0.0 ? low_a / plane.average_a_lx : 0.0;
    plane.uo_b = scale > 0.0 ? low_b / scale : 0.0;
    plane.bias = scale > 0.0 ? sum / scale : (sum == 0.0 ? 0.0 : HUGE_VAL);
    plane.rms = scale > 0.0 ? std::sqrt(squares) / scale : (squares == 0.0 ? 0.0 : HUGE_VAL);
  }
}

std::vector<std::size_t> worst_points(const ComparedPlane& plane, std::size_t count) {
  std::vector<std::size_t> order(plane.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    return severity(plane.points[x]) > severity(plane.points[y]);
  });
  order.resize(std::min(count, order.size()));
  return order;
}

}  // namespace report
