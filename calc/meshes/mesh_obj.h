#pragma once
// Reads Wavefront OBJ as triangles. tinyobjloader splits the file into statements; every number
// from it is checked.

#include "calc/base/diagnostics.h"
#include "calc/meshes/triangle_mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Reads vertices, faces, usemtl names as materials, and names of o or g statements (the last one
// before a face) as objects. .mtl files are not needed; lines, points and curves are ignored,
// because they are not surfaces. The first ten errors (bad index, not a number, no face) are
// reported; empty if and only if there was one.
std::optional<TriangleMesh> parse_obj(std::string_view bytes, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace calc
