#include "report/formats/csv.h"

#include "report/text/aggregate_words.h"
#include "report/text/csv_field.h"
#include "report/text/number_format.h"
#include "report/text/words.h"

#include <cmath>
#include <initializer_list>
#include <string_view>

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

constexpr std::string_view kResultsHeader =
    "project,space,plane,requirement,quantity,percent,unit,scene,state,clause,comparison,limit,"
    "value,low,"
    "high,margin,verdict,reason,place_x_m,place_y_m,place_z_m\r\n";

constexpr std::string_view kPointsHeader =
    "project,space,plane,column,row,x_m,y_m,z_m,nx,ny,nz,illuminance_lx,low_lx,high_lx,direct_lx,"
    "indirect_lx,quantity,rating,rating_low,rating_high\r\n";

void add_finding(const std::string& place, const rules::Finding& finding, std::string& csv) {
  const rules::Requirement& requirement = finding.requirement;
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  const auto measured = [&](double value) { return is_judged ? number(value) : std::string(); };
  const auto coordinate = [&](int axis) {
    return is_judged && finding.place_m ? number((*finding.place_m)[axis]) : std::string();
  };
  const bool has_percent = requirement.metric == rules::Metric::percentile;
  add_row({place, field(requirement.id), std::string(calc::name_of(requirement.metric)),
           has_percent ? number(requirement.percent) : "", rules::unit_of(requirement),
           field(requirement.scene), std::string(calc::name_of(requirement.state)),
           field(requirement.clause), std::string(calc::name_of(requirement.comparison)),
           std::isnan(requirement.limit) ? "" : number(requirement.limit),
           measured(finding.measured.value), measured(finding.measured.low),
           measured(finding.measured.high), measured(finding.margin),
           rules::verdict_name(finding.verdict), field(finding.reason), coordinate(0),
           coordinate(1), coordinate(2)},
          csv);
}

void add_unjudged_project(const ProjectPart& project, std::string& csv) {
  add_row({field(project.path),
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           rules::verdict_name(rules::Verdict::not_judged),
           "could not be read or calculated",
           "",
           "",
           ""},
          csv);
}

// Without numbers: what is asked for and what was found are words.
void add_aggregate(const ProjectPart& project, const rules::AggregateFinding& finding,
                   std::string& csv) {
  std::string words = aggregate_required({}, finding) + ": " + aggregate_measured({}, finding);
  if (!finding.reason.empty()) words += "; " + finding.reason;
  add_row({field(project.path),
           field(finding.space_id),
           field(finding.plane_id),
           field(finding.id),
           std::string(calc::name_of(finding.kind)),
           "",
           "",
           "",
           "",
           field(finding.clause),
           "",
           "",
           "",
           "",
           "",
           "",
           rules::verdict_name(finding.verdict),
           field(words),
           "",
           "",
           ""},
          csv);
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
  add_row({field(project.path),
           "",
           "",
           field(calc::diagnostic_name(warning.id)),
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           "",
           is_strict_warning(project, warning) ? "strict warning" : "warning",
           field(calc::format_diagnostic(warning)),
           "",
           "",
           ""},
          csv);
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

}  // namespace

std::string render_results_csv(const Document& document) {
  std::string csv(kResultsHeader);
  for (const ProjectPart& project : document.projects) {
    if (!project.is_judged) add_unjudged_project(project, csv);
    for_each_plane(project, [&csv](const std::string& place, const PlanePart& plane) {
      for (const rules::Finding& finding : plane.findings) add_finding(place, finding, csv);
    });
    for (const rules::AggregateFinding& finding : project.aggregates) {
      add_aggregate(project, finding, csv);
    }
    for (const calc::Diagnostic& diagnostic : project.diagnostics) {
      if (is_warning(diagnostic)) add_warning(project, diagnostic, csv);
    }
  }
  return csv;
}

std::string render_points_csv(const Document& document) {
  std::string csv(kPointsHeader);
  for (const ProjectPart& project : document.projects) {
    for_each_plane(project, [&csv](const std::string& place, const PlanePart& plane) {
      for (const PointRow& point : plane.points) add_point(place, plane, point, csv);
    });
  }
  return csv;
}

}  // namespace report
