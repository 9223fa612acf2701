#include "tests/validation/open_scene.h"

#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/validation/open_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace validation {

using namespace cli::selftest;

namespace {

// An evenly shining plate that is no rectangle: as many diffuse point sources of the same flux.
void add_luminous_triangles(const std::vector<glm::dvec3>& corners, double exitance, Scene& scene) {
  constexpr int kLevels = 5;  // 1024 sources a triangle: within 1e-4 from one side away
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Triangle whole{corners[0], corners[k], corners[k + 1]};
    const glm::dvec3 across = glm::cross(whole[1] - whole[0], whole[2] - whole[0]);
    const glm::dvec3 z = -glm::normalize(across), x = glm::normalize(whole[1] - whole[0]);
    bool is_first = true;
    const std::vector<Triangle> parts = split_triangle(whole, kLevels);
    const double flux_lm = exitance * 0.5 * glm::length(across) / static_cast<double>(parts.size());
    for (const Triangle& part : parts) {
      const glm::dvec3 middle = (part[0] + part[1] + part[2]) / 3.0;
      if (is_first) {
        scene.add_luminaire(lambert_web(flux_lm / calc::kPi), middle,
                            glm::dmat3(x, glm::cross(z, x), z));
      } else {
        scene.repeat_luminaire(middle);
      }
      is_first = false;
    }
  }
}

// Its own light: polygons, discs and spheres.
void add_emission(const Row& row, const std::vector<glm::dvec3>& corners, Scene& scene) {
  const double exitance = number(row, "exitance_lm_m2");
  const std::string& shape = row.at("shape");
  if (shape == "polygon") {
    std::optional<Rectangle> face = rectangle_of(corners);
    const bool reflects = number(row, "reflectance") > 0.0;
    if (!face) {
      if (reflects) throw NotCovered("a luminous and reflecting surface that is no rectangle");
      return add_luminous_triangles(corners, exitance, scene);
    }
    const double inset = 1e-5 * std::min(glm::length(face->u), glm::length(face->v));
    if (reflects) face->corner += inset * face->normal;
    scene.add_luminous(*face, exitance);
    return;
  }
  const std::string& geometry = row.at("geometry");
  const double r = calc::parse_number(part_named(geometry, "radius")).value_or(0.0);
  const double luminance = exitance / calc::kPi, cd = luminance * calc::kPi * r * r;
  if (shape == "disc") {
    const glm::dvec3 normal = vector(part_named(geometry, "normal"));
    if (glm::length(normal - kDown) > 1e-9) throw NotCovered("a luminous disc that looks aside");
    scene.add_luminaire(lambert_web(cd, {calc::OpeningShape::disk, 2 * r, 2 * r, 0.0}),
                        vector(part_named(geometry, "centre")));
  } else if (shape == "sphere") {
    scene.add_luminaire(isotropic_web(cd, {calc::OpeningShape::ellipsoid, 2 * r, 2 * r, 2 * r}),
                        vector(part_named(geometry, "centre")));
  } else {
    throw NotCovered("a surface of shape '" + shape + "'");
  }
}

void add_surface(const Row& row, std::optional<double> override_rho, Scene& scene) {
  if (row.at("reflectance").empty() && !override_rho) {
    throw NotCovered("it is run with several reflectances");
  }
  const double rho = override_rho ? *override_rho : number(row, "reflectance");
  std::vector<glm::dvec3> corners;
  if (row.at("shape") == "polygon") {
    corners = corners_of(row);
  } else if (rho > 0.0 || number(row, "exitance_lm_m2") == 0.0) {
    throw NotCovered("a reflecting surface of shape '" + row.at("shape") + "'");
  }
  if (number(row, "exitance_lm_m2") > 0.0) add_emission(row, corners, scene);
  if (number(row, "exitance_lm_m2") > 0.0 && rho == 0.0) return;  // nothing behind a source
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    scene.add_triangle(corners[0], corners[k], corners[k + 1], rho);
  }
}

