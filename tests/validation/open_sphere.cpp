#include "tests/validation/open_sphere.h"

#include "calc/base/text.h"
#include "calc/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace validation {

using namespace cli::selftest;

namespace {

constexpr double kFlux_lm = 1000.0;
constexpr int kFinerLevels = 2;  // 320 triangles become 5120

// Vertices and triangles of the OBJ file, which has nothing else.
std::vector<Triangle> read_mesh(const Tables& tables) {
  const std::string path = tables.folder + "/icosphere_sph-o1.obj";
  const calc::FileContent content = tables.files.read(path);
  if (!content.ok()) throw BadTable("cannot read '" + path + "': " + content.error);
  std::vector<glm::dvec3> vertex;
  std::vector<Triangle> mesh;
  for (const std::string& line : split(content.bytes, '\n')) {
    if (line.rfind("v ", 0) == 0) vertex.push_back(vector(line.substr(2)));
    if (line.rfind("f ", 0) != 0) continue;
    const glm::dvec3 numbers = vector(line.substr(2));
    Triangle t;
    for (int k = 0; k < 3; ++k) {
      const double n = numbers[k];
      if (!(n >= 1.0 && n <= static_cast<double>(vertex.size()))) throw BadTable(path);
      t[static_cast<std::size_t>(k)] = vertex[static_cast<std::size_t>(n) - 1];
    }
    mesh.push_back(t);
  }
  if (mesh.empty()) throw BadTable("'" + path + "' has no triangle");
  return mesh;
}

// Parts of the same triangles, their corners on the unit sphere.
std::vector<Triangle> finer(const std::vector<Triangle>& mesh) {
  std::vector<Triangle> parts = mesh;
  for (int level = 0; level < kFinerLevels; ++level) {
    std::vector<Triangle> next;
    for (const Triangle& t : parts) {
      for (Triangle part : split_triangle(t, 1)) {
        for (glm::dvec3& corner : part) corner = glm::normalize(corner);
        next.push_back(part);
      }
    }
    parts = std::move(next);
  }
  return parts;
}

double area_m2(const Triangle& t) {
  return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
}

// Points that see the inside; 1 or 3 a triangle.
void add_places(Triangle t, bool is_fine, Places& places) {
  if (glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), t[0]) > 0.0) std::swap(t[1], t[2]);
  Places more = places_on_polygon({t[0], t[1], t[2]}, is_fine ? 0 : 1);
  if (is_fine) {
    more.point.resize(1);
    more.point[0].position_m = (t[0] + t[1] + t[2]) / 3.0;
    more.area_m2 = {area_m2(t)};
  }
  places.add(more);
}

}  // namespace

std::optional<SphereCase> sphere_case(const std::string& name, const std::string& quantity,
                                      const Tables& tables) {
  double above = 0.0, below = 0.0;
  if (std::sscanf(name.c_str(), "rho=%lf", &above) == 1) {
    below = above;
  } else if (std::sscanf(name.c_str(), "rho %lf above z=0, %lf below", &above, &below) != 2) {
    return std::nullopt;
  }
  const bool is_ideal = quantity.find("ideal sphere") != std::string::npos;
  if (!is_ideal && quantity.find("mesh average") == std::string::npos) return std::nullopt;
  const std::vector<Triangle> mesh = is_ideal ? finer(read_mesh(tables)) : read_mesh(tables);
  SphereCase sphere;
  double sum_m2 = 0.0, absorbed_m2 = 0.0;
  for (const Triangle& t : mesh) {
    const double rho = (t[0] + t[1] + t[2]).z > 0.0 ? above : below;
    sphere.scene.add_triangle(t[0], t[1], t[2], rho);
    add_places(t, is_ideal, sphere.places);
    sum_m2 += area_m2(t);
    absorbed_m2 += area_m2(t) * (1.0 - rho);
  }
  sphere.scene.add_luminaire(isotropic_web(kFlux_lm / (4.0 * calc::kPi)), {0, 0, 0});
  sphere.largest_rho = std::max(above, below);
  sphere.known_to = 5e-4;
  if (is_ideal) {
    sphere.known_to = 1e-3;  // one point a triangle
    const double ideal_m2 = 4.0 * calc::kPi * (1.0 - 0.5 * (above + below));
    sphere.known_to += std::abs(ideal_m2 / absorbed_m2 - 1.0);
    sphere.note = fmt::format(" (of {} triangles, {:.2f} % too small)", mesh.size(),
                              100.0 * (1.0 - sum_m2 / (4.0 * calc::kPi)));
  }
  return sphere;
}

}  // namespace validation
