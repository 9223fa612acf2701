#include "calc/radiosity/plane_work.h"

#include "calc/planner/predicates.h"
#include "calc/radiosity/direct.h"
#include "calc/radiosity/glare.h"
#include "calc/radiosity/grid_receivers.h"
#include "calc/radiosity/phase_timer.h"
#include "calc/radiosity/point_problem.h"
#include "calc/radiosity/random.h"
#include "calc/statistics.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

namespace calc {
namespace {

constexpr std::uint32_t kFewestDraws = 16;
// A fine cut costs weights, a coarse one error: at 16 nodes a draw, an office of 1000 points
// reaches a given error in the least time.  [measured from 4 to 32]
constexpr std::size_t kCutNodesPerDraw = 16;
constexpr std::size_t kSmallestCut = 128;
constexpr std::size_t kLargestCut = 1024;

// A tile has too few short rays for a device: so many tiles send theirs together, at least.
constexpr std::size_t kTilesPerCast = 128;

// Share of the indirect part's variance below which openings need no more samples.
constexpr double kNegligibleVariance = 0.1;

// Results do not depend on it.
std::size_t tiles_per_task(const VertexBatch& batch, const Gatherer& gatherer) {
  return std::max(gatherer.tiles_per_batch(), batch.short_rays != nullptr ? kTilesPerCast : 1);
}

// Runs work(i) -> rays for every point on all threads and returns the sum of rays.
template <class Work>
std::uint64_t for_each_point(std::size_t points, const Work& work) {
  std::atomic<std::uint64_t> rays{0};
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
    const FlushDenormals flush;
    rays += work(i);
  });
  return rays;
}

}  // namespace

std::uint32_t draws_per_point(std::uint64_t paths, std::size_t points) {
  const std::uint64_t affordable = 16 * paths / std::max<std::size_t>(1, points);
  const std::uint64_t most = std::max<std::uint64_t>(paths / 2, kFewestDraws);
  const std::uint64_t fewest = std::max<std::uint64_t>(paths / 64, kFewestDraws);
  return static_cast<std::uint32_t>(std::bit_floor(std::clamp(affordable, fewest, most)));
}

std::uint32_t short_rays_per_point(std::uint32_t draws, double clear_m, double reach_m) {
  const double depth = 1.0 - clear_m / reach_m;
  return std::bit_ceil(
      std::max(2u, static_cast<std::uint32_t>(depth * depth * depth * depth * draws)));
}

// Sums of one tile in one batch, [channel][receiver of the tile].
struct PlaneWork::TileSums {
  std::vector<double> lx;
  std::vector<float> largest_lx;
};

PlaneWork::PlaneWork(const Tracer& tracer, const std::string& plane_id, const SensorGrid& grid,
                     const std::vector<Beam>& beams, const RadiositySettings& settings)
    : tracer_(tracer),
      settings_(settings),
      opening_key_(stage_key(settings.seed, RandomStage::opening).with(plane_id)),
      near_key_(stage_key(settings.seed, RandomStage::near_field).with(plane_id)),
      draw_key_(stage_key(settings.seed, RandomStage::connections).with(plane_id)) {
  receiver_ = receivers_of(tracer, grid);
  is_eyes_ = grid.derived == DerivedQuantity::ugr;
  const auto replicates = static_cast<std::size_t>(settings.replicates);
  field_.plane_id = plane_id;
  field_.points = points();
  field_.replicates = replicates;
  field_.channels = tracer.scene().channels;
  field_.direct_exact_lx.assign(channels() * points(), 0.0);
  replicate_connection_rays_.assign(replicates, 0);
  replicate_near_rays_.assign(replicates, 0);
  active_.assign(points(), 1);
  rounds_.assign(points(), 0);
  paths_.assign(points(), 0);
  possible_sample_lx_.assign(points(), 0.0);
  const PreparedScene& scene = tracer.scene();
  const std::vector<glm::dvec3> local_m = local_positions_m(scene, grid);
  const PointSet set{local_m, grid.normal, grid.kernel};
  // A point's other receivers see nothing that the first one does not.
  const std::vector<std::uint8_t> sees = find_reflection_view(scene, set).sees_reflection;
  for (std::size_t part = 0; part < receivers_per_point(grid.derived); ++part) {
    sees_reflection_.insert(sees_reflection_.end(), sees.begin(), sees.end());
  }
  may_be_sampled_ = has_indirect_ = sees_reflection_;
  if (settings.skips.allows(Skip::dark_pairs) && points() > 0) {
    is_dark_ = find_dark_luminaires(scene, beams, bounds_of(set));
  }
  if (!settings.skips.allows(Skip::behind_plane)) sees_reflection_.assign(points(), 1);
  if (std::string problem = point_problem(tracer, grid, receiver_, settings.refuses_close_points);
      !problem.empty()) {
    refuse(std::move(problem));
  }
}

