#include "report/formats/xlsx.h"

#include "report/document/luminaire_schedule.h"
#include "report/document/luminaire_totals.h"
#include "report/document/room_summary.h"
#include "report/formats/ci_finding.h"
#include "report/formats/table.h"
#include "report/revision/gate.h"
#include "report/revision/revision_tables.h"
#include "report/text/about_words.h"
#include "report/text/notices.h"
#include "report/text/number_format.h"
#include "report/text/room_causes.h"
#include "report/text/schedule_words.h"
#include "report/text/words.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr int kWrapFrom = 30;  // columns as wide as that hold sentences

ColumnRole role_of(std::string_view name) {
  if (name == "shown") return ColumnRole::verdict;
  return name == "counts" ? ColumnRole::counts : ColumnRole::other;
}

// Of a table, in an order for people: `first`, and after them all others as they come, without a
// verdict for data beside the one that people are shown.
class SheetOrder {
 public:
  SheetOrder(std::span<const TableColumn> columns, std::span<const std::string_view> first) {
    for (const std::string_view name : first) places_.push_back(column_of(columns, name));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool is_for_data = columns[i].name == "verdict";
      if (!is_for_data && std::find(places_.begin(), places_.end(), i) == places_.end())
        places_.push_back(i);
    }
    for (const std::size_t place : places_) {
      const TableColumn& column = columns[place];
      head_.push_back({std::string(column.heading), column.width, column.decimals,
                       column.width >= kWrapFrom, role_of(column.name)});
    }
    row_.resize(places_.size());
  }

  const std::vector<SheetColumn>& head() const { return head_; }
  // Valid until the next call.
  std::span<const TableCell> row(std::span<const TableCell> cells) {
    for (std::size_t i = 0; i < places_.size(); ++i) row_[i] = cells[places_[i]];
    return row_;
  }

 private:
  std::vector<std::size_t> places_;
  std::vector<SheetColumn> head_;
  std::vector<TableCell> row_;
};

constexpr std::array<std::string_view, 18> kResultsFirst{
    "shown",    "project", "space",  "plane",  "requirement", "quantity",
    "required", "value",   "low",    "high",   "unit",        "margin",
    "counts",   "reason",  "clause", "source", "waiver",      "note"};

TableCell count_cell(int count) { return static_cast<std::int64_t>(count); }

// --- Projects ------------------------------------------------------------------------------------

std::vector<SheetColumn> project_columns() {
  return {{"Verdict", 15, kOfColumn, false, ColumnRole::verdict},
          {"Project", 30, kOfColumn, true},
          {"Name", 24},
          {"Pass", 9},
          {"Fail", 9},
          {"Undecided", 11},
          {"Not judged", 11},
          {"Waived", 9},
          {"With a deviation", 11},
          {"Warnings", 10},
          {"That count", 10},
          {"Client and author", 50, kOfColumn, true}};
}

std::vector<TableCell> project_row(const ProjectPart& project) {
  const VerdictCounts counts = count_verdicts(project);
  const WarningCounts warnings = count_warnings(project);
  return {std::string(outcome_words(outcome_of(project))),
          project.path,
          project.name,
          count_cell(counts.pass),
          count_cell(counts.fail),
          count_cell(counts.undecided),
          count_cell(counts.not_judged),
          count_cell(counts.waived),
          count_cell(counts.deviating),
          count_cell(warnings.all),
          count_cell(warnings.strict),
          about_line({}, project.about)};
}

// --- Rooms ---------------------------------------------------------------------------------------

std::vector<SheetColumn> room_columns() {
  return {{"Verdict", 15, kOfColumn, false, ColumnRole::verdict},
          {"Room", 30, kOfColumn, true},
          {"Required", 10},
          {"Met", 8},
          {"Average (lx)", 12},
          {"Required (lx)", 12},
          {"Uo", 9},
          {"Required Uo", 12},
          {"UGR", 9},
          {"Required UGR", 12},
          {"Power (W/m²)", 12, 2},
          {"Why it does not pass", 80, kOfColumn, true},
          {"Project", 30, kOfColumn, true},
          {"Room id", 24}};
}

