#include "calc/forecast/device_cost.h"

#include "calc/radiosity/sampling/short_rays.h"

#include <cmath>
#include <limits>

namespace calc {
namespace {

// --- what the CPU does beside the device, nanoseconds of one thread ------------------------------
// [measured on one core of a shared AMD Zen 5 by bench_gpu and bench_gpu_stages]
constexpr double kBesideReceiver_ns = 55.0;  // adding what comes back
constexpr double kBesideOpening_ns = 2.0;    // reading what is proved of it, listing samples
constexpr double kBesidePath_ns = 60.0;      // copying its vertices
constexpr double kSendPath_ns = 10.0;        // by the one thread that owns the device
constexpr double kBesideShortRay_ns = 8.0;   // with the light at its hit
constexpr double kSortVertex_ns = 45.0;
constexpr double kPackVertex_ns = 25.0;     // with its groups, by one thread
constexpr double kPackTriangle_ns = 300.0;  // the device's own tree, by one thread
// What a first short ray costs the CPU without the light at its end.
constexpr double kFirstShortRay_ns = 75.0;
// Light at hits that stays on the CPU.  [in rooms 0.1 to 0.7 of 100 hits are left]
constexpr double kLeftLight = 0.002;
constexpr double kRaysPerHit = 5.0;  // of a step  [counted]

// --- bytes, by the layouts in gpu/ ---------------------------------------------------------------
constexpr double kVertexUp_bytes = 168.0;  // with its two groups
constexpr double kVertexDown_bytes = 48.0;
// Up: 64 and a share of its tile, once for all replicates of a look.
constexpr double kReceiverUp_bytes = 5.0, kReceiverDown_bytes = 32.0;
// Of a short ray its share of what a point gets; of a hit its share of those that are left.
constexpr double kShortRayDown_bytes = 8.0, kHitDown_bytes = 16.0;
constexpr double kTriangleUp_bytes = 150.0;  // corners, surface, order, its share of the tree

// --- the device ----------------------------------------------------------------------------------
// Groups, their weights and the search for a draw's vertex, beside a connection that is given.
// Assumed.
constexpr double kDrawnOverGiven = 1.5;
// Of an opening: a ray with its photometry; a proof. In any-hit rays. Assumed.
constexpr double kRaysPerDirectRay = 3.0, kRaysPerProof = 10.0;
// Of a ray at a short ray's hit, with its share of the search for bound, luminaire and vertices,
// too.
constexpr double kRaysPerHitRay = 3.0;
constexpr double kReceiversPerPiece = 2048.0;  // 64 tiles of 32, the fewest
// Five dispatches and what is sent and set for them; reads are others' meanwhile. Assumed.
constexpr double kTripsPerPiece = 1.0;
constexpr double kPathsPerTrip = 16384.0;  // a round of a bundle of batches
// Of short rays: how many hits, their list, their light; dispatches of later steps. Assumed.
constexpr double kTripsPerCast = 5.0;

double trips(double items, double per_trip) { return std::ceil(items / per_trip); }

double known(double measured, double assumed) {
  return std::isfinite(measured) && measured > 0.0 ? measured : assumed;
}

struct Weigher {
  const DeviceWork& work;
  const DeviceRates& rates;
  double thread_s = 1e-9 / work.threads;  // of a nanosecond's work that all threads share

