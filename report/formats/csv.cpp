#include "report/formats/csv.h"

#include "report/formats/ci_revision.h"
#include "report/text/aggregate_words.h"
#include "report/text/csv_field.h"
#include "report/text/number_format.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace report {
namespace {

std::string field(std::string_view text) { return csv_field(text); }
std::string number(double value) { return format_shortest(value); }

void add_row(std::initializer_list<std::string> fields, std::string& csv) {
  const char* separator = "";
  for (const std::string& text : fields) {
    csv += separator;
    csv += text;
    separator = ",";
  }
  csv += "\r\n";
}

// Columns of results.csv, in their order; new ones come at the end.
constexpr std::array<std::string_view, 27> kResultColumns{
    "project", "space",  "plane",   "requirement", "quantity",  "percent",   "unit",
    "scene",   "state",  "clause",  "comparison",  "limit",     "value",     "low",
    "high",    "margin", "verdict", "reason",      "place_x_m", "place_y_m", "place_z_m",
    "pack",    "row",    "check",   "severity",    "waiver",    "note"};

// A row of results.csv: what is not set is empty.
class ResultRow {
 public:
  // A name of kResultColumns, or else std::logic_error. text: as it stands in the file.
  void set(std::string_view column, std::string text) {
    const auto found = std::find(kResultColumns.begin(), kResultColumns.end(), column);
    if (found == kResultColumns.end()) throw std::logic_error("results.csv has no such column");
    cells_[static_cast<std::size_t>(found - kResultColumns.begin())] = std::move(text);
  }
  void add_to(std::string& csv) const { csv += fmt::format("{}\r\n", fmt::join(cells_, ",")); }

