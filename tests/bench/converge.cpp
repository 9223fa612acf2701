// Error of the indirect part against rays and time, for the light pool and for shared virtual point
// lights.
#include "tests/bench/experiments.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

namespace bench {
namespace {

struct Series {
  std::vector<double> rays, replicate_error, mean_error, average_error, seconds;
};

Series measure(const BenchScene& scene, const Truth& truth, const Options& options,
               calc::Method method, const std::string& name) {
  std::vector<std::string> heads{"paths",     "rays/point", "pool/point", "indirect %",
                                 "of mean %", "total %",    "average %",  "av. of mean %"};
  for (const int threads : options.threads) heads.push_back(fmt::format("s ({} T)", threads));
  Table table(fmt::format("{}, {}: {} points, {} replicates", scene.name, name, scene.points(),
                          options.replicates),
              heads);
  Series series;
  for (std::uint64_t paths = options.min_paths; paths <= options.max_paths; paths *= 2) {
    std::vector<std::string> times;
    Run run;
    for (const int threads : options.threads) {
      RunPlan plan{method, paths, options.replicates, options.seed, threads, 0.0};
      std::vector<Run> runs;
      const Run best = best_of(scene, plan, options.repeats, &runs);
      times.push_back(fmt::format("{:.4f}", best.seconds));
      if (threads == options.threads.front()) {
        run = runs.front();
        series.seconds.push_back(best.seconds);
      }
    }
    const Errors errors = errors_of(run.field, truth);
    series.rays.push_back(run.rays_per_point());
    series.replicate_error.push_back(errors.replicate);
    series.mean_error.push_back(errors.mean);
    series.average_error.push_back(errors.replicate_average);
    const double pool = static_cast<double>(run.pool_rays) /
                        static_cast<double>(run.field.points * run.field.replicates);
    std::vector<std::string> cells{
        fmt::format("{}", paths),          count(run.rays_per_point()), count(pool),
        percent(errors.replicate),         percent(errors.mean),        percent(errors.total),
        percent(errors.replicate_average), percent(errors.mean_average)};
    cells.insert(cells.end(), times.begin(), times.end());
    table.add(cells);
  }
  table.print();
  fmt::print(
      "  slopes over rays: indirect {:.2f}, of mean {:.2f}, average {:.2f}; over time: {:.2f}\n",
      fitted_exponent(series.rays, series.replicate_error),
      fitted_exponent(series.rays, series.mean_error),
      fitted_exponent(series.rays, series.average_error),
      fitted_exponent(series.seconds, series.replicate_error));
  return series;
}

std::string looked(const Looked& value) {
  return number(value.y) + (value.is_extrapolated ? "*" : "");
}

void compare(const Series& pool, const Series& shared) {
  Table table("equal error of one replicate's indirect part (* extrapolated)",
              {"error %", "pool rays", "shared rays", "ratio", "pool s", "shared s", "ratio"});
  for (const double error : {0.10, 0.05, 0.03, 0.013}) {
    const Looked a = look_up(pool.replicate_error, pool.rays, error);
    const Looked b = look_up(shared.replicate_error, shared.rays, error);
    const Looked c = look_up(pool.replicate_error, pool.seconds, error);
    const Looked d = look_up(shared.replicate_error, shared.seconds, error);
    table.add({percent(error), looked(a), looked(b), number(b.y / a.y), looked(c), looked(d),
               number(d.y / c.y)});
  }
  table.print();
}

}  // namespace

void run_converge(const Options& options) {
  for (const std::string& name : options.names) {
    const BenchScene scene = make_scene(find_room(name));
    const Truth truth = find_truth(scene, options);
    const double direct = average(truth.direct_lx), indirect = average(truth.indirect_lx);
    fmt::print(
        "{}: {} triangles, {} luminaires, average {:.2f} lx, indirect share {:.1f} %, truth "
        "off by {} % of the indirect part\n",
        name, scene.scene.triangle.size(), scene.scene.luminaires.size(), direct + indirect,
        100.0 * indirect / (direct + indirect), percent(truth_error(truth)));
    const Series pool = measure(scene, truth, options, calc::Method::light_pool, "light pool");
    const Series shared = measure(scene, truth, options, calc::Method::instant_radiosity,
                                  "instant radiosity (shared virtual lights)");
    compare(pool, shared);
  }
}

}  // namespace bench
