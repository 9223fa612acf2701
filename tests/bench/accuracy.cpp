// Time to an accuracy of the total illuminance, intervals included, and how near the run comes to
// what the ray tracer alone would need.
#include "tests/bench/experiments.h"
#include "tests/bench/ray_limit.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

// RMS over runs with different seeds.
double total_error(const std::vector<Run>& runs, const Truth& truth) {
  double squares = 0.0;
  for (const Run& run : runs) squares += std::pow(errors_of(run.field, truth).total, 2);
  return std::sqrt(squares / static_cast<double>(runs.size()));
}

void measure(const BenchScene& scene, const Truth& truth, const Options& options, int threads) {
  const RayCosts costs = measure_rays(scene, threads, options.repeats);
  fmt::print(
      "\n  ray tracer alone, {} threads, ns per ray: connection {:.1f}, light path {:.1f}, "
      "near {:.1f}, direct {:.1f}\n",
      threads, costs.connection_ns, costs.path_ns, costs.near_ns, costs.direct_ns);
  Table table(fmt::format("{}: {} points, {} replicates, {} threads", scene.name, scene.points(),
                          options.replicates, threads),
              {"paths", "total %", "s", "build", "direct", "pool", "connect", "near", "pool rays",
               "conn. rays", "near rays", "limit s", "limit/run", "limit/connect"});
  std::vector<double> errors, seconds;
  for (std::uint64_t paths = std::min<std::uint64_t>(options.min_paths, 64);
       paths <= options.max_paths; paths *= 2) {
    std::vector<Run> runs;
    const Run best = best_of(
        scene, {calc::Method::light_pool, paths, options.replicates, options.seed, threads, 0.0},
        options.repeats, &runs);
    errors.push_back(total_error(runs, truth));
    seconds.push_back(best.seconds);
    const RayLimit limit = limit_of(best, costs);
    const calc::SolveTimes& t = best.times;
    table.add(
        {fmt::format("{}", paths), percent(errors.back()), fmt::format("{:.4f}", best.seconds),
         fmt::format("{:.4f}", t.build_s), fmt::format("{:.4f}", t.direct_s),
         fmt::format("{:.4f}", t.pool_s), fmt::format("{:.4f}", t.connect_s),
         fmt::format("{:.4f}", t.near_s), fmt::format("{}", best.pool_rays),
         fmt::format("{}", best.field.counters.connection_rays),
         fmt::format("{}", best.field.counters.near_rays), fmt::format("{:.4f}", limit.whole_s),
         fmt::format("{:.2f}", limit.whole_s / best.seconds),
         t.connect_s > 0.0 ? fmt::format("{:.2f}", limit.connection_s / t.connect_s) : "-"});
    if (errors.back() < 0.0009) break;
  }
  table.print();
  for (const double error : {0.01, 0.005, 0.001}) {
    const Looked s = look_up(errors, seconds, error);
    fmt::print("  {:>4} % of the total: {} s{}\n", 100.0 * error, number(s.y),
               s.is_extrapolated ? " (extrapolated)" : "");
  }
}

}  // namespace

void run_accuracy(const Options& options) {
  for (const std::string& name : options.names) {
    const BenchScene scene = make_scene(find_room(name));
    const Truth truth = find_truth(scene, options);
    fmt::print("{}: {} triangles, truth off by {} % of the indirect part\n", name,
               scene.scene.triangle.size(), percent(truth_error(truth)));
    for (const int threads : options.threads) measure(scene, truth, options, threads);
  }
}

}  // namespace bench
