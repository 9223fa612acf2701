#include "calc/meshes/mesh_builder.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr double kMaxCornerPairs = 2.0e9;  // of all faces together: about two minutes

}  // namespace

std::uint32_t NameList::index_of(std::string_view name) {
  if (const auto found = index_.find(name); found != index_.end()) return found->second;
  const auto index = static_cast<std::uint32_t>(names_.size());
  names_.emplace_back(name);
  index_.emplace(name, index);
  return index;
}

MeshBuilder::MeshBuilder(MeshFormat format, std::string name, Diagnostics& diagnostics)
    : name_(std::move(name)), diagnostics_(diagnostics) {
  mesh_.format = format;
}

void MeshBuilder::set_material(std::string_view name) {
  if (name == material_) return;
  material_ = name;
  material_index_.reset();
}

void MeshBuilder::set_object(std::string_view name) {
  if (name == object_) return;
  object_ = name;
  object_index_.reset();
}

bool MeshBuilder::has_room_for_vertices(std::size_t count) {
  if (count <= kMaxMeshVertices - mesh_.vertex.size()) return true;
  diagnostics_.report(DiagnosticId::mesh_too_large, {name_, 0, 0}, "vertices", kMaxMeshVertices);
  return false;
}

bool MeshBuilder::add_vertex(const glm::dvec3& position, const std::function<std::string()>& what) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(position[axis]) <= kMaxMeshCoordinate) continue;  // false for nan
    diagnostics_.report(DiagnosticId::mesh_not_finite, {name_, 0, 0}, what(), position.x,
                        position.y, position.z, kMaxMeshCoordinate);
    return false;
  }
  if (mesh_.vertex.size() >= kMaxMeshVertices) return has_room_for_vertices(1);
  mesh_.vertex.push_back(position);
  return true;
}

bool MeshBuilder::add_face(std::span<const std::uint32_t> corner, int line) {
  ++mesh_.faces;
  if (!is_small_enough(corner.size(), line)) return false;
  double area = 0.0;
  // Triangles in the end are kept however thin they are.
  const std::vector<std::uint32_t> distinct = distinct_corners(corner);
  if (distinct.size() == 3) {
    if (split_triangle(distinct, line)) note_doubled(corner, distinct, line);
  } else if (corner.size() < 3 || !split_polygon(corner, line, area)) {
    leave_out(area, line);
  }
  if (mesh_.triangle.size() <= kMaxMeshTriangles) return true;
  diagnostics_.report(DiagnosticId::mesh_too_large, {name_, line, 0}, "triangles",
                      kMaxMeshTriangles);
  return false;
}

bool MeshBuilder::is_small_enough(std::size_t corners, int line) {
  if (corners > kMaxFaceCorners) {
    diagnostics_.report(DiagnosticId::mesh_face_too_large, {name_, line, 0}, mesh_.faces, corners,
                        kMaxFaceCorners);
    return false;
  }
  corner_pairs_ += static_cast<double>(corners) * static_cast<double>(corners);
  if (corner_pairs_ <= kMaxCornerPairs) return true;
  diagnostics_.report(DiagnosticId::mesh_too_complex, {name_, line, 0}, mesh_.faces);
  return false;
}

// Without corners that repeat the one before them.
std::vector<std::uint32_t> MeshBuilder::distinct_corners(
    std::span<const std::uint32_t> corner) const {
  std::vector<std::uint32_t> corners;
  corners.reserve(corner.size());
  for (const std::uint32_t c : corner) {
    if (corners.empty() || mesh_.vertex[corners.back()] != mesh_.vertex[c]) corners.push_back(c);
  }
  while (corners.size() > 1 && mesh_.vertex[corners.back()] == mesh_.vertex[corners.front()]) {
    corners.pop_back();
  }
  return corners;
}

bool MeshBuilder::split_triangle(const std::vector<std::uint32_t>& corner, int line) {
  const glm::dvec3& a = mesh_.vertex[corner[0]];
  if (glm::cross(mesh_.vertex[corner[1]] - a, mesh_.vertex[corner[2]] - a) == glm::dvec3(0.0)) {
    leave_out(0.0, line);
    return false;
  }
  add_triangle({corner[0], corner[1], corner[2]});
  return true;
}

