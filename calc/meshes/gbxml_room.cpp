#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/meshes/gbxml.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_cut.h"
#include "calc/scene/polygon_mend.h"
#include "calc/scene/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr double kFlatness_m = 0.05;  // an opening farther from its surface does not belong to it
constexpr double kSameHeight_m = 1e-3;
constexpr double kBeyondShare = 0.01;  // of an opening's area

// A polygon's mean plane: p = origin + x u + y v, counter-clockwise about the normal u x v.
struct Plane {
  glm::dvec3 origin_m, u, v;

  glm::dvec2 flat(const glm::dvec3& p) const {
    return {glm::dot(p - origin_m, u), glm::dot(p - origin_m, v)};
  }
  double distance_m(const glm::dvec3& p) const {
    return std::abs(glm::dot(p - origin_m, glm::cross(u, v)));
  }
  glm::dvec3 lifted(const glm::dvec2& p) const { return origin_m + p.x * u + p.y * v; }
};

// Newell's normal; empty without an area.
std::optional<Plane> mean_plane(const std::vector<glm::dvec3>& corner_m) {
  if (corner_m.size() < 3) return std::nullopt;
  glm::dvec3 normal(0.0), longest(0.0), centre(0.0);
  for (std::size_t i = 0; i < corner_m.size(); ++i) {
    const glm::dvec3 a = corner_m[i] - corner_m[0];
    const glm::dvec3 b = corner_m[(i + 1) % corner_m.size()] - corner_m[0];
    normal += glm::cross(a, b);
    if (glm::length(b - a) > glm::length(longest)) longest = b - a;
    centre += corner_m[i] / static_cast<double>(corner_m.size());
  }
  if (!(glm::length(normal) > 0.0)) return std::nullopt;
  normal = glm::normalize(normal);
  const glm::dvec3 along = longest - glm::dot(longest, normal) * normal;
  if (!(glm::length(along) > 0.0)) return std::nullopt;
  const glm::dvec3 u = glm::normalize(along);
  return Plane{centre, u, glm::cross(normal, u)};
}

