// What the model of devices (gpu_model.py) is fed with, counted on the CPU; JSON to stdout:
//   gpu_model_counts [PATHS COLUMNS ROWS]...
// The counters, the error and the seconds of one look at the office with PATHS light paths per
// replicate and so many points; and what a connection takes llvmpipe, where that is the OpenGL
// there is. Node visits of rays are counted by bench_gpu_traversal.
#include "calc/radiosity/phase_timer.h"
#include "calc/radiosity/solve.h"
#include "gpu/gl_gatherer.h"
#include "tests/bench/scenes.h"

#include <fmt/format.h>

#include <ctime>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Relative standard error of the indirect part's and direct part's sum, RMS over points.
double error_of(const calc::PlaneField& field) {
  const auto n = static_cast<double>(field.replicates);
  double squares = 0.0;
  for (std::size_t i = 0; i < field.points; ++i) {
    double sum = 0.0, sum2 = 0.0;
    for (std::size_t r = 0; r < field.replicates; ++r) {
      double lx = 0.0;
      for (std::size_t c = 0; c < field.channels.size(); ++c) {
        const std::size_t k = (r * field.channels.size() + c) * field.points + i;
        lx += field.direct_exact_lx[c * field.points + i];
        if (!field.indirect_lx.empty()) lx += field.indirect_lx[k];
        if (!field.direct_sampled_lx.empty()) lx += field.direct_sampled_lx[k];
      }
      sum += lx;
      sum2 += lx * lx;
    }
    const double mean = sum / n;
    if (mean > 0.0) squares += std::max(0.0, sum2 / n - mean * mean) / (n - 1.0) / (mean * mean);
  }
  return std::sqrt(squares / static_cast<double>(field.points));
}

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct LookRun {
  calc::SpaceSolution solution;
  double processor_s = 0, busy = 0;  // of all threads; of the clock
};

// One look on one thread, but for those that the gatherer has.
LookRun look(const bench::BenchScene& scene, std::uint64_t paths, calc::Gatherer& gatherer) {
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = paths;
  settings.jobs = 1;
  const auto go_on = [](std::size_t, const calc::PlaneField&, calc::Look) {
    return calc::LookAnswer{};
  };
  LookRun run;
  const double begin_s = calc::now_s(), cpu_begin_s = processor_s();
  run.solution = calc::solve_illuminance(scene.scene, {{"plane", &scene.grid}}, settings, 0.95,
                                         {gatherer}, go_on, {});
  run.processor_s = processor_s() - cpu_begin_s;
  run.busy = run.processor_s / (calc::now_s() - begin_s);
  const std::string& problem = run.solution.fields.front().problem;
  if (!problem.empty()) throw std::runtime_error(problem);
  return run;
}

// Processor time of a connection by OpenGL; null if that is no software: it would not be its time.
std::string software_json(const bench::BenchScene& scene, std::uint64_t paths) {
  std::string problem;
  const auto device = gpu::DeviceThread::open({}, problem);
  if (!device || !device->device().is_software) return "null";
  const auto gl = gpu::make_gl_gatherer(device);
  const auto cpu = calc::make_cpu_gatherer();
  look(scene, paths, *gl);  // compiled
  const LookRun by_cpu = look(scene, paths, *cpu), by_gl = look(scene, paths, *gl);
  const double connect_s =
      by_gl.processor_s - by_cpu.processor_s + by_cpu.busy * by_cpu.solution.times.connect_s;
  const auto connections =
      static_cast<double>(by_gl.solution.fields.front().counters.connection_rays);
  return fmt::format(
      "{{\"tree\": \"eight\", \"renderer\": \"{}\", \"points\": {}, \"draws\": {}, "
      "\"ns_per_connection\": {:.0f}}}",
      device->device().renderer, scene.points(), calc::draws_per_point(paths, scene.points()),
      1e9 * connect_s / connections);
}

std::string look_json(const bench::BenchScene& scene, std::uint64_t paths) {
  const auto gatherer = calc::make_cpu_gatherer();
  const LookRun run = look(scene, paths, *gatherer);
  // Others may use the machine: phases are the clock's, put right by the processor's time.
  const double busy = run.busy;
  const calc::SpaceSolution& s = run.solution;
  const calc::PlaneField& field = s.fields.front();
  return fmt::format(
      "{{\"points\": {}, \"paths\": {}, \"replicates\": {}, \"error\": {:.6f}, \"pool_rays\": {}, "
      "\"direct_rays\": {}, \"connections\": {}, \"near_rays\": {}, \"seconds\": {{\"direct\": "
      "{:.3f}, \"light_paths\": {:.3f}, \"connections\": {:.3f}, \"near_field\": {:.3f}}}}}",
      scene.points(), paths, field.replicates, error_of(field), s.pool_rays,
      field.counters.direct_rays, field.counters.connection_rays, field.counters.near_rays,
      busy * s.times.direct_s, busy * s.times.pool_s, busy * s.times.connect_s,
      busy * s.times.near_s);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::string looks;
    for (int k = 1; k + 2 < argc; k += 3) {
      const bench::BenchScene sized =
          make_scene(bench::office(std::atoi(argv[k + 1]), std::atoi(argv[k + 2])));
      looks += fmt::format("{}\n    {}", looks.empty() ? "" : ",",
                           look_json(sized, std::strtoull(argv[k], nullptr, 10)));
    }
    const bench::BenchScene scene = make_scene(bench::office(40, 25));
    fmt::print("{{\n  \"scene\": \"office\",\n  \"triangles\": {},\n  \"llvmpipe\": {},\n",
               scene.scene.triangle.size(), software_json(scene, 256));
    fmt::print("  \"looks\": [{}]\n}}\n", looks);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
