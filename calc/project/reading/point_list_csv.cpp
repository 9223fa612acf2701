#include "calc/project/reading/point_list_csv.h"

#include "calc/base/csv.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace calc {
namespace {

constexpr std::array<std::string_view, 6> kPointColumns{"x", "y", "z", "nx", "ny", "nz"};
constexpr std::size_t kLengthColumns = 3;  // x, y and z
constexpr std::size_t kBadPointLineLimit = 10;
constexpr double kLargestCoordinate = 1.0e9;
constexpr double kSmallestNormal = 1.0e-9;

// Whether it is a header, and the unit that it names for all of x, y and z; none: they name no
// unit.
bool read_header(const CsvRecord& record, std::optional<double>& metres) {
  if (record.cells.size() != kPointColumns.size()) return false;
  metres = length_column(record.cells.front().text).metres;
  for (std::size_t i = 0; i < kPointColumns.size(); ++i) {
    const LengthColumn column = length_column(record.cells[i].text);
    const bool has_its_unit = i < kLengthColumns ? column.metres == metres : !column.metres;
    if (column.name != kPointColumns[i] || !has_its_unit) return false;
  }
  return true;
}

// False if something was reported.
bool parse_line(const CsvRecord& record, double metres, const SourceLocation& where,
                PointList& list, Diagnostics& diagnostics) {
  std::array<double, kPointColumns.size()> value{};
  if (record.cells.size() != value.size()) {
    diagnostics.report(DiagnosticId::point_list_line, where, record.cells.size());
    return false;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string& text = record.cells[i].text;
    const std::optional<double> number = parse_number(text);
    if (!number || std::abs(*number) > kLargestCoordinate) {
      diagnostics.report(DiagnosticId::point_list_number, where, shorten_utf8(text, 30),
                         decimal_comma_hint(text));
      return false;
    }
    value[i] = *number;
  }
  const glm::dvec3 normal(value[3], value[4], value[5]);
  if (glm::length(normal) < kSmallestNormal) {
    diagnostics.report(DiagnosticId::point_list_zero_normal, where);
    return false;
  }
  list.position_m.push_back(metres * glm::dvec3(value[0], value[1], value[2]));
  list.normal.push_back(glm::normalize(normal));
  list.line.push_back(where.line);
  return true;
}

}  // namespace

std::optional<PointList> parse_point_list(std::string_view bytes, const std::string& name,
                                          Diagnostics& diagnostics) {
  PointList list;
  list.file = name;
  SourceLocation where{name, 0, 0};
  bool has_header = false;
  std::optional<double> metres;
  std::size_t bad_lines = 0;
  CsvReader table(bytes);
  while (const std::optional<CsvRecord> record = table.next()) {
    where.line = record->line;
    if (!has_header) {
      if (!read_header(*record, metres)) {
        diagnostics.report(DiagnosticId::point_list_header, where, shorten_utf8(record->text, 60));
        return std::nullopt;
      }
      has_header = true;
      list.names_its_unit = metres.has_value();
    } else if (!record->is_blank() &&
               !parse_line(*record, metres.value_or(1.0), where, list, diagnostics) &&
               ++bad_lines == kBadPointLineLimit) {
      diagnostics.report(DiagnosticId::point_list_gives_up, where, kBadPointLineLimit - 1);
      return std::nullopt;
    }
  }
  if (report_csv_problem(table, name, diagnostics) || bad_lines > 0) return std::nullopt;
  if (list.position_m.empty()) {
    diagnostics.report(DiagnosticId::point_list_empty, where);
    return std::nullopt;
  }
  return list;
}

}  // namespace calc
