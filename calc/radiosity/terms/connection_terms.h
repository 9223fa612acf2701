#pragma once
// Includes connection_terms.glsl as C++, in float and in double.

#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <cmath>
#include <numbers>

#define TERM inline
#define KERNEL ReceiverKernel
#define KERNEL_PLANAR ReceiverKernel::planar
#define KERNEL_CYLINDRICAL ReceiverKernel::cylindrical
#define KERNEL_SEMICYLINDRICAL ReceiverKernel::semicylindrical
#define KERNEL_HEMISPHERICAL ReceiverKernel::hemispherical
#define KERNEL_SCALAR ReceiverKernel::scalar

namespace calc {

static_assert(0.31830988618379067154 == 1.0 / std::numbers::pi);

// Argument-dependent lookup finds functions of vectors in glm.
namespace connection_terms {
using std::sqrt;

#define REAL float
#define VEC3 const glm::vec3&
#include "calc/radiosity/terms/connection_terms.glsl"
#undef REAL
#undef VEC3

#define REAL double
#define VEC3 const glm::dvec3&
#include "calc/radiosity/terms/connection_terms.glsl"
#undef REAL
#undef VEC3
}  // namespace connection_terms

using connection_terms::connection_geometry;
using connection_terms::connection_lx;
using connection_terms::lift_at;
using connection_terms::lifted_connection_geometry;
using connection_terms::response_times_distance;

}  // namespace calc

#undef TERM
#undef KERNEL
#undef KERNEL_PLANAR
#undef KERNEL_CYLINDRICAL
#undef KERNEL_SEMICYLINDRICAL
#undef KERNEL_HEMISPHERICAL
#undef KERNEL_SCALAR
