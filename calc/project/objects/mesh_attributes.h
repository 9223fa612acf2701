#pragma once
// Reads how <mesh> and a <room> from a mesh describe their file.

#include "calc/meshes/triangle_mesh.h"
#include "calc/project/reading/project_context.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace calc {

struct PlacedMesh {
  const TriangleMesh* mesh;             // stays valid as long as the context's files
  std::vector<glm::dvec3> vertex_m;     // in the coordinates around the element, z up
  std::vector<std::uint32_t> material;  // per triangle, index into Project::materials
};

// Reads the attributes file, format, node, position, rotation, scale, up, units and material, and
// the children <map>. Empty after an error.
std::optional<PlacedMesh> read_placed_mesh(ProjectContext& context, ElementReader& reader);

}  // namespace calc