// A value and its limit; nothing where it is not asked.
void add_value(const rules::Finding* finding, std::vector<TableCell>& row) {
  if (finding == nullptr) {
    row.insert(row.end(), 2, TableCell());
    return;
  }
  const rules::Requirement& requirement = finding->requirement;
  if (finding->verdict == rules::Verdict::not_judged) {
    row.emplace_back();
  } else if (calc::is_nothing(finding->measured)) {
    row.emplace_back(std::string(english_text(Text::none)));
  } else if (is_below_scale(*finding)) {
    row.emplace_back(measured_words({}, *finding));
  } else {
    row.emplace_back(TableNumber{finding->measured.value});
  }
  row.emplace_back(format_required(Threshold{requirement.limit, requirement.comparison}, ""));
}

std::vector<TableCell> room_row(const ProjectPart& project, const RoomSummary& room) {
  std::vector<TableCell> row{std::string(outcome_words(room.outcome)),
                             std::string(report::title_of(room.space->name, room.space->id)),
                             count_cell(room.required), count_cell(room.met)};
  for (const rules::Finding* value : {room.average, room.uniformity, room.glare})
    add_value(value, row);
  const std::optional<double> power_w_m2 = room.space->power.density_w_m2();
  row.push_back(power_w_m2 ? TableCell(TableNumber{*power_w_m2}) : TableCell());
  std::string why;
  for (const RoomCause& cause : room.causes) {
    const CauseWords words = cause_words({}, room, cause);
    why += (why.empty() ? "" : "\n") + words.what;
    for (const std::string& more : words.more) why += "; " + more;
  }
  row.emplace_back(why);
  row.emplace_back(project.path);
  row.emplace_back(room.space->id);
  return row;
}

// --- Types ---------------------------------------------------------------------------------------

std::vector<SheetColumn> type_columns() {
  return {{"Project", 18},
          {"Position", 9},
          {"Type", 16},
          {"Maker", 18},
          {"Name", 24},
          {"Article number", 18},
          {"Luminous flux of one, new (lm)", 14},
          {"Power of one (W)", 12},
          {"Efficacy (lm/W)", 11, 0},
          {"Colour temperature (K)", 12},
          {"Ra", 8},
          {"Mounting height of the opening", 18},
          {"Count", 8},
          {"Rooms", 30, kOfColumn, true},
          {"Maintenance factor", 13},
          {"Luminous flux of all, new (lm)", 14},
          {"Power of all (W)", 12},
          {"Lamp", 18},
          {"Highest intensity (cd)", 12, 0},
          {"Material of the housing", 16},
          {"Depth of the housing (m)", 12, 3},
          {"Photometry file", 24},
          {"Format", 14},
          {"SHA-256 of the file", 20}};
}

TableCell stated(double value, bool is_stated) {
  return is_stated ? TableCell(TableNumber{value}) : TableCell();
}

std::vector<TableCell> type_row(const ProjectPart& project, const ScheduleRow& of) {
  const LuminaireRow& row = *of.type;
  const bool has_power = row.power_w > 0.0;
  return {project.path,
          of.position,
          row.type_id,
          row.maker,
          row.name,
          row.article(),
          TableNumber{row.flux_lm},
          stated(row.power_w, has_power),
          stated(row.flux_lm / row.power_w, has_power),
          colour_temperature_words(row),
          colour_rendering_words({}, row),
          mounting_words({}, of),
          count_cell(row.count),
          rooms_words({}, of),
          TableNumber{row.maintenance_factor},
          TableNumber{row.count * row.flux_lm},
          stated(row.count * row.power_w, has_power),
          row.lamp,
          TableNumber{row.max_intensity_cd},
          row.housing_material,
          stated(row.housing_depth_m, !row.housing_material.empty()),
          row.photometry_file,
          row.format,
          row.sha256};
}

