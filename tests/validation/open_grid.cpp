#include "tests/validation/open_grid.h"

#include "rules/measure/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace validation {

using namespace cli::selftest;

namespace {

constexpr double kTableKnownTo = 1e-6;  // of grids under lamps whose table is the truth
constexpr double kSolverKnownTo = 1e-3;

// 0..4 is two numbers.
std::string without_dots(std::string text) {
  for (std::size_t at = text.find(".."); at != std::string::npos; at = text.find("..")) {
    text.replace(at, 2, " ");
  }
  return text;
}

Places cells(const glm::dvec2& low, const glm::dvec2& high, double z, int columns, int rows) {
  Places places;
  const glm::dvec2 size = (high - low) / glm::dvec2(columns, rows);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const glm::dvec2 at = low + glm::dvec2(i + 0.5, j + 0.5) * size;
      places.point.push_back({{at.x, at.y, z}, kUp});
      places.area_m2.push_back(size.x * size.y);
    }
  }
  return places;
}

// "Plane z = 0.75, x 0..4, y 0..4, 8 x 8 points"
std::optional<GridCase> stated_grid(const Row& item, bool is_true_average) {
  const std::string spec = without_dots(item.at("spec"));
  const std::size_t at = spec.find("Plane z = ");
  double z = 0, x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  int columns = 0, rows = 0;
  if (at == std::string::npos ||
      std::sscanf(spec.c_str() + at, "Plane z = %lf, x %lf %lf, y %lf %lf, %d x %d", &z, &x0, &x1,
                  &y0, &y1, &columns, &rows) != 7) {
    return std::nullopt;
  }
  if (is_true_average) columns = rows = 200;
  return GridCase{cells({x0, y0}, {x1, y1}, z, columns, rows), 1.0, kTableKnownTo};
}

// "grid 6 x 69 cell centres of the bordered plane" in a room of DIAL.
std::optional<GridCase> bordered_grid(const Row& item, const Row& scalar, const Tables& tables) {
  double x = 0, y = 0, height = 0, z = 0;
  int columns = 0, rows = 0;
  const std::string& spec = item.at("spec");
  const std::size_t plane = spec.find("Plane z = ");
  if (std::sscanf(spec.c_str(), "Room %lf x %lf x %lf m", &x, &y, &height) != 3 ||
      plane == std::string::npos || std::sscanf(spec.c_str() + plane, "Plane z = %lf", &z) != 1) {
    return std::nullopt;
  }
  double of_name = 0.0;
  if (std::sscanf(scalar.at("name").c_str(), "plane at %lf m", &of_name) == 1) z = of_name;
  for (const Row& row : rows_of(tables.scalars, item.at("case_id"))) {
    if (std::sscanf(row.at("note").c_str(), "grid %d x %d cell", &columns, &rows) == 2) break;
  }
  if (columns <= 0 || rows <= 0) return std::nullopt;
  const double border = std::min(0.5, 0.15 * std::min(x, y));
  return GridCase{cells({border, border}, {x - border, y - border}, z, columns, rows), 0.8,
                  kSolverKnownTo};
}

// Points named g0_0, g0_1, ... of the case's own table.
std::optional<GridCase> named_grid(const Row& item, const Tables& tables) {
  GridCase grid;
  grid.known_to = kSolverKnownTo;
  for (const Row& row : rows_of(tables.points, item.at("case_id"))) {
    int i = 0, j = 0;
    if (std::sscanf(row.at("point").c_str(), "g%d_%d", &i, &j) != 2 ||
        row.at("quantity") != "E total") {
      continue;
    }
    grid.places.point.push_back({{number(row, "x"), number(row, "y"), number(row, "z")}, kUp});
    grid.places.area_m2.push_back(1.0);
  }
  return grid.places.point.empty() ? std::nullopt : std::optional(grid);
}

std::optional<rules::Metric> metric_of(const std::string& quantity) {
  const auto starts = [&](const char* with) { return quantity.rfind(with, 0) == 0; };
  if (starts("U0")) return rules::Metric::uniformity_min_avg;
  if (starts("Ud")) return rules::Metric::uniformity_min_max;
  if (starts("mean") || starts("maintained average")) return rules::Metric::average;
  if (starts("min")) return rules::Metric::minimum;
  if (starts("max")) return rules::Metric::maximum;
  return std::nullopt;
}

}  // namespace

std::optional<GridCase> grid_case(const Row& item, const Row& scalar, const Tables& tables) {
  const std::string& quantity = scalar.at("quantity");
  const bool is_true_average = quantity == "true area average";
  if (!is_true_average && !metric_of(quantity)) return std::nullopt;
  if (auto grid = stated_grid(item, is_true_average)) return grid;
  if (auto grid = bordered_grid(item, scalar, tables)) return grid;
  return named_grid(item, tables);
}

Measured grid_statistic(const Row& scalar, const GridCase& grid, const Solution& solution) {
  rules::PointValues values;
  values.points = grid.places.point.size();
  for (std::size_t i = 0; i < values.points; ++i) {
    const std::vector<double> replicates = solution.replicates(i);
    values.replicates = replicates.size();
    values.value_lx.resize(values.replicates * values.points);
    for (std::size_t r = 0; r < replicates.size(); ++r) {
      values.value_lx[r * values.points + i] = grid.maintenance * replicates[r];
    }
  }
  const rules::Metric metric = metric_of(scalar.at("quantity")).value();
  Measured m;
  m.what = scalar.at("name") + ": " + scalar.at("quantity");
  m.unit = scalar.at("unit") == "1" ? "" : scalar.at("unit");
  const std::string& table = scalar.at("value_linear_table");
  m.exact = number(scalar, table.empty() ? "value" : "value_linear_table");
  m.known_to = grid.known_to * m.exact;
  m.interval = [values, metric](double confidence) {
    const auto made = rules::compute_metric(values, metric, 0.0, std::nullopt, confidence);
    return made ? made->estimate : calc::Estimate{};
  };
  m.replicates.assign(values.replicates, m.interval(0.95).value);
  return m;
}

}  // namespace validation
