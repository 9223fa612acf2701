#include "calc/scene/point_filter.h"

#include "calc/scene/polygon.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/surface_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace calc {
namespace {

constexpr double kInFront_m = 1.0e-4;
constexpr double kOfHeight = 1.0e-9;  // of a room: what is so near to its floor is on it

}  // namespace

PointFilter::PointFilter(const Space& space, ReceiverKernel kernel, const BoundingBox& region)
    : space_(space),
      kernel_(kernel),
      offset_m_(scale_of(space).ray_offset_m()),
      near_(space, region, kContactReach * offset_m_),
      hollow_(space, {region.lower - kInFront_m, region.upper + kInFront_m}) {
  for (const Body& body : space.bodies) {
    const bool has_inside = body.is_closed || body.encloses_room;
    if (!has_inside) continue;
    const Solid solid{&body, bounding_box(body.vertex_m)};
    if (body.encloses_room) {
      around_room_ = solid;
    } else {
      solids_.push_back(solid);
    }
  }
  if (space.is_from_mesh && !around_room_) find_bounds();
}

// Inside and outside of a shell with gaps are not told apart, but beyond all of it is outside.
void PointFilter::find_bounds() {
  const std::string shell = space_.id + ".shell";
  for (const Body& body : space_.bodies) {
    if (body.id == shell) room_bounds_ = bounding_box(body.vertex_m);
  }
  if (!room_bounds_ || space_.outline_m.empty()) return;
  constexpr double kSame_m = 1.0e-3;
  outline_is_all_ = true;
  for (const glm::length_t axis : {0, 1}) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const glm::dvec2& corner : space_.outline_m) {
      low = std::min(low, corner[axis]);
      high = std::max(high, corner[axis]);
    }
    outline_is_all_ = outline_is_all_ && low <= room_bounds_->lower[axis] + kSame_m &&
                      high >= room_bounds_->upper[axis] - kSame_m;
  }
}

PointStand PointFilter::stand(const CandidatePoint& candidate) const {
  PointStand result;
  if (is_outside_room(candidate.position_m)) {
    result.dropped = DropReason::outside_room;
    return result;
  }
  for (const Solid& solid : solids_) {
    if (!looks_into(solid, candidate)) continue;
    result.dropped = DropReason::inside_solid;
    result.body = solid.body->id;
    return result;
  }
  // In front: on a face the side there decides, as of closed bodies.
  const HollowPlace hollow = hollow_.around(candidate.position_m + kInFront_m * candidate.front,
                                            [&](const glm::dvec3& place) { return is_air(place); });
  if (hollow.side == HollowSide::inside) {
    result.dropped = DropReason::inside_solid;
    result.body = hollow.shell->id;
    return result;
  }
  result = stand_in_surface(candidate);
  if (hollow.side == HollowSide::unclear) result.open_body = hollow.shell->id;
  return result;
}

bool PointFilter::is_beside_room(const glm::dvec3& point) const {
  return space_.shell && !contains_point(space_.shell->footprint_m, glm::dvec2(point));
}

// Floor, walls and ceiling themselves count as inside.
bool PointFilter::is_outside_room(const glm::dvec3& point) const {
  if (space_.shell) return !is_in_prism(point);
  if (room_bounds_) {
    if (!room_bounds_->contains(point)) return true;
    return outline_is_all_ && !contains_point(space_.outline_m, glm::dvec2(point)) &&
           distance_to_boundary(space_.outline_m, glm::dvec2(point)) > offset_m_;
  }
  return around_room_ &&
         locate_point(*around_room_->body, around_room_->box, point) == SolidSide::outside;
}

bool PointFilter::is_in_prism(const glm::dvec3& point) const {
  const RoomShell& shell = *space_.shell;
  const double ceiling_z_m = shell.floor_z_m + shell.height_m;
  const double highest_m = std::max(std::abs(shell.floor_z_m), std::abs(ceiling_z_m));
  const double gap_m =
      kOfHeight * shell.height_m + 4.0 * std::numeric_limits<double>::epsilon() * highest_m;
  return point.z >= shell.floor_z_m - gap_m && point.z <= ceiling_z_m + gap_m &&
         contains_point(shell.footprint_m, glm::dvec2(point.x, point.y));
}

// On a face, the side in front decides: a plane on a desk top stays, one that looks into the desk
// does not.
bool PointFilter::looks_into(const Solid& solid, const CandidatePoint& candidate) const {
  constexpr double kStep = 1.0e-6;  // of the solid's size; well above the surface tolerance
  const SolidSide side = locate_point(*solid.body, solid.box, candidate.position_m);
  if (side != SolidSide::on_surface) return side == SolidSide::inside;
  const glm::dvec3 in_front = candidate.position_m + kStep * solid.box.diagonal() * candidate.front;
  return locate_point(*solid.body, solid.box, in_front) == SolidSide::inside;
}

const Body* PointFilter::solid_around(const glm::dvec3& point) const {
  const auto found = std::find_if(solids_.begin(), solids_.end(), [&](const Solid& solid) {
    return locate_point(*solid.body, solid.box, point) == SolidSide::inside;
  });
  return found == solids_.end() ? nullptr : found->body;
}

bool PointFilter::is_air(const glm::dvec3& point) const {
  if (is_outside_room(point)) return false;
  // Of a room of a building file; a closed shell knows better.
  if (!around_room_ && !space_.outline_m.empty() &&
      !contains_point(space_.outline_m, glm::dvec2(point))) {
    return false;
  }
  return solid_around(point) == nullptr;
}

PointStand PointFilter::stand_in_surface(const CandidatePoint& candidate) const {
  const bool is_plane = kernel_ == ReceiverKernel::planar;
  const SurfaceContact contact = surface_contact(
      near_, candidate.position_m, is_plane ? candidate.axis : candidate.front, kernel_, offset_m_);
  PointStand result;
  if (contact.body == nullptr) return result;
  const glm::dvec3 begin_m =
      candidate.position_m + (is_plane ? offset_m_ * candidate.axis : glm::dvec3(0.0));
  const SurfaceContact::Side* side = nullptr;
  std::size_t sides = 0;
  for (const SurfaceContact::Side& one : contact.sides) {
    if (!is_air(begin_m + one.shift_m)) continue;
    side = &one;
    ++sides;
  }
  const bool is_clear = sides == 1 && side->has_room;
  if (is_clear) result.shift_m = side->shift_m;
  if (!is_clear) result.dropped = DropReason::in_surface;
  // On a surface, looking away from it, is where points are meant to be.
  const bool is_on_it = is_clear && glm::cross(side->shift_m, candidate.front) == glm::dvec3(0.0);
  if (!is_on_it) result.body = contact.body->id;
  return result;
}

}  // namespace calc
