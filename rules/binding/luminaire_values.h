#pragma once
// Requirements on luminaires as such: their light upwards, towards points and at glaring angles,
// and their distances. They use no illuminance of points.

#include "calc/base/field.h"
#include "calc/glare/luminaires_seen.h"
#include "calc/scene/project.h"
#include "rules/applicability/place_in_space.h"
#include "rules/catalogue/requirement.h"

#include <functional>
#include <vector>

namespace rules {

// The points of a plane's grid.
struct PlanePoints {
  std::vector<glm::dvec3> position_m, normal;
};

// Angles from the downward vertical, at any azimuth.
struct AngleZone {
  double from_deg, to_deg;
  auto operator<=>(const AngleZone&) const = default;
};

// Facts about a space's luminaires in a scene of the project, or at full output (""). The functions
// are called only if their facts are needed.
struct LuminaireFacts {
  const calc::Project& project;
  const calc::Space& space;
  const calc::LightScene* scene;  // null: full output
  std::function<const std::vector<calc::ZoneIntensity>&(AngleZone)> zone_intensities;
  std::function<const std::vector<MountingHeight>&()> heights;  // of all luminaires
  std::function<calc::Estimate()> upward_percent;
  std::function<const PlanePoints&()> points;
};

// Sets the value of a metric that is_of_luminaires() with words, or why there is none.
void set_luminaire_value(const LuminaireFacts& facts, Requirement& requirement);

}  // namespace rules
