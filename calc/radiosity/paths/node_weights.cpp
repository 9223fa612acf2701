#include "calc/radiosity/paths/node_weights.h"

#include "calc/base/wide.h"
#include "calc/radiosity/terms/node_terms.h"

namespace calc {
LUXGATE_WIDE void weigh_planar(const CutArrays& cut, const float p[3], const float n[3],
                               float* __restrict__ out) {
  const float px = p[0], py = p[1], pz = p[2];
  const float ax = n[0], ay = n[1], az = n[2];
  const std::size_t nodes = cut.nodes;
  const float* __restrict__ flux_lm = cut.flux_lm;
  const float* __restrict__ radius_m = cut.radius_m;
  const float* __restrict__ bound_per_m2 = cut.bound_per_m2;
  const float* __restrict__ centre_x = cut.centre_x;
  const float* __restrict__ centre_y = cut.centre_y;
  const float* __restrict__ centre_z = cut.centre_z;
  const float* __restrict__ x = cut.x;
  const float* __restrict__ y = cut.y;
  const float* __restrict__ z = cut.z;
  const float* __restrict__ nx = cut.nx;
  const float* __restrict__ ny = cut.ny;
  const float* __restrict__ nz = cut.nz;
  for (std::size_t c = 0; c < nodes; ++c) {
    const float ux = centre_x[c] - px, uy = centre_y[c] - py, uz = centre_z[c] - pz;
    const float r = radius_m[c];
    const float dx = x[c] - px, dy = y[c] - py, dz = z[c] - pz;
    const float d2 = node_terms::node_softened_m2(r, dx, dy, dz);
    const float facing = node_terms::node_facing(nx[c], ny[c], nz[c], dx, dy, dz);
    const float kernel = node_terms::node_kernel_planar(d2, facing, ax, ay, az, dx, dy, dz);
    out[c] = node_terms::node_mixed(flux_lm[c], kernel, r, bound_per_m2[c], ux, uy, uz);
  }
}

LUXGATE_WIDE void weigh_round(const CutArrays& cut, const float p[3], float* __restrict__ out) {
  const float px = p[0], py = p[1], pz = p[2];
  const std::size_t nodes = cut.nodes;
  const float* __restrict__ flux_lm = cut.flux_lm;
  const float* __restrict__ radius_m = cut.radius_m;
  const float* __restrict__ bound_per_m2 = cut.bound_per_m2;
  const float* __restrict__ centre_x = cut.centre_x;
  const float* __restrict__ centre_y = cut.centre_y;
  const float* __restrict__ centre_z = cut.centre_z;
  const float* __restrict__ x = cut.x;
  const float* __restrict__ y = cut.y;
  const float* __restrict__ z = cut.z;
  const float* __restrict__ nx = cut.nx;
  const float* __restrict__ ny = cut.ny;
  const float* __restrict__ nz = cut.nz;
  for (std::size_t c = 0; c < nodes; ++c) {
    const float ux = centre_x[c] - px, uy = centre_y[c] - py, uz = centre_z[c] - pz;
    const float r = radius_m[c];
    const float dx = x[c] - px, dy = y[c] - py, dz = z[c] - pz;
    const float d2 = node_terms::node_softened_m2(r, dx, dy, dz);
    const float facing = node_terms::node_facing(nx[c], ny[c], nz[c], dx, dy, dz);
    const float kernel = node_terms::node_kernel_round(d2, facing);
    out[c] = node_terms::node_mixed(flux_lm[c], kernel, r, bound_per_m2[c], ux, uy, uz);
  }
}

LUXGATE_WIDE float sum_of(const float* values, std::size_t n) {
  float part[16] = {};
  std::size_t i = 0;
  for (; i + 16 <= n; i += 16) {
    for (std::size_t k = 0; k < 16; ++k) part[k] += values[i + k];
  }
  for (std::size_t k = 0; i < n; ++i, ++k) part[k] += values[i];
  for (std::size_t step = 8; step > 0; step /= 2) {
    for (std::size_t k = 0; k < step; ++k) part[k] += part[k + step];
  }
  return part[0];
}

}  // namespace calc
