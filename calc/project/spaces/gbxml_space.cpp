#include "calc/project/spaces/gbxml_space.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/meshes/gbxml.h"
#include "calc/project/objects/material_map.h"
#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace calc {
namespace {

// All that a room of the file can have, so that rooms may share their maps.
std::vector<std::string> types_in(const GbxmlBuilding& building) {
  std::set<std::string> types{"Ceiling", "InteriorFloor"};
  for (const GbxmlSurface& surface : building.surface) {
    types.insert(surface.type);
    for (const GbxmlSurface::Side& side : surface.side) types.insert(side.type);
    for (const GbxmlOpening& opening : surface.opening) types.insert(opening.type);
  }
  return {types.begin(), types.end()};
}

constexpr const char* kOpenBoundary = "Air";

void add_bodies(GbxmlRoom room, const MaterialMap& materials, ElementReader& reader, Space& space) {
  std::vector<std::string> missing;
  for (GbxmlPart& part : room.part) {
    // Nothing stands there: what all surfaces are made of does not fit it.
    const bool is_open = part.type == kOpenBoundary && !materials.of_name.contains(kOpenBoundary);
    const std::optional<std::uint32_t> material =
        is_open ? std::nullopt : materials.find(part.type);
    if (!material) {
      const std::string words =
          part.type.empty() ? "surfaces without a type"
          : is_open         ? fmt::format(
                                  "'{}', an open boundary that 'material' does not cover: map it to "
                                          "a black material, which takes in what leaves there",
                                  kOpenBoundary)
                    : "'" + part.type + "'";
      if (std::find(missing.begin(), missing.end(), words) == missing.end()) {
        missing.push_back(words);
      }
      continue;
    }
    Body body;
    body.id = space.id + "." + part.id;
    body.vertex_m = std::move(part.vertex_m);
    body.material_of.assign(part.triangle.size(), *material);
    body.triangle = std::move(part.triangle);
    body.where = space.where;
    space.bodies.push_back(std::move(body));
  }
  if (missing.empty()) return;
  reader.report(DiagnosticId::gbxml_unmapped, reader.where(), space.id,
                fmt::format("{}", fmt::join(missing, ", ")));
}

}  // namespace

void read_gbxml_surfaces(ProjectContext& context, ElementReader& reader, Space& space,
                         RoomPlan& plan) {
  const std::string file = reader.text("file");
  const std::string space_id = reader.text("space");
  const GbxmlBuilding* building =
      file.empty() ? nullptr : context.files.building(file, reader.where("file"));
  std::vector<std::string> types;
  if (building != nullptr) types = types_in(*building);
  const MaterialMap materials = read_material_map(context, reader, "surface or opening type",
                                                  building != nullptr ? &types : nullptr);
  if (building == nullptr || space_id.empty()) return;
  space.surfaces_file = file;
  std::optional<GbxmlRoom> room =
      gbxml_room(*building, space_id, reader.where("space"), context.diagnostics);
  if (!room) return;
  if (space.name.empty()) space.name = room->name;
  plan.corners_m = room->footprint_m;
  plan.origin_m = {0.0, 0.0, room->floor_z_m};
  plan.height_m = room->height_m;
  plan.is_clockwise = signed_area(plan.corners_m) < 0.0;
  add_bodies(std::move(*room), materials, reader, space);
}

}  // namespace calc
