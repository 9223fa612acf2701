#include "report/tools/compare/compare_pairs.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace cli {
namespace {

std::string where(const TableRow& row) {
  std::string text = row.line > 0 ? fmt::format("line {} of B", row.line) : "B";
  if (row.plane) text += fmt::format(", plane '{}'", *row.plane);
  if (row.position_m) {
    text += fmt::format(", ({:.6g}, {:.6g}, {:.6g}) m", row.position_m->x, row.position_m->y,
                        row.position_m->z);
  } else if (row.cell) {
    text += fmt::format(", column {}, row {}", row.cell->x, row.cell->y);
  }
  return text;
}

}  // namespace

PointPairs::PointPairs(std::vector<report::ComparedPlane>& planes,
                       const std::map<std::string, std::string>& quantity, double distance_m)
    : planes_(planes), quantity_(quantity), distance_m_(distance_m) {
  for (const report::ComparedPlane& plane : planes) has_b_.emplace_back(plane.points.size(), false);
}

bool PointPairs::is_there(const TableRow& row, const report::ComparedPoint& point) const {
  if (row.position_m) return glm::distance(*row.position_m, point.position_m) <= distance_m_;
  return point.column == row.cell->x && point.row == row.cell->y;
}

std::string PointPairs::place(const TableRow& row) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  std::size_t planes = 0, at_plane = 0, at_point = 0;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    if (row.plane && *row.plane != planes_[p].id) continue;
    if (!row.quantity.empty() && row.quantity != quantity_.at(planes_[p].id)) continue;
    const auto& points = planes_[p].points;
    double nearest = kNowhere;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_there(row, points[i])) continue;
      const double d = row.position_m ? glm::distance(*row.position_m, points[i].position_m) : 0.0;
      if (d >= nearest) continue;
      if (nearest == kNowhere) ++planes;
      nearest = d;
      at_plane = p;
      at_point = i;
    }
  }
  if (planes == 0) {
    if (++strangers_ == 1) first_stranger_ = where(row);
    return "";
  }
  if (planes > 1) {
    return where(row) +
           fmt::format(
               ": the table has points of {} planes: a column 'plane' or --plane ID is needed",
               planes);
  }
  if (has_b_[at_plane][at_point]) {
    return where(row) +
           ": this point was given before; give --distance a smaller value if "
           "these are different points";
  }
  has_b_[at_plane][at_point] = true;
  planes_[at_plane].points[at_point].b = row.value;
  return "";
}

std::vector<std::string> PointPairs::drop_unpaired(std::size_t rows) {
  std::vector<std::string> lacks;
  if (strangers_ > 0) {
    lacks.push_back(fmt::format("{} of the {} values of B have no point in A, the first is {}",
                                strangers_, rows, first_stranger_));
  }
  std::vector<report::ComparedPlane> kept_planes;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    report::ComparedPlane& plane = planes_[p];
    std::vector<report::ComparedPoint> kept;
    for (std::size_t i = 0; i < plane.points.size(); ++i) {
      if (has_b_[p][i]) kept.push_back(plane.points[i]);
    }
    if (kept.size() < plane.points.size()) {
      lacks.push_back(fmt::format("{} of the {} points of plane '{}' have no value in B",
                                  plane.points.size() - kept.size(), plane.points.size(),
                                  plane.id));
    }
    plane.points = std::move(kept);
    if (!plane.points.empty()) kept_planes.push_back(std::move(plane));
  }
  planes_ = std::move(kept_planes);
  has_b_.clear();
  return lacks;
}

}  // namespace cli
