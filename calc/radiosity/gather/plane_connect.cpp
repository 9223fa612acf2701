// Indirect light of a plane's tiles: connections to light vertices and the near field.
#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "calc/radiosity/gather/plane_work.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/random.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

namespace calc {
namespace {

constexpr std::uint32_t kFewestDraws = 16;
// Of a point in a surface, until its variance is known.  [measured in six examples: METHOD, 4.4]
constexpr double kDrawsPerShortRay = 4.0;
// Time of a short ray with all that hangs on it, in draws.  [measured: 170 to 300 ns and 57 ns]
constexpr double kShortRayTime = 4.0;
// Of a vertex's light around a point, reflectance for ever.
constexpr double kMostRepeated = 0.9;
constexpr double kLeastShortRays = 0.5, kMostShortRays = 8.0;
// A fine cut costs weights, a coarse one error: at 16 nodes a draw, an office of 1000 points
// reaches a given error in the least time.  [measured from 4 to 32]
constexpr std::size_t kCutNodesPerDraw = 16;
constexpr std::size_t kSmallestCut = 128;
constexpr std::size_t kLargestCut = 1024;

// Where a few points draw thousands of vertices, as many nodes as draws: beside a bright spot of a
// wall the error is then a hundredth.  [measured: ExtremeLuminaire.ThreeCentimetresFromAWall]
std::size_t cut_nodes(std::uint32_t draws) {
  return std::clamp(kCutNodesPerDraw * draws, kSmallestCut,
                    std::max<std::size_t>(kLargestCut, draws));
}

// A tile has too few short rays for a device: so many tiles send theirs together, at least. How
// many fill a cast is told from so many of them.
constexpr std::size_t kTilesPerCast = 128, kTilesLookedAt = 64;
// No more than have so many sums, 32 MiB on every thread: points times channels.
constexpr std::size_t kMostSumsPerCast = std::size_t{1} << 22;

}  // namespace

std::uint32_t draws_per_point(std::uint64_t paths, std::size_t points) {
  const std::uint64_t affordable = 16 * paths / std::max<std::size_t>(1, points);
  const std::uint64_t most = std::max<std::uint64_t>(paths / 2, kFewestDraws);
  const std::uint64_t fewest = std::max<std::uint64_t>(paths / 64, kFewestDraws);
  return static_cast<std::uint32_t>(std::bit_floor(std::clamp(affordable, fewest, most)));
}

std::uint32_t short_rays_per_point(std::uint32_t draws, double clear_m, double reach_m,
                                   double factor) {
  const double depth = 1.0 - clear_m / reach_m;
  const double rays = factor * depth * depth * depth * depth * draws / kDrawsPerShortRay;
  return std::bit_ceil(std::max(2u, static_cast<std::uint32_t>(rays)));
}

double next_short_ray_factor(double factor, double near_variance, double drawn_variance,
                             std::uint32_t draws, std::uint32_t rays) {
  if (!(near_variance > 0.0)) return std::max(kLeastShortRays, std::min(factor, 1.0));
  if (!(drawn_variance > 0.0)) return kMostShortRays;
  const double best_rays = std::sqrt(near_variance / drawn_variance * draws * rays / kShortRayTime);
  return std::clamp(factor * best_rays / rays, kLeastShortRays, kMostShortRays);
}

// Sums of one tile in one batch, [channel][receiver of the tile].
struct PlaneWork::TileSums {
  std::vector<double> lx;
  std::vector<float> largest_lx;
  std::vector<double> near_lx;  // [receiver], of lx what short rays brought, all channels

