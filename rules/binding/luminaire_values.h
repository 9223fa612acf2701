#pragma once
// What is required of luminaires as such: their light upwards, towards points and at glaring
// angles, and how near they are. No light of points is in it.

#include "calc/base/field.h"
#include "calc/glare/luminaires_seen.h"
#include "calc/scene/project.h"
#include "rules/applicability/place_in_space.h"
#include "rules/catalogue/requirement.h"

#include <functional>
#include <vector>

namespace rules {

// Of a plane, as its grid has them.
struct PlanePoints {
  std::vector<glm::dvec3> position_m, normal;
};

// Of any azimuth, from the downward vertical.
struct AngleZone {
  double from_deg, to_deg;
  auto operator<=>(const AngleZone&) const = default;
};

// What is known of a space's luminaires in a scene of the project, or at full output (""); asked
// for only if it is needed.
struct LuminaireFacts {
  const calc::Project& project;
  const calc::Space& space;
  const calc::LightScene* scene;  // null: full output
  std::function<const std::vector<calc::ZoneIntensity>&(AngleZone)> zone_intensities;
  std::function<const std::vector<MountingHeight>&()> heights;  // of all luminaires
  std::function<calc::Estimate()> upward_percent;
  std::function<const PlanePoints&()> points;
};

// Of a metric that is_of_luminaires(): its value, with words, or why there is none.
void set_luminaire_value(const LuminaireFacts& facts, Requirement& requirement);

}  // namespace rules
