#pragma once
// The loss of light of a lamp in a tilted luminaire (metal halide).

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// TILT data of an LM-63 file. The factor scales all intensities by the tilt of the lamp in the
// installed luminaire, whatever the direction of the light.
struct LampTilt {
  // LM-63's lamp-to-luminaire geometry. 1: the lamp is vertical while the luminaire points down;
  // 2: horizontal along C0-C180, so that it stays horizontal while the luminaire turns about that
  // line; 3: horizontal, and tilts with the luminaire.
  int geometry = 1;
  std::vector<double> angle_rad;  // ascending, within [-pi, pi], holding 0
  std::vector<double> factor;     // > 0, one for each angle
};

// Returns the lamp's tilt, rad in [0, pi] (geometry 2: [0, pi/2]). Columns: the luminaire's axes.
double lamp_tilt_rad(const LampTilt& tilt, const glm::dmat3& world_from_luminaire);

// Returns whether the table holds this angle. A table of angles >= 0 only, or up to 90 degrees
// only, does not hold others.
bool covers(const LampTilt& tilt, double tilt_rad);

// Returns a factor linear between the angles; beyond them that of the nearest.
double tilt_factor(const LampTilt& tilt, double tilt_rad);

}  // namespace calc