  double all_channels_lx(std::size_t receiver, std::size_t receivers) const {
    double sum = 0.0;
    for (std::size_t k = receiver; k < lx.size(); k += receivers) sum += lx[k];
    return sum;
  }
};

// Connections of tiles first..last.
std::uint64_t PlaneWork::connect_tiles(std::size_t first, std::size_t last,
                                       const VertexBatch& batch, Gatherer& gatherer,
                                       std::span<TileSums> sums) const {
  if (settings_.method == Method::instant_radiosity) {
    std::uint64_t rays = 0;
    for (std::size_t t = first; t < last; ++t) {
      if (!is_past(batch.deadline_s))
        rays += connect_all(tiles()[t], batch, gatherer, sums[t - first]);
    }
    return rays;
  }
  const std::uint32_t draws = draws_per_point(batch.paths, look_points_);
  const CutRequest cut{cut_nodes(draws), static_cast<float>(batch.near_bound->smallest()),
                       settings_.skips.allows(Skip::hidden_nodes)};
  std::vector<GatherSums> wanted;
  for (TileSums& sum : sums) {
    wanted.push_back({sum.lx.data(), sum.largest_lx.size(), sum.largest_lx.data()});
  }
  return gatherer.draw_and_gather(
      {tracer_, batch.tree, batch.bounds, cut, draws, has_shadows(), batch.deadline_s,
       draw_key_.with(batch.replicate).with(batch.first_path), tiles_, first, wanted});
}

// Every vertex once: instant radiosity.
std::uint64_t PlaneWork::connect_all(const ReceiverGroup& tile, const VertexBatch& batch,
                                     Gatherer& gatherer, TileSums& sums) const {
  thread_local std::vector<Connection> connections;
  connections.clear();
  const LightVertices& vertices = batch.tree.vertices();
  for (std::uint32_t k = 0; k < tile.point.size(); ++k) {
    for (std::uint32_t j = 0; j < vertices.size(); ++j) connections.push_back({k, j, 1.0f});
  }
  return gatherer.gather({tracer_, vertices, batch.bounds, tile.receiver, connections,
                          has_shadows(), batch.tree.identity()},
                         {sums.lx.data(), tile.point.size(), sums.largest_lx.data()});
}

// Light of the short rays of some tiles, point by point, as far as a device found it.
struct PlaneWork::ShortRays {
  bool is_found = false;      // else add_near_field() traces them itself
  std::size_t last_tile = 0;  // the first that is not among them
  ShortRayLight light{};
  std::size_t next_point = 0;

  // Of the next point that has rays.
  std::optional<PointLight> next() {
    if (!is_found) return std::nullopt;
    return light.of(next_point++);
  }
};

RandomKey PlaneWork::near_key(const VertexBatch& batch) const {
  return near_key_.with(batch.replicate).with(batch.first_path);
}

std::uint32_t PlaneWork::short_rays_of(std::uint32_t point, const VertexBatch& batch) const {
  const double clear_m = settings_.skips.allows(Skip::clear_distance) ? sums_.clear_m[point] : 0.0;
  if (!(clear_m < reach_m_)) return 0;
  return short_rays_per_point(draws_per_point(batch.paths, look_points_), clear_m, reach_m_,
                              sums_.short_ray_factor[point]);
}

NearField PlaneWork::near_field(const VertexBatch& batch) const {
  return {tracer_,    *batch.near_bound, batch.luminaires,
          batch.tree, batch.bounds,      batch.global_cut,
          channels(), batch.deadline_s,  batch.has_endless_chain};
}

// Of all these tiles, or of so many that their rays fill a cast.
PlaneWork::ShortRays PlaneWork::cast_short_rays(std::size_t first_tile, std::size_t last_tile,
                                                const VertexBatch& batch) const {
  ShortRays result;
  result.last_tile = last_tile;
  result.is_found = batch.short_rays != nullptr && reach_m_ > 0.0;
  if (!result.is_found) return result;
  std::vector<PointRays> points;
  std::vector<std::size_t> first_ray{0};  // of each point
  for (std::size_t t = first_tile; t < last_tile; ++t) {
    if (first_ray.back() >= kShortRaysPerCast) {
      result.last_tile = t;
      break;
    }
    const std::size_t before = tiles_.receivers_before(t);
    for (std::size_t k = 0; k < tiles()[t].point.size(); ++k) {
      const std::uint32_t rays = short_rays_of(tiles()[t].point[k], batch);
      if (rays == 0) continue;
      points.push_back({static_cast<std::uint32_t>(before + k), rays});
      first_ray.push_back(first_ray.back() + rays);
    }
  }
  const NearField field = near_field(batch);
  for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
    for (last = first + 1; last < points.size(); ++last) {
      if (first_ray[last + 1] - first_ray[first] > kShortRaysPerCast) break;
    }
    batch.short_rays->find_light(
        field, {tiles_, near_key(batch), std::span(points).subspan(first, last - first)},
        result.light);
  }
  return result;
}

