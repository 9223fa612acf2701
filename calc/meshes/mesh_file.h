#pragma once
// Reads any mesh file as triangles. The contents decide its format, not the file's name.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns the bytes of a file that a mesh file names, e.g. the .bin of a .gltf: path relative to
// the mesh file's folder, normalised, in that folder or below. Reports errors, and is then empty.
using SideFiles = std::function<std::optional<std::string>(const std::string& path)>;

// Returns the format: "glTF" or "{" at the start: glTF; "ply": PLY; "solid", or the exact size of a
// binary STL: STL; all other text: OBJ. Empty for other bytes.
std::optional<MeshFormat> detect_mesh_format(std::string_view bytes);

// Returns the mesh. name: the path used in messages. format: if given, anything else is an error.
// node: "", or the node of a glTF file whose meshes, with all below it, are read; an error for
// other files. Empty if and only if an error was reported.
std::optional<TriangleMesh> parse_mesh_file(std::string_view bytes, const std::string& name,
                                            const SideFiles& side_files, Diagnostics& diagnostics,
                                            std::optional<MeshFormat> format = std::nullopt,
                                            std::string_view node = {});

}  // namespace calc
