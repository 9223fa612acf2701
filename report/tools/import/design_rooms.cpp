#include "report/tools/import/design_rooms.h"

#include "calc/scene/polygon.h"

#include <tuple>
#include <vector>

namespace cli {

std::optional<std::size_t> room_at(const Design& design, const glm::dvec2& at,
                                   std::optional<double> z, const std::string& storey) {
  constexpr double kNear_m = 0.02;  // of floors and ceilings
  std::optional<std::size_t> best;
  std::tuple<bool, bool, double> rank;  // smaller is better
  for (std::size_t i = 0; i < design.room.size(); ++i) {
    const DesignRoom& room = design.room[i];
    if (!calc::contains_point(room.outline_m, at)) continue;
    bool is_in_hole = false;
    for (const std::vector<glm::dvec2>& hole : room.hole_m) {
      is_in_hole = is_in_hole || calc::contains_point(hole, at);
    }
    if (is_in_hole) continue;
    const bool is_elsewhere = !storey.empty() && !room.storey.empty() && room.storey != storey;
    const bool is_beyond = z && (*z < room.floor_z_m - kNear_m ||
                                 (room.height_m && *z > room.floor_z_m + *room.height_m + kNear_m));
    const std::tuple mine(is_elsewhere, is_beyond, calc::signed_area(room.outline_m));
    if (best && !(mine < rank)) continue;
    best = i;
    rank = mine;
  }
  return best;
}

}  // namespace cli
