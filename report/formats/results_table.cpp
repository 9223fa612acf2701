#include "calc/base/diagnostic_ids.h"
#include "report/document/one_source.h"
#include "report/formats/ci_revision.h"
#include "report/formats/table.h"
#include "report/text/aggregate_words.h"
#include "report/text/notices.h"
#include "report/text/one_source_note.h"
#include "report/text/sentences.h"
#include "report/text/shown_decimals.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace report {
namespace {

constexpr std::array kResultColumns{
    TableColumn{"project", "Project", 18},
    TableColumn{"space", "Space", 14},
    TableColumn{"plane", "Plane", 16},
    TableColumn{"requirement", "Requirement", 18},
    TableColumn{"quantity", "Quantity", 18},
    TableColumn{"percent", "Percentile (%)", 11},
    TableColumn{"unit", "Unit", 9},
    TableColumn{"scene", "Scene", 10},
    TableColumn{"state", "State", 12},
    TableColumn{"clause", "Clause", 24},
    TableColumn{"comparison", "Comparison", 12},
    TableColumn{"limit", "Limit (in the unit)", 12},
    TableColumn{"value", "Calculated (in the unit)", 12},
    TableColumn{"low", "Low (in the unit)", 12},
    TableColumn{"high", "High (in the unit)", 12},
    TableColumn{"margin", "Margin (% of the limit)", 12},
    TableColumn{"verdict", "Verdict", 15},
    TableColumn{"reason", "Reason", 45},
    TableColumn{"place_x_m", "Place x (m)", 10, 3},
    TableColumn{"place_y_m", "Place y (m)", 10, 3},
    TableColumn{"place_z_m", "Place z (m)", 10, 3},
    TableColumn{"pack", "Rule pack", 16},
    TableColumn{"row", "Row", 10},
    TableColumn{"check", "Check", 14},
    TableColumn{"severity", "Severity", 12},
    TableColumn{"waiver", "Waived by", 30},
    TableColumn{"note", "Notes (also trust in the requirement)", 45},
    TableColumn{"source", "Who says the limit", 14},
    TableColumn{"required", "Required", 14, kOfColumn, false},
    TableColumn{"counts", "Counts", 12, kOfColumn, false},
    TableColumn{"close", "Close to the limit", 30, kOfColumn, false},
    TableColumn{"what", "What", 22, kOfColumn, false},
    TableColumn{"shown", "Verdict", 15, kOfColumn, false}};

// What is not set is not there.
class ResultRow {
 public:
  // column: a name of kResultColumns, or else std::logic_error.
  void set(std::string_view column, std::string_view text) { put(column, std::string(text)); }
  void set(std::string_view column, double value) { put(column, TableNumber{value}); }
  void set(std::string_view column, const TableNumber& number) { put(column, number); }
  // Of data, and as it is told to people.
  void set_verdict(std::string_view verdict, std::string_view shown) {
    set("verdict", verdict);
    set("shown", shown);
  }
  void set_verdict(const Texts& t, Text words) { set_verdict(english_text(words), t[words]); }
  void visit_with(const VisitRow& visit) const { visit(cells_); }

 private:
  void put(std::string_view column, TableCell cell) {
    cells_[column_of(kResultColumns, column)] = std::move(cell);
  }

