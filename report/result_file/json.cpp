#include "report/result_file/json.h"

#include "report/document/same_bits.h"
#include "report/text/json_layout.h"
#include "report/text/words.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

Json from(const calc::Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}
Json from(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }
Json from(const VerdictCounts& counts) {
  return {{"pass", counts.pass},
          {"fail", counts.fail},
          {"undecided", counts.undecided},
          {"not_judged", counts.not_judged},
          {"waived", counts.waived}};
}
Json from(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json from(const std::vector<glm::dvec2>& polygon) {
  Json array = Json::array();
  for (const glm::dvec2& corner : polygon) array.push_back(Json::array({corner.x, corner.y}));
  return array;
}

// Calls convert on each item.
template <class Items, class Convert>
Json list_of(const Items& items, Convert convert) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(convert(item));
  return array;
}

Json from(const calc::SourceLocation& where) {
  return {{"file", where.file}, {"line", where.line}, {"column", where.column}};
}

Json provenance_json(const Provenance& provenance) {
  Json json = {{"program_version", provenance.program_version},
               {"command_line", provenance.command_line},
               {"seed", provenance.seed},
               {"confidence", provenance.confidence},
               {"goal", rules::goal_name(provenance.goal)},
               {"tolerance", provenance.tolerance},
               {"max_paths", provenance.max_paths},
               {"replicates", provenance.replicates},
               {"backend", provenance.backend},
               {"numbers_version", provenance.numbers_version},
               {"same_bits_on", same_bits_name(provenance.same_bits)}};
  if (!provenance.timestamp.empty()) json["timestamp"] = provenance.timestamp;
  if (provenance.is_redacted) json["redacted"] = true;
  return json;
}

Json diagnostic_json(const calc::Diagnostic& diagnostic) {
  const bool is_error = diagnostic.severity() == calc::Severity::error;
  return {{"severity", is_error ? "error" : "warning"},
          {"id", calc::diagnostic_name(diagnostic.id)},
          {"where", from(diagnostic.where)},
          {"message", diagnostic.message}};
}

Json luminaire_json(const LuminaireRow& row) {
  return {{"type", row.type_id},
          {"photometry_file", row.photometry_file},
          {"sha256", row.sha256},
          {"name", row.name},
          {"format", row.format},
          {"count", row.count},
          {"flux_lm", row.flux_lm},
          {"power_w", row.power_w > 0 ? Json(row.power_w) : Json()},
          {"max_intensity_cd", row.max_intensity_cd},
          {"maintenance_factor", row.maintenance_factor},
          {"maintenance_parts",
           {{"product", row.maintenance.product},
            {"llmf", from(row.maintenance.llmf)},
            {"lsf", from(row.maintenance.lsf)},
            {"lmf", from(row.maintenance.lmf)},
            {"rsmf", from(row.maintenance.rsmf)}}},
          {"polar", {{"step_deg", kPolarStep_deg}, {"c0_cd", row.c0_cd}, {"c90_cd", row.c90_cd}}}};
}

Json decision_json(const rules::DecisionPolicy& policy) {
  return {{"compares_rounded", policy.compares_rounded},
          {"rounding", rules::rounding_name(policy.rounding)},
          {"illuminance_digits", policy.illuminance_digits},
          {"ratio_digits", policy.ratio_digits},
          {"other_digits", policy.other_digits},
          {"tolerance", policy.tolerance},
          {"tolerance_reason", policy.tolerance_reason},
          {"guard", policy.guard}};
}

