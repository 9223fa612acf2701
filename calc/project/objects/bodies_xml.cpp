#include "calc/project/objects/bodies_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/objects/frame.h"
#include "calc/project/objects/luminous_surface.h"
#include "calc/project/objects/mesh_attributes.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_mend.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace calc {
namespace {

constexpr double kParallelSidesSine = 1.0e-9;

ObjectSet set_of(Body body) {
  ObjectSet set;
  set.add_body(std::move(body));
  return set;
}

Body single_material_body(std::vector<glm::dvec3> vertex_m, std::vector<glm::uvec3> triangle,
                          std::uint32_t material, const SourceLocation& where) {
  Body body;
  body.vertex_m = std::move(vertex_m);
  body.material_of.assign(triangle.size(), material);
  body.triangle = std::move(triangle);
  body.where = where;
  return body;
}

// Corner i of the unit cube: x, y, z are the bits of i. Triangles wind counter-clockwise seen from
// outside.
const std::vector<glm::uvec3>& box_triangles() {
  static const std::vector<glm::uvec3> kTriangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                                  {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                  {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return kTriangles;
}

}  // namespace

ObjectSet read_box(ProjectContext& context, ElementReader& reader) {
  reader.allow(kBoxElement);
  const glm::dvec3 size = read_size_m(context, reader, "size");
  const Placement placement{rotation_about_z(read_angle_rad(reader, "rotation")),
                            read_point_m_or_zero(context, reader, "position")};
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  std::vector<glm::dvec3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 unit(i & 1u, (i >> 1u) & 1u, (i >> 2u) & 1u);
    corners.push_back(placement.apply(unit * size));
  }
  ObjectSet set =
      set_of(single_material_body(std::move(corners), box_triangles(), material, reader.where()));
  set.bodies[0].is_closed = true;
  set.box_tops[""] = {placement.apply({0, 0, size.z}), placement.turn * glm::dvec3(size.x, 0, 0),
                      placement.turn * glm::dvec3(0, size.y, 0)};
  return set;
}

ObjectSet read_quad(ProjectContext& context, ElementReader& reader) {
  reader.allow(kQuadElement);
  const glm::dvec3 origin = read_point_m(context, reader, "origin");
  const glm::dvec3 u = read_point_m(context, reader, "u");
  const glm::dvec3 v = read_point_m(context, reader, "v");
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  if (!(glm::length(glm::cross(u, v)) > kParallelSidesSine * glm::length(u) * glm::length(v))) {
    reader.report(DiagnosticId::parallel_vectors, reader.where("u"), "u", "v", "quad");
    return {};
  }
  ObjectSet set = set_of(single_material_body({origin, origin + u, origin + u + v, origin + v},
                                              {{0, 1, 2}, {0, 2, 3}}, material, reader.where()));
  add_luminous_surface(context, reader, {origin, u, v}, set);
  return set;
}

ObjectSet read_polygon(ProjectContext& context, ElementReader& reader) {
  reader.allow(kPolygonElement);
  std::vector<glm::dvec3> corners = read_corners_m(context, reader, "points");
  const std::uint32_t material = read_material(context, reader);
  if (!reader.ok()) return {};
  std::optional<MendedPolygon> mended = mend_polygon(corners);
  if (!mended || mended->deviation > kNearlyPlanar) {
    reader.report(DiagnosticId::not_simple_polygon, reader.where("points"), "points", "polygon",
                  "lie in one plane and ");
    return {};
  }
  warn_of_mending(reader, "points", mended->mending, "");
  if (mended->deviation > kPlanarTolerance) {
    reader.report(DiagnosticId::outline_bent, reader.where("points"), "points", "polygon",
                  mended->deviation);
  }
  drop_unused_corners(corners, mended->triangle);
  return set_of(single_material_body(std::move(corners), std::move(mended->triangle), material,
                                     reader.where()));
}

ObjectSet read_mesh(ProjectContext& context, ElementReader& reader) {
  reader.allow(kMeshElement);
  std::optional<PlacedMesh> placed = read_placed_mesh(context, reader);
  if (!placed) return {};
  Body body;
  body.where = reader.where();
  body.vertex_m = std::move(placed->vertex_m);
  body.triangle = placed->mesh->triangle;
  body.material_of = std::move(placed->material);
  body.is_closed = is_watertight(body);
  return set_of(std::move(body));
}

}  // namespace calc
