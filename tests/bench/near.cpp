// Points next to walls, in corners and beside washed walls: error, bias and intervals.
#include "calc/base/statistics.h"
#include "tests/bench/experiments.h"
#include "tests/bench/path_tracing.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bench {
namespace {

constexpr std::uint64_t kPaths = 4096;

// Over the points of one label.
struct Cell {
  int points = 0, inside = 0;
  double squares = 0.0, replicates = 0.0, bias = 0.0, truth_squares = 0.0;
};

using Cells = std::map<std::string, Cell>;

// Adds one method's replicates, in % of the truth's indirect part.
Cells compare(const BenchScene& scene, const Truth& truth,
              const std::vector<std::vector<double>>& replicates) {
  Cells cells;
  std::vector<double> values(replicates.size());
  for (std::size_t i = 0; i < scene.points(); ++i) {
    Cell& cell = cells[scene.label[i]];
    const double indirect = truth.indirect_lx[i];
    for (std::size_t r = 0; r < values.size(); ++r) {
      values[r] = replicates[r][i];
      cell.squares += std::pow(values[r] / indirect - 1.0, 2);
    }
    const calc::Estimate estimate = calc::t_interval(values, 0.95);
    const double spare = 2.0 * truth.error_lx[i];  // the truth has an error of its own
    cell.inside += estimate.low - spare <= indirect && indirect <= estimate.high + spare ? 1 : 0;
    cell.bias += estimate.value / indirect - 1.0;
    cell.truth_squares += std::pow(truth.error_lx[i] / indirect, 2);
    cell.replicates += static_cast<double>(values.size());
    ++cell.points;
  }
  return cells;
}

std::string error_cell(const Cell& cell) {
  return percent(std::sqrt(cell.squares / cell.replicates));
}
std::string bias_cell(const Cell& cell) { return percent(cell.bias / cell.points); }
std::string inside_cell(const Cell& cell) { return fmt::format("{}/{}", cell.inside, cell.points); }

// The bench's own clamped instant radiosity: one set of lights per replicate, for all points.
std::vector<std::vector<double>> clamped_replicates(const BenchScene& scene, std::uint64_t paths,
                                                    int replicates, std::uint64_t seed) {
  const calc::Tracer tracer(scene.scene);
  const calc::Emitter emitter(scene.scene);
  std::vector<std::vector<double>> lx;
  for (int r = 0; r < replicates; ++r) {
    const LightTrace light =
        trace_light(tracer, emitter, Roulette::per_bounce, static_cast<std::uint32_t>(paths),
                    seed * 1000 + static_cast<std::uint64_t>(r));
    lx.push_back(connect_clamped(tracer, scene, light.vertices, 1.0));
  }
  return lx;
}

void measure(const BenchScene& scene, const Options& options) {
  const Truth truth = find_truth(scene, options);
  const std::uint64_t paths = std::min(kPaths, options.max_paths);
  RunPlan plan{calc::Method::light_pool, paths, options.replicates, options.seed,
               options.threads.back(),   0.0};
  const Run pool_run = run_core(scene, plan);
  plan.method = calc::Method::instant_radiosity;
  const Run shared_run = run_core(scene, plan);
  const Cells pool = compare(scene, truth, indirect_replicates(pool_run.field));
  const Cells shared = compare(scene, truth, indirect_replicates(shared_run.field));
  Cells clamped;
  if (has_clamp()) {
    plan.clamp_per_m2 = 1.0;
    clamped = compare(scene, truth, indirect_replicates(run_core(scene, plan).field));
  } else {
    clamped =
        compare(scene, truth, clamped_replicates(scene, paths, options.replicates, options.seed));
  }
  Table table(fmt::format("{}: % of the indirect part, {} paths; rays/point: pool {:.0f}, shared "
                          "{:.0f}; clamp b = 1 {}",
                          scene.name, paths, pool_run.rays_per_point(), shared_run.rays_per_point(),
                          has_clamp() ? "by the core" : "by the benchmark's own code"),
              {"point", "truth's", "pool error", "bias", "inside", "shared error", "bias", "inside",
               "clamped error", "bias", "inside"});
  for (std::size_t i = 0; i < scene.points(); ++i) {
    if (i > 0 && scene.label[i] == scene.label[i - 1]) continue;
    const std::string& label = scene.label[i];
    std::vector<std::string> row{
        label, percent(std::sqrt(pool.at(label).truth_squares / pool.at(label).points))};
    for (const Cells* cells : std::array<const Cells*, 3>{&pool, &shared, &clamped}) {
      const Cell& cell = cells->at(label);
      row.insert(row.end(), {error_cell(cell), bias_cell(cell), inside_cell(cell)});
    }
    table.add(row);
  }
  table.print();
}

// Whole planes under narrow beams.
void measure_planes(const Options& options) {
  Table table("narrow beams, plane at 0.8 m: RMS error of the indirect part in %",
              {"scene", "truth's", "pool", "rays/point", "shared", "rays/point"});
  for (const char* name : {"spots", "uplights", "washers"}) {
    const BenchScene scene = make_scene(find_room(name));
    const Truth truth = find_truth(scene, options);
    RunPlan plan{calc::Method::light_pool, std::min(kPaths, options.max_paths),
                 options.replicates,       options.seed,
                 options.threads.back(),   0.0};
    const Run pool = run_core(scene, plan);
    plan.method = calc::Method::instant_radiosity;
    const Run shared = run_core(scene, plan);
    table.add({name, percent(truth_error(truth)), percent(errors_of(pool.field, truth).replicate),
               count(pool.rays_per_point()), percent(errors_of(shared.field, truth).replicate),
               count(shared.rays_per_point())});
  }
  table.print();
}

}  // namespace

void run_near(const Options& options) {
  const std::vector<std::string> all{"12", "1000", "washers", "spots"};
  for (const std::string& kind : options.names.empty() ? all : options.names) {
    measure(make_scene(near_room(kind)), options);
  }
  if (options.names.empty()) measure_planes(options);
}

}  // namespace bench