  std::array<TableCell, kResultColumns.size()> cells_;
};

// "A. Meier until 2027-01-31: temporary"
std::string waiver_text(const Texts& t, const rules::Waiver& waiver) {
  return t.say<Text::xlsx_waiver>(waiver.owner, waiver.until, waiver.reason);
}

// "" without a waiver.
std::string waiver_words(const Texts& t, const rules::Finding& finding) {
  const std::optional<rules::Waiver>& waiver = finding.requirement.waiver;
  if (!waiver) return {};
  return waiver_text(t, *waiver) + (finding.is_waived ? "" : t[Text::xlsx_waiver_idle]);
}

// Whether it sets the exit code, or why not.
const char* counts_words(const Texts& t, const rules::Finding& finding) {
  if (finding.is_waived) return t[Text::xlsx_counts_waived];
  switch (finding.requirement.severity) {
    case rules::Severity::advice:
      return t[Text::xlsx_counts_advice];
    case rules::Severity::in_aggregate:
      return t[Text::xlsx_counts_in_aggregates];
    case rules::Severity::shall:
      break;
  }
  return t[Text::xlsx_counts_yes];
}

// What is required, and of what; space_id and plane_id may be "".
ResultRow row_of(const ProjectPart& project, const std::string& space_id,
                 const std::string& plane_id, const std::string& id, std::string_view quantity) {
  ResultRow row;
  row.set("project", project.path);
  row.set("space", space_id);
  row.set("plane", plane_id);
  row.set("requirement", id);
  row.set("quantity", quantity);
  return row;
}

void add_numbers(const rules::Finding& finding, ResultRow& row) {
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  const int decimals = interval_decimals(finding.measured, rules::unit_of(requirement), threshold);
  row.set("value", TableNumber{finding.measured.value, decimals});
  row.set("low", TableNumber{finding.measured.low, decimals});
  row.set("high", TableNumber{finding.measured.high, decimals});
  row.set("margin", TableNumber{finding.margin, margin_decimals(finding.margin), true});
  if (finding.place_m) {
    row.set("place_x_m", finding.place_m->x);
    row.set("place_y_m", finding.place_m->y);
    row.set("place_z_m", finding.place_m->z);
  }
}

// Advice that is not kept to is no failure, for people.
const char* shown_verdict(const Texts& t, const rules::Finding& finding) {
  return is_outside_advice(finding) ? t[Text::advice_outside] : verdict_words(t, finding.verdict);
}

void add_finding(const Texts& t, ResultRow row, const rules::Finding& finding,
                 const VisitRow& visit) {
  const rules::Requirement& requirement = finding.requirement;
  if (const auto* of = std::get_if<rules::Percentile>(&requirement.arguments)) {
    row.set("percent", of->percent);
  }
  row.set("unit", rules::unit_of(requirement));
  row.set("scene", requirement.scene);
  row.set("state", calc::name_of(requirement.state));
  row.set("clause", sentence(t, without_one_source(requirement.clause)));
  row.set("source", calc::name_of(rules::source_of(requirement)));
  row.set("comparison", calc::name_of(requirement.comparison));
  if (!std::isnan(requirement.limit)) row.set("limit", requirement.limit);
  if (finding.verdict != rules::Verdict::not_judged) add_numbers(finding, row);
  row.set_verdict(rules::verdict_name(finding.verdict), shown_verdict(t, finding));
  row.set("reason", sentence(t, finding.reason));
  row.set("pack", requirement.origin.pack);
  row.set("row", requirement.origin.row);
  row.set("check", requirement.origin.check);
  row.set("severity", calc::name_of(requirement.severity));
  row.set("waiver", waiver_words(t, finding));
  row.set("note", note_words(t, finding));
  row.set("required", format_required(t, {requirement.limit, requirement.comparison},
                                      rules::unit_of(requirement)));
  row.set("counts", counts_words(t, finding));
  row.set("close", close_words(t, finding));
  row.visit_with(visit);
}

void add_unjudged_project(const Texts& t, const ProjectPart& project, const VisitRow& visit) {
  ResultRow row;
  row.set("project", project.path);
  row.set_verdict(t, Text::verdict_not_judged);
  row.set("reason", t[Text::xlsx_unread]);
  row.visit_with(visit);
}

// Of a building: a row as those of planes have, with "building ID" for a space, which no id can be.
// Else without numbers: what is asked for and what was found are words.
void add_aggregate(const Texts& t, const ProjectPart& project,
                   const rules::AggregateFinding& finding, const VisitRow& visit) {
  if (finding.kind == rules::AggregateKind::building) {
    const rules::Requirement& requirement = finding.sum->requirement;
    ResultRow row = row_of(project, "building " + finding.building_id, "", requirement.id,
                           calc::name_of(requirement.metric));
    row.set("what", quantity_words(t, requirement));
    return add_finding(t, row, *finding.sum, visit);
  }
  const std::string required = aggregate_required(t, finding);
  std::string words = required + t[Text::colon] + aggregate_measured(t, finding);
  if (!finding.reason.empty()) words += "; " + sentence(t, finding.reason);
  ResultRow row =
      row_of(project, finding.space_id, finding.plane_id, finding.id, calc::name_of(finding.kind));
  row.set("what", aggregate_title(t, finding));
  row.set("clause", sentence(t, without_one_source(finding.clause)));
  row.set("source", calc::name_of(rules::source_of_pack(finding.is_user_supplied)));
  row.set_verdict(rules::verdict_name(finding.verdict), verdict_words(t, finding.verdict));
  row.set("reason", words);
  row.set("required", required);
  row.visit_with(visit);
}

// A row like any other, so that a table shows it and a filter finds it: "warning" for a verdict.
void add_warning(const Texts& t, const ProjectPart& project, const calc::Diagnostic& warning,
                 const VisitRow& visit) {
  ResultRow row;
  row.set("project", project.path);
  row.set("requirement", calc::diagnostic_name(warning.id));
  row.set_verdict(t,
                  is_strict_warning(project, warning) ? Text::xlsx_strict_warning : Text::warning);
  row.set("reason", calc::format_diagnostic(warning));
  row.visit_with(visit);
}

// What must be read with the numbers, though it is of no single one. What of a row of a standard
// was never asked is a doubt, too.
void add_notice(const Texts& t, const ProjectPart& project, const Notice& notice,
                const VisitRow& visit) {
  if (notice.kind == NoticeKind::row) return;
  ResultRow row;
  row.set("project", project.path);
  row.set("space", notice.space->id);
  if (notice.plane != nullptr) row.set("plane", notice.plane->id);
  row.set_verdict(calc::name_of(notice.kind), notice_kind_words(t, notice.kind));
  if (notice.row != nullptr) {
    row.set("clause", sentence(t, notice.row->clause));
    row.set("source", calc::name_of(rules::source_of_pack(notice.row->is_user_supplied)));
  }
  if (notice.left_out != nullptr) {
    row.set("plane", notice.row->workplace + "." + notice.left_out->zone);
    row.set("waiver", waiver_text(t, notice.left_out->by));
  } else {
    if (notice.row != nullptr) row.set("requirement", notice.row->workplace);
    row.set("reason", notice_words(t, notice));
  }
  row.visit_with(visit);
}

void visit_results(const ProjectPart& project, const VisitRow& visit) {
  results_in({}, project, visit);
}

constexpr DocumentTable kResultsTable{kResultColumns, visit_results};

}  // namespace

