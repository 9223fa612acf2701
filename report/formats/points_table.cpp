#include "report/formats/table.h"
#include "report/text/point_thresholds.h"
#include "report/text/shown_decimals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace report {
namespace {

constexpr int kLuxDecimals = 2, kNumberDecimals = 3;

constexpr std::array kPointColumns{
    TableColumn{"project", "Project", 18},
    TableColumn{"space", "Space", 14},
    TableColumn{"plane", "Plane", 16},
    TableColumn{"column", "Column", 8},
    TableColumn{"row", "Row", 8},
    TableColumn{"x_m", "x (m)", 10, 3},
    TableColumn{"y_m", "y (m)", 10, 3},
    TableColumn{"z_m", "z (m)", 10, 3},
    TableColumn{"nx", "Axis x", 9, 3},
    TableColumn{"ny", "Axis y", 9, 3},
    TableColumn{"nz", "Axis z", 9, 3},
    TableColumn{"illuminance_lx", "Illuminance (lx)", 12, kLuxDecimals},
    TableColumn{"low_lx", "Low (lx)", 12, kLuxDecimals},
    TableColumn{"high_lx", "High (lx)", 12, kLuxDecimals},
    TableColumn{"direct_lx", "Of it direct (lx)", 12, kLuxDecimals},
    TableColumn{"indirect_lx", "Of it reflected (lx)", 12, kLuxDecimals},
    TableColumn{"quantity", "Quantity", 16},
    TableColumn{"rating", "Rating or ratio", 10, kNumberDecimals},
    TableColumn{"rating_low", "Low of it", 10, kNumberDecimals},
    TableColumn{"rating_high", "High of it", 10, kNumberDecimals}};

// As many as the column has, or more where these would put a value on the wrong side of a limit.
int point_decimals(const calc::Estimate& measured, bool is_number, const Thresholds& thresholds) {
  const int least = is_number ? kNumberDecimals : kLuxDecimals;
  const double near = is_number ? 1e-3 : 1e-2;  // one digit of the last place
  const auto is_near = [&](const Threshold& threshold) {
    return std::abs(measured.value - threshold.limit) < near ||
           std::abs(measured.low - threshold.limit) < near ||
           std::abs(measured.high - threshold.limit) < near;
  };
  if (std::none_of(thresholds.list.begin(), thresholds.list.end(), is_near)) return kOfColumn;
  return std::max(least, interval_decimals(measured, is_number ? "" : "lx", thresholds));
}

// Ratings and ratios have columns of their own: what is called lx is lx.
void visit_plane(const ProjectPart& project, const SpacePart& space, const PlanePart& plane,
                 const VisitRow& visit) {
  std::array<TableCell, kPointColumns.size()> cells;
  const auto at = [&cells](std::string_view name) -> TableCell& {
    return cells[column_of(kPointColumns, name)];
  };
  at("project") = project.path;
  at("space") = space.id;
  at("plane") = plane.id;
  at("quantity") = std::string(calc::quantity_name(plane.kernel, plane.derived));
  TableCell &column = at("column"), &row = at("row"), &direct = at("direct_lx"),
            &indirect = at("indirect_lx");
  const std::array position{&at("x_m"), &at("y_m"), &at("z_m")};
  const std::array normal{&at("nx"), &at("ny"), &at("nz")};
  const bool is_number = calc::is_plain_number(plane.derived);
  const Thresholds thresholds = point_thresholds(plane);
  const std::array measured =
      is_number ? std::array{&at("rating"), &at("rating_low"), &at("rating_high")}
                : std::array{&at("illuminance_lx"), &at("low_lx"), &at("high_lx")};
  for (const PointRow& point : plane.points) {
    column = std::int64_t{point.column};
    row = std::int64_t{point.row};
    for (int axis = 0; axis < 3; ++axis) {
      *position[static_cast<std::size_t>(axis)] = TableNumber{point.position_m[axis]};
      *normal[static_cast<std::size_t>(axis)] = TableNumber{point.normal[axis]};
    }
    const int decimals = point_decimals(point.measured, is_number, thresholds);
    *measured[0] = TableNumber{point.measured.value, decimals};
    *measured[1] = TableNumber{point.measured.low, decimals};
    *measured[2] = TableNumber{point.measured.high, decimals};
    direct = TableNumber{point.direct_lx};
    indirect = TableNumber{point.indirect_lx};
    visit(cells);
  }
}

void visit_points(const ProjectPart& project, const VisitRow& visit) {
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) visit_plane(project, space, plane, visit);
  }
}

constexpr DocumentTable kPointsTable{kPointColumns, visit_points};

}  // namespace

const DocumentTable& points_table() { return kPointsTable; }

}  // namespace report