// A line of words under the types that they are about.
std::vector<TableCell> type_remark(const ProjectPart& project, const std::string& words) {
  std::vector<TableCell> row(type_columns().size());
  row[0] = project.path;
  row[2] = words;
  return row;
}

std::vector<TableCell> type_totals(const ProjectPart& project, const LuminaireTotals& totals) {
  std::vector<TableCell> row = type_remark(project, "All luminaires");
  row[12] = count_cell(totals.count);
  row[15] = TableNumber{totals.flux_lm};
  row[16] = stated(totals.power_w, totals.is_power_known);
  return row;
}

// The types that are used, what they add up to and what must be read with it.
std::vector<std::vector<TableCell>> type_rows(const ProjectPart& project) {
  std::vector<std::vector<TableCell>> rows;
  if (project.luminaires.empty()) return rows;
  const LuminaireSchedule schedule = schedule_of(project);
  for (const ScheduleRow& row : schedule.used) rows.push_back(type_row(project, row));
  rows.push_back(type_totals(project, schedule.totals));
  for (const std::string& words : schedule_remarks({}, schedule))
    rows.push_back(type_remark(project, words));
  return rows;
}

// --- Warnings ------------------------------------------------------------------------------------

std::vector<SheetColumn> warning_columns() {
  return {{"Kind", 18, kOfColumn, false, ColumnRole::verdict},
          {"Project", 24},
          {"Where", 30, kOfColumn, true},
          {"Message", 90, kOfColumn, true},
          {"Id", 24}};
}

// What must be read with the verdicts.
struct Remark {
  std::string kind, where, words, id = {};
};

std::string place_text(const calc::SourceLocation& where) {
  std::string text = where.file;
  if (where.line > 0) text += fmt::format(":{}", where.line);
  if (where.column > 0) text += fmt::format(":{}", where.column);
  return text;
}

void add_plane_remarks(const std::string& room, const PlanePart& plane,
                       std::vector<Remark>& remarks) {
  const std::string where = room + " / " + std::string(report::title_of(plane.name, plane.id));
  if (!plane.is_computed) remarks.push_back({"not computed", where, plane.reason.english()});
  for (const rules::Finding& finding : plane.findings) {
    const std::string place = where + " / " + finding.requirement.id;
    if (finding.is_close) remarks.push_back({"close", place, close_words(finding)});
    if (finding.is_waived)
      remarks.push_back(
          {"waived", place, rules::waiver_words(*finding.requirement.waiver).english()});
  }
}

std::vector<Remark> remarks_of(const ProjectPart& project) {
  std::vector<Remark> remarks;
  for (const calc::Diagnostic& message : project.diagnostics) {
    const char* kind = !is_warning(message)                  ? "error"
                       : is_strict_warning(project, message) ? "strict warning"
                                                             : "warning";
    remarks.push_back({kind, place_text(message.where), message.message,
                       std::string(calc::diagnostic_name(message.id))});
  }
  for (const SpacePart& space : project.spaces) {
    const std::string room(report::title_of(space.name, space.id));
    for (const Notice& notice : notices_of(space)) {
      if (notice.kind == NoticeKind::row || notice.kind == NoticeKind::left_out) continue;
      remarks.push_back({std::string(calc::name_of(notice.kind)), notice_place({}, notice),
                         notice_words({}, notice)});
    }
    for (const PlanePart& plane : space.planes) add_plane_remarks(room, plane, remarks);
  }
  for (const std::string& words : ci_left_out(project)) remarks.push_back({"left out", "", words});
  return remarks;
}

// --- Summary -------------------------------------------------------------------------------------

const char* same_bits_text(SameBits same_bits) {
  switch (same_bits) {
    case SameBits::any_processor:
      return english_text(Text::repeatable);
    case SameBits::same_device:
      return english_text(Text::repeatable_on_device);
    case SameBits::nowhere:
      break;
  }
  return english_text(Text::not_repeatable);
}