Json finding_json(const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  Json json = {{"requirement", requirement.id},
               {"quantity", rules::metric_name(requirement.metric)},
               {"unit", rules::unit_of(requirement)},
               {"comparison", comparison_key(requirement.comparison)},
               {"limit", requirement.limit},
               {"state", state_name(requirement.state)},
               {"scene", requirement.scene},
               {"clause", requirement.clause},
               {"where", from(requirement.where)},
               {"verdict", verdict_key(finding.verdict)},
               {"measured", is_judged ? from(finding.measured) : Json()},
               {"margin", is_judged ? Json(finding.margin) : Json()},
               {"is_close", finding.is_close},
               {"place_m", is_judged && finding.place_m ? from(*finding.place_m) : Json()},
               {"reason", finding.reason},
               {"note", note_words(finding)},
               {"policy", rules::policy_text(requirement.policy)},
               {"decision", decision_json(requirement.policy)},
               {"requirement_note", requirement.note},
               {"severity", severity_key(requirement.severity)},
               {"direct_only", requirement.direct_only},
               {"by_tolerance", finding.by_tolerance}};
  if (requirement.waiver) {
    json["waiver"] = {{"reason", requirement.waiver->reason},
                      {"owner", requirement.waiver->owner},
                      {"until", requirement.waiver->until},
                      {"applies", finding.is_waived}};
  }
  if (requirement.metric == rules::Metric::share) {
    const bool is_plain = calc::is_plain_number(requirement.derived);
    json[is_plain ? "from" : "from_lx"] = requirement.range.from;
    json[is_plain ? "to" : "to_lx"] =
        std::isfinite(requirement.range.to) ? Json(requirement.range.to) : Json();
  }
  if (!requirement.mask.id.empty()) {
    json["mask"] = {{"id", requirement.mask.id}, {"points_used", finding.points_used}};
  }
  if (requirement.metric == rules::Metric::percentile) json["percent"] = requirement.percent;
  if (requirement.point_m) json["point_m"] = from(*requirement.point_m);
  return json;
}

Json dropped_json(const calc::DroppedPoint& point) {
  Json json = {{"column", point.column},
               {"row", point.row},
               {"position_m", from(point.position_m)},
               {"reason", drop_key(point.reason)}};
  if (!point.body.empty()) json["body"] = point.body;
  return json;
}

Json grid_json(const PlanePart& plane) {
  const calc::SensorGrid& grid = plane.grid;
  return {{"rule", grid.rule},
          {"columns", grid.columns},
          {"rows", grid.rows},
          {"spacing_u_m", grid.spacing_u_m},
          {"spacing_v_m", grid.spacing_v_m},
          {"margin_m", grid.margin_m},
          {"origin_m", from(grid.origin_m)},
          {"u", from(grid.u)},
          {"v", from(grid.v)},
          {"outline_m", from(plane.outline_m)},
          {"holes_m", list_of(plane.holes_m, [](const auto& hole) { return from(hole); })},
          {"dropped", list_of(grid.dropped, dropped_json)}};
}

Json points_json(const PlanePart& plane) {
  return {{"columns",
           {"column", "row", "x_m", "y_m", "z_m", "nx", "ny", "nz", value_key(plane),
            *plane_unit(plane) == '\0' ? "low" : "low_lx",
            *plane_unit(plane) == '\0' ? "high" : "high_lx", "direct_lx", "indirect_lx"}},
          {"rows", list_of(plane.points, [](const PointRow& p) {
             return Json::array({p.column, p.row, p.position_m.x, p.position_m.y, p.position_m.z,
                                 p.normal.x, p.normal.y, p.normal.z, p.maintained_lx.value,
                                 p.maintained_lx.low, p.maintained_lx.high, p.direct_lx,
                                 p.indirect_lx});
           })}};
}

Json light_json(const LuminaireShare& share) {
  return {{"average_lx", from(share.average_lx)},
          {"direct_lx", share.direct_lx},
          {"minimum_lx", from(share.minimum_lx)},
          {"minimum_direct_lx", share.minimum_direct_lx}};
}

