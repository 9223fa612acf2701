#pragma once
// STL, text and binary, to triangles.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// True if the size is exactly what the binary header's count asks for: 84 + 50 bytes per triangle.
bool is_binary_stl(std::string_view bytes);
// True if the first word is "solid" and there are no bytes that are not text.
bool is_text_stl(std::string_view bytes);

// One object per solid, all of material "default". Normals and attribute bytes are not used. Empty
// if and only if an error was reported.
std::optional<TriangleMesh> parse_stl(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace calc
