#include "rules/catalogue/mask.h"

#include "calc/base/sentences.h"
#include "calc/scene/polygon.h"
#include "calc/scene/route_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rules {
namespace {

constexpr double kTolerance_m = 1e-9;  // a point on the edge of a strip counts

// Least ratio of the sides of a plane at which its long side shows the walking direction.
constexpr double kClearRatio = 2.0;

// The place of a point on a rectangle whose long sides run along `along`.
struct Place {
  double along_m, across_m;
};

struct Rectangle {
  double length_m, width_m;  // of the whole plane: along the way that people go, and across it
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
  const bool is_said = grid.travel != glm::dvec3(0.0);
  const bool is_along_u =
      is_said ? std::abs(glm::dot(grid.travel, grid.u)) >= std::abs(glm::dot(grid.travel, grid.v))
              : u_m >= v_m;
  if (is_along_u) return {u_m, v_m, grid.spacing_v_m, true};
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

bool counts_on_rectangle(const MaskOperation& operation, const Rectangle& rectangle,
                         const Place& place) {
  const double strip = strip_m(operation, rectangle.width_m);
  switch (operation.step) {
    case MaskStep::inset:
      return is_within(place.along_m, strip, rectangle.length_m) &&
             is_within(place.across_m, strip, rectangle.width_m);
    case MaskStep::across:
      return is_within(place.across_m, strip, rectangle.width_m);
    case MaskStep::walls:
    case MaskStep::border:
    case MaskStep::centre_line:
      break;
  }
  return std::abs(place.across_m - 0.5 * rectangle.width_m) <=
         0.5 * rectangle.spacing_across_m + kTolerance_m;
}

bool needs_rectangle(const MaskOperation& operation) {
  if (operation.step == MaskStep::walls) return false;
  return operation.step != MaskStep::inset || operation.up_to_width_m > 0.0;
}

bool is_off_walls(const MaskOperation& operation, const calc::SensorGrid& grid, std::size_t point) {
  const glm::dvec2 at(grid.position_m[point]);
  return grid.room_m.empty() ||
         calc::distance_to_boundary(grid.room_m, at) >= operation.metres - kTolerance_m;
}

// Returns whether the point counts. rectangle: of the plane, or null if it is not one.
bool counts(const MaskOperation& operation, const calc::SensorGrid& grid, std::size_t point,
            const Rectangle* rectangle) {
  if (operation.step == MaskStep::walls) return is_off_walls(operation, grid, point);
  if (rectangle == nullptr) {
    const glm::dvec3 offset_m = grid.position_m[point] - grid.origin_m;
    const glm::dvec2 at(glm::dot(offset_m, grid.u), glm::dot(offset_m, grid.v));
    return calc::distance_to_boundary(grid.outline_m, at) >= operation.metres - kTolerance_m;
  }
  return counts_on_rectangle(operation, *rectangle, rectangle->place(grid, point));
}

// Returns whether a hall is too wide for a line: it must then be judged strip by strip.
bool is_too_wide(const MaskOperation& operation, double width_m) {
  return operation.step == MaskStep::centre_line && operation.up_to_width_m > 0.0 &&
         width_m > operation.up_to_width_m + kTolerance_m;
}

// Returns whether the point of a route counts: strips run along its line, and an inset is also a
// strip at both ends.
bool counts_on_route(const MaskOperation& operation, const calc::RouteCells& cells,
                     const calc::SensorGrid& grid, std::size_t point) {
  const double width_m = grid.route->line.width_m;
  const double strip = strip_m(operation, width_m);
  const int column = grid.column[point], row = grid.row[point];
  const bool is_within_width = is_within(cells.offset_m(row) + 0.5 * width_m, strip, width_m);
  switch (operation.step) {
    case MaskStep::inset:
      return is_within_width && cells.from_begin_m(column, row) >= strip - kTolerance_m &&
             cells.from_end_m(column, row) >= strip - kTolerance_m;
    case MaskStep::across:
      return is_within_width;
    case MaskStep::walls:
      return is_off_walls(operation, grid, point);
    case MaskStep::border:
    case MaskStep::centre_line:
      break;
  }
  return 2 * row + 1 == grid.rows;
}

std::vector<std::size_t> points_on_route(const Mask& mask, const calc::SensorGrid& grid) {
  const calc::RouteCells cells = grid.route->cells(grid.rows);
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    const bool is_in = std::all_of(
        mask.operations.begin(), mask.operations.end(),
        [&](const MaskOperation& operation) { return counts_on_route(operation, cells, grid, i); });
    if (is_in) points.push_back(i);
  }
  return points;
}

std::vector<std::size_t> points_on_plane(const Mask& mask, const calc::SensorGrid& grid) {
  const Rectangle rectangle = rectangle_of(grid);
  const Rectangle* known = is_rectangle(grid) ? &rectangle : nullptr;
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    const bool is_in = std::all_of(
        mask.operations.begin(), mask.operations.end(),
        [&](const MaskOperation& operation) { return counts(operation, grid, i, known); });
    if (is_in) points.push_back(i);
  }
  return points;
}

