#include "rules/applicability/masked_grid.h"

#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace rules {
namespace {

constexpr double kTie = 1.0e-9;  // relative
// Places in a cell, along each side of it. Even, so that none lies on a cell's middle line.
constexpr int kParts = 16;
constexpr double kMostPlaces = 8.0e6;

// Returns the cells of a grid, each divided into parts; for a route only across it, because its
// stations differ.
calc::SensorGrid divided(const calc::SensorGrid& grid, const std::vector<std::size_t>& points) {
  calc::SensorGrid fine = grid;
  const int parts_u = grid.route ? 1 : kParts;
  fine.columns = grid.columns * parts_u;
  fine.rows = grid.rows * kParts;
  fine.spacing_u_m = grid.spacing_u_m / parts_u;
  fine.spacing_v_m = grid.spacing_v_m / kParts;
  fine.position_m.clear();
  fine.column.clear();
  fine.row.clear();
  std::optional<calc::RouteCells> cells;
  if (grid.route) cells.emplace(grid.route->cells(fine.rows));
  for (const std::size_t i : points) {
    for (int a = 0; a < parts_u; ++a) {
      for (int b = 0; b < kParts; ++b) {
        const int column = grid.column[i] * parts_u + a, row = grid.row[i] * kParts + b;
        glm::dvec2 flat((column + 0.5) * fine.spacing_u_m, (row + 0.5) * fine.spacing_v_m);
        if (!grid.route && !calc::contains_point(grid.outline_m, flat)) continue;
        fine.position_m.push_back(cells ? cells->centre_m(column, row)
                                        : grid.origin_m + flat.x * grid.u + flat.y * grid.v);
        fine.column.push_back(column);
        fine.row.push_back(row);
      }
    }
  }
  return fine;
}

// Cells by column and row.
class CellSet {
 public:
  CellSet(int columns, int rows)
      : columns_(columns), rows_(rows), has_(static_cast<std::size_t>(columns) * rows, 0) {}

  void add(int column, int row) { has_[at(column, row)] = 1; }
  bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ && has_[at(column, row)];
  }

 private:
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int columns_, rows_;
  std::vector<char> has_;
};

// Returns the cells whose points count, or would count without a body there.
CellSet counted_cells(const std::vector<std::size_t>& points, const calc::SensorGrid& grid) {
  CellSet cells(grid.columns, grid.rows);
  for (const std::size_t i : points) cells.add(grid.column[i], grid.row[i]);
  for (const calc::DroppedPoint& dropped : grid.dropped) {
    if (dropped.reason == calc::DropReason::outside_area) continue;
    if (dropped.reason == calc::DropReason::within_margin) continue;
    cells.add(dropped.column, dropped.row);
  }
  return cells;
}

// Returns the required spacing along both sides, at most.
glm::dvec2 asked_spacing_m(const RuleGrid& asked, double u_m, double v_m) {
  if (const auto* spacing = std::get_if<calc::GridBySpacing>(&*asked.rule)) {
    const glm::dvec2 long_and_short(spacing->along_u_m, spacing->along_v_m);
    return u_m >= v_m ? long_and_short : glm::dvec2(long_and_short.y, long_and_short.x);
  }
  const calc::GridCounts counts = asked_counts(asked, u_m, v_m);
  return {u_m / counts.columns, v_m / counts.rows};
}

// Returns the greatest distance of a counted place from the next point: half of the required
// spacing, as in a grid on the counted area; or in the next cell by a quarter of it, as in a grid
// on a larger area.
glm::dvec2 farthest_m(const glm::dvec2& asked_m, const glm::dvec2& own_m) {
  return glm::max(0.5 * asked_m, 0.5 * own_m + 0.25 * asked_m);
}

// Finds how far a counted place is from the nearest counted cell's centre, along the worse side.
class Nearest {
 public:
  Nearest(const CellSet& cells, const calc::SensorGrid& grid, glm::dvec2 most_m)
      : cells_(cells), spacing_m_(grid.spacing_u_m, grid.spacing_v_m), most_m_(most_m) {}

  // Empty: near enough along both sides.
  std::optional<MaskGap> gap(const glm::dvec2& flat, int column, int row) const {
    MaskGap best{std::numeric_limits<double>::infinity(), std::max(most_m_.x, most_m_.y)};
    // In rings about the place's own cell; `sure_m`: no cell farther out is nearer.
    for (int reach = 0; reach <= kFarthest; ++reach) {
      for (int c = column - reach; c <= column + reach; ++c) {
        for (int r = row - reach; r <= row + reach; ++r) {
          if (std::max(std::abs(c - column), std::abs(r - row)) != reach || !cells_.has(c, r)) {
            continue;
          }
          const glm::dvec2 off_m = glm::abs(flat - spacing_m_ * glm::dvec2(c + 0.5, r + 0.5));
          const glm::dvec2 share = off_m / most_m_;
          if (share.x <= 1.0 + kTie && share.y <= 1.0 + kTie) return std::nullopt;
          const MaskGap here =
              share.x > share.y ? MaskGap{off_m.x, most_m_.x} : MaskGap{off_m.y, most_m_.y};
          if (here.to_point_m < best.to_point_m) best = here;
        }
      }
      const double sure_m = (reach - 0.5) * std::min(spacing_m_.x, spacing_m_.y);
      const bool is_near_seen = sure_m > std::max(most_m_.x, most_m_.y);
      if (is_near_seen && std::isfinite(best.to_point_m)) return best;
    }
    best.to_point_m = std::min(best.to_point_m, kFarthest * std::min(spacing_m_.x, spacing_m_.y));
    return best;
  }

