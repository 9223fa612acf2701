#include "calc/scene/housing.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/scene/opening.h"
#include "calc/scene/opening_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace calc {
namespace {

constexpr std::size_t kCorners = 32;  // of what is round
constexpr std::size_t kStripes = 16;  // of an ellipsoid, from pole to pole

struct Mesh {
  std::vector<glm::dvec3> vertex_m;  // in the luminaire's axes
  std::vector<glm::uvec3> triangle;
};

// Counter-clockwise as seen from behind (+z).
using Outline = std::vector<glm::dvec2>;

Outline rectangle(const glm::dvec2& half_m) {
  return {
      {-half_m.x, -half_m.y}, {half_m.x, -half_m.y}, {half_m.x, half_m.y}, {-half_m.x, half_m.y}};
}

// Corners on the ellipse with these half axes.
Outline ellipse(const glm::dvec2& half_m) {
  Outline outline;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const double angle_rad = 2.0 * kPi * static_cast<double>(i) / kCorners;
    outline.push_back(half_m * glm::dvec2(calc::cos(angle_rad), calc::sin(angle_rad)));
  }
  return outline;
}

// How much larger the polygon's half axes must be for the ellipse's area.
double same_area_factor() {
  const double angle_rad = 2.0 * kPi / kCorners;
  return std::sqrt(angle_rad / calc::sin(angle_rad));
}

void add_fan(std::size_t first, std::size_t count, bool is_turned, Mesh& mesh) {
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const auto a = static_cast<std::uint32_t>(first), b = static_cast<std::uint32_t>(first + i),
               c = static_cast<std::uint32_t>(first + i + 1);
    mesh.triangle.push_back(is_turned ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
  }
}

Mesh sheet(const Outline& outline) {
  Mesh mesh;
  for (const glm::dvec2& corner : outline) mesh.vertex_m.emplace_back(corner, 0.0);
  add_fan(0, outline.size(), true, mesh);
  return mesh;
}

Mesh prism(const Outline& outline, double lower_m, double upper_m) {
  Mesh mesh;
  for (const double z : {lower_m, upper_m}) {
    for (const glm::dvec2& corner : outline) mesh.vertex_m.emplace_back(corner, z);
  }
  const std::size_t count = outline.size();
  add_fan(0, count, true, mesh);
  add_fan(count, count, false, mesh);
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>((i + 1) % count),
               up = static_cast<std::uint32_t>(count);
    mesh.triangle.emplace_back(a, b, b + up);
    mesh.triangle.emplace_back(a, b + up, a + up);
  }
  return mesh;
}

// Corners on it.
Mesh ellipsoid(const glm::dvec3& half_m) {
  Mesh mesh;
  for (std::size_t stripe = 1; stripe < kStripes; ++stripe) {
    const double angle_rad = kPi * static_cast<double>(stripe) / kStripes;
    for (const glm::dvec2& corner : ellipse(glm::dvec2(half_m) * calc::sin(angle_rad))) {
      mesh.vertex_m.emplace_back(corner, -half_m.z * calc::cos(angle_rad));
    }
  }
  const auto corner = [](std::size_t stripe, std::size_t i) {
    return static_cast<std::uint32_t>(stripe * kCorners + i % kCorners);
  };
  for (std::size_t stripe = 0; stripe + 2 < kStripes; ++stripe) {
    for (std::size_t i = 0; i < kCorners; ++i) {
      const std::uint32_t a = corner(stripe, i), b = corner(stripe, i + 1),
                          c = corner(stripe + 1, i + 1), d = corner(stripe + 1, i);
      mesh.triangle.emplace_back(a, b, c);
      mesh.triangle.emplace_back(a, c, d);
    }
  }
  const auto low = static_cast<std::uint32_t>(mesh.vertex_m.size()), high = low + 1;
  mesh.vertex_m.emplace_back(0.0, 0.0, -half_m.z);
  mesh.vertex_m.emplace_back(0.0, 0.0, half_m.z);
  for (std::size_t i = 0; i < kCorners; ++i) {
    mesh.triangle.emplace_back(low, corner(0, i + 1), corner(0, i));
    mesh.triangle.emplace_back(high, corner(kStripes - 2, i), corner(kStripes - 2, i + 1));
  }
  return mesh;
}

// A prism along z becomes one along x or y.
Mesh turned(Mesh mesh, OpeningShape shape) {
  for (glm::dvec3& p : mesh.vertex_m) {
    if (shape == OpeningShape::cylinder_c0) p = {p.z, p.x, p.y};
    if (shape == OpeningShape::cylinder_c90) p = {p.y, p.z, p.x};
  }
  return mesh;
}