calc::Message too_wide_words(const Mask& mask, const MaskOperation& operation, bool is_route,
                             double width_m) {
  return is_route
             ? calc::say<calc::Sentence::mask_too_wide_route>(mask.id, operation.up_to_width_m,
                                                              width_m)
             : calc::say<calc::Sentence::mask_too_wide>(mask.id, operation.up_to_width_m, width_m);
}

calc::Message problem_of(const Mask& mask, const MaskOperation& operation,
                         const calc::SensorGrid& grid) {
  if (operation.step == MaskStep::walls) {
    if (!grid.has_unknown_walls) return {};
    return calc::say<calc::Sentence::mask_without_walls>(mask.id);
  }
  if (grid.route) {
    const double width_m = grid.route->line.width_m;
    if (!is_too_wide(operation, width_m)) return {};
    return too_wide_words(mask, operation, true, width_m);
  }
  const bool has_outline = grid.columns > 0 && !grid.outline_m.empty();
  if (!is_rectangle(grid) && (needs_rectangle(operation) || !has_outline)) {
    return calc::say<calc::Sentence::mask_no_rectangle>(mask.id);
  }
  const Rectangle rectangle = rectangle_of(grid);
  if (is_too_wide(operation, rectangle.width_m)) {
    return too_wide_words(mask, operation, false, rectangle.width_m);
  }
  const bool has_way =
      operation.step == MaskStep::across || operation.step == MaskStep::centre_line;
  const bool is_clear =
      grid.travel != glm::dvec3(0.0) ||
      rectangle.length_m >= kClearRatio * rectangle.width_m * (1.0 - kTolerance_m);
  if (!has_way || is_clear) return {};
  return calc::say<calc::Sentence::mask_no_way>(mask.id, rectangle.length_m, rectangle.width_m);
}

}  // namespace

Mask mask_at(Mask mask, bool has_no_walls) {
  for (MaskOperation& operation : mask.operations) {
    if (operation.step != MaskStep::border) continue;
    operation.step = has_no_walls ? MaskStep::inset : MaskStep::walls;
  }
  return mask;
}

MaskedPoints apply_mask(const Mask& written, const calc::SensorGrid& grid) {
  const Mask mask = mask_at(written, grid.room_m.empty());
  MaskedPoints result;
  if (mask.operations.empty()) {
    result.points.resize(grid.position_m.size());
    std::iota(result.points.begin(), result.points.end(), std::size_t{0});
    return result;
  }
  for (const MaskOperation& operation : mask.operations) {
    result.problem = problem_of(mask, operation, grid);
    if (!result.problem.empty()) return result;
  }
  result.points = grid.route ? points_on_route(mask, grid) : points_on_plane(mask, grid);
  if (result.points.empty()) {
    result.problem = calc::say<calc::Sentence::mask_leaves_none>(mask.id, grid.position_m.size());
  }
  return result;
}

calc::Message mask_words(const Mask& mask, const glm::dvec3& travel) {
  using enum calc::Sentence;
  calc::Message words;
  bool is_across = false;
  for (const MaskOperation& operation : mask.operations) {
    const double metres = operation.metres, share = operation.share;
    const double narrow_m = operation.up_to_width_m;
    is_across = is_across || operation.step == MaskStep::across ||
                operation.step == MaskStep::centre_line || narrow_m > 0.0;
    switch (operation.step) {
      case MaskStep::centre_line:
        append(
            words,
            narrow_m > 0.0 ? calc::say<mask_middle_of_narrow>(narrow_m) : calc::say<mask_middle>(),
            ", ");
        break;
      case MaskStep::walls:
        append(words, calc::say<mask_off_walls>(metres), ", ");
        break;
      case MaskStep::border:
        append(words, calc::say<mask_off_border>(metres), ", ");
        break;
      case MaskStep::inset:
        append(words,
               narrow_m > 0.0 ? calc::say<mask_off_outline_share>(share, narrow_m, metres)
                              : calc::say<mask_off_outline>(metres),
               ", ");
        break;
      case MaskStep::across:
        append(words,
               narrow_m > 0.0 ? calc::say<mask_off_sides_share>(share, narrow_m, metres)
                              : calc::say<mask_off_sides>(metres),
               ", ");
        break;
    }
  }
  if (is_across && travel != glm::dvec3(0.0)) {
    append(words,
           calc::say<mask_people>(calc::Message::number(
               fmt::format("({:g} {:g} {:g})", travel.x, travel.y, travel.z))),
           ", ");
  }
  return words;
}

}  // namespace rules
