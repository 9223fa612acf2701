#pragma once
// Documents for tests of renderers. small_document(): few, exact, hand-made numbers.
// sample_document(): everything a report can show, with light from a simple closed form, so that
// pictures look like real ones.

#include "calc/base/diagnostics.h"
#include "report/document/document.h"
#include "report/document/luminaire_labels.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace report {

inline calc::Estimate estimate(double value, double half_width) {
  return {value, value - half_width, value + half_width};
}

// As the finding's own numbers have it; readers of results refuse everything else.
inline void judge_again(rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const rules::Decision decision = rules::decide(requirement, finding.measured);
  finding.verdict = decision.verdict;
  finding.is_close = decision.is_close;
  finding.by_tolerance = decision.by_tolerance;
  finding.margin = rules::margin(finding.measured.value, requirement.comparison, requirement.limit);
}

inline rules::Finding sample_finding(rules::Metric metric, double limit,
                                     const calc::Estimate& measured, std::string clause = {}) {
  rules::Finding finding;
  finding.requirement.id = calc::name_of(metric);
  finding.requirement.metric = metric;
  finding.requirement.limit = limit;
  finding.requirement.clause = calc::Message::words(std::move(clause));
  finding.measured = measured;
  judge_again(finding);
  if (finding.verdict == rules::Verdict::undecided)
    finding.reason = calc::Message::words("the interval contains the limit");
  return finding;
}

inline PointRow sample_point(int column, int row, const glm::dvec3& position_m,
                             const calc::Estimate& lx, double direct_lx) {
  PointRow point;
  point.position_m = position_m;
  point.normal = {0, 0, 1};
  point.column = column;
  point.row = row;
  point.measured = lx;
  point.direct_lx = direct_lx;
  point.indirect_lx = lx.value - direct_lx;
  return point;
}

// One project, one room, one plane of 2 x 1 points: average passes, minimum fails.
inline Document small_document() {
  PlanePart plane;
  plane.id = "work";
  plane.name = "Work plane";
  plane.space_id = "r1";
  plane.is_computed = true;
  plane.grid.rule = calc::Message::words("count");
  plane.grid.columns = 2;
  plane.grid.rows = 1;
  plane.grid.spacing_u_m = plane.grid.spacing_v_m = 1.5;
  plane.grid.origin_m = {0.5, 0.25, 0.8};
  plane.outline_m = {{0, 0}, {3, 0}, {3, 1.5}, {0, 1.5}};
  plane.points = {sample_point(0, 0, {1.25, 1.0, 0.8}, estimate(600.5, 6.25), 500.25),
                  sample_point(1, 0, {2.75, 1.0, 0.8}, estimate(424.5, 4.25), 324.0)};
  for (const PointRow& point : plane.points) {
    plane.grid.position_m.push_back(point.position_m);
    plane.grid.normal.push_back(point.normal);
    plane.grid.column.push_back(point.column);
    plane.grid.row.push_back(point.row);
  }
  plane.average = estimate(512.5, 4.0);
  plane.minimum = estimate(424.5, 4.25);
  plane.maximum = estimate(600.5, 6.25);
  plane.uniformity_min_avg = estimate(0.8283, 0.0062);
  plane.uniformity_min_max = estimate(0.7069, 0.0080);
  plane.findings = {
      sample_finding(rules::Metric::average, 500, plane.average, "EN 12464-1:2021 34.2"),
      sample_finding(rules::Metric::minimum, 450, plane.minimum)};
  plane.findings[1].place_m = plane.points[1].position_m;
  plane.stop = calc::StopReason::accurate;

  SpacePart space;
  space.id = "r1";
  space.name = "Office";
  space.footprint_m = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  space.height_m = 3.0;
  space.planes = {plane};

  ProjectPart project;
  project.path = "office.xml";
  project.name = "Small office";
  project.is_judged = true;
  project.spaces = {space};

  Document document;
  document.provenance.program_version = "0.1.0";
  document.provenance.command_line = "luxgate check office.xml --seed 1";
  document.provenance.seed = 1;
  document.provenance.backend = "cpu";
  document.provenance.numbers_version = 1;
  document.projects = {project};
  return document;
}

