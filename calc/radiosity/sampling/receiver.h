#pragma once
// Points that receive light, and their quantities.

#include "calc/radiosity/terms/connection_terms.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>

namespace calc {

// A receiver in local coordinates. Every quantity is a weighted integral of radiance L over
// directions w,
//   E = integral k(w) L(w) dw,
// so that kernels differ only in k: response_times_distance() is k.
struct Receiver {
  glm::dvec3 position_m;
  glm::dvec3 axis;  // unit, see ReceiverKernel
  ReceiverKernel kernel = ReceiverKernel::planar;
};

// Returns whether light cannot come from one side, as for a plane.
inline bool has_back(ReceiverKernel kernel) { return kernel == ReceiverKernel::planar; }

}  // namespace calc
