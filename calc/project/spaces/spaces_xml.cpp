#include "calc/project/spaces/spaces_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/objects/objects_xml.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/gbxml_space.h"
#include "calc/project/spaces/mesh_room.h"
#include "calc/project/spaces/planes_xml.h"
#include "calc/project/spaces/road_xml.h"
#include "calc/project/spaces/room_plan.h"
#include "calc/project/spaces/route_xml.h"
#include "calc/project/spaces/workplace_xml.h"
#include "calc/project/warnings/coincident_surfaces.h"
#include "calc/project/warnings/open_shells.h"
#include "calc/scene/housing.h"
#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace calc {
namespace {

// Room coordinates; empty on errors.
std::vector<glm::dvec2> read_footprint_m(const ProjectContext& context, ElementReader& reader) {
  const std::vector<double> numbers =
      reader.number_groups("footprint", 2, 3, kCornerLimit,
                           fmt::format("3 to {} corners of 2 numbers (x y)", kCornerLimit));
  std::vector<glm::dvec2> corners;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    corners.push_back(glm::dvec2(numbers[i], numbers[i + 1]) * context.metres_per_unit);
  }
  return corners;
}

RoomPlan read_plan(const ProjectContext& context, ElementReader& reader) {
  RoomPlan plan;
  plan.origin_m = read_point_m_or_zero(context, reader, "origin");
  if (!reader.exclude("size", "footprint")) return plan;
  if (reader.has("size")) {
    reader.exclude("size", "height");
    const glm::dvec3 size = read_size_m(context, reader, "size");
    plan.corners_m = {{0, 0}, {size.x, 0}, {size.x, size.y}, {0, size.y}};
    plan.height_m = size.z;
  } else if (reader.has("footprint") || reader.has("height")) {
    if (!reader.require_together("footprint", "height")) return plan;
    plan.corners_m = read_footprint_m(context, reader);
    plan.height_m = reader.number("height", kPositive) * context.metres_per_unit;
  } else {
    reader.report(DiagnosticId::missing_form, reader.where(), "room",
                  "'size', or 'footprint' and 'height'");
  }
  plan.is_clockwise = signed_area(plan.corners_m) < 0.0;  // mending keeps it
  // A size can be too thin for its length, too.
  const char* attribute = reader.has("size") ? "size" : "footprint";
  const bool is_read = !plan.corners_m.empty() && (reader.has("footprint") || reader.ok());
  if (!is_read) return plan;
  plan.corners_m = mended_outline(reader, attribute, plan.corners_m,
                                  "; walls are numbered without these corners");
  if (plan.corners_m.empty()) {
    reader.report(DiagnosticId::not_simple_polygon, reader.where(attribute), attribute, "room", "");
  }
  return plan;
}

ShellMaterials read_shell_materials(const ProjectContext& context, ElementReader& reader,
                                    std::size_t wall_count) {
  ShellMaterials materials;
  materials.ceiling = read_material(context, reader, "ceiling");
  materials.floor = read_material(context, reader, "floor");
  materials.walls.assign(wall_count, read_material(context, reader, "walls"));
  if (!reader.has("wall-materials")) return materials;
  const std::string list = reader.text("wall-materials");
  const std::vector<std::string_view> ids = split_words(list);
  if (ids.size() != wall_count && wall_count > 0 && !ids.empty()) {
    reader.report(DiagnosticId::wrong_number_count, reader.where("wall-materials"),
                  "wall-materials", "room",
                  fmt::format("{} materials, one for each wall", wall_count), ids.size());
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::size_t material =
        context.materials.find(reader, "wall-materials", std::string(ids[i]));
    if (i < wall_count) materials.walls[i] = static_cast<std::uint32_t>(material);
  }
  return materials;
}

// Ids that only the assemblies' prefixes or the shell's own names make equal.
void check_body_ids(const Space& space, Diagnostics& diagnostics) {
  std::map<std::string_view, int> line_of_id;
  for (const Body& body : space.bodies) {
    const auto [entry, is_new] = line_of_id.try_emplace(body.id, body.where.line);
    if (is_new) continue;
    diagnostics.report(DiagnosticId::duplicate_id, body.where, "object", body.id, entry->second);
  }
}

void add_objects(ProjectContext& context, ObjectSet objects, const glm::dvec3& origin_m,
                 Space& space, PlaneSurroundings& surroundings) {
  context.instances += objects.instances();
  context.triangles += objects.triangles;
  const std::size_t shell_bodies = space.bodies.size();
  for (Body& body : objects.bodies) {
    for (glm::dvec3& vertex : body.vertex_m) vertex += origin_m;
    space.bodies.push_back(std::move(body));
  }
  for (Luminaire& luminaire : objects.luminaires) {
    luminaire.position_m += origin_m;
    space.luminaires.push_back(std::move(luminaire));
  }
  if (surroundings.objects_are_good && surroundings.room_is_good) {
    fit_housings(context.project, space);
    settle_coincident_surfaces(space, shell_bodies, context.project.materials, context.diagnostics);
    find_open_shells(space, shell_bodies);
  }
  surroundings.origin_m = origin_m;
  surroundings.box_tops = std::move(objects.box_tops);
  for (auto& [id, top] : surroundings.box_tops) top.origin_m += origin_m;
}

