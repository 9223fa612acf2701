#include "calc/project/project_warnings.h"

#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/project/surface_overlap.h"
#include "calc/scene/opening_fit.h"
#include "calc/scene/polygon.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace calc {
namespace {

constexpr double kOnBoundary_m = 1.0e-6;

bool room_contains(const RoomShell& shell, const glm::dvec3& point_m) {
  if (point_m.z < shell.floor_z_m - kOnBoundary_m) return false;
  if (point_m.z > shell.floor_z_m + shell.height_m + kOnBoundary_m) return false;
  const glm::dvec2 foot(point_m);
  return contains_point(shell.footprint_m, foot) ||
         distance_to_boundary(shell.footprint_m, foot) <= kOnBoundary_m;
}

std::string and_others(std::size_t others) {
  return others == 0 ? std::string() : fmt::format(" ({})", and_more(others, "of this element"));
}

// Things that come from one element of the file get one warning: the first one's id, and how many
// more.
struct FirstOfElement {
  std::string id;
  SourceLocation where;
  std::size_t others = 0;
};

class PerElement {
 public:
  void add(const std::string& id, const SourceLocation& where) {
    const auto [entry, is_new] =
        found_.try_emplace({where.line, where.column}, FirstOfElement{id, where, 0});
    if (!is_new) ++entry->second.others;
  }
  void report(const std::function<void(const FirstOfElement&)>& warn) const {
    for (const auto& [place, first] : found_) warn(first);
  }

 private:
  std::map<std::pair<int, int>, FirstOfElement> found_;
};

// Things of one kind, each from an element of its own: the first few are named, the last of these
// tells how many more there are.
template <class Thing>
void warn_of_first_few(const std::vector<Thing>& things, const char* kind,
                       const std::function<void(const Thing&, const std::string& more)>& warn) {
  constexpr std::size_t kNamed = 3;
  for (std::size_t i = 0; i < std::min(things.size(), kNamed); ++i) {
    const bool has_more = i + 1 == kNamed && things.size() > kNamed;
    warn(things[i], has_more ? fmt::format(" ({})", and_more(things.size() - kNamed, kind)) : "");
  }
}

// How far a point is outside; 0 within the room.
double distance_outside_m(const RoomShell& shell, const glm::dvec3& point_m) {
  if (room_contains(shell, point_m)) return 0.0;
  const glm::dvec2 foot(point_m);
  const double sideways_m =
      contains_point(shell.footprint_m, foot) ? 0.0 : distance_to_boundary(shell.footprint_m, foot);
  const double upright_m =
      std::max({0.0, shell.floor_z_m - point_m.z, point_m.z - shell.floor_z_m - shell.height_m});
  return glm::length(glm::dvec2(sideways_m, upright_m));
}

// The commonest way to be outside is said: ", 0.2 m above its ceiling".
std::string above_ceiling_words(const RoomShell& shell, const glm::dvec3& point_m) {
  const double above_m = point_m.z - shell.floor_z_m - shell.height_m;
  if (above_m <= 0.0 || !contains_point(shell.footprint_m, glm::dvec2(point_m))) return {};
  return fmt::format(", {:.3g} m above its ceiling", above_m);
}

void warn_luminaires_outside(const Space& room, Diagnostics& diagnostics) {
  PerElement outside;
  std::map<std::pair<int, int>, std::string> how;
  for (const Luminaire& luminaire : room.luminaires) {
    if (room_contains(*room.shell, luminaire.position_m)) continue;
    outside.add(luminaire.id, luminaire.where);
    how.try_emplace({luminaire.where.line, luminaire.where.column},
                    above_ceiling_words(*room.shell, luminaire.position_m));
  }
  outside.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_outside_room, first.where, first.id,
                       and_others(first.others), room.id,
                       how.at({first.where.line, first.where.column}));
  });
}

