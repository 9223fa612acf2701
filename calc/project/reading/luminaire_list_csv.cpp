#include "calc/project/reading/luminaire_list_csv.h"

#include "calc/base/csv.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace calc {
namespace {

enum Column : std::size_t {
  kName,
  kType,
  kX,
  kY,
  kZ,
  kAxisX,
  kAxisY,
  kAxisZ,
  kAimX,
  kAimY,
  kAimZ,
  kRotation,
  kGroup,
  kColumns
};
constexpr std::array<std::string_view, kColumns> kNames{
    "name",   "type",    "x_m",     "y_m",     "z_m",          "axis_x", "axis_y",
    "axis_z", "aim_x_m", "aim_y_m", "aim_z_m", "rotation_deg", "group"};
constexpr std::size_t kRequired = kAxisX;
constexpr std::size_t kBadLineLimit = 10;
constexpr double kShortestAim = 1.0e-9;

// The name in metres of a column of lengths that is in another unit.
std::string_view name_in_metres(std::string_view written) {
  const LengthColumn length = length_column(written);
  for (const std::string_view name : kNames) {
    const LengthColumn known = length_column(name);
    if (length.metres && known.metres && known.name == length.name) return name;
  }
  return written;
}

// What is wrong with the line; thrown within this file only.
struct BadLine {
  std::string what;
};

class ListReader {
 public:
  // Throws BadLine.
  void read_header(const CsvRecord& header) {
    columns_ = CsvColumns(header, kNames, name_in_metres);
    if (!columns_.unknown().empty()) {
      const std::string found = shorten_utf8(columns_.unknown()[0], 40);
      throw BadLine{"unknown column '" + found + "'" +
                    suggestion(found, {kNames.begin(), kNames.end()})};
    }
    if (!columns_.doubled().empty()) {
      throw BadLine{fmt::format("column '{}' is given twice", columns_.doubled())};
    }
    for (std::size_t c = 0; c < kRequired; ++c) {
      if (!columns_.has(c)) throw BadLine{fmt::format("column '{}' is missing", kNames[c])};
    }
    for (const Column first : {kAxisX, kAimX}) {
      for (std::size_t c = first; c < first + 3u; ++c) {
        if (columns_.has(c) != columns_.has(first)) {
          throw BadLine{fmt::format("columns '{}', '{}' and '{}' must be given together",
                                    kNames[first], kNames[first + 1u], kNames[first + 2u])};
        }
      }
    }
    read_unit(header);
  }

  LuminaireEntry read_line(const CsvRecord& record) {
    if (record.cells.size() != columns_.width()) {
      throw BadLine{fmt::format("expected {} values as in the first line, found {}",
                                columns_.width(), record.cells.size())};
    }
    record_ = &record;
    LuminaireEntry entry;
    entry.line = record.line;
    entry.name = cell(kName);
    entry.type = cell(kType);
    entry.group = cell(kGroup);
    if (!is_id(entry.name)) {
      throw BadLine{
          fmt::format("the name '{}' is not an id; allowed are letters, digits and _ . : -",
                      shorten_utf8(entry.name, 40))};
    }
    if (entry.type.empty()) throw BadLine{"the type is empty"};
    entry.position_m = metres_ * glm::dvec3(number_in(kX), number_in(kY), number_in(kZ));
    entry.axis = optional_vector(kAxisX);
    entry.aim_m = optional_vector(kAimX);
    if (entry.aim_m) *entry.aim_m *= metres_;
    if (entry.axis && entry.aim_m) {
      throw BadLine{"the luminaire has both an axis and an aim; give only one of them"};
    }
    if (entry.axis && glm::length(*entry.axis) < kShortestAim) {
      throw BadLine{"the axis is zero; it must be a direction"};
    }
    if (entry.aim_m && glm::distance(*entry.aim_m, entry.position_m) < kShortestAim) {
      throw BadLine{"the aim is the luminaire's own position; it must be another point"};
    }
    if (!cell(kRotation).empty()) entry.rotation_rad = radians_from_degrees(number_in(kRotation));
    const auto [first, is_new] = line_of_name_.try_emplace(entry.name, entry.line);
    if (!is_new) {
      throw BadLine{fmt::format("the name '{}' is also in line {}", entry.name, first->second)};
    }
    return entry;
  }

 private:
  // All lengths of a file are in one unit.
  void read_unit(const CsvRecord& header) {
    std::string_view first;
    for (const CsvCell& cell : header.cells) {
      const std::optional<double> metres = length_column(cell.text).metres;
      if (!metres) continue;
      if (!first.empty() && *metres != metres_) {
        throw BadLine{fmt::format("columns '{}' and '{}' have different units", first, cell.text)};
      }
      first = cell.text;
      metres_ = *metres;
    }
  }

  const std::string& cell(Column column) const { return columns_.cell(*record_, column); }

  double number_in(Column column) const {
    const std::string& text = cell(column);
    const std::optional<double> number = parse_number(text);
    if (number && std::abs(*number) <= kCoordinate.high) return *number;
    throw BadLine{fmt::format("{} '{}' is not a number from -1e9 to 1e9{}", kNames[column],
                              shorten_utf8(text, 30), decimal_comma_hint(text))};
  }

  std::optional<glm::dvec3> optional_vector(Column first) const {
    const auto y = static_cast<Column>(first + 1u), z = static_cast<Column>(first + 2u);
    if (cell(first).empty() && cell(y).empty() && cell(z).empty()) return std::nullopt;
    return glm::dvec3(number_in(first), number_in(y), number_in(z));
  }

  CsvColumns columns_;
  double metres_ = 1.0;                // of the unit of the file
  const CsvRecord* record_ = nullptr;  // that is being read
  std::map<std::string, int> line_of_name_;
};

}  // namespace

std::optional<LuminaireList> parse_luminaire_list(std::string_view bytes, const std::string& name,
                                                  Diagnostics& diagnostics) {
  LuminaireList list;
  list.file = name;
  ListReader reader;
  CsvReader table(bytes);
  const std::optional<CsvRecord> header = table.next();
  if (report_csv_problem(table, name, diagnostics)) return std::nullopt;
  try {
    reader.read_header(header.value_or(CsvRecord{1, "", {CsvCell{}}}));
  } catch (const BadLine& bad) {
    diagnostics.report(DiagnosticId::luminaire_list_header, SourceLocation{name, 1, 0}, bad.what);
    return std::nullopt;
  }
  std::size_t bad_lines = 0;
  while (const std::optional<CsvRecord> record = table.next()) {
    if (record->is_blank()) continue;
    const SourceLocation where{name, record->line, 0};
    try {
      list.entry.push_back(reader.read_line(*record));
    } catch (const BadLine& bad) {
      if (++bad_lines > kBadLineLimit) {
        diagnostics.report(DiagnosticId::luminaire_list_gives_up, where, kBadLineLimit);
        break;
      }
      diagnostics.report(DiagnosticId::luminaire_list_line, where, bad.what);
    }
  }
  if (report_csv_problem(table, name, diagnostics) || bad_lines > 0) return std::nullopt;
  if (!list.entry.empty()) return list;
  diagnostics.report(DiagnosticId::luminaire_list_empty, SourceLocation{name, 0, 0});
  return std::nullopt;
}

}  // namespace calc
