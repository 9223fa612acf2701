#include "calc/radiosity/node_weights.h"

// GCC makes one version of a function per instruction set and picks at start-up; without
// contraction to fused multiply-add all versions give the same bits.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LUXGATE_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define LUXGATE_WIDE
#endif

namespace calc {
namespace {

constexpr float kFloor = 0.03f;  // share of the largest kernel that every node keeps

inline float larger(float a, float b) { return a > b ? a : b; }
inline float smaller(float a, float b) { return a < b ? a : b; }

}  // namespace

LUXGATE_WIDE void weigh_planar(const CutArrays& cut, const float p[3], const float n[3],
                               float* __restrict__ out) {
  const std::size_t nodes = cut.nodes;
  const float px = p[0], py = p[1], pz = p[2];
  const float ax = n[0], ay = n[1], az = n[2];
  const float* __restrict__ r2 = cut.radius2_m2;
  const float* __restrict__ bound = cut.bound_per_m2;
  for (std::size_t c = 0; c < nodes; ++c) {
    const float dx = cut.centre_x[c] - px, dy = cut.centre_y[c] - py, dz = cut.centre_z[c] - pz;
    const float distance = __builtin_sqrtf(dx * dx + dy * dy + dz * dz);
    const float gap = larger(distance - __builtin_sqrtf(r2[c]), 0.0f);
    out[c] = static_cast<float>(kRepresentatives) * kFloor * smaller(1.0f / (gap * gap + 1e-12f), bound[c]);
  }
  for (std::size_t m = 0; m < kRepresentatives; ++m) {
    const float* __restrict__ x = cut.x + m * nodes, * __restrict__ y = cut.y + m * nodes, * __restrict__ z = cut.z + m * nodes, * __restrict__ nx = cut.nx + m * nodes, * __restrict__ ny = cut.ny + m * nodes, * __restrict__ nz = cut.nz + m * nodes;
    for (std::size_t c = 0; c < nodes; ++c) {
      const float dx = x[c] - px, dy = y[c] - py, dz = z[c] - pz;
      const float cx = larger(ax * dx + ay * dy + az * dz, 0.0f);
      const float cy = larger(-(nx[c] * dx + ny[c] * dy + nz[c] * dz), 0.0f);
      const float d2 = dx * dx + dy * dy + dz * dz + r2[c] + 1e-12f;
      out[c] += smaller(cx * cy / (d2 * d2), bound[c]);
    }
  }
  for (std::size_t c = 0; c < nodes; ++c) out[c] *= cut.flux_lm[c];
}

LUXGATE_WIDE void weigh_round(const CutArrays& cut, const float p[3], float* __restrict__ out) {
  const std::size_t nodes = cut.nodes;
  const float px = p[0], py = p[1], pz = p[2];
  const float* __restrict__ r2 = cut.radius2_m2;
  const float* __restrict__ bound = cut.bound_per_m2;
  for (std::size_t c = 0; c < nodes; ++c) {
    const float dx = cut.centre_x[c] - px, dy = cut.centre_y[c] - py, dz = cut.centre_z[c] - pz;
    const float distance = __builtin_sqrtf(dx * dx + dy * dy + dz * dz);
    const float gap = larger(distance - __builtin_sqrtf(r2[c]), 0.0f);
    out[c] = static_cast<float>(kRepresentatives) * kFloor * smaller(1.0f / (gap * gap + 1e-12f), bound[c]);
  }
  for (std::size_t m = 0; m < kRepresentatives; ++m) {
    for (std::size_t c = 0; c < nodes; ++c) {
      const std::size_t k = m * nodes + c;
      const float dx = cut.x[k] - px, dy = cut.y[k] - py, dz = cut.z[k] - pz;
      const float cy = larger(-(cut.nx[k] * dx + cut.ny[k] * dy + cut.nz[k] * dz), 0.0f);
      const float d2 = dx * dx + dy * dy + dz * dz + r2[c] + 1e-12f;
      out[c] += smaller(cy * __builtin_sqrtf(d2) / (d2 * d2), bound[c]);
    }
  }
  for (std::size_t c = 0; c < nodes; ++c) out[c] *= cut.flux_lm[c];
}

}  // namespace calc
