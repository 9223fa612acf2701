#pragma once
// The result file, a plane: grid, points, statistics, course of its calculation. See
// result_fields.h.

#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/result_file/describe.h"
#include "report/result_file/finding_fields.h"
#include "report/text/words.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

void describe(auto& v, Is<calc::DroppedPoint> auto& point) {
  v.is("dropped");
  v.field("column", point.column);
  v.field("row", point.row);
  v.field("position_m", point.position_m);
  v.field("reason", point.reason);
  v.field("body", point.body, {.presence = only_if(!point.body.empty())});
}

// Returns whether the cells of pictures can be made from it.
inline bool is_whole(const calc::RouteGrid& route, const calc::SensorGrid& grid) {
  const std::vector<int>& stations = route.stations;
  return !stations.empty() && stations.size() + 1 == route.line.corner_m.size() &&
         *std::min_element(stations.begin(), stations.end()) > 0 && grid.rows > 0 &&
         std::accumulate(stations.begin(), stations.end(), std::int64_t{0}) == grid.columns;
}

void describe_route(auto& v, Is<calc::SensorGrid> auto& grid) {
  const auto fields = [&](auto& o) {
    calc::RouteGrid route = grid.route.value_or(calc::RouteGrid{});
    o.field("line_m", route.line.corner_m, {.words = "The corners of its centre line."});
    o.field("width_m", route.line.width_m);
    o.field("height_m", route.height_m, {.words = "Of the points above the walking surface."});
    o.field("stations", route.stations, {.words = "Columns of cells on each leg of the line."});
    o.refuse_if(!(route.line.width_m > 0.0), "width_m", "a number above 0 is needed");
    o.refuse_if(!is_whole(route, grid), "stations", "each leg needs its columns of the grid");
    o.refuse_if(!calc::route_fault(route.line).empty(), "line_m", "it is not the line of a route");
    assign(grid.route, std::optional(route));
  };
  v.object(
      "route", fields,
      {.words = "Of an escape route: its columns are stations along the line, its rows go from "
                "the right side to the left one.",
       .presence = only_if(grid.route.has_value())});
}

// Describes the grid and the plane's area.
void describe_grid(auto& v, Is<PlanePart> auto& plane) {
  // Most cells of a plane; a file must not make pictures of any size.
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
  describe_route(v, grid);
  // Pictures divide by them. A route has its own cells, and a list of points has none.
  const bool has_cells = grid.columns > 0 && !grid.route;
  constexpr const char* kAboveZero = "a number above 0 is needed";
  v.refuse_if(has_cells && !(grid.spacing_u_m > 0.0), "spacing_u_m", kAboveZero);
  v.refuse_if(has_cells && !(grid.spacing_v_m > 0.0), "spacing_v_m", kAboveZero);
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

void describe(auto& v, Is<AskedLight> auto& light) {
  v.is("asked_light",
       "The plane's points and statistics in the light that all its requirements ask "
       "for, where that is not all luminaires at full output.");
  v.field("scene", light.scene, {.words = "\"\": full output."});
  v.field("state", light.state);
  v.field("direct_only", light.direct_only);
  v.field("average_lx", light.average);
  v.field("minimum_lx", light.minimum);
  v.field("maximum_lx", light.maximum);
  v.field("uniformity_min_avg", light.uniformity_min_avg);
  v.field("uniformity_min_max", light.uniformity_min_max);
  v.written("columns",
            [] {
              return std::vector<std::string_view>{"illuminance_lx", "low_lx", "high_lx",
                                                   "direct_lx", "indirect_lx"};
            },
            {.words = "Of points, which are in the order of the plane's."});
  v.rows("points", light.points, [](auto& row, auto& p) {
    row(or_null(p.measured.value), or_null(p.measured.low), or_null(p.measured.high),
        or_null(p.direct_lx), or_null(p.indirect_lx));
  });
}

void describe(auto& v, Is<GroupShare> auto& share) {
  v.field("group", share.group);
  v.field("average_lx", share.average_lx);
  v.field("direct_lx", or_null(share.direct_lx));
  v.field("point_lx", share.point_lx,
          {.words = "At each point, in their order; only of planes with several groups, and not of "
                    "very many points.",
           .presence = only_if(!share.point_lx.empty())});
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

// Describes statistics. An average of ratings or ratios of points has no meaning.
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

// Describes values that only computed planes have.
void describe_results(auto& v, Is<PlanePart> auto& plane) {
  auto& counters = plane.counters;
  v.field("remarks", plane.remarks,
          {.words = "How the quantity was come by.", .presence = only_if(!plane.remarks.empty())});
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
  v.field("asked_light", plane.asked_light, {.presence = only_if(plane.asked_light.has_value())});
  v.refuse_if(plane.asked_light && plane.asked_light->points.size() != plane.points.size(),
              "asked_light", "as many values as the plane has points are needed");
  const auto lacks_points = [&](const GroupShare& share) {
    return !share.point_lx.empty() && share.point_lx.size() != plane.points.size();
  };
  v.refuse_if(std::any_of(plane.groups.begin(), plane.groups.end(), lacks_points), "groups",
              "each group needs as many values as the plane has points");
}

inline std::vector<std::string_view> plane_quantities() {
  std::vector<std::string_view> names;
  for (const calc::PlaneQuantity& known : calc::kPlaneQuantities) names.push_back(known.name);
  return names;
}

void describe(auto& v, Is<PlanePart> auto& plane) {
  v.is("plane");
  v.field("id", plane.id);
  v.field("was", plane.was, {.presence = only_if(!plane.was.empty())});
  v.field("name", plane.name);
  v.field("where", plane.where);
  // Two members share one name.
  std::string quantity(calc::quantity_name(plane.kernel, plane.derived));
  v.field("quantity", quantity,
          {.choices = plane_quantities(), .unknown = "unknown kind of point"});
  for (const calc::PlaneQuantity& known : calc::kPlaneQuantities) {
    if (known.name != quantity) continue;
    assign(plane.kernel, known.kernel);
    assign(plane.derived, known.derived);
  }
  v.field("is_computed", plane.is_computed);
  v.field("reason", plane.reason, {.words = "Why it was not computed."});
  v.field("findings", plane.findings);
  const auto zone = [&](auto& o) {
    o.field("made_by", plane.made_by);
    o.field("changed", plane.changed);
  };
  v.object("zone", zone,
           {.words = "Only of planes that a workplace has made: from what, and what the project "
                     "changed.",
            .presence = only_if(!plane.made_by.empty())});
  v.if_true("is_computed", plane.is_computed, [&] { describe_results(v, plane); });
}

}  // namespace report
