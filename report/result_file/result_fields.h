#pragma once
// The result file, said once: of each part of a document its keys, in the order in which they are
// written, with what they hold, where they may be missing and what the schema says of them. Four
// visitors go through it (describe.h): the writer (json.cpp), the reader (read_json.cpp), the
// schema (result_schema.cpp) and the redaction (redact.cpp). A new key is a line here.

#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/result_file/describe.h"
#include "report/text/words.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

void describe(auto& v, Is<calc::Estimate> auto& estimate) {
  v.is(
      "estimate",
      "A value and its confidence interval; low = value = high: exact. null: not a finite number.");
  v.field("value", or_null(estimate.value));
  v.field("low", or_null(estimate.low));
  v.field("high", or_null(estimate.high));
}

void describe(auto& v, Is<calc::SourceLocation> auto& where) {
  v.is("where", "A place in an input file; line and column count from 1, 0: not known.");
  v.field("file", where.file, {.holds = Holds::file});
  v.field("line", where.line);
  v.field("column", where.column);
}

void describe(auto& v, Is<VerdictCounts> auto& counts) {
  v.is("counts");
  v.field("pass", counts.pass);
  v.field("fail", counts.fail);
  v.field("undecided", counts.undecided);
  v.field("not_judged", counts.not_judged);
  v.field("waived", counts.waived);
  v.field(
      "with_deviations", counts.deviating,
      {.words =
           "Of all these: judged on a plane that is not quite the one that the rule pack means.",
       .presence = kSinceLater});
}

void describe(auto& v, Is<WarningCounts> auto& counts) {
  v.is("warnings");
  v.field("all", counts.all);
  v.field("strict", counts.strict, {.words = "Of them count like errors, by --strict."});
}

void describe(auto& v, Is<Provenance> auto& p) {
  v.is("provenance");
  v.field("program_version", p.program_version);
  v.field("command_line", p.command_line, {.words = "Makes the same numbers again."});
  v.field("seed", p.seed);
  v.field("confidence", p.confidence,
          {.words = "Of all intervals, over all looks of a plane.", .above = 0.0, .below = 1.0});
  v.field("goal", p.goal);
  v.field("tolerance", p.tolerance, {.words = "Relative half-width aimed at."});
  v.field("max_paths", p.max_paths);
  v.field("replicates", p.replicates);
  v.field("backend", p.backend);
  v.field(
      "numbers_version", p.numbers_version,
      {.words = "Raised whenever a change of the program moves results; the same version, input "
                "and seed give the same bits on the machines that same_bits_on names.",
       .least = 1.0});
  v.field(
      "same_bits_on", p.same_bits,
      {.words = "any-processor: any x86-64 processor. same-device: the same graphics device and "
                "driver. nowhere: time or an interruption cut the calculation short."});
  v.field("timestamp", p.timestamp,
          {.words = "Only if asked for.", .presence = only_if(!p.timestamp.empty())});
  v.field("redacted", p.is_redacted,
          {.words = "There if folders of files and names of graphics devices were left out.",
           .presence = only_if(p.is_redacted),
           .is_mark = true});
}

void describe(auto& v, Is<calc::Diagnostic> auto& diagnostic) {
  v.is("diagnostic");
  v.written("severity", [&] { return diagnostic.severity(); });
  std::string name = calc::diagnostic_name(diagnostic.id);
  v.field("id", name, {.words = "Stable name of the message."});
  const std::optional<calc::DiagnosticId> id = calc::diagnostic_from_name(name);
  v.refuse_if(!id, "id", "no message of this program has that id");
  assign(diagnostic.id, id.value_or(diagnostic.id));
  v.field("where", diagnostic.where);
  v.field("message", diagnostic.message, {.holds = Holds::prose});
}

void describe(auto& v, Is<calc::MaintenanceFactor> auto& factor) {
  v.field("product", factor.product);
  v.field("llmf", factor.llmf);
  v.field("lsf", factor.lsf);
  v.field("lmf", factor.lmf);
  v.field("rsmf", factor.rsmf);
  v.field("stated", factor.is_stated,
          {.words = "false: the project states none, and 1 is assumed.", .presence = kSinceLater});
}