// The outermost points of the opening as seen from below, in the world.
std::vector<glm::dvec3> opening_edge_m(const LuminousOpening& opening, const Luminaire& luminaire) {
  const LuminousOpening flat = flattened(opening);
  const glm::dvec3 half_m = 0.5 * flat.size_m();
  std::vector<glm::dvec3> edge;
  for (const double side : {-1.0, 1.0}) {
    const std::array<glm::dvec3, 2> ends =
        flat.shape == OpeningShape::disk
            ? std::array{glm::dvec3(side * half_m.x, 0, 0), glm::dvec3(0, side * half_m.y, 0)}
            : std::array{glm::dvec3(side * half_m.x, half_m.y, 0),
                         glm::dvec3(side * half_m.x, -half_m.y, 0)};
    for (const glm::dvec3& end : ends) {
      edge.push_back(luminaire.position_m + luminaire.world_from_luminaire * end);
    }
  }
  return edge;
}

// Those whose centre is within the room: of all others everything is said already.
void warn_luminaires_partly_outside(const Project& project, const Space& room,
                                    Diagnostics& diagnostics) {
  constexpr double kTolerated_m = 1.0e-3;  // projects are written in millimetres
  PerElement partly;
  std::map<std::pair<int, int>, double> reach_m;  // the farthest of each element
  for (const Luminaire& luminaire : room.luminaires) {
    if (!room_contains(*room.shell, luminaire.position_m)) continue;
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
    double farthest_m = 0.0;
    for (const glm::dvec3& point_m : opening_edge_m(web.opening(), luminaire)) {
      farthest_m = std::max(farthest_m, distance_outside_m(*room.shell, point_m));
    }
    if (farthest_m <= kTolerated_m) continue;
    partly.add(luminaire.id, luminaire.where);
    double& reach = reach_m[{luminaire.where.line, luminaire.where.column}];
    reach = std::max(reach, farthest_m);
  }
  partly.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_partly_outside, first.where, first.id,
                       and_others(first.others), reach_m.at({first.where.line, first.where.column}),
                       room.id);
  });
}

void warn_luminaires_in_solids(const Space& space, Diagnostics& diagnostics) {
  PerElement buried;
  std::map<std::pair<int, int>, std::string> solid;
  for (const Body& body : space.bodies) {
    if (!body.is_closed) continue;
    const BoundingBox box = bounding_box(body.vertex_m);
    for (const Luminaire& luminaire : space.luminaires) {
      if (locate_point(body, box, luminaire.position_m) != SolidSide::inside) continue;
      buried.add(luminaire.id, luminaire.where);
      solid.try_emplace({luminaire.where.line, luminaire.where.column}, body.id);
    }
  }
  buried.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_in_solid, first.where, first.id,
                       and_others(first.others), solid.at({first.where.line, first.where.column}));
  });
}

std::string luminaire_words(const Luminaire& luminaire) {
  if (!luminaire.id.empty()) return "'" + luminaire.id + "'";
  const glm::dvec3& p = luminaire.position_m;
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) m", p.x, p.y, p.z);
}

constexpr double kSamePlace_m = 0.010;

// Other types at one place are the direct and the indirect light of one luminaire, other aims the
// heads of one mast.
bool is_same_luminaire(const Luminaire& a, const Luminaire& b) {
  constexpr double kSameAim = 0.99985;  // cosine of 1 degree
  return a.type == b.type && glm::distance(a.position_m, b.position_m) < kSamePlace_m &&
         glm::dot(a.world_from_luminaire[2], b.world_from_luminaire[2]) > kSameAim;
}

// Looks luminaires up by place, in cells of the distance that counts as none.
class Places {
 public:
  const Luminaire* like(const Luminaire& luminaire) const {
    const Cell centre = cell_of(luminaire);
    for (int k = 0; k < 27; ++k) {
      const auto found =
          in_cell_.find({std::get<0>(centre) + k % 3 - 1, std::get<1>(centre) + k / 3 % 3 - 1,
                         std::get<2>(centre) + k / 9 - 1});
      if (found == in_cell_.end()) continue;
      for (const Luminaire* other : found->second) {
        if (is_same_luminaire(*other, luminaire)) return other;
      }
    }
    return nullptr;
  }
  void add(const Luminaire& luminaire) { in_cell_[cell_of(luminaire)].push_back(&luminaire); }

 private:
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  static Cell cell_of(const Luminaire& luminaire) {
    const auto index = [](double x_m) { return std::llround(x_m / kSamePlace_m); };
    const glm::dvec3& p = luminaire.position_m;
    return {index(p.x), index(p.y), index(p.z)};
  }
  std::map<Cell, std::vector<const Luminaire*>> in_cell_;
};

