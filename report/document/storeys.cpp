#include "report/document/storeys.h"

#include "calc/base/text.h"
#include "calc/scene/polygon.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

namespace report {
namespace {

using Outline = std::vector<glm::dvec2>;

struct Extent {
  glm::dvec2 low{std::numeric_limits<double>::max()};
  glm::dvec2 high{std::numeric_limits<double>::lowest()};
};

Extent extent_of(const Outline& outline) {
  Extent extent;
  for (const glm::dvec2& corner : outline) {
    extent.low = glm::min(extent.low, corner);
    extent.high = glm::max(extent.high, corner);
  }
  return extent;
}

// A file may hold any numbers, and any number of them; such a room is on no plan.
bool is_usable(const SpacePart& space) {
  constexpr double kFarthest_m = 1e7;
  const auto is_near = [](double m) { return std::abs(m) <= kFarthest_m; };  // false if not finite
  return space.footprint_m.size() >= 3 && space.footprint_m.size() <= kMostPlanCorners &&
         is_near(space.floor_z_m) &&
         std::all_of(space.footprint_m.begin(), space.footprint_m.end(),
                     [&](const glm::dvec2& m) { return is_near(m.x) && is_near(m.y); });
}

// Outlines of real buildings touch and overlap a little at walls and doors. They overlap where a
// fourth of the smaller one is shared, counted at places of a grid over it.
bool overlap(const Outline& a, const Outline& b) {
  constexpr int kPlaces = 16;
  constexpr double kShare = 0.25;
  const Extent of_a = extent_of(a), of_b = extent_of(b);
  const glm::dvec2 shared = glm::min(of_a.high, of_b.high) - glm::max(of_a.low, of_b.low);
  if (!(shared.x > 0.0) || !(shared.y > 0.0)) return false;
  const bool is_a_smaller = std::abs(calc::signed_area(a)) <= std::abs(calc::signed_area(b));
  const Outline &smaller = is_a_smaller ? a : b, &larger = is_a_smaller ? b : a;
  const Extent box = is_a_smaller ? of_a : of_b;
  int inside = 0, in_both = 0;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    const glm::dvec2 share((i % kPlaces + 0.5) / kPlaces, (i / kPlaces + 0.5) / kPlaces);
    const glm::dvec2 place = box.low + share * (box.high - box.low);
    if (!calc::contains_point(smaller, place)) continue;
    ++inside;
    in_both += calc::contains_point(larger, place) ? 1 : 0;
  }
  return in_both > kShare * inside;
}

bool fits(const ProjectPart& project, const SpacePart& space, const Storey& storey) {
  return std::none_of(storey.rooms.begin(), storey.rooms.end(), [&](std::size_t other) {
    return overlap(space.footprint_m, project.spaces[other].footprint_m);
  });
}

// room: not lower than those before it. It goes to the highest storey that it fits into.
void add_room(const ProjectPart& project, std::size_t room, Storeys& storeys) {
  constexpr int kMostBeside = 8;  // more of one height are no alternatives of a design
  const SpacePart& space = project.spaces[room];
  int beside = 0;
  for (std::size_t i = storeys.list.size(); i-- > 0;) {
    Storey& storey = storeys.list[i];
    if (space.floor_z_m - storey.floor_z_m >= kStoreyStep_m) break;
    if (fits(project, space, storey)) {
      storey.rooms.push_back(room);
      return;
    }
    ++beside;
  }
  if (beside < kMostBeside) {
    storeys.list.push_back({space.floor_z_m, {room}});
  } else {
    storeys.overlapping.push_back(room);
  }
}

bool has_neighbour(const Storeys& storeys, const Storey& storey) {
  return std::any_of(storeys.list.begin(), storeys.list.end(), [&](const Storey& other) {
    return &other != &storey && std::abs(other.floor_z_m - storey.floor_z_m) < kStoreyStep_m;
  });
}

// Rooms that are alone at a height that others have, too.
void drop_overlapping(Storeys& storeys) {
  std::vector<Storey> kept;
  for (const Storey& storey : storeys.list) {
    if (storey.rooms.size() == 1 && has_neighbour(storeys, storey))
      storeys.overlapping.push_back(storey.rooms.front());
    else
      kept.push_back(storey);
  }
  std::sort(storeys.overlapping.begin(), storeys.overlapping.end());
  storeys.list = std::move(kept);
}

std::string_view sorted_name(const SpacePart& space) {
  return space.name.empty() ? space.id : space.name;
}

// By names; of names that are equal by ids.
bool stands_before(const SpacePart& a, const SpacePart& b) {
  if (calc::comes_before(sorted_name(a), sorted_name(b))) return true;
  if (calc::comes_before(sorted_name(b), sorted_name(a))) return false;
  return calc::comes_before(a.id, b.id);
}

}  // namespace

bool overlap_in_plan(const SpacePart& a, const SpacePart& b) {
  return is_usable(a) && is_usable(b) && overlap(a.footprint_m, b.footprint_m);
}

Storeys storeys_of(const ProjectPart& project) {
  Storeys storeys;
  std::vector<std::size_t> rooms;
  for (std::size_t i = 0; i < project.spaces.size(); ++i) {
    const SpacePart& space = project.spaces[i];
    if (is_usable(space)) {
      rooms.push_back(i);
    } else if (space.footprint_m.empty() && space.surface_lines_m.empty()) {
      storeys.outdoors.push_back(i);
    } else {
      storeys.without_outline.push_back(i);
    }
  }
  std::stable_sort(rooms.begin(), rooms.end(), [&](std::size_t a, std::size_t b) {
    return project.spaces[a].floor_z_m < project.spaces[b].floor_z_m;
  });
  for (const std::size_t room : rooms) add_room(project, room, storeys);
  for (Storey& storey : storeys.list) std::sort(storey.rooms.begin(), storey.rooms.end());
  drop_overlapping(storeys);
  return storeys;
}

std::vector<std::size_t> spaces_in_order(const ProjectPart& project) {
  const Storeys storeys = storeys_of(project);
  std::vector<std::size_t> order(project.spaces.size()),
      storey(project.spaces.size(), storeys.list.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < storeys.list.size(); ++i) {
    for (const std::size_t room : storeys.list[i].rooms) storey[room] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return storey[a] != storey[b] ? storey[a] < storey[b]
                                  : stands_before(project.spaces[a], project.spaces[b]);
  });
  return order;
}

}  // namespace report