void describe(auto& v, Is<LuminaireRow> auto& row) {
  v.is("luminaire");
  v.field("type", row.type_id);
  v.field("photometry_file", row.photometry_file, {.holds = Holds::own_file});
  v.field("sha256", row.sha256);
  v.field("name", row.name);
  v.field("format", row.format);
  v.field("count", row.count);
  v.field("flux_lm", or_null(row.flux_lm), {.words = "Of one luminaire, new, after any override."});
  v.field("power_w", or_null(row.power_w, 0.0), {.words = "null: not stated."});
  v.field("max_intensity_cd", or_null(row.max_intensity_cd));
  v.field("maintenance_factor", or_null(row.maintenance_factor));
  v.field("maintenance_parts", row.maintenance);
  const auto polar = [&](auto& o) {
    double step_deg = kPolarStep_deg;
    o.field("step_deg", step_deg);
    // Either nothing or every step.
    const auto is_whole = [&](const std::vector<double>& cd) {
      return cd.empty() || (step_deg == kPolarStep_deg && cd.size() == 2 * kPolarHalfSteps + 1);
    };
    constexpr const char* kNeeded = "145 values, 2.5 degrees apart, are needed";
    o.field("c0_cd", row.c0_cd);
    o.refuse_if(!is_whole(row.c0_cd), "c0_cd", kNeeded);
    o.field("c90_cd", row.c90_cd);
    o.refuse_if(!is_whole(row.c90_cd), "c90_cd", kNeeded);
  };
  v.object(
      "polar", polar,
      {.words = "Intensity of one luminaire over gamma from -180 (C180, C270) to 180 (C0, C90) "
                "degrees.",
       .presence = kSinceLater});
}

void describe(auto& v, Is<rules::DecisionPolicy> auto& policy) {
  v.field("compares_rounded", policy.compares_rounded);
  v.field("rounding", policy.rounding);
  v.field("illuminance_digits", policy.illuminance_digits);
  v.field("ratio_digits", policy.ratio_digits);
  v.field("other_digits", policy.other_digits);
  v.field("tolerance", policy.tolerance);
  v.field("tolerance_reason", policy.tolerance_reason, {.holds = Holds::prose});
  v.field("guard", policy.guard);
}

// Units of everything that can be required, each once.
inline std::vector<std::string_view> requirement_units() {
  std::vector<std::string_view> units;
  for (const auto& metric : calc::EnumNames<rules::Metric>::list) {
    const std::string_view unit = rules::metric_unit(metric.value);
    if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
  }
  return units;
}

// Of everything that somebody lives with: why, who, up to which day.
void describe_waiver(auto& v, Is<rules::Waiver> auto& waiver) {
  v.field("reason", waiver.reason);
  v.field("owner", waiver.owner);
  v.field("until", waiver.until, {.words = "The last day, YYYY-MM-DD."});
}

void describe(auto& v, Is<rules::Deviation> auto& deviation) {
  v.is("deviation");
  v.field("in", deviation.aspect);
  v.field("words", deviation.words, {.holds = Holds::prose});
  v.field("accepted", deviation.is_accepted,
          {.words = "The project states it, and its last day is not over."});
  const auto by = [&](auto& o) {
    rules::Waiver of = deviation.stated.value_or(rules::Waiver{});
    describe_waiver(o, of);
    assign(deviation.stated, of);
  };
  v.object("stated", by, {.presence = only_if(deviation.stated.has_value())});
}

