#pragma once
// glTF 2.0, text and GLB, to triangles. tinygltf turns the JSON into a model; the frame of the
// file, every index and every range of bytes are checked here.

#include "calc/base/diagnostics.h"
#include "calc/meshes/mesh_file.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// The meshes of the default scene (the first one, if none is; all nodes without scenes) with the
// transforms of their nodes: metres, y up. One object per node and mesh. Points and lines are not
// surfaces and passed over, skins and morph targets too (with a warning). node: if given, only the
// node of that name and all below it, an error unless there is exactly one. Required extensions
// that change geometry and are not known here are an error; others that are not known are passed
// over with a warning. Empty if and only if an error was reported.
std::optional<TriangleMesh> parse_gltf(std::string_view bytes, const std::string& name,
                                       const SideFiles& side_files, Diagnostics& diagnostics,
                                       std::string_view node = {});

}  // namespace calc
