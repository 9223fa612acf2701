#pragma once
// The result file, in one description: the keys of each part of a document, in the order in which
// they are written, with their contents, when they may be missing and their words in the schema.
// Five visitors use it (describe.h): the writer (json_writer.h), the reader (read_json.cpp), the
// check of derived keys (written_check.cpp), the schema (result_schema.cpp) and the redaction
// (redact.cpp). A new key is a line here, in finding_fields.h, plane_fields.h or revision_fields.h.

#include "calc/base/day.h"
#include "calc/base/names.h"
#include "calc/project/objects/maintenance_plan_xml.h"
#include "calc/project/reading/logo.h"
#include "report/document/document.h"
#include "report/document/one_source.h"
#include "report/document/road_facts.h"
#include "report/document/room_summary.h"
#include "report/document/row_uses.h"
#include "report/result_file/describe.h"
#include "report/result_file/finding_fields.h"
#include "report/result_file/plane_fields.h"
#include "report/result_file/revision_fields.h"
#include "report/text/base64.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace report {

void describe(auto& v, Is<calc::Estimate> auto& estimate) {
  v.is(
      "estimate",
      "A value and its confidence interval; low = value = high: exact. null: not a finite number.");
  v.field("value", or_null(estimate.value));
  v.field("low", or_null(estimate.low));
  v.field("high", or_null(estimate.high));
  bool is_nothing = calc::is_nothing(estimate);
  v.field("is_nothing", is_nothing,
          {.words = "There if nothing is there that could be measured: less than every number, and "
                    "at most 'high' if that is a number.",
           .presence = only_if(is_nothing),
           .is_mark = true});
  v.refuse_if(is_nothing && (std::isfinite(estimate.value) || std::isfinite(estimate.low)),
              "is_nothing", "value and low must be null");
  if (is_nothing) {
    calc::Estimate nothing = estimate;
    nothing.value = -std::numeric_limits<double>::infinity();
    assign(estimate, settled(nothing));
  }
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

// Describes keys that are only written, because they follow from the findings.
void describe(auto& v, Is<RoomSummary> auto& room) {
  v.is("room", "What became of a room of which something is asked.");
  const std::string space = room.space == nullptr ? "" : room.space->id;
  v.field("space", space);
  v.field("outcome", room.outcome, {.words = "The gravest of what counts."});
  v.field("required", room.required, {.words = "Requirements that count."});
  v.field("met", room.met, {.words = "Of these."});
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
  v.field("method", p.method,
          {.words = "Options of the method that are not as by default; '': none.",
           .presence = kSinceLater});
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
  v.field("judged_on", p.judged_on,
          {.words = "The day by which waivers and stated deviations were held to last; there if "
                    "the result has any.",
           .presence = only_if(!p.judged_on.empty())});
  v.field("timestamp", p.timestamp,
          {.words = "Only if asked for.", .presence = only_if(!p.timestamp.empty())});
  v.field("policy", p.policy,
          {.words = "Name of the owner's policy that it was judged by; there if there is one.",
           .presence = only_if(!p.policy.empty())});
  v.field("policy_sha256", p.policy_sha256,
          {.words = "Of the file of that policy.", .presence = only_if(!p.policy.empty())});
  v.field(
      "selection", p.selection,
      {.words = "Options that chose a part of what the projects require; there if they did. The "
                "rest was neither calculated nor judged.",
       .presence = only_if(!p.selection.empty())});
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
  v.refuse_if(!id, "id", "unknown message id");
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
  v.field("maker", row.maker,
          {.words = "As the photometry file has it, likewise the next four; \"\" = not stated.",
           .presence = kSinceLater});
  v.field("article_number", row.article_number, {.presence = kSinceLater});
  v.field("lamp", row.lamp, {.presence = kSinceLater});
  v.field("colour_temperature", row.colour_temperature, {.presence = kSinceLater});
  v.field("colour_rendering", row.colour_rendering, {.presence = kSinceLater});
  v.field("package", row.package,
          {.words = "Article of the lamp package that the project takes in place of the file's "
                    "flux and power; \"\" = none.",
           .presence = kSinceLater});
  v.field("count", row.count, {.words = "Of `luminaires` of all spaces: what the model holds."});
  v.field("flux_lm", or_null(row.flux_lm), {.words = "Of one luminaire, new, after any override."});
  v.field("power_w", or_null(row.power_w, 0.0), {.words = "null: not stated."});
  v.field("file_flux_lm", or_null(row.file_flux_lm, 0.0),
          {.words = "Of the photometry file, without an override. null: no file.",
           .presence = kSinceLater});
  v.field("file_power_w", or_null(row.file_power_w, 0.0),
          {.words = "Likewise. null: not stated.", .presence = kSinceLater});
  v.field("stated_flux_lm", or_null(row.stated_flux_lm, 0.0),
          {.words = "As the photometry file states it; file_flux_lm is what its intensities "
                    "give. null: not stated.",
           .presence = kSinceLater});
  v.field("max_intensity_cd", or_null(row.max_intensity_cd));
  v.field("maintenance_factor", or_null(row.maintenance_factor));
  v.field("maintenance_parts", row.maintenance);
  v.field("housing_material", row.housing_material,
          {.words = "Of the housing that shades and takes up light; \"\" = none, light passes "
                    "through the luminaire.",
           .presence = kSinceLater});
  v.field("housing_depth_m", row.housing_depth_m,
          {.words = "Behind the opening, or how high a luminous body is; 0: the face alone.",
           .presence = kSinceLater,
           .least = 0.0});
  const auto polar = [&](auto& o) {
    double step_deg = kPolarStep_deg;
    o.field("step_deg", step_deg);
    // A curve has either no values or one for every step.
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

void describe(auto& v, Is<MaterialRow> auto& material) {
  v.field("id", material.id);
  v.field("reflectance", material.reflectance, {.least = 0.0, .most = 1.0});
}

void describe(auto& v, Is<LuminaireMark> auto& mark) {
  v.field("type", mark.type_id);
  v.field("position_m", mark.position_m);
  v.field("id", mark.id, {.words = "As the project has it; \"\" = none.", .presence = kSinceLater});
  v.field("group", mark.group, {.presence = kSinceLater});
  v.field("outline_m", mark.outline_m,
          {.words = "Of the opening from above; empty: a point.", .presence = kSinceLater});
  glm::dvec2 c0(mark.c0);
  double c0_z = mark.c0.z;
  v.field("c0", c0, {.words = "x and y of the direction of C0.", .presence = kSinceLater});
  v.field("c0_z", c0_z, {.presence = kSinceLater});
  assign(mark.c0, glm::dvec3(c0, c0_z));
  v.field("axis", mark.axis, {.words = "Direction of gamma = 0.", .presence = kSinceLater});
}

void describe(auto& v, Is<BodyMark> auto& body) {
  v.field("id", body.id);
  v.field("low_z_m", body.low_z_m);
  v.field("high_z_m", body.high_z_m);
  v.field("lines_m", body.lines_m, {.words = "x1, y1, x2, y2 each."});
  v.field("materials", body.materials, {.words = "Ids.", .presence = kSinceLater});
}

void describe(auto& v, Is<SurfaceFinish> auto& finish) {
  v.field("surface", finish.surface);
  v.field("materials", finish.materials, {.words = "Ids."});
}

void describe(auto& v, Is<calc::InstalledPower> auto& power) {
  v.field("power_w", power.power_w);
  v.field("area_m2", power.area_m2);
  v.field("luminaires", power.luminaires);
  v.field("without_power", power.without_power);
  v.field("of_spacing", power.is_of_spacing,
          {.words = "There of a road: all this is of one spacing of it. `luminaires` of the space "
                    "are all that are drawn, and those count in `count` of their types.",
           .presence = only_if(power.is_of_spacing),
           .is_mark = true});
}

void describe(auto& v, Is<calc::LightingEnergy> auto& energy) {
  v.field("lighting_kwh", energy.lighting_kwh, {.words = "In a year.", .least = 0.0});
  v.field("leni_kwh_m2", energy.leni_kwh_m2,
          {.words = "By floor area, with the parasitic part.", .least = 0.0});
  v.field("problem", energy.problem,
          {.words = "Why there is none; the numbers are then 0.",
           .presence = only_if(!energy.problem.empty())});
  v.field("words", energy.words, {.presence = only_if(!energy.words.empty())});
}

void describe(auto& v, Is<calc::FluxBalance> auto& balance) {
  v.field("emitted_lm", or_null(balance.emitted_lm));
  v.field("untraced_lm", or_null(balance.untraced_lm));
  v.field("absorbed_lm", balance.absorbed_lm);
  v.field("escaped_lm", balance.escaped_lm);
}

void describe(auto& v, Is<SceneRow> auto& scene) {
  v.is("scene");
  v.field("id", scene.id);
  v.rows("level_of_group", scene.level_of_group,
         [](auto& row, auto& level) { row(level.first, level.second); });
}

void describe(auto& v, Is<RoadRowPart> auto& row) {
  v.field("id", row.id);
  v.field("type", row.type_id);
  v.field("group", row.group, {.presence = only_if(!row.group.empty())});
  v.field("height_m", row.height_m, {.above = 0.0});
  v.field("y_m", row.y_m, {.words = "From the right edge of the carriageway to the left."});
  v.field("shift_m", row.shift_m, {.least = 0.0});
  v.field("tilt_deg", row.tilt_deg, {.words = "Above 0: the left side is lifted."});
  v.field("power_w", or_null(row.power_w, 0.0), {.words = "Of one. null: not stated."});
  v.field("maintenance_factor", row.maintenance_factor, {.above = 0.0});
}

void describe(auto& v, Is<RoadAreaPart> auto& area) {
  v.field("plane", area.plane_id);
  v.field("name", area.name);
  v.field("from_y_m", area.from_y_m);
  v.field("to_y_m", area.to_y_m);
  v.refuse_if(!(area.from_y_m < area.to_y_m), "to_y_m", "it must be above from_y_m");
}

void describe(auto& v, Is<calc::RoadObserver> auto& observer) {
  v.field("lane", observer.lane, {.words = "From 0, at the right edge."});
  v.field("oncoming", observer.is_oncoming, {.words = "true: looks to -x."});
  v.field("eye_m", observer.eye_m, {.words = "In the frame of the road."});
  v.field("average_cd_m2", observer.average_cd_m2);
  v.field("uo", observer.uo, {.presence = only_if(observer.uo.has_value())});
  v.field("ul", observer.ul, {.presence = only_if(observer.ul.has_value())});
  v.field("veiling_cd_m2", observer.veiling_cd_m2);
  v.field("ti_percent", observer.ti_percent,
          {.presence = only_if(observer.ti_percent.has_value())});
  v.field("cd_m2", observer.cd_m2, {.words = "Maintained, row by row of y_m."});
}

// Returns whether there are as many points as the lanes and the spacing allow; pictures rely on it.
inline bool is_whole(const calc::RoadLight& light) {
  constexpr std::size_t kMostAlong = 1000, kMostLanes = 100;
  const std::vector<calc::RoadObserver>& observers = light.observers;
  if (observers.empty() || observers.size() > kMostLanes) return false;
  if (light.grid.along() == 0 || light.grid.along() > kMostAlong) return false;
  if (light.grid.across() != observers.size() * calc::kRoadRowsPerLane) return false;
  int lane = 0;
  return std::all_of(observers.begin(), observers.end(), [&](const calc::RoadObserver& observer) {
    return observer.lane == lane++ &&
           observer.cd_m2.size() == light.grid.along() * light.grid.across();
  });
}

void describe(auto& v, Is<RoadPart> auto& road) {
  v.is("road",
       "In its own frame: x along the road from a luminaire of the first row, in the direction of "
       "traffic that is not oncoming, y across it from the right edge of the carriageway.");
  v.field("spacing_m", road.spacing_m, {.words = "Of the luminaires of a row.", .above = 0.0});
  v.field("width_m", road.width_m, {.words = "Of the carriageway.", .above = 0.0});
  v.field("surface", road.surface, {.words = "Table of reduced luminance coefficients."});
  v.field("q0", road.q0);
  v.field("rows", road.rows, {.words = "Of luminaires."});
  v.field("areas", road.areas, {.words = "The carriageway first."});
  v.field("scene", road.scene, {.words = "Whose luminance this is; \"\": full output."});
  v.field("x_m", road.light.grid.x_m, {.words = "Of the points of luminance."});
  v.field("y_m", road.light.grid.y_m);
  v.field("observers", road.light.observers, {.words = "One for each lane, from the right edge."});
  v.refuse_if(!is_whole(road.light), "observers",
              "each lane needs an observer with a luminance at each point");
  v.field("right_edge_ratio", road.light.right_ratio,
          {.presence = only_if(road.light.right_ratio.has_value())});
  v.field("left_edge_ratio", road.light.left_ratio,
          {.presence = only_if(road.light.left_ratio.has_value())});
}

// Describes keys that are only written, because they follow from the road and its planes.
void describe(auto& v, Is<RoadFacts> auto& facts) {
  v.is("road_energy", "By EN 13201-5, at full output.");
  v.field("luminaires", facts.luminaires, {.words = "In one spacing."});
  v.field("power_w", facts.power_w, {.words = "Of these. null: of one it is not stated."});
  v.field("area_m2", facts.m2,
          {.words = "Of carriageway and footways over one spacing, what several share once."});
  const std::optional<calc::Estimate>& density = facts.power_density_w_lx_m2;
  v.field("power_density_w_lx_m2", density,
          {.words = "Power density indicator: power by average illuminance and area. Not there: "
                    "power or an average is not known, or areas overlap.",
           .presence = only_if(density.has_value())});
}

void describe(auto& v, Is<SpacePart> auto& space) {
  v.is("space");
  v.field("id", space.id);
  v.field("was", space.was,
          {.words = "Its id in earlier revisions, as the project says.",
           .presence = only_if(!space.was.empty())});
  v.field("name", space.name);
  v.field("footprint_m", space.footprint_m);
  v.field("floor_z_m", space.floor_z_m);
  v.field("power", space.power,
          {.words = "Installed power of the space's luminaires. without_power: how many of them "
                    "state none, which power_w is then without. area_m2: of the floor, 0 = not "
                    "known.",
           .presence = kSinceLater});
  v.field("energy", space.energy,
          {.words = "Of a year, after EN 15193, where the project states how the light is used.",
           .presence = only_if(space.energy.has_value())});
  v.field("height_m", space.height_m);
  v.field("triangles", space.triangles);
  v.field("degenerate_triangles", space.degenerate_triangles);
  v.field("luminaires", space.luminaires);
  v.field("finishes", space.finishes,
          {.words = "Of floor, ceiling and walls of a room.",
           .presence = only_if(!space.finishes.empty())});
  v.field("bodies", space.bodies,
          {.words = "Furniture as seen from above.", .presence = kSinceLater});
  v.field("bodies_left_out", space.bodies_left_out,
          {.words = "Furniture that is too much to draw.", .presence = kSinceLater});
  v.field("surface_lines_m", space.surface_lines_m,
          {.words = "Where surfaces of a room from a file bend or end: two ends each, one behind "
                    "the other.",
           .presence = only_if(!space.surface_lines_m.empty())});
  v.refuse_if(space.surface_lines_m.size() % 2 != 0, "surface_lines_m", "an end without a start");
  v.field("surface_lines_left_out", space.surface_lines_left_out,
          {.words = "Such lines that are too many to draw, the shortest.",
           .presence = only_if(space.surface_lines_left_out > 0)});
  v.field("flux_balance", space.balance);
  v.field("scene_sha256", space.scene_sha256,
          {.words = "Of all surfaces with their reflectances and all luminaires with their "
                    "photometry, as they were calculated, without maintenance factors and dimming: "
                    "equal ones have the same light.",
           .presence = kSinceLater});
  v.field("planes", space.planes);
  v.field("coverage", space.coverage,
          {.words = "What is asked of which rows of rule packs.",
           .presence = only_if(!space.coverage.empty())});
  v.field("road", space.road,
          {.words = "Of a street.", .presence = only_if(space.road.has_value())});
  v.written("road_energy", [&] { return road_facts(space); },
            {.words = "Of a street, by EN 13201-5.", .presence = only_if(space.road.has_value())});
  v.field("notes", space.notes,
          {.words = "Zones of workplaces that were not made, and why.",
           .presence = only_if(!space.notes.empty())});
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

void describe(auto& v, Is<calc::Logo> auto& logo) {
  v.field("file", logo.file, {.holds = Holds::own_file});
  v.field("format", logo.format);
  std::string text = base64(logo.bytes);
  v.field("base64", text, {.words = "Its bytes."});
  const std::optional<std::string> bytes = bytes_of_base64(text);
  v.refuse_if(!bytes || !calc::logo_problem(*bytes, logo.format).empty(), "base64",
              "a picture that 'luxgate check' lets into reports is needed");
  assign(logo.bytes, bytes.value_or(""));
}

void describe(auto& v, Is<calc::AboutProject> auto& about) {
  v.is("about", "Whom the design is for and who made it, as the project says; what it says only.");
  for (const calc::AboutText& one : calc::kAboutTexts) {
    v.field(one.name, about.*one.text, {.presence = only_if(!(about.*one.text).empty())});
  }
  v.refuse_if(!about.date.empty() && !calc::is_day(about.date), "date",
              "a day, YYYY-MM-DD, is needed");
  v.field("logo", about.logo, {.presence = only_if(!about.logo.bytes.empty())});
}

// Refuses a number that a project could not have stated.
void refuse_beyond(auto& v, const std::optional<double>& number, const calc::NumberRange& range,
                   const char* key) {
  v.refuse_if(number && !range.contains(*number), key,
              (std::string(range.words) + " is needed").c_str());
}

void describe(auto& v, Is<calc::MaintenancePlan> auto& plan) {
  v.field("environment", plan.environment, {.presence = only_if(!plan.environment.empty())});
  for (const calc::MaintenanceNumber& one : calc::kMaintenanceNumbers) {
    const std::optional<double>& number = plan.*one.number;
    v.field(one.result_key, plan.*one.number, {.presence = only_if(number.has_value())});
    refuse_beyond(v, number, calc::range_of(one), one.result_key);
  }
  v.field("instructions", plan.instructions, {.presence = only_if(!plan.instructions.empty())});
}

void describe(auto& v, Is<AdvisedGroup> auto& group) {
  v.field("group", group.group, {.words = "\"\": luminaires without one."});
  v.field("luminaires", group.luminaires);
  v.field("power_w", group.power_w,
          {.words = "Of all of them at full output; 0 = not stated.", .least = 0.0});
  v.field("flux_lm", group.flux_lm, {.words = "Likewise.", .least = 0.0});
  v.field("energy_kwh", group.energy_kwh,
          {.words = "Likewise, of a year, by the rooms that state their use.",
           .presence = only_if(group.energy_kwh > 0.0),
           .least = 0.0});
  v.field("now", group.now, {.words = "Level in the project.", .least = 0.0, .most = 1.0});
  v.field("level", group.level,
          {.words = "Advised; above 1: so many times the light.",
           .least = 0.0,
           .most = kMostAdvisedLight});
}

void describe(auto& v, Is<RequirementName> auto& name) {
  v.is("requirement_name");
  v.field("plane", name.plane, {.words = "Its id."});
  v.field("requirement", name.requirement, {.words = "Its id."});
}

void describe(auto& v, Is<LevelAdvice> auto& advice) {
  v.is("level_advice", "Of one light scene.");
  v.field("scene", advice.scene, {.words = "\"\": full output."});
  v.field("outcome", advice.outcome,
          {.words = "levels: these are enough, checked with other random numbers; contradiction: "
                    "surely none are; more-light: only more light than there is, not checked; "
                    "too-uncertain: the intervals are too wide; none-found: see reason."});
  v.field("reason", advice.reason, {.presence = only_if(!advice.reason.empty())});
  v.field("unit", advice.unit, {.words = "Of now and advised: lumens where a power is not known."});
  v.field("now", advice.now, {.least = 0.0});
  v.field("advised", advice.advised, {.least = 0.0});
  v.field("groups", advice.groups, {.words = "Empty without levels."});
  v.field("passing", advice.passing, {.words = "Of the scene's requirements, with the levels."});
  v.field("asked", advice.asked);
  v.refuse_if(advice.passing > advice.asked, "passing", "more pass than are asked");
  v.field("not_met", advice.not_met, {.words = "With the levels."});
  v.field("aggregates_not_met", advice.aggregates_not_met,
          {.words = "Aggregates and classes of rule packs, with the levels.",
           .presence = only_if(!advice.aggregates_not_met.empty()),
           .holds = Holds::prose});
  v.refuse_if(advice.has_levels() && advice.passing + advice.not_met.size() != advice.asked,
              "not_met", "as many as do not pass are needed");
  v.field("excluding", advice.excluding, {.words = "Of these no levels meet all."});
}

void describe(auto& v, Is<ProjectPart> auto& project) {
  v.is("project");
  v.field("path", project.path, {.holds = Holds::file});
  v.field("name", project.name);
  v.field("about", project.about, {.presence = only_if(!project.about.is_empty())});
  v.field("north_deg", project.north_deg,
          {.words = "Where north lies in plan, from +x counter-clockwise.",
           .presence = only_if(project.north_deg.has_value())});
  refuse_beyond(v, project.north_deg, calc::kTurn, "north_deg");
  v.field("maintenance_plan", project.maintenance_plan,
          {.words = "How the installation is to be kept, as the project says; what it says only.",
           .presence = only_if(!project.maintenance_plan.is_empty())});
  v.field("is_judged", project.is_judged);
  v.written("counts", [&] { return count_verdicts(project); });
  v.written("rooms", [&] { return room_summaries(project); }, {.presence = kSinceLater});
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
    v.refuse_if(!id, "strict_warnings", "unknown message id");
    if (id) strict_ids.push_back(*id);
  }
  assign(project.strict_warnings, strict_ids);
  v.field("luminaires", project.luminaires);
  v.field("materials", project.materials, {.presence = kSinceLater});
  v.field("scenes", project.scenes,
          {.words = "Dimming levels of groups; others are at 1.",
           .presence = only_if(!project.scenes.empty())});
  v.field("spaces", project.spaces);
  v.field("inputs", project.inputs);
  v.field("aggregates", project.aggregates, {.presence = only_if(!project.aggregates.empty())});
  v.field("advice", project.advice,
          {.words = "Of --advice: dimming levels for scenes in which something is not met.",
           .presence = only_if(project.advice.has_value())});
  const std::vector<RowUse> uses = row_uses(project);
  v.written("uses", [&] { return uses; },
            {.words = "Each row of a rule pack, over all rooms that are asked it.",
             .presence = only_if(!uses.empty())});
  v.field("times", project.times, {.presence = only_if(project.times.total_s > 0.0)});
}

void describe(auto& v, Is<RowUse> auto& use) {
  v.is("row_use");
  std::string clause = use.clause.english();
  v.field("clause", clause);
  v.field("user_supplied", use.is_user_supplied,
          {.words = "The pack does not come with luxgate.",
           .presence = only_if(use.is_user_supplied),
           .is_mark = true});
  v.field("rooms", use.rooms, {.words = "Their ids."});
  v.field("times", use.times, {.words = "By how many workplaces, or planes of a room together."});
  v.field("whole", use.whole, {.words = "Of these: nothing of the row was never asked."});
  v.field(
      "excepted", use.excepted,
      {.words = "Of these: something of the row is waived or left out.", .presence = kSinceLater});
  v.field("requirements", use.requirements, {.words = "That count, each once."});
  v.field("met", use.met);
  v.field("outcome", use.outcome,
          {.words = "The gravest of what is asked, and of the aggregates that it is in."});
  v.written("is_met", [&] { return use.is_met(); },
            {.words = "Everything is met, and the row asked as a whole wherever it is asked, with "
                      "nothing waived and nothing left out."});
  v.field("margin", use.margin, {.words = "The smallest; null: nothing has one."});
  v.field("room", use.room, {.words = "Whose margin it is, with plane and requirement."});
  v.field("plane", use.plane);
  v.field("requirement", use.requirement);
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
  v.field("revision", document.revision, {.presence = only_if(document.revision.has_value())});
  const std::vector<std::string> one_source = one_source_names(totals_of(document));
  v.written("one_source", [&] { return one_source; },
            {.words = "Clauses whose numbers rest on one public source, each once. Clauses and "
                      "notes of requirements have the mark, too.",
             .presence = only_if(!one_source.empty()),
             .holds = Holds::prose});
  const std::vector<calc::Diagnostic> errors = document_errors(end_of(document));
  v.written("errors", [&] { return errors; },
            {.words = "Of no single project, as that options chose nothing in any of them.",
             .presence = only_if(!errors.empty())});
}

}  // namespace report
