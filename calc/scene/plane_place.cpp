#include "calc/scene/plane_place.h"

#include "calc/scene/polygon.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"
#include "calc/scene/solids.h"

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

namespace {

// Whether the segment runs through the inside of the room, more than a trifle from its surfaces.
bool runs_through(const RoomShell& shell, const glm::dvec3& from_m, const glm::dvec3& to_m) {
  constexpr double kTrifle_m = 0.01;
  constexpr int kPlaces = 64;
  const double low_m = shell.floor_z_m + kTrifle_m;
  const double high_m = shell.floor_z_m + shell.height_m - kTrifle_m;
  double begin = 0.0, end = 1.0;
  const double up_m = to_m.z - from_m.z;
  if (up_m == 0.0) {
    if (from_m.z < low_m || from_m.z > high_m) return false;
  } else {
    const double a = (low_m - from_m.z) / up_m, b = (high_m - from_m.z) / up_m;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    if (!(begin < end)) return false;
  }
  for (int k = 0; k < kPlaces; ++k) {
    const glm::dvec2 at(from_m + (begin + (end - begin) * (k + 0.5) / kPlaces) * (to_m - from_m));
    if (contains_point(shell.footprint_m, at) &&
        distance_to_boundary(shell.footprint_m, at) > kTrifle_m) {
      return true;
    }
  }
  return false;
}

}  // namespace

const Space* room_between(const Project& project, const Space& open_space,
                          const std::vector<glm::dvec3>& points_m, const LightScene* scene) {
  constexpr std::size_t kMostPoints = 256;
  constexpr double kTrifle = 0.01;
  BoundingBox light;
  for (const glm::dvec3& point : points_m) light.add(point);
  for (const Luminaire& luminaire : open_space.luminaires) light.add(luminaire.position_m);
  std::vector<const Space*> rooms;
  for (const Space& room : project.spaces) {
    if (!room.shell) continue;
    BoundingBox box;
    for (const glm::dvec2& corner : room.shell->footprint_m) {
      box.add({corner, room.shell->floor_z_m});
      box.add({corner, room.shell->floor_z_m + room.shell->height_m});
    }
    if (glm::all(glm::lessThan(box.lower, light.upper)) &&
        glm::all(glm::greaterThan(box.upper, light.lower))) {
      rooms.push_back(&room);
    }
  }
  if (rooms.empty()) return nullptr;
  const std::size_t apart = (points_m.size() + kMostPoints - 1) / kMostPoints;
  for (std::size_t i = 0; i < points_m.size(); i += apart) {
    double all_lx = 0.0, hidden_lx = 0.0;
    const Space* hiding = nullptr;
    for (const Luminaire& luminaire : open_space.luminaires) {
      const glm::dvec3 way_m = points_m[i] - luminaire.position_m;
      const double distance2 = glm::dot(way_m, way_m);
      if (!(distance2 > 0.0)) continue;
      const glm::dvec3 out =
          glm::transpose(luminaire.world_from_luminaire) * (way_m / std::sqrt(distance2));
      const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
      const double lx = web.intensity_cd({out.x, out.y, out.z}) *
                        installed_flux_scale(project, luminaire) *
                        level_in_scene(scene, luminaire.group) / distance2;
      if (!(lx > 0.0)) continue;
      all_lx += lx;
      const auto found = std::find_if(rooms.begin(), rooms.end(), [&](const Space* room) {
        return runs_through(*room->shell, luminaire.position_m, points_m[i]);
      });
      if (found == rooms.end()) continue;
      hidden_lx += lx;
      hiding = *found;
    }
    if (hidden_lx > kTrifle * all_lx) return hiding;
  }
  return nullptr;
}

}  // namespace calc
