#include "rules/pack/import_rows.h"

#include "calc/base/csv.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "rules/pack/import_columns.h"
#include "rules/pack/import_plane.h"
#include "rules/pack/row_values.h"
#include "rules/pack/rule_pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rules {
namespace {

using calc::CsvRecord;
using calc::DiagnosticId;
using calc::XmlElement;

// A parameter of the pack with the columns of its numbers.
struct Parameter {
  const char* name;
  ImportColumnIndex required;
  std::optional<ImportColumnIndex> modified;  // none: one level only
  std::string_view confirmed;                 // as the column `confirmed` names it
  std::string_view confirmed_modified;
};
constexpr std::array kParameters{
    Parameter{"Em", kEmColumn, kEmModifiedColumn, "Em_required", "Em_modified"},
    Parameter{"Uo", kUoColumn, {}, "Uo", ""},
    Parameter{"Ra", kRaColumn, {}, "Ra", ""},
    Parameter{"RUGL", kRuglColumn, {}, "RUGL", ""},
    Parameter{"Ez", kEzColumn, {}, "Ez", ""},
    Parameter{"Ewall", kEwallColumn, {}, "Em_wall", ""},
    Parameter{"Eceiling", kEceilingColumn, {}, "Em_ceiling", ""},
};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// Returns whether the point in "1.000" may separate thousands, as in tables of many countries.
bool may_be_thousands(std::string_view text) {
  const std::size_t first = text.find('.');
  const std::string_view whole = text.substr(0, first);
  const auto are_digits = [](std::string_view part) {
    return std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  if (first == text.npos || whole.empty() || whole.size() > 3 || whole.front() == '0') return false;
  const std::string_view behind = text.substr(first + 1);
  return are_digits(whole) && behind.size() == 3 && are_digits(behind);
}

// XML text, and for each of its lines the line of the table that it comes from; 0 = none.
struct WrittenPack {
  std::string text;
  std::vector<int> table_line;

  void add(const std::string& line, int of_table) {
    text += line + "\n";
    table_line.push_back(of_table);
  }
};

void write_element(const XmlElement& element, int depth, int table_line, WrittenPack& out) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  std::string line = indent + "<" + element.name;
  for (const calc::XmlAttribute& attribute : element.attributes) {
    line += fmt::format(" {}=\"{}\"", attribute.name, escaped(attribute.value));
  }
  if (element.children.empty()) return out.add(line + "/>", table_line);
  out.add(line + ">", table_line);
  for (const XmlElement& child : element.children) {
    write_element(child, depth + 1, table_line, out);
  }
  out.add(indent + "</" + element.name + ">", table_line);
}

XmlElement element_of(std::string name,
                      const std::vector<std::pair<std::string, std::string>>& attributes) {
  XmlElement element;
  element.name = std::move(name);
  for (const auto& [key, value] : attributes) {
    if (!value.empty()) element.attributes.push_back({key, value, {}});
  }
  return element;
}

void set_attribute(XmlElement& element, const std::string& name, const std::string& value) {
  for (calc::XmlAttribute& attribute : element.attributes) {
    if (attribute.name != name) continue;
    attribute.value = value;
    return;
  }
  element.attributes.push_back({name, value, {}});
}

class Importer {
 public:
  Importer(const std::string& file, calc::Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  // Reads the header; returns false after an error.
  bool read_header(const CsvRecord& header) {
    columns_ = calc::CsvColumns(header, import_column_names(), import_column_name);
    for (const calc::CsvCell& cell : header.cells) {
      const auto& names = import_column_names();
      const auto known = std::find(names.begin(), names.end(), import_column_name(cell.text));
      if (known == names.end()) continue;
      written_[static_cast<std::size_t>(known - names.begin())] = cell.text;
    }
    for (const ImportColumn& column : import_columns()) {
      if (!column.is_needed || columns_.has(index_of(column))) continue;
      report(header, fmt::format("column '{}' is missing; 'luxgate rules import --help' lists its "
                                 "allowed names",
                                 column.name));
    }
    if (!columns_.doubled().empty()) {
      const std::string& doubled = columns_.doubled();
      report(header, fmt::format("column '{}' is given twice, also as '{}'", doubled,
                                 import_column_name(doubled)));
    }
    if (diagnostics_.has_errors()) return false;
    warn_of_header(header);
    return true;
  }

  // Reads a row; empty for an omitted row, and after an error.
  std::optional<XmlElement> read_row(const CsvRecord& record) {
    if (record.cells.size() != columns_.width()) {
      report(record, fmt::format("the row has {} fields, the first line has {}",
                                 record.cells.size(), columns_.width()));
      return std::nullopt;
    }
    const std::string ref = columns_.cell(record, kRefColumn);
    if (ref.empty() || columns_.cell(record, kStatusColumn) == "dropped_in_final") {
      diagnostics_.report(DiagnosticId::rule_import_skipped, {file_, record.line, 0},
                          ref.empty() ? columns_.cell(record, kNameColumn) : ref,
                          ref.empty() ? fmt::format("the row has no {}", written_[kRefColumn])
                                      : "the row is not in the published edition");
      ++left_out_;
      return std::nullopt;
    }
    const std::optional<TaskPlane> plane = read_plane(record);
    check_em(record);
    std::string name = columns_.cell(record, kGroupColumn);
    name += (name.empty() ? "" : ": ") + columns_.cell(record, kNameColumn);
    std::string note = columns_.cell(record, kNotesColumn);
    if (const std::string sources = columns_.cell(record, kSourcesColumn); !sources.empty()) {
      note += (note.empty() ? "sources: " : "; sources: ") + sources;
    }
    const std::string trust = row_trust(record);
    XmlElement row = element_of(
        "row",
        {{"ref", ref}, {"name", name}, {"trust", trust}, {"sources", "table"}, {"note", note}});
    if (plane && plane->heights_m) {
      set_attribute(
          row, "task-heights",
          fmt::format("{:.6g} {:.6g}", plane->heights_m->lowest_m, plane->heights_m->highest_m));
    }
    if (plane && plane->is_upright) set_attribute(row, "task-orientation", std::string(kUpright));
    for (const Parameter& parameter : kParameters) {
      row.children.push_back(value(record, parameter, trust));
    }
    if (plane) count(*plane);
    return row;
  }

  // Returns the heading of the column of a number of the pack, as written.
  const std::string& head_of(std::string_view parameter, bool is_modified) const {
    const auto is_it = [&](const Parameter& p) { return p.name == parameter; };
    const Parameter& found = *std::find_if(kParameters.begin(), kParameters.end(), is_it);
    return written_[is_modified ? *found.modified : found.required];
  }

  int floor_rows() const { return floor_rows_; }
  int upright_rows() const { return upright_rows_; }
  int left_out() const { return left_out_; }

 private:
  static std::size_t index_of(const ImportColumn& column) {
    return static_cast<std::size_t>(&column - import_columns().data());
  }

  void report(const CsvRecord& record, const std::string& problem) {
    diagnostics_.report(DiagnosticId::rule_import, {file_, record.line, 0}, problem);
  }

  void warn(const CsvRecord& record, const std::string& problem) {
    diagnostics_.report(DiagnosticId::rule_import_doubtful, {file_, record.line, 0}, problem);
  }

  // Warns of ignored columns, and of values that no row will require.
  void warn_of_header(const CsvRecord& header) {
    for (const std::string& name : columns_.unknown()) {
      warn(header,
           fmt::format("unknown column '{}' is ignored{}", name, import_column_suggestion(name)));
    }
    std::vector<std::string_view> missing;
    for (const Parameter& parameter : kParameters) {
      if (!columns_.has(parameter.required)) {
        missing.push_back(import_column_names()[parameter.required]);
      }
    }
    if (!missing.empty()) {
      warn(header, fmt::format("column {} is missing; no row requires its value",
                               calc::join_choices(missing)));
    }
    if (!columns_.has(kPlaneColumn)) {
      warn(header,
           "column plane is missing; every row is read as a horizontal task at desk height, "
           "also corridors and shelves");
    }
  }

  // Reads the plane; empty after an error.
  std::optional<TaskPlane> read_plane(const CsvRecord& record) {
    const std::string& text = columns_.cell(record, kPlaneColumn);
    std::optional<TaskPlane> plane = parse_task_plane(text);
    if (!plane) {
      report(record, fmt::format("column '{}': unknown place '{}'; allowed: {}; 'luxgate rules "
                                 "import --help' lists more words",
                                 written_[kPlaneColumn], text, task_plane_choices()));
    }
    return plane;
  }

  void count(const TaskPlane& plane) {
    if (plane.is_upright) {
      ++upright_rows_;
    } else if (plane.heights_m && plane.heights_m->lowest_m == 0.0) {
      ++floor_rows_;
    }
  }

  // Checks that a row without Em gives a reason.
  void check_em(const CsvRecord& record) {
    if (!columns_.cell(record, kEmColumn).empty()) return;
    if (!columns_.cell(record, kEmModifiedColumn).empty()) {
      report(record, fmt::format("column '{}' is empty, but column '{}' is not",
                                 written_[kEmColumn], written_[kEmModifiedColumn]));
    } else if (columns_.cell(record, kNotesColumn).empty()) {
      report(record, fmt::format("column '{}' is empty; state in '{}' why the row requires no "
                                 "illuminance of its task, or delete the row",
                                 written_[kEmColumn], import_column_names()[kNotesColumn]));
    }
  }

  std::string row_trust(const CsvRecord& record) const {
    const std::string mark = columns_.cell(record, kTrustColumn);
    if (calc::find_value<Trust>(mark)) return mark;
    const bool is_single = mark == "A-part" || mark.starts_with('B') || !columns_.has(kTrustColumn);
    const Trust trust = is_single ? Trust::single_source : Trust::unverified;
    return std::string(calc::name_of(mark == "A" ? Trust::confirmed : trust));
  }

  bool is_confirmed(const CsvRecord& record, std::string_view name) const {
    const std::string all = ";" + columns_.cell(record, kConfirmedColumn) + ";";
    return name.empty() || all.find(fmt::format(";{};", name)) != std::string::npos;
  }

  std::string number(const CsvRecord& record, ImportColumnIndex column) {
    const std::string& text = columns_.cell(record, column);
    if (!text.empty() && !calc::parse_number(text)) {
      report(record, fmt::format("column '{}': '{}' is not a number{}", written_[column], text,
                                 calc::decimal_comma_hint(text)));
    } else if (may_be_thousands(text)) {
      const std::size_t point = text.find('.');
      report(record, fmt::format("column '{}': '{}' is ambiguous, {:.6g} or {}{}; write it without "
                                 "three digits after a point",
                                 written_[column], text, *calc::parse_number(text),
                                 text.substr(0, point), text.substr(point + 1)));
    }
    return text;
  }

  XmlElement value(const CsvRecord& record, const Parameter& parameter, const std::string& trust) {
    const std::string required = number(record, parameter.required);
    if (required.empty()) {
      return element_of("value", {{"of", parameter.name}, {"none", "not-specified"}});
    }
    const std::string modified = parameter.modified ? number(record, *parameter.modified) : "";
    const bool is_better = columns_.cell(record, kTrustColumn) == "A-part" &&
                           is_confirmed(record, parameter.confirmed) &&
                           (modified.empty() || is_confirmed(record, parameter.confirmed_modified));
    const std::string own = is_better ? std::string(calc::name_of(Trust::confirmed)) : trust;
    return element_of("value", {{"of", parameter.name},
                                {"required", required},
                                {"modified", modified},
                                {"trust", own == trust ? "" : own}});
  }

  const std::string& file_;
  calc::Diagnostics& diagnostics_;
  calc::CsvColumns columns_;
  std::array<std::string, kImportColumnCount> written_;  // heads of the table; "" = not there
  int floor_rows_ = 0, upright_rows_ = 0, left_out_ = 0;
};

struct ImportedRow {
  XmlElement element;
  int table_line = 0;
};

// Removes the special limits of a check for rows that the table does not have.
void keep_specials_of(const std::vector<ImportedRow>& rows, XmlElement& check) {
  const auto is_there = [&](const std::string& ref) {
    return std::any_of(rows.begin(), rows.end(), [&](const ImportedRow& row) {
      const calc::XmlAttribute* own = row.element.find("ref");
      return own != nullptr && own->value == ref;
    });
  };
  std::erase_if(check.children, [&](XmlElement& special) {
    const calc::XmlAttribute* named = special.find("rows");
    if (named == nullptr) return false;
    std::string kept, ref;
    std::istringstream refs(named->value);
    while (refs >> ref) kept += is_there(ref) ? (kept.empty() ? "" : " ") + ref : "";
    set_attribute(special, "rows", kept);
    return kept.empty();
  });
}

// Returns `like` without its sources and rows, with new ones before the first check.
WrittenPack assembled(XmlElement like, const std::string& pack_id, const std::string& csv_file,
                      const std::vector<ImportedRow>& rows) {
  set_attribute(like, "id", pack_id);
  set_attribute(like, "version", "1");
  set_attribute(like, "licence", "user-supplied");
  set_attribute(like, "licence-note", "imported from " + csv_file + "; not for redistribution");
  WrittenPack pack;
  pack.add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>", 0);
  const std::vector<XmlElement> children = std::exchange(like.children, {});
  write_element(like, 0, 0, pack);  // <rule-pack .../>, to be opened
  pack.text.replace(pack.text.size() - 3, 2, ">");
  write_element(element_of("source", {{"id", "table"}, {"note", "table of the user: " + csv_file}}),
                1, 0, pack);
  bool has_rows = false;
  for (const XmlElement& child : children) {
    if (child.name == "source" || child.name == "row") continue;
    if (child.name == "check" && !has_rows) {
      for (const ImportedRow& row : rows) write_element(row.element, 1, row.table_line, pack);
      has_rows = true;
    }
    XmlElement part = child;
    if (part.name == "check") keep_specials_of(rows, part);
    write_element(part, 1, 0, pack);
  }
  pack.add("</rule-pack>", 0);
  return pack;
}

// Reports errors of the pack at the lines of the table, where they can be corrected.
void report_for_table(const calc::Diagnostics& of_pack, const std::vector<int>& table_line,
                      const std::string& csv_file, calc::Diagnostics& diagnostics) {
  for (const calc::Diagnostic& diagnostic : of_pack.all()) {
    if (diagnostic.severity() != calc::Severity::error) continue;
    const auto line = static_cast<std::size_t>(diagnostic.where.line);
    const bool is_known = line >= 1 && line <= table_line.size();
    diagnostics.report(DiagnosticId::rule_import,
                       {csv_file, is_known ? table_line[line - 1] : 0, 0}, diagnostic.message);
  }
}

// Reports impossible or unlikely numbers by their columns.
void report_values(const RulePack& pack, const Importer& importer,
                   const std::vector<int>& table_line, const std::string& csv_file,
                   calc::Diagnostics& diagnostics) {
  for (const RowValueProblem& problem : row_value_problems(pack)) {
    const auto line = static_cast<std::size_t>(problem.value->where.line);
    diagnostics.report(
        problem.is_error ? DiagnosticId::rule_import : DiagnosticId::rule_import_doubtful,
        {csv_file, table_line.at(line - 1), 0},
        fmt::format("row '{}', column '{}': {}", problem.row->ref,
                    importer.head_of(problem.value->parameter, problem.is_of_modified),
                    problem.words));
  }
}

}  // namespace

std::optional<ImportedPack> import_rows(std::string_view csv, const std::string& csv_file,
                                        std::string_view like_xml, const std::string& pack_id,
                                        calc::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  std::vector<CsvRecord> records;
  calc::CsvReader table(csv);
  while (std::optional<CsvRecord> record = table.next()) {
    if (!record->is_blank()) records.push_back(std::move(*record));
  }
  if (const std::optional<calc::CsvProblem>& problem = table.problem()) {
    diagnostics.report(DiagnosticId::rule_import,
                       {csv_file, problem->place.line, problem->place.column}, problem->what);
    return std::nullopt;
  }
  if (records.size() < 2) {
    diagnostics.report(DiagnosticId::rule_import, {csv_file, 0, 0},
                       "the file needs a line of column names and at least one row");
    return std::nullopt;
  }
  Importer importer(csv_file, diagnostics);
  if (!importer.read_header(records.front())) return std::nullopt;
  std::vector<ImportedRow> rows;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const std::size_t errors = diagnostics.error_count();
    std::optional<XmlElement> row = importer.read_row(records[i]);
    // Of a row with an error nothing more is said; what is wrong with the others is told together.
    if (!row || diagnostics.error_count() > errors) continue;
    rows.push_back({std::move(*row), records[i].line});
  }
  const std::optional<XmlElement> like =
      calc::parse_xml(std::string(like_xml), "built in", diagnostics);
  if (!like) return std::nullopt;
  WrittenPack pack = assembled(*like, pack_id, csv_file, rows);
  calc::Diagnostics of_pack;
  const std::optional<RulePack> parsed = parse_rule_pack(pack.text, pack_id + ".xml", of_pack);
  if (!parsed) {
    report_for_table(of_pack, pack.table_line, csv_file, diagnostics);
    return std::nullopt;
  }
  report_values(*parsed, importer, pack.table_line, csv_file, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return ImportedPack{std::move(pack.text), static_cast<int>(rows.size()), importer.floor_rows(),
                      importer.upright_rows(), importer.left_out()};
}

}  // namespace rules
