#pragma once
// Wavefront OBJ to triangles. tinyobjloader splits the file into statements; every number it hands
// on is checked.

#include "calc/diagnostics.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// As in the file: no unit, no axis change. material[i] is the usemtl name of triangle i ("" =
// none).
struct ObjMesh {
  std::vector<glm::dvec3> vertex;
  std::vector<glm::uvec3> triangle;
  std::vector<std::string> material;
};

// Vertices, faces and material names; .mtl files are not needed, lines, points and curves are not
// surfaces and passed over. Faces with more than three corners are triangulated (concave ones
// correctly); those not flat too, as seen along their mean normal, with one warning. Faces without
// area or with crossing sides are left out, with one warning. Errors (bad index, not a number, no
// face) are reported, the first ten of them; empty if and only if there was one.
std::optional<ObjMesh> parse_obj(std::string_view bytes, const std::string& name,
                                 Diagnostics& diagnostics);

}  // namespace calc
