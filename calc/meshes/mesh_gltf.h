#pragma once
// Reads glTF 2.0, text and GLB, as triangles. tinygltf turns the JSON into a model; the frame of
// the file, every index and every range of bytes are checked here.

#include "calc/base/diagnostics.h"
#include "calc/meshes/mesh_file.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns the meshes of the default scene (else the first; all nodes without scenes) with the
// transforms of their nodes: metres, y up. One object per node and mesh. Points and lines are
// ignored, because they are not surfaces; skins and morph targets, too (with a warning). node: if
// given, only the node of that name and all below it, an error unless there is exactly one. Unknown
// required extensions that change geometry are an error; other unknown ones are ignored with a
// warning. Empty if and only if an error was reported.
std::optional<TriangleMesh> parse_gltf(std::string_view bytes, const std::string& name,
                                       const SideFiles& side_files, Diagnostics& diagnostics,
                                       std::string_view node = {});

}  // namespace calc
