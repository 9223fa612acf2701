#pragma once
// Joins luminous openings that touch, because an eye sees them as a single source.

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

// Openings of which each touches another along a side, or nearly so: in one plane, no farther apart
// than a tenth of their shortest side.
struct JoinedOpening {
  std::vector<std::size_t> members;  // ascending, two at least
  double width_m = 0.0;  // the shorter side of the rectangle around all, along the first one's axes
};

// Largest width of luminaires in a line; glare tables are made for these, and not for ceilings.
inline constexpr double kWidestLine_m = 0.35;

// Returns groups wider than a line, without lines that meet, as in a frame along the walls. Points
// and openings without size in a direction do not join.
std::vector<JoinedOpening> joined_openings(std::span<const OpeningInPlace> openings);

// Returns the share of the smaller outline within the other, seen along the axis of `a`: 0 to 1. 0
// for points and lines, for openings of other directions, and for planes farther apart than
// kOneBehind_m, where one may hang below the other. Disks count as squares of their area.
inline constexpr double kOneBehind_m = 0.05;
double overlap_share(const OpeningInPlace& a, const OpeningInPlace& b);

}  // namespace calc
