#include "report/read_json.h"

#include "report/json_cursor.h"
#include "report/words.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace report {
namespace {

// As many as a plane may have; a file must not make pictures of any size.
constexpr std::int64_t kMostCells = 4'000'000;
constexpr std::int64_t kMostInt = std::numeric_limits<int>::max();

int whole(const JsonCursor& at, std::int64_t low = 0) {
  return static_cast<int>(at.whole(low, kMostInt));
}

std::size_t size(const JsonCursor& at) { return static_cast<std::size_t>(at.count()); }

glm::dvec3 vec3(const JsonCursor& at) {
  const std::vector<JsonCursor> items = at.items(3);
  return {items[0].finite(), items[1].finite(), items[2].finite()};
}

glm::dvec2 vec2(const JsonCursor& at) {
  const std::vector<JsonCursor> items = at.items(2);
  return {items[0].finite(), items[1].finite()};
}

std::vector<glm::dvec2> polygon(const JsonCursor& at) { return at.list_of(vec2); }

calc::Estimate estimate(const JsonCursor& at) {
  return settled({at["value"].number(), at["low"].number(), at["high"].number()});
}

std::optional<double> optional_number(const JsonCursor& at) {
  if (at.is_null()) return std::nullopt;
  return at.finite();
}

calc::SourceLocation location(const JsonCursor& at) {
  return {at["file"].text(), whole(at["line"]), whole(at["column"])};
}

Provenance provenance(const JsonCursor& at) {
  Provenance p;
  p.program_version = at["program_version"].text();
  p.command_line = at["command_line"].text();
  p.seed = at["seed"].count();
  p.confidence = at["confidence"].finite();
  p.goal =
      at["goal"].one_of(std::array{rules::Goal::verdict, rules::Goal::accuracy}, rules::goal_name);
  p.tolerance = at["tolerance"].finite();
  p.max_paths = at["max_paths"].count();
  p.replicates = whole(at["replicates"]);
  p.backend = at["backend"].text();
  if (const auto timestamp = at.find("timestamp")) p.timestamp = timestamp->text();
  if (const auto redacted = at.find("redacted")) p.is_redacted = redacted->flag();
  return p;
}

calc::Diagnostic diagnostic(const JsonCursor& at) {
  const std::optional<calc::DiagnosticId> id = calc::diagnostic_from_name(at["id"].text());
  if (!id) at["id"].refuse("no message of this program has that id");
  return {*id, location(at["where"]), at["message"].text()};
}

// Either nothing or every step.
std::vector<double> polar_curve(const JsonCursor& polar, std::string_view key) {
  constexpr std::size_t kValues = 2 * kPolarHalfSteps + 1;
  const double step_deg = polar["step_deg"].finite();
  const std::vector<JsonCursor> items = polar[key].items();
  if (items.empty()) return {};
  if (step_deg != kPolarStep_deg || items.size() != kValues)
    polar[key].refuse("145 values, 2.5 degrees apart, are needed");
  std::vector<double> cd;
  for (const JsonCursor& item : items) cd.push_back(item.finite());
  return cd;
}

LuminaireRow luminaire(const JsonCursor& at) {
  LuminaireRow row;
  row.type_id = at["type"].text();
  row.photometry_file = at["photometry_file"].text();
  row.sha256 = at["sha256"].text();
  row.name = at["name"].text();
  row.format = at["format"].text();
  row.count = whole(at["count"]);
  row.flux_lm = at["flux_lm"].number();
  row.power_w = at["power_w"].is_null() ? 0.0 : at["power_w"].finite();
  row.max_intensity_cd = at["max_intensity_cd"].number();
  row.maintenance_factor = at["maintenance_factor"].number();
  const JsonCursor parts = at["maintenance_parts"];
  row.maintenance.product = parts["product"].finite();
  row.maintenance.llmf = optional_number(parts["llmf"]);
  row.maintenance.lsf = optional_number(parts["lsf"]);
  row.maintenance.lmf = optional_number(parts["lmf"]);
  row.maintenance.rsmf = optional_number(parts["rsmf"]);
  if (const auto polar = at.find("polar")) {
    row.c0_cd = polar_curve(*polar, "c0_cd");
    row.c90_cd = polar_curve(*polar, "c90_cd");
  }
  return row;
}

rules::DecisionPolicy policy(const JsonCursor& at) {
  using enum rules::Rounding;
  rules::DecisionPolicy p;
  p.compares_rounded = at["compares_rounded"].flag();
  p.rounding = at["rounding"].one_of(std::array{half_up, half_even, down}, rules::rounding_name);
  p.illuminance_digits = whole(at["illuminance_digits"]);
  p.ratio_digits = whole(at["ratio_digits"]);
  p.other_digits = whole(at["other_digits"]);
  p.tolerance = at["tolerance"].finite();
  p.tolerance_reason = at["tolerance_reason"].text();
  p.guard = at["guard"].finite();
  return p;
}

rules::Requirement requirement(const JsonCursor& at, const PlanePart& plane) {
  rules::Requirement r;
  r.plane_id = plane.id;
  r.derived = plane.derived;
  r.id = at["requirement"].text();
  const JsonCursor quantity = at["quantity"];
  const std::optional<rules::Metric> metric = rules::metric_from_name(quantity.text());
  if (!metric) quantity.refuse("no quantity has that name");
  r.metric = *metric;
  r.comparison = at["comparison"].one_of(
      std::array{rules::Comparison::at_least, rules::Comparison::at_most,
                 rules::Comparison::more_than, rules::Comparison::less_than},
      comparison_key);
  r.limit = at["limit"].number();
  r.state = at["state"].one_of(std::array{rules::LightState::maintained, rules::LightState::initial,
                                          rules::LightState::end_of_duration},
                               rules::state_name);
  r.scene = at["scene"].text();
  r.clause = at["clause"].text();
  r.where = location(at["where"]);
  r.note = at["requirement_note"].text();
  r.severity = at["severity"].one_of(
      std::array{rules::Severity::shall, rules::Severity::advice, rules::Severity::in_aggregate},
      severity_key);
  r.direct_only = at["direct_only"].flag();
  r.policy = policy(at["decision"]);
  if (const auto waiver = at.find("waiver")) {
    r.waiver = rules::Waiver{(*waiver)["reason"].text(), (*waiver)["owner"].text(),
                             (*waiver)["until"].text()};
  }
  if (const auto mask = at.find("mask")) r.mask.id = (*mask)["id"].text();
  const bool is_plain = calc::is_plain_number(r.derived);
  if (const auto from = at.find(is_plain ? "from" : "from_lx")) r.range.from = from->finite();
  const auto to = at.find(is_plain ? "to" : "to_lx");
  if (to && !to->is_null()) r.range.to = to->finite();
  if (const auto percent = at.find("percent")) r.percent = percent->finite();
  if (const auto point = at.find("point_m")) r.point_m = vec3(*point);
  return r;
}

rules::Verdict verdict(const JsonCursor& at) {
  return at.one_of(std::array{rules::Verdict::pass, rules::Verdict::fail, rules::Verdict::undecided,
                              rules::Verdict::not_judged},
                   verdict_key);
}

rules::Finding finding(const JsonCursor& at, const PlanePart& plane) {
  rules::Finding f;
  f.requirement = requirement(at, plane);
  f.verdict = verdict(at["verdict"]);
  if (f.verdict != rules::Verdict::not_judged) {
    at["limit"].finite();  // only what is not judged may lack one
    f.measured = estimate(at["measured"]);
    f.margin = at["margin"].number();
    if (!at["place_m"].is_null()) f.place_m = vec3(at["place_m"]);
  }
  f.is_close = at["is_close"].flag();
  f.by_tolerance = at["by_tolerance"].flag();
  if (const auto waiver = at.find("waiver")) {
    const bool may_be_waived =
        f.verdict == rules::Verdict::fail || f.verdict == rules::Verdict::undecided;
    f.is_waived = (*waiver)["applies"].flag();
    if (f.is_waived && !may_be_waived) {
      (*waiver)["applies"].refuse("only 'fail' and 'undecided' can be waived");
    }
  }
  if (const auto mask = at.find("mask")) f.points_used = size((*mask)["points_used"]);
  f.reason = at["reason"].text();
  return f;
}

calc::DroppedPoint dropped(const JsonCursor& at) {
  using enum calc::DropReason;
  calc::DroppedPoint point{vec3(at["position_m"]), whole(at["column"]), whole(at["row"]),
                           outside_area, ""};
  point.reason = at["reason"].one_of(
      std::array{outside_area, within_margin, outside_room, inside_solid}, drop_key);
  if (const auto body = at.find("body")) point.body = body->text();
  return point;
}

calc::SensorGrid grid(const JsonCursor& at) {
  calc::SensorGrid g;
  g.rule = at["rule"].text();
  g.columns = whole(at["columns"]);
  g.rows = whole(at["rows"]);
  if (std::int64_t{g.columns} * g.rows > kMostCells)
    at["columns"].refuse("the grid has too many cells");
  g.spacing_u_m = at["spacing_u_m"].finite();
  g.spacing_v_m = at["spacing_v_m"].finite();
  g.margin_m = at["margin_m"].finite();
  g.origin_m = vec3(at["origin_m"]);
  g.u = vec3(at["u"]);
  g.v = vec3(at["v"]);
  g.dropped = at["dropped"].list_of(dropped);
  return g;
}

PointRow point(const JsonCursor& at) {
  constexpr std::size_t kColumns = 13;
  const std::vector<JsonCursor> c = at.items(kColumns);
  PointRow row;
  row.column = whole(c[0]);
  row.row = whole(c[1]);
  row.position_m = {c[2].finite(), c[3].finite(), c[4].finite()};
  row.normal = {c[5].finite(), c[6].finite(), c[7].finite()};
  row.maintained_lx = {c[8].number(), c[9].number(), c[10].number()};
  row.direct_lx = c[11].number();
  row.indirect_lx = c[12].number();
  return row;
}

// The grid's own lists follow from the points. Cells must lie within the grid: pictures rely on it.
void add_points(const JsonCursor& at, PlanePart& plane) {
  calc::SensorGrid& grid = plane.grid;
  for (const JsonCursor& item : at["rows"].items()) {
    const PointRow row = point(item);
    if (grid.columns > 0 && (row.column >= grid.columns || row.row >= grid.rows)) {
      item.refuse("the cell is outside the grid");
    }
    plane.points.push_back(row);
    grid.position_m.push_back(row.position_m);
    grid.normal.push_back(row.normal);
    grid.column.push_back(row.column);
    grid.row.push_back(row.row);
  }
}

calc::StopReason stop(const JsonCursor& at) {
  using enum calc::StopReason;
  return at.one_of(std::array{exact, decided, accurate, path_limit, time_limit, memory_limit,
                              endless_path, interrupted},
                   stop_key);
}

GroupShare group_share(const JsonCursor& at) {
  return {at["group"].text(), estimate(at["average_lx"]), at["direct_lx"].number()};
}

PlaneLook look(const JsonCursor& at, std::size_t findings) {
  PlaneLook l;
  l.paths = at["paths"].count();
  l.rays = at["rays"].count();
  l.points = size(at["points"]);
  l.average_lx = estimate(at["average_lx"]);
  for (const JsonCursor& item : at["findings"].items(findings)) {
    LookFinding f;
    f.verdict = verdict(item["verdict"]);
    if (f.verdict != rules::Verdict::not_judged) f.measured = estimate(item["measured"]);
    l.findings.push_back(f);
  }
  return l;
}

PlanePart plane(const JsonCursor& at, const std::string& space_id) {
  PlanePart p;
  p.id = at["id"].text();
  p.name = at["name"].text();
  p.space_id = space_id;
  p.where = location(at["where"]);
  const JsonCursor quantity = at["quantity"];
  const std::string kernel = quantity.text();
  const auto known = std::find_if(calc::kPlaneQuantities.begin(), calc::kPlaneQuantities.end(),
                                  [&](const auto& candidate) { return candidate.name == kernel; });
  if (known == calc::kPlaneQuantities.end()) quantity.refuse("no kind of point has that name");
  p.kernel = known->kernel;
  p.derived = known->derived;
  if (const auto remarks = at.find("remarks")) {
    p.remarks = remarks->list_of([](const JsonCursor& remark) { return remark.text(); });
  }
  p.is_computed = at["is_computed"].flag();
  p.reason = at["reason"].text();
  p.findings = at["findings"].list_of([&](const JsonCursor& f) { return finding(f, p); });
  if (const auto zone = at.find("zone")) {
    p.made_by = (*zone)["made_by"].text();
    p.changed = (*zone)["changed"].text();
  }
  if (!p.is_computed) return p;
  const JsonCursor statistics = at["statistics"];
  if (calc::is_plain_number(p.derived)) {
    p.average_lx = p.uniformity_min_avg = p.uniformity_min_max = no_estimate();
    p.minimum_lx = estimate(statistics["minimum"]);
    p.maximum_lx = estimate(statistics["maximum"]);
  } else {
    p.average_lx = estimate(statistics["average_lx"]);
    p.minimum_lx = estimate(statistics["minimum_lx"]);
    p.maximum_lx = estimate(statistics["maximum_lx"]);
    p.uniformity_min_avg = estimate(statistics["uniformity_min_avg"]);
    p.uniformity_min_max = estimate(statistics["uniformity_min_max"]);
  }
  p.stop = stop(at["stop"]);
  p.looks_planned = whole(at["looks_planned"]);
  p.unseen_points = size(at["unseen_points"]);
  p.single_sample_points = size(at["single_sample_points"]);
  const JsonCursor counters = at["counters"];
  p.counters = {counters["paths"].count(), counters["direct_rays"].count(),
                counters["connection_rays"].count(), counters["near_rays"].count(),
                at["points_per_look"].list_of(size)};
  if (const auto groups = at.find("groups")) p.groups = groups->list_of(group_share);
  if (const auto looks = at.find("look_results")) {
    p.looks = looks->list_of([&](const JsonCursor& l) { return look(l, p.findings.size()); });
  }
  p.grid = grid(at["grid"]);
  p.grid.kernel = p.kernel;
  p.grid.derived = p.derived;
  p.outline_m = polygon(at["grid"]["outline_m"]);
  p.holes_m = at["grid"]["holes_m"].list_of(polygon);
  add_points(at["points"], p);
  settle_estimates(p);
  return p;
}

// What later versions added may be missing.
LuminaireMark luminaire_mark(const JsonCursor& at) {
  LuminaireMark mark{vec3(at["position_m"]), at["type"].text()};
  if (const auto group = at.find("group")) mark.group = group->text();
  if (const auto outline = at.find("outline_m")) mark.outline_m = polygon(*outline);
  if (const auto c0 = at.find("c0")) mark.c0 = vec2(*c0);
  return mark;
}

BodyMark body_mark(const JsonCursor& at) {
  BodyMark mark;
  mark.id = at["id"].text();
  mark.low_z_m = at["low_z_m"].finite();
  mark.high_z_m = at["high_z_m"].finite();
  mark.lines_m = at["lines_m"].list_of([](const JsonCursor& line) {
    const std::vector<JsonCursor> c = line.items(4);
    return std::array{glm::dvec2(c[0].finite(), c[1].finite()),
                      glm::dvec2(c[2].finite(), c[3].finite())};
  });
  return mark;
}

SpacePart space(const JsonCursor& at) {
  SpacePart s;
  s.id = at["id"].text();
  s.name = at["name"].text();
  s.footprint_m = polygon(at["footprint_m"]);
  s.floor_z_m = at["floor_z_m"].finite();
  if (const auto power = at.find("power")) {
    s.power = {(*power)["power_w"].finite(), (*power)["area_m2"].finite(),
               whole((*power)["luminaires"]), whole((*power)["without_power"])};
  }
  s.height_m = at["height_m"].finite();
  s.triangles = size(at["triangles"]);
  s.degenerate_triangles = size(at["degenerate_triangles"]);
  s.luminaires = at["luminaires"].list_of(luminaire_mark);
  if (const auto bodies = at.find("bodies")) s.bodies = bodies->list_of(body_mark);
  if (const auto left_out = at.find("bodies_left_out")) s.bodies_left_out = size(*left_out);
  const JsonCursor balance = at["flux_balance"];
  s.balance = {balance["emitted_lm"].number(), balance["untraced_lm"].number(),
               estimate(balance["absorbed_lm"]), estimate(balance["escaped_lm"])};
  if (const auto notes = at.find("notes")) {
    s.notes = notes->list_of([](const JsonCursor& note) { return note.text(); });
  }
  s.planes = at["planes"].list_of([&](const JsonCursor& p) { return plane(p, s.id); });
  return s;
}

rules::AggregateMember member(const JsonCursor& at) {
  return {at["name"].text(), verdict(at["verdict"]), at["is_waived"].flag(),
          optional_number(at["area_m2"]), at["reason"].text()};
}

rules::AggregateFinding aggregate(const JsonCursor& at) {
  using rules::AggregateKind, rules::AggregateOver, rules::AggregateRule, rules::Severity;
  rules::AggregateFinding f;
  f.kind = at["kind"].one_of(std::array{AggregateKind::aggregate, AggregateKind::row_class},
                             rules::kind_name);
  f.id = at["id"].text();
  f.space_id = at["space"].text();
  f.plane_id = at["plane"].text();
  f.clause = at["clause"].text();
  f.note = at["note"].text();
  f.where = location(at["where"]);
  f.rule = at["rule"].one_of(std::array{AggregateRule::all, AggregateRule::any,
                                        AggregateRule::at_least, AggregateRule::share},
                             rules::rule_name);
  f.over = at["over"].one_of(
      std::array{AggregateOver::checks, AggregateOver::planes, AggregateOver::rooms},
      rules::over_name);
  f.count = whole(at["count"]);
  f.share = at["share"].finite();
  f.by_area = at["by_area"].flag();
  f.severity = at["severity"].one_of(std::array{Severity::shall, Severity::advice}, severity_key);
  f.verdict = verdict(at["verdict"]);
  f.is_waived = at["is_waived"].flag();
  if (f.is_waived && f.verdict == rules::Verdict::pass) {
    at["is_waived"].refuse("what passes cannot be waived");
  }
  f.reason = at["reason"].text();
  f.members = at["members"].list_of(member);
  f.asked = at["asked"].text();
  f.reached = at["reached"].text();
  f.possible = at["possible"].text();
  return f;
}

PhaseTimes times(const JsonCursor& at) {
  PhaseTimes t;
  t.load_s = at["load_s"].finite();
  t.prepare_s = at["prepare_s"].finite();
  t.direct_s = at["direct_s"].finite();
  t.pool_s = at["pool_s"].finite();
  t.connect_s = at["connect_s"].finite();
  t.near_s = at["near_s"].finite();
  if (const auto maps = at.find("maps_s")) t.maps_s = maps->finite();
  t.judge_s = at["judge_s"].finite();
  t.total_s = at["total_s"].finite();
  return t;
}

ProjectPart project(const JsonCursor& at) {
  ProjectPart p;
  p.path = at["path"].text();
  p.name = at["name"].text();
  p.is_judged = at["is_judged"].flag();
  p.diagnostics = at["diagnostics"].list_of(diagnostic);
  p.luminaires = at["luminaires"].list_of(luminaire);
  p.spaces = at["spaces"].list_of(space);
  p.inputs = at["inputs"].list_of([](const JsonCursor& input) {
    return calc::InputFile{input["path"].text(), input["sha256"].text()};
  });
  if (const auto found = at.find("aggregates")) p.aggregates = found->list_of(aggregate);
  if (const auto found = at.find("times")) p.times = times(*found);
  return p;
}

Document document(const JsonCursor& at) {
  if (at["format"].text() != "luxgate-result") at["format"].refuse("'luxgate-result' is needed");
  at["format_version"].whole(1, 1);
  return {provenance(at["provenance"]), at["projects"].list_of(project)};
}

}  // namespace

std::optional<Document> read_json(std::string_view bytes, std::string& problem) {
  try {
    const nlohmann::json json = nlohmann::json::parse(bytes);
    return document(JsonCursor(json));
  } catch (const BadJson& bad) {
    problem = bad.what();
  } catch (const nlohmann::json::exception& error) {
    problem = std::string("it is not JSON: ") + error.what();
  }
  return std::nullopt;
}

}  // namespace report