// Light of lambertian spots (intensity `peak_cd` straight down) plus a soft inter-reflected part.
struct SampleLight {
  std::vector<glm::dvec3> position_m;
  double peak_cd = 1000.0;
  double indirect_lx = 100.0;

  double direct(const glm::dvec3& p, const glm::dvec3& normal) const {
    double lx = 0.0;
    for (const glm::dvec3& source : position_m) {
      const glm::dvec3 path = source - p;
      const double distance = glm::length(path);
      const double leaving = std::max(0.0, path.z / distance);
      const double arriving = std::max(0.0, glm::dot(normal, path) / distance);
      lx += peak_cd * leaving * leaving * arriving / (distance * distance);
    }
    return lx;
  }
  double indirect(const glm::dvec3& p) const {
    return indirect_lx * (1.0 + 0.12 * std::sin(1.3 * p.x + 0.7 * p.y));
  }
};

inline void measure(PlanePart& plane) {
  double sum = 0.0, low = 1e300, high = 0.0;
  for (const PointRow& point : plane.points) {
    sum += point.measured.value;
    low = std::min(low, point.measured.value);
    high = std::max(high, point.measured.value);
  }
  const double average = sum / static_cast<double>(plane.points.size());
  plane.average = estimate(average, 0.0061 * average);
  plane.minimum = estimate(low, 0.011 * low);
  plane.maximum = estimate(high, 0.009 * high);
  plane.uniformity_min_avg = estimate(low / average, 0.009 * low / average);
  plane.uniformity_min_max = estimate(low / high, 0.012 * low / high);
  plane.is_computed = true;
  plane.stop = calc::StopReason::accurate;
  plane.looks_planned = 9;
  plane.counters = {4194304, 86400, 1572864, 262144, {plane.points.size(), 12, 2}};
}

inline glm::dvec3 lowest_place(const PlanePart& plane) {
  return std::min_element(plane.points.begin(), plane.points.end(),
                          [](const PointRow& a, const PointRow& b) {
                            return a.measured.value < b.measured.value;
                          })
      ->position_m;
}

// columns x rows cells from origin along u and v; keep(x, y) in metres says which cells have a
// point.
template <class Keep>
PlanePart sample_plane(std::string id, std::string name, const glm::dvec3& origin_m,
                       const glm::dvec3& u, const glm::dvec3& v, glm::ivec2 cells,
                       const glm::dvec2& size_m, const SampleLight& light, Keep keep) {
  PlanePart plane;
  plane.id = std::move(id);
  plane.name = std::move(name);
  plane.grid.rule = calc::Message::words("EN 12464-1 (p = 0.2 * 5^log10 d)");
  plane.grid.columns = cells.x;
  plane.grid.rows = cells.y;
  plane.grid.spacing_u_m = size_m.x / cells.x;
  plane.grid.spacing_v_m = size_m.y / cells.y;
  plane.grid.origin_m = origin_m;
  plane.grid.u = u;
  plane.grid.v = v;
  const glm::dvec3 normal = glm::cross(u, v);
  for (int row = 0; row < cells.y; ++row) {
    for (int column = 0; column < cells.x; ++column) {
      const double x = (column + 0.5) * plane.grid.spacing_u_m,
                   y = (row + 0.5) * plane.grid.spacing_v_m;
      const glm::dvec3 position = origin_m + x * u + y * v;
      if (!keep(x, y)) {
        plane.grid.dropped.push_back({position, column, row, calc::DropReason::outside_area, ""});
        continue;
      }
      const double direct = light.direct(position, normal);
      const double lx = direct + light.indirect(position);
      PointRow point = sample_point(column, row, position, estimate(lx, 0.012 * lx), direct);
      point.normal = normal;
      plane.points.push_back(point);
      plane.grid.position_m.push_back(position);
      plane.grid.normal.push_back(normal);
      plane.grid.column.push_back(column);
      plane.grid.row.push_back(row);
    }
  }
  plane.outline_m = {{0, 0}, {size_m.x, 0}, {size_m.x, size_m.y}, {0, size_m.y}};
  measure(plane);
  return plane;
}

