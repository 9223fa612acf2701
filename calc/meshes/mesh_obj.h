#pragma once
// Wavefront OBJ to triangles. tinyobjloader splits the file into statements; every number it hands
// on is checked.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Vertices, faces, usemtl names as materials, and names of o or g statements (the last one before a
// face) as objects; .mtl files are not needed, lines, points and curves are not surfaces and passed
// over. Errors (bad index, not a number, no face) are reported, the first ten of them; empty if and
// only if there was one.
std::optional<TriangleMesh> parse_obj(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace calc