void PlaneWork::refuse(std::string problem) {
  is_active_ = false;
  field_.problem = std::move(problem);
}

void PlaneWork::finish(StopReason reason) {
  is_active_ = false;
  field_.stop = reason;
}

bool PlaneWork::sees_reflection() const {
  return std::find(sees_reflection_.begin(), sees_reflection_.end(), 1) != sees_reflection_.end();
}

void PlaneWork::narrow(const std::vector<std::uint8_t>& active) {
  active_ = active;
  active_.resize(points(), 1);
}

void PlaneWork::add_exact(double deadline_s, SolveTimes& times) {
  const PhaseTimer timer(times.direct_s);
  if (is_eyes_) return add_glare(deadline_s);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    return add_point_sources(tracer_, receiver_[i], {is_dark_, has_shadows_},
                             &field_.direct_exact_lx[i], points())
        .traced;
  });
}

void PlaneWork::add_glare(double deadline_s) {
  std::vector<GlareSum> sums(points() * channels());  // [point][channel]
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    return add_glare_sources(tracer_, receiver_[i], has_shadows_,
                             std::span(sums).subspan(i * channels(), channels()));
  });
  GlareField& glare = field_.glare;
  for (std::size_t c = 0; c < channels(); ++c) {
    for (std::size_t i = 0; i < points(); ++i) {
      const GlareSum& sum = sums[i * channels() + c];
      glare.value.push_back(sum.value);
      glare.low.push_back(sum.low);
      glare.high.push_back(sum.high);
      if (!sum.refusal) continue;
      glare.refusals.push_back(*sum.refusal);
      glare.refusals.back().point = i;
    }
  }
}

void PlaneWork::sample_openings(double deadline_s, SolveTimes& times) {
  if (is_eyes_) return;
  if (most_rounds_ > 0 && !opening_error_matters()) return;
  const PhaseTimer timer(times.direct_s);
  direct_sum_lx_.resize(values());
  const std::uint32_t last = std::max<std::uint32_t>(1, 2 * most_rounds_);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    std::uint64_t rays = 0;
    if (active_[i] == 0 || is_past(deadline_s)) return rays;
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      const DirectRays direct = add_extended_sources(
          tracer_, receiver_[i], {is_dark_, has_shadows_}, opening_key_.with(i).with(r), rounds_[i],
          last, &direct_sum_lx_[r * channels() * points() + i], points());
      rays += direct.traced;
      if (direct.may_be_lit) may_be_sampled_[i] = 1;
    }
    rounds_[i] = last;
    return rays;
  });
  most_rounds_ = last;
}

bool PlaneWork::opening_error_matters() const {
  if (std::find(field_.unseen.begin(), field_.unseen.end(), 1) != field_.unseen.end()) return true;
  if (field_.indirect_lx.empty()) return true;
  return squared_error(field_.direct_sampled_lx) >
         kNegligibleVariance * squared_error(field_.indirect_lx);
}

// Sum over active points of the squared standard error, all channels at full output.
double PlaneWork::squared_error(const std::vector<double>& values_lx) const {
  double sum = 0.0;
  std::vector<double> at_point(field_.replicates);
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      at_point[r] = 0.0;
      for (std::size_t c = 0; c < channels(); ++c) {
        at_point[r] += values_lx[(r * channels() + c) * points() + i];
      }
    }
    const double error = replicate_mean(at_point).standard_error;
    sum += error * error;
  }
  return sum;
}