void describe(auto& v, Is<rules::Finding> auto& finding) {
  auto& requirement = finding.requirement;
  v.is("finding");
  v.field("requirement", requirement.id, {.words = "Its id, unique within the plane."});
  v.field("quantity", requirement.metric, {.unknown = "no quantity has that name"});
  v.written("unit", [&] { return std::string_view(rules::unit_of(requirement)); },
            {.choices = requirement_units()});
  v.field("comparison", requirement.comparison);
  v.field("limit", or_null(requirement.limit));
  v.field("state", requirement.state);
  v.field("scene", requirement.scene, {.words = "'': every luminaire at full output."});
  v.field("clause", requirement.clause);
  v.field("where", requirement.where);
  v.field("verdict", finding.verdict);
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  v.refuse_if(is_judged && std::isnan(requirement.limit), "limit", "a number is needed");
  v.field("measured", finding.measured, {.null_if = !is_judged});
  v.field("margin", or_null(finding.margin),
          {.words = "(measured - limit) / limit, the sign turned for at_most: positive is good.",
           .null_if = !is_judged});
  v.field("is_close", finding.is_close, {.words = "Usual rounding would change the verdict."});
  v.field("place_m", finding.place_m, {.null_if = !is_judged});
  v.field("reason", finding.reason, {.holds = Holds::prose});
  v.written("note", [&] { return note_words(finding); },
            {.words = "What must be read with the finding, in words."});
  v.written("policy", [&] { return rules::policy_text(requirement.policy); },
            {.words = "How values are compared, in words."});
  v.field("decision", requirement.policy);
  v.field("requirement_note", requirement.note, {.holds = Holds::prose});
  v.field("severity", requirement.severity);
  v.field("direct_only", requirement.direct_only);
  v.field("by_tolerance", finding.by_tolerance);
  const auto waiver = [&](auto& o) {
    rules::Waiver of = requirement.waiver.value_or(rules::Waiver{});
    describe_waiver(o, of);
    assign(requirement.waiver, of);
    o.field("applies", finding.is_waived);
    const bool may_be_waived =
        finding.verdict == rules::Verdict::fail || finding.verdict == rules::Verdict::undecided;
    o.refuse_if(finding.is_waived && !may_be_waived, "applies",
                "only 'fail' and 'undecided' can be waived");
  };
  v.object("waiver", waiver, {.presence = only_if(requirement.waiver.has_value())});
  const auto rule = [&](auto& o) {
    o.field("pack", requirement.origin.pack, {.words = "With its edition: en12464-1:2021."});
    o.field("row", requirement.origin.row);
    o.field("check", requirement.origin.check);
  };
  v.object("rule", rule, {.presence = only_if(!requirement.origin.pack.empty())});
  v.field("deviations", requirement.deviations,
          {.words = "In what the plane is not the one that the rule pack's number is about.",
           .presence = only_if(!requirement.deviations.empty())});
  // The ends of a range have one name where they are in lx, and one where they have no unit.
  const bool is_share = requirement.metric == rules::Metric::share;
  const bool is_plain = calc::is_plain_number(requirement.derived);
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  v.field(
      "from", requirement.range.from,
      {.words = "Of quantities without unit, as to.", .presence = only_if(is_share && is_plain)});
  v.field("to", or_null(requirement.range.to, kOpen),
          {.words = "null: no upper end.", .presence = only_if(is_share && is_plain)});
  v.field("from_lx", requirement.range.from, {.presence = only_if(is_share && !is_plain)});
  v.field("to_lx", or_null(requirement.range.to, kOpen),
          {.words = "null: no upper end.", .presence = only_if(is_share && !is_plain)});
  const auto mask = [&](auto& o) {
    o.field("id", requirement.mask.id);
    o.field("points_used", finding.points_used);
  };
  v.object("mask", mask, {.presence = only_if(!requirement.mask.id.empty())});
  v.field("percent", requirement.percent,
          {.presence = only_if(requirement.metric == rules::Metric::percentile)});
  v.field("point_m", requirement.point_m, {.presence = only_if(requirement.point_m.has_value())});
}

void describe(auto& v, Is<calc::DroppedPoint> auto& point) {
  v.is("dropped");
  v.field("column", point.column);
  v.field("row", point.row);
  v.field("position_m", point.position_m);
  v.field("reason", point.reason);
  v.field("body", point.body, {.presence = only_if(!point.body.empty())});
}

