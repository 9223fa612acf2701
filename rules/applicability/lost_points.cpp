#include "rules/applicability/lost_points.h"

#include "calc/base/sentences.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace rules {

namespace {

// Returns words for this many points that a body removed: is_of_body().
calc::Message taken_words(calc::DropReason reason, std::size_t count, const std::string& body) {
  using enum calc::Sentence;
  if (reason == calc::DropReason::in_the_way) return calc::say<lost_where>(count, body);
  if (reason == calc::DropReason::inside_solid) return calc::say<lost_inside>(count, body);
  return calc::say<lost_in_surface>(count, body);
}

bool is_of_body(calc::DropReason reason) {
  return reason == calc::DropReason::in_the_way || reason == calc::DropReason::inside_solid ||
         reason == calc::DropReason::in_surface;
}

}  // namespace

double LostPoints::share() const {
  return all == 0 ? 0.0 : static_cast<double>(lost) / static_cast<double>(all);
}

calc::Message inner_words(const calc::SensorGrid& grid) {
  if (grid.inner.empty()) return {};
  return calc::say<calc::Sentence::inner_points>(grid.inner.size(), grid.position_m.size(),
                                                 grid.inner.front().body);
}

LostPoints lost_points(const calc::SensorGrid& grid) {
  constexpr std::size_t kMostNamed = 3;
  std::map<std::pair<std::string, calc::DropReason>, std::size_t> taken;  // by body and reason
  std::size_t outside = 0, in_bodies = 0, floorless = 0;
  for (const calc::DroppedPoint& point : grid.dropped) {
    if (point.reason == calc::DropReason::outside_room) ++outside;
    if (point.reason == calc::DropReason::without_floor) ++floorless;
    if (!is_of_body(point.reason)) continue;
    ++taken[{point.body, point.reason}];
    ++in_bodies;
  }
  LostPoints result;
  result.lost = outside + in_bodies + floorless;
  result.all = grid.position_m.size() + result.lost;
  if (result.lost == 0) return result;
  calc::Message places;
  const auto add = [&](const calc::Message& words) { append(places, words, ", "); };
  std::size_t named = 0, rest = in_bodies;
  for (const auto& [by, count] : taken) {
    if (named++ == kMostNamed) break;
    add(taken_words(by.second, count, by.first));
    rest -= count;
  }
  if (rest > 0) add(calc::say<calc::Sentence::lost_elsewhere>(rest));
  if (floorless > 0) add(calc::say<calc::Sentence::lost_floorless>(floorless));
  if (outside > 0) add(calc::say<calc::Sentence::lost_outside>(outside));
  result.words = calc::say<calc::Sentence::points_lost>(result.lost, result.all, places);
  return result;
}

}  // namespace rules
