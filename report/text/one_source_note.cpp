#include "report/text/one_source_note.h"

#include "calc/base/diagnostic_ids.h"
#include "report/document/one_source.h"
#include "report/text/clause_words.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

namespace report {
namespace {

// Rows of one standard: "EN 12464-1:2021" and "34.2", "36.1". Without rows: a whole name.
struct StandardRows {
  std::string standard;
  std::vector<std::string> rows;
};

// Of "TITLE:EDITION ROW", as clauses of rule packs are. Rows of several words stay whole names: a
// list of them with commas could be read in two ways.
StandardRows split_clause(const std::string& name) {
  const std::size_t edition = name.find(':');
  const std::size_t end = edition == std::string::npos ? edition : name.find(' ', edition);
  if (end == std::string::npos || name.find(' ', end + 1) != std::string::npos) return {name, {}};
  return {name.substr(0, end), {name.substr(end + 1)}};
}

void add_split(StandardRows added, std::vector<StandardRows>& list) {
  const auto known = std::find_if(list.begin(), list.end(), [&](const StandardRows& one) {
    return !one.rows.empty() && one.standard == added.standard;
  });
  if (added.rows.empty() || known == list.end()) {
    list.push_back(std::move(added));
  } else {
    known->rows.push_back(std::move(added.rows.front()));
  }
}

// "EN 12464-1:2021 34.2, 36.1; EN 1838:2024 escape route"
std::string named_rows(const Texts& t, const std::vector<calc::Message>& rows) {
  std::vector<StandardRows> list;
  const std::size_t named = std::min(rows.size(), kMostOneSourceRows);
  for (std::size_t i = 0; i < named; ++i)
    add_split(split_clause(printable(clause_words(t, rows[i], rules::LimitSource::pack))), list);
  std::string words;
  for (const StandardRows& one : list) {
    words += (words.empty() ? "" : "; ") + one.standard;
    if (!one.rows.empty()) words += fmt::format(" {}", fmt::join(one.rows, ", "));
  }
  const std::size_t more = rows.size() - named;
  return more == 0 ? words : t.say<Text::names_and_more>(words, more);
}

}  // namespace

std::string one_source_note(const Texts& t, const std::vector<calc::Message>& rows) {
  if (rows.empty()) return {};
  const std::string named = named_rows(t, rows);
  return rows.size() == 1 ? t.say<Text::one_source_row>(named)
                          : t.say<Text::one_source_rows>(rows.size(), named);
}

void warn_of_one_source(const std::vector<calc::Message>& rows, const std::string& path,
                        std::vector<calc::Diagnostic>& diagnostics) {
  if (rows.empty()) return;
  const std::string count = rows.size() == 1 ? "1 row" : fmt::format("{} rows", rows.size());
  calc::Diagnostics warning;
  warning.report(calc::DiagnosticId::one_source, {path, 0, 0}, count, named_rows({}, rows));
  diagnostics.insert(diagnostics.end(), warning.all().begin(), warning.all().end());
}

void warn_of_one_source(ProjectPart& project) {
  std::vector<calc::Message> rows;
  add_one_source_rows(project, rows);
  warn_of_one_source(rows, project.path, project.diagnostics);
}

}  // namespace report
