#include "calc/project/objects/mesh_attributes.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/objects/frame.h"
#include "calc/project/objects/material_map.h"
#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace calc {
namespace {

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
  const std::string node = reader.has("node") ? reader.text("node") : std::string();
  return context.files.mesh(file, format, node, reader.where("file"));
}

}  // namespace

std::optional<PlacedMesh> read_placed_mesh(ProjectContext& context, ElementReader& reader) {
  const Placement placement{rotation_about_z(read_angle_rad(reader, "rotation")),
                            read_point_m_or_zero(context, reader, "position")};
  const double scale = reader.number_or("scale", kPositive, 1.0);
  const TriangleMesh* mesh = read_mesh_file(context, reader);
  const MeshAxes axes = read_mesh_axes(reader, mesh);
  const MaterialMap materials = read_material_map(context, reader, "material of the mesh",
                                                  mesh != nullptr ? &mesh->material_name : nullptr);
  if (mesh == nullptr) return std::nullopt;
  PlacedMesh placed{mesh, {}, assign_materials(reader, *mesh, materials)};
  if (!reader.ok()) return std::nullopt;
  placed.vertex_m.reserve(mesh->vertex.size());
  for (const glm::dvec3& vertex : mesh->vertex) {
    const glm::dvec3 upright = axes.y_is_up ? glm::dvec3(vertex.x, -vertex.z, vertex.y) : vertex;
    placed.vertex_m.push_back(placement.apply(upright * (scale * axes.metres_per_unit)));
  }
  return placed;
}

}  // namespace calc