void warn_coincident_luminaires(const Space& space, Diagnostics& diagnostics) {
  Places places;
  const Luminaire *first = nullptr, *pasted = nullptr;
  std::size_t others = 0;
  for (const Luminaire& luminaire : space.luminaires) {
    const Luminaire* same = places.like(luminaire);
    if (same == nullptr) {
      places.add(luminaire);
    } else if (pasted == nullptr) {
      first = same;
      pasted = &luminaire;
    } else {
      ++others;
    }
  }
  if (pasted == nullptr) return;
  const std::string place = first->where.file == pasted->where.file
                                ? fmt::format("line {}", first->where.line)
                                : fmt::format("{}:{}", first->where.file, first->where.line);
  diagnostics.report(
      DiagnosticId::luminaires_coincide, pasted->where, luminaire_words(*pasted),
      luminaire_words(*first), place, kSamePlace_m * 1.0e3,
      others == 0 ? std::string()
                  : fmt::format(" ({})", and_more(others, "luminaires of this space likewise")));
}

void warn_efficacies(const Project& project, Diagnostics& diagnostics) {
  // Less than any incandescent lamp in a shade, more than any luminaire on sale.
  constexpr double kLowest_lm_w = 5.0, kHighest_lm_w = 250.0;
  std::set<std::size_t> used;
  for (const Space& space : project.spaces) {
    for (const Luminaire& luminaire : space.luminaires) used.insert(luminaire.type);
  }
  std::vector<const LuminaireType*> unusual;
  const auto flux_lm = [&project](const LuminaireType& type) {
    return project.webs[type.web].flux_lm() * type.flux_scale;
  };
  for (const std::size_t index : used) {
    const LuminaireType& type = project.luminaire_types[index];
    if (!(type.power_w > 0.0)) continue;
    const double efficacy_lm_w = flux_lm(type) / type.power_w;
    if (efficacy_lm_w < kLowest_lm_w || efficacy_lm_w > kHighest_lm_w) unusual.push_back(&type);
  }
  warn_of_first_few<const LuminaireType*>(
      unusual, "types", [&](const LuminaireType* type, const std::string& more) {
        diagnostics.report(DiagnosticId::efficacy_unusual, type->where, type->id, more,
                           flux_lm(*type), type->power_w, flux_lm(*type) / type->power_w,
                           kLowest_lm_w, kHighest_lm_w);
      });
}

// From the lowest to the highest coordinates of the room's corners; empty of the open space.
BoundingBox room_box(const Space& room) {
  BoundingBox box;
  if (room.shell) {
    for (const glm::dvec2& corner : room.shell->footprint_m) {
      box.add({corner, room.shell->floor_z_m});
      box.add({corner, room.shell->floor_z_m + room.shell->height_m});
    }
  } else if (!room.surfaces_file.empty()) {
    for (const Body& body : room.bodies) {
      for (const glm::dvec3& vertex : body.vertex_m) box.add(vertex);
    }
  }
  return box;
}

void warn_room_sizes(const Project& project, Diagnostics& diagnostics) {
  // From a cupboard or the box of an experiment to the largest halls that there are.
  constexpr double kLeast_m = 0.3, kLongest_m = 500.0, kHighest_m = 100.0;
  std::vector<const Space*> unusual;
  for (const Space& space : project.spaces) {
    const BoundingBox box = room_box(space);
    if (box.is_empty()) continue;
    const glm::dvec3 size_m = box.upper - box.lower;
    const bool is_small = std::min({size_m.x, size_m.y, size_m.z}) < kLeast_m;
    const bool is_large = std::max(size_m.x, size_m.y) > kLongest_m || size_m.z > kHighest_m;
    if (is_small || is_large) unusual.push_back(&space);
  }
  warn_of_first_few<const Space*>(
      unusual, "rooms", [&](const Space* room, const std::string& more) {
        const BoundingBox box = room_box(*room);
        const glm::dvec3 size_m = box.upper - box.lower;
        diagnostics.report(DiagnosticId::room_size_unusual, room->where, room->id, more, size_m.x,
                           size_m.y, size_m.z, kLeast_m, kLongest_m, kLeast_m, kHighest_m);
      });
}