// How far a housing lies within the surface of this body.
double within_m(const LuminousOpening& opening) {
  constexpr double kWithin_m = 1.0e-3, kLeast = 0.9;
  const glm::dvec3 outer_m = 0.5 * opening.size_m();
  return std::min(kWithin_m, (1.0 - kLeast) * std::min({outer_m.x, outer_m.y, outer_m.z}));
}

Mesh inside_of(const LuminousOpening& opening) {
  const glm::dvec3 half_m = 0.5 * opening.size_m() - within_m(opening);
  switch (opening.shape) {
    case OpeningShape::cylinder:
      return prism(ellipse(glm::dvec2(half_m)), -half_m.z, half_m.z);
    case OpeningShape::cylinder_c0:
      return turned(prism(ellipse({half_m.y, half_m.z}), -half_m.x, half_m.x), opening.shape);
    case OpeningShape::cylinder_c90:
      return turned(prism(ellipse({half_m.z, half_m.x}), -half_m.y, half_m.y), opening.shape);
    case OpeningShape::ellipsoid:
      return ellipsoid(half_m);
    default:
      return prism(rectangle(glm::dvec2(half_m)), -half_m.z, half_m.z);
  }
}

Outline outline_of(const LuminousOpening& opening, const Housing& housing) {
  const glm::dvec2 half_m = 0.5 * housing.size_m.value_or(glm::dvec2(opening.size_m()));
  const bool is_round = housing.size_m ? housing.is_round : opening.shape == OpeningShape::disk;
  return is_round ? ellipse(same_area_factor() * half_m) : rectangle(half_m);
}

constexpr std::string_view kFace = "face", kHousing = "housing";

struct NamedMesh {
  std::string_view name;
  bool is_closed;
  Mesh mesh;
};

// Of a flat opening.
NamedMesh face_of(const LuminousOpening& opening, const Housing& housing) {
  return {kFace, false, sheet(outline_of(opening, housing))};
}

std::vector<NamedMesh> meshes_of(const LuminousOpening& opening, const Housing& housing) {
  std::vector<NamedMesh> meshes;
  if (opening.is_body()) {
    meshes.push_back({kHousing, true, inside_of(opening)});
    return meshes;
  }
  meshes.push_back(face_of(opening, housing));
  if (housing.depth_m > 0.0) {
    meshes.push_back({kHousing, true, prism(outline_of(opening, housing), 0.0, housing.depth_m)});
  }
  return meshes;
}

// What lies no further before an opening, or off a place, is there but for rounding.
constexpr double kSamePlane_m = 1.0e-6;

glm::dvec3 to_emitter(const EmitterPlace& place, const glm::dvec3& p) {
  return glm::transpose(place.turn) * (p - place.position_m);
}

// Of a type of several emitters; nobody asks for their light here.
std::vector<HousedOpening> openings_of(const Project& project, const LuminaireType& type) {
  std::vector<HousedOpening> openings;
  for (const TypeEmitter& emitter : type.emitters) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[emitter.type].web];
    openings.push_back({web.opening(), 0.0, emitter.place});
  }
  return openings;
}

// The box around all openings, in the axes of the first emitter.
NamedMesh common_box(const std::vector<HousedOpening>& openings, const Housing& housing) {
  const HousingBox box = housing_box_m(openings, housing);
  const glm::dvec2 lower_m(box.lower_m), upper_m(box.upper_m);
  Outline outline = rectangle(0.5 * (upper_m - lower_m));
  for (glm::dvec2& corner : outline) corner += 0.5 * (lower_m + upper_m);
  NamedMesh named{kHousing, true, prism(outline, box.lower_m.z, box.upper_m.z)};
  for (glm::dvec3& p : named.mesh.vertex_m) p = to_emitter(openings.front().place, p);
  return named;
}

// A size is that of the box around several openings, not of the faces; a mesh has none.
NamedMesh own_face(const LuminousOpening& opening) { return face_of(opening, {}); }

// In the axes of the emitter at this place.
NamedMesh of_file(const HousingMesh& mesh, const EmitterPlace& place) {
  NamedMesh named{kHousing, mesh.is_closed, {{}, mesh.triangle}};
  for (const glm::dvec3& p : mesh.vertex_m) {
    named.mesh.vertex_m.push_back(to_emitter(place, p));
  }
  return named;
}

