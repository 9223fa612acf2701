#pragma once
// Visibility and closest hits. rays.cpp is the only file that knows Embree.

#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace calc {

// A point on a surface, local coordinates.
struct SurfaceHit {
  std::uint32_t triangle;
  glm::dvec3 position_m;  // from barycentric coordinates, not from origin + t * direction
  glm::dvec3 normal;      // unit, towards the side that the ray came from
};

// Up to 16 segments from one common point, as arrays for a ray packet.
struct SegmentPacket {
  static constexpr int kSize = 16;
  std::array<float, kSize> to_x, to_y, to_z;  // lifted end points, local
  int count = 0;
};

// Ray queries on one prepared scene. Queries are const and may run on many threads at once.
//
// Both ends of a segment stand off surfaces by PreparedScene::ray_offset_m(): callers lift points
// along their normals; the query leaves out the last stretch of that length at either end as well,
// so that a point in the plane of a wall does not hit the wall it lies in.  [method 02, section 7]
class Tracer {
 public:
  explicit Tracer(const PreparedScene& scene);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  const PreparedScene& scene() const { return scene_; }
  double offset_m() const { return offset_m_; }

  // A point moved off its surface along the unit normal.
  glm::dvec3 lift(const glm::dvec3& position_m, const glm::dvec3& normal) const {
    return position_m + offset_m_ * normal;
  }

  // First surface from a lifted origin along a unit direction within max_distance_m; false if there
  // is none.
  bool closest_hit(const glm::dvec3& origin_m, const glm::dvec3& direction, double max_distance_m,
                   SurfaceHit& hit) const;

  // Whether any surface stands between two lifted points.
  bool is_blocked(const glm::dvec3& from_m, const glm::dvec3& to_m) const;

  // Bit k is set if segment k is blocked.
  std::uint32_t blocked(const glm::vec3& from_m, const SegmentPacket& packet) const;

 private:
  struct Embree;
  const PreparedScene& scene_;
  double offset_m_;
  std::unique_ptr<Embree> embree_;
};

// Denormal numbers are flushed to zero while it lives, as Embree asks for, on the current thread.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

// "Embree 3.13.5"
std::string tracer_version();

}  // namespace calc
