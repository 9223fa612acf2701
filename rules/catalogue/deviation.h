#pragma once
// Aspects in which a plane may differ from the plane that a standard's number is about.

#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/scene/waiver.h"

#include <optional>
#include <string>

namespace rules {

using calc::Waiver;

enum class FitAspect {
  orientation,  // it faces another way
  place,        // it lies on no wall, or not on the ceiling
  height,       // above the floor
  grid,         // its points are fewer than the standard's, or a list
  margin,       // it leaves out more along its edges
  points,       // too many of its points were left out
};

// A deviation found on a plane; if the project states it, the number is compared all the same.
struct Deviation {
  FitAspect aspect = FitAspect::grid;
  calc::Message words;           // what differs, e.g. "1 x 1 points, where ..."
  std::optional<Waiver> stated;  // who lives with it, and until when
  bool is_accepted = false;      // stated, and the last day is not over
};

// A deviation that a project states, whether it is found or not.
struct StatedDeviation {
  FitAspect aspect = FitAspect::grid;
  Waiver by;
};

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::FitAspect> {
  static constexpr EnumName<rules::FitAspect> list[] = {
      {rules::FitAspect::orientation, "orientation"}, {rules::FitAspect::place, "place"},
      {rules::FitAspect::height, "height"},           {rules::FitAspect::grid, "grid"},
      {rules::FitAspect::margin, "margin"},           {rules::FitAspect::points, "points"}};
};

}  // namespace calc
