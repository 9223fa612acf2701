#include "calc/scene/grid_coverage.h"

#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {
namespace {

constexpr double kCoverageTie = 1.0e-9;
constexpr double kShare =
    0.05;  // of the area; a missed part above it matters however large cells are

bool counts(const PlanarArea& area, glm::dvec2 point) { return !reason_to_drop(area, point); }

class CoverageMap {
 public:
  CoverageMap(const PlanarArea& area, const GridCells& cells) : area_(area), cells_(cells) {
    const double most = area.outline_m.size() > 100 ? 100.0 : 240.0;  // O(corners) each
    const auto samples = [&](int count) {
      return static_cast<int>(std::clamp(8.0 * count, 48.0, most));
    };
    width_ = samples(cells.columns);
    height_ = samples(cells.rows);
    step_m_ = cells.cell_m * glm::dvec2(cells.columns, cells.rows) / glm::dvec2(width_, height_);
    mark_centres();
    mark_samples();
  }

  std::optional<MissedPart> largest() {
    const double sample_m2 = step_m_.x * step_m_.y;
    MissedPart largest{0.0, {}};
    for (std::size_t i = 0; i < missed_.size(); ++i) {
      if (missed_[i] == 0) continue;
      const double part_m2 = static_cast<double>(take_part(i)) * sample_m2;
      if (part_m2 > largest.area_m2) largest = {part_m2, place(i)};
    }
    const double cell_m2 = cells_.cell_m.x * cells_.cell_m.y;
    const double whole_m2 = static_cast<double>(counted_) * sample_m2;
    if (largest.area_m2 <= std::min(cell_m2, kShare * whole_m2)) return std::nullopt;
    return largest;
  }

 private:
  glm::dvec2 centre(int column, int row) const {
    return cells_.lower_m + glm::dvec2(column + 0.5, row + 0.5) * cells_.cell_m;
  }

  glm::dvec2 place(std::size_t sample) const {
    const auto width = static_cast<std::size_t>(width_);
    const glm::dvec2 at(static_cast<double>(sample % width), static_cast<double>(sample / width));
    return cells_.lower_m + (at + 0.5) * step_m_;
  }

  std::size_t cell_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_.columns) +
           static_cast<std::size_t>(column);
  }

  void mark_centres() {
    for (int row = 0; row < cells_.rows; ++row) {
      for (int column = 0; column < cells_.columns; ++column) {
        has_point_.push_back(counts(area_, centre(column, row)) ? 1 : 0);
      }
    }
  }

  void mark_samples() {
    const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    missed_.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec2 at = place(i);
      if (!counts(area_, at)) continue;
      ++counted_;
      missed_[i] = is_near_point(at) ? 0 : 1;
    }
  }

  bool is_near_point(glm::dvec2 at) const {
    const glm::dvec2 in_cells = (at - cells_.lower_m) / cells_.cell_m - 0.5;
    const auto first = [](double x) {
      return std::max(0, static_cast<int>(std::ceil(x - 1.0 - kCoverageTie)));
    };
    const auto last = [](double x, int end) {
      return std::min(end - 1, static_cast<int>(std::floor(x + 1.0 + kCoverageTie)));
    };
    for (int row = first(in_cells.y); row <= last(in_cells.y, cells_.rows); ++row) {
      for (int column = first(in_cells.x); column <= last(in_cells.x, cells_.columns); ++column) {
        if (has_point_[cell_index(column, row)] != 0 && is_way(at, centre(column, row)))
          return true;
      }
    }
    return false;
  }

  // Not through a partition.
  bool is_way(glm::dvec2 from, glm::dvec2 to) const {
    for (const double t : {0.25, 0.5, 0.75}) {
      if (!counts(area_, from + t * (to - from))) return false;
    }
    return true;
  }

  // Number of samples of a part, which is marked as seen.
  std::size_t take_part(std::size_t first) {
    std::vector<std::size_t> open{first};
    missed_[first] = 0;
    std::size_t count = 0;
    const auto visit = [&](std::size_t sample) {
      if (missed_[sample] == 0) return;
      missed_[sample] = 0;
      open.push_back(sample);
    };
    const auto width = static_cast<std::size_t>(width_);
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      ++count;
      if (at % width > 0) visit(at - 1);
      if (at % width + 1 < width) visit(at + 1);
      if (at >= width) visit(at - width);
      if (at + width < missed_.size()) visit(at + width);
    }
    return count;
  }

  const PlanarArea& area_;
  const GridCells& cells_;
  int width_ = 0, height_ = 0;
  glm::dvec2 step_m_{0.0};
  std::vector<std::uint8_t> has_point_, missed_;  // per cell, per sample
  std::size_t counted_ = 0;
};

// Every cell centre counts.
bool is_whole_rectangle(const PlanarArea& area, const GridCells& cells) {
  if (!area.holes_m.empty()) return false;
  const glm::dvec2 side_m =
      cells.cell_m * glm::dvec2(cells.columns, cells.rows) + 2.0 * area.margin_m;
  return std::abs(signed_area(area.outline_m)) >= side_m.x * side_m.y * (1.0 - kCoverageTie);
}

}  // namespace

std::optional<DropReason> reason_to_drop(const PlanarArea& area, glm::dvec2 point) {
  if (!contains_point(area.outline_m, point)) return DropReason::outside_area;
  for (const std::vector<glm::dvec2>& hole : area.holes_m) {
    if (contains_point(hole, point)) return DropReason::outside_area;
  }
  // In a rectangle the grid starts inside the margin, so that this drops nothing.
  if (distance_to_boundary(area.outline_m, point) < area.margin_m * (1.0 - kCoverageTie)) {
    return DropReason::within_margin;
  }
  return std::nullopt;
}

std::optional<MissedPart> missed_part(const PlanarArea& area, const GridCells& cells) {
  if (is_whole_rectangle(area, cells)) return std::nullopt;
  return CoverageMap(area, cells).largest();
}

}  // namespace calc
