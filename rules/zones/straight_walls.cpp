#include "rules/zones/straight_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rules {

std::vector<std::optional<std::size_t>> join_straight_walls(const RulePack& pack,
                                                            calc::Workplace& workplace) {
  constexpr double kStraight = 1.0e-9;  // sine
  const std::size_t n = workplace.walls.size();
  std::vector<std::optional<std::size_t>> part_of(n);
  const auto is_named = [&](std::size_t i) {
    return std::any_of(
        workplace.zones.begin(), workplace.zones.end(), [&](const calc::ZoneText& zone) {
          const RulePlane* plane = pack.find_plane(zone.role.substr(0, zone.role.rfind('.')));
          return plane != nullptr && plane->area == ZoneArea::walls &&
                 zone.role == fmt::format("{}.{}", plane->role, i + 1);
        });
  };
  const auto goes_on = [&](std::size_t i) {
    const calc::PlanarArea& one = workplace.walls[i];
    const calc::PlanarArea& next = workplace.walls[(i + 1) % n];
    return glm::length(glm::cross(one.u, next.u)) < kStraight && glm::dot(one.u, next.u) > 0.0 &&
           !is_named(i) && !is_named((i + 1) % n);
  };
  std::size_t start = 0;  // behind a real corner
  while (start < n && goes_on((start + n - 1) % n)) ++start;
  const std::vector<calc::PlanarArea> walls = workplace.walls;
  for (std::size_t k = 0; k < n;) {
    std::vector<std::size_t> group{(start + k) % n};
    while (++k < n && goes_on(group.back())) group.push_back((start + k) % n);
    const std::size_t first = *std::min_element(group.begin(), group.end());
    calc::PlanarArea& joined = workplace.walls[first];
    double length_m = 0.0;
    for (const std::size_t i : group) {
      length_m += walls[i].outline_m[1].x;
      if (glm::dot(walls[i].origin_m - joined.origin_m, joined.u) < 0.0) {
        joined.origin_m = walls[i].origin_m;
      }
      if (i != first) part_of[i] = first;
    }
    if (group.size() == 1) continue;
    joined.outline_m[1].x = joined.outline_m[2].x = length_m;
  }
  return part_of;
}

std::string run_of_pieces(const std::vector<calc::PlanarArea>& walls,
                          const std::vector<std::optional<std::size_t>>& part_of,
                          const std::vector<std::size_t>& too_narrow) {
  constexpr double kNearlyStraight = 0.94;  // cosine, 20 degrees
  constexpr double kWide_m = 1.5;           // a metre and more is left within half-metre margins
  const std::size_t n = walls.size();
  const std::set<std::size_t> narrow(too_narrow.begin(), too_narrow.end());
  const auto after = [&](std::size_t i) {
    std::size_t next = (i + 1) % n;
    while (next != i && part_of[next]) next = (next + 1) % n;
    return next;
  };
  const auto goes_on = [&](std::size_t i, std::size_t next) {
    return narrow.contains(next) && glm::dot(walls[i].u, walls[next].u) > kNearlyStraight;
  };
  for (const std::size_t first : too_narrow) {
    double length_m = walls[first].outline_m[1].x;
    std::size_t last = first;
    for (std::size_t next = after(first); next != first && goes_on(last, next);
         next = after(next)) {
      length_m += walls[next].outline_m[1].x;
      last = next;
    }
    if (last == first || length_m < kWide_m) continue;
    return fmt::format("walls {} to {}, pieces of a wall of {:.2f} m, are too narrow one by one",
                       first + 1, last + 1, length_m);
  }
  return "";
}

}  // namespace rules
