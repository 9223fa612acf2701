#include "calc/scene/prepared_scene.h"

#include "calc/scene/opening_fit.h"
#include "calc/scene/plane_place.h"
#include "calc/scene/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace calc {
namespace {

BoundingBox bounds_of(const Space& space) {
  BoundingBox box;
  for (const Body& body : space.bodies) {
    for (const glm::dvec3& vertex : body.vertex_m) box.add(vertex);
  }
  for (const Luminaire& luminaire : space.luminaires) box.add(luminaire.position_m);
  return box;
}

BoundingBox bounds_of(const RoomShell& shell) {
  BoundingBox box;
  for (const glm::dvec2& corner : shell.footprint_m) {
    box.add({corner, shell.floor_z_m});
    box.add({corner, shell.floor_z_m + shell.height_m});
  }
  return box;
}

// Of all that is asked about: the room, or else what gives light and what is lit.
BoundingBox core_of(const Space& space) {
  if (space.shell) return bounds_of(*space.shell);
  BoundingBox box;
  for (const Luminaire& luminaire : space.luminaires) box.add(luminaire.position_m);
  for (const CalcPlane& plane : space.planes) {
    for (const glm::dvec3& place : places_of(plane)) box.add(place);
  }
  return box;
}

// What of all the space is near.
BoundingBox near_of(const Space& space, const BoundingBox& all) {
  constexpr double kDiagonals = 4.0;
  const BoundingBox core = core_of(space);
  const double around_m = kDiagonals * core.diagonal();
  if (all.is_empty() || !(around_m > 0.0)) return all;
  BoundingBox near;
  near.lower = glm::max(all.lower, core.lower - around_m);
  near.upper = glm::min(all.upper, core.upper + around_m);
  const bool is_apart = glm::any(glm::greaterThan(near.lower, near.upper));
  return is_apart ? core : near;
}

// The box of a triangle reaches into the other one, or touches it.
bool reaches(const std::array<glm::dvec3, 3>& corner_m, const BoundingBox& box) {
  const glm::dvec3 low = glm::min(corner_m[0], glm::min(corner_m[1], corner_m[2]));
  const glm::dvec3 high = glm::max(corner_m[0], glm::max(corner_m[1], corner_m[2]));
  return glm::all(glm::lessThanEqual(low, box.upper)) &&
         glm::all(glm::greaterThanEqual(high, box.lower));
}

std::array<glm::dvec3, 3> corners_m(const Body& body, const glm::uvec3& triangle) {
  return {body.vertex_m[triangle.x], body.vertex_m[triangle.y], body.vertex_m[triangle.z]};
}

// Of triangles that reach into the box and out of it.
double rounding_of(const Space& space, const glm::dvec3& origin_m, const BoundingBox& near) {
  double rounding_m = 0.0;
  for (const Body& body : space.bodies) {
    for (const glm::uvec3& triangle : body.triangle) {
      const std::array<glm::dvec3, 3> corner_m = corners_m(body, triangle);
      const bool is_inside = std::all_of(corner_m.begin(), corner_m.end(),
                                         [&](const auto& corner) { return near.contains(corner); });
      if (is_inside || !reaches(corner_m, near)) continue;
      const glm::dvec3 across = glm::cross(corner_m[1] - corner_m[0], corner_m[2] - corner_m[0]);
      const double length = glm::length(across);
      if (!(length > 0.0)) continue;
      for (const glm::dvec3& corner : corner_m) {
        const glm::dvec3 local = corner - origin_m;
        const glm::dvec3 moved = glm::dvec3(glm::vec3(local)) - local;
        rounding_m = std::max(rounding_m, std::abs(glm::dot(moved, across)) / length);
      }
    }
  }
  return rounding_m;
}

bool has_no_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a) == glm::dvec3(0.0);
}

// Triangles that do not reach into the box are left out: no light comes from there.
void add_body(const Project& project, const Body& body, std::uint32_t body_index,
              const std::optional<BoundingBox>& sealed, PreparedScene& scene) {
  const auto first = static_cast<std::uint32_t>(scene.vertex_m.size());
  for (const glm::dvec3& vertex : body.vertex_m) {
    scene.vertex_m.emplace_back(vertex - scene.origin_m);
  }
  for (std::size_t i = 0; i < body.triangle.size(); ++i) {
    const glm::uvec3 given = body.triangle[i], local = given + first;
    if (sealed && !reaches(corners_m(body, given), *sealed)) continue;
    // Rounding to float can take away the rest of a needle's area; rays would get a normal of 0/0.
    if (has_no_area(body.vertex_m[given.x], body.vertex_m[given.y], body.vertex_m[given.z]) ||
        has_no_area(scene.vertex_m[local.x], scene.vertex_m[local.y], scene.vertex_m[local.z])) {
      ++scene.degenerate_triangles;
      continue;
    }
    scene.triangle.push_back(local);
    scene.reflectance.push_back(project.materials[body.material_of[i]].reflectance);
    scene.body.push_back(body_index);
  }
}