void PlaneWork::start_look(double near_reach_m, double largest_sample) {
  look_sample_lx_ = largest_sample;
  if (spatial_order_.empty()) spatial_order_ = spatial_order(receiver_);
  indirect_sum_lx_.resize(values());
  largest_sum_lx_.resize(field_.replicates * points());
  std::vector<std::uint8_t> is_wanted(points());
  for (std::size_t i = 0; i < points(); ++i) {
    is_wanted[i] = static_cast<std::uint8_t>(active_[i] != 0 && sees_reflection_[i] != 0);
  }
  tiles_ = make_tiles(receiver_, spatial_order_, is_wanted);
  reach_m_ = near_reach_m;
  if (near_reach_m > 0.0 && clear_m_.empty()) {
    clear_m_.assign(points(), 0.0);
    if (!settings_.skips.allows(Skip::clear_distance)) return;
    for_each_point(points(), [&](std::size_t i) {
      const Receiver& r = receiver_[i];
      clear_m_[i] = tracer_.clear_distance(
          r.position_m, has_back(r.kernel) ? r.axis : glm::dvec3(0.0), near_reach_m);
      return std::uint64_t{0};
    });
  }
}

// Connections of tiles first..last.
std::uint64_t PlaneWork::connect_tiles(std::size_t first, std::size_t last,
                                       const VertexBatch& batch, Gatherer& gatherer,
                                       std::span<TileSums> sums) const {
  if (settings_.method == Method::instant_radiosity) {
    std::uint64_t rays = 0;
    for (std::size_t t = first; t < last; ++t) {
      if (!is_past(batch.deadline_s))
        rays += connect_all(tiles_[t], batch, gatherer, sums[t - first]);
    }
    return rays;
  }
  const std::uint32_t draws = draws_per_point(batch.paths, points());
  const CutRequest cut{std::clamp(kCutNodesPerDraw * draws, kSmallestCut, kLargestCut),
                       static_cast<float>(batch.near_bound->smallest()),
                       settings_.skips.allows(Skip::hidden_nodes)};
  const RandomKey key = draw_key_.with(batch.replicate).with(batch.first_path);
  std::vector<double> shifts;
  for (std::size_t t = first; t < last; ++t) {
    for (const std::uint32_t i : tiles_[t].point) shifts.push_back(key.with(i).uniform());
  }
  std::vector<DrawTile> tiles;
  std::span<const double> rest(shifts);
  for (std::size_t t = first; t < last; ++t) {
    const std::size_t count = tiles_[t].point.size();
    TileSums& sum = sums[t - first];
    tiles.push_back(
        {tiles_[t].receiver, rest.first(count), {sum.lx.data(), count, sum.largest_lx.data()}});
    rest = rest.subspan(count);
  }
  return gatherer.draw_and_gather(
      {tracer_, batch.tree, batch.bounds, cut, draws, has_shadows_, batch.deadline_s, tiles});
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
  return gatherer.gather({tracer_, vertices, batch.bounds, tile.receiver, connections, has_shadows_,
                          batch.tree.identity()},
                         {sums.lx.data(), tile.point.size(), sums.largest_lx.data()});
}

// First hits of short rays of some tiles; there are none if add_near_field() traces them itself.
struct PlaneWork::ShortRays {
  std::vector<FirstHit> hits;
  std::vector<std::size_t> first_hit{};  // per tile
  std::size_t last_tile = 0;             // the first that is not among them

  const FirstHit* of(std::size_t tile) const {
    return hits.empty() ? nullptr : hits.data() + first_hit[tile];
  }
};

NearFieldRequest PlaneWork::near_request(const ReceiverGroup& tile, std::size_t k,
                                         const VertexBatch& batch) const {
  const std::uint32_t i = tile.point[k];
  const RandomKey key = near_key_.with(batch.replicate).with(batch.first_path).with(i);
  if (!(clear_m_[i] < reach_m_)) return {tile.receiver[k], key, 0};
  const std::uint32_t draws = draws_per_point(batch.paths, points());
  return {tile.receiver[k], key, short_rays_per_point(draws, clear_m_[i], reach_m_)};
}