// "2027-01-31T12:00:00Z" alone is a date for the properties of a file.
bool is_moment(std::string_view text) {
  constexpr std::string_view kLike = "0000-00-00T00:00:00Z";
  if (text.size() != kLike.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    if (kLike[i] == '0' ? !is_digit : text[i] != kLike[i]) return false;
  }
  return true;
}

// What a revision changed, as the other formats for people tell it.
std::unique_ptr<SheetSeries> revision_sheet(const Document& revised, const SpillPlace& place) {
  const std::vector<RevisionTable> tables = revision_tables(revised, {}, kMostSheetRows / 4);
  std::size_t columns = 2;
  for (const RevisionTable& table : tables) columns = std::max(columns, table.head.size());
  auto sheet = std::make_unique<SheetSeries>(
      "Revision", std::vector<SheetColumn>(columns, {"", kWrapFrom, kOfColumn, true}), place,
      kMostSheetRows, SheetHead::without);
  const auto add = [&](const std::vector<std::string>& words, TextLook look) {
    std::vector<TableCell> row(columns);
    std::copy(words.begin(), words.end(), row.begin());
    sheet->add(row, look);
  };
  for (const RevisionTable& table : tables) {
    add({table.title}, TextLook::title);
    add(table.head, TextLook::head);
    for (const std::vector<std::string>& row : table.rows) add(row, TextLook::wrapped);
    if (table.left_out > 0)
      add({Texts().say<Text::more_left_out>(table.left_out)}, TextLook::wrapped);
  }
  for (const std::string& remark : revision_remarks(revised, {})) add({remark}, TextLook::plain);
  return sheet;
}

class XlsxWriter : public FormatWriter {
 public:
  XlsxWriter(const DocumentFrame& frame, const SpillPlace& place, std::size_t most_rows)
      : frame_(frame),
        place_(place),
        results_order_(results_table().columns, kResultsFirst),
        points_order_(points_table().columns, {}),
        luminaires_order_(luminaires_table().columns, {}),
        rooms_("Rooms", room_columns(), place, most_rows),
        projects_("Projects", project_columns(), place, most_rows),
        requirements_("Requirements", results_order_.head(), place, most_rows),
        points_("Points", points_order_.head(), place, most_rows),
        luminaires_("Luminaires", luminaires_order_.head(), place, most_rows),
        types_("Types", type_columns(), place, most_rows),
        warnings_("Warnings", warning_columns(), place, most_rows) {}

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  static constexpr std::size_t kMostRemarks = 100;  // in the summary; the sheet has all

  void add_remarks(const ProjectPart& project);
  void write_what(SheetSeries& summary) const;
  void write_counts(SheetSeries& summary, const DocumentEnd& end) const;
  void write_provenance(SheetSeries& summary, const Provenance& provenance) const;
  void write_reading(SheetSeries& summary, const Provenance& provenance) const;
  void write_remarks(SheetSeries& summary) const;
  std::vector<const SheetSeries*> tables() const {
    return {&rooms_, &projects_, &requirements_, &points_, &luminaires_, &types_, &warnings_};
  }

  const DocumentFrame& frame_;
  SpillPlace place_;
  SheetOrder results_order_, points_order_, luminaires_order_;
  SheetSeries rooms_, projects_, requirements_, points_, luminaires_, types_, warnings_;
  std::string title_;  // of the only project
  std::vector<AboutWords> about_;
  std::vector<std::pair<std::string, std::string>> first_remarks_;
};

void XlsxWriter::add(const ProjectPart& project) {
  for (const RoomSummary& room : room_summaries(project)) rooms_.add(room_row(project, room));
  projects_.add(project_row(project));
  results_table().rows(
      project, [&](std::span<const TableCell> row) { requirements_.add(results_order_.row(row)); });
  points_table().rows(project, [&](std::span<const TableCell> row) { points_.add(row); });
  luminaires_table().rows(project, [&](std::span<const TableCell> row) { luminaires_.add(row); });
  for (const std::vector<TableCell>& row : type_rows(project)) types_.add(row);
  add_remarks(project);
  if (frame_.paths.size() > 1) return;
  title_ = project.name;
  about_ = about_words({}, project.about);
}

