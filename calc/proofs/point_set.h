#pragma once
// The points of a plane for the proofs.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/receiver_kernel.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace calc {

// Points that receive light, local coordinates. Light from behind a planar receiver does not count;
// all other kernels see light from everywhere.
struct PointSet {
  std::span<const glm::dvec3> position_m;
  std::span<const glm::dvec3> normal;  // unit, as many
  ReceiverKernel kernel = ReceiverKernel::planar;

  bool has_back() const { return kernel == ReceiverKernel::planar; }
};

// Returns a grid's positions in the scene's local coordinates, for PointSet::position_m.
std::vector<glm::dvec3> local_positions_m(const PreparedScene& scene, const SensorGrid& grid);

// Points with the same normal: all of them have dot(normal, x) >= lowest_m.
struct NormalGroup {
  glm::dvec3 normal;
  double lowest_m;
};

// Bounds of a point set: everything the proofs need, in O(points).
struct PointBounds {
  std::array<glm::dvec3, 8> corner_m;  // of a box about all points, upright on the first normal
  // Empty: too many different normals, or a kernel without back: nothing is behind the points.
  std::vector<NormalGroup> groups;
  double reach_m = 0.0;  // largest distance of a corner from the local origin
};
inline constexpr std::size_t kMostNormalGroups = 64;

// Returns the bounds of at least one point.
PointBounds bounds_of(const PointSet& points);

// Returns the corners of the box between two opposite ones.
std::array<glm::dvec3, 8> box_corners(const glm::dvec3& low, const glm::dvec3& high);

}  // namespace calc
