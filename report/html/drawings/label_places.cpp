#include "report/html/drawings/label_places.h"

#include "calc/scene/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace report {
namespace {

constexpr double kCell_mm = 6.0;

bool meets_line(const LabelBox& box, const glm::dvec2& from, const glm::dvec2& to) {
  double first = 0.0, last = 1.0;  // of the line, inside the box
  const glm::dvec2 way = to - from;
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0.0) {
      if (from[axis] <= box.low[axis] || from[axis] >= box.high[axis]) return false;
      continue;
    }
    const double a = (box.low[axis] - from[axis]) / way[axis],
                 b = (box.high[axis] - from[axis]) / way[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

// Whether two lines cross; lines that only touch may count either way.
bool cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const auto side = [](const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& p) {
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x) > 0.0;
  };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

// What lies beside the paper counts to the cells at its edge.
std::size_t cell_at(double mm, std::size_t cells_along) {
  return static_cast<std::size_t>(
      std::clamp(mm / kCell_mm, 0.0, static_cast<double>(cells_along - 1)));
}

LabelBox box_of_line(const glm::dvec2& from, const glm::dvec2& to) {
  return {glm::min(from, to), glm::max(from, to)};
}

glm::dvec2 middle_of(const FlatBox& box) { return 0.5 * (box.low + box.high); }

FlatBox label_extent(const std::vector<glm::dvec2>& outline) {
  FlatBox extent;
  for (const glm::dvec2& corner : outline) extent.add(corner);
  return extent;
}

// Of the area; of the extent where that has none, or where lines that cross leave so little that
// the centroid is anywhere.
glm::dvec2 centroid_of(const std::vector<glm::dvec2>& outline) {
  const glm::dvec2 origin = outline.front();
  glm::dvec2 sum(0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - origin, b = outline[(i + 1) % outline.size()] - origin;
    const double part = a.x * b.y - a.y * b.x;
    area += part;
    sum += part * (a + b);
  }
  const glm::dvec2 centroid = origin + sum / (3.0 * area);
  const FlatBox extent = label_extent(outline);
  return extent.contains(centroid) ? centroid : middle_of(extent);
}

// Places inside the outline, those near its middle first.
std::vector<glm::dvec2> places_inside(const std::vector<glm::dvec2>& outline) {
  constexpr double kMostPlaces = 40, kLeastStep_mm = 0.7;  // along an axis
  const FlatBox extent = label_extent(outline);
  const glm::dvec2 middle = centroid_of(outline);
  const glm::dvec2 step = glm::max(extent.size() / kMostPlaces, glm::dvec2(kLeastStep_mm));
  std::vector<glm::dvec2> places{middle};
  // Around the middle, so that steps are symmetric to it.
  const glm::dvec2 before = glm::floor((middle - extent.low) / step),
                   behind = glm::floor((extent.high - middle) / step);
  for (double y = -before.y; y <= behind.y; y += 1.0) {
    for (double x = -before.x; x <= behind.x; x += 1.0)
      places.push_back(middle + step * glm::dvec2(x, y));
  }
  const auto distance = [&](const glm::dvec2& p) { return glm::dot(p - middle, p - middle); };
  std::stable_sort(places.begin(), places.end(), [&](const glm::dvec2& a, const glm::dvec2& b) {
    return distance(a) < distance(b);
  });
  return places;
}

// Ways in all directions, the shortest first.
std::vector<glm::dvec2> ways_around() {
  constexpr double kReach_mm = 40.0, kStep_mm = 2.0;
  constexpr std::array kFirst{glm::dvec2(1.0, 0.0), glm::dvec2(0.9239, 0.3827),
                              glm::dvec2(0.7071, 0.7071), glm::dvec2(0.3827, 0.9239)};
  std::vector<glm::dvec2> ways;
  for (double reach = kStep_mm; reach <= kReach_mm; reach += kStep_mm) {
    for (const glm::dvec2& way : kFirst) {
      const glm::dvec2 along = reach * way, across(-along.y, along.x);
      ways.insert(ways.end(), {along, across, -along, -across});
    }
  }
  return ways;
}

}  // namespace

LabelPlaces::LabelPlaces(const FlatBox& paper) : paper_(paper) {
  constexpr double kMostCells = 200.0;  // along an axis
  const auto cells_along = [&](double length_mm) {
    return static_cast<std::size_t>(std::clamp(std::ceil(length_mm / kCell_mm), 1.0, kMostCells));
  };
  columns_ = cells_along(paper.size().x);
  rows_ = cells_along(paper.size().y);
  cells_.resize(columns_ * rows_);
}

template <class Visit>
bool LabelPlaces::visit_cells(const LabelBox& box, const Visit& visit) const {
  const glm::dvec2 low = box.low - paper_.low, high = box.high - paper_.low;
  const std::size_t last_row = cell_at(high.y, rows_), last_column = cell_at(high.x, columns_);
  for (std::size_t row = cell_at(low.y, rows_); row <= last_row; ++row) {
    for (std::size_t column = cell_at(low.x, columns_); column <= last_column; ++column) {
      if (!visit(row * columns_ + column)) return false;
    }
  }
  return true;
}

std::size_t LabelPlaces::take(const LabelBox& box) {
  boxes_.push_back(box);
  visit_cells(box, [&](std::size_t cell) {
    cells_[cell].boxes.push_back(boxes_.size() - 1);
    return true;
  });
  return boxes_.size() - 1;
}

