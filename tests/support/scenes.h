#pragma once
// Small scenes built in code, so that tests of the calculation need no files.

#include "calc/base/units.h"
#include "calc/photometry/web.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

// intensity_cd everywhere between gamma_begin and pi (radians).
inline calc::PhotometricWeb isotropic_web(double intensity_cd) {
  return calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi / 2, calc::kPi},
                                    {intensity_cd, intensity_cd, intensity_cd}, {}, {});
}

// I(gamma) = axis_cd * cos(gamma) for gamma <= 90 degrees, tabulated in steps of 90 / steps
// degrees.
inline calc::PhotometricWeb lambert_web(double axis_cd, int steps,
                                        calc::LuminousOpening opening = {}) {
  std::vector<double> gamma_rad, cd;
  for (int k = 0; k <= steps; ++k) {
    gamma_rad.push_back(calc::kPi / 2 * k / steps);
    cd.push_back(k == steps ? 0.0 : axis_cd * std::cos(gamma_rad.back()));
  }
  return calc::PhotometricWeb::make({0.0}, gamma_rad, cd, opening, {});
}

inline void add_triangle(calc::PreparedScene& scene, const glm::dvec3& a, const glm::dvec3& b,
                         const glm::dvec3& c, double reflectance) {
  const auto first = static_cast<std::uint32_t>(scene.vertex_m.size());
  for (const glm::dvec3& p : {a, b, c}) scene.vertex_m.emplace_back(p);
  scene.triangle.emplace_back(first, first + 1, first + 2);
  scene.reflectance.push_back(reflectance);
  scene.body.push_back(0);
}

// Parallelogram with corner `origin` and sides u, v.
inline void add_quad(calc::PreparedScene& scene, const glm::dvec3& origin, const glm::dvec3& u,
                     const glm::dvec3& v, double reflectance) {
  add_triangle(scene, origin, origin + u, origin + u + v, reflectance);
  add_triangle(scene, origin, origin + u + v, origin + v, reflectance);
}

// The six faces of a box from corner `low` with sides `size`.
inline void add_box(calc::PreparedScene& scene, const glm::dvec3& low, const glm::dvec3& size,
                    double reflectance) {
  const glm::dvec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  add_quad(scene, low, x, y, reflectance);
  add_quad(scene, low + z, x, y, reflectance);
  add_quad(scene, low, x, z, reflectance);
  add_quad(scene, low + y, x, z, reflectance);
  add_quad(scene, low, y, z, reflectance);
  add_quad(scene, low + x, y, z, reflectance);
}

inline void add_luminaire(calc::PreparedScene& scene, const calc::PhotometricWeb& web,
                          const glm::dvec3& position_m) {
  calc::PlacedLuminaire luminaire{};
  luminaire.position_m = position_m;
  luminaire.world_from_luminaire = glm::dmat3(1.0);  // axis straight down
  luminaire.web = &web;
  luminaire.flux_scale = 1.0;
  luminaire.opening = web.opening();
  luminaire.channel = 0;
  scene.luminaires.push_back(luminaire);
  if (scene.channels.empty()) scene.channels.push_back({"", 1.0});
}

// Call last: the length of the diagonal of all corners.
inline void set_extent(calc::PreparedScene& scene) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::vec3& p : scene.vertex_m) {
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  for (const calc::PlacedLuminaire& l : scene.luminaires) {
    low = glm::min(low, l.position_m);
    high = glm::max(high, l.position_m);
  }
  scene.extent_m = glm::length(high - low);
}

// Icosahedron subdivided `levels` times, corners on the sphere of radius_m about the origin.
inline void add_sphere(calc::PreparedScene& scene, double radius_m, int levels,
                       double reflectance) {
  const double t = (1.0 + std::sqrt(5.0)) / 2.0;
  std::vector<glm::dvec3> p{{-1, t, 0}, {1, t, 0}, {-1, -t, 0}, {1, -t, 0},
                            {0, -1, t}, {0, 1, t}, {0, -1, -t}, {0, 1, -t},
                            {t, 0, -1}, {t, 0, 1}, {-t, 0, -1}, {-t, 0, 1}};
  std::vector<glm::uvec3> f{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                            {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                            {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                            {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, is_new] =
          middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(p.size()));
      if (is_new) p.push_back(glm::normalize(p[a]) + glm::normalize(p[b]));
      return entry->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& g : f) {
      const std::uint32_t a = midpoint(g.x, g.y), b = midpoint(g.y, g.z), c = midpoint(g.z, g.x);
      finer.insert(finer.end(), {{g.x, a, c}, {g.y, b, a}, {g.z, c, b}, {a, b, c}});
    }
    f = std::move(finer);
  }
  for (glm::dvec3& q : p) q = radius_m * glm::normalize(q);
  for (const glm::uvec3& g : f) add_triangle(scene, p[g.x], p[g.y], p[g.z], reflectance);
}

inline double surface_area_m2(const calc::PreparedScene& scene) {
  double area = 0.0;
  for (const glm::uvec3& t : scene.triangle) {
    const glm::dvec3 a(scene.vertex_m[t.x]), b(scene.vertex_m[t.y]), c(scene.vertex_m[t.z]);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return area;
}

// One plane, a fixed number of paths per replicate, in `looks` looks.
inline calc::SpaceSolution solve_with_paths(const calc::PreparedScene& scene,
                                            const calc::SensorGrid& grid, std::uint64_t seed,
                                            std::uint64_t paths, int replicates = 16,
                                            int looks = 1) {
  calc::RadiositySettings settings;
  settings.seed = seed;
  settings.first_paths = paths >> (looks - 1);
  settings.max_paths = paths;
  settings.replicates = replicates;
  const auto gatherer = calc::make_cpu_gatherer();
  return calc::solve_illuminance(
      scene, {{"plane", &grid}}, settings, 0.95, *gatherer,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});
}

// In looks as luxgate takes them: what one measures decides how the next one shares its rays.
inline calc::SpaceSolution solve_in_looks(const calc::PreparedScene& scene,
                                          const calc::SensorGrid& grid, std::uint64_t seed,
                                          std::uint64_t paths, int replicates = 16) {
  const std::uint64_t first = calc::RadiositySettings{}.first_paths;
  return solve_with_paths(scene, grid, seed, paths, replicates,
                          std::countr_zero(paths / first) + 1);
}

// Total illuminance of replicate r at point i, all channels.
inline double total_lx(const calc::PlaneField& field, std::size_t r, std::size_t i) {
  return field.total_lx(r, i);
}

inline std::vector<double> replicates_at(const calc::PlaneField& field, std::size_t i) {
  std::vector<double> values;
  for (std::size_t r = 0; r < field.replicates; ++r) values.push_back(total_lx(field, r, i));
  return values;
}

// Replicates of the mean over all points.
inline std::vector<double> replicate_averages(const calc::PlaneField& field) {
  std::vector<double> values(field.replicates, 0.0);
  for (std::size_t r = 0; r < field.replicates; ++r) {
    for (std::size_t i = 0; i < field.points; ++i) values[r] += total_lx(field, r, i);
    values[r] /= static_cast<double>(field.points);
  }
  return values;
}

}  // namespace test_support
