#pragma once
// Which rooms of a project share a floor plan.

#include "report/document/document.h"

#include <cstddef>
#include <vector>

namespace report {

// Rooms whose floors differ by less than kStoreyStep_m and that do not overlap in plan. Rooms are
// places in ProjectPart::spaces, ascending.
struct Storey {
  double floor_z_m = 0;  // the lowest of its floors
  std::vector<std::size_t> rooms;
};
inline constexpr double kStoreyStep_m = 1.2;

// Labels look for a place among all corners of an outline; a results file may hold any number, and
// an outline of more than these is not usable.
inline constexpr std::size_t kMostPlanCorners = 2000;

struct Storeys {
  std::vector<Storey> list;                  // lowest first
  std::vector<std::size_t> overlapping;      // rooms that would cover others of their height
  std::vector<std::size_t> without_outline;  // rooms from mesh files, or with unusable outlines
  std::vector<std::size_t> outdoors;         // open spaces and roads, which have no outline
};

// Whether the outlines of two rooms share more of the smaller one than walls and doors make.
// Outlines that are not usable share nothing.
bool overlap_in_plan(const SpacePart& a, const SpacePart& b);

// A storey may lie beside another of the same height where their rooms overlap, as in projects that
// are alternatives of each other; a room that is alone there is `overlapping`, because most such
// rooms are described around an origin of their own.
Storeys storeys_of(const ProjectPart& project);

// Places of all spaces as documents have them one after another: by storeys, lowest first, and
// there as people sort names; spaces that are on no storey come last.
std::vector<std::size_t> spaces_in_order(const ProjectPart& project);

}  // namespace report
