#include "report/revision/point_places.h"

#include "report/revision/matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace report {
namespace {

std::vector<PlacedPoint> points_of(const PlanePart& plane) {
  std::vector<PlacedPoint> points;
  points.reserve(plane.points.size() + plane.grid.dropped.size());
  for (const PointRow& point : plane.points) {
    points.push_back({point.position_m, point.column, point.row, &point});
  }
  for (const calc::DroppedPoint& point : plane.grid.dropped) {
    points.push_back({point.position_m, point.column, point.row, nullptr});
  }
  return points;
}

using Box = std::array<std::int64_t, 3>;

// Of boxes of one size; of what no number of boxes can be made: one for all.
Box box_of(const glm::dvec3& position_m, double size_m) {
  Box box{};
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double kFarthest = 1e15;
    const double place = std::floor(position_m[axis] / size_m);
    box[static_cast<std::size_t>(axis)] =
        std::abs(place) < kFarthest ? static_cast<std::int64_t>(place) : 0;
  }
  return box;
}

// Finds points by boxes that are much larger than what two places may differ by.
class PlaceIndex {
 public:
  explicit PlaceIndex(const std::vector<PlacedPoint>& points) : points_(points) {
    for (std::size_t k = points.size(); k-- > 0;) {  // so that the first is at the end
      boxes_[box_of(points[k].position_m, kBox_m)].push_back(k);
    }
  }

  // The first that is left at this place, or points.size().
  std::size_t take(const glm::dvec3& position_m) {
    std::size_t found = points_.size();
    std::vector<std::size_t>* of_found = nullptr;
    for (int side = 0; side < 8; ++side) {
      const glm::dvec3 off{(side & 1) != 0 ? 1.0 : -1.0, (side & 2) != 0 ? 1.0 : -1.0,
                           (side & 4) != 0 ? 1.0 : -1.0};
      const auto box = boxes_.find(box_of(position_m + kSamePlace_m * off, kBox_m));
      if (box == boxes_.end()) continue;
      for (const std::size_t k : box->second) {
        if (k >= found || !is_same_place(points_[k].position_m, position_m)) continue;
        found = k;
        of_found = &box->second;
      }
    }
    if (of_found != nullptr) std::erase(*of_found, found);
    return found;
  }

 private:
  static constexpr double kBox_m = 0.001;

  const std::vector<PlacedPoint>& points_;
  std::map<Box, std::vector<std::size_t>> boxes_;
};

}  // namespace

PointPairs match_points(const PlanePart& before, const PlanePart& after) {
  const std::vector<PlacedPoint> was = points_of(before), is = points_of(after);
  PointPairs pairs;
  PlaceIndex index(was);
  std::vector<bool> is_taken(was.size(), false);
  for (const PlacedPoint& point : is) {
    const std::size_t k = index.take(point.position_m);
    if (k == was.size()) {
      pairs.added.push_back(point);
      continue;
    }
    is_taken[k] = true;
    pairs.both.emplace_back(was[k], point);
  }
  for (std::size_t k = 0; k < was.size(); ++k) {
    if (!is_taken[k]) pairs.gone.push_back(was[k]);
  }
  return pairs;
}

bool has_points_in_all_cells(const PlanePart& of, const PlanePart& in) {
  const calc::SensorGrid& grid = of.grid;
  const double half_u_m = 0.5 * grid.spacing_u_m, half_v_m = 0.5 * grid.spacing_v_m;
  const double reach_m =
      std::sqrt(half_u_m * half_u_m + half_v_m * half_v_m) * (1.0 + 1e-9) + kSamePlace_m;
  const auto is_within = [&](const glm::dvec3& off_m) {
    if (grid.route) return glm::length(off_m) <= reach_m;
    return std::abs(glm::dot(off_m, grid.u)) <= half_u_m + kSamePlace_m &&
           std::abs(glm::dot(off_m, grid.v)) <= half_v_m + kSamePlace_m;
  };
  std::map<Box, std::vector<glm::dvec3>> places_m;
  for (const PointRow& point : in.points) {
    places_m[box_of(point.position_m, reach_m)].push_back(point.position_m);
  }
  const auto has_one = [&](const glm::dvec3& place_m) {
    const Box middle = box_of(place_m, reach_m);
    for (int side = 0; side < 27; ++side) {
      const Box box{middle[0] + side % 3 - 1, middle[1] + side / 3 % 3 - 1,
                    middle[2] + side / 9 - 1};
      const auto found = places_m.find(box);
      if (found == places_m.end()) continue;
      for (const glm::dvec3& other_m : found->second) {
        if (is_within(other_m - place_m)) return true;
      }
    }
    return false;
  };
  return std::all_of(of.points.begin(), of.points.end(),
                     [&](const PointRow& point) { return has_one(point.position_m); });
}

double farthest_move_m(const PointPairs& pairs) {
  std::map<std::pair<int, int>, glm::dvec3> place_of_cell;
  for (const PlacedPoint& point : pairs.gone) {
    place_of_cell.emplace(std::pair(point.column, point.row), point.position_m);
  }
  double farthest_m = 0.0;
  for (const PlacedPoint& point : pairs.added) {
    const auto found = place_of_cell.find({point.column, point.row});
    if (found == place_of_cell.end()) continue;
    farthest_m = std::max(farthest_m, glm::length(point.position_m - found->second));
  }
  return farthest_m;
}

}  // namespace report
