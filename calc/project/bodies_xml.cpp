#include "calc/project/bodies_xml.h"

#include "calc/project/frame.h"
#include "calc/project/luminous_surface.h"
#include "calc/project/material_map.h"
#include "calc/project/project_elements.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_mend.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace calc {
namespace {

constexpr double kParallelSidesSine = 1.0e-9;

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

// Per triangle. Reports all names without a material in one message.
std::vector<std::uint32_t> assign_materials(ElementReader& reader, const TriangleMesh& mesh,
                                            const MaterialMap& materials) {
  std::vector<std::uint32_t> material_of_name;
  std::vector<std::string> missing;
  for (const std::string& name : mesh.material_name) {
    if (const std::optional<std::uint32_t> material = materials.find(name)) {
      material_of_name.push_back(*material);
    } else {
      material_of_name.push_back(0);
      missing.push_back(name.empty() ? "faces without a material" : "'" + name + "'");
    }
  }
  if (!missing.empty()) {
    reader.report(DiagnosticId::unmapped_mesh_materials, reader.where(), reader.text("id"),
                  fmt::format("{}", fmt::join(missing, ", ")));
  }
  std::vector<std::uint32_t> material_of;
  material_of.reserve(mesh.material_of.size());
  for (const std::uint32_t name : mesh.material_of) material_of.push_back(material_of_name[name]);
  return material_of;
}

// How coordinates of a mesh file become metres with z up.
struct MeshAxes {
  double metres_per_unit = 1.0;
  bool y_is_up = true;
};

// Files that fix both may be told the same again, nothing else; all others must be told.
MeshAxes read_mesh_axes(ElementReader& reader, const TriangleMesh* mesh) {
  const Names& up_names = kUpAxisType.words;
  if (mesh == nullptr || !has_fixed_units(mesh->format)) {
    // Without the file nothing is known that would be missing.
    const auto wanted = [&](std::string_view name) { return mesh != nullptr || reader.has(name); };
    MeshAxes axes;
    if (wanted("units"))
      axes.metres_per_unit = metres_per_unit(reader.choice("units", kUnitsType.words));
    if (wanted("up")) axes.y_is_up = reader.choice("up", up_names) == 1;
    return axes;
  }
  const std::string_view format = name_of(mesh->format);
  if (reader.choice_or("units", kUnitsType.words, 0) != 0) {
    reader.report(DiagnosticId::mesh_units_fixed, reader.where("units"), "units", format, "m");
  }
  if (reader.choice_or("up", up_names, 1) != 1) {
    reader.report(DiagnosticId::mesh_units_fixed, reader.where("up"), "up", format, "y");
  }
  return {};
}

const TriangleMesh* read_mesh_file(ProjectContext& context, ElementReader& reader) {
  std::optional<MeshFormat> format;
  if (reader.has("format")) {
    format = reader.value<MeshFormat>("format");
  }
  const std::string file = reader.text("file");
  if (file.empty()) return nullptr;
  return context.files.mesh(file, format, reader.where("file"));
}

}  // namespace

ObjectSet read_box(ProjectContext& context, ElementReader& reader) {
  reader.allow(kBoxElement);
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
  reader.allow(kQuadElement);
  const glm::dvec3 origin = read_point_m(context, reader, "origin");
  const glm::dvec3 u = read_point_m(context, reader, "u");
  const glm::dvec3 v = read_point_m(context, reader, "v");
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  if (!(glm::length(glm::cross(u, v)) > kParallelSidesSine * glm::length(u) * glm::length(v))) {
    reader.report(DiagnosticId::parallel_vectors, reader.where("u"), "u", "v", "quad");
    return {};
  }
  ObjectSet set = set_of(single_material_body({origin, origin + u, origin + u + v, origin + v},
                                              {{0, 1, 2}, {0, 2, 3}}, material, reader.where()));
  add_luminous_surface(context, reader, {origin, u, v}, set);
  return set;
}

ObjectSet read_polygon(ProjectContext& context, ElementReader& reader) {
  reader.allow(kPolygonElement);
  std::vector<glm::dvec3> corners = read_corners_m(context, reader, "points");
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  std::optional<MendedPolygon> mended = mend_polygon(corners);
  if (!mended || mended->deviation > kNearlyPlanar) {
    reader.report(DiagnosticId::not_simple_polygon, reader.where("points"), "points", "polygon",
                  "lie in one plane and ");
    return {};
  }
  warn_of_mending(reader, "points", mended->mending, "");
  if (mended->deviation > kPlanarTolerance) {
    reader.report(DiagnosticId::outline_bent, reader.where("points"), "points", "polygon",
                  mended->deviation);
  }
  drop_unused_corners(corners, mended->triangle);
  return set_of(single_material_body(std::move(corners), std::move(mended->triangle), material,
                                     reader.where()));
}

ObjectSet read_mesh(ProjectContext& context, ElementReader& reader) {
  reader.allow(kMeshElement);
  const Placement placement{rotation_about_z(read_angle_rad(reader, "rotation")),
                            read_point_m_or_zero(context, reader, "position")};
  const double scale = reader.number_or("scale", kPositive, 1.0);
  const TriangleMesh* mesh = read_mesh_file(context, reader);
  const MeshAxes axes = read_mesh_axes(reader, mesh);
  const MaterialMap materials = read_material_map(context, reader, "material of the mesh",
                                                  mesh != nullptr ? &mesh->material_name : nullptr);
  if (mesh == nullptr) return {};
  Body body;
  body.where = reader.where();
  body.material_of = assign_materials(reader, *mesh, materials);
  if (!reader.ok()) return {};
  body.triangle = mesh->triangle;
  for (const glm::dvec3& vertex : mesh->vertex) {
    const glm::dvec3 upright = axes.y_is_up ? glm::dvec3(vertex.x, -vertex.z, vertex.y) : vertex;
    body.vertex_m.push_back(placement.apply(upright * (scale * axes.metres_per_unit)));
  }
  body.is_closed = is_watertight(body);
  return set_of(std::move(body));
}

}  // namespace calc
