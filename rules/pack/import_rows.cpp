#include "rules/pack/import_rows.h"

#include "calc/base/csv.h"
#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "rules/pack/rule_pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace rules {
namespace {

using calc::CsvRecord;
using calc::DiagnosticId;
using calc::XmlElement;

enum Column : std::size_t {
  kRef,
  kActivity,
  kTrust,
  kConfirmed,
  kEm,
  kEmModified,
  kUo,
  kRa,
  kRugl,
  kEz,
  kEwall,
  kEceiling,
  kRefConfidence,
  kGroup,
  kNotes,
  kSources,
  kColumns
};
constexpr std::array<std::string_view, kColumns> kNames{"final_ref",
                                                        "activity",
                                                        "trust",
                                                        "confirmed_fields",
                                                        "Em_required_lx",
                                                        "Em_modified_lx",
                                                        "Uo_min",
                                                        "Ra_min",
                                                        "RUGL_max",
                                                        "Ez_m_lx",
                                                        "Em_wall_lx",
                                                        "Em_ceiling_lx",
                                                        "final_ref_confidence",
                                                        "group",
                                                        "notes",
                                                        "sources"};
constexpr std::size_t kNeeded = kRefConfidence;  // the first that may be missing

// A parameter of the pack and where its numbers are.
struct Parameter {
  const char* name;
  Column required;
  std::optional<Column> modified;  // none: one level only
  std::string_view confirmed;      // as the column confirmed_fields names it
  std::string_view confirmed_modified;
};
constexpr std::array kParameters{
    Parameter{"Em", kEm, kEmModified, "Em_required", "Em_modified"},
    Parameter{"Uo", kUo, {}, "Uo", ""},
    Parameter{"Ra", kRa, {}, "Ra", ""},
    Parameter{"RUGL", kRugl, {}, "RUGL", ""},
    Parameter{"Ez", kEz, {}, "Ez", ""},
    Parameter{"Ewall", kEwall, {}, "Em_wall", ""},
    Parameter{"Eceiling", kEceiling, {}, "Em_ceiling", ""},
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

// XML text, and for each of its lines the line of the table that it was made of; 0 = none.
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

  // False after an error.
  bool read_header(const CsvRecord& header) {
    columns_ = calc::CsvColumns(header, kNames);
    for (std::size_t c = 0; c < kNeeded; ++c) {
      if (!columns_.has(c)) report(header, fmt::format("there is no column '{}'", kNames[c]));
    }
    if (!columns_.doubled().empty()) {
      report(header, fmt::format("the column '{}' is there twice", columns_.doubled()));
    }
    return !diagnostics_.has_errors();
  }

  // Empty for a row that is left out, and after an error.
  std::optional<XmlElement> read_row(const CsvRecord& record) {
    if (record.cells.size() != columns_.width()) {
      report(record, fmt::format("{} fields, but the first line has {}", record.cells.size(),
                                 columns_.width()));
      return std::nullopt;
    }
    const std::string ref = columns_.cell(record, kRef);
    if (ref.empty() || columns_.cell(record, kRefConfidence) == "dropped_in_final") {
      diagnostics_.report(
          DiagnosticId::rule_import_skipped, {file_, record.line, 0},
          ref.empty() ? columns_.cell(record, kActivity) : ref,
          ref.empty() ? "it has no final_ref" : "it is not in the published edition");
      return std::nullopt;
    }
    std::string name = columns_.cell(record, kGroup);
    name += (name.empty() ? "" : ": ") + columns_.cell(record, kActivity);
    std::string note = columns_.cell(record, kNotes);
    if (const std::string sources = columns_.cell(record, kSources); !sources.empty()) {
      note += (note.empty() ? "sources: " : "; sources: ") + sources;
    }
    const std::string trust = row_trust(record);
    XmlElement row = element_of(
        "row",
        {{"ref", ref}, {"name", name}, {"trust", trust}, {"sources", "table"}, {"note", note}});
    for (const Parameter& parameter : kParameters) {
      row.children.push_back(value(record, parameter, trust));
    }
    return row;
  }

 private:
  void report(const CsvRecord& record, const std::string& problem) {
    diagnostics_.report(DiagnosticId::rule_import, {file_, record.line, 0}, problem);
  }

  std::string row_trust(const CsvRecord& record) const {
    const std::string mark = columns_.cell(record, kTrust);
    const bool is_single = mark == "A-part" || mark.starts_with('B');
    const Trust trust = is_single ? Trust::single_source : Trust::unverified;
    return std::string(calc::name_of(mark == "A" ? Trust::confirmed : trust));
  }

  bool is_confirmed(const CsvRecord& record, std::string_view name) const {
    const std::string all = ";" + columns_.cell(record, kConfirmed) + ";";
    return name.empty() || all.find(fmt::format(";{};", name)) != std::string::npos;
  }

  std::string number(const CsvRecord& record, Column column) {
    const std::string& text = columns_.cell(record, column);
    if (!text.empty() && !calc::parse_number(text)) {
      report(record, fmt::format("{}: '{}' is not a number", kNames[column], text));
    }
    return text;
  }

  XmlElement value(const CsvRecord& record, const Parameter& parameter, const std::string& trust) {
    const std::string required = number(record, parameter.required);
    if (required.empty()) {
      return element_of("value", {{"of", parameter.name}, {"none", "not-specified"}});
    }
    const std::string modified = parameter.modified ? number(record, *parameter.modified) : "";
    const bool is_better = columns_.cell(record, kTrust) == "A-part" &&
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
};

struct ImportedRow {
  XmlElement element;
  int table_line = 0;
};

// Everything of `like` but its sources and rows, with new ones before the first check.
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
    write_element(child, 1, 0, pack);
  }
  pack.add("</rule-pack>", 0);
  return pack;
}

// What is wrong with the pack is wrong with the table: there it can be mended.
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

}  // namespace

std::optional<std::string> import_rows(std::string_view csv, const std::string& csv_file,
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
                       "a line with names of columns and at least one row are needed");
    return std::nullopt;
  }
  Importer importer(csv_file, diagnostics);
  if (!importer.read_header(records.front())) return std::nullopt;
  std::vector<ImportedRow> rows;
  for (std::size_t i = 1; i < records.size(); ++i) {
    if (std::optional<XmlElement> row = importer.read_row(records[i])) {
      rows.push_back({std::move(*row), records[i].line});
    }
  }
  const std::optional<XmlElement> like =
      calc::parse_xml(std::string(like_xml), "built in", diagnostics);
  if (!like || diagnostics.error_count() > errors_before) return std::nullopt;
  WrittenPack pack = assembled(*like, pack_id, csv_file, rows);
  calc::Diagnostics of_pack;
  if (!parse_rule_pack(pack.text, pack_id + ".xml", of_pack)) {
    report_for_table(of_pack, pack.table_line, csv_file, diagnostics);
    return std::nullopt;
  }
  return std::move(pack.text);
}

}  // namespace rules
