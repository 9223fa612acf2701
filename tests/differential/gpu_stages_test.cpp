// The whole calculation with some of its stages on the device.
#include "calc/base/statistics.h"
#include "calc/project/project_xml.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/opengl.h"
#include "tests/support/same_sum.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gpu_stages_test {
namespace {

using namespace test_support;

// One context for all stages, as in the program.
struct Device {
  std::shared_ptr<gpu::DeviceThread> thread;
  std::unique_ptr<calc::Gatherer> cpu = calc::make_cpu_gatherer();
  std::unique_ptr<calc::Gatherer> gatherer = gpu::make_gl_gatherer(thread);
  std::unique_ptr<calc::PathTracer> paths = gpu::make_gl_path_tracer(thread);
  std::unique_ptr<calc::ShortRayCaster> near = gpu::make_gl_short_rays(thread);
  std::unique_ptr<calc::DirectTracer> direct = gpu::make_gl_direct_tracer(thread);

  calc::Stages all() const { return {*gatherer, paths.get(), near.get(), direct.get()}; }

  explicit Device(gpu::Fault fault = gpu::Fault::none) : thread(gl_device(fault)) {}
};

struct Hall {
  LampHall hall{0.6};
  calc::SensorGrid task, corner;
  std::vector<calc::PlaneTask> tasks{{"task", &task}, {"corner", &corner}};

  Hall() {
    for (int i = 0; i < 80; ++i) {
      task.position_m.emplace_back(-3.795 + 0.09 * i, -2.7 + 0.06 * i, 0.05);
      task.normal.emplace_back(0, 0, 1);
      corner.position_m.emplace_back(-3.98, -2.9 + 0.07 * i, 0.03);  // short rays matter here
      corner.normal.emplace_back(1, 0, 0);
    }
  }
};

calc::RadiositySettings settings_of(std::uint64_t paths, int jobs) {
  calc::RadiositySettings settings;
  settings.first_paths = paths / 2;
  settings.max_paths = paths;
  settings.replicates = 4;
  settings.jobs = jobs;
  return settings;
}

// Means of replicates against each other's intervals: the random numbers are the same, so that the
// difference is a small part of them.
void expect_within_intervals(const std::vector<calc::PlaneField>& a,
                             const std::vector<calc::PlaneField>& b) {
  for (std::size_t p = 0; p < a.size(); ++p) {
    for (std::size_t i = 0; i < a[p].points; ++i) {
      const calc::ReplicateMean x = calc::replicate_mean(replicates_at(a[p], i));
      const calc::ReplicateMean y = calc::replicate_mean(replicates_at(b[p], i));
      EXPECT_LE(std::abs(x.mean - y.mean), x.standard_error + y.standard_error) << p << " " << i;
    }
  }
}

void expect_near(const std::vector<double>& a_lx, const std::vector<double>& b_lx) {
  ASSERT_EQ(a_lx.size(), b_lx.size());
  for (std::size_t i = 0; i < a_lx.size(); ++i)
    EXPECT_NEAR(a_lx[i], b_lx[i], 1e-6 * std::abs(a_lx[i])) << i;
}

// The same samples, but for rays that graze an edge, of which these scenes have none.
void expect_same_direct_light(const std::vector<calc::PlaneField>& a,
                              const std::vector<calc::PlaneField>& b) {
  for (std::size_t p = 0; p < a.size(); ++p) {
    EXPECT_GT(a[p].direct_exact_lx.size() + a[p].direct_sampled_lx.size(), 0u);
    expect_near(a[p].direct_exact_lx, b[p].direct_exact_lx);
    expect_near(a[p].direct_sampled_lx, b[p].direct_sampled_lx);
    EXPECT_EQ(a[p].counters.direct_rays, b[p].counters.direct_rays);
  }
}

TEST(GlStages, GiveTheSameSumEachAndTogether) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall;
  const Device device;
  const calc::RadiositySettings settings = settings_of(512, 2);
  const double begin_s = calc::now_s();
  const auto cpu = solve_with(hall.hall.scene, hall.tasks, settings, *device.cpu);
  std::printf("cpu: %.2f s\n", calc::now_s() - begin_s);
  const auto compare = [&](const char* name, const calc::Stages& stages, double most_grazed,
                           double most_mean) {
    SCOPED_TRACE(name);
    const double start_s = calc::now_s();
    const auto gl = solve_with(hall.hall.scene, hall.tasks, settings, stages);
    const double took_s = calc::now_s() - start_s;
    const SameSum same = compare_sums(cpu, gl);
    std::printf(
        "%s: %zu of %zu values differ by more than rounding, the largest by %.2g; without "
        "them %.2g; mean %.2g; %.2f s\n",
        name, same.grazed, same.values, same.largest_grazed, same.largest, same.mean_difference(),
        took_s);
    EXPECT_GT(same.values, 1000u);
    EXPECT_LE(static_cast<double>(same.grazed), most_grazed * static_cast<double>(same.values));
    EXPECT_LE(same.mean_difference(), most_mean);
    expect_within_intervals(cpu, gl);
    // Where a hit differs by rounding, a chain may end sooner or later: some ten rays each.
    constexpr double kChains = 4.0, kRaysPerChain = 10.0;
    for (std::size_t p = 0; p < cpu.size(); ++p) {
      EXPECT_NEAR(static_cast<double>(gl[p].counters.near_rays),
                  static_cast<double>(cpu[p].counters.near_rays),
                  1e-3 * static_cast<double>(cpu[p].counters.near_rays) + kChains * kRaysPerChain);
    }
  };
  compare("near field", {*device.cpu, nullptr, device.near.get()}, 0.005, 1e-6);
  compare("light paths", {*device.cpu, device.paths.get()}, 0.2, 1e-4);
  compare("direct light", {*device.cpu, nullptr, nullptr, device.direct.get()}, 0.0, 0.0);
  expect_same_direct_light(cpu, solve_with(hall.hall.scene, hall.tasks, settings, device.all()));
  compare("all", device.all(), 0.2, 1e-4);
}