void XlsxWriter::add_remarks(const ProjectPart& project) {
  for (const Remark& remark : remarks_of(project)) {
    const std::array<TableCell, 5> row{remark.kind, project.path, remark.where, remark.words,
                                       remark.id};
    warnings_.add(row);
    if (first_remarks_.size() >= kMostRemarks) continue;
    const std::string id = remark.id.empty() ? "" : " [" + remark.id + "]";
    first_remarks_.emplace_back(
        remark.kind, (remark.where.empty() ? "" : remark.where + ": ") + remark.words + id);
  }
}

void XlsxWriter::write_what(SheetSeries& summary) const {
  summary.add_pair("luxgate: lighting checked against requirements", {}, TextLook::title);
  if (frame_.paths.size() != 1) {
    summary.add_pair("Projects", static_cast<std::int64_t>(frame_.paths.size()));
    return;
  }
  summary.add_pair("Project", frame_.paths.front());
  if (!title_.empty()) summary.add_pair("Name", title_);
  for (const AboutWords& one : about_) summary.add_pair(one.name, one.words);
}

void XlsxWriter::write_counts(SheetSeries& summary, const DocumentEnd& end) const {
  const Totals& totals = end.totals;
  const bool is_revised = frame_.revised != nullptr;
  const rules::Outcome outcome = is_revised ? gate_outcome(*frame_.revised) : totals.outcome;
  summary.add_pair("Verdict", std::string(outcome_words(outcome)));
  if (is_revised) {
    for (const std::string& remark : revision_remarks(*frame_.revised, {}))
      summary.add_pair("Against the earlier result", remark);
  }
  summary.add_pair("In words", summary_words(totals));
  const std::string selection = selection_words(end.provenance);
  if (!selection.empty()) summary.add_pair("Only a part", selection);
  for (const calc::Diagnostic& error : document_errors(end)) {
    summary.add_pair("Error", calc::format_diagnostic(error));
  }
  summary.add_pair("Pass", count_cell(totals.verdicts.pass));
  summary.add_pair("Fail", count_cell(totals.verdicts.fail));
  summary.add_pair("Undecided", count_cell(totals.verdicts.undecided));
  summary.add_pair("Not judged", count_cell(totals.verdicts.not_judged));
  summary.add_pair("Waived", count_cell(totals.verdicts.waived));
  summary.add_pair("With a deviation from the standard", count_cell(totals.verdicts.deviating));
  summary.add_pair("Rows of standards that are asked in part", count_cell(totals.rows_in_part));
  summary.add_pair("Projects that could not be judged", count_cell(totals.projects_not_judged));
  summary.add_pair("Warnings", count_cell(totals.warnings.all));
  summary.add_pair("Warnings that count", count_cell(totals.warnings.strict));
}

void XlsxWriter::write_provenance(SheetSeries& summary, const Provenance& provenance) const {
  const auto add_words = [&summary](const char* label, const std::string& words) {
    if (!words.empty()) summary.add_pair(label, words);
  };
  summary.add_pair("Where it comes from", {}, TextLook::title);
  summary.add_pair("Program", "luxgate " + provenance.program_version);
  summary.add_pair("Version of the numbers", count_cell(provenance.numbers_version));
  summary.add_pair("Command", provenance.command_line);
  add_words("Made", provenance.timestamp);
  add_words("Waivers and deviations are judged as of", provenance.judged_on);
  add_words("Policy", policy_words(provenance));
  add_words("SHA-256 of the policy", provenance.policy_sha256);
  add_words("Left out of paths", redaction_words(provenance));
  summary.add_pair("Backend", provenance.backend);
  add_words("Method", provenance.method);
  summary.add_pair("Seed", fmt::format("{}", provenance.seed));
  summary.add_pair("Confidence", format_percent(provenance.confidence));
  summary.add_pair("Goal", std::string(calc::name_of(provenance.goal)));
  summary.add_pair("Relative half-width aimed at", format_percent(provenance.tolerance));
  summary.add_pair("Light paths at most, of a plane and replicate",
                   static_cast<std::int64_t>(provenance.max_paths));
  summary.add_pair("Replicates", count_cell(provenance.replicates));
  summary.add_pair("Again the same", std::string(same_bits_text(provenance.same_bits)));
}

