#include "calc/scene/plane_place.h"

#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace calc {

std::vector<glm::dvec3> places_of(const CalcPlane& plane) {
  if (const auto* list = std::get_if<PointList>(&plane.area)) return list->position_m;
  if (const auto* route = std::get_if<EscapeRoute>(&plane.area)) return route->line.corner_m;
  const auto& area = std::get<PlanarArea>(plane.area);
  std::vector<glm::dvec3> places;
  for (const glm::dvec2& corner : area.outline_m) {
    places.push_back(area.origin_m + corner.x * area.u + corner.y * area.v);
  }
  return places;
}

std::vector<glm::dvec3> normals_of(const CalcPlane& plane) {
  if (const auto* list = std::get_if<PointList>(&plane.area)) return list->normal;
  if (const auto* route = std::get_if<EscapeRoute>(&plane.area)) {
    return std::vector<glm::dvec3>(route->line.corner_m.size(), glm::dvec3(0, 0, 1));
  }
  const auto& area = std::get<PlanarArea>(plane.area);
  return std::vector<glm::dvec3>(area.outline_m.size(), area.normal());
}

double opening_reach_m(const LuminousOpening& opening, const Luminaire& luminaire,
                       const glm::dvec3& direction) {
  // Along each axis of the luminaire: half of the size, as seen along the direction.
  glm::dvec3 along = 0.5 * opening.size_m();
  for (int axis = 0; axis < 3; ++axis) {
    along[axis] *= std::abs(glm::dot(luminaire.world_from_luminaire[axis], direction));
  }
  const auto round = [](double a, double b) { return std::sqrt(a * a + b * b); };
  switch (opening.shape) {
    case OpeningShape::point:
    case OpeningShape::rectangle:
    case OpeningShape::box:
      return along.x + along.y + along.z;
    case OpeningShape::disk:
    case OpeningShape::cylinder:
      return round(along.x, along.y) + along.z;
    case OpeningShape::cylinder_c0:
      return along.x + round(along.y, along.z);
    case OpeningShape::cylinder_c90:
      return along.y + round(along.x, along.z);
    case OpeningShape::ellipsoid:
      break;
  }
  return glm::length(along);
}

bool faces_away(const Project& project, const Space& space, const CalcPlane& plane,
                const LightScene* scene) {
  constexpr double kTouch_m = 1.0e-6, kWeak = 1.0e-3;
  std::vector<double> flux_lm;
  double most_lm = 0.0;
  for (const Luminaire& luminaire : space.luminaires) {
    const double web_lm = project.webs[project.luminaire_types[luminaire.type].web].flux_lm();
    flux_lm.push_back(web_lm * installed_flux_scale(project, luminaire) *
                      level_in_scene(scene, luminaire.group));
    most_lm = std::max(most_lm, flux_lm.back());
  }
  if (!(most_lm > 0.0)) return false;
  const std::vector<glm::dvec3> places = places_of(plane), normals = normals_of(plane);
  const auto is_behind = [&](const Luminaire& luminaire, std::size_t i) {
    const LuminousOpening& opening =
        project.webs[project.luminaire_types[luminaire.type].web].opening();
    return glm::dot(normals[i], luminaire.position_m - places[i]) +
               opening_reach_m(opening, luminaire, normals[i]) <=
           kTouch_m;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < space.luminaires.size(); ++k) {
      if (flux_lm[k] >= kWeak * most_lm && !is_behind(space.luminaires[k], i)) return false;
    }
  }
  return true;
}

}  // namespace calc