// Photometry of all formats, as projects name it.
TEST(GlStages, GiveTheSameSumForEveryExample) {
  LUXGATE_NEEDS_OPENGL();
  const Device device;
  const calc::Stages stages = device.all();
  const std::filesystem::path folder = std::filesystem::path(LUXGATE_SOURCE_DIR) / "examples";
  std::size_t values = 0, grazed = 0;
  for (const std::filesystem::directory_entry& entry :
       std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path file = entry.path() / "project.xml";
    if (!std::filesystem::exists(file)) continue;
    SCOPED_TRACE(file.string());
    calc::Diagnostics diagnostics;
    const auto project = calc::load_project(calc::DiskFileReader(), file.string(), diagnostics);
    ASSERT_TRUE(project);
    for (const calc::Space& space : project->spaces) {
      std::vector<calc::SensorGrid> grids;
      for (const calc::CalcPlane& plane : space.planes) {
        auto grid = calc::make_sensor_grid(plane, space, diagnostics);
        if (grid) grids.push_back(std::move(*grid));
      }
      std::vector<calc::PlaneTask> tasks;
      for (std::size_t p = 0; p < grids.size(); ++p) {
        tasks.push_back({"plane " + std::to_string(p), &grids[p]});
      }
      const calc::PreparedScene scene = calc::prepare_scene(*project, space);
      const SameSum same = compare_sums(solve_with(scene, tasks, settings_of(128, 2), *device.cpu),
                                        solve_with(scene, tasks, settings_of(128, 2), stages));
      EXPECT_LE(same.mean_difference(), 1e-4);
      values += same.values;
      grazed += same.grazed;
    }
  }
  std::printf("%zu of %zu values differ by more than rounding\n", grazed, values);
  EXPECT_GT(values, 5000u);
  EXPECT_LE(grazed, values / 100);
}

TEST(GlStages, GiveTheSameBitsForAnyNumberOfThreads) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall;
  const Device device;
  const calc::Stages stages{*device.cpu, device.paths.get(), device.near.get(),
                            device.direct.get()};
  const auto one = solve_with(hall.hall.scene, hall.tasks, settings_of(128, 1), stages);
  for (const int jobs : {2, 8, 3}) {
    const auto many = solve_with(hall.hall.scene, hall.tasks, settings_of(128, jobs), stages);
    for (std::size_t p = 0; p < one.size(); ++p) {
      EXPECT_EQ(one[p].indirect_lx, many[p].indirect_lx);
      EXPECT_EQ(one[p].direct_exact_lx, many[p].direct_exact_lx);
      EXPECT_EQ(one[p].direct_sampled_lx, many[p].direct_sampled_lx);
      EXPECT_EQ(one[p].largest_share, many[p].largest_share);
      EXPECT_EQ(one[p].counters.near_rays, many[p].counters.near_rays);
    }
  }
}

TEST(GlStages, EndWithTheReasonWhenTheDeviceFails) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall;
  const Device device(gpu::Fault::context_lost);
  for (const calc::Stages& stages :
       {calc::Stages{*device.cpu, device.paths.get()},
        calc::Stages{*device.cpu, nullptr, device.near.get()},
        calc::Stages{*device.cpu, nullptr, nullptr, device.direct.get()}}) {
    EXPECT_THROW(solve_with(hall.hall.scene, hall.tasks, settings_of(64, 4), stages),
                 calc::BackendFailure);
  }
}

}  // namespace
}  // namespace gpu_stages_test
