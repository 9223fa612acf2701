#pragma once
// Counts possible faults of a surface model, without tracing rays.

#include "calc/base/diagnostics.h"
#include "calc/meshes/mesh_shells.h"
#include "calc/meshes/triangle_mesh.h"
#include "calc/scene/project.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace calc {

// Triangles in metres, z up, each of an object and a material (indices into the names).
struct SurfaceModel {
  std::vector<glm::dvec3> vertex_m;
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint32_t> object_of, material_of;
  std::vector<std::string> object_name, material_name;
  std::size_t faces_left_out = 0;  // by the reader, because they had no area or could not be mended
  std::size_t polygons_mended = 0, polygons_left_out = 0;  // see polygon_mend.h
  double area_left_out_m2 = 0.0;                           // of the latter
};

// Returns the surface as <mesh> reads a file, without placing it.
SurfaceModel surface_of(const TriangleMesh& mesh, double metres_per_unit, bool y_is_up);
// Returns all bodies of a space, with a room's own surfaces.
SurfaceModel surface_of(const Project& project, const Space& space);

struct SurfacePart {
  std::string name;
  std::size_t triangles = 0;
  double area_m2 = 0.0;
};

struct SurfaceFindings {
  BoundingBox bounds_m;  // of finite vertices that a triangle uses
  std::size_t triangles = 0;
  double area_m2 = 0.0;
  std::vector<SurfacePart> objects, materials;  // in the order of the names
  // Corners at exactly the same position count as one, as for is_watertight().
  std::size_t edges = 0;
  std::size_t open_edges = 0;     // of one triangle only
  std::size_t crowded_edges = 0;  // of more than two
  std::size_t duplicates = 0;     // triangles that have the corners of an earlier one
  std::size_t degenerate = 0;     // without area, those left out by the reader included
  std::size_t left_out = 0;       // of them, by the reader, which said so
  std::size_t polygons_mended = 0, polygons_left_out = 0;  // as in the model
  double area_left_out_m2 = 0.0;
  std::size_t not_finite = 0;  // triangles with such a corner; counted nowhere else
  bool is_watertight = false;  // every edge has an even number of triangles
  // Shells of triangles with finite corners: those that are closed and have two sides, and edges
  // with an odd number of triangles.
  std::vector<MeshShell> closed;
  OpenEdges open;
  double float_step_m = 0.0;  // distance of neighbouring floats at the farthest coordinate
};
SurfaceFindings check_surface(const SurfaceModel& model);

// Warns about everything except what the reader has omitted and open edges, which furniture may
// have.
void warn_about_surface(const SurfaceFindings& findings, const SourceLocation& where,
                        Diagnostics& diagnostics);

}  // namespace calc
