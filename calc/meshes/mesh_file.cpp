#include "calc/meshes/mesh_file.h"

#include "calc/meshes/gltf_container.h"
#include "calc/meshes/mesh_gltf.h"
#include "calc/meshes/mesh_obj.h"
#include "calc/meshes/mesh_ply.h"
#include "calc/meshes/mesh_stl.h"

namespace calc {

std::optional<MeshFormat> detect_mesh_format(std::string_view bytes) {
  if (is_gltf(bytes)) return MeshFormat::gltf;
  if (is_ply(bytes)) return MeshFormat::ply;
  if (is_binary_stl(bytes) || is_text_stl(bytes)) return MeshFormat::stl;
  if (bytes.find('\0') == std::string_view::npos) return MeshFormat::obj;
  return std::nullopt;
}

std::optional<TriangleMesh> parse_mesh_file(std::string_view bytes, const std::string& name,
                                            const SideFiles& side_files, Diagnostics& diagnostics,
                                            std::optional<MeshFormat> format) {
  const std::optional<MeshFormat> found = detect_mesh_format(bytes);
  if (format && found && format != found) {
    diagnostics.report(DiagnosticId::mesh_other_format, SourceLocation{name, 0, 0},
                       name_of(*format), name_of(*found));
    return std::nullopt;
  }
  // A cut-off binary STL looks like nothing, but its reader says what is missing.
  const bool is_named_stl = name.ends_with(".stl") || name.ends_with(".STL");
  switch (found.value_or(format.value_or(is_named_stl ? MeshFormat::stl : MeshFormat::obj))) {
    case MeshFormat::gltf:
      return parse_gltf(bytes, name, side_files, diagnostics);
    case MeshFormat::ply:
      return parse_ply(bytes, name, diagnostics);
    case MeshFormat::stl:
      return parse_stl(bytes, name, diagnostics);
    case MeshFormat::obj:
      break;
  }
  if (!found) {
    diagnostics.report(DiagnosticId::mesh_unknown_format, SourceLocation{name, 0, 0});
    return std::nullopt;
  }
  return parse_obj(bytes, name, diagnostics);
}

}  // namespace calc
