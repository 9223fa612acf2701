#include "tests/bench/ray_limit.h"

#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "tests/bench/path_tracing.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bench {
namespace {

constexpr std::uint32_t kPathsTraced = 4096;
constexpr int kDraws = 64;                  // connections of a point
constexpr std::size_t kMostRays = 1 << 18;  // of a kind
constexpr int kNearRays = 64;

struct PacketQuery {
  glm::vec3 from_m;
  calc::SegmentPacket packet;
};

struct HitQuery {
  calc::RayPacket rays{};
  float reach_m = 0.0f;
};

void add_target(std::vector<PacketQuery>& queries, const glm::vec3& from, const glm::dvec3& to_m) {
  if (queries.empty() || queries.back().from_m != from || queries.back().packet.is_full()) {
    queries.push_back({from, {}});
  }
  queries.back().packet.add(from, glm::vec3(to_m));
}

// Places along a Morton curve, for the order in which a sorted pool is visited.
std::uint64_t morton(const glm::dvec3& share) {
  std::uint64_t code = 0;
  for (int bit = 9; bit >= 0; --bit) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto cell = static_cast<std::uint64_t>(std::clamp(share[axis], 0.0, 0.999) * 1024.0);
      code = code << 1 | (cell >> bit & 1);
    }
  }
  return code;
}

void sort_along_curve(std::vector<ReflectedLight>& vertices, double extent_m) {
  const auto code = [&](const ReflectedLight& v) { return morton(v.position_m / extent_m + 0.5); };
  std::sort(vertices.begin(), vertices.end(),
            [&](const auto& a, const auto& b) { return code(a) < code(b); });
}

// Every k-th point, so that they span the plane.
std::vector<std::size_t> chosen_points(const BenchScene& scene, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t step = scene.points() / std::max<std::size_t>(1, most) + 1;
  for (std::size_t i = 0; i < scene.points(); i += step) chosen.push_back(i);
  return chosen;
}

std::vector<PacketQuery> connection_rays(const calc::Tracer& tracer, const BenchScene& scene,
                                         const std::vector<ReflectedLight>& pool) {
  std::vector<PacketQuery> queries;
  std::vector<double> cumulative(pool.size());
  for (const std::size_t i : chosen_points(scene, kMostRays / kDraws / 2)) {
    const glm::dvec3 x = scene.grid.position_m[i] - scene.scene.origin_m;
    const glm::dvec3& normal = scene.grid.normal[i];
    double sum = 0.0;
    for (std::size_t j = 0; j < pool.size(); ++j) {
      sum += pool[j].flux_lm *
             std::min(1.0, calc::geometry_term(x, normal, pool[j].position_m, pool[j].normal));
      cumulative[j] = sum;
    }
    const glm::vec3 from(tracer.lift(x, normal));
    std::size_t j = 0;
    for (int k = 0; k < kDraws && sum > 0.0; ++k) {
      while (j + 1 < pool.size() && cumulative[j] < (k + 0.5) / kDraws * sum) ++j;
      add_target(queries, from, pool[j].position_m);
    }
  }
  return queries;
}

std::vector<PacketQuery> direct_rays(const calc::Tracer& tracer, const BenchScene& scene) {
  std::vector<PacketQuery> queries;
  const auto& luminaires = scene.scene.luminaires;
  for (const std::size_t i : chosen_points(scene, kMostRays / luminaires.size() + 1)) {
    const glm::dvec3 x = scene.grid.position_m[i] - scene.scene.origin_m;
    const glm::vec3 from(tracer.lift(x, scene.grid.normal[i]));
    for (const calc::PlacedLuminaire& luminaire : luminaires) {
      add_target(queries, from,
                 calc::lifted_source_m(luminaire, luminaire.position_m, x, tracer.offset_m()));
    }
  }
  return queries;
}

std::vector<RayQuery> near_rays(const calc::Tracer& tracer, const BenchScene& scene) {
  std::vector<RayQuery> queries;
  const double reach_m = mean_chord_m(scene.scene) / 3.0;
  for (const std::size_t i : chosen_points(scene, kMostRays / kNearRays)) {
    const glm::dvec3 x = scene.grid.position_m[i] - scene.scene.origin_m;
    const calc::ScrambledSobol sobol{calc::RandomKey(i)};
    for (std::uint32_t k = 0; k < kNearRays; ++k) {
      const auto u = sobol.sample_pair(k, 0);
      queries.push_back({tracer.lift(x, scene.grid.normal[i]),
                         calc::cosine_direction(scene.grid.normal[i], u[0], u[1]), reach_m});
    }
  }
  return queries;
}

