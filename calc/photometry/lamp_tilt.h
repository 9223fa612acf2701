#pragma once
// How much less light a lamp gives when the luminaire is installed tilted (metal halide).

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// TILT data of an LM-63 file. The factor scales all intensities by the tilt of the lamp in the
// installed luminaire; it has nothing to do with the direction of the light.
struct LampTilt {
  // LM-63's lamp-to-luminaire geometry. 1: the lamp is vertical while the luminaire points down;
  // 2: horizontal along C0-C180, so that it stays horizontal while the luminaire turns about that
  // line; 3: horizontal, and tilts with the luminaire.
  int geometry = 1;
  std::vector<double> angle_rad;  // ascending, within [-pi, pi], holding 0
  std::vector<double> factor;     // > 0, one for each angle
};

// The lamp's tilt (rad, [0, pi]; geometry 2: [0, pi/2]) in a luminaire whose axes are the columns.
double lamp_tilt_rad(const LampTilt& tilt, const glm::dmat3& world_from_luminaire);

// Whether the table holds this angle. One that lists angles >= 0 only, or up to 90 degrees only,
// says nothing of others.
bool covers(const LampTilt& tilt, double tilt_rad);

// Linear between the angles; the factor of the nearest one outside of them.
double tilt_factor(const LampTilt& tilt, double tilt_rad);

}  // namespace calc