  double direct() const {
    const double rays =
        kRaysPerDirectRay * work.work.direct_rays + kRaysPerProof * work.work.opening_pairs;
    // The caller looks at a piece while the device has the next.
    return std::fmax(rays / rates.any_hit_per_s,
                     1e-9 * kBesideOpening_ns * (work.work.direct_rays + work.work.opening_pairs));
  }
  double pool() const {
    const double vertices = work.work.pool_rays;  // at most
    return work.work.pool_rays / rates.path_rays_per_s +
           vertices * kVertexDown_bytes / rates.down_bytes_per_s +
           rates.round_trip_s * trips(work.work.light_paths, kPathsPerTrip) +
           1e-9 * kSendPath_ns * work.work.light_paths +
           thread_s * (kBesidePath_ns * work.work.light_paths + kSortVertex_ns * vertices);
  }
  double connect() const {
    const double vertices = work.work.pool_rays;
    return kDrawnOverGiven * work.work.connection_rays / rates.any_hit_per_s +
           vertices * (1e-9 * kPackVertex_ns + kVertexUp_bytes / rates.up_bytes_per_s) +
           work.receivers * (kReceiverUp_bytes / rates.up_bytes_per_s +
                             kReceiverDown_bytes / rates.down_bytes_per_s) +
           kTripsPerPiece * rates.round_trip_s * trips(work.receivers, kReceiversPerPiece) +
           thread_s * kBesideReceiver_ns * work.receivers;
  }
  double near_field() const {
    const double first = work.work.near_rays / kRaysPerShortRay;
    const double hit_rays = (1.0 - kLeftLight) * (work.work.near_rays - first);
    const double hits = hit_rays / kRaysPerHit;
    const double light_ns =
        std::fmax(0.0, 1e9 * work.one_thread.near_field - kFirstShortRay_ns * first);
    return first / rates.closest_hit_per_s + kRaysPerHitRay * hit_rays / rates.any_hit_per_s +
           (first * kShortRayDown_bytes + hits * kHitDown_bytes) / rates.down_bytes_per_s +
           kTripsPerCast * rates.round_trip_s *
               trips(first, static_cast<double>(kShortRaysPerCast)) +
           thread_s * (kBesideShortRay_ns * first + kLeftLight * light_ns);
  }
};

}  // namespace

DeviceRates with_assumptions(const DeviceRates& measured) {
  const DeviceRates& a = kAssumedRates;
  return {known(measured.any_hit_per_s, a.any_hit_per_s),
          known(measured.closest_hit_per_s, a.closest_hit_per_s),
          known(measured.path_rays_per_s, a.path_rays_per_s),
          known(measured.up_bytes_per_s, a.up_bytes_per_s),
          known(measured.down_bytes_per_s, a.down_bytes_per_s),
          known(measured.round_trip_s, a.round_trip_s),
          known(measured.open_s, a.open_s)};
}

void DeviceWork::add(const Prediction& prediction, const SpaceWorkload& space,
                     const RadiositySettings& settings, int predicted_threads) {
  work.light_paths += prediction.work.light_paths;
  work.pool_rays += prediction.work.pool_rays;
  work.direct_rays += prediction.work.direct_rays;
  work.opening_pairs += prediction.work.opening_pairs;
  work.connection_rays += prediction.work.connection_rays;
  work.near_rays += prediction.work.near_rays;
  const double times = predicted_threads;
  one_thread.prepare += prediction.seconds.prepare;
  one_thread.direct += times * prediction.seconds.direct;
  one_thread.pool += times * prediction.seconds.pool;
  one_thread.connect += times * prediction.seconds.connect;
  one_thread.near_field += times * prediction.seconds.near_field;
  for (const PlaneWorkload& plane : space.planes) {
    receivers += static_cast<double>(plane.seeing_points) * settings.replicates;
  }
  triangles += static_cast<double>(space.triangles);
  if (settings.shadow_map_texels > 0) {
    drawing.add_shadow_maps(prediction, space, settings.shadow_map_texels);
  }
}

DeviceCost weigh_device(const DeviceWork& work, const DeviceRates& rates,
                        const DeviceStages& possible) {
  const Weigher device{work, rates};
  DeviceCost cost;
  cost.cpu = {work.one_thread.prepare, work.one_thread.direct / work.threads,
              work.one_thread.pool / work.threads, work.one_thread.connect / work.threads,
              work.one_thread.near_field / work.threads};
  cost.with_device = cost.cpu;
  const auto take = [](bool is_possible, double device_s, double& s, bool& is_taken) {
    is_taken = is_possible && device_s < s;
    if (is_taken) s = device_s;
  };
  DeviceStages& stages = cost.stages;
  take(possible.direct_light, device.direct(), cost.with_device.direct, stages.direct_light);
  take(possible.light_paths, device.pool(), cost.with_device.pool, stages.light_paths);
  take(possible.connections, device.connect(), cost.with_device.connect, stages.connections);
  take(possible.near_field, device.near_field(), cost.with_device.near_field, stages.near_field);
  if (!stages.any()) return cost;
  cost.open_s = rates.open_s;
  cost.send_s =
      work.triangles * (1e-9 * kPackTriangle_ns + kTriangleUp_bytes / rates.up_bytes_per_s);
  return cost;
}

bool is_device_worth_it(const DeviceCost& cost) {
  return cost.stages.any() && kWorthwhileGain * cost.device_s() < cost.cpu_s();
}

DeviceCost weigh_ideal_device(const DeviceWork& work, const DeviceStages& possible) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  return weigh_device(work, {kEndless, kEndless, kEndless, kEndless, kEndless, 0.0, kLeastOpen_s},
                      possible);
}

}  // namespace calc