void MeshBuilder::note_doubled(std::span<const std::uint32_t> corner,
                               const std::vector<std::uint32_t>& distinct, int line) {
  if (corner.size() == distinct.size()) return;
  Mending mending;
  mending.doubled = corner.size() - distinct.size();
  mending.at = mesh_.vertex[distinct[0]];
  note(mending, line);
}

void MeshBuilder::note(const Mending& mending, int line) {
  if (!mending.is_any()) return;
  ++mesh_.faces_mended;
  if (mesh_.faces_mended == 1 || mending.longest > mending_.longest) {
    longest_mended_ = {mesh_.faces, line};
  }
  mending_.add(mending);
}

// area: what is missing if it cannot be split.
bool MeshBuilder::split_polygon(std::span<const std::uint32_t> corner, int line, double& area) {
  std::vector<glm::dvec3> positions;
  positions.reserve(corner.size());
  for (const std::uint32_t c : corner) positions.push_back(mesh_.vertex[c]);
  const std::optional<MendedPolygon> mended = mend_polygon(positions);
  if (!mended) {
    area = enclosed_area(positions);
    return false;
  }
  note(mended->mending, line);
  if (mended->deviation > kPlanarTolerance) {
    ++bent_;
    if (mended->deviation > worst_deviation_) worst_ = {mesh_.faces, line};
    worst_deviation_ = std::max(worst_deviation_, mended->deviation);
  }
  for (const glm::uvec3& t : mended->triangle) {
    add_triangle({corner[t.x], corner[t.y], corner[t.z]});
  }
  return true;
}

void MeshBuilder::add_triangle(const glm::uvec3& triangle) {
  if (!material_index_) material_index_ = materials_.index_of(material_);
  if (!object_index_) object_index_ = objects_.index_of(object_);
  mesh_.triangle.push_back(triangle);
  mesh_.material_of.push_back(*material_index_);
  mesh_.object_of.push_back(*object_index_);
}

void MeshBuilder::leave_out(double area, int line) {
  if (mesh_.faces_left_out == 0) first_left_out_ = largest_left_out_ = {mesh_.faces, line};
  ++mesh_.faces_left_out;
  mesh_.area_left_out += area;
  if (area <= largest_area_left_out_) return;
  largest_area_left_out_ = area;
  largest_left_out_ = {mesh_.faces, line};
}

std::string MeshBuilder::missing_area() const {
  if (!(mesh_.area_left_out > 0.0)) return "";
  return fmt::format(
      "; an area of {:.4g} (in the file's unit, squared) is missing, {:.4g} of it of face {}",
      mesh_.area_left_out, largest_area_left_out_, largest_left_out_.face);
}

void MeshBuilder::warn() const {
  if (mesh_.faces_mended > 0) {
    diagnostics_.report(DiagnosticId::mesh_mended_faces, {name_, longest_mended_.line, 0},
                        mesh_.faces_mended, mesh_.faces, mending_.words(), mending_.longest,
                        mending_.at.x, mending_.at.y, mending_.at.z, longest_mended_.face);
  }
  if (bent_ > 0) {
    diagnostics_.report(DiagnosticId::mesh_bent_faces, {name_, worst_.line, 0}, bent_, mesh_.faces,
                        worst_.face, worst_deviation_);
  }
  if (mesh_.faces_left_out > 0) {
    diagnostics_.report(DiagnosticId::mesh_faces_left_out, {name_, first_left_out_.line, 0},
                        mesh_.faces_left_out, mesh_.faces, first_left_out_.face, missing_area());
  }
}

std::optional<TriangleMesh> MeshBuilder::finish() {
  if (mesh_.triangle.empty()) {
    diagnostics_.report(DiagnosticId::mesh_without_faces, {name_, 0, 0}, mesh_.vertex.size(),
                        mesh_.faces);
    return std::nullopt;
  }
  warn();
  mesh_.material_name = materials_.names();
  mesh_.object_name = objects_.names();
  return std::move(mesh_);
}

}  // namespace calc
