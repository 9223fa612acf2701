#include "calc/project/spaces/room_plan.h"

#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

namespace calc {
namespace {

Body make_body(std::string id, std::vector<glm::dvec3> vertex_m, std::vector<glm::uvec3> triangle,
               std::uint32_t material, const SourceLocation& where) {
  Body body;
  body.id = std::move(id);
  body.vertex_m = std::move(vertex_m);
  body.material_of.assign(triangle.size(), material);
  body.triangle = std::move(triangle);
  body.where = where;
  return body;
}

std::vector<glm::dvec3> lifted(const std::vector<glm::dvec2>& outline, const glm::dvec3& origin) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& corner : outline) points.push_back(origin + glm::dvec3(corner, 0.0));
  return points;
}

}  // namespace

std::vector<glm::dvec2> RoomPlan::outline() const {
  std::vector<glm::dvec2> outline = corners_m;
  if (is_clockwise) std::reverse(outline.begin(), outline.end());
  return outline;
}

RoomShell RoomPlan::shell() const {
  RoomShell shell{outline(), origin_m.z, height_m};
  for (glm::dvec2& corner : shell.footprint_m) corner += glm::dvec2(origin_m);
  return shell;
}

Rectangle RoomPlan::wall(std::size_t index) const {
  glm::dvec2 from = corners_m[index];
  glm::dvec2 to = corners_m[(index + 1) % corners_m.size()];
  if (is_clockwise) std::swap(from, to);
  // The inside is on the left of from -> to; u runs to the right as seen from there.
  return {origin_m + glm::dvec3(to, 0.0), glm::dvec3(from - to, 0.0), {0, 0, height_m}};
}

std::vector<Body> make_shell_bodies(const RoomPlan& plan, const ShellMaterials& materials,
                                    const std::string& room_id, const SourceLocation& where) {
  const std::vector<glm::dvec2> outline = plan.outline();
  const std::optional<std::vector<glm::uvec3>> up = triangulate_polygon(outline);
  if (!up) throw std::logic_error("make_shell_bodies: the footprint is not a simple polygon");
  std::vector<glm::uvec3> down = *up;
  for (glm::uvec3& triangle : down) std::swap(triangle.y, triangle.z);

  const glm::dvec3 ceiling_origin = plan.origin_m + glm::dvec3(0, 0, plan.height_m);
  std::vector<Body> bodies;
  bodies.push_back(
      make_body(room_id + ".floor", lifted(outline, plan.origin_m), *up, materials.floor, where));
  bodies.push_back(make_body(room_id + ".ceiling", lifted(outline, ceiling_origin), std::move(down),
                             materials.ceiling, where));
  for (std::size_t i = 0; i < plan.corners_m.size(); ++i) {
    const auto [origin, u, v] = plan.wall(i);
    bodies.push_back(make_body(fmt::format("{}.wall{}", room_id, i + 1),
                               {origin, origin + u, origin + u + v, origin + v},
                               {{0, 1, 2}, {0, 2, 3}}, materials.walls[i], where));
  }
  return bodies;
}

}  // namespace calc
