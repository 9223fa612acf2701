#pragma once
// Decides at which points of a space light can be measured, and from where.

#include "calc/base/names.h"
#include "calc/scene/hollow_shells.h"
#include "calc/scene/near_triangles.h"
#include "calc/scene/project.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace calc {

enum class DropReason {
  outside_area,
  within_margin,
  outside_room,
  inside_solid,
  without_floor,  // of a route: nothing to walk on
  in_the_way,     // of a route: an obstacle is there
  in_surface      // what it would measure differs from one side of a surface to the other
};

template <>
struct EnumNames<DropReason> {
  static constexpr EnumName<DropReason> list[] = {
      {DropReason::outside_area, "outside-area"},   {DropReason::within_margin, "within-margin"},
      {DropReason::outside_room, "outside-room"},   {DropReason::inside_solid, "inside-solid"},
      {DropReason::without_floor, "without-floor"}, {DropReason::in_the_way, "in-the-way"},
      {DropReason::in_surface, "in-surface"}};
};

// A candidate: front is the side of a surface to which it belongs, see SensorGrid::front(); axis
// see SensorGrid::normal. Unit vectors, world coordinates.
struct CandidatePoint {
  glm::dvec3 position_m, front, axis;
};

// The decision about a candidate.
struct PointStand {
  std::optional<DropReason> dropped;
  // The shift to where it is measured: 0, or off the surface that contains it.
  glm::dvec3 shift_m{0.0};
  std::string body;  // that it lies in: of a drop, or of a shift along the plane; else ""
  // A body that is not closed and nearly encloses it (HollowSide::unclear): it counts as outside.
  std::string open_body{};
};

class PointFilter {
 public:
  // Serves candidates within the region. The space must outlive it.
  PointFilter(const Space& space, ReceiverKernel kernel, const BoundingBox& region);

  // Decides by these rules:
  // - Outside the room, whose surfaces count as inside, or inside a body that is closed, or that
  //   encloses it although it is not closed (hollow_shells.h): dropped.
  // - On a face of a closed body: dropped if `front` looks into the body.
  // - In surfaces that leave air on one side only (walls, corners of the room, sides of furniture):
  //   measured on that side, a few ray offsets off: the limit of measurements ever nearer to them.
  //   Dropped if there is air on several sides (in a screen), or room on none.
  PointStand stand(const CandidatePoint& candidate) const;

  // Returns whether the point is beside the room's walls, whatever its height.
  bool is_beside_room(const glm::dvec3& point) const;

 private:
  struct Solid {
    const Body* body;
    BoundingBox box;
  };

  void find_bounds();
  bool is_in_prism(const glm::dvec3& point) const;
  bool is_outside_room(const glm::dvec3& point) const;
  const Body* solid_around(const glm::dvec3& point) const;
  bool is_air(const glm::dvec3& point) const;
  bool looks_into(const Solid& solid, const CandidatePoint& candidate) const;
  PointStand stand_in_surface(const CandidatePoint& candidate) const;

  const Space& space_;
  ReceiverKernel kernel_;
  double offset_m_;
  NearTriangles near_;
  HollowShells hollow_;
  std::vector<Solid> solids_;
  std::optional<Solid> around_room_;        // of a room of a mesh that is closed
  std::optional<BoundingBox> room_bounds_;  // of one that is not: of all its surfaces
  bool outline_is_all_ = false;             // nothing of it lies beyond the outline of its floor
};

}  // namespace calc
