#include "calc/proofs/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace calc {
namespace {

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::max()};
  glm::dvec3 high{-std::numeric_limits<double>::max()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

std::array<glm::dvec3, 3> triangle_corners(const PreparedScene& scene, std::size_t t) {
  const glm::uvec3& corner = scene.triangle[t];
  return {glm::dvec3(scene.vertex_m[corner.x]), glm::dvec3(scene.vertex_m[corner.y]),
          glm::dvec3(scene.vertex_m[corner.z])};
}

// Corners of reflecting triangles, each once.
std::vector<glm::dvec3> reflecting_corners(const PreparedScene& scene) {
  std::vector<std::uint8_t> is_used(scene.vertex_m.size(), 0);
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    if (scene.reflectance[t] <= 0.0) continue;
    for (int k = 0; k < 3; ++k) is_used[scene.triangle[t][k]] = 1;
  }
  std::vector<glm::dvec3> corners;
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v] != 0) corners.emplace_back(scene.vertex_m[v]);
  }
  return corners;
}

double farthest_m(std::span<const glm::dvec3> corners, const glm::dvec3& direction) {
  double farthest = -std::numeric_limits<double>::max();
  for (const glm::dvec3& c : corners) farthest = std::max(farthest, glm::dot(direction, c));
  return farthest;
}

// Reflecting triangles by body, so that most of them need no test of their own.
struct ReflectingBody {
  Box box;
  std::vector<std::size_t> triangles;
};

std::vector<ReflectingBody> reflecting_bodies(const PreparedScene& scene) {
  std::vector<ReflectingBody> bodies;
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    if (scene.reflectance[t] <= 0.0) continue;
    if (scene.body[t] >= bodies.size()) bodies.resize(scene.body[t] + std::size_t{1});
    ReflectingBody& body = bodies[scene.body[t]];
    body.triangles.push_back(t);
    for (const glm::dvec3& corner : triangle_corners(scene, t)) body.box.add(corner);
  }
  std::erase_if(bodies, [](const ReflectingBody& body) { return body.triangles.empty(); });
  return bodies;
}

bool is_along(const glm::dvec3& axis, const PlacedLuminaire& luminaire) {
  return glm::length(glm::cross(axis, luminaire.world_from_luminaire[2])) < 1.0e-12;
}

// Light paths start off the opening by ray_offset_m() along the luminaire's axis, on the side they
// go to. A half-space beam about that axis thus starts well in front of what lies in its opening's
// plane, as the ceiling about a recessed luminaire does; any other beam, and one from a luminous
// body, must keep off by more than that lift.
BeamClearance path_clearance(const PreparedScene& scene, const Beam& beam,
                             const PlacedLuminaire& luminaire) {
  const double offset_m = scene.ray_offset_m();
  const bool is_flat_along = !luminaire.opening.is_body() && is_along(beam.axis, luminaire);
  return {is_flat_along ? -0.25 * offset_m : 2.0 * offset_m, 2.0 * offset_m};
}

bool misses_all(const PreparedScene& scene, const std::vector<ReflectingBody>& bodies,
                const Beam& beam, const PlacedLuminaire& luminaire, std::size_t& tests_left) {
  const BeamClearance clearance = path_clearance(scene, beam, luminaire);
  for (const ReflectingBody& body : bodies) {
    if (tests_left < body.triangles.size() + 1) return false;
    --tests_left;
    const auto box = box_corners(body.box.low, body.box.high);
    if (beam_misses(beam, luminaire, box, clearance)) continue;
    for (const std::size_t t : body.triangles) {
      --tests_left;
      if (!beam_misses(beam, luminaire, triangle_corners(scene, t), clearance)) return false;
    }
  }
  return true;
}

bool is_behind_all(const PlacedLuminaire& luminaire, const PointBounds& bounds, double margin_m) {
  return !bounds.groups.empty() &&
         std::all_of(bounds.groups.begin(), bounds.groups.end(), [&](const NormalGroup& group) {
           const double highest_m = glm::dot(group.normal, luminaire.position_m) +
                                    opening_support_m(luminaire, group.normal);
           return highest_m < group.lowest_m - margin_m;
         });
}

}  // namespace

bool no_reflection(const PreparedScene& scene) {
  return std::none_of(scene.reflectance.begin(), scene.reflectance.end(),
                      [](double rho) { return rho > 0.0; });
}

ReflectionView find_reflection_view(const PreparedScene& scene, const PointSet& points) {
  const std::vector<glm::dvec3> corners = reflecting_corners(scene);
  const std::size_t count = points.position_m.size();
  ReflectionView view;
  view.sees_reflection.assign(count, corners.empty() || points.has_back() ? 0 : 1);
  if (!corners.empty() && points.has_back()) {
    Box box;
    for (const glm::dvec3& c : corners) box.add(c);
    const auto box_corner_m = box_corners(box.low, box.high);
    const double offset_m = scene.ray_offset_m();
    std::size_t tests_left = kMostCornerTests;
    glm::dvec3 direction(0.0);  // neighbours mostly share their normal
    double farthest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || points.normal[i] != direction) {
        direction = points.normal[i];
        const bool is_affordable = corners.size() <= tests_left;
        if (is_affordable) tests_left -= corners.size();
        farthest =
            is_affordable ? farthest_m(corners, direction) : farthest_m(box_corner_m, direction);
      }
      const double height_m = glm::dot(direction, points.position_m[i]);
      view.sees_reflection[i] = farthest > height_m + offset_m ? 1 : 0;
    }
  }
  return view;
}

std::vector<std::uint8_t> find_unlit_surfaces(const PreparedScene& scene,
                                              const std::vector<Beam>& beams) {
  const std::vector<ReflectingBody> bodies = reflecting_bodies(scene);
  std::vector<std::uint8_t> unlit(scene.luminaires.size(), 0);
  std::size_t tests_left = kMostBeamTests;
  for (std::size_t l = 0; l < unlit.size(); ++l) {
    unlit[l] = misses_all(scene, bodies, beams[l], scene.luminaires[l], tests_left) ? 1 : 0;
  }
  return unlit;
}

std::vector<std::uint8_t> find_dark_luminaires(const PreparedScene& scene,
                                               const std::vector<Beam>& beams,
                                               const PointBounds& bounds) {
  const double margin_m = 1.0e-7 * std::max(scene.extent_m, bounds.reach_m);
  std::vector<std::uint8_t> dark(scene.luminaires.size(), 0);
  for (std::size_t l = 0; l < dark.size(); ++l) {
    const PlacedLuminaire& luminaire = scene.luminaires[l];
    const bool is_dark = is_behind_all(luminaire, bounds, margin_m) ||
                         beam_misses(beams[l], luminaire, bounds.corner_m, {margin_m, margin_m});
    dark[l] = is_dark ? 1 : 0;
  }
  return dark;
}

}  // namespace calc
