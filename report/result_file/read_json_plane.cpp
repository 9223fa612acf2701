#include "report/result_file/read_json_parts.h"
#include "report/text/words.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace report {
namespace {

// As many as a plane may have; a file must not make pictures of any size.
constexpr std::int64_t kMostCells = 4'000'000;

calc::DroppedPoint dropped(const JsonCursor& at) {
  using enum calc::DropReason;
  calc::DroppedPoint point{read_vec3(at["position_m"]), read_whole(at["column"]),
                           read_whole(at["row"]), outside_area, ""};
  point.reason = at["reason"].one_of(
      std::array{outside_area, within_margin, outside_room, inside_solid}, drop_key);
  if (const auto body = at.find("body")) point.body = body->text();
  return point;
}

calc::SensorGrid grid(const JsonCursor& at) {
  calc::SensorGrid g;
  g.rule = at["rule"].text();
  g.columns = read_whole(at["columns"]);
  g.rows = read_whole(at["rows"]);
  if (std::int64_t{g.columns} * g.rows > kMostCells)
    at["columns"].refuse("the grid has too many cells");
  g.spacing_u_m = at["spacing_u_m"].finite();
  g.spacing_v_m = at["spacing_v_m"].finite();
  g.margin_m = at["margin_m"].finite();
  g.origin_m = read_vec3(at["origin_m"]);
  g.u = read_vec3(at["u"]);
  g.v = read_vec3(at["v"]);
  g.dropped = at["dropped"].list_of(dropped);
  return g;
}

PointRow point(const JsonCursor& at) {
  constexpr std::size_t kColumns = 13;
  const std::vector<JsonCursor> c = at.items(kColumns);
  PointRow row;
  row.column = read_whole(c[0]);
  row.row = read_whole(c[1]);
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
  return {at["group"].text(), read_estimate(at["average_lx"]), at["direct_lx"].number()};
}

LuminaireShare light_of(const JsonCursor& at) {
  LuminaireShare share;
  share.average_lx = read_estimate(at["average_lx"]);
  share.direct_lx = at["direct_lx"].number();
  share.minimum_lx = read_estimate(at["minimum_lx"]);
  share.minimum_direct_lx = at["minimum_direct_lx"].number();
  return share;
}

LuminaireShare luminaire_share(const JsonCursor& at) {
  LuminaireShare share = light_of(at);
  share.id = at["id"].text();
  share.type_id = at["type"].text();
  share.group = at["group"].text();
  share.position_m = read_vec3(at["position_m"]);
  return share;
}

LuminaireShares luminaire_shares(const JsonCursor& at) {
  LuminaireShares shares;
  shares.minimum_at_m = read_vec3(at["minimum_at_m"]);
  shares.largest = at["largest"].list_of(luminaire_share);
  if (const auto others = at.find("others")) {
    shares.others = read_size((*others)["count"]);
    shares.rest = light_of(*others);
  }
  return shares;
}

PlaneLook look(const JsonCursor& at, std::size_t findings) {
  PlaneLook l;
  l.paths = at["paths"].count();
  l.rays = at["rays"].count();
  l.points = read_size(at["points"]);
  l.average_lx = read_estimate(at["average_lx"]);
  for (const JsonCursor& item : at["findings"].items(findings)) {
    LookFinding f;
    f.verdict = read_verdict(item["verdict"]);
    if (f.verdict != rules::Verdict::not_judged) f.measured = read_estimate(item["measured"]);
    l.findings.push_back(f);
  }
  return l;
}

}  // namespace

PlanePart read_plane(const JsonCursor& at, const std::string& space_id) {
  PlanePart p;
  p.id = at["id"].text();
  p.name = at["name"].text();
  p.space_id = space_id;
  p.where = read_location(at["where"]);
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
  p.findings = at["findings"].list_of([&](const JsonCursor& f) { return read_finding(f, p); });
  if (const auto zone = at.find("zone")) {
    p.made_by = (*zone)["made_by"].text();
    p.changed = (*zone)["changed"].text();
  }
  if (!p.is_computed) return p;
  const JsonCursor statistics = at["statistics"];
  if (calc::is_plain_number(p.derived)) {
    p.average_lx = p.uniformity_min_avg = p.uniformity_min_max = no_estimate();
    p.minimum_lx = read_estimate(statistics["minimum"]);
    p.maximum_lx = read_estimate(statistics["maximum"]);
  } else {
    p.average_lx = read_estimate(statistics["average_lx"]);
    p.minimum_lx = read_estimate(statistics["minimum_lx"]);
    p.maximum_lx = read_estimate(statistics["maximum_lx"]);
    p.uniformity_min_avg = read_estimate(statistics["uniformity_min_avg"]);
    p.uniformity_min_max = read_estimate(statistics["uniformity_min_max"]);
  }
  p.stop = stop(at["stop"]);
  p.looks_planned = read_whole(at["looks_planned"]);
  p.unseen_points = read_size(at["unseen_points"]);
  p.single_sample_points = read_size(at["single_sample_points"]);
  const JsonCursor counters = at["counters"];
  p.counters = {counters["paths"].count(), counters["direct_rays"].count(),
                counters["connection_rays"].count(), counters["near_rays"].count(),
                at["points_per_look"].list_of(read_size)};
  if (const auto groups = at.find("groups")) p.groups = groups->list_of(group_share);
  if (const auto shares = at.find("by_luminaire")) p.by_luminaire = luminaire_shares(*shares);
  if (const auto looks = at.find("look_results")) {
    p.looks = looks->list_of([&](const JsonCursor& l) { return look(l, p.findings.size()); });
  }
  p.grid = grid(at["grid"]);
  p.grid.kernel = p.kernel;
  p.grid.derived = p.derived;
  p.outline_m = read_polygon(at["grid"]["outline_m"]);
  p.holes_m = at["grid"]["holes_m"].list_of(read_polygon);
  add_points(at["points"], p);
  settle_estimates(p);
  return p;
}

}  // namespace report