// Of the grid and of the plane's area.
void describe_grid(auto& v, Is<PlanePart> auto& plane) {
  // As many as a plane may have; a file must not make pictures of any size.
  constexpr std::int64_t kMostCells = 4'000'000;
  auto& grid = plane.grid;
  v.is("grid");
  v.field("rule", grid.rule);
  v.field("columns", grid.columns);
  v.field("rows", grid.rows);
  v.refuse_if(std::int64_t{grid.columns} * grid.rows > kMostCells, "columns",
              "the grid has too many cells");
  v.field("spacing_u_m", grid.spacing_u_m);
  v.field("spacing_v_m", grid.spacing_v_m);
  v.field("margin_m", grid.margin_m);
  v.field("origin_m", grid.origin_m);
  v.field("u", grid.u);
  v.field("v", grid.v);
  v.field("outline_m", plane.outline_m);
  v.field("holes_m", plane.holes_m);
  v.field("dropped", grid.dropped);
}

inline std::vector<std::string_view> point_columns(calc::DerivedQuantity derived) {
  const bool is_plain = calc::is_plain_number(derived);
  return {"column",
          "row",
          "x_m",
          "y_m",
          "z_m",
          "nx",
          "ny",
          "nz",
          value_key(derived),
          is_plain ? "low" : "low_lx",
          is_plain ? "high" : "high_lx",
          "direct_lx",
          "indirect_lx"};
}

void describe_points(auto& v, Is<PlanePart> auto& plane) {
  using enum calc::DerivedQuantity;
  v.is("points", "Maintained illuminance of every luminaire at full output, one row per point.");
  v.written(
      "columns", [&] { return point_columns(plane.derived); },
      {.words = "ugr and modelling have no unit. Of ugr the light is the reflected light at the "
                "eye."},
      std::vector{point_columns(none), point_columns(ugr), point_columns(modelling)});
  v.rows("rows", plane.points, [&](auto& row, auto& p) {
    row(p.column, p.row, p.position_m.x, p.position_m.y, p.position_m.z, p.normal.x, p.normal.y,
        p.normal.z, or_null(p.measured.value), or_null(p.measured.low), or_null(p.measured.high),
        or_null(p.direct_lx), or_null(p.indirect_lx));
    // Pictures rely on it.
    const calc::SensorGrid& grid = plane.grid;
    row.refuse_if(grid.columns > 0 && (p.column >= grid.columns || p.row >= grid.rows),
                  "the cell is outside the grid");
  });
}

void describe(auto& v, Is<GroupShare> auto& share) {
  v.field("group", share.group);
  v.field("average_lx", share.average_lx);
  v.field("direct_lx", or_null(share.direct_lx));
}

void describe_light(auto& v, Is<LuminaireShare> auto& share) {
  v.field("average_lx", share.average_lx);
  v.field("direct_lx", or_null(share.direct_lx));
  v.field("minimum_lx", share.minimum_lx);
  v.field("minimum_direct_lx", or_null(share.minimum_direct_lx));
}

void describe(auto& v, Is<LuminaireShare> auto& share) {
  v.field("id", share.id);
  v.field("type", share.type_id);
  v.field("group", share.group);
  v.field("position_m", share.position_m);
  describe_light(v, share);
}

void describe(auto& v, Is<LuminaireShares> auto& shares) {
  v.field("minimum_at_m", shares.minimum_at_m,
          {.words = "Of the point with the least light, which minimum_lx and minimum_direct_lx are "
                    "of."});
  v.field("largest", shares.largest);
  const auto others = [&](auto& o) {
    o.field("count", shares.others, {.least = 2.0});
    describe_light(o, shares.rest);
  };
  v.object("others", others, {.presence = only_if(shares.others > 0)});
}

void describe(auto& v, Is<LookFinding> auto& finding) {
  v.field("verdict", finding.verdict);
  v.field("measured", finding.measured, {.null_if = finding.verdict == rules::Verdict::not_judged});
}

void describe(auto& v, Is<PlaneLook> auto& look) {
  v.field("paths", look.paths);
  v.field("rays", look.rays);
  v.field("points", look.points);
  v.field("average_lx", look.average);
  v.field("findings", look.findings, {.words = "In the order of the plane's findings."});
}

