#include "report/html/drawings/plan_layout.h"

#include "calc/base/elementary.h"
#include "report/html/drawings/flat_box.h"
#include "report/text/point_thresholds.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace report {
namespace {

glm::dvec2 in_plane(const calc::SensorGrid& grid, const glm::dvec3& world_m) {
  const glm::dvec3 offset = world_m - grid.origin_m;
  return {glm::dot(offset, grid.u), glm::dot(offset, grid.v)};
}

FlatBox plane_box(const PlanePart& plane) {
  FlatBox box;
  if (!plane.grid.route) {
    box.add({0.0, 0.0});
    box.add(
        {plane.grid.columns * plane.grid.spacing_u_m, plane.grid.rows * plane.grid.spacing_v_m});
  }
  for (const glm::dvec2& corner : plane.outline_m) box.add(corner);
  return box;
}

// Of two ends of which neither is in the picture the line may still cross it: boxes decide.
std::vector<PlanLine> furniture(const SpacePart& space, const calc::SensorGrid& grid,
                                const FlatBox& picture) {
  std::vector<PlanLine> lines;
  for (const BodyMark& body : space.bodies) {
    for (const auto& line : body.lines_m) {
      PlanLine sign{in_plane(grid, {line[0], grid.origin_m.z}),
                    in_plane(grid, {line[1], grid.origin_m.z}), body.low_z_m > grid.origin_m.z};
      FlatBox box;
      box.add(sign.from_m);
      box.add(sign.to_m);
      if (box.meets(picture)) lines.push_back(sign);
    }
  }
  return lines;
}

}  // namespace

PlanLayout lay_out_plan(const SpacePart& space, const PlanePart& plane,
                        const glm::dvec2& wanted_px) {
  constexpr double kFairPart = 0.3;  // of the room's longer side
  constexpr double kEdge = 0.015;
  constexpr double kSurroundings = 0.12;  // of the plane's longer side
  const calc::SensorGrid& grid = plane.grid;
  const bool is_plan_view = is_horizontal(glm::cross(grid.u, grid.v));
  PlanLayout layout;
  FlatBox box = plane_box(plane);
  FlatBox room;
  if (is_plan_view) {
    for (const glm::dvec2& corner : space.footprint_m) {
      layout.room_m.push_back(in_plane(grid, {corner, grid.origin_m.z}));
      room.add(layout.room_m.back());
    }
  }
  const bool shows_room = !layout.room_m.empty() && box.longest() >= kFairPart * room.longest();
  if (shows_room) {
    for (const glm::dvec2& corner : layout.room_m) box.add(corner);
  }
  const double border = (is_plan_view && !shows_room ? kSurroundings : kEdge) * box.longest();
  box = {box.low - border, box.high + border};
  layout.low_m = box.low;
  layout.high_m = box.high;
  layout.pixels_per_metre = std::min(wanted_px.x / box.size().x, wanted_px.y / box.size().y);
  if (!is_plan_view) return layout;
  for (const LuminaireMark& mark : space.luminaires) {
    PlanLuminaire sign;
    sign.label = mark.label;
    sign.place_m = in_plane(grid, mark.position_m);
    if (!box.contains(sign.place_m)) continue;
    for (const glm::dvec2& corner : mark.outline_m)
      sign.outline_m.push_back(in_plane(grid, {corner, grid.origin_m.z}));
    const glm::dvec3 c0(mark.c0.x, mark.c0.y, 0.0);
    sign.c0 = {glm::dot(c0, grid.u), glm::dot(c0, grid.v)};
    layout.luminaires_m.push_back(std::move(sign));
  }
  layout.furniture_m = furniture(space, grid, box);
  return layout;
}

std::vector<PlanLimit> plan_limits(const Texts& t, const PlanePart& plane) {
  std::vector<PlanLimit> limits;
  for (const rules::Finding& finding : plane.findings) {
    const rules::Requirement& requirement = finding.requirement;
    const bool is_of_values = rules::has_unit_of_values(requirement.metric);
    const bool is_known = !std::isnan(requirement.limit);
    if (!is_of_values || !is_known || !is_about_points(plane, requirement)) continue;
    limits.push_back({quantity_words(t, requirement) + " " +
                          format_required(t, {requirement.limit, requirement.comparison},
                                          rules::unit_of(requirement)),
                      requirement.limit});
  }
  return limits;
}

double scale_bar_m(double width_m) {
  const double longest = width_m / 3.0;
  const double power = calc::pow(10.0, std::floor(calc::log10(longest)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= longest) return factor * power;
  }
  return power;
}

}  // namespace report
