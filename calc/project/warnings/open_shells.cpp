#include "calc/project/warnings/open_shells.h"

#include "calc/meshes/mesh_shells.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace calc {
namespace {

constexpr std::size_t kLeastTriangles = 4;  // fewer have no place that they are all around
constexpr double kLeastSide_m = 0.05;       // no point is asked for in less

bool has_places_within(const MeshShell& shell) {
  const glm::dvec3 size_m = shell.bounds.upper - shell.bounds.lower;
  return shell.triangle.size() >= kLeastTriangles &&
         std::min({size_m.x, size_m.y, size_m.z}) >= kLeastSide_m;
}

// With its own corners alone.
Body part_of(const Body& body, const MeshShell& shell) {
  Body part;
  part.id = body.id;
  part.where = body.where;
  std::unordered_map<std::uint32_t, std::uint32_t> number;  // in the part, of a corner of the body
  for (const std::uint32_t t : shell.triangle) {
    glm::uvec3 corners = body.triangle[t];
    for (const glm::length_t k : {0, 1, 2}) {
      const auto [known, is_new] =
          number.try_emplace(corners[k], static_cast<std::uint32_t>(part.vertex_m.size()));
      if (is_new) part.vertex_m.push_back(body.vertex_m[corners[k]]);
      corners[k] = known->second;
    }
    part.triangle.push_back(corners);
  }
  return part;
}

}  // namespace

void find_open_shells(Space& space, std::size_t first) {
  for (std::size_t i = first; i < space.bodies.size(); ++i) {
    const Body& body = space.bodies[i];
    const bool is_open = !body.is_closed && !body.encloses_room && body.housing_of.empty();
    if (!is_open || body.triangle.size() < kLeastTriangles) continue;
    for (const MeshShell& shell : find_shells(body.vertex_m, body.triangle)) {
      if (has_places_within(shell)) space.open_shells.push_back(part_of(body, shell));
    }
  }
}

}  // namespace calc
