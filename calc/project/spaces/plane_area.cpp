#include "calc/project/spaces/plane_area.h"

#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>

namespace calc {
namespace {

glm::dvec3 unit_normal_of(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return glm::normalize(sum);
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

double outline_size(const PlanarArea& area) {
  double size = 0.0;
  for (const glm::dvec2& corner : area.outline_m) {
    size = std::max(size, glm::distance(corner, area.outline_m[0]));
  }
  return size;
}

}  // namespace

PlanarArea rectangle_area(const Rectangle& rectangle) {
  PlanarArea area;
  const double width = glm::length(rectangle.u_m), height = glm::length(rectangle.v_m);
  area.origin_m = rectangle.origin_m;
  area.u = rectangle.u_m / width;
  area.v = glm::normalize(rectangle.v_m - glm::dot(rectangle.v_m, area.u) * area.u);
  area.outline_m = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  return area;
}

glm::dvec2 long_axis(const std::vector<glm::dvec2>& outline) {
  constexpr double kTie = 1.0e-9;
  const std::size_t n = outline.size();
  glm::dvec2 longest(0.0);
  for (std::size_t i = 0; i < n; ++i) {
    glm::dvec2 side = outline[(i + 1) % n] - outline[i];
    const glm::dvec2 along = glm::normalize(side);
    for (std::size_t k = 1; k < n; ++k) {
      const glm::dvec2 next = outline[(i + k + 1) % n] - outline[(i + k) % n];
      if (std::abs(cross(along, next)) > kTie * glm::length(next) || glm::dot(along, next) < 0.0) {
        break;
      }
      side += next;
    }
    if (glm::length(side) > glm::length(longest) * (1.0 + kTie)) longest = side;
  }
  glm::dvec2 axis = glm::normalize(longest);
  while (!(axis.x > 0.0 && std::abs(axis.y) <= axis.x * (1.0 + kTie))) axis = {-axis.y, axis.x};
  if (std::abs(axis.y) < kTie) axis = {1.0, 0.0};
  return axis;
}

namespace {

// Diameter of the largest circle in the outline, up to 5 mm; or some circle's of enough_m. Squares
// are quartered, always the one that may hold the centre of the largest.
double largest_circle_m(const std::vector<glm::dvec2>& outline, double enough_m) {
  struct Square {
    glm::dvec2 middle;
    double half_m, here_m, most_m;
    bool operator<(const Square& other) const { return most_m < other.most_m; }
  };
  constexpr double kFine_m = 2.5e-3, kDiagonal = 1.4142135623730951;
  double found_m = 0.0;
  std::priority_queue<Square> squares;
  const auto add = [&](const glm::dvec2& middle, double half_m) {
    const double distance_m = distance_to_boundary(outline, middle);
    const double here_m = contains_point(outline, middle) ? distance_m : -distance_m;
    found_m = std::max(found_m, here_m);
    squares.push({middle, half_m, here_m, here_m + half_m * kDiagonal});
  };
  glm::dvec2 low = outline[0], high = outline[0];
  for (const glm::dvec2& corner : outline) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  add(0.5 * (low + high), 0.5 * std::max(high.x - low.x, high.y - low.y));
  while (2.0 * found_m < enough_m && squares.top().most_m > found_m + kFine_m) {
    const Square square = squares.top();
    squares.pop();
    const double half_m = 0.5 * square.half_m;
    for (const glm::dvec2& way :
         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)}) {
      add(square.middle + half_m * way, half_m);
    }
  }
  return 2.0 * found_m;
}

}  // namespace

double width_up_to(const std::vector<glm::dvec2>& outline, double most_m) {
  const glm::dvec2 along = long_axis(outline), across(-along.y, along.x);
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const glm::dvec2& corner : outline) {
    const glm::dvec2 place(glm::dot(corner, along), glm::dot(corner, across));
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  const glm::dvec2 side_m = high - low;
  const double width_m = std::min({side_m.x, side_m.y, most_m});
  constexpr double kSame = 1.0e-9, kSame_m = 6.0e-3;  // as fine as circles are
  const bool is_rectangle = std::abs(signed_area(outline)) >= side_m.x * side_m.y * (1.0 - kSame);
  if (is_rectangle) return width_m;
  const double circle_m = largest_circle_m(outline, width_m);
  return circle_m < width_m - kSame_m ? circle_m : width_m;
}

PlanarArea horizontal_area(const RoomPlan& room, double height_m, bool faces_up) {
  PlanarArea area;
  area.origin_m = room.origin_m + glm::dvec3(0, 0, height_m);
  area.outline_m = room.outline();
  const glm::dvec2 axis = long_axis(area.outline_m);
  area.u = glm::dvec3(axis, 0.0);
  area.v = glm::dvec3(-axis.y, axis.x, 0.0);
  for (glm::dvec2& corner : area.outline_m) corner = {glm::dot(corner, axis), cross(axis, corner)};
  if (faces_up) return area;
  area.v = -area.v;
  for (glm::dvec2& corner : area.outline_m) corner.y = -corner.y;
  std::reverse(area.outline_m.begin(), area.outline_m.end());
  return area;
}

std::optional<PlanarArea> polygon_area(const std::vector<glm::dvec3>& corners) {
  if (!triangulate_polygon(corners)) return std::nullopt;
  PlanarArea area;
  const glm::dvec3 normal = unit_normal_of(corners);
  const glm::dvec3 side = corners[1] - corners[0];
  area.origin_m = corners[0];
  area.u = glm::normalize(side - glm::dot(side, normal) * normal);
  area.v = glm::cross(normal, area.u);
  const auto set_outline = [&] {
    area.outline_m.clear();
    for (const glm::dvec3& corner : corners) {
      area.outline_m.push_back(area_coordinates(area, corner));
    }
  };
  set_outline();
  constexpr double kTie = 1.0e-9;
  if (const glm::dvec2 axis = long_axis(area.outline_m); std::abs(axis.y) > kTie) {
    area.u = glm::normalize(axis.x * area.u + axis.y * area.v);
    area.v = glm::cross(normal, area.u);
    set_outline();
  }
  return area;
}

glm::dvec2 area_coordinates(const PlanarArea& area, const glm::dvec3& point) {
  const glm::dvec3 offset = point - area.origin_m;
  return {glm::dot(offset, area.u), glm::dot(offset, area.v)};
}

bool lies_in_area(const PlanarArea& area, const glm::dvec3& point) {
  const double distance = std::abs(glm::dot(point - area.origin_m, area.normal()));
  return distance <= kPlanarTolerance * outline_size(area) &&
         contains_point(area.outline_m, area_coordinates(area, point));
}

}  // namespace calc
