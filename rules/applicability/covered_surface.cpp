#include "rules/applicability/covered_surface.h"

#include "calc/project/spaces/plane_area.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_cut.h"
#include "calc/scene/route_shape.h"
#include "rules/applicability/place_in_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace rules {
namespace {

constexpr int kPlacesPerSide = 64;
constexpr double kSameEdge_m = 1e-6;
constexpr double kParallel = 0.966;  // cosine, 15 degrees

struct FlatBounds {
  glm::dvec2 low{0.0}, high{0.0};
};

FlatBounds bounds_of(const std::vector<glm::dvec2>& outline_m) {
  FlatBounds bounds{outline_m.front(), outline_m.front()};
  for (const glm::dvec2& corner : outline_m) {
    bounds.low = glm::min(bounds.low, corner);
    bounds.high = glm::max(bounds.high, corner);
  }
  return bounds;
}

// Returns whether the place is inside the outline, off the strip along it.
bool is_inside(const std::vector<glm::dvec2>& outline_m, const glm::dvec2& place, double strip_m) {
  if (!calc::contains_point(outline_m, place)) return false;
  return !(strip_m > 0.0) || calc::distance_to_boundary(outline_m, place) >= strip_m - kSameEdge_m;
}

// Cell centres of the surface without its strip, in its own axes.
struct SurfacePlaces {
  std::vector<glm::dvec2> place_m;
  double cell_m2 = 0.0;
};

SurfacePlaces places_on(const RoomSurface& surface, double strip_m) {
  SurfacePlaces places;
  const FlatBounds bounds = bounds_of(surface.outline_m);
  const glm::dvec2 low = bounds.low + strip_m, size_m = bounds.high - strip_m - low;
  if (!(size_m.x > kSameEdge_m && size_m.y > kSameEdge_m)) return places;
  const glm::dvec2 cell_m = size_m / static_cast<double>(kPlacesPerSide);
  places.cell_m2 = cell_m.x * cell_m.y;
  for (int row = 0; row < kPlacesPerSide; ++row) {
    for (int column = 0; column < kPlacesPerSide; ++column) {
      const glm::dvec2 place = low + cell_m * glm::dvec2(column + 0.5, row + 0.5);
      if (is_inside(surface.outline_m, place, strip_m)) places.place_m.push_back(place);
    }
  }
  return places;
}

// Returns whether the area can lie on the surface: parallel to it, and not all of it before or
// behind it.
bool is_near(const calc::PlanarArea& area, const RoomSurface& surface) {
  const glm::dvec3 face = glm::cross(surface.u, surface.v);
  if (std::abs(glm::dot(face, area.normal())) < kParallel) return false;
  double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
  for (const glm::dvec2& corner : area.outline_m) {
    const glm::dvec3 place = area.origin_m + corner.x * area.u + corner.y * area.v;
    const double off_m = glm::dot(place - surface.origin_m, face);
    least_m = std::min(least_m, off_m);
    most_m = std::max(most_m, off_m);
  }
  constexpr double kFar_m = 2.0 * kLift_m;
  return least_m <= kFar_m && most_m >= -kFar_m;
}

class AreaOnSurface {
 public:
  AreaOnSurface(const calc::PlanarArea& area, const RoomSurface& surface)
      : area_(area), surface_(surface) {}

  // Returns whether a place of the surface is in the area, without a strip along its outline.
  bool covers(const glm::dvec2& place, double own_strip_m) const {
    const glm::dvec3 offset_m =
        surface_.origin_m + place.x * surface_.u + place.y * surface_.v - area_.origin_m;
    if (std::abs(glm::dot(offset_m, area_.normal())) > kLift_m + kSameEdge_m) return false;
    const glm::dvec2 flat(glm::dot(offset_m, area_.u), glm::dot(offset_m, area_.v));
    return is_inside(area_.outline_m, flat, own_strip_m) &&
           std::none_of(area_.holes_m.begin(), area_.holes_m.end(),
                        [&](const auto& hole) { return calc::contains_point(hole, flat); });
  }

  // Returns whether an area too small for the surface's grid of places lies on it, by the area's
  // own places, off its corners, which may touch the next surface.
  bool has_place_on_surface() const {
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& corner : area_.outline_m) middle += corner;
    middle /= static_cast<double>(area_.outline_m.size());
    return std::any_of(area_.outline_m.begin(), area_.outline_m.end(), [&](const auto& corner) {
      const glm::dvec2 own = 0.5 * (middle + corner);
      const glm::dvec3 offset_m =
          area_.origin_m + own.x * area_.u + own.y * area_.v - surface_.origin_m;
      const glm::dvec3 face = glm::cross(surface_.u, surface_.v);
      return std::abs(glm::dot(offset_m, face)) <= kLift_m + kSameEdge_m &&
             calc::contains_point(surface_.outline_m, glm::dvec2(glm::dot(offset_m, surface_.u),
                                                                 glm::dot(offset_m, surface_.v)));
    });
  }