// Of all these tiles, or of so many that their rays fill a cast: hits take memory on every thread.
PlaneWork::ShortRays PlaneWork::cast_short_rays(std::size_t first_tile, std::size_t last_tile,
                                                const VertexBatch& batch) const {
  ShortRays result;
  result.last_tile = last_tile;
  if (batch.short_rays == nullptr || !(reach_m_ > 0.0)) return result;
  std::vector<NearFieldRequest> requests;
  std::vector<std::size_t> first_ray{0};  // of each request
  for (std::size_t t = first_tile; t < last_tile; ++t) {
    if (first_ray.back() >= kShortRaysPerCast) {
      result.last_tile = t;
      break;
    }
    result.first_hit.push_back(first_ray.back());
    for (std::size_t k = 0; k < tiles_[t].point.size(); ++k) {
      const NearFieldRequest request = near_request(tiles_[t], k, batch);
      if (request.rays == 0) continue;
      requests.push_back(request);
      first_ray.push_back(first_ray.back() + request.rays);
    }
  }
  result.hits.assign(first_ray.back(), {FirstHit::kNotDone});
  for (std::size_t first = 0, last = 0; first < requests.size(); first = last) {
    for (last = first + 1; last < requests.size(); ++last) {
      if (first_ray[last + 1] - first_ray[first] > kShortRaysPerCast) break;
    }
    batch.short_rays->cast(
        tracer_, static_cast<float>(tracer_.offset_m()),
        static_cast<float>(batch.near_bound->reach_m()),
        std::span(requests).subspan(first, last - first),
        std::span(result.hits).subspan(first_ray[first], first_ray[last] - first_ray[first]));
  }
  return result;
}

std::uint64_t PlaneWork::add_near(const ReceiverGroup& tile, const VertexBatch& batch,
                                  const FirstHit* first_hits, TileSums& sums) const {
  const NearField field{tracer_,      *batch.near_bound, batch.tree,
                        batch.bounds, batch.global_cut,  channels()};
  std::uint64_t rays = 0;
  for (std::size_t k = 0; k < tile.point.size(); ++k) {
    const NearFieldRequest request = near_request(tile, k, batch);
    if (request.rays == 0) continue;
    rays += add_near_field(field, request, first_hits, &sums.lx[k], tile.point.size(),
                           sums.largest_lx[k]);
    if (first_hits != nullptr) first_hits += request.rays;
  }
  return rays;
}

void PlaneWork::connect(const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times) {
  std::atomic<std::uint64_t> connection_rays{0}, near_rays{0};
  std::atomic<double> connect_s{0.0}, near_s{0.0};
  // A thread that waits here must not take up another replicate, whose pool would add to memory.
  tbb::this_task_arena::isolate([&] {
    const tbb::blocked_range<std::size_t> all(0, tiles_.size(), tiles_per_task(batch, gatherer));
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
      const FlushDenormals flush;
      if (is_past(batch.deadline_s)) return;
      std::vector<TileSums> sums(range.size());
      for (std::size_t t = range.begin(); t < range.end(); ++t) {
        const std::size_t count = tiles_[t].point.size();
        sums[t - range.begin()].lx.assign(channels() * count, 0.0);
        sums[t - range.begin()].largest_lx.assign(count, 0.0f);
      }
      const double begin_s = now_s();
      connection_rays += connect_tiles(range.begin(), range.end(), batch, gatherer, sums);
      const double middle_s = now_s();
      for (std::size_t first = range.begin(); first < range.end();) {
        const ShortRays short_rays = cast_short_rays(first, range.end(), batch);
        for (std::size_t t = first; t < short_rays.last_tile; ++t) {
          TileSums& sum = sums[t - range.begin()];
          if (is_past(batch.deadline_s)) return;
          if (reach_m_ > 0.0) {
            near_rays += add_near(tiles_[t], batch, short_rays.of(t - first), sum);
          }
          store(tiles_[t], batch, sum);
        }
        first = short_rays.last_tile;
      }
      near_s += now_s() - middle_s;
      connect_s += middle_s - begin_s;
    });
  });
  replicate_connection_rays_[batch.replicate] += connection_rays;
  replicate_near_rays_[batch.replicate] += near_rays;
  times.connect_s += connect_s;
  times.near_s += near_s;
}

