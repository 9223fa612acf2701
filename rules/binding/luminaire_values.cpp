#include "rules/binding/luminaire_values.h"

#include "calc/base/sentences.h"
#include "calc/glare/field_glare.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>

namespace rules {
namespace {

using calc::say;
using calc::Sentence;

calc::Message place_words(const glm::dvec3& place) {
  return say<Sentence::place_of_point>(place.x, place.y, place.z);
}

// Returns the id of a luminaire, which its emitters share.
const std::string& name_of(const LuminaireFacts& facts, std::size_t luminaire) {
  return facts.space.luminaires[luminaire].id;
}

// Refuses planes whose values would take minutes.
bool are_too_many(const LuminaireFacts& facts, Requirement& requirement) {
  const auto points = static_cast<double>(facts.points().position_m.size());
  const auto luminaires = static_cast<double>(facts.space.luminaires.size());
  if (points * luminaires <= calc::kMostFieldPairs) return false;
  requirement.problem = say<Sentence::field_too_many>(points, luminaires, calc::kMostFieldPairs);
  return true;
}

void set_intensity(const LuminaireFacts& facts, Requirement& requirement) {
  if (are_too_many(facts, requirement)) return;
  const PlanePoints& points = facts.points();
  const calc::StrongestLight strongest = calc::strongest_intensity(
      facts.project, facts.space, facts.scene, points.position_m, points.normal);
  requirement.of_space = strongest.cd;
  if (strongest.cd.value > 0.0) {
    add_note(say<Sentence::strongest_of>(name_of(facts, strongest.luminaire),
                                         place_words(points.position_m[strongest.point])),
             requirement);
  }
  add_note(say<Sentence::strongest_method>(), requirement);
  if (!(strongest.cd.low < strongest.cd.value)) return;
  add_note(strongest.may_be_hidden ? say<Sentence::luminaires_may_be_hidden>()
                                   : say<Sentence::luminaires_behind>(),
           requirement);
}

void set_distance(const LuminaireFacts& facts, Requirement& requirement) {
  if (are_too_many(facts, requirement)) return;
  const PlanePoints& points = facts.points();
  add_note(say<Sentence::distance_method>(), requirement);
  const calc::NearestLuminaire nearest =
      calc::nearest_luminaire(facts.project, facts.space, facts.scene, points.position_m);
  requirement.of_space = nearest.m;
  if (!std::isfinite(nearest.m.value)) {
    requirement.problem = say<Sentence::no_luminaire_is_on>();
    return;
  }
  if (points.position_m.empty()) return;
  add_note(say<Sentence::nearest_of>(place_words(points.position_m[nearest.point]),
                                     name_of(facts, nearest.luminaire)),
           requirement);
}

// Returns the angles at which EN 1838 limits the intensity of luminaires: 60 to 90 degrees for
// level ways, elsewhere all angles.
AngleZone limited_zone(Metric metric) {
  return metric == Metric::peak_intensity ? AngleZone{0.0, 180.0} : AngleZone{60.0, 90.0};
}

// Adds the intensities at full output, because a battery's light before its end is between the
// scene's level and full output.
void add_full_output(const LuminaireFacts& facts, AngleZone zone,
                     std::vector<calc::ZoneIntensity>& intensities) {
  const std::vector<calc::ZoneIntensity> full =
      calc::zone_intensities(facts.project, facts.space, nullptr, zone.from_deg, zone.to_deg);
  for (calc::ZoneIntensity& one : intensities) {
    for (const calc::ZoneIntensity& same : full) {
      if (same.luminaire != one.luminaire) continue;
      one.cd.value = std::max(one.cd.value, same.cd.value);
      one.cd.high = std::max(one.cd.high, same.cd.high);
    }
  }
}

// Returns words for a range of heights without luminaires.
calc::Message no_luminaire_words(const HeightRange& range,
                                 const std::vector<calc::ZoneIntensity>& luminaires,
                                 const std::vector<MountingHeight>& heights) {
  MountingHeight all{std::numeric_limits<double>::infinity(), 0.0};
  for (const calc::ZoneIntensity& one : luminaires) {
    all.least_m = std::min(all.least_m, heights[one.luminaire].least_m);
    all.most_m = std::max(all.most_m, heights[one.luminaire].most_m);
  }
  if (!std::isfinite(range.to_m)) return say<Sentence::no_luminaire_from>(range.from_m, all.most_m);
  if (range.from_m == 0.0) return say<Sentence::no_luminaire_below>(range.to_m, all.least_m);
  return say<Sentence::no_luminaire_between>(range.from_m, range.to_m, all.least_m, all.most_m);
}

void set_zone_intensity(const LuminaireFacts& facts, Requirement& requirement) {
  std::size_t count = 0, worst = 0;
  calc::Estimate greatest;
  const AngleZone zone = limited_zone(requirement.metric);
  std::vector<calc::ZoneIntensity> intensities = facts.zone_intensities(zone);
  const bool is_of_battery = requirement.state == LightState::end_of_duration;
  if (is_of_battery) add_full_output(facts, zone, intensities);
  const std::vector<MountingHeight>& heights = facts.heights();
  const auto& range = std::get<HeightRange>(requirement.arguments);
  bool is_height_open = false;
  for (const calc::ZoneIntensity& one : intensities) {
    const MountingHeight& height = heights[one.luminaire];
    if (height.most_m < range.from_m || height.least_m >= range.to_m) continue;
    const bool is_certain = height.least_m >= range.from_m && height.most_m < range.to_m;
    is_height_open = is_height_open || !is_certain;
    if (++count == 1 || one.cd.value > greatest.value) worst = one.luminaire;
    greatest = {std::max(greatest.value, one.cd.value),
                std::max(greatest.low, is_certain ? one.cd.low : 0.0),
                std::max(greatest.high, one.cd.high)};
  }
  requirement.of_space = greatest;
  if (count == 0) {
    // Of a row other ranges hold the luminaires. A range of the project's own may have been written
    // in another unit, and then nothing has been judged.
    if (!requirement.origin.pack.empty()) {
      return add_note(say<Sentence::nobody_hangs_there>(), requirement);
    }
    requirement.problem = no_luminaire_words(range, intensities, heights);
    return;
  }
  add_note(say<Sentence::glare_zone_of>(name_of(facts, worst), heights[worst].least_m, count),
           requirement);
  if (is_height_open) add_note(say<Sentence::floors_differ>(), requirement);
  if (greatest.low < greatest.high && is_of_battery) {
    add_note(say<Sentence::battery_begins_full>(), requirement);
  }
}

// Returns whether the scene switches off every luminaire that would emit light at full output: then
// every upper limit is met. Not for batteries, whose light before their end is not known from that.
// Darkness says nothing about the distance of the nearest luminaire.
bool is_met_by_darkness(const LuminaireFacts& facts, const Requirement& requirement) {
  return facts.scene != nullptr && calc::has_light(facts.project, facts.space, nullptr) &&
         requirement.metric != Metric::luminaire_distance &&
         requirement.state != LightState::end_of_duration &&
         !is_lower_limit(requirement.comparison);
}

}  // namespace

void set_luminaire_value(const LuminaireFacts& facts, Requirement& requirement) {
  if (!requirement.problem.empty()) return;
  if (facts.space.road) {
    requirement.problem = say<Sentence::luminaires_go_on>();
    return;
  }
  if (requirement.metric == Metric::upward_share && !facts.space.is_open_space()) {
    requirement.problem = say<Sentence::upward_indoors>();
    return;
  }
  if (!calc::has_light(facts.project, facts.space, facts.scene)) {
    if (!is_met_by_darkness(facts, requirement)) {
      requirement.problem = say<Sentence::no_luminaire_is_on>();
      return;
    }
    // Of the share of no light it is so decided: nothing goes up.
    requirement.of_space = {};
    return add_note(say<Sentence::scene_is_dark>(facts.scene->id), requirement);
  }
  switch (requirement.metric) {
    case Metric::upward_share:
      requirement.of_space = facts.upward_percent();
      return add_note(say<Sentence::upward_method>(), requirement);
    case Metric::intensity:
      return set_intensity(facts, requirement);
    case Metric::glare_intensity:
    case Metric::peak_intensity:
      return set_zone_intensity(facts, requirement);
    case Metric::luminaire_distance:
      return set_distance(facts, requirement);
    default:
      throw std::logic_error("this is not of luminaires");
  }
}

}  // namespace rules
