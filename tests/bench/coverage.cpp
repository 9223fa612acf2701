// How often 95 % intervals hold the truth, over many seeds, at awkward points.
#include "calc/base/statistics.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "tests/bench/experiments.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace bench {
namespace {

struct Count {
  double covered = 0.0, all = 0.0;
  double share() const { return covered / all; }
};

// Mean of the indirect replicates with the exact direct part in front of the statistics.
calc::Estimate interval_of(const std::vector<std::vector<double>>& replicates,
                           const std::vector<double>& direct_lx, std::size_t point) {
  std::vector<double> values;
  for (const auto& replicate : replicates) values.push_back(direct_lx[point] + replicate[point]);
  return calc::t_interval(values, 0.95);
}

struct SceneCounts {
  std::vector<Count> points;
  Count average;
  std::vector<double> bias;   // sum over seeds, relative to the truth
  double minimum_bias = 0.0;  // of the smallest mean, sum over seeds
  double seconds = 0.0;
};

void add_seed(const BenchScene& scene, const Truth& truth, const Options& options,
              std::uint64_t seed, SceneCounts& counts) {
  const double begin_s = calc::now_s();
  const Run run = run_core(scene, {calc::Method::light_pool, options.min_paths, options.replicates,
                                   seed, options.threads.back(), 0.0});
  counts.seconds += calc::now_s() - begin_s;
  const auto replicates = indirect_replicates(run.field);
  double least = 1e300, true_least = 1e300;
  for (std::size_t i = 0; i < scene.points(); ++i) {
    const double total = truth.direct_lx[i] + truth.indirect_lx[i];
    const calc::Estimate e = interval_of(replicates, truth.direct_lx, i);
    counts.points[i].covered += e.low <= total && total <= e.high ? 1.0 : 0.0;
    counts.points[i].all += 1.0;
    counts.bias[i] += e.value / total - 1.0;
    least = std::min(least, e.value);
    true_least = std::min(true_least, total);
  }
  counts.minimum_bias += least / true_least - 1.0;
  std::vector<double> averages;
  for (const auto& replicate : replicates) averages.push_back(average(replicate));
  const calc::Estimate e = calc::t_interval(averages, 0.95);
  const double truth_average = average(truth.indirect_lx);
  counts.average.covered += e.low <= truth_average && truth_average <= e.high ? 1.0 : 0.0;
  counts.average.all += 1.0;
}

}  // namespace

void run_coverage(const Options& options) {
  const int seeds = options.names.empty() ? 400 : std::atoi(options.names.front().c_str());
  if (seeds < 1) throw std::runtime_error("coverage: the number of seeds must be 1 or more");
  Count pooled, pooled_average;
  double worst = 1.0;
  Table table(fmt::format("coverage of 95 % intervals in %, {} seeds, {} paths x {} replicates",
                          seeds, options.min_paths, options.replicates),
              {"scene", "truth's error %", "points", "all points", "least point", "where",
               "most |bias| %", "where", "average", "bias of plain minimum %", "s per seed"});
  for (const RoomModel& room : coverage_rooms()) {
    const BenchScene scene = make_scene(room);
    const Truth truth = find_truth(scene, options);
    SceneCounts counts;
    counts.points.resize(scene.points());
    counts.bias.resize(scene.points());
    for (int seed = 0; seed < seeds; ++seed) {
      add_seed(scene, truth, options, options.seed + static_cast<std::uint64_t>(seed), counts);
    }
    Count here;
    std::size_t least = 0, biased = 0;
    for (std::size_t i = 0; i < scene.points(); ++i) {
      here.covered += counts.points[i].covered;
      here.all += counts.points[i].all;
      if (counts.points[i].covered < counts.points[least].covered) least = i;
      if (std::abs(counts.bias[i]) > std::abs(counts.bias[biased])) biased = i;
    }
    pooled.covered += here.covered;
    pooled.all += here.all;
    pooled_average.covered += counts.average.covered;
    pooled_average.all += counts.average.all;
    worst = std::min(worst, here.share());
    table.add({room.name, percent(truth_error(truth)), fmt::format("{}", scene.points()),
               percent(here.share()), percent(counts.points[least].share()), scene.label[least],
               percent(counts.bias[biased] / seeds), scene.label[biased],
               percent(counts.average.share()), percent(counts.minimum_bias / seeds),
               fmt::format("{:.4f}", counts.seconds / seeds)});
  }
  table.print();
  // Points of one run share their light paths: a run counts as one for the error.
  fmt::print(
      "  pooled: points {} % (goal 93.5 to 96.5), averages {} % +- {:.1f}; least scene {} % "
      "(goal 90)\n",
      percent(pooled.share()), percent(pooled_average.share()),
      196.0 * std::sqrt(0.95 * 0.05 / pooled_average.all), percent(worst));
}

}  // namespace bench