// Lines of Lambertian light, as openings too narrow to tell from lines.
void add_line(const Row& row, Scene& scene) {
  constexpr double kWidth_m = 1e-4;
  const glm::dvec3 middle(number(row, "x"), number(row, "y"), number(row, "z"));
  double length_m = 0.0, cd_per_m = 0.0;
  const std::string& words = row.at("distribution");
  const bool is_strip = words.find("strip") != std::string::npos;
  const std::size_t at = words.find(is_strip ? "= " : "cylinder, ");
  if (std::sscanf(row.at("note").c_str(), "length %lf m along x", &length_m) != 1 ||
      at == std::string::npos ||
      std::sscanf(words.c_str() + at + (is_strip ? 2 : 10), "%lf", &cd_per_m) != 1) {
    throw NotCovered("a luminaire without a photometry file");
  }
  const calc::LuminousOpening opening{calc::OpeningShape::rectangle, length_m, kWidth_m, 0.0};
  if (is_strip) return scene.add_luminaire(lambert_web(cd_per_m * length_m, opening), middle);
  // A cylinder along C 0: sine of the angle to its axis.
  std::vector<double> c_rad, gamma_rad, cd;
  for (int c = 0; c <= 180; ++c) c_rad.push_back(calc::kPi * c / 90.0);
  for (int g = 0; g <= 180; ++g) gamma_rad.push_back(calc::kPi * g / 180.0);
  for (const double c : c_rad) {
    for (const double g : gamma_rad) {
      const double along = calc::sin(g) * calc::cos(c);
      cd.push_back(cd_per_m * length_m * std::sqrt(std::max(0.0, 1.0 - along * along)));
    }
  }
  scene.add_luminaire(calc::PhotometricWeb::make(c_rad, gamma_rad, cd, opening, {}), middle);
}

std::vector<glm::dvec3> places_of(const Row& row) {
  int columns = 0, rows = 0;
  if (std::sscanf(row.at("luminaire").c_str(), "array %d x %d", &columns, &rows) != 2) {
    return {{number(row, "x"), number(row, "y"), number(row, "z")}};
  }
  double width = 0.0, depth = 0.0, of_width = 0.0, of_depth = 0.0;
  if (std::sscanf(row.at("x").c_str(), "(i+0.5)*%lf/%lf", &width, &of_width) != 2 ||
      std::sscanf(row.at("y").c_str(), "(j+0.5)*%lf/%lf", &depth, &of_depth) != 2) {
    throw BadTable("an array of luminaires at '" + row.at("x") + "', '" + row.at("y") + "'");
  }
  std::vector<glm::dvec3> places;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      places.emplace_back((i + 0.5) * width / of_width, (j + 0.5) * depth / of_depth,
                          number(row, "z"));
    }
  }
  return places;
}

void add_lamp(const Row& row, const Tables& tables, Scene& scene) {
  if (row.at("ies_file").empty()) return add_line(row, scene);
  const std::string path = tables.folder + "/" + row.at("ies_file");
  const calc::FileContent content = tables.files.read(path);
  calc::Diagnostics diagnostics;
  const std::optional<calc::PhotometricWeb> web =
      content.ok() ? calc::parse_photometry(content.bytes, path, diagnostics) : std::nullopt;
  if (!web) throw BadTable(fmt::format("'{}' cannot be read", path));
  const glm::dvec3 back = -glm::normalize(vector(row.at("aim")));
  const glm::dvec3 c0 = glm::normalize(vector(row.at("c0_direction")));
  const std::vector<glm::dvec3> places = places_of(row);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k == 0) {
      scene.add_luminaire(*web, places[k], glm::dmat3(c0, glm::cross(back, c0), back));
    } else {
      scene.repeat_luminaire(places[k]);
    }
  }
}

}  // namespace

std::vector<glm::dvec3> corners_of(const Row& surface) {
  std::vector<glm::dvec3> corners;
  for (const std::string& corner : split(surface.at("geometry"), ';')) {
    corners.push_back(vector(corner));
  }
  return corners;
}

std::optional<Rectangle> rectangle_of(const std::vector<glm::dvec3>& corners) {
  if (corners.size() != 4 ||
      glm::length(corners[0] + corners[2] - corners[1] - corners[3]) > 1e-9 ||
      std::abs(glm::dot(corners[1] - corners[0], corners[3] - corners[0])) > 1e-9) {
    return std::nullopt;
  }
  Rectangle face{corners[0], corners[1] - corners[0], corners[3] - corners[0], glm::dvec3(0.0)};
  face.normal = glm::normalize(glm::cross(face.u, face.v));
  return face;
}

Scene open_scene(const std::string& id, const Tables& tables, std::optional<double> rho) {
  Scene scene;
  bool has_luminous = false;
  for (const Row& surface : rows_of(tables.surfaces, id)) {
    add_surface(surface, rho, scene);
    has_luminous = has_luminous || number(surface, "exitance_lm_m2") > 0.0;
  }
  // Beside a luminous surface the table of luminaires describes the same source once more.
  for (const Row& lamp : rows_of(tables.luminaires, id)) {
    if (!has_luminous) add_lamp(lamp, tables, scene);
  }
  return scene;
}

std::vector<glm::dvec3> lamps_of(const std::string& id, const Tables& tables) {
  std::vector<glm::dvec3> lamps;
  for (const Row& row : rows_of(tables.luminaires, id)) {
    if (row.at("ies_file").empty()) continue;
    for (const glm::dvec3& place : places_of(row)) lamps.push_back(place);
  }
  return lamps;
}

}  // namespace validation
