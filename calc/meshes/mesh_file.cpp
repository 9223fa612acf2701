#include "calc/meshes/mesh_file.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/encoding.h"
#include "calc/base/file_kind.h"
#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/meshes/gltf_container.h"
#include "calc/meshes/mesh_gltf.h"
#include "calc/meshes/mesh_obj.h"
#include "calc/meshes/mesh_ply.h"
#include "calc/meshes/mesh_stl.h"

#include <vector>

namespace calc {

std::optional<MeshFormat> detect_mesh_format(std::string_view bytes) {
  if (is_gltf(bytes)) return MeshFormat::gltf;
  if (is_ply(bytes)) return MeshFormat::ply;
  if (is_binary_stl(bytes) || is_text_stl(bytes)) return MeshFormat::stl;
  if (bytes.find('\0') == std::string_view::npos) return MeshFormat::obj;
  return std::nullopt;
}

namespace {

// A statement of OBJ at the start of a line.
bool has_obj_statement(std::string_view text) {
  LineCursor lines(text);
  while (const std::optional<std::string_view> line = lines.next()) {
    const std::vector<std::string_view> words = split_words(line->substr(0, 200));
    if (!words.empty() && (words[0] == "v" || words[0] == "f")) return true;
  }
  return false;
}

std::optional<TriangleMesh> parse_obj_file(std::string_view text, const std::string& name,
                                           Diagnostics& diagnostics) {
  const bool is_obj = has_obj_statement(text);
  if (!check_file_kind(text, name, FileUse::mesh, diagnostics, is_obj)) return std::nullopt;
  const bool is_named_obj = name.ends_with(".obj") || name.ends_with(".OBJ");
  if (!is_obj && !is_named_obj && !text.empty()) {
    diagnostics.report(DiagnosticId::mesh_unknown_format, SourceLocation{name, 0, 0});
    return std::nullopt;
  }
  return parse_obj(text, name, diagnostics);
}

}  // namespace

std::optional<TriangleMesh> parse_mesh_file(std::string_view bytes, const std::string& name,
                                            const SideFiles& side_files, Diagnostics& diagnostics,
                                            std::optional<MeshFormat> format,
                                            std::string_view node) {
  // A binary STL may begin with anything.
  if (!is_binary_stl(bytes) && !check_file_kind(bytes, name, FileUse::mesh, diagnostics)) {
    return std::nullopt;
  }
  if (has_utf16_mark(bytes) && !is_binary_stl(bytes)) {
    const DecodedText decoded = decoded_text(std::string(bytes));
    if (decoded.problem.empty() && !has_utf16_mark(decoded.utf8)) {
      return parse_mesh_file(decoded.utf8, name, side_files, diagnostics, format, node);
    }
  }
  const std::optional<MeshFormat> found = detect_mesh_format(bytes);
  if (format && found && format != found) {
    diagnostics.report(DiagnosticId::mesh_other_format, SourceLocation{name, 0, 0},
                       name_of(*format), name_of(*found));
    return std::nullopt;
  }
  // A cut-off binary STL looks like nothing, but its reader says what is missing.
  const bool is_named_stl = name.ends_with(".stl") || name.ends_with(".STL");
  if (!node.empty() && found && found != MeshFormat::gltf) {
    diagnostics.report(DiagnosticId::mesh_node, SourceLocation{name, 0, 0}, shorten_utf8(node, 60),
                       "only glTF files have nodes");
    return std::nullopt;
  }
  switch (found.value_or(format.value_or(is_named_stl ? MeshFormat::stl : MeshFormat::obj))) {
    case MeshFormat::gltf:
      return parse_gltf(bytes, name, side_files, diagnostics, node);
    case MeshFormat::ply:
      return parse_ply(bytes, name, diagnostics);
    case MeshFormat::stl:
      return parse_stl(bytes, name, diagnostics);
    case MeshFormat::obj:
      break;
  }
  if (found) return parse_obj_file(bytes, name, diagnostics);
  if (check_file_kind(bytes, name, FileUse::mesh, diagnostics, false)) {
    diagnostics.report(DiagnosticId::mesh_unknown_format, SourceLocation{name, 0, 0});
  }
  return std::nullopt;
}

}  // namespace calc
