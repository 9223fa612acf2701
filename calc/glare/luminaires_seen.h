#pragma once
// Light of luminaires to the sky and towards eyes: upward share, intensity towards points and
// within zones about the vertical, distance in plan. Limits for obtrusive light and for the glare
// of emergency luminaires use these.
//
// All values are of new luminaires. A luminaire counts with installed_flux_scale() times the level
// of its group in the scene, and not at all where that is 0. scene: null, or one of the project's.
// Light is that of the interpolated tables; where a search finds it, the interval holds it. Several
// emitters of one luminaire are one luminaire, at each emitter's place: the index is that of the
// first.

#include "calc/base/field.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace calc {

bool has_light(const Project& project, const Space& space, const LightScene* scene);

// Returns whether anything above the lower end may be between an eye and a luminaire.
bool may_hide_luminaires(const Space& space, double lower_z_m);

// Returns ULR: the share of the flux of all luminaires together above the horizontal as mounted, in
// %. 0 where has_light() is false. Exact for tables whose axis is vertical.
Estimate upward_share_percent(const Project& project, const Space& space, const LightScene* scene);

// A result with indices into Space::luminaires and into the points.
struct StrongestLight {
  Estimate cd;
  std::size_t luminaire = 0, point = 0;  // of cd.value; of equal ones the first point's first
  bool may_be_hidden = false;            // by what stands about
};

// Returns the greatest intensity of one luminaire towards one of the points; luminaires are at
// their centres, and one in the point itself counts with its highest intensity. facing: the
// direction of view of each point, unit. low: only of luminaires in front of the points, and 0 if
// something may hide them. 0 without luminaires.
StrongestLight strongest_intensity(const Project& project, const Space& space,
                                   const LightScene* scene, const std::vector<glm::dvec3>& points_m,
                                   const std::vector<glm::dvec3>& facing);

struct NearestLuminaire {
  Estimate m;                            // exact
  std::size_t luminaire = 0, point = 0;  // of equal ones the first
};

// Returns the distance in plan from a point to its nearest luminaire, for the point where it is
// greatest. In a room with walls only luminaires within it count; obstacles are ignored. Infinite
// without luminaires, 0 without points.
NearestLuminaire nearest_luminaire(const Project& project, const Space& space,
                                   const LightScene* scene,
                                   const std::vector<glm::dvec3>& points_m);

struct ZoneIntensity {
  std::size_t luminaire;
  Estimate cd;
};

// Returns for every luminaire that counts its greatest intensity among directions from_deg to
// to_deg from straight down in the world, of any azimuth; 0 <= from_deg < to_deg <= 180. Where
// planes of a table disagree at its pole, the greatest is that of directions arbitrarily near the
// pole. Exact for tables whose axis is vertical.
std::vector<ZoneIntensity> zone_intensities(const Project& project, const Space& space,
                                            const LightScene* scene, double from_deg,
                                            double to_deg);

}  // namespace calc
