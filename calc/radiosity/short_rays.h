#pragma once
// The seam between the near field and whatever finds what the first short rays meet: CPU in
// near_field.cpp, point by point, or OpenGL in gpu/, many points at once.

#include "calc/radiosity/random.h"
#include "calc/radiosity/rays.h"
#include "calc/radiosity/receiver.h"

#include <cstdint>
#include <span>

namespace calc {

// One point's near-field part for one batch of light vertices.
struct NearFieldRequest {
  Receiver receiver;
  RandomKey key;  // of point, replicate and batch
  std::uint32_t rays;
};

// What a first ray meets: a triangle, from which side, and where on it as in
// Tracer::surface_hit(). Three words, as devices write them.
struct FirstHit {
  static constexpr std::uint32_t kNothing = 0xffff'ffff;
  static constexpr std::uint32_t kNotDone = 0xffff'fffe;
  static constexpr std::uint32_t kFromBehind = 0x8000'0000;

  std::uint32_t triangle_and_side = kNothing;  // + kFromBehind: from where the normal points away
  float u = 0.0f, v = 0.0f;
};
static_assert(sizeof(FirstHit) == 12);

// Rays of one call to ShortRayCaster::cast(): enough for a large device, 12 MiB of hits.
inline constexpr std::uint64_t kShortRaysPerCast = std::uint64_t{1} << 20;

class ShortRayCaster {
 public:
  virtual ~ShortRayCaster() = default;

  // First surfaces from least_m to most_m of all rays of all requests, one after the other, as
  // add_near_field() traces them: up to rounding, and to rays that graze an edge. hits: one per
  // ray, at most kShortRaysPerCast or one request's. Always the same bits. May be called from
  // several threads at once. May throw BackendFailure.
  virtual void cast(const Tracer& tracer, float least_m, float most_m,
                    std::span<const NearFieldRequest> requests, std::span<FirstHit> hits) = 0;
};

}  // namespace calc
