#pragma once
// The quantities that a calculation point measures.

#include <array>
#include <cstddef>
#include <string_view>

namespace calc {

// planar: illuminance on a plane, axis = normal. cylindrical: mean over the side of a small
// cylinder about the axis. semicylindrical: over the curved half of a small upright half-cylinder,
// axis = horizontal direction it looks in. hemispherical: over a half-sphere that bulges along the
// axis. scalar: over a sphere (a quarter of the fluence rate; the axis does not matter).
enum class ReceiverKernel { planar, cylindrical, semicylindrical, hemispherical, scalar };

// Quantities of a point that need more than the illuminance of one kernel.
enum class DerivedQuantity {
  none,
  // Unified glare rating of an eye that looks along the axis, see calc/radiosity/direct/glare.h.
  // The illuminance is that of reflected light on a plane across the line of sight.
  ugr,
  // Cylindrical illuminance about the axis / illuminance of the plane across it, at the same point.
  modelling,
  // The mean of four planes along the axis, 90 degrees apart, which some programs take for the
  // cylindrical illuminance; the true integral is computed beside it.
  four_planes
};

// A quantity as project files and results write it.
struct PlaneQuantity {
  std::string_view name;
  ReceiverKernel kernel;  // of the point's first receiver
  DerivedQuantity derived;
  std::size_t receivers;  // that one point's value is made of, in the order of receivers_of()
  const char* unit;       // of its points' values; "" of ratings and ratios
  bool has_look;  // its points look in a horizontal direction, whatever the plane's normal is
};
inline constexpr std::array<PlaneQuantity, 8> kPlaneQuantities{{
    {"planar", ReceiverKernel::planar, DerivedQuantity::none, 1, "lx", false},
    {"cylindrical", ReceiverKernel::cylindrical, DerivedQuantity::none, 1, "lx", false},
    {"semicylindrical", ReceiverKernel::semicylindrical, DerivedQuantity::none, 1, "lx", true},
    {"hemispherical", ReceiverKernel::hemispherical, DerivedQuantity::none, 1, "lx", false},
    {"scalar", ReceiverKernel::scalar, DerivedQuantity::none, 1, "lx", false},
    {"ugr", ReceiverKernel::planar, DerivedQuantity::ugr, 1, "", true},
    {"modelling", ReceiverKernel::cylindrical, DerivedQuantity::modelling, 2, "", false},
    {"cylindrical-4", ReceiverKernel::cylindrical, DerivedQuantity::four_planes, 5, "lx", false},
}};

// Returns the quantity; null for pairs that no plane has.
constexpr const PlaneQuantity* find_quantity(ReceiverKernel kernel, DerivedQuantity derived) {
  for (const PlaneQuantity& quantity : kPlaneQuantities) {
    if (quantity.kernel == kernel && quantity.derived == derived) return &quantity;
  }
  return nullptr;
}

constexpr std::string_view quantity_name(ReceiverKernel kernel, DerivedQuantity derived) {
  const PlaneQuantity* found = find_quantity(kernel, derived);
  return found == nullptr ? "" : found->name;
}

constexpr bool has_look(ReceiverKernel kernel, DerivedQuantity derived) {
  const PlaneQuantity* found = find_quantity(kernel, derived);
  return found != nullptr && found->has_look;
}

// Returns the first row with it, for properties that all such rows share.
constexpr const PlaneQuantity& row_of(DerivedQuantity derived) {
  for (const PlaneQuantity& quantity : kPlaneQuantities) {
    if (quantity.derived == derived) return quantity;
  }
  return kPlaneQuantities.front();
}
constexpr std::size_t receivers_per_point(DerivedQuantity derived) {
  return row_of(derived).receivers;
}
constexpr const char* unit_of(DerivedQuantity derived) { return row_of(derived).unit; }
// Returns whether it has no unit.
constexpr bool is_plain_number(DerivedQuantity derived) { return *unit_of(derived) == '\0'; }

}  // namespace calc
