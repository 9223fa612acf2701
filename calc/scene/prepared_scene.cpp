#include "calc/scene/prepared_scene.h"

#include "calc/scene/opening_fit.h"
#include "calc/scene/solids.h"

#include <algorithm>
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

bool has_no_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a) == glm::dvec3(0.0);
}

void add_body(const Project& project, const Body& body, std::uint32_t body_index,
              PreparedScene& scene) {
  const auto first = static_cast<std::uint32_t>(scene.vertex_m.size());
  for (const glm::dvec3& vertex : body.vertex_m) {
    scene.vertex_m.emplace_back(vertex - scene.origin_m);
  }
  for (std::size_t i = 0; i < body.triangle.size(); ++i) {
    const glm::uvec3 given = body.triangle[i], local = given + first;
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

double extent_m(const Space& space) {
  const double diagonal_m = bounds_of(space).diagonal();
  return diagonal_m > 0.0 ? diagonal_m : 1.0;
}

double installed_flux_scale(const Project& project, const Luminaire& luminaire) {
  const LuminaireType& type = project.luminaire_types[luminaire.type];
  return type.flux_scale * installed_tilt_factor(project.webs[type.web], luminaire);
}

PreparedScene prepare_scene(const Project& project, const Space& space) {
  PreparedScene scene;
  scene.origin_m = bounds_of(space).centre();
  scene.extent_m = extent_m(space);
  for (std::size_t i = 0; i < space.bodies.size(); ++i) {
    scene.body_id.push_back(space.bodies[i].id);
    add_body(project, space.bodies[i], static_cast<std::uint32_t>(i), scene);
  }
  OpeningFit fit(space);
  for (const Luminaire& luminaire : space.luminaires) {
    add_luminaire(project, space, luminaire, fit, scene);
  }
  return scene;
}

}  // namespace calc
