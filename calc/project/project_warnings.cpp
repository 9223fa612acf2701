#include "calc/project/project_warnings.h"

#include "calc/base/units.h"
#include "calc/project/surface_overlap.h"
#include "calc/scene/opening_fit.h"
#include "calc/scene/polygon.h"
#include "calc/scene/solids.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
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
  return others == 0 ? std::string() : fmt::format(" (and {} more of this element)", others);
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

void warn_luminaires_outside(const Space& room, Diagnostics& diagnostics) {
  PerElement outside;
  for (const Luminaire& luminaire : room.luminaires) {
    if (room_contains(*room.shell, luminaire.position_m)) continue;
    outside.add(luminaire.id, luminaire.where);
  }
  outside.report([&](const FirstOfElement& first) {
    diagnostics.report(DiagnosticId::luminaire_outside_room, first.where, first.id,
                       and_others(first.others), room.id);
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

}  // namespace

void warn_about_project(const Project& project, const std::set<std::string>& planes_on_surfaces,
                        Diagnostics& diagnostics) {
  bool has_plane = false;
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
      warn_objects_outside(space, diagnostics);
    } else if (space.surfaces_file.empty()) {
      for (const Space& room : project.spaces) {
        if (room.shell) warn_open_objects_in_room(space, room, diagnostics);
      }
    }
    warn_lamp_tilts(project, space, diagnostics);
    warn_cut_openings(project, space, diagnostics);
    warn_planes_in_surfaces(space, planes_on_surfaces, diagnostics);
  }
  if (!has_plane) {
    diagnostics.report(DiagnosticId::project_without_planes, SourceLocation{project.path});
  }
}

}  // namespace calc