Json by_luminaire_json(const LuminaireShares& shares) {
  Json json = {{"minimum_at_m", from(shares.minimum_at_m)},
               {"largest", list_of(shares.largest, [](const LuminaireShare& share) {
                  Json luminaire = {{"id", share.id},
                                    {"type", share.type_id},
                                    {"group", share.group},
                                    {"position_m", from(share.position_m)}};
                  luminaire.update(light_json(share));
                  return luminaire;
                })}};
  if (shares.others > 0) {
    json["others"] = {{"count", shares.others}};
    json["others"].update(light_json(shares.rest));
  }
  return json;
}

Json look_json(const PlaneLook& look) {
  return {{"paths", look.paths},
          {"rays", look.rays},
          {"points", look.points},
          {"average_lx", from(look.average_lx)},
          {"findings", list_of(look.findings, [](const LookFinding& finding) {
             const bool is_judged = finding.verdict != rules::Verdict::not_judged;
             return Json{{"verdict", verdict_key(finding.verdict)},
                         {"measured", is_judged ? from(finding.measured) : Json()}};
           })}};
}

// Ratings and ratios of points have no average that would mean anything.
Json statistics_json(const PlanePart& plane) {
  if (calc::is_plain_number(plane.derived)) {
    return {{"minimum", from(plane.minimum_lx)}, {"maximum", from(plane.maximum_lx)}};
  }
  return {{"average_lx", from(plane.average_lx)},
          {"minimum_lx", from(plane.minimum_lx)},
          {"maximum_lx", from(plane.maximum_lx)},
          {"uniformity_min_avg", from(plane.uniformity_min_avg)},
          {"uniformity_min_max", from(plane.uniformity_min_max)}};
}

Json plane_json(const PlanePart& plane) {
  Json json = {{"id", plane.id},
               {"name", plane.name},
               {"where", from(plane.where)},
               {"quantity", calc::quantity_name(plane.kernel, plane.derived)},
               {"is_computed", plane.is_computed},
               {"reason", plane.reason},
               {"findings", list_of(plane.findings, finding_json)}};
  if (!plane.made_by.empty())
    json["zone"] = {{"made_by", plane.made_by}, {"changed", plane.changed}};
  if (!plane.is_computed) return json;
  if (!plane.remarks.empty()) json["remarks"] = plane.remarks;
  json["statistics"] = statistics_json(plane);
  json["stop"] = stop_key(plane.stop);
  json["looks"] = plane.counters.active_points.size();
  json["points_per_look"] = plane.counters.active_points;
  json["looks_planned"] = plane.looks_planned;
  json["unseen_points"] = plane.unseen_points;
  json["single_sample_points"] = plane.single_sample_points;
  json["counters"] = {{"paths", plane.counters.paths},
                      {"direct_rays", plane.counters.direct_rays},
                      {"connection_rays", plane.counters.connection_rays},
                      {"near_rays", plane.counters.near_rays}};
  json["groups"] = list_of(plane.groups, [](const GroupShare& share) {
    return Json{{"group", share.group},
                {"average_lx", from(share.average_lx)},
                {"direct_lx", share.direct_lx}};
  });
  if (!plane.by_luminaire.largest.empty())
    json["by_luminaire"] = by_luminaire_json(plane.by_luminaire);
  json["look_results"] = list_of(plane.looks, look_json);
  json["grid"] = grid_json(plane);
  json["points"] = points_json(plane);
  return json;
}

Json mark_json(const LuminaireMark& mark) {
  return {{"type", mark.type_id},
          {"position_m", from(mark.position_m)},
          {"group", mark.group},
          {"outline_m", from(mark.outline_m)},
          {"c0", Json::array({mark.c0.x, mark.c0.y})}};
}

Json body_json(const BodyMark& body) {
  return {{"id", body.id},
          {"low_z_m", body.low_z_m},
          {"high_z_m", body.high_z_m},
          {"lines_m", list_of(body.lines_m, [](const std::array<glm::dvec2, 2>& line) {
             return Json::array({line[0].x, line[0].y, line[1].x, line[1].y});
           })}};
}

