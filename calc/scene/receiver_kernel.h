#pragma once
// What a calculation point measures.

namespace calc {

// planar: illuminance on a plane, axis = normal. cylindrical: mean over the side of a small
// cylinder about the axis. semicylindrical: over the curved half of a small upright half-cylinder,
// axis = horizontal direction it looks in. hemispherical: over a half-sphere that bulges along the
// axis. scalar: over a sphere (a quarter of the fluence rate; the axis does not matter).
enum class ReceiverKernel { planar, cylindrical, semicylindrical, hemispherical, scalar };

}  // namespace calc
