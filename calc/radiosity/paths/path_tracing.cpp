#include "calc/radiosity/paths/path_tracing.h"

#include "calc/base/elementary.h"
#include "calc/base/sentences.h"
#include "calc/base/units.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/grid_receivers.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/random.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace calc {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kPathsPerRound = 256;  // rounds of samples on extended openings

// By formulas of its own: this is the second method that the first is held against.
struct PathStart {
  glm::dvec3 origin_m, direction;
  double weight;  // k(w) / (density pi)
};

PathStart path_start(const Tracer& tracer, const Receiver& receiver, std::array<double, 2> u) {
  if (has_back(receiver.kernel)) {
    return {tracer.lift(receiver), cosine_direction(receiver.axis, u[0], u[1]), 1.0};
  }
  const double z = 1.0 - 2.0 * u[0];
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  const glm::dvec3 direction(radius * calc::cos(2.0 * kPi * u[1]),
                             radius * calc::sin(2.0 * kPi * u[1]), z);
  return {receiver.position_m, direction,
          4.0 * response_times_distance(receiver.kernel, receiver.axis, direction)};
}

struct PathSums {
  double* lx;  // [channel * stride]
  std::size_t stride;
  std::uint64_t path_rays = 0, direct_rays = 0;
  bool is_endless = false;
};

// E = mean of weight rho(y) E(y), y = first hit; E(y) = E_dir(y) + the same again.
void add_path(const Tracer& tracer, const Receiver& receiver, const ScrambledSobol& sobol,
              std::uint32_t index, RandomKey key, double weight, PathSums& sums) {
  const PathStart first = path_start(tracer, receiver, sobol.sample_pair(index, 0));
  weight *= first.weight;
  if (!(weight > 0.0)) return;
  glm::dvec3 origin_m = first.origin_m, direction = first.direction;
  for (int reflection = 0;; ++reflection) {
    SurfaceHit hit;
    ++sums.path_rays;
    if (!tracer.closest_hit(origin_m, direction, kNoLimit, hit)) return;
    const double rho = tracer.scene().reflectance[hit.triangle];
    const RandomKey at_hit = key.with(static_cast<std::uint64_t>(reflection));
    if (reflection == 0) {
      weight *= rho;
    } else if (at_hit.with(0).uniform() >= rho) {
      return;
    }
    if (!(weight > 0.0)) return;
    if (reflection >= kMostReflections) {
      sums.is_endless = true;
      return;
    }
    sums.direct_rays += add_direct_sample(tracer, {hit.position_m, hit.normal}, at_hit.with(1),
                                          weight, sums.lx, sums.stride);
    const auto u = sobol.sample_pair(index, 2 + 2 * reflection);
    origin_m = tracer.lift(hit.position_m, hit.normal);
    direction = cosine_direction(hit.normal, u[0], u[1]);
  }
}

}  // namespace

PlaneField trace_from_points(const Tracer& tracer, const std::string& plane_id,
                             const SensorGrid& grid, const PathTracingSettings& settings) {
  const std::vector<Receiver> receivers = receivers_of(tracer, grid);
  const std::size_t points = receivers.size();
  const std::size_t channels = tracer.scene().channels.size();
  const bool has_extended = has_extended_luminaires(tracer.scene());
  const auto rounds =
      static_cast<std::uint32_t>(std::max<std::uint64_t>(1, settings.paths / kPathsPerRound));
  PlaneField field;
  field.plane_id = plane_id;
  field.points = points;
  field.point_weight = point_weights(grid);
  field.replicates = static_cast<std::size_t>(settings.replicates);
  field.channels = tracer.scene().channels;
  field.direct_exact_lx.assign(channels * points, 0.0);
  field.indirect_lx.assign(field.replicates * channels * points, 0.0);
  if (has_extended) field.direct_sampled_lx = field.indirect_lx;
  field.stop = StopReason::path_limit;

  const RandomKey plane_key =
      stage_key(settings.seed, RandomStage::paths_from_points).with(plane_id);
  std::atomic<std::uint64_t> path_rays{0}, direct_rays{0};
  std::atomic<bool> is_endless{false}, is_stopped{false};
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
    const FlushDenormals flush;
    if (settings.goes_on && !settings.goes_on()) is_stopped = true;
    if (is_stopped) return;
    direct_rays +=
        add_point_sources(tracer, receivers[i], {}, &field.direct_exact_lx[i], points).traced;
    for (std::size_t r = 0; r < field.replicates && !is_endless; ++r) {
      const RandomKey key = plane_key.with(i).with(r);
      const ScrambledSobol sobol(key.with("directions"), kSobolDimensions);
      const std::size_t row = r * channels * points + i;
      if (has_extended) {
        direct_rays += add_extended_sources(tracer, receivers[i], {}, key.with("openings"), 0,
                                            rounds, &field.direct_sampled_lx[row], points)
                           .traced;
        for (std::size_t c = 0; c < channels; ++c) {
          field.direct_sampled_lx[row + c * points] /= rounds;
        }
      }
      PathSums sums{&field.indirect_lx[row], points};
      for (std::uint64_t p = 0; p < settings.paths && !sums.is_endless; ++p) {
        add_path(tracer, receivers[i], sobol, static_cast<std::uint32_t>(p), key.with(p),
                 1.0 / static_cast<double>(settings.paths), sums);
      }
      path_rays += sums.path_rays;
      direct_rays += sums.direct_rays;
      if (sums.is_endless) is_endless = true;
    }
  });
  field.counters.near_rays = path_rays;
  field.counters.direct_rays = direct_rays;
  if (is_stopped) {
    field.stop = StopReason::interrupted;
    field.problem = say<Sentence::interrupted>();
  } else if (is_endless) {
    field.problem = say<Sentence::endless_path>(kMostReflections);
  }
  return field;
}

}  // namespace calc
