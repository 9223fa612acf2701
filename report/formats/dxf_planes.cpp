#include "report/formats/dxf_planes.h"

#include "calc/scene/polygon.h"
#include "report/text/plane_names.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace report {
namespace {

bool is_of_task(const rules::Finding& finding) { return finding.requirement.origin.is_of_own_role; }

// Points of one lie in the area of the other: their numbers would be mixed.
bool has_points_in(const PlanePart& plane, const PlanePart& area) {
  const calc::SensorGrid& grid = area.grid;
  const auto is_in = [&](const PointRow& point) {
    const glm::dvec3 offset = point.position_m - grid.origin_m;
    const glm::dvec2 uv(glm::dot(offset, grid.u), glm::dot(offset, grid.v));
    return calc::contains_point(area.outline_m, uv) &&
           std::none_of(area.holes_m.begin(), area.holes_m.end(),
                        [&](const auto& hole) { return calc::contains_point(hole, uv); });
  };
  return std::any_of(plane.points.begin(), plane.points.end(), is_in);
}

bool meet(const PlanePart& a, const FlatBox& box_a, const PlanePart& b, const FlatBox& box_b) {
  if (!box_a.meets(box_b)) return false;
  if (a.outline_m.empty() || b.outline_m.empty()) return true;
  return has_points_in(a, b) || has_points_in(b, a);
}

}  // namespace

rules::Outcome gravest_outcome(const PlanePart& plane) {
  if (!plane.is_computed) return rules::Outcome::not_judged;
  rules::Outcome gravest = rules::Outcome::nothing_asked;
  for (const rules::Finding& finding : plane.findings)
    gravest = rules::graver(gravest, rules::outcome_of(finding));
  return gravest;
}

bool is_level_plane(const PlanePart& plane) {
  return is_horizontal(glm::cross(plane.grid.u, plane.grid.v));
}

std::string plane_label(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  const bool is_outside =
      std::any_of(plane.findings.begin(), plane.findings.end(),
                  [](const auto& finding) { return is_outside_advice(finding); });
  const rules::Outcome outcome = gravest_outcome(plane);
  std::string words = fmt::format("{}: {}", plane_name(t, space, plane),
                                  is_outside && outcome == rules::Outcome::nothing_asked
                                      ? t[Text::advice_outside]
                                      : outcome_words(t, outcome));
  if (!plane.is_computed) words += std::string(", ") + t[Text::not_computed];
  if (plane.is_computed && !is_plain_illuminance(plane)) words += ", " + values_words(t, plane);
  if (!doubt_words(t, plane).empty()) words += fmt::format(" ({})", t[Text::doubt]);
  return words;
}

bool is_task_area(const SpacePart& space, const PlanePart& plane) {
  const auto is_own = [](const PlanePart& one) {
    return one.made_by.empty() ||
           (is_plain_illuminance(one) &&
            std::any_of(one.findings.begin(), one.findings.end(), is_of_task));
  };
  if (!is_own(plane)) return false;
  return !plane.findings.empty() ||
         std::none_of(space.planes.begin(), space.planes.end(), [&](const PlanePart& other) {
           return !other.findings.empty() && is_own(other);
         });
}

PlaneLayers plane_layers(bool is_task, std::size_t tier) {
  const std::string kind = is_task ? "" : kOtherLayers;
  const std::string number = tier == 0 ? "" : fmt::format("_{}", tier + 1);
  return {"LUX_PLANES" + kind,
          "LUX_PLANE_NAMES" + kind,
          "LUX_VALUES" + kind + number,
          "LUX_ISOLUX" + kind + number,
          "LUX_ISOLUX_LIMITS" + kind + number,
          "LUX_ISOLUX_LABELS" + kind + number};
}

FlatBox drawn_box(const PlanePart& plane) {
  FlatBox box;
  const calc::SensorGrid& grid = plane.grid;
  for (const glm::dvec2& corner : plane.outline_m)
    box.add(grid.origin_m + corner.x * grid.u + corner.y * grid.v);
  for (const PointRow& point : plane.points) box.add(point.position_m);
  return box;
}

std::size_t Tiers::tier_of(const PlanePart& plane) {
  const FlatBox box = drawn_box(plane);
  std::size_t tier = 0;
  for (; tier < tiers_.size(); ++tier) {
    const bool is_free = std::none_of(
        tiers_[tier].begin(), tiers_[tier].end(),
        [&](const auto& other) { return meet(plane, box, *other.first, other.second); });
    if (is_free) break;
  }
  if (tier == tiers_.size()) tiers_.emplace_back();
  tiers_[tier].emplace_back(&plane, box);
  return tier;
}

}  // namespace report