void warn_lamp_tilts(const Project& project, const Space& space, Diagnostics& diagnostics) {
  constexpr double kDegrees = 180.0 / kPi;
  PerElement outside;
  std::map<std::pair<int, int>, const Luminaire*> first_at;
  for (const Luminaire& luminaire : space.luminaires) {
    const auto& tilt = project.webs[project.luminaire_types[luminaire.type].web].source().lamp_tilt;
    if (!tilt || covers(*tilt, lamp_tilt_rad(*tilt, luminaire.world_from_luminaire))) continue;
    outside.add(luminaire.id, luminaire.where);
    first_at.try_emplace({luminaire.where.line, luminaire.where.column}, &luminaire);
  }
  outside.report([&](const FirstOfElement& first) {
    const Luminaire& luminaire = *first_at.at({first.where.line, first.where.column});
    const auto& tilt =
        *project.webs[project.luminaire_types[luminaire.type].web].source().lamp_tilt;
    const double tilt_rad = lamp_tilt_rad(tilt, luminaire.world_from_luminaire);
    diagnostics.report(DiagnosticId::photometry_tilt_outside, first.where, first.id,
                       and_others(first.others), tilt_rad * kDegrees,
                       tilt.angle_rad.front() * kDegrees, tilt.angle_rad.back() * kDegrees,
                       tilt_factor(tilt, tilt_rad));
  });
}

void warn_cut_openings(const Project& project, const Space& space, Diagnostics& diagnostics) {
  PerElement cut;
  OpeningFit fit(space);
  for (const Luminaire& luminaire : space.luminaires) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[luminaire.type].web];
    if (fit.is_cut(web.opening(), luminaire)) cut.add(luminaire.id, luminaire.where);
  }
  cut.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminous_body_cut, first.where, first.id,
                       and_others(first.others));
  });
}

void warn_objects_outside(const Space& room, Diagnostics& diagnostics) {
  glm::dvec3 low(room.shell->footprint_m.front(), room.shell->floor_z_m);
  glm::dvec3 high(low.x, low.y, room.shell->floor_z_m + room.shell->height_m);
  for (const glm::dvec2& corner : room.shell->footprint_m) {
    low = glm::min(low, glm::dvec3(corner, low.z));
    high = glm::max(high, glm::dvec3(corner, high.z));
  }
  PerElement outside;
  for (const Body& body : room.bodies) {
    const BoundingBox box = bounding_box(body.vertex_m);
    const bool is_apart =
        glm::any(glm::greaterThan(box.lower, high)) || glm::any(glm::lessThan(box.upper, low));
    if (is_apart) outside.add(body.id, body.where);
  }
  outside.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::object_outside_room, first.where, first.id,
                       and_others(first.others), room.id);
  });
}

glm::dvec3 centre_of(const Body& body) {
  const BoundingBox box = bounding_box(body.vertex_m);
  return 0.5 * (box.lower + box.upper);
}

void warn_open_objects_in_room(const Space& open, const Space& room, Diagnostics& diagnostics) {
  PerElement bodies, luminaires;
  for (const Body& body : open.bodies) {
    if (room_contains(*room.shell, centre_of(body))) bodies.add(body.id, body.where);
  }
  for (const Luminaire& luminaire : open.luminaires) {
    if (room_contains(*room.shell, luminaire.position_m)) {
      luminaires.add(luminaire.id, luminaire.where);
    }
  }
  const auto warn_as = [&](const char* kind) {
    return [&diagnostics, &room, kind](const FirstOfElement& first) {
      diagnostics.report(DiagnosticId::object_inside_room, first.where, kind, first.id,
                         and_others(first.others), room.id);
    };
  };
  bodies.report(warn_as("object"));
  luminaires.report(warn_as("luminaire"));
}

void warn_planes_in_surfaces(const Space& space, const std::set<std::string>& on_purpose,
                             Diagnostics& diagnostics) {
  for (const CalcPlane& plane : space.planes) {
    const auto* area = std::get_if<PlanarArea>(&plane.area);
    if (area == nullptr || on_purpose.contains(plane.id)) continue;
    const SurfaceOverlap overlap(*area);
    for (const Body& body : space.bodies) {
      if (!overlap.with(body)) continue;
      diagnostics.report(DiagnosticId::plane_in_surface, plane.where, plane.id, body.id);
      break;
    }
  }
}