void LabelPlaces::take_line(const glm::dvec2& from, const glm::dvec2& to) {
  lines_.push_back({from, to});
  const LabelBox box = box_of_line(from, to);
  const std::size_t last = cell_at(box.high.y - paper_.low.y, rows_);
  for (std::size_t row = cell_at(box.low.y - paper_.low.y, rows_); row <= last; ++row) {
    const LabelBox part = part_in_row({from, to}, row);
    const std::size_t end = cell_at(part.high.x - paper_.low.x, columns_);
    for (std::size_t i = cell_at(part.low.x - paper_.low.x, columns_); i <= end; ++i)
      cells_[row * columns_ + i].lines.push_back(lines_.size() - 1);
  }
}

// The box of a line has many more cells than those that it meets.
LabelBox LabelPlaces::part_in_row(const Line& line, std::size_t row) const {
  constexpr double kRounding_mm = 0.01;
  LabelBox part = box_of_line(line.from, line.to);
  const glm::dvec2 way = line.to - line.from;
  if (way.y == 0.0) return part;
  const double top_mm = paper_.low.y + kCell_mm * static_cast<double>(row) - kRounding_mm;
  const double bottom_mm = top_mm + kCell_mm + 2.0 * kRounding_mm;
  const double first = row == 0 ? part.low.y : std::max(part.low.y, top_mm);
  const double last = row + 1 == rows_ ? part.high.y : std::min(part.high.y, bottom_mm);
  const auto x_at = [&](double y) { return line.from.x + (y - line.from.y) / way.y * way.x; };
  const double low = std::min(x_at(first), x_at(last)), high = std::max(x_at(first), x_at(last));
  part.low.x = std::max(part.low.x, low - kRounding_mm);
  part.high.x = std::min(part.high.x, high + kRounding_mm);
  return part;
}

void LabelPlaces::take_outline(const std::vector<glm::dvec2>& outline) {
  outlines_.push_back(outline);
  for (std::size_t i = 0; i < outline.size(); ++i)
    take_line(outline[i], outline[(i + 1) % outline.size()]);
}

bool LabelPlaces::is_free(const LabelBox& box, std::size_t ignored) const {
  if (!paper_.contains(box.low) || !paper_.contains(box.high)) return false;
  return visit_cells(box, [&](std::size_t index) {
    const Cell& cell = cells_[index];
    return std::none_of(cell.boxes.begin(), cell.boxes.end(),
                        [&](std::size_t i) { return i != ignored && boxes_[i].meets(box); }) &&
           std::none_of(cell.lines.begin(), cell.lines.end(), [&](std::size_t i) {
             return meets_line(box, lines_[i].from, lines_[i].to);
           });
  });
}

bool LabelPlaces::is_crossed(const glm::dvec2& from, const glm::dvec2& to) const {
  return !visit_cells(box_of_line(from, to), [&](std::size_t index) {
    const Cell& cell = cells_[index];
    return std::none_of(cell.lines.begin(), cell.lines.end(), [&](std::size_t i) {
      return cross(from, to, lines_[i].from, lines_[i].to);
    });
  });
}

std::optional<LabelPlace> LabelPlaces::put_inside(const std::vector<glm::dvec2>& outline,
                                                  const std::vector<glm::dvec2>& sizes) {
  if (outline.size() < 3) return std::nullopt;
  const FlatBox extent = label_extent(outline);
  const std::vector<glm::dvec2> places = places_inside(outline);
  for (std::size_t form = 0; form < sizes.size(); ++form) {
    if (sizes[form].x > extent.size().x || sizes[form].y > extent.size().y) continue;
    for (const glm::dvec2& place : places) {
      const LabelBox box = box_around(place, sizes[form]);
      if (!is_free(box) || !calc::contains_point(outline, place)) continue;
      take(box);
      return LabelPlace{form, place};
    }
  }
  return std::nullopt;
}

bool LabelPlaces::is_leader_free(const Line& leader) const {
  return visit_cells(box_of_line(leader.from, leader.to), [&](std::size_t index) {
    const Cell& cell = cells_[index];
    return std::none_of(cell.boxes.begin(), cell.boxes.end(), [&](std::size_t i) {
      const LabelBox& box = boxes_[i];
      // A sign may stand where the leader ends.
      const bool is_end = leader.to.x > box.low.x && leader.to.x < box.high.x &&
                          leader.to.y > box.low.y && leader.to.y < box.high.y;
      return !is_end && meets_line(box, leader.from, leader.to);
    });
  });
}

bool LabelPlaces::is_in_outline(const glm::dvec2& place) const {
  return std::any_of(outlines_.begin(), outlines_.end(), [&](const std::vector<glm::dvec2>& one) {
    return calc::contains_point(one, place);
  });
}

std::optional<LeaderPlace> LabelPlaces::put_beside(const std::vector<glm::dvec2>& outline,
                                                   const glm::dvec2& size) {
  const std::vector<glm::dvec2> inside = places_inside(outline);
  const auto anchor = std::find_if(inside.begin(), inside.end(), [&](const glm::dvec2& place) {
    return calc::contains_point(outline, place);
  });
  const glm::dvec2 to = anchor == inside.end() ? inside.front() : *anchor;
  for (const bool is_in_rooms : {false, true}) {
    for (const glm::dvec2& way : ways_around()) {
      const LabelBox box = box_around(to + way, size);
      const Line leader{glm::clamp(to, box.low, box.high), to};
      if (!is_free(box) || !is_leader_free(leader)) continue;
      if (!is_in_rooms && is_in_outline(to + way)) continue;
      take(box);
      take_line(leader.from, leader.to);
      return LeaderPlace{to + way, leader.from, leader.to};
    }
  }
  return std::nullopt;
}

}  // namespace report