 private:
  static constexpr int kFarthest = 64;

  const CellSet& cells_;
  glm::dvec2 spacing_m_, most_m_;
};

bool is_line(const Mask& mask) {
  return std::any_of(mask.operations.begin(), mask.operations.end(),
                     [](const auto& operation) { return operation.step == MaskStep::centre_line; });
}

}  // namespace

calc::GridCounts asked_counts(const RuleGrid& grid, double u_m, double v_m) {
  const bool is_u_long = u_m >= v_m;
  const auto turned = [&](int along, int across) {
    return is_u_long ? calc::GridCounts{along, across} : calc::GridCounts{across, along};
  };
  if (const auto* formula = std::get_if<calc::GridByRule>(&*grid.rule)) {
    return calc::grid_counts(*formula, u_m, v_m);
  }
  if (const auto* count = std::get_if<calc::GridByCount>(&*grid.rule)) {
    return turned(count->columns, count->rows);
  }
  const auto& spacing = std::get<calc::GridBySpacing>(*grid.rule);
  const auto cells = [](double side_m, double spacing_m, int least) {
    return std::max(least, static_cast<int>(std::ceil(side_m / spacing_m * (1.0 - kTie))));
  };
  return turned(cells(std::max(u_m, v_m), spacing.along_u_m, grid.least.columns),
                cells(std::min(u_m, v_m), spacing.along_v_m, grid.least.rows));
}

std::optional<CellsLeft> cells_left(const Mask& mask, const calc::SensorGrid& grid) {
  if (grid.route) return std::nullopt;
  const MaskedPoints left = apply_mask(mask, grid);
  if (!left.problem.empty() || left.points.empty()) return std::nullopt;
  if (left.points.size() == grid.position_m.size()) return std::nullopt;
  const auto cells = [&](const std::vector<int>& of) {
    const auto [least, most] =
        std::minmax_element(left.points.begin(), left.points.end(),
                            [&](std::size_t a, std::size_t b) { return of[a] < of[b]; });
    return of[*most] - of[*least] + 1;
  };
  const int columns = cells(grid.column), rows = cells(grid.row);
  return CellsLeft{columns, rows, columns * grid.spacing_u_m, rows * grid.spacing_v_m};
}

std::optional<MaskGap> mask_gap(const Mask& mask, const calc::SensorGrid& grid,
                                const RuleGrid& asked) {
  if (mask.operations.empty() || is_line(mask)) return std::nullopt;
  const MaskedPoints left = apply_mask(mask, grid);
  if (!left.problem.empty()) return std::nullopt;
  std::vector<std::size_t> taken;  // whose cells may reach out of what the mask takes
  for (std::size_t i = 0, k = 0; i < grid.position_m.size(); ++i) {
    const bool counts = k < left.points.size() && left.points[k] == i;
    if (counts) {
      ++k;
    } else {
      taken.push_back(i);
    }
  }
  if (static_cast<double>(taken.size()) * kParts * kParts > kMostPlaces) return std::nullopt;
  const calc::SensorGrid fine = divided(grid, taken);
  const MaskedPoints places = apply_mask(mask, fine);
  if (!places.problem.empty()) return std::nullopt;
  const double u_m = grid.columns * grid.spacing_u_m, v_m = grid.rows * grid.spacing_v_m;
  const CellSet cells = counted_cells(left.points, grid);
  glm::dvec2 most_m =
      farthest_m(asked_spacing_m(asked, u_m, v_m), {grid.spacing_u_m, grid.spacing_v_m});
  // Along a route its stations are what they are.
  if (grid.route) most_m.x = std::max(most_m.x, grid.spacing_u_m);
  const Nearest nearest(cells, grid, most_m);
  const int parts_u = fine.columns / grid.columns;
  std::optional<MaskGap> widest;
  for (const std::size_t i : places.points) {
    const int column = fine.column[i] / parts_u, row = fine.row[i] / kParts;
    if (cells.has(column, row)) continue;
    const glm::dvec2 flat((fine.column[i] + 0.5) * fine.spacing_u_m,
                          (fine.row[i] + 0.5) * fine.spacing_v_m);
    const std::optional<MaskGap> gap = nearest.gap(flat, column, row);
    if (gap && (!widest || gap->to_point_m > widest->to_point_m)) widest = gap;
  }
  return widest;
}

}  // namespace rules
