#include "calc/project/objects/housing_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/utf8.h"
#include "calc/project/objects/mesh_attributes.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/housing.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace calc {
namespace {

// Sizes of housings and openings are often rounded to this.
constexpr double kSizeRounding_m = 1.0e-3;

// What is wrong with a housing is said at the attribute.
void refuse(ElementReader& reader, std::string_view attribute, const std::string& expected) {
  reader.report(DiagnosticId::number_out_of_range, reader.where(attribute), attribute, "housing",
                shorten_utf8(reader.text(attribute), 80), expected);
}

void refuse_point(ElementReader& reader) {
  reader.report(DiagnosticId::missing_form, reader.where(), "housing",
                "photometry with a luminous opening; this photometry has none, or "
                "opening=\"point\" leaves it out");
}

std::string backwards_words(double share) {
  return fmt::format(
      "no value: {:.2g} % of the light goes backwards and would be lost in the housing. "
      "Without this attribute the face alone takes up light, on both sides",
      100.0 * share);
}

std::string size_words(const LuminousOpening& opening) {
  return fmt::format("{:.4g} x {:.4g} x {:.4g} m", opening.along_c0_m, opening.along_c90_m,
                     opening.height_m);
}

// Than an outline of these sides.
bool is_smaller(const Housing& housing, double along_c0_m, double along_c90_m) {
  return housing.size_m && (housing.size_m->x < along_c0_m - kSizeRounding_m ||
                            housing.size_m->y < along_c90_m - kSizeRounding_m);
}

// Of one emitter, without a mesh.
void check_housing(ElementReader& reader, const HousedOpening& housed, const Housing& housing) {
  const LuminousOpening& opening = housed.opening;
  const auto refuse_size = [&](std::string_view attribute, const std::string& expected) {
    const std::string_view where = reader.has("dimensions") ? "dimensions" : attribute;
    const std::string value =
        where == "dimensions" && housing.size_m
            ? fmt::format("file ({:.4g} x {:.4g} m, {:.4g} m deep)", housing.size_m->x,
                          housing.size_m->y, housing.depth_m)
            : reader.text(where);
    reader.report(DiagnosticId::number_out_of_range, reader.where(where), where, "housing", value,
                  expected);
  };
  if (opening.shape == OpeningShape::point) return refuse_point(reader);
  if (opening.is_body()) {
    for (const std::string_view attribute : {"depth", "size", "dimensions"}) {
      if (!reader.has(attribute)) continue;
      refuse_size(attribute,
                  "no value: the opening of this photometry is a body, " + size_words(opening));
    }
    return;
  }
  if (is_smaller(housing, opening.along_c0_m, opening.along_c90_m)) {
    refuse_size("size", fmt::format("at least the luminous opening, {:.4g} x {:.4g} m",
                                    opening.along_c0_m, opening.along_c90_m));
  }
  const double backwards = housed.backward_share;
  if (housing.depth_m > 0.0 && backwards > kNoBackwardLight) {
    refuse_size("depth", backwards_words(backwards));
  }
}

void read_stated_size(const ProjectContext& context, ElementReader& reader, Housing& housing) {
  housing.depth_m =
      reader.optional_number("depth", kPositive).value_or(0.0) * context.metres_per_unit;
  if (!reader.has("size")) return;
  const std::vector<double> size =
      reader.numbers("size", 2, "2 numbers (along C0, along C90)", kPositive);
  housing.size_m = glm::dvec2(size[0], size[1]) * context.metres_per_unit;
}

// What is wrong with a housing of several emitters, light[i] with openings[i]. mesh: null for a
// box.
void check_common_housing(ElementReader& reader, const std::vector<PlacedWeb>& light,
                          const std::vector<HousedOpening>& openings, const Housing& housing,
                          const HousingMesh* mesh) {
  const std::string_view attribute = mesh != nullptr ? "file" : "depth";
  const auto need = [&](const std::string& what) {
    reader.report(DiagnosticId::missing_form, reader.where(), "housing", what);
  };
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const LuminousOpening& opening = openings[i].opening;
    const std::string& emitter = light[i].emitter;
    if (opening.shape == OpeningShape::point) {
      return need(
          fmt::format("photometry with a luminous opening; emitter '{}' has none, or "
                      "opening=\"point\" leaves it out",
                      emitter));
    }
    if (opening.is_body()) {
      return need(
          fmt::format("flat luminous openings for a luminaire of several emitters; the opening of "
                      "emitter '{}' is a body, {}",
                      emitter, size_words(opening)));
    }
    const double backwards = openings[i].backward_share;
    if ((mesh != nullptr || housing.depth_m > 0.0) && backwards > kNoBackwardLight) {
      return refuse(reader, attribute,
                    fmt::format("no value: {:.2g} % of the light of emitter '{}' goes backwards "
                                "and would be lost in the housing. Without this attribute the "
                                "faces alone take up light, on both sides",
                                100.0 * backwards, emitter));
    }
  }
  const HousingBox reach = reach_of(openings);
  const glm::dvec3 size_m = reach.upper_m - reach.lower_m;
  if (is_smaller(housing, size_m.x, size_m.y)) {
    return refuse(
        reader, "size",
        fmt::format("at least the size of all luminous openings together, {:.4g} x {:.4g} m",
                    size_m.x, size_m.y));
  }
  const std::optional<HiddenOpening> hidden = hidden_opening(openings, housing, mesh);
  if (!hidden) return;
  const std::string& emitter = light[hidden->emitter].emitter;
  if (hidden->face) {
    return need(
        fmt::format("luminous openings that do not block each other's light; the face of "
                    "emitter '{}' would reach {:.3g} m into the light of emitter '{}'",
                    light[*hidden->face].emitter, hidden->before_m, emitter));
  }
  refuse(
      reader, attribute,
      fmt::format("{}; it would reach {:.3g} m into the light of emitter '{}'",
                  mesh != nullptr
                      ? "a mesh with all of its parts behind all openings"
                      : "no value, or a box around all openings that is in front of none of them",
                  hidden->before_m, emitter));
}

