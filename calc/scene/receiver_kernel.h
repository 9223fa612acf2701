#pragma once
// What a calculation point measures.

#include <array>
#include <cstddef>
#include <string_view>

namespace calc {

// planar: illuminance on a plane, axis = normal. cylindrical: mean over the side of a small
// cylinder about the axis. semicylindrical: over the curved half of a small upright half-cylinder,
// axis = horizontal direction it looks in. hemispherical: over a half-sphere that bulges along the
// axis. scalar: over a sphere (a quarter of the fluence rate; the axis does not matter).
enum class ReceiverKernel { planar, cylindrical, semicylindrical, hemispherical, scalar };

// Results give illuminances these names, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> kReceiverKernelNames{
    "planar", "cylindrical", "semicylindrical", "hemispherical", "scalar"};

constexpr std::string_view kernel_name(ReceiverKernel kernel) {
  return kReceiverKernelNames[static_cast<std::size_t>(kernel)];
}

// What a point measures where that is more than the illuminance of one kernel.
enum class DerivedQuantity {
  none,
  // Unified glare rating of an eye that looks along the axis, see calc/radiosity/glare.h. The
  // illuminance is that of reflected light on a plane across the line of sight.
  ugr,
  // Cylindrical illuminance about the axis / illuminance of the plane across it, of one point.
  modelling,
  // The mean of four planes along the axis, 90 degrees apart, which some programs take for the
  // cylindrical illuminance; the true integral is computed beside it.
  four_planes
};

// Of one point: how many receivers its quantity is made of. Their order is that of receivers_of().
constexpr std::size_t receivers_per_point(DerivedQuantity derived) {
  switch (derived) {
    case DerivedQuantity::modelling:
      return 2;
    case DerivedQuantity::four_planes:
      return 5;
    default:
      return 1;
  }
}

// Without a unit; all else is in lx.
constexpr bool is_plain_number(DerivedQuantity derived) {
  return derived == DerivedQuantity::ugr || derived == DerivedQuantity::modelling;
}

// The points look somewhere: a horizontal direction of their own, whatever the plane's normal is.
constexpr bool has_look(ReceiverKernel kernel, DerivedQuantity derived) {
  return kernel == ReceiverKernel::semicylindrical || derived == DerivedQuantity::ugr;
}

// As project files and results write them.
struct PlaneQuantity {
  std::string_view name;
  ReceiverKernel kernel;  // of the point's first receiver
  DerivedQuantity derived;
};
inline constexpr std::array<PlaneQuantity, 8> kPlaneQuantities{{
    {"planar", ReceiverKernel::planar, DerivedQuantity::none},
    {"cylindrical", ReceiverKernel::cylindrical, DerivedQuantity::none},
    {"semicylindrical", ReceiverKernel::semicylindrical, DerivedQuantity::none},
    {"hemispherical", ReceiverKernel::hemispherical, DerivedQuantity::none},
    {"scalar", ReceiverKernel::scalar, DerivedQuantity::none},
    {"ugr", ReceiverKernel::planar, DerivedQuantity::ugr},
    {"modelling", ReceiverKernel::cylindrical, DerivedQuantity::modelling},
    {"cylindrical-4", ReceiverKernel::cylindrical, DerivedQuantity::four_planes},
}};

constexpr std::string_view quantity_name(ReceiverKernel kernel, DerivedQuantity derived) {
  for (const PlaneQuantity& quantity : kPlaneQuantities) {
    if (quantity.kernel == kernel && quantity.derived == derived) return quantity.name;
  }
  return "";
}

}  // namespace calc
