#pragma once
// Visibility, closest hits and distances in one prepared scene.

#include "calc/radiosity/sampling/identity.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/rays/sight.h"
#include "calc/rays/triangle_tree.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace calc {

// A point on a surface, local coordinates.
struct SurfaceHit {
  std::uint32_t triangle;
  glm::dvec3 position_m;  // from barycentric coordinates, not from origin + t * direction
  glm::dvec3 normal;      // unit, towards the side that the ray came from
};

struct FirstHit;

// A point, and the start of its rays; local coordinates.
struct ClosenessQuery {
  glm::dvec3 position_m, origin_m;
  glm::dvec3 normal;  // unit: only what reaches in front of the plane through the point; 0 = all
  double touching_m;  // a surface that reaches no farther in front of that plane lies in it
  double least_m;     // distance of `origin_m` from other surfaces that is enough
};
struct CloseSurface {
  std::uint32_t triangle;
  double distance_m;  // from the point
};

// The parts that a segment omits at its ends, in ray offsets. A point lifted off the surface it was
// found on is in front of it: nothing must be omitted there, or light would pass a partition that
// the point touches. A receiver may be in a surface that it does not look out of, and a luminaire
// in the ceiling.
struct SegmentMargins {
  float from = 1.0f, to = 1.0f;
};
inline constexpr SegmentMargins kReceiverToVertex{1.0f, 0.0f}, kHitToVertex{0.0f, 0.0f},
    kReceiverToSource{1.0f, 1.0f}, kHitToSource{0.0f, 1.0f};

// Up to 16 segments between lifted points, local coordinates.
struct SegmentPacket {
  static constexpr int kSize = 16;
  std::array<Ray, kSize> segment;  // from one end to the other at 1
  std::array<SegmentMargins, kSize> margins;
  int count = 0;

  bool is_full() const { return count == kSize; }
  // Returns its place. The packet must not be full.
  std::size_t add(const glm::vec3& from_m, const glm::vec3& to_m, SegmentMargins left_out = {}) {
    const auto k = static_cast<std::size_t>(count++);
    segment[k].origin = from_m;
    segment[k].direction = to_m - from_m;
    margins[k] = left_out;
    return k;
  }
};

// Up to 16 rays with unit directions.
struct RayPacket {
  static constexpr int kSize = 16;
  std::array<Ray, kSize> ray;
  int count = 0;

  bool is_full() const { return count == kSize; }
  // The packet must not be full.
  void add(const glm::dvec3& origin_m, const glm::dvec3& direction) {
    const auto k = static_cast<std::size_t>(count++);
    ray[k].origin = glm::vec3(origin_m);
    ray[k].direction = glm::vec3(direction);
  }
};
static_assert(SegmentPacket::kSize == TriangleTree::kRays &&
              RayPacket::kSize == TriangleTree::kRays);

// Ray queries on one prepared scene. Queries are const and may run on many threads at once. Answers
// are the same bits on every processor, see triangle_tree.h.
//
// Both ends of a segment are off surfaces by PreparedScene::ray_offset_m(): callers lift points
// along their normals; the query also omits the last stretch of that length at ends that may be in
// another surface, so that a point in the plane of a wall does not hit that wall.  [METHOD, 8.1]
class Tracer {
 public:
  explicit Tracer(const PreparedScene& scene);
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // Makes is_blocked() and shadow batches answer without a ray, because a proof (convex space)
  // shows that nothing is between any two points inside the surfaces.
  void leave_out_shadows() { has_shadows_ = false; }
  bool has_shadows() const { return has_shadows_; }

  // Returns the identity of this tracer and its scene, see new_identity().
  std::uint64_t identity() const { return identity_; }
  const PreparedScene& scene() const { return scene_; }
  double offset_m() const { return offset_m_; }
  // Returns the distance up to which a point is in a surface, see calc::touching_m().
  double touching_m() const { return calc::touching_m(offset_m_); }
  // Returns the unit normal by the order of corners.
  const glm::dvec3& triangle_normal(std::size_t triangle) const {
    return triangle_normal_[triangle];
  }