// The same of one emitter with a mesh.
void check_mesh(ElementReader& reader, const HousedOpening& housed, const Housing& housing,
                const HousingMesh& mesh) {
  const LuminousOpening& opening = housed.opening;
  if (opening.shape == OpeningShape::point) return refuse_point(reader);
  if (opening.is_body()) {
    const std::optional<glm::dvec3> outside = corner_outside(opening, mesh);
    if (!outside) return;
    return refuse(reader, "file",
                  fmt::format("surfaces inside the luminous opening, which is a body of {}, and "
                              "1 mm or a tenth of its half size away from its surface. A corner "
                              "is at ({:.4g}, {:.4g}, {:.4g}) m from its centre, along C0, C90 "
                              "and backwards",
                              size_words(opening), outside->x, outside->y, outside->z));
  }
  if (housed.backward_share > kNoBackwardLight) {
    return refuse(reader, "file", backwards_words(housed.backward_share));
  }
  const std::optional<HiddenOpening> hidden = hidden_opening({housed}, housing, &mesh);
  if (!hidden) return;
  refuse(
      reader, "file",
      fmt::format("surfaces behind the luminous opening; a corner is {:.3g} m in front of it and "
                  "would block its light. z is 0 at the opening and points backwards (up for a "
                  "luminaire that shines down)",
                  hidden->before_m));
}

// A box, of whose size nobody but the project knows: each emitter has a file of its own.
void read_common_size(const ProjectContext& context, ElementReader& reader, Housing& housing) {
  if (reader.has("dimensions")) {
    reader.report(DiagnosticId::missing_form, reader.where("dimensions"), "housing",
                  "'depth' instead of 'dimensions' for a luminaire of several emitters: each "
                  "emitter has its own photometry");
    return;
  }
  if (reader.has("size") && !reader.has("depth")) {
    reader.report(DiagnosticId::missing_form, reader.where("size"), "housing",
                  "'depth' beside 'size' for a luminaire of several emitters: their faces have "
                  "the size of the openings");
    return;
  }
  read_stated_size(context, reader, housing);
}

// Its size in the project, or where that asks for it in the photometry.
void read_housing_size(const ProjectContext& context, ElementReader& reader,
                       const PhotometrySource& source, Housing& housing) {
  reader.exclude("dimensions", "size");
  reader.exclude("dimensions", "depth");
  if (!reader.has("dimensions")) return read_stated_size(context, reader, housing);
  reader.choice("dimensions", kHousingDimensionsType.words);
  if (!reader.ok()) return;
  if (!source.body_m) {
    reader.report(DiagnosticId::missing_form, reader.where("dimensions"), "housing",
                  "'size' and 'depth': this photometry does not state how large the luminaire is "
                  "(EULUMDAT files can)");
    return;
  }
  housing.size_m = glm::dvec2(*source.body_m);
  housing.depth_m = source.body_m->z;
  housing.is_round = source.body_is_round;
}

