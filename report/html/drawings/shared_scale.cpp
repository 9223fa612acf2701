#include "report/html/drawings/shared_scale.h"

#include "report/document/shown_plane.h"
#include "report/html/drawings/plan_layout.h"
#include "report/text/words.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

namespace report {
namespace {

struct Range {
  double low = 0.0, high = 0.0;
};

Range values_of(const PlanePart& plane) {
  Range range{plane.points[0].measured.value, plane.points[0].measured.value};
  for (const PointRow& point : plane.points) {
    range.low = std::min(range.low, point.measured.value);
    range.high = std::max(range.high, point.measured.value);
  }
  return range;
}

// The limits widen the scale when that does not squeeze the colours; else they are marked off the
// scale.
Range wanted_range(const PlanePart& plane) {
  Range range = values_of(plane);
  const double reach = 0.6 * (range.high - range.low);
  const double least = range.low - reach, most = range.high + reach;
  for (const PlanLimit& limit : plan_limits({}, plane)) {
    if (limit.limit < least || limit.limit > most) continue;
    range.low = std::min(range.low, limit.limit);
    range.high = std::max(range.high, limit.limit);
  }
  return range;
}

constexpr double kFarBelow = 0.1;

struct PlaneRange {
  Range wanted, values;
};

double highest_of(const std::vector<PlaneRange>& planes) {
  double highest = planes.front().values.high;
  for (const PlaneRange& plane : planes) highest = std::max(highest, plane.values.high);
  return highest;
}

// Of the plane that has the fewest.
int fewest_colours(const ColourScale& scale, const std::vector<PlaneRange>& planes) {
  int fewest = scale.bands;
  for (const PlaneRange& plane : planes) {
    const int colours = band_of(scale, plane.values.high) - band_of(scale, plane.values.low) + 1;
    fewest = std::min(fewest, colours);
  }
  return fewest;
}

// is_of_light: in lx or the like, not ratings or ratios.
ColourScale scale_of_all(std::vector<PlaneRange> planes, double highest, bool is_of_light) {
  std::erase_if(planes,
                [&](const PlaneRange& plane) { return plane.values.high < kFarBelow * highest; });
  Range all{highest, highest};
  for (const PlaneRange& plane : planes) {
    all.low = std::min(all.low, plane.wanted.low);
    all.high = std::max(all.high, plane.wanted.high);
  }
  const ColourScale even = make_colour_scale(all.low, all.high);
  if (!is_of_light || !(all.low >= 0.0) || !(all.high > 0.0)) return even;
  // Of one colour says nothing of how light falls off; what is told apart by fewer colours is read
  // more easily.
  const ColourScale classes = make_class_scale(all.low, all.high);
  const ColourScale& best =
      fewest_colours(classes, planes) > fewest_colours(even, planes) ? classes : even;
  if (fewest_colours(best, planes) > 1) return best;
  const ColourScale fine = make_class_scale(all.low, all.high, ClassSeries::fine);
  return fewest_colours(fine, planes) > 1 ? fine : best;
}

bool has_drawing(const PlanePart& plane) { return has_cells(plane) && has_all_values(plane); }

}  // namespace

ColourScale own_scale(const PlanePart& plane) {
  const Range range = wanted_range(plane);
  return make_colour_scale(range.low, range.high);
}

std::string_view sharing_words(const Texts& t, ScaleSharing sharing) {
  switch (sharing) {
    case ScaleSharing::project:
      return t[Text::scale_of_project];
    case ScaleSharing::room:
      return t[Text::scale_of_room];
    case ScaleSharing::plane:
      break;
  }
  return t[Text::scale_of_plane];
}

ColourScales::ColourScales(const ProjectPart& project, ScaleSharing sharing, ColourMap map)
    : sharing_(sharing), map_(map) {
  if (sharing == ScaleSharing::plane) return;
  std::map<Key, std::vector<PlaneRange>> planes;
  std::set<Key> units_of_light;
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      const ShownPlane shown(plane);
      if (!has_drawing(*shown)) continue;
      if (*plane_unit(plane) != '\0') units_of_light.insert(key_of(space, plane));
      planes[key_of(space, plane)].push_back({wanted_range(*shown), values_of(*shown)});
    }
  }
  for (const auto& [key, ranges] : planes) {
    if (ranges.size() < 2) continue;
    const double highest = highest_of(ranges);
    const bool is_of_light = units_of_light.contains(key);
    shared_.emplace(key, Shared{scale_of_all(ranges, highest, is_of_light), highest});
  }
}

ColourScales::Key ColourScales::key_of(const SpacePart& space, const PlanePart& plane) const {
  // Ratings and ratios are no illuminance, nor like each other.
  const std::string unit = plane_unit(plane);
  const std::string kind = unit.empty() ? plane_words(plane) : unit;
  return {sharing_ == ScaleSharing::room ? space.id : "", kind};
}

PlaneScale ColourScales::of(const SpacePart& space, const PlanePart& own_plane) const {
  const ShownPlane shown(own_plane);
  const PlanePart& plane = *shown;
  const auto found = shared_.find(key_of(space, plane));
  const bool is_shared =
      found != shared_.end() && values_of(plane).high >= kFarBelow * found->second.highest;
  PlaneScale result = is_shared ? PlaneScale{found->second.scale, sharing_}
                                : PlaneScale{own_scale(plane), ScaleSharing::plane};
  result.scale.map = map_;
  return result;
}

}  // namespace report