// Of one emitter, which stands for its luminaire if that has no other.
std::vector<NamedMesh> meshes_of(const Project& project, const LuminaireType& type,
                                 const HousingMesh* mesh) {
  const LuminousOpening& opening = project.webs[type.web].opening();
  if (type.is_further_emitter) return {own_face(opening)};
  if (type.emitters.empty() && mesh == nullptr) return meshes_of(opening, *type.housing);
  std::vector<NamedMesh> meshes;
  if (!opening.is_body()) meshes.push_back(own_face(opening));
  if (mesh != nullptr) {
    meshes.push_back(
        of_file(*mesh, type.emitters.empty() ? EmitterPlace{} : type.emitters.front().place));
  } else if (type.housing->depth_m > 0.0) {
    meshes.push_back(common_box(openings_of(project, type), *type.housing));
  }
  return meshes;
}

// The id of an emitter's luminaire: with_all_emitters() puts the emitter's own behind a "/", which
// other ids do not have.
std::string_view whole_luminaire(std::string_view id) { return id.substr(0, id.find('/')); }

Body placed(NamedMesh named, const Luminaire& luminaire, std::uint32_t material) {
  Body body;
  body.id = luminaire.id + "." + std::string(named.name);
  body.housing_of = luminaire.id;
  body.where = luminaire.where;
  body.is_closed = named.is_closed;
  body.material_of.assign(named.mesh.triangle.size(), material);
  body.triangle = std::move(named.mesh.triangle);
  for (const glm::dvec3& p : named.mesh.vertex_m) {
    body.vertex_m.push_back(luminaire.position_m + luminaire.world_from_luminaire * p);
  }
  return body;
}

// Of a housing's bodies.
bool is_face(const Body& body) {
  return body.id.size() > body.housing_of.size() &&
         body.id.substr(body.housing_of.size() + 1) == kFace;
}

}  // namespace

bool is_housing_of(const Body& body, const Luminaire& luminaire) {
  return !body.housing_of.empty() &&
         whole_luminaire(body.housing_of) == whole_luminaire(luminaire.id);
}

double backward_share(const PhotometricWeb& web) {
  return web.zonal_flux_lm(0.5 * kPi, kPi) / web.flux_lm();
}

std::vector<Body> housing_bodies(const Project& project, const Luminaire& luminaire,
                                 const HousingMesh* mesh) {
  const LuminaireType& type = project.luminaire_types[luminaire.type];
  std::vector<Body> bodies;
  if (!type.housing) return bodies;
  for (NamedMesh& named : meshes_of(project, type, mesh)) {
    bodies.push_back(placed(std::move(named), luminaire, type.housing->material));
  }
  return bodies;
}

namespace {

// How far a flat opening reaches from its centre in a unit direction of the luminaire's axes.
double half_width_m(const HousedOpening& housed, const glm::dvec3& direction) {
  const glm::dvec3 half_m = 0.5 * housed.opening.size_m();
  const double c0_m = half_m.x * std::abs(glm::dot(housed.place.turn[0], direction)),
               c90_m = half_m.y * std::abs(glm::dot(housed.place.turn[1], direction));
  return housed.opening.shape == OpeningShape::disk ? std::sqrt(c0_m * c0_m + c90_m * c90_m)
                                                    : c0_m + c90_m;
}

std::vector<glm::dvec3> box_corners_m(const HousingBox& box) {
  std::vector<glm::dvec3> corners_m;
  for (unsigned i = 0; i < 8; ++i) {
    corners_m.emplace_back((i & 1u) != 0 ? box.upper_m.x : box.lower_m.x,
                           (i & 2u) != 0 ? box.upper_m.y : box.lower_m.y,
                           (i & 4u) != 0 ? box.upper_m.z : box.lower_m.z);
  }
  return corners_m;
}

// Files may hold others.
std::vector<glm::dvec3> used_corners_m(const HousingMesh& mesh) {
  std::vector<char> is_used(mesh.vertex_m.size(), 0);
  for (const glm::uvec3& t : mesh.triangle) {
    for (const std::uint32_t v : {t.x, t.y, t.z}) is_used[v] = 1;
  }
  std::vector<glm::dvec3> corners_m;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i] != 0) corners_m.push_back(mesh.vertex_m[i]);
  }
  return corners_m;
}

}  // namespace