// Ratings and ratios of points have no average that would mean anything.
void describe_statistics(auto& v, Is<PlanePart> auto& plane) {
  const auto of_light = [&] {
    v.field("average_lx", plane.average);
    v.field("minimum_lx", plane.minimum);
    v.field("maximum_lx", plane.maximum);
    v.field("uniformity_min_avg", plane.uniformity_min_avg);
    v.field("uniformity_min_max", plane.uniformity_min_max);
  };
  const auto of_plain_numbers = [&] {
    v.field("minimum", plane.minimum);
    v.field("maximum", plane.maximum);
  };
  v.either(!calc::is_plain_number(plane.derived), of_light, of_plain_numbers);
}

// What only planes have that were computed.
void describe_results(auto& v, Is<PlanePart> auto& plane) {
  auto& counters = plane.counters;
  v.field("remarks", plane.remarks,
          {.words = "How the quantity was come by.",
           .presence = only_if(!plane.remarks.empty()),
           .holds = Holds::prose});
  v.object("statistics", [&](auto& o) { describe_statistics(o, plane); },
           {.words = "Of ugr and modelling, which have no unit: minimum and maximum alone."});
  v.field("stop", plane.stop, {.words = "Why the work on the plane ended."});
  v.written("looks", [&] { return counters.active_points.size(); });
  v.field("points_per_look", counters.active_points);
  v.field("looks_planned", plane.looks_planned);
  v.field("unseen_points", plane.unseen_points);
  v.field("single_sample_points", plane.single_sample_points);
  v.object("counters", [&](auto& o) {
    o.field("paths", counters.paths);
    o.field("direct_rays", counters.direct_rays);
    o.field("connection_rays", counters.connection_rays);
    o.field("near_rays", counters.near_rays);
  });
  v.field("groups", plane.groups,
          {.words = "Dimming groups, each alone at full output, maintained, reflections included; "
                    "averages add up to the plane's.",
           .presence = kSinceLater});
  v.field("by_luminaire", plane.by_luminaire,
          {.words = "Only if asked for: what single luminaires give, each alone at full output, "
                    "maintained, reflections included; averages of the largest and of all others "
                    "together add up to the plane's.",
           .presence = only_if(!plane.by_luminaire.largest.empty())});
  v.field("look_results", plane.looks,
          {.words = "The plane after each look at its growing results.", .presence = kSinceLater});
  const auto lacks_findings = [&](const PlaneLook& look) {
    return look.findings.size() != plane.findings.size();
  };
  v.refuse_if(std::any_of(plane.looks.begin(), plane.looks.end(), lacks_findings), "look_results",
              "each look needs as many findings as the plane has");
  v.object("grid", [&](auto& o) { describe_grid(o, plane); });
  v.object("points", [&](auto& o) { describe_points(o, plane); });
}

inline std::vector<std::string_view> plane_quantities() {
  std::vector<std::string_view> names;
  for (const calc::PlaneQuantity& known : calc::kPlaneQuantities) names.push_back(known.name);
  return names;
}

void describe(auto& v, Is<PlanePart> auto& plane) {
  v.is("plane");
  v.field("id", plane.id);
  v.field("name", plane.name);
  v.field("where", plane.where);
  // Two members have one name.
  std::string quantity(calc::quantity_name(plane.kernel, plane.derived));
  v.field("quantity", quantity,
          {.choices = plane_quantities(), .unknown = "no kind of point has that name"});
  for (const calc::PlaneQuantity& known : calc::kPlaneQuantities) {
    if (known.name != quantity) continue;
    assign(plane.kernel, known.kernel);
    assign(plane.derived, known.derived);
  }
  v.field("is_computed", plane.is_computed);
  v.field("reason", plane.reason, {.words = "Why it was not computed.", .holds = Holds::prose});
  v.field("findings", plane.findings);
  const auto zone = [&](auto& o) {
    o.field("made_by", plane.made_by, {.holds = Holds::prose});
    o.field("changed", plane.changed, {.holds = Holds::prose});
  };
  v.object("zone", zone,
           {.words = "Only of planes that a workplace has made: from what, and what the project "
                     "changed.",
            .presence = only_if(!plane.made_by.empty())});
  v.if_true("is_computed", plane.is_computed, [&] { describe_results(v, plane); });
}

