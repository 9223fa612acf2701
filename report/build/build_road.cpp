#include "report/build/build_road.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/road/road_values.h"
#include "report/document/road_facts.h"
#include "rules/catalogue/metric.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace report {
namespace {

std::string scene_asked_of_road(const std::vector<PlanePart>& planes) {
  for (const PlanePart& plane : planes) {
    for (const rules::Finding& finding : plane.findings) {
      if (rules::is_of_road(finding.requirement.metric)) return finding.requirement.scene;
    }
  }
  return {};
}

const calc::LightScene* scene_named(const calc::Project& project, const std::string& id) {
  const auto found = std::find_if(project.scenes.begin(), project.scenes.end(),
                                  [&](const calc::LightScene& scene) { return scene.id == id; });
  return found == project.scenes.end() ? nullptr : &*found;
}

RoadRowPart row_of_road(const calc::Project& project, const calc::Road& road,
                        const calc::Luminaire& luminaire) {
  const calc::LuminaireType& type = project.luminaire_types[luminaire.type];
  // Seen along the road, the axis of a luminaire whose left side is lifted leans to the right.
  const glm::dvec3& axis = luminaire.world_from_luminaire[2];
  RoadRowPart row;
  row.id = luminaire.id;
  row.type_id = type.id;
  row.group = luminaire.group;
  row.height_m = luminaire.position_m.z;
  row.y_m = luminaire.position_m.y;
  row.shift_m = first_shift_m(luminaire.position_m.x, road.spacing_m);
  row.tilt_deg = calc::degrees_from_radians(calc::atan2(-axis.y, axis.z)) + 0.0;  // no -0
  row.power_w = type.power_w;
  row.maintenance_factor = type.maintenance.product;
  return row;
}

// Its plane is a rectangle that is as long as the field.
std::optional<RoadAreaPart> area_of_road(const calc::Road& road, const calc::CalcPlane& plane) {
  const auto* area = std::get_if<calc::PlanarArea>(&plane.area);
  if (area == nullptr || area->outline_m.empty()) return std::nullopt;
  const double from_m = glm::dot(area->origin_m - road.origin_m, road.world_from_road[1]);
  const double width_m =
      std::max_element(area->outline_m.begin(), area->outline_m.end(),
                       [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; })
          ->y;
  return RoadAreaPart{plane.id, plane.name, from_m, from_m + width_m};
}

}  // namespace

std::optional<RoadPart> build_road(const calc::Project& project, const calc::Space& space,
                                   const std::vector<PlanePart>& planes) {
  if (!space.road) return std::nullopt;
  const calc::Road& road = *space.road;
  RoadPart part;
  const calc::LightScene* scene = scene_named(project, scene_asked_of_road(planes));
  if (scene != nullptr) part.scene = scene->id;
  const calc::RoadLayout layout = calc::road_layout(project, space, scene);
  part.spacing_m = road.spacing_m;
  part.width_m = road.width_m;
  part.surface = road.surface;
  part.q0 = layout.q0;
  for (const calc::Luminaire& luminaire : road.rows) {
    if (project.luminaire_types[luminaire.type].counts_as_luminaire())
      part.rows.push_back(row_of_road(project, road, luminaire));
  }
  for (const calc::CalcPlane& plane : space.planes) {
    if (std::optional<RoadAreaPart> area = area_of_road(road, plane))
      part.areas.push_back(*std::move(area));
  }
  part.light = calc::road_light(layout);
  return part;
}

}  // namespace report
