// Time and memory against the size of the problem.
#include "tests/bench/experiments.h"
#include "tests/bench/memory.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace bench {
namespace {

struct Step {
  std::string name;
  double size = 0.0;
  ScalingSize room;
  std::uint64_t paths = 0;
};

void measure(const std::string& title, const std::vector<Step>& steps, const Options& options) {
  Table table(title, {"size", "triangles", "points", "paths", "s", "build", "direct", "pool",
                      "connect", "near", "rays", "MiB"});
  std::vector<double> sizes, seconds, memory, connects;
  for (const Step& step : steps) {
    if (options.most_size > 0 && step.size > options.most_size) continue;
    const BenchScene scene = make_scene(scaling_room(step.room));
    reset_peak_memory();
    const double before = used_memory_mib();
    const int repeats = step.size >= 1e5 ? 1 : options.repeats;
    const Run run = best_of(scene,
                            {calc::Method::light_pool, step.paths, options.replicates, options.seed,
                             options.threads.back(), 0.0},
                            repeats);
    const double peak = peak_memory_mib() - before;
    const calc::SolveTimes& t = run.times;
    sizes.push_back(step.size);
    seconds.push_back(run.seconds);
    connects.push_back(std::max(1e-6, t.connect_s + t.near_s));
    memory.push_back(std::max(0.1, peak));
    table.add({step.name, fmt::format("{}", scene.scene.triangle.size()),
               fmt::format("{}", scene.points()), fmt::format("{}", step.paths),
               fmt::format("{:.4f}", run.seconds), fmt::format("{:.4f}", t.build_s),
               fmt::format("{:.4f}", t.direct_s), fmt::format("{:.4f}", t.pool_s),
               fmt::format("{:.4f}", t.connect_s), fmt::format("{:.4f}", t.near_s),
               count(run.rays_per_replicate() * static_cast<double>(run.field.replicates)),
               fmt::format("{:.1f}", peak)});
  }
  table.print();
  fmt::print("  exponents: time {:.2f}, connections and near field {:.2f}, memory {:.2f}\n",
             fitted_exponent(sizes, seconds), fitted_exponent(sizes, connects),
             fitted_exponent(sizes, memory));
  const std::size_t half = sizes.size() / 2;
  const auto upper = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(half), all.end());
  };
  fmt::print("  of the upper half alone: time {:.2f}, memory {:.2f}\n",
             fitted_exponent(upper(sizes), upper(seconds)),
             fitted_exponent(upper(sizes), upper(memory)));
}

}  // namespace

void run_scaling(const Options& options) {
  const auto wanted = [&](const char* name) {
    return options.names.empty() || options.names.front() == name;
  };
  const std::uint64_t paths = options.min_paths;
  std::vector<Step> steps;
  for (const int points : {100, 1000, 10000, 100000, 1000000}) {
    steps.push_back({fmt::format("{} points", points),
                     static_cast<double>(points),
                     {points, 12, 1, 0.5},
                     paths});
  }
  if (wanted("points")) measure("points", steps, options);
  steps.clear();
  for (const int luminaires : {1, 3, 10, 30, 100, 300, 1000}) {
    steps.push_back({fmt::format("{} luminaires", luminaires),
                     static_cast<double>(luminaires),
                     {1000, luminaires, 1, 0.5},
                     paths});
  }
  if (wanted("luminaires")) measure("luminaires, equal flux", steps, options);
  steps.clear();
  for (const int cells : {1, 3, 10, 30, 96}) {
    const double triangles = 108.0 * cells * cells;
    steps.push_back(
        {fmt::format("{:.0f} triangles", triangles), triangles, {1000, 12, cells, 0.5}, paths});
  }
  if (wanted("triangles")) measure("triangles, the same surfaces cut finer", steps, options);
  steps.clear();
  for (const double rho : {0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99}) {
    steps.push_back(
        {fmt::format("reflectance {}", rho), 1.0 / (1.0 - rho), {1000, 12, 1, rho}, paths});
  }
  if (wanted("reflectance")) {
    measure("reflectance; the size is 1 / (1 - rho)", steps, options);
  }
}

}  // namespace bench
