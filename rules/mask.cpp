#include "rules/mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rules {
namespace {

constexpr double kTolerance_m = 1e-9;  // a point on the edge of a strip counts

// Place of a point on a rectangle whose long sides run along `along`.
struct Place {
  double along_m, across_m;
};

struct Rectangle {
  double length_m, width_m;  // of the whole plane, length >= width
  double spacing_across_m;
  bool is_u_long;

  Place place(const calc::SensorGrid& grid, std::size_t point) const {
    const glm::dvec3 offset_m = grid.position_m[point] - grid.origin_m;
    const double u_m = glm::dot(offset_m, grid.u) + grid.margin_m;
    const double v_m = glm::dot(offset_m, grid.v) + grid.margin_m;
    return is_u_long ? Place{u_m, v_m} : Place{v_m, u_m};
  }
};

Rectangle rectangle_of(const calc::SensorGrid& grid) {
  const double u_m = grid.columns * grid.spacing_u_m + 2.0 * grid.margin_m;
  const double v_m = grid.rows * grid.spacing_v_m + 2.0 * grid.margin_m;
  if (u_m >= v_m) return {u_m, v_m, grid.spacing_v_m, true};
  return {v_m, u_m, grid.spacing_u_m, false};
}

bool is_rectangle(const calc::SensorGrid& grid) {
  return grid.columns > 0 &&
         std::none_of(grid.dropped.begin(), grid.dropped.end(), [](const auto& dropped) {
           return dropped.reason == calc::DropReason::outside_area ||
                  dropped.reason == calc::DropReason::within_margin;
         });
}

double strip_m(const MaskOperation& operation, double width_m) {
  const bool is_narrow = width_m <= operation.up_to_width_m + kTolerance_m;
  return is_narrow ? operation.share * width_m : operation.metres;
}

bool is_within(double place_m, double strip_m, double side_m) {
  return place_m >= strip_m - kTolerance_m && place_m <= side_m - strip_m + kTolerance_m;
}

bool counts(const MaskOperation& operation, const Rectangle& rectangle, const Place& place) {
  const double strip = strip_m(operation, rectangle.width_m);
  switch (operation.step) {
    case MaskStep::inset:
      return is_within(place.along_m, strip, rectangle.length_m) &&
             is_within(place.across_m, strip, rectangle.width_m);
    case MaskStep::across:
      return is_within(place.across_m, strip, rectangle.width_m);
    case MaskStep::centre_line:
      break;
  }
  return std::abs(place.across_m - 0.5 * rectangle.width_m) <=
         0.5 * rectangle.spacing_across_m + kTolerance_m;
}

// Of a wide hall a line says nothing: it must be judged strip by strip.
bool is_too_wide(const MaskOperation& operation, const Rectangle& rectangle) {
  return operation.step == MaskStep::centre_line && operation.up_to_width_m > 0.0 &&
         rectangle.width_m > operation.up_to_width_m + kTolerance_m;
}

}  // namespace

MaskedPoints apply_mask(const Mask& mask, const calc::SensorGrid& grid) {
  MaskedPoints result;
  if (mask.operations.empty()) {
    result.points.resize(grid.position_m.size());
    std::iota(result.points.begin(), result.points.end(), std::size_t{0});
    return result;
  }
  if (!is_rectangle(grid)) {
    result.problem = fmt::format("mask '{}' needs a plane that is a rectangle", mask.id);
    return result;
  }
  const Rectangle rectangle = rectangle_of(grid);
  for (const MaskOperation& operation : mask.operations) {
    if (!is_too_wide(operation, rectangle)) continue;
    result.problem = fmt::format(
        "mask '{}' needs a plane at most {:.6g} m wide, this one is {:.6g} m: divide it into "
        "strips",
        mask.id, operation.up_to_width_m, rectangle.width_m);
    return result;
  }
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    const Place place = rectangle.place(grid, i);
    const bool is_in = std::all_of(
        mask.operations.begin(), mask.operations.end(),
        [&](const MaskOperation& operation) { return counts(operation, rectangle, place); });
    if (is_in) result.points.push_back(i);
  }
  if (result.points.empty()) {
    result.problem =
        fmt::format("mask '{}' leaves none of {} points", mask.id, grid.position_m.size());
  }
  return result;
}

}  // namespace rules