inline SpacePart sample_office() {
  SpacePart space;
  space.id = "r101";
  space.name = "Open office";
  space.footprint_m = {{0, 0}, {9, 0}, {9, 4}, {5.4, 4}, {5.4, 7.2}, {0, 7.2}};
  space.height_m = 2.8;
  space.triangles = 1284;
  space.degenerate_triangles = 2;
  SampleLight light;
  for (const glm::dvec2 p :
       {glm::dvec2(1.5, 1.6), {4.2, 1.6}, {7.2, 1.6}, {1.5, 4.9}, {4.0, 4.9}}) {
    light.position_m.push_back({p, 2.8});
    space.luminaires.push_back({{p, 2.8}, "panel"});
  }
  light.peak_cd = 2310;
  light.indirect_lx = 96;
  space.balance = {21000, 0, estimate(20987, 61), estimate(0, 0)};

  PlanePart work =
      sample_plane("r101.work", "Work plane", {0.5, 0.5, 0.8}, {1, 0, 0}, {0, 1, 0}, {16, 12},
                   {8, 6.2}, light, [](double x, double y) { return x < 4.4 || y < 3.0; });
  work.outline_m = {{0, 0}, {8, 0}, {8, 3}, {4.4, 3}, {4.4, 6.2}, {0, 6.2}};
  work.grid.margin_m = 0.5;
  work.grid.dropped.push_back({{2, 2, 0.8}, 3, 3, calc::DropReason::inside_solid, "cupboard"});
  work.findings = {
      sample_finding(rules::Metric::average, 500, work.average, "EN 12464-1:2021 34.2"),
      sample_finding(rules::Metric::uniformity_min_avg, 0.6, work.uniformity_min_avg,
                     "EN 12464-1:2021 34.2"),
      sample_finding(rules::Metric::minimum, 240, work.minimum)};
  work.findings[1].place_m = work.findings[2].place_m = lowest_place(work);

  PlanePart board = sample_plane("r101.board", "Whiteboard", {9, 3.2, 0.9}, {0, -1, 0}, {0, 0, 1},
                                 {10, 5}, {2.6, 1.2}, light, [](double, double) { return true; });
  board.findings = {sample_finding(rules::Metric::average, std::round(board.average.value),
                                   board.average, "EN 12464-1:2021 44.4")};
  board.findings[0].requirement.limit += 1;
  judge_again(board.findings[0]);
  board.findings[0].reason =
      calc::Message::words("the interval contains the limit; more light paths would decide");
  space.planes = {std::move(work), std::move(board)};
  return space;
}

inline SpacePart sample_hall() {
  SpacePart space;
  space.id = "r200";
  space.name = "Sports hall";
  space.footprint_m = {{0, 0}, {46, 0}, {46, 28}, {0, 28}};
  space.height_m = 9;
  space.triangles = 96;
  SampleLight light;
  light.peak_cd = 9400;
  light.indirect_lx = 130;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 4; ++j) {
      light.position_m.push_back({4.0 + 7.6 * i, 4.0 + 6.7 * j, 8.5});
      space.luminaires.push_back({light.position_m.back(), "hall <b>\"80 W\"</b>"});
    }
  }
  space.balance = {264000, 0, estimate(263700, 900), estimate(0, 0)};
  PlanePart floor = sample_plane("r200.floor", "Court", {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {88, 52},
                                 {44, 26}, light, [](double, double) { return true; });
  floor.findings = {sample_finding(rules::Metric::minimum, 260, floor.minimum, "EN 12193")};
  floor.findings[0].place_m = lowest_place(floor);
  PlanePart spots;
  spots.id = "r200.spots";
  spots.name = "Site measurement";
  spots.grid.rule = calc::Message::words("point list");
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 p(5.0 + 11.0 * i, 14.0, 1.0);
    const double direct = light.direct(p, {0, 0, 1}), lx = direct + light.indirect(p);
    spots.points.push_back(sample_point(0, 0, p, estimate(lx, 0.01 * lx), direct));
  }
  measure(spots);
  PlanePart stand;
  stand.id = "r200.stand";
  stand.name = "Stand";
  stand.reason =
      calc::Message::words("no point of the grid is left: all 24 lie inside the solid 'stand'");
  stand.findings = {sample_finding(rules::Metric::average, 200, {})};
  stand.findings[0].verdict = rules::Verdict::not_judged;
  stand.findings[0].is_close = false;
  stand.findings[0].reason = calc::Message::words("the plane was not computed");
  space.planes = {std::move(floor), std::move(spots), std::move(stand)};
  return space;
}

