#include "calc/forecast/drawing_cost.h"

#include "calc/forecast/device_cost.h"

#include <algorithm>

namespace calc {
namespace {

// Nanoseconds for each. What does not depend on the device is left out: light, colours, files, sums
// of shadow maps.
struct DrawingTimes {
  double room = 0;  // whatever its size
  double pixel = 0, triangle = 0;
  double map_texel = 0, map_triangle = 0, lookup = 0;

  double seconds(const DrawingWork& work) const {
    return 1e-9 * (room * work.rooms + pixel * work.pixels + triangle * work.triangles +
                   map_texel * work.map_texels + map_triangle * work.map_triangles +
                   lookup * work.lookups);
  }
};

// Mesa 22.3 with LLVM 15 on one core of a shared AMD Zen 5, processor time.  [measured: rooms of
// five examples; grids of 2 to 200,000 triangles; maps of 16 to 256 texels in rooms of 12 to 4,800
// triangles]
constexpr DrawingTimes kByOneThread{1e7, 3.0, 90.0, 0.1, 150.0, 0.0};
constexpr DrawingTimes kByAllThreads{4e7, 9.0, 200.0, 3.7, 50.0, 250.0};
constexpr double kMostSoftwareThreads = 16.0;  // as its makers have it
// The context, and 50 ms to compile what draws the first room, every time.
constexpr double kSoftwareOpen_s = 0.09;

// Hardware: assumed, the slower end of what such devices are known for.
constexpr DrawingTimes kByHardware{5e6, 0.5, 2.0, 0.2, 1.0, 1.0};
constexpr double kPixelDown_bytes = 8.0, kLookupDown_bytes = 4.0;

constexpr double kFaces = 5.0;  // of a shadow map

}  // namespace

void DrawingWork::add_shadow_maps(const Prediction& prediction, const SpaceWorkload& space,
                                  double texels) {
  const double maps = prediction.work.light_paths * space.vertices_per_path;
  bool has_shadows = false;
  for (const PlaneWorkload& plane : space.planes) {
    const auto points = static_cast<double>(plane.seeing_points);
    lookups += maps * points;
    has_shadows = has_shadows || (points > 0.0 && !plane.is_unobstructed);
  }
  if (!has_shadows) return;
  map_texels += maps * kFaces * texels * texels;
  map_triangles += maps * kFaces * static_cast<double>(space.triangles);
}

DrawingCost weigh_drawing(const DrawingWork& work, const DeviceRates& rates, int threads) {
  DrawingCost cost;
  cost.software_s = kSoftwareOpen_s + kByOneThread.seconds(work) +
                    kByAllThreads.seconds(work) / std::min<double>(threads, kMostSoftwareThreads);
  cost.open_s = rates.open_s;
  cost.hardware_s =
      cost.open_s + kByHardware.seconds(work) +
      (kPixelDown_bytes * work.pixels + kLookupDown_bytes * work.lookups) / rates.down_bytes_per_s;
  return cost;
}

DrawingCost weigh_ideal_drawing(const DrawingWork& work, int threads) {
  DrawingCost cost = weigh_drawing(work, kAssumedRates, threads);
  cost.open_s = cost.hardware_s = kLeastOpen_s;
  return cost;
}

bool is_hardware_to_draw(const DrawingWork& work, const DrawingCost& cost) {
  return work.rooms > kMostRoomsOnSoftware || cost.hardware_s < cost.software_s;
}

}  // namespace calc