// No part of the luminaire's opening is on the side that the normal points to.
bool is_behind(const Project& project, const Luminaire& luminaire, const glm::dvec3& point_m,
               const glm::dvec3& normal) {
  const LuminousOpening& opening =
      project.webs[project.luminaire_types[luminaire.type].web].opening();
  return glm::dot(normal, luminaire.position_m - point_m) < -0.5 * glm::length(opening.size_m());
}

bool faces_away(const Project& project, const Space& space, const CalcPlane& plane) {
  const auto sees_none = [&](const glm::dvec3& point_m, const glm::dvec3& normal) {
    return std::all_of(
        space.luminaires.begin(), space.luminaires.end(),
        [&](const Luminaire& luminaire) { return is_behind(project, luminaire, point_m, normal); });
  };
  if (const auto* area = std::get_if<PlanarArea>(&plane.area)) {
    return sees_none(area->origin_m, area->normal());
  }
  if (const auto* route = std::get_if<EscapeRoute>(&plane.area)) {
    const std::vector<glm::dvec3>& corners_m = route->line.corner_m;
    return std::all_of(corners_m.begin(), corners_m.end(), [&](const glm::dvec3& corner_m) {
      return sees_none(corner_m, glm::dvec3(0, 0, 1));
    });
  }
  const auto& list = std::get<PointList>(plane.area);
  for (std::size_t i = 0; i < list.position_m.size(); ++i) {
    if (!sees_none(list.position_m[i], list.normal[i])) return false;
  }
  return true;
}

// on_purpose: planes in a surface look away from it, whatever the light does.
void warn_planes_facing_away(const Project& project, const Space& space,
                             const std::set<std::string>& on_purpose, Diagnostics& diagnostics) {
  if (space.luminaires.empty()) return;
  std::vector<const CalcPlane*> away;
  for (const CalcPlane& plane : space.planes) {
    const bool is_planar =
        plane.kernel == ReceiverKernel::planar && plane.derived == DerivedQuantity::none;
    if (!is_planar || on_purpose.contains(plane.id)) continue;
    if (faces_away(project, space, plane)) away.push_back(&plane);
  }
  warn_of_first_few<const CalcPlane*>(
      away, "planes of this space", [&](const CalcPlane* plane, const std::string& more) {
        diagnostics.report(DiagnosticId::plane_faces_away, plane->where, plane->id, more);
      });
}

}  // namespace

void warn_about_project(const Project& project, const std::set<std::string>& planes_on_surfaces,
                        Diagnostics& diagnostics) {
  bool has_plane = false;
  warn_efficacies(project, diagnostics);
  warn_room_sizes(project, diagnostics);
  for (const Space& space : project.spaces) {
    const bool has_planes_here = !space.planes.empty() || !space.workplaces.empty();
    has_plane = has_plane || has_planes_here;
    if (has_planes_here && space.luminaires.empty()) {
      diagnostics.report(DiagnosticId::space_without_luminaires, space.where,
                         space.shell || !space.surfaces_file.empty()
                             ? "room '" + space.id + "'"
                             : std::string("the open space"));
    }
    if (space.shell) {
      warn_luminaires_outside(space, diagnostics);
      warn_luminaires_partly_outside(project, space, diagnostics);
      warn_objects_outside(space, diagnostics);
    } else if (space.surfaces_file.empty()) {
      for (const Space& room : project.spaces) {
        if (room.shell) warn_open_objects_in_room(space, room, diagnostics);
      }
    }
    warn_luminaires_in_solids(space, diagnostics);
    warn_coincident_luminaires(space, diagnostics);
    warn_lamp_tilts(project, space, diagnostics);
    warn_cut_openings(project, space, diagnostics);
    warn_planes_in_surfaces(space, planes_on_surfaces, diagnostics);
    warn_planes_facing_away(project, space, planes_on_surfaces, diagnostics);
  }
  if (!has_plane) {
    diagnostics.report(DiagnosticId::project_without_planes, SourceLocation{project.path});
  }
}

}  // namespace calc