 private:
  const calc::PlanarArea& area_;
  const RoomSurface& surface_;
};

// Returns whether the area, seen along its normal, contains the place, without a strip along its
// outline.
bool has_place(const calc::PlanarArea& area, const glm::dvec3& place_m, double own_strip_m) {
  const glm::dvec3 offset_m = place_m - area.origin_m;
  const glm::dvec2 flat(glm::dot(offset_m, area.u), glm::dot(offset_m, area.v));
  return is_inside(area.outline_m, flat, own_strip_m) &&
         std::none_of(area.holes_m.begin(), area.holes_m.end(),
                      [&](const auto& hole) { return calc::contains_point(hole, flat); });
}

// Tests whether places are in the room, off the strip along its walls. Upright zones are seen from
// the front: they may be on a wall, which has no strip for them. Every place is in the open space.
class InRoom {
 public:
  InRoom(const calc::Space& space, const calc::PlanarArea& zone, double strip_m)
      : space_(space), normal_(zone.normal()) {
    const bool is_level = looks_up(normal_) || looks_down(normal_);
    strip_m_ = is_level ? strip_m : 0.0;
    before_m_ = is_level ? 0.0 : 2.0 * kLift_m;
  }

  bool has(const glm::dvec3& place) const {
    const auto& outline_m = space_.shell ? space_.shell->footprint_m : space_.outline_m;
    if (outline_m.size() < 3) return true;
    const glm::dvec3 seen = place + before_m_ * normal_;
    if (space_.shell && before_m_ > 0.0) {
      const double height_m = seen.z - space_.shell->floor_z_m;
      if (height_m < 0.0 || height_m > space_.shell->height_m) return false;
    }
    return is_inside(outline_m, glm::dvec2(seen), strip_m_);
  }

 private:
  const calc::Space& space_;
  glm::dvec3 normal_;
  double strip_m_, before_m_;
};

// Returns the surface of a body. Its first vertices are the corners of its outline, in their order;
// covering surfaces may have added more (calc/project/warnings/coincident_surfaces.h).
RoomSurface surface_of(const calc::Body& body, std::size_t corners) {
  const glm::dvec3 origin_m = body.vertex_m.at(0);
  const glm::dvec3 u = glm::normalize(body.vertex_m.at(1) - origin_m);
  const glm::uvec3& first = body.triangle.at(0);
  const glm::dvec3 normal =
      glm::normalize(glm::cross(body.vertex_m.at(first.y) - body.vertex_m.at(first.x),
                                body.vertex_m.at(first.z) - body.vertex_m.at(first.x)));
  RoomSurface surface{body.id, origin_m, u, glm::cross(normal, u), {}};
  for (std::size_t i = 0; i < corners; ++i) {
    const glm::dvec3& corner = body.vertex_m.at(i);
    surface.outline_m.emplace_back(glm::dot(corner - origin_m, surface.u),
                                   glm::dot(corner - origin_m, surface.v));
  }
  return surface;
}

}  // namespace

std::vector<RoomSurface> surfaces_of(const calc::Space& space, std::string_view part) {
  std::vector<RoomSurface> surfaces;
  if (!space.shell) return surfaces;
  for (const calc::Body& body : space.bodies) {
    if (!is_part(body.id, part)) continue;
    const bool is_wall = is_part(body.id, ".wall");
    surfaces.push_back(surface_of(body, is_wall ? 4 : space.shell->footprint_m.size()));
  }
  return surfaces;
}

bool has_inside(const RoomSurface& surface, double strip_m) {
  return !places_on(surface, strip_m).place_m.empty();
}

std::vector<CoveredSurface> covered_surfaces(const calc::PlanarArea& area, double own_strip_m,
                                             const std::vector<RoomSurface>& surfaces,
                                             double strip_m) {
  std::vector<CoveredSurface> covered;
  for (const RoomSurface& surface : surfaces) {
    if (!is_near(area, surface)) continue;
    const SurfacePlaces places = places_on(surface, strip_m);
    if (places.place_m.empty()) continue;
    const AreaOnSurface on(area, surface);
    std::size_t touched = 0, counted = 0;
    for (const glm::dvec2& place : places.place_m) {
      touched += on.covers(place, 0.0) ? 1 : 0;
      counted += on.covers(place, own_strip_m) ? 1 : 0;
    }
    if (touched == 0 && !on.has_place_on_surface()) continue;
    const double all = static_cast<double>(places.place_m.size());
    covered.push_back({surface.id, all * places.cell_m2, static_cast<double>(counted) / all});
  }
  return covered;
}

