#pragma once
// Points that receive light, and what they measure.

#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace calc {

// Local coordinates. Every quantity is a weighted integral of radiance L over directions w,
//   E = integral k(w) L(w) dw,
// so that kernels differ in k alone.
struct Receiver {
  glm::dvec3 position_m;
  glm::dvec3 axis;  // unit, see ReceiverKernel
  ReceiverKernel kernel = ReceiverKernel::planar;
};

// k(w / d) d for w = light - receiver (not normalised), d = |w|. 0 for a plane that faces away.
// [EN 13201-3 for the semicylindrical kernel; DIN 5031 for the others]
template <class Vector>
inline auto response_times_distance(ReceiverKernel kernel, const Vector& axis, const Vector& w) {
  using Real = typename Vector::value_type;
  constexpr Real kPerPi = static_cast<Real>(1.0 / std::numbers::pi);
  const Real dot = glm::dot(axis, w);
  switch (kernel) {
    case ReceiverKernel::planar:
      break;
    case ReceiverKernel::cylindrical:
      return kPerPi * glm::length(glm::cross(axis, w));
    case ReceiverKernel::semicylindrical:
      // The axis points from the flat back to the round front; the cylinder stands upright.
      return kPerPi * (std::sqrt(w.x * w.x + w.y * w.y) + dot);
    case ReceiverKernel::hemispherical:
      return Real(0.25) * (glm::length(w) + dot);
    case ReceiverKernel::scalar:
      return Real(0.25) * glm::length(w);
  }
  return dot > Real(0) ? dot : Real(0);
}

// Only a plane has a side that light cannot come from.
inline bool has_back(ReceiverKernel kernel) { return kernel == ReceiverKernel::planar; }

}  // namespace calc