std::uint64_t PlaneWork::add_near(const ReceiverGroup& tile, const VertexBatch& batch,
                                  ShortRays& short_rays, TileSums& sums) const {
  const NearField field = near_field(batch);
  std::uint64_t rays = 0;
  for (std::size_t k = 0; k < tile.point.size(); ++k) {
    const std::uint32_t point = tile.point[k];
    const NearFieldRequest request{tile.receiver[k], near_key(batch).with(point),
                                   short_rays_of(point, batch)};
    if (request.rays == 0) continue;
    const double drawn_lx = sums.all_channels_lx(k, tile.point.size());
    rays += add_near_field(field, request, short_rays.next(), &sums.lx[k], tile.point.size(),
                           sums.largest_lx[k]);
    sums.near_lx[k] = sums.all_channels_lx(k, tile.point.size()) - drawn_lx;
  }
  return rays;
}

// Whose short rays fill a device's cast, if a thread has so many. Every cast costs dozens of
// commands, whatever its size.
std::size_t PlaneWork::tiles_per_cast(const VertexBatch& batch, std::size_t tiles_each) const {
  if (batch.short_rays == nullptr) return 1;
  const std::size_t apart = std::max<std::size_t>(1, tiles().size() / kTilesLookedAt);
  std::uint64_t rays = 0, sums = 0, looked_at = 0;
  for (std::size_t t = 0; t < tiles().size(); t += apart) {
    ++looked_at;
    sums += channels() * tiles()[t].point.size();
    for (const std::uint32_t point : tiles()[t].point) rays += short_rays_of(point, batch);
  }
  if (rays == 0) return kTilesPerCast;
  const std::uint64_t wanted = kShortRaysPerCast - kShortRaysPerCast / 16;  // a little less
  const std::size_t most = std::min<std::size_t>(tiles_each, kMostSumsPerCast * looked_at / sums);
  return std::clamp<std::size_t>(wanted * looked_at / rays, kTilesPerCast,
                                 std::max(kTilesPerCast, most));
}

// Results do not depend on it.
std::size_t PlaneWork::tiles_per_task(const VertexBatch& batch, const Gatherer& gatherer) const {
  const std::uint32_t draws = draws_per_point(batch.paths, look_points_);
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t tiles_each = tiles().size() * field_.replicates / threads;
  const std::size_t wanted = gatherer.tiles_per_batch(
      {draws, cut_nodes(draws), look_points_ / tiles().size(), tiles_each});
  return std::max(wanted, tiles_per_cast(batch, tiles_each));
}

void PlaneWork::connect(const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times) {
  std::atomic<std::uint64_t> connection_rays{0}, near_rays{0};
  std::atomic<double> connect_s{0.0}, near_s{0.0};
  if (tiles().empty()) return;
  // A thread that waits here must not take up another replicate, whose pool would add to memory.
  tbb::this_task_arena::isolate([&] {
    const tbb::blocked_range<std::size_t> all(0, tiles().size(), tiles_per_task(batch, gatherer));
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
      const FlushDenormals flush;
      if (is_past(batch.deadline_s)) return;
      std::vector<TileSums> sums(range.size());
      for (std::size_t t = range.begin(); t < range.end(); ++t) {
        const std::size_t count = tiles()[t].point.size();
        sums[t - range.begin()].lx.assign(channels() * count, 0.0);
        sums[t - range.begin()].largest_lx.assign(count, 0.0f);
        sums[t - range.begin()].near_lx.assign(count, 0.0);
      }
      const double begin_s = now_s();
      connection_rays += connect_tiles(range.begin(), range.end(), batch, gatherer, sums);
      const double middle_s = now_s();
      for (std::size_t first = range.begin(); first < range.end();) {
        ShortRays short_rays = cast_short_rays(first, range.end(), batch);
        for (std::size_t t = first; t < short_rays.last_tile; ++t) {
          TileSums& sum = sums[t - range.begin()];
          if (is_past(batch.deadline_s)) return;
          if (reach_m_ > 0.0) {
            near_rays += add_near(tiles()[t], batch, short_rays, sum);
          }
          store(tiles()[t], batch, sum);
        }
        first = short_rays.last_tile;
      }
      near_s += now_s() - middle_s;
      connect_s += middle_s - begin_s;
    });
  });
  sums_.connection_rays[batch.replicate] += connection_rays;
  sums_.near_rays[batch.replicate] += near_rays;
  times.connect_s += connect_s;
  times.near_s += near_s;
}

