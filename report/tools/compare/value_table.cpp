#include "report/tools/compare/value_table.h"

#include "calc/base/csv.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/statistics.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/scene/receiver_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cli {
namespace {

enum Column : std::size_t {
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
      : place_{path, 0, 0},
        widening_(calc::student_t_quantile(0.5 + 0.5 * confidence, kLargeFreedom)),
        diagnostics_(diagnostics) {}

  std::optional<ValueTable> read(std::string_view text) {
    calc::CsvReader table(text, calc::CsvComments::hash);
    while (is_good_) {
      const std::optional<calc::CsvRecord> record = table.next();
      if (!record) break;
      place_.line = record->line;
      if (record->is_blank()) continue;
      if (columns_.width() == 0) {
        read_names(*record);
      } else {
        read_row(*record);
      }
    }
    if (const std::optional<calc::CsvProblem>& problem = table.problem()) {
      place_.line = problem->place.line;
      place_.column = problem->place.column;
      fail(problem->what);
    }
    if (is_good_ && columns_.width() == 0) fail("it has no line of column names");
    if (is_good_ && table_.rows.empty()) fail("it has no values of illuminance");
    if (!is_good_) return std::nullopt;
    return std::move(table_);
  }

 private:
  void fail(const std::string& problem) {
    diagnostics_.report(calc::DiagnosticId::reference_unreadable, place_, problem);
    is_good_ = false;
  }
  bool has(Column column) const { return columns_.has(column); }

  void read_names(const calc::CsvRecord& header) {
    columns_ = calc::CsvColumns(header, kNames, plain_name);
    table_.unused_columns = columns_.unknown();
    if (!columns_.doubled().empty()) {
      return fail(fmt::format("the column '{}' is given twice", columns_.doubled()));
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
      return fail(
          "errors must be in the columns 'error_lx', 'error_fc', or 'low_lx' and 'high_lx'");
    }
  }

  double number(const calc::CsvRecord& record, Column column) {
    const std::string& text = columns_.cell(record, column);
    const std::optional<double> value = calc::parse_number(text);
    if (!value && is_good_) {
      fail(fmt::format("'{}' in column '{}' is not a number{}", text, kNames[column],
                       calc::decimal_comma_hint(text)));
    }
    return value.value_or(0.0);
  }

  void read_row(const calc::CsvRecord& record) {
    if (record.cells.size() != columns_.width()) {
      return fail(fmt::format("{} values in this line, {} names of columns", record.cells.size(),
                              columns_.width()));
    }
    TableRow row;
    row.line = record.line;
    if (has(kQuantity)) {
      row.quantity = columns_.cell(record, kQuantity);
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
    if (has(kPlane)) row.plane = columns_.cell(record, kPlane);
    if (has(kX) && has(kY) && has(kZ)) {
      row.position_m = glm::dvec3(number(record, kX), number(record, kY), number(record, kZ));
    }
    if (has(kColumn) && has(kRow)) {
      const double column = number(record, kColumn), of_row = number(record, kRow);
      const auto is_cell = [](double v) { return v >= 0.0 && v < 1e7 && v == std::floor(v); };
      if (is_good_ && (!is_cell(column) || !is_cell(of_row))) {
        return fail("'column' and 'row' must be whole numbers from 0");
      }
      row.cell = glm::ivec2(static_cast<int>(column), static_cast<int>(of_row));
    }
    const double unit = has(kFc) ? calc::kLuxPerFootcandle : 1.0;
    row.value.lx = unit * number(record, has(kFc) ? kFc : kLx);
    if (has(kErrorLx)) row.value.half_width_lx = widening_ * number(record, kErrorLx);
    if (has(kErrorFc)) {
      row.value.half_width_lx = widening_ * calc::kLuxPerFootcandle * number(record, kErrorFc);
    }
    if (has(kLow)) row.value.half_width_lx = 0.5 * (number(record, kHigh) - number(record, kLow));
    if (!is_good_) return;
    if (row.value.lx < 0.0 || row.value.half_width_lx < 0.0) {
      return fail("illuminances and their errors must be 0 or more");
    }
    table_.rows.push_back(std::move(row));
  }

  calc::SourceLocation place_;  // of what is being read
  double widening_;
  calc::Diagnostics& diagnostics_;
  calc::CsvColumns columns_;
  bool is_good_ = true;
  ValueTable table_;
};

}  // namespace

std::optional<ValueTable> read_value_table(std::string_view text, const std::string& path,
                                           double confidence, calc::Diagnostics& diagnostics) {
  return TableReader(path, confidence, diagnostics).read(text);
}

}  // namespace cli