bool comes_near(const calc::PlanarArea& area, const ZoneAround& around) {
  const calc::PlanarArea& inner = *around.inner;
  std::vector<glm::dvec2> seen;
  for (const glm::dvec2& corner : area.outline_m) {
    seen.push_back(
        calc::area_coordinates(inner, area.origin_m + corner.x * area.u + corner.y * area.v));
  }
  const FlatBounds own = bounds_of(seen), zone = bounds_of(inner.outline_m);
  const glm::dvec2 low = zone.low - around.to_m, high = zone.high + around.to_m;
  return own.low.x <= high.x && own.low.y <= high.y && own.high.x >= low.x && own.high.y >= low.y;
}

double covered_zone(const calc::PlanarArea& area, double own_strip_m, const ZoneAround& around,
                    std::span<const calc::PlanarArea* const> others, const calc::Space& space,
                    double strip_m) {
  constexpr double kLeastCells = 64.0, kMostCells = 256.0, kCellsAcross = 4.0;
  const calc::PlanarArea& inner = *around.inner;
  const FlatBounds bounds = bounds_of(inner.outline_m);
  const glm::dvec2 low = bounds.low - around.to_m, size_m = bounds.high + around.to_m - low;
  const double longest_m = std::max(size_m.x, size_m.y);
  const double wanted_m = around.has_inner ? 0.0 : (around.to_m - around.from_m) / kCellsAcross;
  const double cell_m = std::clamp(wanted_m, longest_m / kMostCells, longest_m / kLeastCells);
  const InRoom room(space, inner, strip_m);
  std::vector<const calc::PlanarArea*> near;
  std::copy_if(others.begin(), others.end(), std::back_inserter(near),
               [&](const calc::PlanarArea* other) { return comes_near(*other, around); });
  std::size_t all = 0, counted = 0;
  const auto columns = static_cast<int>(std::ceil(size_m.x / cell_m));
  const auto rows = static_cast<int>(std::ceil(size_m.y / cell_m));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 flat = low + cell_m * glm::dvec2(column + 0.5, row + 0.5);
      const bool is_in = calc::contains_point(inner.outline_m, flat);
      if (is_in ? !around.has_inner : !(around.to_m > 0.0)) continue;
      const double off_m = is_in ? 0.0 : calc::distance_to_boundary(inner.outline_m, flat);
      if (!is_in && (off_m < around.from_m || off_m > around.to_m)) continue;
      const glm::dvec3 place = inner.origin_m + flat.x * inner.u + flat.y * inner.v;
      if (!room.has(place)) continue;
      if (std::any_of(near.begin(), near.end(),
                      [&](const auto* other) { return has_place(*other, place, 0.0); })) {
        continue;
      }
      ++all;
      counted += has_place(area, place, own_strip_m) ? 1 : 0;
    }
  }
  return all == 0 ? 1.0 : static_cast<double>(counted) / static_cast<double>(all);
}

double shared_area_m2(const calc::PlanarArea& area, const calc::PlanarArea& other) {
  if (glm::dot(area.normal(), other.normal()) < kParallel) return 0.0;
  double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
  const auto seen = [&](const std::vector<glm::dvec2>& outline_m) {
    std::vector<glm::dvec2> flat;
    for (const glm::dvec2& corner : outline_m) {
      const glm::dvec3 offset_m =
          other.origin_m + corner.x * other.u + corner.y * other.v - area.origin_m;
      flat.emplace_back(glm::dot(offset_m, area.u), glm::dot(offset_m, area.v));
      const double above_m = glm::dot(offset_m, area.normal());
      least_m = std::min(least_m, above_m);
      most_m = std::max(most_m, above_m);
    }
    return flat;
  };
  const auto without = [](std::vector<calc::ConvexPiece> pieces,
                          const std::vector<calc::ConvexPiece>& holes) {
    for (const calc::ConvexPiece& hole : holes) pieces = calc::cut_out(pieces, hole);
    return pieces;
  };
  const std::vector<glm::dvec2> outline_m = seen(other.outline_m);
  const FlatBounds its_bounds = bounds_of(outline_m), bounds = bounds_of(area.outline_m);
  if (least_m > calc::kLeastHeadroom_m || most_m < -calc::kLeastHeadroom_m ||
      glm::any(glm::greaterThan(its_bounds.low, bounds.high)) ||
      glm::any(glm::lessThan(its_bounds.high, bounds.low))) {
    return 0.0;
  }
  std::vector<calc::ConvexPiece> own = calc::convex_pieces(area.outline_m);
  for (const auto& hole : area.holes_m) own = without(std::move(own), calc::convex_pieces(hole));
  std::vector<calc::ConvexPiece> its = calc::convex_pieces(outline_m);
  for (const auto& hole : other.holes_m) {
    its = without(std::move(its), calc::convex_pieces(seen(hole)));
  }
  return calc::area(own) - calc::area(without(own, its));
}

}  // namespace rules
