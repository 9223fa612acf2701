// Rooms that absorb little: error of the plane average against rays, growth of the cost, and the
// gain of one roulette number per path over one per bounce.
#include "calc/base/statistics.h"
#include "tests/bench/experiments.h"
#include "tests/bench/path_tracing.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

constexpr int kWalks = 32;               // repetitions of the benchmark's own walks
constexpr double kMostWalkRays = 2.0e5;  // of one repetition
constexpr std::uint64_t kFewestPaths = 16;

struct Walks {
  double rays = 0.0;              // of one repetition
  double average_variance = 0.0;  // relative, of the plane average
  double balance_variance = 0.0;  // relative, of the absorbed flux
};

Walks walk(const BenchScene& scene, Roulette roulette, std::uint32_t paths, std::uint64_t seed,
           double truth_average) {
  const calc::Tracer tracer(scene.scene);
  const calc::Emitter emitter(scene.scene);
  Walks walks;
  for (int k = 0; k < kWalks; ++k) {
    const LightTrace light =
        trace_light(tracer, emitter, roulette, paths, seed * 1000 + static_cast<std::uint64_t>(k));
    walks.rays += static_cast<double>(light.rays) / kWalks;
    const double off = average(connect_unoccluded(scene, light.vertices)) / truth_average - 1.0;
    walks.average_variance += off * off / kWalks;
    walks.balance_variance +=
        std::pow((light.absorbed_lm + light.escaped_lm) / emitter.flux_lm() - 1.0, 2) / kWalks;
  }
  return walks;
}

// The same error with rays like the core's: the variance of independent walks falls as 1 / rays.
std::string gain(double variance, double rays, double core_variance, double core_rays) {
  return fmt::format("{:.1f}", variance * rays / (core_variance * core_rays));
}

double average_flux_residual(const Run& run) {
  return run.balance.absorbed_lm.value / run.balance.emitted_lm - 1.0;
}

struct Cost {
  double rays_to_target = 0.0;  // of one replicate, to 1 % of the plane's average
};

// The same effort for every reflectance: fewer of the paths that are longer.
Options for_reflectance(Options options, double reflectance) {
  std::uint64_t fewer = 1;
  while (static_cast<double>(fewer) * 2.0 <= 0.1 / (1.0 - reflectance)) fewer *= 2;
  options.min_paths = std::max(kFewestPaths, options.min_paths / fewer);
  options.max_paths = std::max(options.min_paths, options.max_paths / fewer);
  options.reference_paths = std::max(kFewestPaths, options.reference_paths / fewer);
  return options;
}

Cost measure(const BenchScene& scene, const Options& given, double reflectance) {
  const Options options = for_reflectance(given, reflectance);
  const Truth truth = find_truth(scene, options);
  const double truth_average = average(truth.indirect_lx);
  Table table(fmt::format("{}: {} points, truth off by {} %; per replicate", scene.name,
                          scene.points(), percent(truth_error(truth))),
              {"paths", "pool rays", "all rays", "average %", "of mean %", "points %", "balance %",
               "+-", "walk paths", "walk rays", "per-bounce av. %", "balance %", "gain, light rays",
               "gain, all rays", "roulette alone"});
  std::vector<double> rays, errors;
  for (std::uint64_t paths = options.min_paths; paths <= options.max_paths; paths *= 2) {
    const Run run = run_core(scene, {calc::Method::light_pool, paths, options.replicates,
                                     options.seed, options.threads.back(), 0.0});
    const Errors e = errors_of(run.field, truth);
    rays.push_back(run.rays_per_replicate());
    errors.push_back(e.replicate_average);
    const double pool_rays =
        static_cast<double>(run.pool_rays) / static_cast<double>(run.field.replicates);
    std::vector<std::string> row{
        fmt::format("{}", paths),
        count(pool_rays),
        count(run.rays_per_replicate()),
        percent(e.replicate_average),
        percent(e.mean_average),
        percent(e.replicate),
        percent(average_flux_residual(run)),
        percent(run.balance.absorbed_lm.half_width() / run.balance.emitted_lm)};
    if (static_cast<double>(paths) / (1.0 - reflectance) <= kMostWalkRays && scene.is_convex) {
      const auto walk_paths = static_cast<std::uint32_t>(paths);
      const Walks bounce =
          walk(scene, Roulette::per_bounce, walk_paths, options.seed, truth_average);
      const Walks one = walk(scene, Roulette::one_number, walk_paths, options.seed, truth_average);
      const double core = e.replicate_average * e.replicate_average;
      row.insert(
          row.end(),
          {fmt::format("{}", walk_paths), count(bounce.rays),
           percent(std::sqrt(bounce.average_variance)), percent(std::sqrt(bounce.balance_variance)),
           gain(bounce.average_variance, bounce.rays, core, pool_rays),
           gain(bounce.average_variance, bounce.rays, core, run.rays_per_replicate()),
           gain(bounce.average_variance, bounce.rays, one.average_variance, one.rays)});
    }
    table.add(row);
  }
  table.print();
  fmt::print("  slope of the average's error over rays: {:.2f}\n", fitted_exponent(rays, errors));
  return {look_up(errors, rays, 0.01).y};
}

