#include "calc/project/point_list_csv.h"

#include "calc/base/csv.h"
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
constexpr std::size_t kBadPointLineLimit = 10;
constexpr double kLargestCoordinate = 1.0e9;
constexpr double kSmallestNormal = 1.0e-9;

bool is_header(const CsvRecord& record) {
  return std::equal(record.cells.begin(), record.cells.end(), kPointColumns.begin(),
                    kPointColumns.end(),
                    [](const CsvCell& cell, std::string_view name) { return cell.text == name; });
}

// False if something was reported.
bool parse_line(const CsvRecord& record, const SourceLocation& where, PointList& list,
                Diagnostics& diagnostics) {
  std::array<double, kPointColumns.size()> value{};
  if (record.cells.size() != value.size()) {
    diagnostics.report(DiagnosticId::point_list_line, where, record.cells.size());
    return false;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string& text = record.cells[i].text;
    const std::optional<double> number = parse_number(text);
    if (!number || std::abs(*number) > kLargestCoordinate) {
      diagnostics.report(DiagnosticId::point_list_number, where, shorten_utf8(text, 30));
      return false;
    }
    value[i] = *number;
  }
  const glm::dvec3 normal(value[3], value[4], value[5]);
  if (glm::length(normal) < kSmallestNormal) {
    diagnostics.report(DiagnosticId::point_list_zero_normal, where);
    return false;
  }
  list.position_m.emplace_back(value[0], value[1], value[2]);
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
  std::size_t bad_lines = 0;
  CsvReader table(bytes);
  while (const std::optional<CsvRecord> record = table.next()) {
    where.line = record->line;
    if (!has_header) {
      if (!is_header(*record)) {
        diagnostics.report(DiagnosticId::point_list_header, where, shorten_utf8(record->text, 60));
        return std::nullopt;
      }
      has_header = true;
    } else if (!record->is_blank() && !parse_line(*record, where, list, diagnostics) &&
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