constexpr std::array<std::string_view, 7> kOfTheMesh{"format", "node", "position", "rotation",
                                                     "scale",  "up",   "units"};

// Its surfaces all have the housing's material. openings: of all emitters.
std::optional<HousingMesh> read_housing_mesh(ProjectContext& context, ElementReader& reader,
                                             const std::vector<HousedOpening>& openings,
                                             Housing& housing) {
  for (const std::string_view other : {"depth", "size", "dimensions"}) {
    reader.exclude("file", other);
  }
  if (!reader.ok()) return std::nullopt;  // a material that is missing is said
  std::optional<PlacedMesh> placed = read_placed_mesh(context, reader);
  if (!placed) return std::nullopt;
  constexpr double kVertex = 24.0, kTriangle = 12.0;  // bytes
  const double bytes = kVertex * static_cast<double>(placed->vertex_m.size()) +
                       kTriangle * static_cast<double>(placed->mesh->triangle.size());
  if (!context.files.take(bytes, reader.where("file"), "the meshes of housings take")) {
    return std::nullopt;
  }
  Body body;
  body.vertex_m = std::move(placed->vertex_m);
  body.triangle = placed->mesh->triangle;
  HousingMesh mesh;
  mesh.is_closed = is_watertight(body);
  mesh.vertex_m = std::move(body.vertex_m);
  mesh.triangle = std::move(body.triangle);
  // For reports: how far it reaches, of flat openings from the foremost one.
  BoundingBox reach;
  for (const glm::uvec3& t : mesh.triangle) {
    for (const std::uint32_t v : {t.x, t.y, t.z}) reach.add(mesh.vertex_m[v]);
  }
  const bool is_flat = !openings.front().opening.is_body();
  const double front_m = is_flat ? reach_of(openings).lower_m.z : reach.lower.z;
  housing.depth_m = std::max(0.0, reach.upper.z - front_m);
  return mesh;
}

// Empty after an error. mesh: of a housing that is a file.
std::optional<Housing> read_one_housing(ProjectContext& context, ElementReader& reader,
                                        const std::vector<PlacedWeb>& light,
                                        std::optional<HousingMesh>& mesh) {
  std::vector<HousedOpening> openings;
  for (const PlacedWeb& emitter : light) {
    const PhotometricWeb& web = context.project.webs[emitter.web];
    // One alone is in the middle.
    openings.push_back(
        {web.opening(), backward_share(web), light.size() > 1 ? emitter.place : EmitterPlace{}});
  }
  Housing housing;
  housing.material = read_material(context, reader);
  if (reader.has("file")) {
    mesh = read_housing_mesh(context, reader, openings, housing);
    if (!mesh) return std::nullopt;
  } else {
    for (const std::string_view attribute : kOfTheMesh) {
      if (!reader.has(attribute)) continue;
      reader.report(DiagnosticId::missing_form, reader.where(attribute), "housing",
                    fmt::format("'file' beside '{}', which describes a mesh file", attribute));
    }
    if (light.size() > 1) {
      read_common_size(context, reader, housing);
    } else {
      read_housing_size(context, reader, context.project.webs[light.front().web].source(), housing);
    }
  }
  if (!reader.ok()) return std::nullopt;
  if (light.size() > 1) {
    check_common_housing(reader, light, openings, housing, mesh ? &*mesh : nullptr);
  } else if (mesh) {
    check_mesh(reader, openings.front(), housing, *mesh);
  } else {
    check_housing(reader, openings.front(), housing);
    // For reports: a body is no face.
    const LuminousOpening& opening = openings.front().opening;
    if (opening.is_body()) housing.depth_m = opening.height_m;
  }
  return reader.ok() ? std::optional(housing) : std::nullopt;
}

}  // namespace

void read_housing(ProjectContext& context, const XmlElement& element,
                  const std::vector<PlacedWeb>& light, LuminaireType& type) {
  for (const XmlElement& child : element.children) {
    if (child.name != "housing") continue;
    ElementReader reader(child, context.diagnostics);
    reader.allow(kHousingElement);
    if (type.housing) {
      reader.report(DiagnosticId::missing_form, reader.where(), element.name,
                    "at most one <housing>");
      continue;
    }
    std::optional<HousingMesh> mesh;
    type.housing = read_one_housing(context, reader, light, mesh);
    if (type.housing && mesh) {
      context.housing_meshes.emplace(context.project.luminaire_types.size(), std::move(*mesh));
    }
  }
}

}  // namespace calc