// A closed room: what its surfaces absorb is what the luminaires give.
void check_surface_balance(double reflectance, const Options& options) {
  const BenchScene scene = make_scene(box_surface(reflectance));
  const std::uint64_t paths = for_reflectance(options, reflectance).min_paths;
  const Run run = run_core(scene, {calc::Method::light_pool, paths, options.replicates,
                                   options.seed, options.threads.back(), 0.0});
  double direct = 0.0;
  for (const double lx : run.field.direct_exact_lx)
    direct += lx / static_cast<double>(run.field.points);
  std::vector<double> absorbed;
  for (const auto& replicate : indirect_replicates(run.field)) {
    absorbed.push_back((1.0 - reflectance) * (direct + average(replicate)) *
                       surface_area_m2(scene.scene) / run.balance.emitted_lm);
  }
  const calc::Estimate share = calc::t_interval(absorbed, 0.95);
  fmt::print("  box rho {}: sum (1 - rho) E A = {:.5f} +- {:.5f} of the flux\n", reflectance,
             share.value, share.half_width());
}

void check_sphere(double reflectance, const Options& options) {
  const BenchScene scene = make_scene(sphere(reflectance));
  const std::uint64_t paths = for_reflectance(options, reflectance).min_paths;
  const Run run = run_core(scene, {calc::Method::light_pool, paths, options.replicates,
                                   options.seed, options.threads.back(), 0.0});
  const double closed_form_lx =
      run.balance.emitted_lm * reflectance / (1.0 - reflectance) / surface_area_m2(scene.scene);
  std::vector<double> ratio;
  for (const auto& replicate : indirect_replicates(run.field)) {
    ratio.push_back(average(replicate) / closed_form_lx);
  }
  const calc::Estimate share = calc::t_interval(ratio, 0.95);
  fmt::print("  sphere rho {}: indirect average / closed form = {:.5f} +- {:.5f}\n", reflectance,
             share.value, share.half_width());
}

}  // namespace

void run_stiff(const Options& options) {
  const std::vector<double> reflectances{0.9, 0.99, 0.999};
  std::vector<double> mean_lengths, costs;
  for (const double rho : reflectances) {
    mean_lengths.push_back(1.0 / (1.0 - rho));
    costs.push_back(measure(make_scene(box(rho)), options, rho).rays_to_target);
  }
  fmt::print(
      "\nrays of a replicate to 1 % of the box's average: {:.0f}, {:.0f}, {:.0f}; exponent over "
      "1/(1 - rho): {:.2f}\n",
      costs[0], costs[1], costs[2], fitted_exponent(mean_lengths, costs));
  for (const double rho : reflectances) measure(make_scene(sphere(rho)), options, rho);
  measure(make_scene(find_room("corridor")), options, 0.9);
  fmt::print("\nclosed forms, 95 % intervals\n");
  for (const double rho : reflectances) {
    check_surface_balance(rho, options);
    check_sphere(rho, options);
  }
}

}  // namespace bench
