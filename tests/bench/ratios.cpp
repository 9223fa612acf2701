// A few ratios and nothing else, for a look at every change: times would say more about the
// machine.
#include "tests/bench/experiments.h"
#include "tests/bench/path_tracing.h"
#include "tests/bench/ray_limit.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace bench {
namespace {

struct Curve {
  std::vector<double> error, seconds, rays;
};

Curve climb(const BenchScene& scene, const Truth& truth, const Options& options,
            calc::Method method, int threads) {
  Curve curve;
  for (std::uint64_t paths = options.min_paths; paths <= options.max_paths; paths *= 2) {
    const Run best = best_of(scene, {method, paths, options.replicates, options.seed, threads, 0.0},
                             options.repeats);
    curve.error.push_back(errors_of(best.field, truth).mean);
    curve.seconds.push_back(best.seconds);
    curve.rays.push_back(best.rays_per_point());
  }
  return curve;
}

// Cosine paths from the points: the error falls as the root of their number, so that one size does.
Curve trace(const BenchScene& scene, const Truth& truth, const Options& options) {
  Curve curve;
  for (const std::uint64_t paths : {options.min_paths / 4 + 1, options.min_paths}) {
    const auto begin = std::chrono::steady_clock::now();
    const auto replicates = trace_from_points(scene, paths, options.replicates, options.seed);
    curve.seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    const std::vector<double> mean = mean_over_replicates(replicates);
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      if (!(truth.indirect_lx[i] > 0.0)) continue;
      squares += std::pow(mean[i] / truth.indirect_lx[i] - 1.0, 2);
      ++count;
    }
    curve.error.push_back(std::sqrt(squares / count));
  }
  return curve;
}

void print_ratio(const std::string& scene, const std::string& what, double value, bool is_rough) {
  fmt::print("{:<10} {:<58} {}{}\n", scene, what,
             std::isfinite(value) ? number(value) : std::string("-"), is_rough ? " *" : "");
}

void measure(const std::string& name, const Options& options) {
  const BenchScene scene = make_scene(find_room(name));
  const Truth truth = find_truth(scene, options);
  const int threads = options.threads.back();
  const Run run = best_of(
      scene,
      {calc::Method::light_pool, options.max_paths, options.replicates, options.seed, threads, 0.0},
      options.repeats);
  const RayLimit limit = limit_of(run, measure_rays(scene, threads, options.repeats));
  print_ratio(name, "run: share that the ray tracer alone would need", limit.whole_s / run.seconds,
              false);
  print_ratio(name, "connections: share that the ray tracer alone would need",
              limit.connection_s / run.times.connect_s, false);

  const Curve core = climb(scene, truth, options, calc::Method::light_pool, threads);
  const Curve shared = climb(scene, truth, options, calc::Method::instant_radiosity, threads);
  const double error = core.error.back();
  const Looked shared_s = look_up(shared.error, shared.seconds, error);
  const Looked shared_rays = look_up(shared.error, shared.rays, error);
  print_ratio(name, "plain instant radiosity at equal error: times the time",
              shared_s.y / core.seconds.back(), shared_s.is_extrapolated);
  print_ratio(name, "plain instant radiosity at equal error: times the rays",
              shared_rays.y / core.rays.back(), shared_rays.is_extrapolated);
  const Curve paths = trace(scene, truth, options);
  // Its variance falls as 1 / n.
  const double paths_s = paths.seconds.back() * std::pow(paths.error.back() / error, 2);
  print_ratio(name, "path tracing at equal error: times the time", paths_s / core.seconds.back(),
              true);
}

}  // namespace

void run_ratios(const Options& options) {
  for (const std::string& name : options.names) measure(name, options);
  fmt::print("* extrapolated\n");
}

}  // namespace bench
