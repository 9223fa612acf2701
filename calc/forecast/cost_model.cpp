#include "calc/forecast/cost_model.h"

#include "calc/radiosity/gather/plane_work.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace calc {
namespace {

// Nanoseconds of one thread, as kConnection_ns. Measured on one core of a shared AMD Zen 5 in the
// examples and the projects of tests/bench/users_projects.py: 20 of 23 take 0.6 to 1.5 times what
// is predicted, three of 0.1 to 15 ms a half or less. Other machines differ by a factor:
// --explain-cost shows it.
constexpr double kPoolRay_ns = 480.0;          // closest hit, sampling, and sorting of the vertex
constexpr double kConnectionShadow_ns = 25.0;  // the part of a connection that a convex space saves
constexpr double kShortRay_ns = 300.0;         // with the light at its end
constexpr double kDirectRay_ns = 300.0;        // photometry and shadow ray
constexpr double kDirectShadow_ns = 20.0;
constexpr double kKnownOpening_ns = 350.0;  // proof, a few places of its light
constexpr double kKnownRest_ns = 400.0;     // samples of what is left of all of them, a replicate's
constexpr double kObstructed_ns = 800.0;    // search for what hides it, or may
constexpr double kPrepare_ns_per_triangle = 1200.0;  // the tree
constexpr double kPrepare_s = 0.0004;                // its device

// Connections that face each other; the others need no ray.
constexpr double kVisibleShare = 0.9;

constexpr double kBytesPerVertex = 230.0;    // with sorting keys and the tree
constexpr double kBytesPerTriangle = 600.0;  // with its share of the tree, while it is built
// Sums and published values, direct and indirect.
constexpr double kBytesPerResult = 4.0 * sizeof(double);

// Short rays of a point in one batch, at a third of the reach from the nearest surface.
double short_rays(std::uint32_t draws) { return short_rays_per_point(draws, 1.0 / 3.0, 1.0); }

}  // namespace

int thread_count(const RadiositySettings& settings) {
  if (settings.jobs > 0) return settings.jobs;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

Prediction predict(const SpaceWorkload& space, const std::vector<std::uint64_t>& paths,
                   const RadiositySettings& settings, int threads) {
  Prediction result;
  Work& work = result.work;
  const double replicates = settings.replicates;
  const double ns = 1.0e-9 / threads;
  std::uint64_t pool_paths = 0, largest_batch = 0;
  for (std::size_t p = 0; p < space.planes.size(); ++p) {
    const PlaneWorkload& plane = space.planes[p];
    const double direct_rays = plane.exact_direct_rays + plane.sampled_direct_rays;
    const double traced = plane.is_unobstructed ? 0.0 : 1.0;
    work.direct_rays += traced * direct_rays;
    work.opening_pairs += plane.known_openings + plane.obstructed_openings;
    result.seconds.direct += ns * (kKnownOpening_ns * plane.known_openings +
                                   kKnownRest_ns * replicates * plane.known_points +
                                   kObstructed_ns * plane.obstructed_openings);
    result.seconds.direct += ns * (kDirectRay_ns - (1.0 - traced) * kDirectShadow_ns) * direct_rays;
    result.bytes += kBytesPerResult * replicates * static_cast<double>(space.channels) *
                    static_cast<double>(plane.points);
    if (plane.seeing_points == 0) continue;
    pool_paths = std::max(pool_paths, paths[p]);
    const bool is_pool = settings.method == Method::light_pool;
    for (std::uint64_t done = 0, total = settings.first_paths; total <= paths[p]; total *= 2) {
      const std::uint64_t batch = total - done;  // a look traces only new paths
      largest_batch = std::max(largest_batch, batch);
      const std::uint32_t draws = draws_per_point(batch, plane.points);
      // A pool without vertices has nothing to draw.
      const double vertices = static_cast<double>(batch) * space.vertices_per_path;
      const double connections = is_pool && vertices > 0.0 ? static_cast<double>(draws) : vertices;
      const double rays =
          replicates * static_cast<double>(plane.seeing_points) * connections * kVisibleShare;
      work.connection_rays += traced * rays;
      result.seconds.connect +=
          ns * (kConnection_ns - (1.0 - traced) * kConnectionShadow_ns) * rays;
      if (is_pool) {
        work.near_rays += replicates * plane.near_points * kRaysPerShortRay * short_rays(draws);
      }
      done = total;
    }
  }
  work.light_paths = static_cast<double>(pool_paths) * replicates;
  work.pool_rays = work.light_paths * space.rays_per_path;

  const auto triangles = static_cast<double>(space.triangles);
  result.seconds.prepare = kPrepare_s + 1.0e-9 * kPrepare_ns_per_triangle * triangles;
  result.seconds.pool = ns * kPoolRay_ns * work.pool_rays;
  result.seconds.near_field = ns * kShortRay_ns * work.near_rays;
  result.bytes += kBytesPerTriangle * triangles + kBytesPerVertex * space.vertices_per_path *
                                                      static_cast<double>(largest_batch) *
                                                      std::min(threads, settings.replicates);
  return result;
}

}  // namespace calc