void read_planes(ProjectContext& context, const XmlElement& parent,
                 const PlaneSurroundings& surroundings, Space& space) {
  for (const XmlElement& child : parent.children) {
    if (child.name != "plane" && child.name != "route") continue;
    ElementReader reader(child, context.diagnostics);
    space.planes.push_back(child.name == "route"
                               ? read_route(context, reader, surroundings.origin_m)
                               : read_plane(context, reader, surroundings));
  }
}

void read_prism(ProjectContext& context, ElementReader& reader, Space& space, RoomPlan& plan) {
  plan = read_plan(context, reader);
  const ShellMaterials materials = read_shell_materials(context, reader, plan.corners_m.size());
  if (!reader.ok()) return;
  space.shell = plan.shell();
  space.bodies = make_shell_bodies(plan, materials, space.id, space.where);
}

struct RoomFile {
  RoomSource source = RoomSource::prism;
  bool is_good = true;  // false: it cannot be read, which is said
};

// The file says what it is; without it the attributes do.
RoomFile find_source(ProjectContext& context, const ElementReader& reader) {
  const XmlAttribute* file = reader.element().find("file");
  if (file == nullptr) return {};
  const RoomSource guess = reader.has("space") ? RoomSource::gbxml : RoomSource::mesh;
  if (file->value.empty()) return {guess};
  const std::optional<bool> is_xml = context.files.is_xml(file->value, reader.where("file"));
  if (!is_xml) return {guess, false};
  return {*is_xml ? RoomSource::gbxml : RoomSource::mesh};
}

const ElementRow& row_of(RoomSource source) {
  switch (source) {
    case RoomSource::gbxml:
      return kGbxmlRoomElement;
    case RoomSource::mesh:
      return kMeshRoomElement;
    case RoomSource::prism:
      break;
  }
  return kPrismRoomElement;
}

void read_room(ProjectContext& context, ElementReader& reader, IdTable& ids, FormerIds& former) {
  const auto [source, is_file_good] = find_source(context, reader);
  const bool is_of_file = source != RoomSource::prism;
  reader.allow(row_of(source));
  Space space;
  space.id = reader.id();
  space.was = former.read(reader, space.id);
  space.name = reader.text_or("name", "");
  space.tags = read_tags(reader);
  space.where = reader.where();
  ids.add(reader, space.id, 0);
  if (space.id == kOpenSpaceId) {
    reader.report(DiagnosticId::reserved_id, reader.where("id"), space.id);
  }
  RoomPlan plan;
  if (is_of_file) {
    if (is_file_good && source == RoomSource::gbxml) {
      read_gbxml_surfaces(context, reader, space, plan);
    } else if (is_file_good) {
      read_mesh_surfaces(context, reader, space, plan);
    }
    for (const glm::dvec2& corner : plan.outline()) {
      space.outline_m.push_back(glm::dvec2(plan.origin_m) + corner);
    }
  } else {
    read_prism(context, reader, space, plan);
  }
  PlaneSurroundings surroundings;
  surroundings.source = source;
  if (!is_of_file || !plan.corners_m.empty()) surroundings.room = &plan;
  surroundings.room_is_good = reader.ok();
  ObjectSet objects = read_objects(context, reader.element());
  surroundings.objects_are_good = reader.ok();
  // Objects in a room of a file are in the building's coordinates.
  add_objects(context, std::move(objects), is_of_file ? glm::dvec3(0.0) : plan.origin_m, space,
              surroundings);
  if (reader.ok()) check_body_ids(space, context.diagnostics);
  read_planes(context, reader.element(), surroundings, space);
  read_workplaces(context, reader.element(), surroundings, space);
  context.project.spaces.push_back(std::move(space));
}

}  // namespace

void read_rooms(ProjectContext& context, const XmlElement& root) {
  IdTable ids("room or road");
  FormerIds former("room");
  for (const XmlElement& child : root.children) {
    if (child.name != "room" && child.name != "road") continue;
    ElementReader reader(child, context.diagnostics);
    if (child.name == "road") {
      read_road(context, reader, ids);
    } else {
      read_room(context, reader, ids, former);
    }
  }
  former.check(context.diagnostics);
}

void read_open_space(ProjectContext& context, const XmlElement& root) {
  Space space;
  space.id = kOpenSpaceId;
  space.where = root.where;
  PlaneSurroundings surroundings;
  const std::size_t errors = context.diagnostics.error_count();
  ObjectSet objects = read_objects(context, root);
  surroundings.objects_are_good = context.diagnostics.error_count() == errors;
  add_objects(context, std::move(objects), glm::dvec3(0.0), space, surroundings);
  if (surroundings.objects_are_good) check_body_ids(space, context.diagnostics);
  read_planes(context, root, surroundings, space);
  if (space.bodies.empty() && space.luminaires.empty() && space.planes.empty()) return;
  context.project.spaces.push_back(std::move(space));
}

}  // namespace calc
