#include "report/tools/compare/value_table.h"

#include "calc/base/statistics.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/scene/receiver_kernel.h"
#include "report/shell/csv_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cli {
namespace {

enum Column {
  kPlane,
  kColumn,
  kRow,
  kX,
  kY,
  kZ,
  kLx,
  kFc,
  kErrorLx,
  kErrorFc,
  kLow,
  kHigh,
  kQuantity,
  kCount
};
constexpr std::array<std::string_view, kCount> kNames{
    "plane", "column",   "row",      "x",      "y",       "z",       "lx",
    "fc",    "error_lx", "error_fc", "low_lx", "high_lx", "quantity"};
constexpr int kLargeFreedom = 1'000'000;  // Student's t is normal there

std::string_view plain_name(std::string_view name) {
  if (name == "x_m" || name == "y_m" || name == "z_m") return name.substr(0, 1);
  return name == "illuminance_lx" ? "lx" : name;
}

class TableReader {
 public:
  TableReader(const std::string& path, double confidence, calc::Diagnostics& diagnostics)
      : path_(path),
        widening_(calc::student_t_quantile(0.5 + 0.5 * confidence, kLargeFreedom)),
        diagnostics_(diagnostics) {
    at_.fill(-1);
  }

  std::optional<ValueTable> read(std::string_view text) {
    if (text.starts_with(calc::kUtf8ByteOrderMark)) {
      text.remove_prefix(calc::kUtf8ByteOrderMark.size());
    }
    while (!text.empty() && is_good_) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      const std::string_view line = calc::trim(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      if (line.empty() || line.front() == '#') continue;
      if (width_ == 0) {
        read_names(csv_cells(line));
      } else {
        read_row(csv_cells(line));
      }
    }
    if (is_good_ && width_ == 0) fail("it has no line of column names");
    if (is_good_ && table_.rows.empty()) fail("it has no values of illuminance");
    if (!is_good_) return std::nullopt;
    return std::move(table_);
  }

 private:
  void fail(const std::string& problem) {
    diagnostics_.report(calc::DiagnosticId::reference_unreadable, {path_, line_, 0}, problem);
    is_good_ = false;
  }
  bool has(Column column) const { return at_[column] >= 0; }

  void read_names(const std::vector<std::string>& cells) {
    width_ = cells.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto name = std::find(kNames.begin(), kNames.end(), plain_name(cells[i]));
      if (name == kNames.end()) {
        table_.unused_columns.push_back(cells[i]);
        continue;
      }
      int& at = at_[static_cast<std::size_t>(name - kNames.begin())];
      if (at >= 0) return fail(fmt::format("the column '{}' is there twice", cells[i]));
      at = static_cast<int>(i);
    }
    const bool by_cell = has(kPlane) && has(kColumn) && has(kRow);
    const bool by_place = has(kX) && has(kY) && has(kZ);
    if (!by_cell && !by_place) {
      return fail("columns 'plane', 'column' and 'row', or 'x', 'y' and 'z', are needed");
    }
    if (has(kLx) == has(kFc)) return fail("either a column 'lx' or a column 'fc' is needed");
    const int errors =
        (has(kErrorLx) ? 1 : 0) + (has(kErrorFc) ? 1 : 0) + (has(kLow) || has(kHigh) ? 1 : 0);
    if (errors > 1 || has(kLow) != has(kHigh)) {
      return fail("errors are wanted as 'error_lx', as 'error_fc' or as 'low_lx' and 'high_lx'");
    }
  }

  double number(const std::vector<std::string>& cells, Column column) {
    const std::string& text = cells[static_cast<std::size_t>(at_[column])];
    const std::optional<double> value = calc::parse_number(text);
    if (!value && is_good_) {
      fail(fmt::format("'{}' in column '{}' is no number", text, kNames[column]));
    }
    return value.value_or(0.0);
  }

  void read_row(const std::vector<std::string>& cells) {
    if (cells.size() != width_) {
      return fail(fmt::format("{} values in this line, {} names of columns", cells.size(), width_));
    }
    TableRow row;
    row.line = line_;
    if (has(kQuantity)) {
      row.quantity = cells[static_cast<std::size_t>(at_[kQuantity])];
      const auto known =
          std::find_if(calc::kPlaneQuantities.begin(), calc::kPlaneQuantities.end(),
                       [&](const auto& candidate) { return candidate.name == row.quantity; });
      if (known == calc::kPlaneQuantities.end()) {
        return fail(fmt::format("'{}' in column 'quantity' is not known", row.quantity));
      }
      if (calc::is_plain_number(known->derived)) {
        ++table_.ratings;
        return;
      }
    }
    if (has(kPlane)) row.plane = cells[static_cast<std::size_t>(at_[kPlane])];
    if (has(kX) && has(kY) && has(kZ)) {
      row.position_m = glm::dvec3(number(cells, kX), number(cells, kY), number(cells, kZ));
    }
    if (has(kColumn) && has(kRow)) {
      const double column = number(cells, kColumn), of_row = number(cells, kRow);
      const auto is_cell = [](double v) { return v >= 0.0 && v < 1e7 && v == std::floor(v); };
      if (is_good_ && (!is_cell(column) || !is_cell(of_row))) {
        return fail("'column' and 'row' must be whole numbers from 0");
      }
      row.cell = glm::ivec2(static_cast<int>(column), static_cast<int>(of_row));
    }
    const double unit = has(kFc) ? calc::kLuxPerFootcandle : 1.0;
    row.value.lx = unit * number(cells, has(kFc) ? kFc : kLx);
    if (has(kErrorLx)) row.value.half_width_lx = widening_ * number(cells, kErrorLx);
    if (has(kErrorFc)) {
      row.value.half_width_lx = widening_ * calc::kLuxPerFootcandle * number(cells, kErrorFc);
    }
    if (has(kLow)) row.value.half_width_lx = 0.5 * (number(cells, kHigh) - number(cells, kLow));
    if (!is_good_) return;
    if (row.value.lx < 0.0 || row.value.half_width_lx < 0.0) {
      return fail("illuminances and their errors must be 0 or more");
    }
    table_.rows.push_back(std::move(row));
  }

  const std::string& path_;
  double widening_;
  calc::Diagnostics& diagnostics_;
  std::array<int, kCount> at_{};
  std::size_t width_ = 0;
  int line_ = 0;
  bool is_good_ = true;
  ValueTable table_;
};

}  // namespace

std::optional<ValueTable> read_value_table(std::string_view text, const std::string& path,
                                           double confidence, calc::Diagnostics& diagnostics) {
  return TableReader(path, confidence, diagnostics).read(text);
}

}  // namespace cli
