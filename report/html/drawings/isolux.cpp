#include "report/html/drawings/isolux.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

namespace report {
namespace {

// The side between two neighbouring nodes: from (column, row) to the right or upwards.
struct Side {
  int column = 0, row = 0;
  bool is_upright = false;
  auto operator<=>(const Side&) const = default;
};

// Nodes are the cells' centres and, around those of a grid, the edge of the outermost cells, where
// the value is that of the cell.
class Squares {
 public:
  Squares(const PlanePart& plane, double level)
      : grid_(plane.grid),
        level_(level),
        edge_(plane.grid.route ? 0 : 1),
        columns_(plane.grid.columns + 2 * edge_),
        rows_(plane.grid.rows + 2 * edge_),
        value_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone) {
    for (const PointRow& point : plane.points)
      value_[index(point.column + edge_, point.row + edge_)] = point.measured.value;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        value_[index(column, row)] = at(std::clamp(column, edge_, columns_ - 1 - edge_),
                                        std::clamp(row, edge_, rows_ - 1 - edge_));
      }
    }
    if (grid_.route) cells_of_route_.emplace(grid_.route->cells(grid_.rows));
  }

  std::vector<IsoluxLine> lines() {
    for (int row = 0; row + 1 < rows_; ++row) {
      for (int column = 0; column + 1 < columns_; ++column) cross(column, row);
    }
    return chained();
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  double at(int column, int row) const { return value_[index(column, row)]; }

  // From grid.origin_m along u and v.
  glm::dvec2 node_m(int column, int row) const {
    if (cells_of_route_)
      return glm::dvec2(cells_of_route_->centre_m(column, row)) - glm::dvec2(grid_.origin_m);
    const auto along = [this](int node, int cells, double spacing_m) {
      return std::clamp(node - edge_ + 0.5, 0.0, static_cast<double>(cells)) * spacing_m;
    };
    return {along(column, grid_.columns, grid_.spacing_u_m),
            along(row, grid_.rows, grid_.spacing_v_m)};
  }

  // Where the level lies on a side whose ends are on different sides of it.
  glm::dvec2 place(const Side& side) const {
    const int dx = side.is_upright ? 0 : 1, dy = side.is_upright ? 1 : 0;
    const double from = at(side.column, side.row), to = at(side.column + dx, side.row + dy);
    const double part = (level_ - from) / (to - from);
    const glm::dvec2 start_m = node_m(side.column, side.row);
    return start_m + part * (node_m(side.column + dx, side.row + dy) - start_m);
  }

  void join(const Side& a, const Side& b) {
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
  }

  // The square whose lower left corner is that node.
  void cross(int column, int row) {
    const std::array corner{at(column, row), at(column + 1, row), at(column + 1, row + 1),
                            at(column, row + 1)};
    double sum = 0.0;
    unsigned above = 0;
    for (std::size_t i = 0; i < corner.size(); ++i) {
      if (std::isnan(corner[i])) return;
      sum += corner[i];
      if (corner[i] >= level_) above |= 1U << i;
    }
    const Side bottom{column, row, false}, right{column + 1, row, true},
        top{column, row + 1, false}, left{column, row, true};
    switch (above) {
      case 1:
      case 14:
        return join(left, bottom);
      case 2:
      case 13:
        return join(bottom, right);
      case 4:
      case 11:
        return join(right, top);
      case 8:
      case 7:
        return join(top, left);
      case 3:
      case 12:
        return join(left, right);
      case 6:
      case 9:
        return join(bottom, top);
      case 5:
      case 10: {
        // Two opposite corners are above: they are one region if the middle is above, too.
        const bool is_middle_above = sum / 4.0 >= level_;
        if (is_middle_above == (above == 5)) {
          join(left, top);
          join(bottom, right);
        } else {
          join(left, bottom);
          join(right, top);
        }
        return;
      }
      default:
        return;  // all on one side
    }
  }

  // A side has one or two neighbours: one for each square beside it that the line enters.
  std::optional<Side> take_neighbour(const Side& side) {
    std::vector<Side>& list = neighbours_[side];
    if (list.empty()) return std::nullopt;
    const Side next = list.back();
    list.pop_back();
    std::vector<Side>& back = neighbours_[next];
    back.erase(std::find(back.begin(), back.end(), side));
    return next;
  }

  IsoluxLine follow(const Side& start) {
    IsoluxLine line;
    line.points_m.push_back(place(start));
    Side last = start;
    for (std::optional<Side> next = take_neighbour(start); next; next = take_neighbour(last)) {
      last = *next;
      line.points_m.push_back(place(last));
    }
    line.is_closed = last == start;
    return line;
  }

  // Open lines from their ends first; what is left are rings.
  std::vector<IsoluxLine> chained() {
    std::vector<IsoluxLine> lines;
    for (const std::size_t wanted : {std::size_t{1}, std::size_t{2}}) {
      for (auto& [side, list] : neighbours_) {
        if (list.size() == wanted) lines.push_back(follow(side));
      }
    }
    return lines;
  }

  const calc::SensorGrid& grid_;
  double level_;
  int edge_, columns_, rows_;  // nodes beyond the centres on each side; nodes of all
  std::vector<double> value_;  // NaN: no point
  std::optional<calc::RouteCells> cells_of_route_;
  std::map<Side, std::vector<Side>> neighbours_;
};

}  // namespace

