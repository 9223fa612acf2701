#pragma once
// Reads illuminances of another program or of a site from a table.

#include "calc/base/diagnostics.h"
#include "report/tools/compare/comparison.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

struct TableRow {
  std::optional<std::string> plane;
  std::optional<glm::dvec3> position_m;
  std::optional<glm::ivec2> cell;  // column and row
  std::string quantity;            // "planar", see calc::quantity_name(); "" = not told
  report::ComparedValue value;     // half_width_lx at `confidence`
  int line = 0;
};

struct ValueTable {
  std::vector<TableRow> rows;
  std::vector<std::string> unused_columns;
  std::size_t ratings = 0;  // lines of ratings and ratios, which are no illuminances: left out
};

// Reads CSV with a line of names: 'plane,column,row' or 'x,y,z' (m; x_m is x too), 'lx' (also
// 'illuminance_lx') or 'fc', and optionally 'error_lx' or 'error_fc' (a standard error, widened to
// `confidence` by the normal distribution) or 'low_lx,high_lx'; 'quantity', a name of
// calc::kPlaneQuantities. '#' begins a comment line. Empty after an error: unreadable lines are
// never skipped.
std::optional<ValueTable> read_value_table(std::string_view text, const std::string& path,
                                           double confidence, calc::Diagnostics& diagnostics);

}  // namespace cli
