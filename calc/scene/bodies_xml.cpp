#include "calc/scene/bodies_xml.h"

#include "calc/scene/frame.h"
#include "calc/scene/polygon.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace calc {
namespace {

constexpr double kParallelSine = 1.0e-9;

ObjectSet set_of(Body body) {
  ObjectSet set;
  set.add_body(std::move(body));
  return set;
}

Body single_material_body(std::vector<glm::dvec3> vertex_m, std::vector<glm::uvec3> triangle,
                          std::uint32_t material, const SourceLocation& where) {
  Body body;
  body.vertex_m = std::move(vertex_m);
  body.material_of.assign(triangle.size(), material);
  body.triangle = std::move(triangle);
  body.where = where;
  return body;
}

// Corner i of the unit cube: x, y, z are the bits of i. Triangles wind counter-clockwise seen from
// outside.
const std::vector<glm::uvec3>& box_triangles() {
  static const std::vector<glm::uvec3> kTriangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                                  {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                  {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return kTriangles;
}

// Materials of a mesh by usemtl name; `fallback` for names not mapped.
struct MeshMaterials {
  std::map<std::string, std::uint32_t, std::less<>> of_name;
  std::optional<std::uint32_t> fallback;
};

MeshMaterials read_mesh_materials(ProjectContext& context, ElementReader& reader,
                                  const ObjMesh* mesh) {
  MeshMaterials materials;
  if (reader.has("material")) materials.fallback = read_material(context, reader);
  std::set<std::string_view> known;
  if (mesh != nullptr) known.insert(mesh->material.begin(), mesh->material.end());
  known.erase("");
  IdTable names("usemtl");
  for (const XmlElement& child : reader.element().children) {
    if (child.name != "map") continue;
    ElementReader map(child, context.diagnostics);
    map.allow_attributes({"name", "material"});
    map.allow_children({});
    const std::string name = map.text("name");
    names.add(map, name, 0);
    if (mesh != nullptr && !name.empty() && !known.contains(name)) {
      report_unknown_reference(map, "name", "usemtl", name, Names(known.begin(), known.end()));
    }
    materials.of_name[name] = read_material(context, map);
  }
  return materials;
}

// Reports all names without a material in one message.
std::vector<std::uint32_t> assign_materials(ElementReader& reader, const ObjMesh& mesh,
                                            const MeshMaterials& materials) {
  std::vector<std::uint32_t> material_of;
  std::vector<std::string> missing;
  for (const std::string& name : mesh.material) {
    const auto mapped = materials.of_name.find(name);
    if (mapped != materials.of_name.end()) {
      material_of.push_back(mapped->second);
    } else if (materials.fallback) {
      material_of.push_back(*materials.fallback);
    } else {
      const std::string words = name.empty() ? "faces without usemtl" : "usemtl '" + name + "'";
      if (std::find(missing.begin(), missing.end(), words) == missing.end()) {
        missing.push_back(words);
      }
    }
  }
  if (!missing.empty()) {
    reader.report(DiagnosticId::unmapped_mesh_materials, reader.where(), reader.text("id"),
                  fmt::format("{}", fmt::join(missing, ", ")));
  }
  return material_of;
}

}  // namespace

ObjectSet read_box(ProjectContext& context, ElementReader& reader) {
  reader.allow_attributes({"id", "size", "position", "rotation", "material", "repeat", "step"});
  reader.allow_children({});
  const glm::dvec3 size = read_size_m(context, reader, "size");
  const Placement placement{rotation_about_z(read_angle_rad(reader, "rotation")),
                            read_point_m_or_zero(context, reader, "position")};
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  std::vector<glm::dvec3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 unit(i & 1u, (i >> 1u) & 1u, (i >> 2u) & 1u);
    corners.push_back(placement.apply(unit * size));
  }
  ObjectSet set =
      set_of(single_material_body(std::move(corners), box_triangles(), material, reader.where()));
  set.bodies[0].is_closed = true;
  set.box_tops[""] = {placement.apply({0, 0, size.z}), placement.turn * glm::dvec3(size.x, 0, 0),
                      placement.turn * glm::dvec3(0, size.y, 0)};
  return set;
}

ObjectSet read_quad(ProjectContext& context, ElementReader& reader) {
  reader.allow_attributes({"id", "origin", "u", "v", "material", "repeat", "step"});
  reader.allow_children({});
  const glm::dvec3 origin = read_point_m(context, reader, "origin");
  const glm::dvec3 u = read_point_m(context, reader, "u");
  const glm::dvec3 v = read_point_m(context, reader, "v");
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  if (!(glm::length(glm::cross(u, v)) > kParallelSine * glm::length(u) * glm::length(v))) {
    reader.report(DiagnosticId::parallel_vectors, reader.where("u"), "u", "v", "quad");
    return {};
  }
  return set_of(single_material_body({origin, origin + u, origin + u + v, origin + v},
                                     {{0, 1, 2}, {0, 2, 3}}, material, reader.where()));
}

ObjectSet read_polygon(ProjectContext& context, ElementReader& reader) {
  reader.allow_attributes({"id", "points", "material", "repeat", "step"});
  reader.allow_children({});
  std::vector<glm::dvec3> corners = read_corners_m(context, reader, "points");
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  std::optional<std::vector<glm::uvec3>> triangles = triangulate_polygon(corners);
  if (!triangles) {
    reader.report(DiagnosticId::not_simple_polygon, reader.where("points"), "points", "polygon",
                  "lie in one plane and ");
    return {};
  }
  return set_of(
      single_material_body(std::move(corners), std::move(*triangles), material, reader.where()));
}

ObjectSet read_mesh(ProjectContext& context, ElementReader& reader) {
  reader.allow_attributes(
      {"id", "file", "position", "rotation", "scale", "up", "units", "material", "repeat", "step"});
  reader.allow_children({"map"});
  const Placement placement{rotation_about_z(read_angle_rad(reader, "rotation")),
                            read_point_m_or_zero(context, reader, "position")};
  double scale = reader.number_or("scale", kPositive, 1.0);
  const bool y_is_up = reader.choice_or("up", {"z", "y"}, 0) == 1;
  scale *= reader.has("units") ? metres_per_unit(reader.choice("units", unit_names()))
                               : context.metres_per_unit;
  const std::string file = reader.text("file");
  const ObjMesh* mesh = file.empty() ? nullptr : context.files.mesh(file, reader.where("file"));
  const MeshMaterials materials = read_mesh_materials(context, reader, mesh);
  if (mesh == nullptr) return {};
  Body body;
  body.where = reader.where();
  body.material_of = assign_materials(reader, *mesh, materials);
  if (!reader.ok()) return {};
  body.triangle = mesh->triangle;
  for (const glm::dvec3& vertex : mesh->vertex) {
    const glm::dvec3 upright = y_is_up ? glm::dvec3(vertex.x, -vertex.z, vertex.y) : vertex;
    body.vertex_m.push_back(placement.apply(upright * scale));
  }
  body.is_closed = is_watertight(body);
  return set_of(std::move(body));
}

}  // namespace calc
