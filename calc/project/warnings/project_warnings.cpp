#include "calc/project/warnings/project_warnings.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/warnings/luminaire_warnings.h"
#include "calc/project/warnings/plane_warnings.h"
#include "calc/project/warnings/room_inside.h"
#include "calc/project/warnings/warning_words.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace calc {
namespace {

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

void warn_objects_outside(const Space& room, Diagnostics& diagnostics) {
  BoundingBox within = room.shell ? room_box(room) : BoundingBox();
  for (const Body& body : room.bodies) {
    if (body.encloses_room) within = bounding_box(body.vertex_m);
  }
  if (within.is_empty()) return;
  const glm::dvec3 low = within.lower, high = within.upper;
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

bool reaches_into(const RoomShell& shell, const BoundingBox& room, const Body& body) {
  const BoundingBox box = bounding_box(body.vertex_m);
  if (glm::any(glm::greaterThan(box.lower, room.upper)) ||
      glm::any(glm::lessThan(box.upper, room.lower))) {
    return false;
  }
  for (const glm::uvec3& t : body.triangle) {
    const std::vector<glm::dvec3> corners{body.vertex_m[t.x], body.vertex_m[t.y],
                                          body.vertex_m[t.z]};
    const BoundingBox around = bounding_box(corners);
    const bool is_apart = glm::any(glm::greaterThan(around.lower, room.upper)) ||
                          glm::any(glm::lessThan(around.upper, room.lower));
    if (!is_apart && reaches_into(shell, corners)) return true;
  }
  // The room may lie wholly within a body.
  return body.is_closed &&
         locate_point(body, box, 0.5 * (room.lower + room.upper)) == SolidSide::inside;
}

void warn_open_objects_in_room(const Space& open, const Space& room, Diagnostics& diagnostics) {
  PerElement bodies, luminaires;
  const BoundingBox box = room_box(room);
  for (const Body& body : open.bodies) {
    if (reaches_into(*room.shell, box, body)) bodies.add(body.id, body.where);
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

void warn_rooms_that_overlap(const Project& project, Diagnostics& diagnostics) {
  std::vector<const Space*> rooms;
  std::vector<BoundingBox> box;
  for (const Space& space : project.spaces) {
    if (!space.shell) continue;
    rooms.push_back(&space);
    box.push_back(room_box(space));
  }
  using Pair = std::pair<const Space*, const Space*>;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (glm::any(glm::greaterThan(box[i].lower, box[k].upper)) ||
          glm::any(glm::lessThan(box[i].upper, box[k].lower))) {
        continue;
      }
      if (share_space(*rooms[i]->shell, *rooms[k]->shell)) pairs.emplace_back(rooms[i], rooms[k]);
    }
  }
  warn_of_first_few<Pair>(pairs, "pairs of rooms", [&](const Pair& pair, const std::string& more) {
    diagnostics.report(DiagnosticId::rooms_overlap, pair.first->where, pair.first->id,
                       pair.second->id, more);
  });
}

// Where light of the open space runs: around its luminaires and planes.
BoundingBox open_light_box(const Space& open) {
  BoundingBox box;
  if (open.luminaires.empty() || open.planes.empty()) return box;
  for (const Luminaire& luminaire : open.luminaires) box.add(luminaire.position_m);
  for (const CalcPlane& plane : open.planes) {
    if (const auto* area = std::get_if<PlanarArea>(&plane.area)) {
      for (const glm::dvec2& p : area->outline_m) {
        box.add(area->origin_m + p.x * area->u + p.y * area->v);
      }
    } else if (const auto* list = std::get_if<PointList>(&plane.area)) {
      for (const glm::dvec3& p : list->position_m) box.add(p);
    }
  }
  return box;
}

void warn_rooms_in_open_space(const Project& project, const Space& open, Diagnostics& diagnostics) {
  const BoundingBox light = open_light_box(open);
  if (light.is_empty()) return;
  std::vector<const Space*> rooms;
  for (const Space& room : project.spaces) {
    const BoundingBox box = room_box(room);
    if (&room == &open || box.is_empty()) continue;
    if (glm::all(glm::lessThan(box.lower, light.upper)) &&
        glm::all(glm::greaterThan(box.upper, light.lower))) {
      rooms.push_back(&room);
    }
  }
  warn_of_first_few<const Space*>(rooms, "rooms", [&](const Space* room, const std::string& more) {
    diagnostics.report(DiagnosticId::room_in_open_space, room->where, room->id, more);
  });
}

void warn_groups_alike(const Project& project, Diagnostics& diagnostics) {
  std::map<std::string, const Luminaire*> first;  // by the name in small letters
  std::set<std::string> said;
  for (const Space& space : project.spaces) {
    for (const Luminaire& luminaire : space.luminaires) {
      const std::string name = ascii_lowered(luminaire.group);
      const Luminaire* other = first.try_emplace(name, &luminaire).first->second;
      if (other->group == luminaire.group || !said.insert(name).second) continue;
      diagnostics.report(DiagnosticId::groups_alike, luminaire.where, luminaire.group,
                         other->group);
    }
  }
}

}  // namespace

void warn_about_project(const Project& project, const std::set<std::string>& planes_on_surfaces,
                        Diagnostics& diagnostics) {
  bool has_plane = false;
  warn_efficacies(project, diagnostics);
  warn_room_sizes(project, diagnostics);
  warn_rooms_that_overlap(project, diagnostics);
  warn_groups_alike(project, diagnostics);
  for (const Space& space : project.spaces) {
    const bool has_planes_here = !space.planes.empty() || !space.workplaces.empty();
    has_plane = has_plane || has_planes_here;
    if (has_planes_here && space.luminaires.empty()) {
      diagnostics.report(DiagnosticId::space_without_luminaires, space.where,
                         space.shell || !space.surfaces_file.empty()
                             ? "room '" + space.id + "'"
                             : std::string("the open space"));
    }
    warn_objects_outside(space, diagnostics);
    if (space.is_open_space()) {
      for (const Space& room : project.spaces) {
        if (room.shell) warn_open_objects_in_room(space, room, diagnostics);
      }
      warn_rooms_in_open_space(project, space, diagnostics);
    }
    warn_luminaires(project, space, diagnostics);
    warn_planes(project, space, planes_on_surfaces, diagnostics);
  }
  if (!has_plane && project.buildings.empty()) {  // of a building nothing is calculated
    diagnostics.report(DiagnosticId::project_without_planes, SourceLocation{project.path});
  }
}

}  // namespace calc