void PlaneWork::take_shared(const VertexBatch& batch, const GatherSums& sums, std::uint64_t pairs) {
  std::size_t first = 0;
  for (const ReceiverGroup& tile : tiles_) {
    const std::size_t count = tile.point.size();
    TileSums part;
    for (std::size_t c = 0; c < channels(); ++c) {
      const double* lx = sums.lx + c * sums.stride + first;
      part.lx.insert(part.lx.end(), lx, lx + count);
    }
    part.largest_lx.assign(sums.largest_lx + first, sums.largest_lx + first + count);
    store(tile, batch, part);
    first += count;
  }
  replicate_connection_rays_[batch.replicate] += pairs;
}

void PlaneWork::store(const ReceiverGroup& tile, const VertexBatch& batch, const TileSums& sums) {
  const std::size_t count = tile.point.size();
  const auto paths = static_cast<double>(batch.paths);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = tile.point[k];
    for (std::size_t c = 0; c < channels(); ++c) {
      indirect_sum_lx_[(batch.replicate * channels() + c) * points() + i] +=
          paths * sums.lx[c * count + k];
    }
    float& largest = largest_sum_lx_[batch.replicate * points() + i];
    largest = std::max(largest, static_cast<float>(paths) * sums.largest_lx[k]);
  }
}

void PlaneWork::finish_look(std::uint64_t batch_paths) {
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;
    paths_[i] += batch_paths;
    if (has_indirect_[i] != 0) {
      possible_sample_lx_[i] = std::max(possible_sample_lx_[i], look_sample_lx_);
    }
  }
  SolveCounters& counters = field_.counters;
  counters.paths += batch_paths * field_.replicates;
  counters.connection_rays = std::accumulate(replicate_connection_rays_.begin(),
                                             replicate_connection_rays_.end(), std::uint64_t{0});
  counters.near_rays =
      std::accumulate(replicate_near_rays_.begin(), replicate_near_rays_.end(), std::uint64_t{0});
}

void PlaneWork::publish(int looks_planned) {
  field_.looks_planned = looks_planned;
  field_.counters.active_points.push_back(
      static_cast<std::size_t>(std::count(active_.begin(), active_.end(), 1)));
  const std::size_t rows = field_.replicates * channels();
  if (most_rounds_ > 0) field_.direct_sampled_lx.resize(values());
  if (!indirect_sum_lx_.empty()) field_.indirect_lx.resize(values());
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;  // nothing new
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t k = row * points() + i;
      if (most_rounds_ > 0) field_.direct_sampled_lx[k] = direct_sum_lx_[k] / rounds_[i];
      if (!indirect_sum_lx_.empty()) {
        field_.indirect_lx[k] = indirect_sum_lx_[k] / static_cast<double>(paths_[i]);
      }
    }
  }
  if (!field_.is_exact()) {
    find_unseen();
    find_largest_share();
  }
}

void PlaneWork::find_unseen() {
  field_.unseen = may_be_sampled_;
  for (const std::vector<double>* sums : {&direct_sum_lx_, &indirect_sum_lx_}) {
    for (std::size_t k = 0; k < sums->size(); ++k) {
      if ((*sums)[k] > 0.0) field_.unseen[k % points()] = 0;
    }
  }
}

void PlaneWork::find_largest_share() {
  field_.largest_share.assign(points(), 0.0f);
  if (indirect_sum_lx_.empty()) return;
  const auto replicates = static_cast<double>(field_.replicates);
  for (std::size_t i = 0; i < points(); ++i) {
    double total_lx = 0.0;
    // What was drawn, or could have been where vertices are so few that none was.
    double largest = possible_sample_lx_[i];
    for (std::size_t c = 0; c < channels(); ++c) {
      total_lx += field_.direct_exact_lx[c * points() + i];
    }
    for (std::size_t row = 0; row < field_.replicates * channels(); ++row) {
      const std::size_t k = row * points() + i;
      total_lx += field_.indirect_lx[k] / replicates;
      if (!field_.direct_sampled_lx.empty()) total_lx += field_.direct_sampled_lx[k] / replicates;
    }
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      largest = std::max(largest, static_cast<double>(largest_sum_lx_[r * points() + i]));
    }
    if (!(total_lx > 0.0) || paths_[i] == 0) continue;
    field_.largest_share[i] =
        static_cast<float>(largest / (static_cast<double>(paths_[i]) * replicates * total_lx));
  }
}

}  // namespace calc
