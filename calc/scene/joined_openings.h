#pragma once
// Luminous openings that touch are one source to an eye, however it is cut.

#include "calc/photometry/web.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace calc {

struct OpeningInPlace {
  glm::dvec3 position_m;
  glm::dmat3 axes;  // of the luminaire: C0, C90, up
  LuminousOpening opening;
};

// Openings of which each touches another one along a side, or nearly so: in one plane, no farther
// apart than a tenth of their shortest side.
struct JoinedOpening {
  std::vector<std::size_t> members;  // ascending, two at least
  double width_m = 0.0;  // the shorter side of the rectangle around all, along the first one's axes
};

// Luminaires in a line, as tables of glare are made for, are as wide as this, and no ceiling.
inline constexpr double kWidestLine_m = 0.35;

// Those wider than a line, but for lines that meet, as in a frame along the walls. Points and what
// has no size in one direction join nothing.
std::vector<JoinedOpening> joined_openings(std::span<const OpeningInPlace> openings);

// How much of the smaller outline lies in the other one, seen along the axis of `a`: 0 to 1. 0 of
// points and lines, of openings that look another way, and of planes farther apart than
// kOneBehind_m, where one may hang below the other. Disks count as squares of their area.
inline constexpr double kOneBehind_m = 0.05;
double overlap_share(const OpeningInPlace& a, const OpeningInPlace& b);

}  // namespace calc
