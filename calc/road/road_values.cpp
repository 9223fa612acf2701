#include "calc/road/road_values.h"

#include "calc/base/sentences.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

enum class Worst { lowest, highest };

// The end that decides of each of several estimates, one for each lane: of both ends and the value.
Estimate worst_of(const std::vector<Estimate>& all, Worst worst) {
  Estimate found = all.front();
  for (const Estimate& one : all) {
    if (worst == Worst::lowest) {
      found = {std::min(found.value, one.value), std::min(found.low, one.low),
               std::min(found.high, one.high)};
    } else {
      found = {std::max(found.value, one.value), std::max(found.low, one.low),
               std::max(found.high, one.high)};
    }
  }
  return found;
}

Message numbers_words(const std::vector<Estimate>& all, int digits) {
  std::vector<std::string> numbers;
  for (const Estimate& one : all) numbers.push_back(fmt::format("{:.{}f}", one.value, digits));
  return Message::number(fmt::format("{}", fmt::join(numbers, " ")));
}

// of: what an observer has of it, empty if there is none.
template <class Of>
RoadValue of_lanes(const RoadLight& light, Worst worst, int digits, const Message& problem, Of of) {
  std::vector<Estimate> all;
  for (const RoadObserver& observer : light.observers) {
    const std::optional<Estimate> one = of(observer);
    if (!one) return {problem};
    all.push_back(*one);
  }
  RoadValue value{{}, worst_of(all, worst)};
  if (all.size() > 1) value.words = say<Sentence::road_by_lane>(numbers_words(all, digits));
  return value;
}

RoadValue of_edges(const RoadLight& light, const RoadLayout& layout) {
  std::vector<Estimate> all;
  if (!layout.right_strip_m && !layout.left_strip_m) return {say<Sentence::road_no_edge>()};
  for (const auto& [strip, ratio] : {std::pair(layout.right_strip_m, light.right_ratio),
                                     std::pair(layout.left_strip_m, light.left_ratio)}) {
    if (strip && !ratio) return {say<Sentence::road_dark>()};
    if (ratio) all.push_back(*ratio);
  }
  constexpr int kDigits = 3;
  RoadValue value{{}, worst_of(all, Worst::lowest)};
  value.words = all.size() > 1
                    ? say<Sentence::road_by_edge>(numbers_words(all, kDigits),
                                                  *layout.right_strip_m, *layout.left_strip_m)
                    : say<Sentence::road_one_edge>(
                          layout.right_strip_m.value_or(layout.left_strip_m.value_or(0.0)));
  return value;
}

const RTable& known_table(const std::string& surface) {
  const RTable* table = r_table(surface);
  if (table == nullptr) throw std::logic_error("no such road surface: " + surface);
  return *table;
}

}  // namespace

RoadLayout road_layout(const Project& project, const Space& space, const LightScene* scene) {
  const Road& road = space.road.value();
  RoadLayout layout;
  layout.spacing_m = road.spacing_m;
  layout.width_m = road.width_m;
  layout.lanes = static_cast<int>(road.is_oncoming.size());
  layout.is_oncoming = road.is_oncoming;
  layout.table = &known_table(road.surface);
  layout.q0 = road.q0.value_or(layout.table->q0);
  layout.right_strip_m = road.right_strip_m;
  layout.left_strip_m = road.left_strip_m;
  for (const Luminaire& luminaire : road.rows) {
    const LuminaireType& type = project.luminaire_types[luminaire.type];
    // An emitter beside the middle of its luminaire may lie behind x = 0.
    double shift_m = luminaire.position_m.x;
    shift_m -= road.spacing_m * std::floor(shift_m / road.spacing_m);
    if (!(shift_m < road.spacing_m)) shift_m = 0.0;
    layout.rows.push_back(
        {&project.webs[type.web],
         installed_flux_scale(project, luminaire) * level_in_scene(scene, luminaire.group),
         type.maintenance.product, luminaire.position_m.z, luminaire.position_m.y, shift_m,
         luminaire.world_from_luminaire});
  }
  return layout;
}

Message road_method_words(const Road& road) {
  const RTable& table = known_table(road.surface);
  const int across = kRoadRowsPerLane * static_cast<int>(road.is_oncoming.size());
  const Message words = say<Sentence::road_method>(road_points_along(road.spacing_m), across,
                                                   road.surface, road.q0.value_or(table.q0));
  return table.is_wet ? words + "; " + say<Sentence::road_wet>() : words;
}

Message road_stated_words(const Road& road) {
  std::string lanes;
  for (const bool is_oncoming : road.is_oncoming) lanes += is_oncoming ? '-' : '+';
  const auto strip = [](const std::optional<double>& width_m) {
    return Message::number(fmt::format("{:.6g} m", width_m.value_or(0.0)));
  };
  return say<Sentence::road_stated>(road.surface, road.q0.value_or(known_table(road.surface).q0),
                                    road.width_m, lanes, strip(road.right_strip_m),
                                    strip(road.left_strip_m));
}

RoadValues road_values(const Project& project, const Space& space, const LightScene* scene) {
  const RoadLayout layout = road_layout(project, space, scene);
  const RoadLight light = road_light(layout);
  RoadValues values;
  constexpr int kLuminanceDigits = 3, kRatioDigits = 3, kPercentDigits = 1;
  const Message dark = say<Sentence::road_dark>();
  values.luminance_cd_m2 =
      of_lanes(light, Worst::lowest, kLuminanceDigits, dark,
               [](const RoadObserver& o) { return std::optional(o.average_cd_m2); });
  values.uo = of_lanes(light, Worst::lowest, kRatioDigits, dark,
                       [](const RoadObserver& o) { return o.uo; });
  values.ul = of_lanes(light, Worst::lowest, kRatioDigits, dark,
                       [](const RoadObserver& o) { return o.ul; });
  values.ti_percent =
      of_lanes(light, Worst::highest, kPercentDigits, say<Sentence::road_too_dark_for_ti>(),
               [](const RoadObserver& o) { return o.ti_percent; });
  values.rei = of_edges(light, layout);
  values.words = say<Sentence::road_standard>();
  values.stated = road_stated_words(*space.road);
  if (layout.table->is_wet) values.why_no_row = say<Sentence::road_wet_row>(space.road->surface);
  if (space.road->is_street_assumed) values.words += "; " + say<Sentence::road_street_assumed>();
  return values;
}

}  // namespace calc