  // Returns a point moved off its surface along the unit normal.
  glm::dvec3 lift(const glm::dvec3& position_m, const glm::dvec3& normal) const {
    return position_m + lift_at(position_m, offset_m_) * normal;
  }

  // Returns the start of a receiver's rays: a plane's is off the surface that may contain it.
  glm::dvec3 lift(const Receiver& receiver) const {
    return has_back(receiver.kernel) ? lift(receiver.position_m, receiver.axis)
                                     : receiver.position_m;
  }

  // Finds the first surface from a lifted origin along a unit direction within max_distance_m;
  // returns false if there is none.
  bool closest_hit(const glm::dvec3& origin_m, const glm::dvec3& direction, double max_distance_m,
                   SurfaceHit& hit) const;

  // Finds the first surfaces of a packet from least_m to most_m: bit k of the result is set and
  // hit[k] valid if ray k meets one.
  std::uint32_t closest_hits(const RayPacket& packet, float least_m, float most_m,
                             std::array<SurfaceHit, RayPacket::kSize>& hit) const;

  // Returns the hit that a ShortRayCaster found: a + u (b - a) + v (c - a) for the corners a, b, c.
  SurfaceHit surface_hit(const FirstHit& first) const;
  SurfaceHit surface_hit(std::uint32_t triangle_and_side, double u, double v) const;

  // Calls visit(index, triangle) for every triangle that may be within radius_m of a place, in no
  // defined order.
  template <class Visit>
  void visit_near(const glm::dvec3& place_m, double radius_m, const Visit& visit) const {
    tree_.visit_near(place_m, radius_m, [&](std::uint32_t index) {
      visit(index, tree_.triangle(index));
      return radius_m;
    });
  }

  // Returns the distance from a point to the nearest surface that reaches in front of the plane
  // through it with this unit normal (0 = all around); most_m if there is none within. Never too
  // large.
  double clear_distance(const glm::dvec3& position_m, const glm::dvec3& normal,
                        double most_m) const;

  // Returns the nearest of the surfaces that do not contain the point but are too close to the
  // start of its rays.
  std::optional<CloseSurface> close_surface(const ClosenessQuery& query) const;

  // Returns whether any surface is between two lifted points.
  bool is_blocked(const glm::dvec3& from_m, const glm::dvec3& to_m,
                  SegmentMargins left_out = {}) const;

  // Return the parameters of sight(): SightQuery::margin_m and clear_m. Segments omit one offset at
  // their ends.
  double sight_margin_m() const { return touching_m(); }
  double sight_clear_m() const { return 2.0 * offset_m_; }

  // Returns what a receiver sees of a parallelogram, by proof, whatever has_shadows() is: a
  // receiver may be outside the convex space. from_m, corner_m: lifted, as the ends of segments
  // would be.
  Sight sight(const glm::dvec3& from_m, const std::array<glm::dvec3, 4>& corner_m) const;

  // Returns true if, by proof, all of one box sees all of the other. Both hold lifted places.
  bool is_free_between(const SightBox& one, const SightBox& other) const {
    return calc::is_free_between(tree_, one, other, touching_m());
  }

  // Returns a mask: bit k is set if segment k is blocked.
  std::uint32_t blocked(const SegmentPacket& packet) const;

 private:
  glm::dvec3 point_on(std::uint32_t triangle, double u, double v) const;
  SurfaceHit surface_hit(const TriangleHit& hit, const glm::dvec3& direction) const;

  const PreparedScene& scene_;
  std::uint64_t identity_ = new_identity();
  double offset_m_;
  bool has_shadows_ = true;
  std::vector<glm::dvec3> triangle_normal_;  // unit
  TriangleTree tree_;
};

// Flushes denormal numbers to zero on the current thread while it lives: they take a hundred times
// as long as others and are far below every rounding that matters.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

}  // namespace calc
