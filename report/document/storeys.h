#pragma once
// Groups the rooms of a project by floor plan.

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

// Most corners of a usable outline: labels try places among all corners, and a results file may
// have any number of them.
inline constexpr std::size_t kMostPlanCorners = 2000;

struct Storeys {
  std::vector<Storey> list;                  // lowest first
  std::vector<std::size_t> overlapping;      // rooms that would cover others of their height
  std::vector<std::size_t> without_outline;  // rooms from mesh files, or with unusable outlines
  std::vector<std::size_t> outdoors;         // open spaces and roads, which have no outline
};

// Returns whether the outlines of two rooms overlap by more of the smaller one than walls and doors
// cause. Unusable outlines do not overlap.
bool overlap_in_plan(const SpacePart& a, const SpacePart& b);

// Returns the storeys. Two may have the same height if their rooms overlap, as in projects that are
// alternatives of each other; a room that is alone there is `overlapping`, because most such rooms
// are drawn around an origin of their own.
Storeys storeys_of(const ProjectPart& project);

// Returns the places of all spaces in the order of documents: by storeys, lowest first, then as
// people sort names; spaces on no storey come last.
std::vector<std::size_t> spaces_in_order(const ProjectPart& project);

}  // namespace report
