#pragma once
// Reads PLY (Stanford polygon file), text and binary of either byte order, as triangles.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns whether the first line is "ply".
bool is_ply(std::string_view bytes);

// Reads elements "vertex" (x, y, z) and "face" (vertex_indices or vertex_index) and ignores others,
// except tristrips, which are refused. One object without a name, material "default". Empty if and
// only if an error was reported.
std::optional<TriangleMesh> parse_ply(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace calc
