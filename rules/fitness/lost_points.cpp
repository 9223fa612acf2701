#include "rules/fitness/lost_points.h"

#include <fmt/format.h>

#include <map>

namespace rules {

namespace {

// Of points that a body has taken; else null.
const char* words_of_body(calc::DropReason reason) {
  if (reason == calc::DropReason::in_the_way) return "where '{}' stands";
  if (reason == calc::DropReason::inside_solid) return "inside '{}'";
  return reason == calc::DropReason::in_surface ? "in the surface of '{}'" : nullptr;
}

}  // namespace

double LostPoints::share() const {
  return all == 0 ? 0.0 : static_cast<double>(lost) / static_cast<double>(all);
}

std::string inner_words(const calc::SensorGrid& grid) {
  if (grid.inner.empty()) return {};
  return fmt::format(
      "{} of {} points lie in a surface that stands on the plane, the first in '{}', and are "
      "measured just off it",
      grid.inner.size(), grid.position_m.size(), grid.inner.front().body);
}

LostPoints lost_points(const calc::SensorGrid& grid) {
  constexpr std::size_t kMostNamed = 3;
  std::map<std::string, std::size_t> inside;  // by place: "inside 'desk'"
  std::size_t outside = 0, in_bodies = 0, floorless = 0;
  for (const calc::DroppedPoint& point : grid.dropped) {
    if (point.reason == calc::DropReason::outside_room) ++outside;
    if (point.reason == calc::DropReason::without_floor) ++floorless;
    const char* words = words_of_body(point.reason);
    if (words == nullptr) continue;
    ++inside[fmt::format(fmt::runtime(words), point.body)];
    ++in_bodies;
  }
  LostPoints result;
  result.lost = outside + in_bodies + floorless;
  result.all = grid.position_m.size() + result.lost;
  if (result.lost == 0) return result;
  std::string places;
  const auto add = [&](std::size_t count, const std::string& where) {
    places += fmt::format("{}{} {}", places.empty() ? "" : ", ", count, where);
  };
  std::size_t named = 0, rest = in_bodies;
  for (const auto& [place, count] : inside) {
    if (named++ == kMostNamed) break;
    add(count, place);
    rest -= count;
  }
  if (rest > 0) add(rest, "at other bodies");
  if (floorless > 0) add(floorless, "without a floor");
  if (outside > 0) add(outside, "outside the room");
  result.words = fmt::format("{} of {} points are left out: {}", result.lost, result.all, places);
  return result;
}

}  // namespace rules