Json space_json(const SpacePart& space) {
  Json json = {{"id", space.id},
               {"name", space.name},
               {"footprint_m", from(space.footprint_m)},
               {"floor_z_m", space.floor_z_m},
               {"power",
                {{"power_w", space.power.power_w},
                 {"area_m2", space.power.area_m2},
                 {"luminaires", space.power.luminaires},
                 {"without_power", space.power.without_power}}},
               {"height_m", space.height_m},
               {"triangles", space.triangles},
               {"degenerate_triangles", space.degenerate_triangles},
               {"luminaires", list_of(space.luminaires, mark_json)},
               {"bodies", list_of(space.bodies, body_json)},
               {"bodies_left_out", space.bodies_left_out},
               {"flux_balance",
                {{"emitted_lm", space.balance.emitted_lm},
                 {"untraced_lm", space.balance.untraced_lm},
                 {"absorbed_lm", from(space.balance.absorbed_lm)},
                 {"escaped_lm", from(space.balance.escaped_lm)}}},
               {"planes", list_of(space.planes, plane_json)}};
  if (!space.notes.empty()) json["notes"] = space.notes;
  return json;
}

Json member_json(const rules::AggregateMember& member) {
  return {{"name", member.name},
          {"verdict", verdict_key(member.verdict)},
          {"is_waived", member.is_waived},
          {"area_m2", from(member.area_m2)},
          {"reason", member.reason}};
}

Json aggregate_json(const rules::AggregateFinding& finding) {
  return {{"kind", rules::kind_name(finding.kind)},
          {"id", finding.id},
          {"space", finding.space_id},
          {"plane", finding.plane_id},
          {"clause", finding.clause},
          {"note", finding.note},
          {"where", from(finding.where)},
          {"rule", rules::rule_name(finding.rule)},
          {"over", rules::over_name(finding.over)},
          {"count", finding.count},
          {"share", finding.share},
          {"by_area", finding.by_area},
          {"severity", severity_key(finding.severity)},
          {"verdict", verdict_key(finding.verdict)},
          {"is_waived", finding.is_waived},
          {"reason", finding.reason},
          {"members", list_of(finding.members, member_json)},
          {"asked", finding.asked},
          {"reached", finding.reached},
          {"possible", finding.possible}};
}

Json times_json(const PhaseTimes& times) {
  Json json = {{"load_s", times.load_s},       {"prepare_s", times.prepare_s},
               {"direct_s", times.direct_s},   {"pool_s", times.pool_s},
               {"connect_s", times.connect_s}, {"near_s", times.near_s},
               {"judge_s", times.judge_s},     {"total_s", times.total_s}};
  if (times.maps_s > 0.0) json["maps_s"] = times.maps_s;
  return json;
}

Json project_json(const ProjectPart& project) {
  Json json = {{"path", project.path},
               {"name", project.name},
               {"is_judged", project.is_judged},
               {"counts", from(count_verdicts(project))},
               {"diagnostics", list_of(project.diagnostics, diagnostic_json)},
               {"luminaires", list_of(project.luminaires, luminaire_json)},
               {"spaces", list_of(project.spaces, space_json)},
               {"inputs", list_of(project.inputs, [](const calc::InputFile& input) {
                  return Json{{"path", input.path}, {"sha256", input.sha256}};
                })}};
  if (!project.aggregates.empty()) {
    json["aggregates"] = list_of(project.aggregates, aggregate_json);
  }
  if (project.times.total_s > 0) json["times"] = times_json(project.times);
  return json;
}

}  // namespace

std::string render_json(const Document& document) {
  const Json json = {{"format", "luxgate-result"},
                     {"format_version", 1},
                     {"provenance", provenance_json(document.provenance)},
                     {"counts", from(count_verdicts(document))},
                     {"projects", list_of(document.projects, project_json)}};
  return json_layout(json);
}

}  // namespace report