std::uint32_t channel_of(const std::string& group, double maintenance_factor,
                         std::vector<LightChannel>& channels) {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const LightChannel& channel) {
        return channel.group == group && channel.maintenance_factor == maintenance_factor;
      });
  const auto index = static_cast<std::uint32_t>(found - channels.begin());
  if (found == channels.end()) channels.push_back({group, maintenance_factor, false});
  return index;
}

// The table holds the factor of the tilt it was measured at.
double installed_tilt_factor(const PhotometricWeb& web, const Luminaire& luminaire) {
  if (!web.source().lamp_tilt) return 1.0;
  const LampTilt& tilt = *web.source().lamp_tilt;
  return tilt_factor(tilt, lamp_tilt_rad(tilt, luminaire.world_from_luminaire)) /
         tilt_factor(tilt, 0.0);
}

// EN 13201-3 has points for luminaires, and counts those near the point that is lit.
void count_as_on_road(const Road& road, const Luminaire& luminaire, PlacedLuminaire& placed) {
  placed.opening = {};
  const double height_m = luminaire.position_m.z - road.origin_m.z;
  placed.reach = LightReach{glm::dvec2(road.world_from_road[0]), kRoadReach_heights * height_m};
}

void add_luminaire(const Project& project, const Space& space, const Luminaire& luminaire,
                   OpeningFit& fit, PreparedScene& scene) {
  const LuminaireType& type = project.luminaire_types[luminaire.type];
  const PhotometricWeb& web = project.webs[type.web];
  PlacedLuminaire placed;
  placed.position_m = luminaire.position_m - scene.origin_m;
  placed.world_from_luminaire = luminaire.world_from_luminaire;
  placed.web = &web;
  placed.flux_scale = installed_flux_scale(project, luminaire);
  placed.opening = fit.fitted(web.opening(), luminaire);
  if (space.road) count_as_on_road(*space.road, luminaire, placed);
  placed.channel = channel_of(luminaire.group, type.maintenance.product, scene.channels);
  LightChannel& channel = scene.channels[placed.channel];
  channel.may_sample_direct =
      channel.may_sample_direct || placed.opening.shape != OpeningShape::point;
  scene.luminaires.push_back(placed);
}

}  // namespace

// What lies at the very end belongs to it, however it was rounded.
bool LightReach::holds(const glm::dvec3& source_m, const glm::dvec3& point_m) const {
  constexpr double kRounding_m = 1.0e-9;
  const glm::dvec2 way_m(point_m - source_m);
  const double along_m = glm::dot(way_m, along);
  const double across_m = along.x * way_m.y - along.y * way_m.x;
  return std::max(std::abs(along_m), std::abs(across_m)) <= distance_m + kRounding_m;
}

double ray_offset_m(double extent_m) {
  // The origin is the centre, so that no coordinate is larger than half the diagonal.
  const auto largest_m = static_cast<float>(0.5 * extent_m);
  const float next_m = std::nextafter(largest_m, std::numeric_limits<float>::infinity());
  const double ulp_m = static_cast<double>(next_m) - static_cast<double>(largest_m);
  return std::max(32.0 * ulp_m, 1.0e-6 * extent_m);
}

double SceneScale::ray_offset_m() const {
  // As many times what rounding does as 32 ulp are of near surfaces.
  constexpr double kRoundings = 32.0;
  return std::max(calc::ray_offset_m(extent_m), kRoundings * rounding_m);
}

SceneScale scale_of(const Space& space) {
  const BoundingBox all = bounds_of(space), near = near_of(space, all);
  const double all_m = all.diagonal(), near_m = near.diagonal();
  SceneScale scale;
  scale.origin_m = near.centre();
  if (!(all_m > 0.0)) return scale;
  scale.whole_extent_m = all_m;
  scale.extent_m = near_m > 0.0 ? near_m : 1.0;
  if (near_m < all_m) scale.rounding_m = rounding_of(space, scale.origin_m, near);
  return scale;
}

double installed_flux_scale(const Project& project, const Luminaire& luminaire) {
  const LuminaireType& type = project.luminaire_types[luminaire.type];
  return type.flux_scale * installed_tilt_factor(project.webs[type.web], luminaire);
}

PreparedScene prepare_scene(const Project& project, const Space& space) {
  const SceneScale scale = scale_of(space);
  PreparedScene scene;
  scene.origin_m = scale.origin_m;
  scene.extent_m = scale.extent_m;
  scene.far_extent_m = scale.whole_extent_m > scale.extent_m ? scale.whole_extent_m : 0.0;
  scene.rounding_m = scale.rounding_m;
  std::optional<BoundingBox> sealed;
  if (space.shell) {
    sealed = bounds_of(*space.shell);
    sealed->lower -= scale.ray_offset_m();
    sealed->upper += scale.ray_offset_m();
  }
  for (std::size_t i = 0; i < space.bodies.size(); ++i) {
    scene.body_id.push_back(space.bodies[i].id);
    add_body(project, space.bodies[i], static_cast<std::uint32_t>(i), sealed, scene);
  }
  OpeningFit fit(space);
  for (const Luminaire& luminaire : space.luminaires) {
    add_luminaire(project, space, luminaire, fit, scene);
  }
  return scene;
}

}  // namespace calc
