#pragma once
// The seam between the near field and whatever finds what the first short rays meet, and the light
// there: CPU in near_field.cpp, point by point, or OpenGL in gpu/, many points at once.

#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/radiosity/sampling/tiles.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

struct NearField;

// One point's near-field part for one batch of light vertices.
struct NearFieldRequest {
  Receiver receiver;
  RandomKey key;  // of point, replicate and batch
  std::uint32_t rays;
};

// Short rays of a point: which of all that the tiles have, in their order.
struct PointRays {
  std::uint32_t receiver, rays;
};

// Of some points of a plane, for one replicate and batch of light vertices.
struct NearFieldBatch {
  const ReceiverTiles& tiles;
  RandomKey key;                      // of all; a point's is key.with(its index in the plane)
  std::span<const PointRays> points;  // in order of receivers, each with rays
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

// Vertices that continue a short ray's hit. The mean over many rays smooths their noise.
inline constexpr std::uint32_t kFarDraws = 4;

// What a first ray's hit gave: the first step of its chain (see add_near_field()), but for what
// only the CPU can finish. Words of 4 bytes, as devices write them, each kNotDone before.
//
// A ray is left to the CPU so if a luminaire is too near, or if its chain goes on for longer than
// devices follow it.
struct HitLight {
  // In place of a number: nothing, without a ray; a ray, but something stood between.
  static constexpr std::uint32_t kNothing = FirstHit::kNothing, kNotDone = FirstHit::kNotDone;
  static constexpr std::uint32_t kHidden = 0xffff'fffd;
  // The CPU has to ask the luminaire: too near for a device.
  static constexpr std::uint32_t kLeft = 0xffff'fffc;

  // One of the vertices that the hit's light from afar is drawn from.
  struct Draw {
    std::uint32_t channel;  // the vertex's; kNothing, kHidden
    float lm_per_m2;        // of the vertex, with its weight
  };

  // On a triangle, as in FirstHit, but not rounded: what hangs on it is compared with the CPU's.
  struct Place {
    double u, v;
  };

  std::uint32_t triangle_and_side;  // as FirstHit's
  std::uint32_t request, ray;       // number of the point in ShortRayLight, of the ray at the point
  std::uint32_t luminaire;          // asked for direct light; kNothing, kHidden, kLeft
  Place place;
  double weight;     // of all light from there; 0: none, and nothing below is said
  double direct_lx;  // from that luminaire, with the weight
  // What the further ray meets; kNothing: the chain ends.
  Place next_place;
  std::uint32_t next_triangle_and_side;
  std::array<Draw, kFarDraws + 1> draws;  // one more: rounding may let it in
  std::uint32_t unused;
};
static_assert(sizeof(HitLight) == 112);

// Light that the short rays of one point brought, as a device found it.
struct PointLight {
  std::span<const double> lx;  // [channel]; of rays that are left to the CPU nothing
  float largest_lx;            // of one ray, all channels; of those that are not left
  std::uint32_t rays;          // traced for them, without the first ones
  std::span<const HitLight> left;
};

// The same of points one after the other.
struct ShortRayLight {
  std::size_t channels = 0;
  std::vector<double> lx;  // [point][channel]
  std::vector<float> largest_lx;
  std::vector<std::uint32_t> rays;
  std::vector<HitLight> left;  // in the order of points (HitLight::request), then of rays

  std::size_t points() const { return rays.size(); }
  PointLight of(std::size_t point) const;
};

// Rays of one call to ShortRayCaster: enough for a large device. Where all of them meet what may
// give light and all is left to the CPU, in a white corner, 28 MiB of HitLight for each thread.
// Beside them 8 bytes for each point, which has two rays and more, and channel.
inline constexpr std::uint64_t kShortRaysPerCast = std::uint64_t{1} << 18;

class ShortRayCaster {
 public:
  virtual ~ShortRayCaster() = default;

  // First surfaces from least_m to most_m of all rays of all points, one after the other, as
  // add_near_field() traces them: up to rounding, and to rays that graze an edge. hits: one per
  // ray, at most kShortRaysPerCast or one point's. Always the same bits. May be called from
  // several threads at once. May throw BackendFailure.
  virtual void cast(const Tracer& tracer, float least_m, float most_m, const NearFieldBatch& batch,
                    std::span<FirstHit> hits) = 0;

  // The same rays within the reach of the field's bound, and the light at their hits: appends the
  // points of the batch, of the field's channels. What a point gets is a function of its rays
  // alone. Past the field's deadline what is there is worth nothing.
  virtual void find_light(const NearField& field, const NearFieldBatch& batch,
                          ShortRayLight& found) = 0;
};

}  // namespace calc
