#include "calc/planner/cost_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <thread>

namespace calc {
namespace {

// Nanoseconds of one thread. Measured on one core of a 2021 server (AVX-512, Embree 3.13, release
// build), furnished office of 840 triangles; other machines differ by a factor, scenes by another:
// --explain-cost shows it.
constexpr double kPoolRay_ns = 160.0;        // closest hit, sampling, bound, sorting of the vertex
constexpr double kConnection_ns = 60.0;      // draw, kernel, shadow ray
constexpr double kConnectionShadow_ns = 20.0;  // the part of it that a convex space saves
constexpr double kShortRay_ns = 150.0;
constexpr double kDirectRay_ns = 85.0;       // photometry and shadow ray
constexpr double kDirectShadow_ns = 20.0;
constexpr double kPrepare_ns_per_triangle = 1200.0;  // Embree's tree
constexpr double kPrepare_s = 0.001;                 // its device

constexpr std::uint64_t kDrawsPerPath = 16;
constexpr std::uint64_t kMostPathsPerDraw = 64;
constexpr std::uint64_t kFewestDraws = 16;
constexpr std::uint64_t kPathsPerNearRay = 4;
constexpr std::uint64_t kFewestNearRays = 4;

constexpr double kBytesPerVertex = 48.0;
constexpr double kBytesPerTriangle = 300.0;  // with its share of Embree's tree
// Sums and published values, direct and indirect.
constexpr double kBytesPerResult = 4.0 * sizeof(double);

std::uint64_t nearest_power_of_two(double value) {
  if (!(value > 1.0)) return 1;
  return std::uint64_t{1} << static_cast<unsigned>(std::lround(std::min(std::log2(value), 62.0)));
}

}  // namespace

std::uint64_t draws_per_point(std::uint64_t paths, std::size_t points) {
  const double wanted = static_cast<double>(kDrawsPerPath) * static_cast<double>(paths) /
                        static_cast<double>(points);
  const std::uint64_t fewest = std::max<std::uint64_t>(1, paths / kMostPathsPerDraw);
  const std::uint64_t draws = std::clamp(nearest_power_of_two(wanted), fewest,
                                         std::max(paths, fewest));
  return std::max(draws, kFewestDraws);
}

std::uint64_t near_rays_per_point(std::uint64_t paths) {
  return std::max(kFewestNearRays, paths / kPathsPerNearRay);
}

int thread_count(const RadiositySettings& settings) {
  if (settings.jobs > 0) return settings.jobs;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

Prediction predict(const SpaceWorkload& space, const std::vector<std::uint64_t>& paths,
                   const RadiositySettings& settings, int threads) {
  Prediction result;
  Work& work = result.work;
  const double replicates = settings.replicates;
  std::uint64_t pool_paths = 0, largest_batch = 0;
  for (std::size_t p = 0; p < space.planes.size(); ++p) {
    const PlaneWorkload& plane = space.planes[p];
    work.direct_rays += plane.exact_direct_rays + plane.sampled_direct_rays;
    result.bytes += kBytesPerResult * replicates * static_cast<double>(space.channels) *
                    static_cast<double>(plane.points);
    if (plane.seeing_points == 0) continue;
    pool_paths = std::max(pool_paths, paths[p]);
    const double points_times_replicates = static_cast<double>(plane.seeing_points) * replicates;
    for (std::uint64_t done = 0, total = settings.first_paths; total <= paths[p]; total *= 2) {
      const std::uint64_t batch = total - done;  // a look traces only new paths
      largest_batch = std::max(largest_batch, batch);
      const double connections =
          settings.method == Method::light_pool
              ? static_cast<double>(draws_per_point(batch, plane.seeing_points))
              : static_cast<double>(batch) * space.vertices_per_path;
      work.connection_rays += points_times_replicates * connections;
      work.near_rays += points_times_replicates * static_cast<double>(near_rays_per_point(batch));
      done = total;
    }
  }
  work.light_paths = static_cast<double>(pool_paths) * replicates;
  work.pool_rays = work.light_paths * space.rays_per_path;

  const double ns = 1.0e-9 / threads;
  const double shadow = space.is_convex ? 0.0 : 1.0;
  const double connection_ns = kConnection_ns - (1.0 - shadow) * kConnectionShadow_ns;
  const double direct_ns = kDirectRay_ns - (1.0 - shadow) * kDirectShadow_ns;
  const auto triangles = static_cast<double>(space.triangles);
  result.seconds.prepare = kPrepare_s + 1.0e-9 * kPrepare_ns_per_triangle * triangles;
  result.seconds.direct = ns * direct_ns * work.direct_rays;
  result.seconds.pool = ns * kPoolRay_ns * work.pool_rays;
  result.seconds.connect = ns * connection_ns * work.connection_rays;
  result.seconds.near_field = ns * kShortRay_ns * work.near_rays;
  result.bytes += kBytesPerTriangle * triangles +
                  kBytesPerVertex * space.vertices_per_path * static_cast<double>(largest_batch);
  return result;
}

}  // namespace calc
