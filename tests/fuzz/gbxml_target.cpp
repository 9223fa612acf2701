// gbXML: the building, then its first rooms.
#include "calc/meshes/gbxml.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <algorithm>
#include <cmath>

namespace {

void check_room(const calc::GbxmlBuilding& building, const std::string& id) {
  calc::Diagnostics diagnostics;
  const auto room = calc::gbxml_room(building, id, {"p.xml", 1, 1}, diagnostics);
  fuzz::check_messages(room.has_value(), diagnostics);
  if (!room) return;
  fuzz::require(!room->part.empty(), "a room has parts");
  for (const calc::GbxmlPart& part : room->part) {
    fuzz::check_triangles(part.vertex_m, part.triangle);
  }
  for (const glm::dvec2& corner : room->footprint_m) {
    fuzz::require(std::isfinite(corner.x) && std::isfinite(corner.y), "the footprint is finite");
  }
  fuzz::require(std::isfinite(room->floor_z_m) && std::isfinite(room->height_m),
                "the heights are finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto building =
      calc::parse_gbxml(std::string(fuzz::as_text(data, size)), "a.xml", diagnostics);
  fuzz::check_messages(building.has_value(), diagnostics);
  if (!building) return 0;
  constexpr std::size_t kRooms = 4;
  for (std::size_t i = 0; i < std::min(kRooms, building->space.size()); ++i) {
    check_room(*building, building->space[i].id);
  }
  return 0;
}
