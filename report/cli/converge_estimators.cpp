#include "report/cli/converge_estimators.h"

#include "calc/radiosity/path_tracing.h"
#include "calc/radiosity/phase_timer.h"
#include "report/cli/interrupt.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

namespace cli {
namespace {

constexpr std::uint64_t kFirstPaths = 1024;  // as `check` begins

EstimatorRun run_solver(const EstimatorContext& context, calc::RadiositySettings settings,
                        std::uint64_t paths, std::uint64_t seed) {
  settings.seed = seed;
  settings.replicates = context.replicates;
  settings.jobs = context.jobs;
  settings.max_paths = paths;
  settings.first_paths = std::min(kFirstPaths, paths);
  const auto go_on = [](std::size_t, const calc::PlaneField&, calc::Look) {
    return calc::LookAnswer{};
  };
  const auto progress = [](const calc::SolveProgress&) { return !interrupted(); };
  const std::unique_ptr<calc::Gatherer> gatherer = calc::make_cpu_gatherer();
  EstimatorRun run;
  const double begin_s = calc::now_s();
  calc::SpaceSolution solution = calc::solve_illuminance(context.scene, context.tasks, settings,
                                                         0.95, *gatherer, go_on, progress);
  run.seconds = calc::now_s() - begin_s;
  run.times = solution.times;
  run.light_rays = run.rays = solution.pool_rays;
  run.fields = std::move(solution.fields);
  return run;
}

EstimatorRun run_core(const EstimatorContext& context, std::uint64_t paths, std::uint64_t seed) {
  return run_solver(context, {}, paths, seed);
}

EstimatorRun run_shared(const EstimatorContext& context, std::uint64_t paths, std::uint64_t seed) {
  calc::RadiositySettings settings;
  settings.method = calc::Method::instant_radiosity;
  return run_solver(context, settings, paths, seed);
}

EstimatorRun run_clamped(const EstimatorContext& context, std::uint64_t paths, std::uint64_t seed) {
  calc::RadiositySettings settings;
  settings.method = calc::Method::instant_radiosity;
  settings.clamp_per_m2 = context.clamp_per_m2;
  return run_solver(context, settings, paths, seed);
}

EstimatorRun run_paths(const EstimatorContext& context, std::uint64_t paths, std::uint64_t seed) {
  tbb::task_arena arena(context.jobs > 0 ? context.jobs : tbb::task_arena::automatic);
  EstimatorRun run;
  arena.execute([&] {
    const double begin_s = calc::now_s();
    const calc::Tracer tracer(context.scene);
    run.times.build_s = calc::now_s() - begin_s;
    for (const calc::PlaneTask& task : context.tasks) {
      if (interrupted()) return;
      run.fields.push_back(calc::trace_from_points(
          tracer, task.plane_id, *task.grid,
          {paths, context.replicates, seed, [] { return !interrupted(); }}));
    }
    run.seconds = calc::now_s() - begin_s;
    run.times.near_s = run.seconds - run.times.build_s;
  });
  return run;
}

struct Entry {
  std::string_view name, title;
  EstimatorRun (*run)(const EstimatorContext&, std::uint64_t, std::uint64_t);
};
constexpr std::array kEstimators{
    Entry{"core", "luxgate's core", run_core},
    Entry{"instant-radiosity", "instant radiosity", run_shared},
    Entry{"clamped-instant-radiosity", "instant radiosity, clamped", run_clamped},
    Entry{"path-tracing", "path tracing", run_paths}};

const Entry& entry_of(std::string_view name) {
  return *std::find_if(kEstimators.begin(), kEstimators.end(),
                       [&](const Entry& entry) { return entry.name == name; });
}

// What is counted the same way for every method.
void count(EstimatorRun& run) {
  run.is_interrupted = interrupted();
  for (const calc::PlaneField& field : run.fields) {
    run.rays += field.counters.connection_rays + field.counters.near_rays;
    if (run.problem.empty() && !field.problem.empty()) {
      run.problem = "plane '" + field.plane_id + "': " + field.problem;
    }
  }
}

}  // namespace

std::vector<std::string_view> estimator_names() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kEstimators) names.push_back(entry.name);
  return names;
}

std::string_view estimator_title(std::string_view name) { return entry_of(name).title; }

Estimator find_estimator(std::string_view name) {
  return [run = entry_of(name).run](const EstimatorContext& context, std::uint64_t paths,
                                    std::uint64_t seed) {
    EstimatorRun result = run(context, paths, seed);
    count(result);
    return result;
  };
}

}  // namespace cli
