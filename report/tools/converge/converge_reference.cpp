#include "report/tools/converge/converge_reference.h"

#include "calc/base/csv.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cli {
namespace {

constexpr double kSamePlace_m = 1e-3;

enum ReferenceColumn : std::size_t { kPlane, kColumn, kRow, kX, kY, kZ, kLux, kError, kColumns };
constexpr std::array<std::string_view, kColumns> kReferenceColumns{
    "plane", "column", "row", "x", "y", "z", "lx", "error_lx"};

std::string_view without_unit(std::string_view name) {  // x_m as in points.csv
  return name == "x_m" ? "x" : (name == "y_m" ? "y" : (name == "z_m" ? "z" : name));
}

struct PointPlace {
  std::size_t task, point;
};

class ReferenceReader {
 public:
  ReferenceReader(const std::string& path, const std::vector<calc::PlaneTask>& tasks,
                  calc::Diagnostics& diagnostics)
      : place_{path, 0, 0}, tasks_(tasks), diagnostics_(diagnostics) {
    for (const calc::PlaneTask& task : tasks) {
      lx_.emplace_back(task.grid->position_m.size(), std::numeric_limits<double>::quiet_NaN());
      error_lx_.emplace_back(task.grid->position_m.size(), 0.0);
    }
  }

  bool read(std::string_view text) {
    calc::CsvReader table(text, calc::CsvComments::hash);
    while (problems_ == 0) {
      const std::optional<calc::CsvRecord> record = table.next();
      if (!record) break;
      place_.line = record->line;
      if (!record->is_blank()) read_line(*record);
    }
    if (const std::optional<calc::CsvProblem>& problem = table.problem()) {
      place_.line = problem->place.line;
      place_.column = problem->place.column;
      fail(problem->what);
    }
    if (problems_ == 0 && columns_.width() == 0) fail("it has no line of column names");
    if (problems_ == 0) find_missing();
    return problems_ == 0;
  }

  std::vector<report::ConvergeTruth> truths() const {
    std::vector<report::ConvergeTruth> truths;
    for (std::size_t t = 0; t < lx_.size(); ++t) {
      truths.push_back(report::truth_of(lx_[t], error_lx_[t]));
    }
    return truths;
  }

 private:
  void fail(const std::string& problem) {
    diagnostics_.report(calc::DiagnosticId::reference_unreadable, place_, problem);
    ++problems_;
  }

  void read_line(const calc::CsvRecord& record) {
    if (columns_.width() == 0) return read_head(record);
    if (record.cells.size() != columns_.width()) {
      return fail(fmt::format("{} values in this line, {} names of columns", record.cells.size(),
                              columns_.width()));
    }
    const std::optional<double> lux = number(record, kLux);
    const std::optional<double> error =
        columns_.has(kError) ? number(record, kError) : std::optional<double>(0.0);
    if (!lux || !error) return;
    if (*lux < 0.0 || *error < 0.0) return fail("lx and error_lx must be 0 or more");
    const std::optional<PointPlace> place = find_point(record);
    if (!place) return;
    double& known = lx_[place->task][place->point];
    if (!std::isnan(known)) return fail("this point was given before");
    known = *lux;
    error_lx_[place->task][place->point] = *error;
  }

  void read_head(const calc::CsvRecord& header) {
    columns_ = calc::CsvColumns(header, kReferenceColumns, without_unit);
    if (!columns_.doubled().empty()) {
      return fail(fmt::format("the column '{}' is given twice", columns_.doubled()));
    }
    const bool by_cell = columns_.has(kPlane) && columns_.has(kColumn) && columns_.has(kRow);
    by_place_ = columns_.has(kX) && columns_.has(kY) && columns_.has(kZ);
    if (!columns_.has(kLux) || (!by_cell && !by_place_)) {
      fail("columns 'lx' and either 'plane', 'column', 'row' or 'x', 'y', 'z' are needed");
    }
  }

  std::optional<double> number(const calc::CsvRecord& record, ReferenceColumn column) {
    const std::string& text = columns_.cell(record, column);
    const std::optional<double> value = calc::parse_number(text);
    if (!value)
      fail(fmt::format("'{}' in column '{}' is not a number{}", text, kReferenceColumns[column],
                       calc::decimal_comma_hint(text)));
    return value;
  }

  std::optional<PointPlace> find_point(const calc::CsvRecord& record) {
    const std::string& plane = columns_.cell(record, kPlane);
    const ReferenceColumn first = by_place_ ? kX : kColumn;
    std::array<double, 3> wanted{};
    for (std::size_t i = 0; i < (by_place_ ? 3u : 2u); ++i) {
      const std::optional<double> value = number(record, static_cast<ReferenceColumn>(first + i));
      if (!value) return std::nullopt;
      wanted[i] = *value;
    }
    bool is_known = !columns_.has(kPlane);
    for (std::size_t t = 0; t < tasks_.size(); ++t) {
      if (columns_.has(kPlane) && tasks_[t].plane_id != plane) continue;
      is_known = true;
      const calc::SensorGrid& grid = *tasks_[t].grid;
      for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
        if (is_there(grid, i, wanted)) return PointPlace{t, i};
      }
    }
    if (is_known) fail("there is no such point; 'points.csv' of 'luxgate check' lists them");
    return std::nullopt;  // a line of another plane is nobody's business
  }

  bool is_there(const calc::SensorGrid& grid, std::size_t i,
                const std::array<double, 3>& wanted) const {
    if (!by_place_) return grid.column[i] == wanted[0] && grid.row[i] == wanted[1];
    return glm::length(grid.position_m[i] - glm::dvec3(wanted[0], wanted[1], wanted[2])) <=
           kSamePlace_m;
  }

  void find_missing() {
    for (std::size_t t = 0; t < lx_.size(); ++t) {
      const auto missing = std::count_if(lx_[t].begin(), lx_[t].end(),
                                         [](double value) { return std::isnan(value); });
      if (missing == 0) continue;
      place_.line = 0;
      fail(fmt::format("{} of the {} points of plane '{}' are missing", missing, lx_[t].size(),
                       tasks_[t].plane_id));
    }
  }

  calc::SourceLocation place_;  // of what is being read
  const std::vector<calc::PlaneTask>& tasks_;
  calc::Diagnostics& diagnostics_;
  std::vector<std::vector<double>> lx_, error_lx_;  // [task][point]
  calc::CsvColumns columns_;
  int problems_ = 0;
  bool by_place_ = false;
};

}  // namespace

std::optional<std::vector<report::ConvergeTruth>> read_reference(
    std::string_view text, const std::string& path, const std::vector<calc::PlaneTask>& tasks,
    calc::Diagnostics& diagnostics) {
  ReferenceReader reader(path, tasks, diagnostics);
  if (!reader.read(text)) return std::nullopt;
  return reader.truths();
}

}  // namespace cli