// The triangles of a polygon, mended, in its plane or that of its surface.
std::vector<ConvexPiece> pieces_of(const std::vector<glm::dvec2>& corner,
                                   const std::vector<glm::uvec3>& triangle) {
  std::vector<ConvexPiece> pieces;
  for (const glm::uvec3& t : triangle) {
    ConvexPiece piece{corner[t.x], corner[t.y], corner[t.z]};
    if (signed_area(piece) < 0.0) std::swap(piece[1], piece[2]);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<glm::dvec2> flattened(const Plane& plane, const std::vector<glm::dvec3>& corner_m) {
  std::vector<glm::dvec2> corners;
  for (const glm::dvec3& p : corner_m) corners.push_back(plane.flat(p));
  return corners;
}

GbxmlPart part_of(const Plane& plane, const std::vector<ConvexPiece>& pieces, std::string id,
                  std::string type) {
  GbxmlPart part{std::move(id), std::move(type), {}, {}};
  for (const ConvexPiece& piece : pieces) {
    const auto first = static_cast<unsigned>(part.vertex_m.size());
    for (const glm::dvec2& corner : piece) part.vertex_m.push_back(plane.lifted(corner));
    for (unsigned i = 2; i < piece.size(); ++i) {
      const glm::dvec3 a = part.vertex_m[first];
      const glm::dvec3 b = part.vertex_m[first + i - 1], c = part.vertex_m[first + i];
      if (glm::cross(b - a, c - a) == glm::dvec3(0.0)) continue;  // three corners in a line
      part.triangle.emplace_back(first, first + i - 1, first + i);
    }
  }
  return part;
}

class RoomBuilder {
 public:
  RoomBuilder(const GbxmlBuilding& building, const GbxmlSpace& space, Diagnostics& diagnostics)
      : building_(building), space_(space), diagnostics_(diagnostics) {}

  GbxmlRoom run() {
    find_surfaces();
    for (const Mended& surface : surfaces_) add_surface(surface);
    find_floor();
    warn_of_mending();
    return std::move(room_);
  }

 private:
  // A surface, and what is used of its corners.
  struct Mended {
    const GbxmlSurface* surface;
    std::optional<MendedPolygon> polygon;
    std::vector<glm::dvec3> used_m;  // of its first outline; all if it could not be mended
  };

  static Mended mended(const GbxmlSurface& surface) {
    Mended result{&surface, mend_polygon(surface.corner_m), {}};
    if (!result.polygon) {
      result.used_m = surface.corner_m;
    } else {
      for (const std::uint32_t c : result.polygon->ring[0]) {
        result.used_m.push_back(surface.corner_m[c]);
      }
    }
    return result;
  }

  void find_surfaces() {
    for (const GbxmlSurface& surface : building_.surface) {
      const auto sees = [&](const GbxmlSurface::Side& side) { return side.space == space_.id; };
      if (std::none_of(surface.side.begin(), surface.side.end(), sees)) continue;
      surfaces_.push_back(mended(surface));
      for (const glm::dvec3& p : surfaces_.back().used_m) bounds_.add(p);
    }
  }

  // As the room sees it: one slab is the floor above and the ceiling below.
  std::string type_of(const Mended& mended) const {
    const GbxmlSurface& surface = *mended.surface;
    for (const GbxmlSurface::Side& side : surface.side) {
      if (side.space == space_.id && !side.type.empty()) return side.type;
    }
    if (surface.type != "InteriorFloor" && surface.type != "Ceiling") return surface.type;
    const BoundingBox box = bounding_box(mended.used_m);
    return box.centre().z > bounds_.centre().z ? "Ceiling" : "InteriorFloor";
  }

  void add_surface(const Mended& mended) {
    const GbxmlSurface& surface = *mended.surface;
    const std::optional<Plane> plane = mean_plane(mended.used_m);
    if (!mended.polygon || !plane) {
      return leave_out(surface.line, surface.id, surface.corner_m,
                       "it has no area or its sides cross");
    }
    note(*mended.polygon, surface.line, surface.id);
    std::vector<ConvexPiece> pieces =
        pieces_of(flattened(*plane, surface.corner_m), mended.polygon->triangle);
    std::vector<GbxmlPart> openings;
    std::vector<ConvexPiece> holes;
    for (const GbxmlOpening& opening : surface.opening) {
      add_opening(opening, *plane, pieces, holes, openings);
    }
    const std::string type = type_of(mended);
    if (openings.empty()) {
      // With its own corners, so that it still meets its neighbours.
      GbxmlPart part{surface.id, type, surface.corner_m, mended.polygon->triangle};
      drop_unused_corners(part.vertex_m, part.triangle);
      room_.part.push_back(std::move(part));
    } else if (!pieces.empty()) {
      room_.part.push_back(part_of(*plane, pieces, surface.id, type));
    }
    for (GbxmlPart& opening : openings) room_.part.push_back(std::move(opening));
  }

  // Cuts the opening out of `pieces`, and what earlier openings have out of the opening.
  void add_opening(const GbxmlOpening& opening, const Plane& plane,
                   std::vector<ConvexPiece>& pieces, std::vector<ConvexPiece>& holes,
                   std::vector<GbxmlPart>& openings) {
    const std::optional<MendedPolygon> mended = mend_polygon(opening.corner_m);
    if (!mended) {
      return leave_out(opening.line, opening.id, opening.corner_m,
                       "it has no area or its sides cross");
    }
    for (const std::uint32_t c : mended->ring[0]) {
      if (plane.distance_m(opening.corner_m[c]) <= kFlatness_m) continue;
      return leave_out(opening.line, opening.id, opening.corner_m, "it is not in its surface");
    }
    note(*mended, opening.line, opening.id);
    std::vector<ConvexPiece> own = pieces_of(flattened(plane, opening.corner_m), mended->triangle);
    for (const ConvexPiece& hole : holes) own = cut_out(own, hole);
    const double own_area = area(own);
    if (own.empty()) {
      return leave_out(opening.line, opening.id, {}, "other openings cover all of its area");
    }
    const double before = area(pieces);
    for (const ConvexPiece& hole : own) pieces = cut_out(pieces, hole);
    const double beyond = own_area - (before - area(pieces));
    if (beyond > kBeyondShare * own_area) {
      warn(DiagnosticId::gbxml_opening_beyond, opening.line, opening.id, beyond, own_area);
    }
    openings.push_back(part_of(plane, own, opening.id, opening.type));
    holes.insert(holes.end(), own.begin(), own.end());
  }

  void find_floor() {
    const bool has_own = !space_.floor_m.empty();
    const std::vector<glm::dvec3>* floor = has_own ? &space_.floor_m : lowest_surface();
    if (floor == nullptr) return;
    std::vector<glm::dvec2> corners;
    for (const glm::dvec3& p : *floor) corners.emplace_back(p.x, p.y);
    const std::optional<MendedPolygon> mended = mend_polygon(corners);
    if (!mended || mended->ring.size() != 1) return;  // with a hole it is no outline of a room
    BoundingBox box;
    for (const std::uint32_t c : mended->ring[0]) box.add((*floor)[c]);
    if (box.upper.z - box.lower.z > kSameHeight_m) return;
    if (has_own) note(*mended, 0, space_.id);
    for (const std::uint32_t c : mended->ring[0]) room_.footprint_m.push_back(corners[c]);
    room_.floor_z_m = box.centre().z;
    room_.height_m = bounds_.upper.z - room_.floor_z_m;
  }

  void note(const MendedPolygon& mended, int line, const std::string& id) {
    if (mended.mending.is_any()) {
      const bool is_first = ++room_.polygons_mended == 1;
      if (is_first || mended.mending.longest > room_.mending.longest) longest_mended_ = {line, id};
      room_.mending.add(mended.mending);
    }
    if (mended.deviation > kPlanarTolerance) {
      ++bent_;
      if (mended.deviation > worst_deviation_) worst_ = {line, id};
      worst_deviation_ = std::max(worst_deviation_, mended.deviation);
    }
  }

  void warn_of_mending() {
    const std::string space = shorten_utf8(space_.id, 60);
    const Mending& mending = room_.mending;
    if (room_.polygons_mended > 0) {
      diagnostics_.report(DiagnosticId::gbxml_mended, {building_.file, longest_mended_.line, 0},
                          room_.polygons_mended, space, mending.words(), mending.longest,
                          mending.at.x, mending.at.y, mending.at.z,
                          shorten_utf8(longest_mended_.id, 60));
    }
    if (bent_ == 0) return;
    diagnostics_.report(DiagnosticId::gbxml_bent, {building_.file, worst_.line, 0}, bent_, space,
                        shorten_utf8(worst_.id, 60), worst_deviation_);
  }

  void leave_out(int line, const std::string& id, const std::vector<glm::dvec3>& corner_m,
                 const char* why) {
    const double area_m2 = enclosed_area(corner_m);
    ++room_.polygons_left_out;
    room_.area_left_out_m2 += area_m2;
    warn(DiagnosticId::gbxml_left_out, line, id, why, area_m2);
  }

  // The one at the room's lowest height; null if there are several.
  const std::vector<glm::dvec3>* lowest_surface() const {
    const Mended* lowest = nullptr;
    for (const Mended& surface : surfaces_) {
      const BoundingBox box = bounding_box(surface.used_m);
      if (box.is_empty() || box.upper.z > bounds_.lower.z + kSameHeight_m) continue;
      if (lowest != nullptr) return nullptr;
      lowest = &surface;
    }
    return lowest != nullptr ? &lowest->surface->corner_m : nullptr;
  }

  template <class... Args>
  void warn(DiagnosticId id, int line, const std::string& name, const Args&... args) {
    diagnostics_.report(id, {building_.file, line, 0}, shorten_utf8(name, 60), args...);
  }

  const GbxmlBuilding& building_;
  const GbxmlSpace& space_;
  Diagnostics& diagnostics_;
  std::vector<Mended> surfaces_;
  BoundingBox bounds_;
  GbxmlRoom room_;
  struct Place {
    int line = 0;
    std::string id;
  };
  std::size_t bent_ = 0;
  double worst_deviation_ = 0.0;
  Place longest_mended_, worst_;
};

}  // namespace

std::optional<GbxmlRoom> gbxml_room(const GbxmlBuilding& building, const std::string& space_id,
                                    const SourceLocation& where, Diagnostics& diagnostics) {
  const auto space = std::find_if(building.space.begin(), building.space.end(),
                                  [&](const GbxmlSpace& s) { return s.id == space_id; });
  if (space == building.space.end()) {
    std::vector<std::string_view> ids;
    for (const GbxmlSpace& s : building.space) ids.push_back(s.id);
    const bool is_short = space_id.size() <= 100 && ids.size() <= 1000;
    diagnostics.report(DiagnosticId::gbxml_no_space, where, building.file,
                       shorten_utf8(space_id, 60), ids.size(),
                       is_short ? suggestion(space_id, ids) : std::string());
    return std::nullopt;
  }
  GbxmlRoom room = RoomBuilder(building, *space, diagnostics).run();
  if (room.part.empty()) {
    diagnostics.report(DiagnosticId::gbxml_no_surfaces, where, building.file, space_id);
    return std::nullopt;
  }
  room.name = space->name;
  return room;
}

}  // namespace calc
