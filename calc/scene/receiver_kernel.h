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

// As project files and results write them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> kReceiverKernelNames{
    "planar", "cylindrical", "semicylindrical", "hemispherical", "scalar"};

constexpr std::string_view kernel_name(ReceiverKernel kernel) {
  return kReceiverKernelNames[static_cast<std::size_t>(kernel)];
}

}  // namespace calc