HousingBox reach_of(const std::vector<HousedOpening>& openings) {
  HousingBox reach;
  for (std::size_t i = 0; i < openings.size(); ++i) {
    glm::dvec3 out_m(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 along(0.0);
      along[axis] = 1.0;
      out_m[axis] = half_width_m(openings[i], along);
    }
    const glm::dvec3 lower_m = openings[i].place.position_m - out_m,
                     upper_m = openings[i].place.position_m + out_m;
    reach.lower_m = i == 0 ? lower_m : glm::min(reach.lower_m, lower_m);
    reach.upper_m = i == 0 ? upper_m : glm::max(reach.upper_m, upper_m);
  }
  return reach;
}

HousingBox housing_box_m(const std::vector<HousedOpening>& openings, const Housing& housing) {
  HousingBox box = reach_of(openings);
  if (housing.size_m) {
    const glm::dvec2 middle_m = 0.5 * (glm::dvec2(box.lower_m) + glm::dvec2(box.upper_m));
    box.lower_m = {middle_m - 0.5 * *housing.size_m, box.lower_m.z};
    box.upper_m = {middle_m + 0.5 * *housing.size_m, box.upper_m.z};
  }
  box.upper_m.z = box.lower_m.z + housing.depth_m;
  return box;
}

std::optional<HiddenOpening> hidden_opening(const std::vector<HousedOpening>& openings,
                                            const Housing& housing, const HousingMesh* mesh) {
  std::vector<glm::dvec3> corners_m;
  if (mesh != nullptr) {
    corners_m = used_corners_m(*mesh);
  } else if (housing.depth_m > 0.0) {
    corners_m = box_corners_m(housing_box_m(openings, housing));
  }
  std::optional<HiddenOpening> worst;
  const auto look = [&](std::size_t emitter, std::optional<std::size_t> face, double before_m) {
    if (before_m <= std::max(kSamePlane_m, worst ? worst->before_m : 0.0)) return;
    worst = HiddenOpening{emitter, face, before_m};
  };
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const EmitterPlace& place = openings[i].place;
    for (std::size_t face = 0; face < openings.size(); ++face) {
      if (face == i) continue;
      const HousedOpening& other = openings[face];
      // Round faces are polygons of the disk's area, whose corners lie beyond it.
      const double reach_m = half_width_m(other, place.turn[2]) *
                             (other.opening.shape == OpeningShape::disk ? same_area_factor() : 1.0);
      const double z_m = to_emitter(place, other.place.position_m).z;
      look(i, face, reach_m - z_m);
      if (openings[i].backward_share > kNoBackwardLight) look(i, face, reach_m + z_m);
    }
    for (const glm::dvec3& p : corners_m) look(i, std::nullopt, -to_emitter(place, p).z);
  }
  return worst;
}

std::optional<glm::dvec3> corner_outside(const LuminousOpening& opening, const HousingMesh& mesh) {
  PlacedLuminaire body{};
  body.world_from_luminaire = glm::dmat3(1.0);
  body.opening = opening;
  for (const glm::dvec3& p : used_corners_m(mesh)) {
    if (!is_inside_opening(body, p, kSamePlane_m - within_m(opening))) return p;
  }
  return std::nullopt;
}

void fit_housings(const Project& project, Space& space) {
  std::map<std::string_view, const Luminaire*> luminaire_of;
  for (const Luminaire& luminaire : space.luminaires) luminaire_of[luminaire.id] = &luminaire;
  // A housing that becomes a face may cut another luminaire: until nothing changes.
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    OpeningFit fit(space);
    std::vector<std::pair<std::size_t, Body>> faces;
    for (std::size_t i = 0; i < space.bodies.size(); ++i) {
      const Body& body = space.bodies[i];
      if (body.housing_of.empty() || is_face(body)) continue;
      const Luminaire& luminaire = *luminaire_of.at(body.housing_of);
      const LuminaireType& type = project.luminaire_types[luminaire.type];
      const LuminousOpening& opening = project.webs[type.web].opening();
      if (!fit.is_cut(opening, luminaire)) continue;
      faces.emplace_back(
          i, placed(face_of(flattened(opening), *type.housing), luminaire, type.housing->material));
    }
    for (auto& [index, face] : faces) {
      space.bodies[index] = std::move(face);
      has_changed = true;
    }
  }
}

std::size_t housing_triangles(const Project& project, const LuminaireType& type,
                              const HousingMesh* mesh) {
  std::size_t triangles = 0;
  if (!type.housing) return triangles;
  for (const NamedMesh& named : meshes_of(project, type, mesh)) {
    triangles += named.mesh.triangle.size();
  }
  return triangles;
}

}  // namespace calc
