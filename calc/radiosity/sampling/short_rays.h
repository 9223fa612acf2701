#pragma once
// Interface between the near field and the code that finds the first hits of short rays, and the
// light there: CPU in near_field.cpp, point by point, or OpenGL in gpu/, many points at once.

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

// A point's near-field part for one batch of light vertices.
struct NearFieldRequest {
  Receiver receiver;
  RandomKey key;  // of point, replicate and batch
  std::uint32_t rays;
};

// The short rays of a point, identified by its place among all receivers of the tiles.
struct PointRays {
  std::uint32_t receiver, rays;
};

// Short rays of some points of a plane, for one replicate and batch of light vertices.
struct NearFieldBatch {
  const ReceiverTiles& tiles;
  RandomKey key;                      // of all; a point's is key.with(its index in the plane)
  std::span<const PointRays> points;  // in order of receivers, each with rays
};

// The first hit of a ray: a triangle, its side, and the place on it as in Tracer::surface_hit().
// Three words, as devices write them.
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

// The light at a first ray's hit: the first step of its chain (see add_near_field()), except for
// the part that only the CPU can finish. Words of 4 bytes, as devices write them, each kNotDone
// before.
//
// This part is left to the CPU if a luminaire is too near, or if the chain is longer than devices
// follow.
struct HitLight {
  // Values instead of a number: kNothing: no ray; kHidden: a ray that was blocked.
  static constexpr std::uint32_t kNothing = FirstHit::kNothing, kNotDone = FirstHit::kNotDone;
  static constexpr std::uint32_t kHidden = 0xffff'fffd;
  // The CPU has to evaluate the luminaire, which is too near for a device.
  static constexpr std::uint32_t kLeft = 0xffff'fffc;

  // One of the vertices drawn for the hit's light from afar.
  struct Draw {
    std::uint32_t channel;  // the vertex's; kNothing, kHidden
    float lm_per_m2;        // of the vertex, with its weight
  };

  // A place as in FirstHit, but not rounded, because its results are compared with the CPU's.
  struct Place {
    double u, v;
  };

  std::uint32_t triangle_and_side;  // as FirstHit's
  std::uint32_t request, ray;       // number of the point in ShortRayLight, of the ray at the point
  std::uint32_t luminaire;          // asked for direct light; kNothing, kHidden, kLeft
  Place place;
  double weight;     // of all light from there; 0: none, and nothing below is said
  double direct_lx;  // from that luminaire, with the weight
  // The hit of the further ray; kNothing: the chain ends.
  Place next_place;
  std::uint32_t next_triangle_and_side;
  std::array<Draw, kFarDraws + 1> draws;  // one more: rounding may let it in
  std::uint32_t unused;
};
static_assert(sizeof(HitLight) == 112);

// Light of the short rays of one point, as a device found it.
struct PointLight {
  std::span<const double> lx;  // [channel]; of rays that are left to the CPU nothing
  float largest_lx;            // of one ray, all channels; of those that are not left
  std::uint32_t rays;          // traced for them, without the first ones
  std::span<const HitLight> left;
};

// The same for points one after the other.
struct ShortRayLight {
  std::size_t channels = 0;
  std::vector<double> lx;  // [point][channel]
  std::vector<float> largest_lx;
  std::vector<std::uint32_t> rays;
  std::vector<HitLight> left;  // in the order of points (HitLight::request), then of rays

  std::size_t points() const { return rays.size(); }
  PointLight of(std::size_t point) const;
};

// Rays of one call to ShortRayCaster: enough for a large device. If all of them meet surfaces that
// may give light and all are left to the CPU, in a white corner, each thread needs 28 MiB of
// HitLight, and 8 bytes for each channel and point, which has two rays and more.
inline constexpr std::uint64_t kShortRaysPerCast = std::uint64_t{1} << 18;

class ShortRayCaster {
 public:
  virtual ~ShortRayCaster() = default;

  // Finds the first surfaces from least_m to most_m of all rays of all points, one after the other,
  // as add_near_field() traces them: up to rounding, and to rays that graze an edge. hits: one per
  // ray, at most kShortRaysPerCast or one point's. Always the same bits. May be called from several
  // threads at once. May throw BackendFailure.
  virtual void cast(const Tracer& tracer, float least_m, float most_m, const NearFieldBatch& batch,
                    std::span<FirstHit> hits) = 0;

  // Finds the same rays' light within the reach of the field's bound: appends the points of the
  // batch, of the field's channels. A point's result depends only on its rays. Past the field's
  // deadline the results are useless.
  virtual void find_light(const NearField& field, const NearFieldBatch& batch,
                          ShortRayLight& found) = 0;
};

}  // namespace calc
