#include "report/tools/converge/converge_estimators.h"

#include "calc/radiosity/paths/path_tracing.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/threads.h"
#include "gpu/gather/gl_gatherer.h"
#include "gpu/raster/shadow_map_gatherer.h"
#include "gpu/rays/gl_direct_tracer.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/gl_short_rays.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cli {
namespace {

constexpr std::uint64_t kFirstPaths = 1024;  // as `check` begins

// Who computes what; opened for the first run of a method and kept for the others.
struct Workers {
  std::unique_ptr<calc::Gatherer> gatherer;
  std::unique_ptr<calc::PathTracer> path_tracer;      // null: the CPU
  std::unique_ptr<calc::ShortRayCaster> short_rays;   // null: the CPU
  std::unique_ptr<calc::DirectTracer> direct_tracer;  // null: the CPU

  calc::Stages stages() const {
    return {*gatherer, path_tracer.get(), short_rays.get(), direct_tracer.get()};
  }
};

EstimatorRun run_solver(const EstimatorContext& context, const Workers& workers,
                        calc::RadiositySettings settings, std::uint64_t paths, std::uint64_t seed) {
  settings.seed = seed;
  settings.replicates = context.replicates;
  settings.jobs = context.jobs;
  settings.max_paths = paths;
  settings.first_paths = std::min(kFirstPaths, paths);
  const auto go_on = [](std::size_t, const calc::PlaneField&, calc::Look) {
    return calc::LookAnswer{};
  };
  const auto progress = [](const calc::SolveProgress&) { return !interrupted(); };
  EstimatorRun run;
  const double begin_s = calc::now_s();
  calc::SpaceSolution solution = calc::solve_illuminance(context.scene, context.tasks, settings,
                                                         0.95, workers.stages(), go_on, progress);
  run.seconds = calc::now_s() - begin_s;
  run.times = solution.times;
  run.light_rays = run.rays = solution.pool_rays;
  run.fields = std::move(solution.fields);
  return run;
}

Workers on_cpu(const EstimatorContext&, std::uint32_t) {
  return {calc::make_cpu_gatherer(), {}, {}, {}};
}

Workers on_gpu(const EstimatorContext& context, std::uint32_t) {
  return {gpu::make_gl_gatherer(context.device), gpu::make_gl_path_tracer(context.device),
          gpu::make_gl_short_rays(context.device), gpu::make_gl_direct_tracer(context.device)};
}

// Light paths on the CPU, as `check --visibility shadow-map` does.
Workers with_maps(const EstimatorContext& context, std::uint32_t texels) {
  return {gpu::make_shadow_map_gatherer(context.device, texels), {}, {}, {}};
}

calc::RadiositySettings core_settings(const EstimatorContext&, std::uint32_t) { return {}; }

calc::RadiositySettings shared_settings(const EstimatorContext&, std::uint32_t texels) {
  calc::RadiositySettings settings;
  settings.method = calc::Method::instant_radiosity;
  settings.shadow_map_texels = texels;
  return settings;
}

calc::RadiositySettings clamped_settings(const EstimatorContext& context, std::uint32_t) {
  calc::RadiositySettings settings = shared_settings(context, 0);
  settings.clamp_per_m2 = context.clamp_per_m2;
  return settings;
}

EstimatorRun run_paths(const EstimatorContext& context, std::uint64_t paths, std::uint64_t seed) {
  EstimatorRun run;
  calc::on_threads(context.jobs, [&] {
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
  bool needs_opengl = false;
  // Without them it is path tracing from the points.
  Workers (*workers)(const EstimatorContext&, std::uint32_t texels) = nullptr;
  calc::RadiositySettings (*settings)(const EstimatorContext&, std::uint32_t texels) = nullptr;
};
constexpr std::string_view kShadowMap = "shadow-map:";
constexpr std::array kEstimators{
    Entry{"core", "luxgate's core", false, on_cpu, core_settings},
    Entry{"gpu", "luxgate's core on the GPU", true, on_gpu, core_settings},
    Entry{"instant-radiosity", "instant radiosity", false, on_cpu, shared_settings},
    Entry{"clamped-instant-radiosity", "instant radiosity, clamped", false, on_cpu,
          clamped_settings},
    Entry{"shadow-map:N", "shadow maps", true, with_maps, shared_settings},
    Entry{"path-tracing", "path tracing"}};

// 0: of no shadow maps.
std::uint32_t texels_of(const std::string& name) {
  std::uint32_t texels = 0;
  if (name.starts_with(kShadowMap)) visibility(texels)(name);
  return texels;
}

const Entry* look_up(const std::string& name) {
  const std::string_view key = texels_of(name) > 0 ? "shadow-map:N" : std::string_view(name);
  if (key == "shadow-map:N" && texels_of(name) == 0) return nullptr;
  const auto* found = std::find_if(kEstimators.begin(), kEstimators.end(),
                                   [&](const Entry& entry) { return entry.name == key; });
  return found != kEstimators.end() ? found : nullptr;
}

// What is counted the same way for every method.
void count(EstimatorRun& run) {
  run.is_interrupted = interrupted();
  for (const calc::PlaneField& field : run.fields) {
    run.rays += field.counters.connection_rays + field.counters.near_rays;
    if (run.problem.empty() && !field.problem.empty()) {
      run.problem = "plane '" + field.plane_id + "': " + field.problem.english();
    }
  }
}

EstimatorRun run_once(const Entry& entry, const EstimatorContext& context, const Workers& workers,
                      std::uint32_t texels, std::uint64_t paths, std::uint64_t seed) {
  EstimatorRun run =
      entry.workers == nullptr
          ? run_paths(context, paths, seed)
          : run_solver(context, workers, entry.settings(context, texels), paths, seed);
  count(run);
  return run;
}

}  // namespace

std::vector<std::string_view> estimator_names() {
  std::vector<std::string_view> names;
  for (const Entry& entry : kEstimators) names.push_back(entry.name);
  return names;
}

std::string estimator_problem(const std::string& name) {
  if (look_up(name) != nullptr) return "";
  if (name.starts_with(kShadowMap)) {
    return fmt::format("'{}': N of shadow-map:N is a power of two from {} to {}", name,
                       calc::kFewestShadowMapTexels, calc::kMostShadowMapTexels);
  }
  return one_of_message(name, estimator_names());
}

std::string estimator_title(const std::string& name) {
  const std::uint32_t texels = texels_of(name);
  const std::string_view title = look_up(name)->title;
  return texels > 0 ? fmt::format("{} of {}", title, texels) : std::string(title);
}

bool needs_opengl(const std::string& name) { return look_up(name)->needs_opengl; }

Estimator find_estimator(const std::string& name) {
  return [&entry = *look_up(name), texels = texels_of(name), workers = std::make_shared<Workers>()](
             const EstimatorContext& context, std::uint64_t paths, std::uint64_t seed) {
    if (entry.workers != nullptr && !workers->gatherer) {
      *workers = entry.workers(context, texels);
      // Programs are compiled when they are first wanted.
      if (entry.needs_opengl) run_once(entry, context, *workers, texels, paths, seed);
    }
    return run_once(entry, context, *workers, texels, paths, seed);
  };
}

}  // namespace cli