void describe(auto& v, Is<LuminaireMark> auto& mark) {
  v.field("type", mark.type_id);
  v.field("position_m", mark.position_m);
  v.field("group", mark.group, {.presence = kSinceLater});
  v.field("outline_m", mark.outline_m,
          {.words = "Of the opening from above; empty: a point.", .presence = kSinceLater});
  v.field("c0", mark.c0, {.words = "x and y of the direction of C0.", .presence = kSinceLater});
}

void describe(auto& v, Is<BodyMark> auto& body) {
  v.field("id", body.id);
  v.field("low_z_m", body.low_z_m);
  v.field("high_z_m", body.high_z_m);
  v.field("lines_m", body.lines_m, {.words = "x1, y1, x2, y2 each."});
}

void describe(auto& v, Is<calc::InstalledPower> auto& power) {
  v.field("power_w", power.power_w);
  v.field("area_m2", power.area_m2);
  v.field("luminaires", power.luminaires);
  v.field("without_power", power.without_power);
}

void describe(auto& v, Is<calc::FluxBalance> auto& balance) {
  v.field("emitted_lm", or_null(balance.emitted_lm));
  v.field("untraced_lm", or_null(balance.untraced_lm));
  v.field("absorbed_lm", balance.absorbed_lm);
  v.field("escaped_lm", balance.escaped_lm);
}

void describe(auto& v, Is<rules::LeftOutZone> auto& zone) {
  v.is("left_out_zone");
  v.field("zone", zone.zone, {.words = "The role, or a part of it: wall.2."});
  describe_waiver(v, zone.by);
  v.field("has_ended", zone.has_ended,
          {.words = "The last day is over: the zone counts as not judged."});
}

void describe(auto& v, Is<rules::RoleCoverage> auto& role) {
  v.is("role_coverage");
  v.field("role", role.role);
  v.field("state", role.state);
  v.field("words", role.words, {.holds = Holds::prose});
  v.field("left_out", role.left_out,
          {.words = "What of the role the project leaves out.",
           .presence = only_if(!role.left_out.empty())});
}

void describe(auto& v, Is<rules::RowCoverage> auto& row) {
  v.is("row_coverage");
  v.field("workplace", row.workplace, {.words = "'': the require elements of the space's planes."});
  v.field("clause", row.clause);
  v.written("is_whole", [&] { return row.is_whole(); },
            {.words = "Nothing of the row was never asked."});
  v.written("is_met", [&] { return row.is_met(); });
  v.field("roles", row.roles);
}

void describe(auto& v, Is<SpacePart> auto& space) {
  v.is("space");
  v.field("id", space.id);
  v.field("name", space.name);
  v.field("footprint_m", space.footprint_m);
  v.field("floor_z_m", space.floor_z_m);
  v.field("power", space.power,
          {.words = "Installed power of the space's luminaires. without_power: how many of them "
                    "state none, which power_w is then without. area_m2: of the floor, 0 = not "
                    "known.",
           .presence = kSinceLater});
  v.field("height_m", space.height_m);
  v.field("triangles", space.triangles);
  v.field("degenerate_triangles", space.degenerate_triangles);
  v.field("luminaires", space.luminaires);
  v.field("bodies", space.bodies,
          {.words = "Furniture as seen from above.", .presence = kSinceLater});
  v.field("bodies_left_out", space.bodies_left_out,
          {.words = "Furniture that is too much to draw.", .presence = kSinceLater});
  v.field("flux_balance", space.balance);
  v.field("planes", space.planes);
  v.field("coverage", space.coverage,
          {.words = "What is asked of which rows of rule packs.",
           .presence = only_if(!space.coverage.empty())});
  v.field("notes", space.notes,
          {.words = "Zones of workplaces that were not made, and why.",
           .presence = only_if(!space.notes.empty()),
           .holds = Holds::prose});
}

void describe(auto& v, Is<rules::AggregateMember> auto& member) {
  v.field("name", member.name);
  v.field("verdict", member.verdict);
  v.field("is_waived", member.is_waived);
  v.field("area_m2", member.area_m2);
  v.field("reason", member.reason, {.holds = Holds::prose});
}

