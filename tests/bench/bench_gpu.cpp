// Both backends on projects: differences, connections per second, and what the CPU does for a
// connection beside the device (in software too, that is on other threads); one CSV line each.
//   bench_gpu PATHS PROJECT.xml...
// PATHS: light paths per replicate, a power of two; one thread, 4 replicates, one look.
#include "calc/project/project_xml.h"
#include "calc/scene/sensor_grid.h"
#include "gpu/gather/gl_gatherer.h"
#include "tests/support/same_sum.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

namespace {

using namespace test_support;

struct Space {
  std::vector<calc::SensorGrid> grids;
  std::vector<calc::PlaneTask> tasks;
};

Space planes_of(const calc::Space& space, calc::Diagnostics& diagnostics) {
  Space result;
  for (const calc::CalcPlane& plane : space.planes) {
    auto grid = calc::make_sensor_grid(plane, space, diagnostics);
    if (grid) result.grids.push_back(std::move(*grid));
  }
  for (std::size_t p = 0; p < result.grids.size(); ++p) {
    result.tasks.push_back({fmt::format("plane {}", p), &result.grids[p]});
  }
  return result;
}

void measure(const std::string& path, std::uint64_t paths, calc::Gatherer& cpu,
             calc::Gatherer& gl) {
  calc::Diagnostics diagnostics;
  const auto project = calc::load_project(calc::DiskFileReader(), path, diagnostics);
  if (!project) {
    fmt::print(stderr, "{} cannot be read\n", path);
    return;
  }
  for (const calc::Space& space : project->spaces) {
    const Space planes = planes_of(space, diagnostics);
    const calc::PreparedScene scene = calc::prepare_scene(*project, space);
    calc::RadiositySettings settings;
    settings.first_paths = settings.max_paths = paths;
    settings.replicates = 4;
    settings.jobs = 1;
    TimedGatherer timed_cpu(cpu), timed_gl(gl);
    const auto a = solve_with(scene, planes.tasks, settings, timed_cpu);
    const double before_s = processor_seconds();
    const auto b = solve_with(scene, planes.tasks, settings, timed_gl);
    const double busy_s = processor_seconds() - before_s;
    const SameSum same = compare_sums(a, b);
    fmt::print("{},{},{},{},{:.2g},{:.2g},{:.2g},{},{:.3g},{:.3g},{:.3g},{:.3g}\n", path, space.id,
               scene.triangle.size(), same.values, same.largest, same.mean_difference(),
               same.largest_grazed, same.grazed,
               static_cast<double>(timed_cpu.connections) / timed_cpu.seconds,
               static_cast<double>(timed_gl.connections) / timed_gl.seconds,
               1e9 * busy_s / static_cast<double>(timed_gl.connections),
               1e9 * timed_gl.processor_s / static_cast<double>(timed_gl.connections));
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "bench_gpu PATHS PROJECT.xml...\n");
    return 2;
  }
  std::string problem;
  const auto device = gpu::DeviceThread::open({}, problem);
  if (!device) {
    fmt::print(stderr, "{}\n", problem);
    return 2;
  }
  const auto gl = gpu::make_gl_gatherer(device);
  const auto cpu = calc::make_cpu_gatherer();
  fmt::print("# {}; {}\n", cpu->description(), gl->description());
  fmt::print(
      "project,space,triangles,values,largest,mean,largest_grazed,grazed,cpu_per_s,gpu_per_s,"
      "cpu_ns_beside_gpu,of_them_in_gatherer\n");
  for (int k = 2; k < argc; ++k) measure(argv[k], std::strtoull(argv[1], nullptr, 10), *cpu, *gl);
  return 0;
}