void PlaneWork::take_shared(const VertexBatch& batch, const GatherSums& sums, std::uint64_t pairs) {
  std::size_t first = 0;
  for (const ReceiverGroup& tile : tiles()) {
    const std::size_t count = tile.point.size();
    TileSums part;
    for (std::size_t c = 0; c < channels(); ++c) {
      const double* lx = sums.lx + c * sums.stride + first;
      part.lx.insert(part.lx.end(), lx, lx + count);
    }
    part.largest_lx.assign(sums.largest_lx + first, sums.largest_lx + first + count);
    part.near_lx.assign(count, 0.0);
    store(tile, batch, part);
    first += count;
  }
  sums_.connection_rays[batch.replicate] += pairs;
}

void PlaneWork::store(const ReceiverGroup& tile, const VertexBatch& batch, const TileSums& sums) {
  const std::size_t count = tile.point.size();
  const auto paths = static_cast<double>(batch.paths);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = tile.point[k];
    for (std::size_t c = 0; c < channels(); ++c) {
      sums_.indirect_sum_lx[(batch.replicate * channels() + c) * points() + i] +=
          paths * sums.lx[c * count + k];
    }
    const std::size_t at = batch.replicate * points() + i;
    look_near_lx_[at] = sums.near_lx[k];
    look_drawn_lx_[at] = sums.all_channels_lx(k, count) - sums.near_lx[k];
    float& largest = sums_.largest_sum_lx[at];
    largest = std::max(largest, static_cast<float>(paths) * sums.largest_lx[k]);
  }
}

// What this look measured decides how many rays the next one has; all replicates of a look have
// the same number, so that they stay independent and alike.
void PlaneWork::share_short_rays(std::uint64_t batch_paths) {
  const std::uint32_t draws = draws_per_point(batch_paths, look_points_);
  std::vector<double> at_point(field_.replicates);
  const auto variance = [&](const std::vector<double>& values_lx, std::size_t i) {
    for (std::size_t r = 0; r < field_.replicates; ++r) at_point[r] = values_lx[r * points() + i];
    const double error = replicate_mean(at_point).standard_error;
    return error * error;
  };
  for (const ReceiverGroup& tile : tiles()) {
    for (const std::uint32_t i : tile.point) {
      const double clear_m = settings_.skips.allows(Skip::clear_distance) ? sums_.clear_m[i] : 0.0;
      if (!(clear_m < reach_m_)) continue;
      double& factor = sums_.short_ray_factor[i];
      factor =
          next_short_ray_factor(factor, variance(look_near_lx_, i), variance(look_drawn_lx_, i),
                                draws, short_rays_per_point(draws, clear_m, reach_m_, factor));
    }
  }
}

// Times the paths of the look. No vertex is nearer than the point is clear. What stands near a
// point is near the surfaces around it, too, and comes from them once more by short rays.
double PlaneWork::possible_sample_lx(std::size_t point) const {
  const double most = possible_vertex_.most_per_m2,
               clear_m = sums_.clear_m.empty() ? 0.0 : sums_.clear_m[point];
  const double geometry = clear_m * clear_m * most > 1.0 ? 1.0 / (clear_m * clear_m) : most;
  const double vertex_lx = possible_vertex_.flux_lm * geometry / kPi;
  if (!(clear_m < reach_m_)) return vertex_lx;
  return vertex_lx / (1.0 - std::min(possible_vertex_.mean_reflectance, kMostRepeated));
}

void PlaneWork::finish_look(std::uint64_t batch_paths) {
  for (std::size_t i = 0; i < points(); ++i) {
    if (state_.active()[i] == 0) continue;
    sums_.paths[i] += batch_paths;
    if (has_indirect_[i] != 0) {
      sums_.possible_sample_lx[i] = std::max(sums_.possible_sample_lx[i], possible_sample_lx(i));
    }
  }
  if (reach_m_ > 0.0) share_short_rays(batch_paths);
  SolveCounters& counters = field_.counters;
  counters.paths += batch_paths * field_.replicates;
  counters.connection_rays =
      std::accumulate(sums_.connection_rays.begin(), sums_.connection_rays.end(), std::uint64_t{0});
  counters.near_rays =
      std::accumulate(sums_.near_rays.begin(), sums_.near_rays.end(), std::uint64_t{0});
}

}  // namespace calc