void describe(auto& v, Is<rules::AggregateFinding> auto& finding) {
  v.is("aggregate",
       "Several requirements as one, as a rule pack has them: an aggregate, or a class of rows. "
       "What "
       "is about one plane names it; without plane it is about the room, without space about the "
       "project.");
  v.field("kind", finding.kind);
  v.field("id", finding.id);
  v.field("space", finding.space_id);
  v.field("plane", finding.plane_id);
  v.field("clause", finding.clause);
  v.field("note", finding.note, {.holds = Holds::prose});
  v.field("where", finding.where);
  v.field("rule", finding.rule);
  v.field("over", finding.over, {.words = "What the members are."});
  v.field("count", finding.count, {.words = "Of at-least."});
  v.field("share", finding.share, {.words = "Of share.", .least = 0.0, .most = 1.0});
  v.field("by_area", finding.by_area);
  // An aggregate counts by itself or not at all, never in another one.
  v.field("severity", finding.severity, {.choices = {"shall", "advice"}});
  v.field("verdict", finding.verdict);
  v.field("is_waived", finding.is_waived);
  v.refuse_if(finding.is_waived && finding.verdict == rules::Verdict::pass, "is_waived",
              "what passes cannot be waived");
  v.field("reason", finding.reason, {.holds = Holds::prose});
  v.field("members", finding.members);
  v.field("asked", finding.asked,
          {.words = "Of classes: the one asked for, the best that is reached for certain, the best "
                    "that may be; empty: none."});
  v.field("reached", finding.reached);
  v.field("possible", finding.possible);
}

void describe(auto& v, Is<PhaseTimes> auto& times) {
  v.is("times", "Only with --timing.");
  v.field("load_s", times.load_s);
  v.field("prepare_s", times.prepare_s);
  v.field("direct_s", times.direct_s);
  v.field("pool_s", times.pool_s);
  v.field("connect_s", times.connect_s);
  v.field("near_s", times.near_s);
  v.field("judge_s", times.judge_s);
  v.field("total_s", times.total_s);
  v.field("maps_s", times.maps_s, {.presence = only_if(times.maps_s > 0.0)});
}

void describe(auto& v, Is<calc::InputFile> auto& input) {
  v.field("path", input.path, {.holds = Holds::own_file});
  v.field("sha256", input.sha256);
}

void describe(auto& v, Is<ProjectPart> auto& project) {
  v.is("project");
  v.field("path", project.path, {.holds = Holds::file});
  v.field("name", project.name);
  v.field("is_judged", project.is_judged);
  v.written("counts", [&] { return count_verdicts(project); });
  v.field("diagnostics", project.diagnostics);
  v.written("warnings", [&] { return count_warnings(project); }, {.presence = kSinceLater});
  std::vector<std::string> strict;
  for (const calc::DiagnosticId id : project.strict_warnings) {
    strict.push_back(calc::diagnostic_name(id));
  }
  v.field("strict_warnings", strict,
          {.words = "Ids of warnings that count like errors, by --strict.",
           .presence = only_if(!strict.empty())});
  std::vector<calc::DiagnosticId> strict_ids;
  for (const std::string& name : strict) {
    const std::optional<calc::DiagnosticId> id = calc::diagnostic_from_name(name);
    v.refuse_if(!id, "strict_warnings", "no message of this program has that id");
    if (id) strict_ids.push_back(*id);
  }
  assign(project.strict_warnings, strict_ids);
  v.field("luminaires", project.luminaires);
  v.field("spaces", project.spaces);
  v.field("inputs", project.inputs);
  v.field("aggregates", project.aggregates, {.presence = only_if(!project.aggregates.empty())});
  v.field("times", project.times, {.presence = only_if(project.times.total_s > 0.0)});
}

void describe(auto& v, Is<Document> auto& document) {
  v.is("",
       "What 'luxgate check --format json' writes. Keys may be added; format_version is raised "
       "when one changes its meaning or goes away.");
  v.constant("format", "luxgate-result");
  v.constant("format_version", 1);
  v.field("provenance", document.provenance);
  v.written("counts", [&] { return count_verdicts(document); });
  v.written("warnings", [&] { return count_warnings(document); }, {.presence = kSinceLater});
  v.field("projects", document.projects);
}

}  // namespace report