// Best time of tracing all queries, by chunks on all threads of the arena.
template <typename Queries, typename Trace>
double best_seconds(const Queries& queries, int repeats, const Trace& trace) {
  constexpr std::size_t kChunk = 64;
  double best_s = std::numeric_limits<double>::max();
  for (int run = 0; run < repeats + 1; ++run) {  // one to warm up
    const double begin_s = calc::now_s();
    tbb::parallel_for(std::size_t{0}, queries.size() / kChunk + 1, [&](std::size_t chunk) {
      const calc::FlushDenormals flush;
      std::uint32_t sum = 0;
      const std::size_t end = std::min(queries.size(), (chunk + 1) * kChunk);
      for (std::size_t q = chunk * kChunk; q < end; ++q) sum += trace(queries[q]);
      volatile std::uint32_t sink = sum;
      static_cast<void>(sink);
    });
    if (run > 0) best_s = std::min(best_s, calc::now_s() - begin_s);
  }
  return best_s;
}

double packet_ns(const calc::Tracer& tracer, const std::vector<PacketQuery>& queries, int repeats) {
  double rays = 0.0;
  for (const PacketQuery& query : queries) rays += query.packet.count;
  return rays == 0.0 ? 0.0
                     : 1e9 / rays * best_seconds(queries, repeats, [&](const PacketQuery& query) {
                         return tracer.blocked(query.packet);
                       });
}

// Rays of one kind and reach in packets, in order.
std::vector<HitQuery> in_packets(const std::vector<RayQuery>& rays) {
  std::vector<HitQuery> packets;
  for (const RayQuery& ray : rays) {
    if (packets.empty() || packets.back().rays.is_full()) {
      packets.emplace_back();
      packets.back().reach_m = static_cast<float>(ray.reach_m);
    }
    packets.back().rays.add(ray.origin_m, ray.direction);
  }
  return packets;
}

double hit_ns(const calc::Tracer& tracer, const std::vector<RayQuery>& rays, int repeats) {
  if (rays.empty()) return 0.0;
  const double seconds = best_seconds(in_packets(rays), repeats, [&](const HitQuery& query) {
    std::array<calc::SurfaceHit, calc::RayPacket::kSize> hit;
    return tracer.closest_hits(query.rays, 0.0f, query.reach_m, hit);
  });
  return 1e9 * seconds / static_cast<double>(rays.size());
}

}  // namespace

RayCosts measure_rays(const BenchScene& scene, int threads, int repeats) {
  const calc::Tracer tracer(scene.scene);
  const calc::Emitter emitter(scene.scene);
  LightTrace light = trace_light(tracer, emitter, Roulette::one_number, kPathsTraced, 1, true);
  if (light.queries.size() > kMostRays) light.queries.resize(kMostRays);
  // Waves: neighbouring paths together, bounce by bounce.
  std::stable_sort(light.queries.begin(), light.queries.end(),
                   [](const RayQuery& a, const RayQuery& b) { return a.bounce < b.bounce; });
  sort_along_curve(light.vertices, scene.scene.extent_m);
  const auto connections = connection_rays(tracer, scene, light.vertices);
  const auto direct = direct_rays(tracer, scene);
  const auto near = near_rays(tracer, scene);
  RayCosts costs;
  tbb::task_arena(threads).execute([&] {
    costs.connection_ns = packet_ns(tracer, connections, repeats);
    costs.direct_ns = packet_ns(tracer, direct, repeats);
    costs.path_ns = hit_ns(tracer, light.queries, repeats);
    costs.near_ns = hit_ns(tracer, near, repeats);
  });
  return costs;
}

RayLimit limit_of(const Run& run, const RayCosts& costs) {
  const calc::SolveCounters& counters = run.field.counters;
  RayLimit limit;
  limit.connection_s = 1e-9 * static_cast<double>(counters.connection_rays) * costs.connection_ns;
  limit.whole_s =
      limit.connection_s + 1e-9 * (static_cast<double>(run.pool_rays) * costs.path_ns +
                                   static_cast<double>(counters.near_rays) * costs.near_ns +
                                   static_cast<double>(counters.direct_rays) * costs.direct_ns);
  return limit;
}

}  // namespace bench