void XlsxWriter::write_reading(SheetSeries& summary, const Provenance& provenance) const {
  summary.add_pair("How to read it", {}, TextLook::title);
  summary.add_pair(
      "Low and high",
      fmt::format(
          "The value lies between them, with {} over all looks of a plane. A verdict looks at "
          "the whole interval, unless the notes of its requirement say something else.",
          format_percent(provenance.confidence)));
  summary.add_pair("Empty cells",
                   std::string("There is no value: not asked, not stated, not known or not "
                               "computed. It is never zero."));
  summary.add_pair("Points",
                   std::string("Maintained, with every luminaire at full output. Ratings of glare "
                               "are of the new installation."));
  std::size_t cut = summary.cut_texts();
  for (const SheetSeries* table : tables()) {
    cut += table->cut_texts();
    const std::string rows = fmt::format(
        "{} rows{}", table->rows(),
        table->sheets() == 1
            ? ""
            : fmt::format(" in {} sheets, '{}' to '{} {}': one sheet has no room for them",
                          table->sheets(), table->name(), table->name(), table->sheets()));
    summary.add_pair("Sheet " + table->name(), rows);
  }
  if (cut > 0) {
    summary.add_pair(
        "Cut texts",
        fmt::format("{} texts are longer than the {} characters that a cell may have, and "
                    "end with a remark; JSON has them whole",
                    cut, kMostCellCharacters));
  }
}

void XlsxWriter::write_remarks(SheetSeries& summary) const {
  summary.add_pair("Warnings and doubts", {}, TextLook::title);
  if (first_remarks_.empty()) summary.add_pair("", std::string("There are none."));
  for (const auto& [kind, words] : first_remarks_) summary.add_pair(kind, words);
  if (warnings_.rows() > first_remarks_.size()) {
    summary.add_pair("", fmt::format("{} more are in the sheet '{}'",
                                     warnings_.rows() - first_remarks_.size(), warnings_.name()));
  }
}

void XlsxWriter::finish(const DocumentEnd& end, Sink& sink) {
  SheetSeries summary("Summary", {{"", 46}, {"", 100, kOfColumn, true, ColumnRole::verdict}},
                      place_, kMostSheetRows, SheetHead::without);
  std::unique_ptr<SheetSeries> revision;
  const auto visit = [&](std::span<const TableCell> row) {
    requirements_.add(results_order_.row(row));
  };
  results_of_errors(end, visit);
  if (frame_.revised != nullptr) {
    results_of_revision(*frame_.revised, visit);
    revision = revision_sheet(*frame_.revised, place_);
  }
  write_what(summary);
  write_counts(summary, end);
  write_remarks(summary);
  write_provenance(summary, end.provenance);
  write_reading(summary, end.provenance);

  Workbook book;
  book.add(summary);
  for (SheetSeries* table :
       {&rooms_, &projects_, &requirements_, &points_, &luminaires_, &types_, &warnings_}) {
    book.add(*table);
  }
  if (revision) book.add(*revision);
  const Provenance& provenance = end.provenance;
  book.write({title_.empty() ? "luxgate" : title_, "luxgate " + provenance.program_version,
              is_moment(provenance.timestamp) ? provenance.timestamp : ""},
             place_, sink);
}

}  // namespace

std::unique_ptr<FormatWriter> xlsx_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          std::size_t most_rows) {
  return std::make_unique<XlsxWriter>(frame, place, most_rows);
}

}  // namespace report
