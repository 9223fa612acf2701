#include "report/tools/converge/converge_reference.h"

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

enum Column { kPlane, kColumn, kRow, kX, kY, kZ, kLux, kError, kColumns };
constexpr std::array<std::string_view, kColumns> kNames{"plane", "column", "row", "x",
                                                        "y",     "z",      "lx",  "error_lx"};

struct PointPlace {
  std::size_t task, point;
};

class ReferenceReader {
 public:
  ReferenceReader(const std::string& path, const std::vector<calc::PlaneTask>& tasks,
                  calc::Diagnostics& diagnostics)
      : path_(path), tasks_(tasks), diagnostics_(diagnostics) {
    for (const calc::PlaneTask& task : tasks) {
      lx_.emplace_back(task.grid->position_m.size(), std::numeric_limits<double>::quiet_NaN());
      error_lx_.emplace_back(task.grid->position_m.size(), 0.0);
    }
  }

  bool read(std::string_view text) {
    while (!text.empty() && problems_ == 0) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      const std::string_view line = calc::trim(text.substr(0, end));
      if (!line.empty() && line.front() != '#') read_line(calc::split_at_commas(line));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (problems_ == 0 && !has_head_) fail("it has no line of column names");
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
    diagnostics_.report(calc::DiagnosticId::reference_unreadable, {path_, line_, 0}, problem);
    ++problems_;
  }

  void read_line(const std::vector<std::string_view>& cells) {
    if (!has_head_) return read_head(cells);
    if (cells.size() != width_) {
      return fail(fmt::format("{} values in this line, {} names of columns", cells.size(), width_));
    }
    const std::optional<double> lux = number(cells, kLux);
    const std::optional<double> error =
        at_[kError] < 0 ? std::optional<double>(0.0) : number(cells, kError);
    if (!lux || !error) return;
    if (*lux < 0.0 || *error < 0.0) return fail("lx and error_lx must be 0 or more");
    const std::optional<PointPlace> place = find_point(cells);
    if (!place) return;
    double& known = lx_[place->task][place->point];
    if (!std::isnan(known)) return fail("this point was given before");
    known = *lux;
    error_lx_[place->task][place->point] = *error;
  }

  void read_head(const std::vector<std::string_view>& cells) {
    has_head_ = true;
    width_ = cells.size();
    at_.fill(-1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto name = std::find(kNames.begin(), kNames.end(), without_unit(cells[i]));
      if (name == kNames.end()) continue;
      int& at = at_[static_cast<std::size_t>(name - kNames.begin())];
      if (at >= 0) return fail(fmt::format("the column '{}' is there twice", cells[i]));
      at = static_cast<int>(i);
    }
    const bool by_cell = at_[kPlane] >= 0 && at_[kColumn] >= 0 && at_[kRow] >= 0;
    by_place_ = at_[kX] >= 0 && at_[kY] >= 0 && at_[kZ] >= 0;
    if (at_[kLux] < 0 || (!by_cell && !by_place_)) {
      fail("columns 'lx' and either 'plane', 'column', 'row' or 'x', 'y', 'z' are needed");
    }
  }

  static std::string_view without_unit(std::string_view name) {  // x_m as in points.csv
    return name == "x_m" ? "x" : (name == "y_m" ? "y" : (name == "z_m" ? "z" : name));
  }

  std::optional<double> number(const std::vector<std::string_view>& cells, Column column) {
    const std::string_view text = cells[static_cast<std::size_t>(at_[column])];
    const std::optional<double> value = calc::parse_number(text);
    if (!value) fail(fmt::format("'{}' in column '{}' is no number", text, kNames[column]));
    return value;
  }

  std::optional<PointPlace> find_point(const std::vector<std::string_view>& cells) {
    std::string_view plane;
    if (at_[kPlane] >= 0) plane = cells[static_cast<std::size_t>(at_[kPlane])];
    const Column first = by_place_ ? kX : kColumn;
    std::array<double, 3> wanted{};
    for (std::size_t i = 0; i < (by_place_ ? 3u : 2u); ++i) {
      const std::optional<double> value = number(cells, static_cast<Column>(first + i));
      if (!value) return std::nullopt;
      wanted[i] = *value;
    }
    bool is_known = at_[kPlane] < 0;
    for (std::size_t t = 0; t < tasks_.size(); ++t) {
      if (at_[kPlane] >= 0 && tasks_[t].plane_id != plane) continue;
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
      line_ = 0;
      fail(fmt::format("{} of the {} points of plane '{}' are missing", missing, lx_[t].size(),
                       tasks_[t].plane_id));
    }
  }

  const std::string& path_;
  const std::vector<calc::PlaneTask>& tasks_;
  calc::Diagnostics& diagnostics_;
  std::vector<std::vector<double>> lx_, error_lx_;  // [task][point]
  std::array<int, kColumns> at_{};
  std::size_t width_ = 0;
  int line_ = 0, problems_ = 0;
  bool has_head_ = false, by_place_ = false;
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