std::size_t column_of(std::span<const TableColumn> columns, std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const TableColumn& column) { return column.name == name; });
  if (found == columns.end()) throw std::logic_error("this table has no such column");
  return static_cast<std::size_t>(found - columns.begin());
}

const DocumentTable& results_table() { return kResultsTable; }

const char* notice_kind_words(const Texts& t, NoticeKind kind) {
  switch (kind) {
    case NoticeKind::in_part:
      return t[Text::xlsx_kind_in_part];
    case NoticeKind::left_out:
      return t[Text::xlsx_kind_left_out];
    case NoticeKind::changed:
      return t[Text::xlsx_kind_changed];
    case NoticeKind::doubt:
      return t[Text::xlsx_kind_doubt];
    case NoticeKind::note:
    case NoticeKind::remark:
    case NoticeKind::row:
      break;
  }
  return t[Text::xlsx_kind_note];
}

void results_in(const Texts& t, const ProjectPart& project, const VisitRow& visit) {
  if (!project.is_judged) add_unjudged_project(t, project, visit);
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        const rules::Requirement& requirement = finding.requirement;
        ResultRow row =
            row_of(project, space.id, plane.id, requirement.id, calc::name_of(requirement.metric));
        row.set("what", quantity_words(t, requirement, plane.kernel));
        add_finding(t, row, finding, visit);
      }
    }
  }
  for (const rules::AggregateFinding& finding : project.aggregates)
    add_aggregate(t, project, finding, visit);
  for (const SpacePart& space : project.spaces) {
    std::vector<Notice> notices = notices_of(space);
    // Of rows first.
    std::stable_partition(notices.begin(), notices.end(),
                          [](const Notice& notice) { return notice.row != nullptr; });
    for (const Notice& notice : notices) add_notice(t, project, notice, visit);
  }
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    if (is_warning(diagnostic)) add_warning(t, project, diagnostic, visit);
  }
}

void results_of_errors(const Texts& t, const DocumentEnd& end, const VisitRow& visit) {
  for (const calc::Diagnostic& error : document_errors(end)) {
    ResultRow row;
    row.set("requirement", calc::diagnostic_name(error.id));
    row.set_verdict(t, Text::error);
    row.set("reason", calc::format_diagnostic(error));
    row.visit_with(visit);
  }
}

void result_of_one_source(const DocumentEnd& end, const VisitRow& visit) {
  const std::string note = one_source_note({}, end.totals.one_source_rows);
  if (note.empty()) return;
  ResultRow row;
  row.set("requirement", calc::diagnostic_name(calc::DiagnosticId::one_source));
  row.set_verdict({}, Text::xlsx_kind_note);
  row.set("reason", note);
  row.visit_with(visit);
}

void results_of_revision(const Texts& t, const Document& document, const VisitRow& visit) {
  for (const CiChange& change : ci_changes(document)) {
    ResultRow row;
    row.set("project", change.project);
    row.set("requirement", change.key);
    row.set_verdict(t, change.rule == "worse" ? Text::xlsx_kind_worse : Text::xlsx_kind_weaker);
    row.set("reason", change.message);
    row.visit_with(visit);
  }
}

}  // namespace report
