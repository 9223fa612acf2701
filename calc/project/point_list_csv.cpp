#include "calc/project/point_list_csv.h"

#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace calc {
namespace {

constexpr std::string_view kHeader = "x,y,z,nx,ny,nz";
constexpr std::size_t kBadLineLimit = 10;
constexpr double kLargestCoordinate = 1.0e9;
constexpr double kSmallestNormal = 1.0e-9;

// False if something was reported.
bool parse_line(std::string_view line, const SourceLocation& where, PointList& list,
                Diagnostics& diagnostics) {
  const std::vector<std::string_view> parts = split_at_commas(line);
  std::array<double, 6> value{};
  if (parts.size() != value.size()) {
    diagnostics.report(DiagnosticId::point_list_line, where, parts.size());
    return false;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::optional<double> number = parse_number(parts[i]);
    if (!number || std::abs(*number) > kLargestCoordinate) {
      diagnostics.report(DiagnosticId::point_list_number, where, shorten_utf8(parts[i], 30));
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
  if (bytes.starts_with(kUtf8ByteOrderMark)) bytes.remove_prefix(kUtf8ByteOrderMark.size());
  PointList list;
  list.file = name;
  SourceLocation where{name, 0, 0};
  bool has_header = false;
  std::size_t bad_lines = 0;
  LineCursor lines(bytes);
  while (const std::optional<std::string_view> text = lines.next()) {
    const std::string_view line = trim(*text);
    where.line = lines.line();
    if (!has_header) {
      if (line != kHeader) {
        diagnostics.report(DiagnosticId::point_list_header, where, shorten_utf8(line, 60));
        return std::nullopt;
      }
      has_header = true;
    } else if (!line.empty() && !parse_line(line, where, list, diagnostics) &&
               ++bad_lines == kBadLineLimit) {
      diagnostics.report(DiagnosticId::point_list_gives_up, where, kBadLineLimit - 1);
      return std::nullopt;
    }
  }
  if (bad_lines > 0) return std::nullopt;
  if (list.position_m.empty()) {
    diagnostics.report(DiagnosticId::point_list_empty, where);
    return std::nullopt;
  }
  return list;
}

}  // namespace calc