 private:
  std::array<std::string, kResultColumns.size()> cells_;
};

constexpr std::string_view kPointsHeader =
    "project,space,plane,column,row,x_m,y_m,z_m,nx,ny,nz,illuminance_lx,low_lx,high_lx,direct_lx,"
    "indirect_lx,quantity,rating,rating_low,rating_high\r\n";

// "A. Meier until 2027-01-31: temporary"
std::string waiver_text(const rules::Waiver& waiver) {
  return fmt::format("{} until {}: {}", waiver.owner, waiver.until, waiver.reason);
}

// "" without a waiver.
std::string waiver_words(const rules::Finding& finding) {
  const std::optional<rules::Waiver>& waiver = finding.requirement.waiver;
  if (!waiver) return {};
  return waiver_text(*waiver) + (finding.is_waived ? "" : " (does not apply)");
}

// What is required, and of what; space_id and plane_id may be "".
ResultRow row_of(const ProjectPart& project, const std::string& space_id,
                 const std::string& plane_id, const std::string& id, std::string_view quantity) {
  ResultRow row;
  row.set("project", field(project.path));
  row.set("space", field(space_id));
  row.set("plane", field(plane_id));
  row.set("requirement", field(id));
  row.set("quantity", std::string(quantity));
  return row;
}

void add_finding(ResultRow row, const rules::Finding& finding, std::string& csv) {
  const rules::Requirement& requirement = finding.requirement;
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  if (requirement.metric == rules::Metric::percentile) {
    row.set("percent", number(requirement.percent));
  }
  row.set("unit", rules::unit_of(requirement));
  row.set("scene", field(requirement.scene));
  row.set("state", std::string(calc::name_of(requirement.state)));
  row.set("clause", field(requirement.clause));
  row.set("comparison", std::string(calc::name_of(requirement.comparison)));
  if (!std::isnan(requirement.limit)) row.set("limit", number(requirement.limit));
  if (is_judged) {
    row.set("value", number(finding.measured.value));
    row.set("low", number(finding.measured.low));
    row.set("high", number(finding.measured.high));
    row.set("margin", number(finding.margin));
  }
  row.set("verdict", rules::verdict_name(finding.verdict));
  row.set("reason", field(finding.reason));
  if (is_judged && finding.place_m) {
    row.set("place_x_m", number(finding.place_m->x));
    row.set("place_y_m", number(finding.place_m->y));
    row.set("place_z_m", number(finding.place_m->z));
  }
  row.set("pack", field(requirement.origin.pack));
  row.set("row", field(requirement.origin.row));
  row.set("check", field(requirement.origin.check));
  row.set("severity", std::string(calc::name_of(requirement.severity)));
  row.set("waiver", field(waiver_words(finding)));
  row.set("note", field(note_words(finding)));
  row.add_to(csv);
}

void add_unjudged_project(const ProjectPart& project, std::string& csv) {
  ResultRow row;
  row.set("project", field(project.path));
  row.set("verdict", rules::verdict_name(rules::Verdict::not_judged));
  row.set("reason", "could not be read or calculated");
  row.add_to(csv);
}

// Of a building: a row as those of planes have, with "building ID" for a space, which no id can be.
// Else without numbers: what is asked for and what was found are words.
void add_aggregate(const ProjectPart& project, const rules::AggregateFinding& finding,
                   std::string& csv) {
  if (finding.kind == rules::AggregateKind::building) {
    const rules::Requirement& requirement = finding.sum->requirement;
    return add_finding(row_of(project, "building " + finding.building_id, "", requirement.id,
                              calc::name_of(requirement.metric)),
                       *finding.sum, csv);
  }
  std::string words = aggregate_required({}, finding) + ": " + aggregate_measured({}, finding);
  if (!finding.reason.empty()) words += "; " + finding.reason;
  ResultRow row =
      row_of(project, finding.space_id, finding.plane_id, finding.id, calc::name_of(finding.kind));
  row.set("clause", field(finding.clause));
  row.set("verdict", rules::verdict_name(finding.verdict));
  row.set("reason", field(words));
  row.add_to(csv);
}

// Ratings and ratios have columns of their own: what is called lx is lx.
void add_point(const std::string& place, const PlanePart& plane, const PointRow& point,
               std::string& csv) {
  const bool is_plain = calc::is_plain_number(plane.derived);
  const auto lux = [&](double value) { return is_plain ? "" : number(value); };
  const auto rating = [&](double value) { return is_plain ? number(value) : ""; };
  const calc::Estimate& value = point.measured;
  add_row({place, std::to_string(point.column), std::to_string(point.row),
           number(point.position_m.x), number(point.position_m.y), number(point.position_m.z),
           number(point.normal.x), number(point.normal.y), number(point.normal.z), lux(value.value),
           lux(value.low), lux(value.high), number(point.direct_lx), number(point.indirect_lx),
           std::string(calc::quantity_name(plane.kernel, plane.derived)), rating(value.value),
           rating(value.low), rating(value.high)},
          csv);
}

// A row like any other, so that a table shows it and a filter finds it: "warning" for a verdict.
void add_warning(const ProjectPart& project, const calc::Diagnostic& warning, std::string& csv) {
  ResultRow row;
  row.set("project", field(project.path));
  row.set("requirement", field(calc::diagnostic_name(warning.id)));
  row.set("verdict", is_strict_warning(project, warning) ? "strict warning" : "warning");
  row.set("reason", field(calc::format_diagnostic(warning)));
  row.add_to(csv);
}

// What became worse, and what is asked for less.
void add_change(const CiChange& change, std::string& csv) {
  ResultRow row;
  row.set("project", field(change.project));
  row.set("requirement", field(change.key));
  row.set("verdict", change.rule == "worse" ? "worse" : "weaker question");
  row.set("reason", field(change.message));
  row.add_to(csv);
}

// What of a row of a standard was never asked is a doubt, too.
void add_row_in_part(const ProjectPart& project, const SpacePart& space,
                     const rules::RowCoverage& coverage, std::string& csv) {
  ResultRow row;
  row.set("project", field(project.path));
  row.set("space", field(space.id));
  row.set("requirement", field(coverage.workplace));
  row.set("clause", field(coverage.clause));
  row.set("verdict", "in part");
  row.set("reason", field(coverage_words({}, coverage)));
  row.add_to(csv);
}

// What somebody leaves out of a row is to be read with it.
void add_left_out(const ProjectPart& project, const SpacePart& space,
                  const rules::RowCoverage& coverage, const rules::LeftOutZone& zone,
                  std::string& csv) {
  ResultRow row;
  row.set("project", field(project.path));
  row.set("space", field(space.id));
  row.set("plane", field(coverage.workplace + "." + zone.zone));
  row.set("clause", field(coverage.clause));
  row.set("verdict", "left out");
  row.set("waiver", field(waiver_text(zone.by)));
  row.add_to(csv);
}

void add_coverage(const ProjectPart& project, const SpacePart& space, std::string& csv) {
  for (const rules::RowCoverage& row : space.coverage) {
    if (!row.is_whole()) add_row_in_part(project, space, row, csv);
    for (const rules::RoleCoverage& role : row.roles) {
      for (const rules::LeftOutZone& zone : role.left_out) {
        if (!zone.has_ended) add_left_out(project, space, row, zone, csv);
      }
    }
  }
}

// Calls visit(place, plane) for every plane; place: the first three fields of a row.
template <class Visit>
void for_each_plane(const ProjectPart& project, Visit visit) {
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      visit(field(project.path) + "," + field(space.id) + "," + field(plane.id), plane);
    }
  }
}