inline Document sample_document() {
  ProjectPart project;
  project.path = "school/project.xml";
  project.name = "School, phase 2 <script>alert('x')</script>";
  project.is_judged = true;
  project.spaces = {sample_office(), sample_hall()};
  LuminaireRow panel;
  panel.type_id = "panel";
  panel.photometry_file = "photometry/panel-600.ldt";
  panel.name = "LED panel 600, 4000 K";
  panel.format = "EULUMDAT";
  panel.count = 5;
  panel.flux_lm = 4200;
  panel.power_w = 32.5;
  panel.max_intensity_cd = 1720;
  panel.maintenance_factor = 0.92 * 0.94 * 0.95;
  panel.maintenance.product = panel.maintenance_factor;
  panel.maintenance.llmf = 0.92;
  panel.maintenance.lsf = 1.0;
  panel.maintenance.lmf = 0.94;
  panel.maintenance.rsmf = 0.95;
  panel.housing_material = "white metal";
  panel.housing_depth_m = 0.08;
  panel.sha256 = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";
  LuminaireRow hall = panel;
  hall.type_id = "hall <b>\"80 W\"</b>";
  hall.photometry_file = "photometry/hall.ies";
  hall.name = "High bay";
  hall.format = "IESNA:LM-63-2002";
  hall.count = 24;
  hall.flux_lm = 11000;
  hall.power_w = 0;
  hall.max_intensity_cd = 9400;
  hall.maintenance = {};
  hall.housing_material = "";
  hall.housing_depth_m = 0.0;
  hall.maintenance_factor = 0.8;
  hall.sha256 = "60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752";
  project.luminaires = {panel, hall};
  project.inputs = {
      {"school/project.xml", "fd61a03af4f77d870fc21e05e7e80678095c92d808cfb3b5c279ee04c74aca13"},
      {"school/photometry/panel-600.ldt", panel.sha256},
      {"school/photometry/hall.ies", hall.sha256}};
  label_luminaires(project);

  Document document;
  document.provenance.program_version = "0.1.0";
  document.provenance.command_line =
      "luxgate check school/project.xml yard.xml --seed 1 --output out";
  document.provenance.seed = 1;
  document.provenance.max_paths = 1048576;
  document.provenance.replicates = 16;
  document.provenance.backend = "cpu";
  document.provenance.numbers_version = 1;
  document.projects.push_back(std::move(project));
  ProjectPart broken;
  broken.path = "yard.xml";
  const calc::SourceLocation where{"yard.xml", 12, 5};
  calc::Diagnostics found;
  found.report(*calc::diagnostic_from_name("file-not-readable"), where, "yard.ies",
               "No such file or directory");
  broken.diagnostics = found.all();
  document.projects.push_back(std::move(broken));
  return document;
}

// small_document() with a route in place of its plane: 4 m along x, then 3 m along y, 1.2 m wide;
// the value of a point is the number of its column, so that lines of equal value run across.
inline Document route_document(double spacing_m = 0.5) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  calc::EscapeRoute route;
  route.line = {{{1, 1, 0}, {5, 1, 0}, {5, 4, 0}}, 1.2};
  route.spacing = {spacing_m, 0.4, {}};
  route.is_spacing_given = true;
  calc::CalcPlane of;
  of.area = route;
  calc::Diagnostics diagnostics;
  plane.grid = calc::make_sensor_grid(of, calc::Space{}, diagnostics).value();
  plane.outline_m = plane.grid.outline_m;
  plane.points.clear();
  for (std::size_t i = 0; i < plane.grid.position_m.size(); ++i) {
    plane.points.push_back(sample_point(plane.grid.column[i], plane.grid.row[i],
                                        plane.grid.position_m[i],
                                        estimate(100.0 + plane.grid.column[i], 0), 0));
  }
  return document;
}

}  // namespace report
