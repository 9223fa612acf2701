#pragma once
// Reads STL, text and binary, as triangles.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns whether the size matches the binary header's count: 84 + 50 bytes per triangle.
bool is_binary_stl(std::string_view bytes);
// Returns whether the first word is "solid" and all bytes are text.
bool is_text_stl(std::string_view bytes);

// Reads one object per solid, all of material "default". Normals and attribute bytes are not used.
// Empty if and only if an error was reported.
std::optional<TriangleMesh> parse_stl(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace calc