std::string result_rows(const ProjectPart& project) {
  std::string csv;
  if (!project.is_judged) add_unjudged_project(project, csv);
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        const rules::Requirement& requirement = finding.requirement;
        add_finding(
            row_of(project, space.id, plane.id, requirement.id, calc::name_of(requirement.metric)),
            finding, csv);
      }
    }
  }
  for (const rules::AggregateFinding& finding : project.aggregates) {
    add_aggregate(project, finding, csv);
  }
  for (const SpacePart& space : project.spaces) add_coverage(project, space, csv);
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    if (is_warning(diagnostic)) add_warning(project, diagnostic, csv);
  }
  return csv;
}

class ResultsWriter : public FormatWriter {
 public:
  ResultsWriter(const DocumentFrame& frame, const SpillPlace& place) : frame_(frame), csv_(place) {
    csv_.write(fmt::format("{}\r\n", fmt::join(kResultColumns, ",")));
  }

  void add(const ProjectPart& project) override { csv_.write(result_rows(project)); }
  void finish(const DocumentEnd& /*end*/, Sink& sink) override {
    csv_.copy_to(sink);
    if (frame_.revised == nullptr) return;
    std::string changes;
    for (const CiChange& change : ci_changes(*frame_.revised)) add_change(change, changes);
    sink.write(changes);
  }

 private:
  const DocumentFrame& frame_;
  Spill csv_;
};

class PointsWriter : public FormatWriter {
 public:
  explicit PointsWriter(const SpillPlace& place) : csv_(place) { csv_.write(kPointsHeader); }

  void add(const ProjectPart& project) override {
    for_each_plane(project, [this](const std::string& at, const PlanePart& plane) {
      std::string rows;
      for (const PointRow& point : plane.points) add_point(at, plane, point, rows);
      csv_.write(rows);
    });
  }
  void finish(const DocumentEnd& /*end*/, Sink& sink) override { csv_.copy_to(sink); }

 private:
  Spill csv_;
};

}  // namespace

std::unique_ptr<FormatWriter> results_csv_writer(const DocumentFrame& frame,
                                                 const SpillPlace& place) {
  return std::make_unique<ResultsWriter>(frame, place);
}

std::unique_ptr<FormatWriter> points_csv_writer(const DocumentFrame& /*frame*/,
                                                const SpillPlace& place) {
  return std::make_unique<PointsWriter>(place);
}

std::string render_results_csv(const Document& document) {
  return render_whole(document, results_csv_writer);
}

std::string render_points_csv(const Document& document) {
  return render_whole(document, points_csv_writer);
}

}  // namespace report
