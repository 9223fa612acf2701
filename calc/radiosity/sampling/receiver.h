#pragma once
// Points that receive light, and what they measure.

#include "calc/radiosity/terms/connection_terms.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>

namespace calc {

// Local coordinates. Every quantity is a weighted integral of radiance L over directions w,
//   E = integral k(w) L(w) dw,
// so that kernels differ in k alone: response_times_distance() is k.
struct Receiver {
  glm::dvec3 position_m;
  glm::dvec3 axis;  // unit, see ReceiverKernel
  ReceiverKernel kernel = ReceiverKernel::planar;
};

// Only a plane has a side that light cannot come from.
inline bool has_back(ReceiverKernel kernel) { return kernel == ReceiverKernel::planar; }

}  // namespace calc