std::vector<IsoluxLine> isolux_lines(const PlanePart& plane, double level) {
  return Squares(plane, level).lines();
}

std::vector<IsoluxLevel> isolux_levels(const PlanePart& plane, const ColourScale& scale,
                                       const std::vector<PlanLimit>& limits, int most) {
  constexpr double kSame = 1e-9;
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const PointRow& point : plane.points) {
    low = std::min(low, point.measured.value);
    high = std::max(high, point.measured.value);
  }
  std::vector<IsoluxLevel> levels;
  for (const PlanLimit& limit : limits) {
    const bool is_known = std::any_of(levels.begin(), levels.end(), [&](const IsoluxLevel& known) {
      return std::abs(known.value - limit.limit) <= kSame * limit.limit;
    });
    if (!is_known && limit.limit > low && limit.limit < high) {
      levels.push_back({limit.limit, true, {}});
    }
  }
  const std::size_t required = levels.size();
  const std::int64_t first = std::llround(scale.low / scale.step);
  std::int64_t stride = 1;
  for (const std::int64_t wanted : {1, 2, 5}) {
    stride = wanted;
    int count = 0;
    for (std::int64_t i = first + 1; i < first + scale.bands; ++i) count += i % wanted == 0 ? 1 : 0;
    if (count <= most) break;
  }
  for (std::int64_t i = first + 1; i < first + scale.bands; ++i) {
    const double value = static_cast<double>(i) * scale.step;
    if (i % stride != 0 || !(value > low) || !(value < high)) continue;
    const bool is_known =
        std::any_of(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(required),
                    [&](const IsoluxLevel& known) {
                      return std::abs(known.value - value) <= kSame * scale.high();
                    });
    if (!is_known) levels.push_back({value, false, {}});
  }
  std::sort(levels.begin(), levels.end(),
            [](const IsoluxLevel& a, const IsoluxLevel& b) { return a.value < b.value; });
  return levels;
}

bool trace_isolux(const PlanePart& plane, std::size_t most_points,
                  std::vector<IsoluxLevel>& levels) {
  std::size_t points = 0;
  std::vector<double> refused;
  for (const bool required : {true, false}) {
    for (IsoluxLevel& level : levels) {
      if (level.is_required != required) continue;
      level.lines = isolux_lines(plane, level.value);
      std::size_t more = 0;
      for (const IsoluxLine& line : level.lines) more += line.points_m.size();
      if (points + more > most_points)
        refused.push_back(level.value);
      else
        points += more;
    }
  }
  std::erase_if(levels, [&](const IsoluxLevel& level) {
    return std::find(refused.begin(), refused.end(), level.value) != refused.end();
  });
  return refused.empty();
}

}  // namespace report
