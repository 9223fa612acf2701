#include "calc/meshes/mesh_check.h"

#include "calc/base/diagnostic_ids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace calc {
namespace {

constexpr double kLargestModel_m = 300.0;  // a large building; beyond it the unit is in doubt
constexpr double kSmallestModel_m = 0.1;
constexpr double kFloatStepLimit_m = 2.0e-4;

bool is_finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using FaceCorners = std::array<std::uint32_t, 3>;

// Calls visit(length) for each run of equal elements of a sorted list.
template <class T, class Visit>
void for_each_run(const std::vector<T>& sorted, Visit visit) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    while (end < sorted.size() && sorted[end] == sorted[begin]) ++end;
    visit(end - begin);
    begin = end;
  }
}

void count_edges(std::vector<Edge> edges, SurfaceFindings& findings) {
  std::sort(edges.begin(), edges.end());
  findings.is_watertight = !edges.empty();
  for_each_run(edges, [&](std::size_t triangles) {
    ++findings.edges;
    if (triangles == 1) ++findings.open_edges;
    if (triangles > 2) ++findings.crowded_edges;
    if (triangles % 2 != 0) findings.is_watertight = false;
  });
}

void count_duplicates(std::vector<FaceCorners> faces, SurfaceFindings& findings) {
  std::sort(faces.begin(), faces.end());
  for_each_run(faces, [&](std::size_t copies) { findings.duplicates += copies - 1; });
}

void measure_floats(SurfaceFindings& findings) {
  if (findings.bounds_m.is_empty()) return;
  double farthest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::abs(findings.bounds_m.lower[axis]),
                         std::abs(findings.bounds_m.upper[axis])});
  }
  findings.float_step_m = farthest * static_cast<double>(std::numeric_limits<float>::epsilon());
}

}  // namespace

SurfaceModel surface_of(const TriangleMesh& mesh, double metres_per_unit, bool y_is_up) {
  SurfaceModel model;
  for (const glm::dvec3& v : mesh.vertex) {
    model.vertex_m.push_back((y_is_up ? glm::dvec3(v.x, -v.z, v.y) : v) * metres_per_unit);
  }
  model.triangle = mesh.triangle;
  model.object_of = mesh.object_of;
  model.material_of = mesh.material_of;
  model.object_name = mesh.object_name;
  model.material_name = mesh.material_name;
  model.faces_left_out = model.polygons_left_out = mesh.faces_left_out;
  model.polygons_mended = mesh.faces_mended;
  model.area_left_out_m2 = mesh.area_left_out * metres_per_unit * metres_per_unit;
  return model;
}

SurfaceModel surface_of(const Project& project, const Space& space) {
  SurfaceModel model;
  for (const Material& material : project.materials) model.material_name.push_back(material.id);
  for (const Body& body : space.bodies) {
    const auto first = static_cast<std::uint32_t>(model.vertex_m.size());
    const auto object = static_cast<std::uint32_t>(model.object_name.size());
    model.object_name.push_back(body.id);
    model.vertex_m.insert(model.vertex_m.end(), body.vertex_m.begin(), body.vertex_m.end());
    for (const glm::uvec3& triangle : body.triangle) model.triangle.push_back(triangle + first);
    model.object_of.resize(model.triangle.size(), object);
    model.material_of.insert(model.material_of.end(), body.material_of.begin(),
                             body.material_of.end());
  }
  return model;
}

SurfaceFindings check_surface(const SurfaceModel& model) {
  SurfaceFindings findings;
  for (const std::string& name : model.object_name) findings.objects.push_back({name, 0, 0.0});
  for (const std::string& name : model.material_name) findings.materials.push_back({name, 0, 0.0});
  findings.triangles = model.triangle.size();
  findings.degenerate = findings.left_out = model.faces_left_out;
  findings.polygons_mended = model.polygons_mended;
  findings.polygons_left_out = model.polygons_left_out;
  findings.area_left_out_m2 = model.area_left_out_m2;
  const std::vector<std::uint32_t> welded = weld_vertices(model.vertex_m);
  std::vector<Edge> edges;
  std::vector<FaceCorners> faces;
  std::vector<glm::uvec3> finite;
  edges.reserve(3 * model.triangle.size());
  faces.reserve(model.triangle.size());
  for (std::size_t i = 0; i < model.triangle.size(); ++i) {
    const glm::uvec3& t = model.triangle[i];
    const std::array corner{model.vertex_m[t.x], model.vertex_m[t.y], model.vertex_m[t.z]};
    SurfacePart& object = findings.objects[model.object_of[i]];
    SurfacePart& material = findings.materials[model.material_of[i]];
    ++object.triangles;
    ++material.triangles;
    if (!std::all_of(corner.begin(), corner.end(), is_finite)) {
      ++findings.not_finite;
      continue;
    }
    for (const glm::dvec3& p : corner) findings.bounds_m.add(p);
    finite.push_back(t);
    const double area = 0.5 * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
    if (!(area > 0.0)) ++findings.degenerate;
    findings.area_m2 += area;
    object.area_m2 += area;
    material.area_m2 += area;
    FaceCorners face{welded[t.x], welded[t.y], welded[t.z]};
    std::sort(face.begin(), face.end());
    if (face[0] == face[1] || face[1] == face[2]) continue;
    faces.push_back(face);
    edges.insert(edges.end(), {{face[0], face[1]}, {face[0], face[2]}, {face[1], face[2]}});
  }
  count_edges(std::move(edges), findings);
  for (MeshShell& shell : find_shells(model.vertex_m, finite)) {
    if (shell.is_closed && shell.faces != FacesLook::unclear) {
      findings.closed.push_back(std::move(shell));
    }
  }
  findings.open = open_edges(model.vertex_m, finite);
  count_duplicates(std::move(faces), findings);
  measure_floats(findings);
  return findings;
}

void warn_about_surface(const SurfaceFindings& findings, const SourceLocation& where,
                        Diagnostics& diagnostics) {
  const auto report = [&](DiagnosticId id, const auto&... args) {
    diagnostics.report(id, where, args...);
  };
  if (findings.not_finite > 0) report(DiagnosticId::surface_not_finite, findings.not_finite);
  const std::size_t degenerate = findings.degenerate - findings.left_out;
  if (degenerate > 0) report(DiagnosticId::surface_degenerate, degenerate);
  if (findings.duplicates > 0) report(DiagnosticId::surface_duplicates, findings.duplicates);
  if (findings.crowded_edges > 0) {
    report(DiagnosticId::surface_crowded_edges, findings.crowded_edges, findings.edges);
  }
  if (findings.bounds_m.is_empty()) return;
  const glm::dvec3 size = findings.bounds_m.upper - findings.bounds_m.lower;
  const double largest = std::max({size.x, size.y, size.z});
  if (largest > kLargestModel_m) report(DiagnosticId::surface_too_large, largest, largest * 1e-3);
  if (largest < kSmallestModel_m) report(DiagnosticId::surface_too_small, largest, largest * 1e3);
  if (findings.float_step_m > kFloatStepLimit_m) {
    report(DiagnosticId::surface_far_away, findings.float_step_m * 1e3);
  }
}

}  // namespace calc
