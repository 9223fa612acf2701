#include "report/check/backend.h"

#include "report/check/plan.h"
#include "report/tools/devices/devices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace backend_test {
namespace {

using ::testing::HasSubstr;

gpu::Device device(int index, const std::string& renderer, bool is_software,
                   const std::string& problem = "") {
  gpu::Device result;
  result.index = index;
  result.renderer = renderer;
  result.vendor = "Maker";
  result.version = "4.6.0 Driver 1";
  result.is_software = is_software;
  result.problem = problem;
  return result;
}

// Of one look, times `size`: some 40 s of one thread each, shared by 16.
calc::DeviceWork work(double size) {
  calc::DeviceWork w;
  w.threads = 16;
  w.work.light_paths = 1e6 * size;
  w.work.pool_rays = 5e6 * size;
  w.work.connection_rays = 4e8 * size;
  w.work.near_rays = 5e6 * size;
  w.receivers = 1e6 * size;
  w.triangles = 1000.0;
  w.one_thread = {0.0, 0.0, 2.4 * size, 38.0 * size, 1.5 * size};
  return w;
}

std::optional<calc::DeviceRates> nothing_known(const gpu::Device&, bool, std::string&) {
  return std::nullopt;
}

check::BackendChoice choose(const gpu::DeviceList& list, double size,
                            const check::RatesOf& rates_of = nothing_known) {
  return check::choose_automatically(
      list, [&] { return work(size); }, rates_of);
}

const gpu::DeviceList kTwoCards{{device(0, "Card A", false), device(1, "Card B", false)}, ""};

TEST(Backend, AutoTakesAGpuForMuchWorkOnly) {
  const check::BackendChoice much = choose(kTwoCards, 10.0);
  EXPECT_EQ(much.backend, check::Backend::gpu);
  EXPECT_EQ(much.device, 0);
  EXPECT_THAT(check::backend_line(much),
              HasSubstr("backend: gpu: enough work for Card A: first looks take some 26 s on 16 "
                        "threads (direct light 0, light paths 1.5, connections 24, near field "
                        "0.94), 1"));
  EXPECT_THAT(much.why, HasSubstr(" s with it (0.4 to open it, "));
  const check::BackendChoice little = choose(kTwoCards, 0.2);
  EXPECT_EQ(little.backend, check::Backend::cpu);
  EXPECT_THAT(little.why, HasSubstr("too little work for Card A: first looks take some 0.52 s on"));
}

TEST(Backend, AutoSaysWhatItsRatesAre) {
  EXPECT_THAT(choose(kTwoCards, 10.0).why,
              HasSubstr("; rates are assumed, none was measured on it: 1e+09 any-hit rays/s, "));
  calc::DeviceRates rates = calc::kAssumedRates;
  rates.any_hit_per_s = 2e9;
  const auto known = [&](const gpu::Device&, bool, std::string&) { return std::optional(rates); };
  EXPECT_THAT(choose(kTwoCards, 10.0, known).why,
              HasSubstr("; rates were measured on it: 2e+09 any-hit rays/s, "));
  rates.path_rays_per_s = 0.0;
  EXPECT_THAT(choose(kTwoCards, 10.0, known).why,
              HasSubstr("; some rates were measured on it, the rest is assumed: 2e+09 "));
}

TEST(Backend, AutoTakesTheStagesThatAreFaster) {
  calc::DeviceRates rates = calc::kAssumedRates;
  rates.path_rays_per_s = 1e5;
  const check::BackendChoice choice =
      choose(kTwoCards, 10.0,
             [&](const gpu::Device&, bool, std::string&) { return std::optional(rates); });
  EXPECT_EQ(choice.backend, check::Backend::gpu);
  EXPECT_FALSE(choice.stages.light_paths);
  EXPECT_TRUE(choice.stages.connections);
  EXPECT_THAT(check::backend_line(choice), HasSubstr("gpu stages: connections"));
}

// What light paths cost the CPU beside a device is shared by its threads.
TEST(Backend, AutoTakesAFastDeviceForLightPaths) {
  calc::DeviceRates rates = calc::kAssumedRates;
  rates.path_rays_per_s = 1e9;
  rates.down_bytes_per_s = 2e10;
  for (const int threads : {1, 16}) {
    calc::DeviceWork some = work(10.0);
    some.threads = threads;
    const calc::DeviceCost cost = calc::weigh_device(some, rates, {});
    EXPECT_TRUE(cost.stages.light_paths) << threads;
    EXPECT_LT(cost.with_device.pool, 0.5 + 3.0 / threads);
  }
}

// A second of measuring must be worth it; where no device could be, not even kept rates are read.
TEST(Backend, AutoMeasuresForMuchWorkOnly) {
  int asked = 0;
  bool may_measure = false;
  const auto watch = [&](const gpu::Device& card, bool may, std::string&) {
    EXPECT_EQ(card.renderer, "Card A");
    ++asked;
    may_measure = may;
    return std::optional<calc::DeviceRates>();
  };
  EXPECT_THAT(choose(kTwoCards, 0.05, watch).why,
              HasSubstr("s or more with the fastest of devices"));
  EXPECT_EQ(asked, 0);
  choose(kTwoCards, 0.4, watch);
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(may_measure);
  choose(kTwoCards, 10.0, watch);
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(may_measure);
}

// One machine must choose alike every time, whatever --jobs is.
TEST(Backend, WhatAutoRestsOnStaysAsItIs) {
  std::string problem;
  const check::RatesOf rates_of = check::rates_on_this_machine(gpu::Fault::no_egl, "");
  EXPECT_FALSE(rates_of(device(0, "Card A", false), true, problem));
  EXPECT_EQ(problem, "");  // not even measured
  calc::RadiositySettings one, many;
  one.jobs = 1;
  many.jobs = 61;
  EXPECT_EQ(check::first_look_work({}, one).threads, check::first_look_work({}, many).threads);
}

TEST(Backend, AutoLeavesADeviceThatFailsWhenItIsMeasured) {
  const check::BackendChoice choice =
      choose(kTwoCards, 10.0, [](const gpu::Device&, bool, std::string& problem) {
        problem = "the device was reset";
        return std::optional<calc::DeviceRates>();
      });
  EXPECT_EQ(choice.backend, check::Backend::cpu);
  EXPECT_EQ(choice.why, "OpenGL device 0 failed when its speed was measured: the device was reset");
}

TEST(Backend, AutoNeverTakesSoftwareOrWhatDoesNotWork) {
  const gpu::DeviceList list{
      {device(0, "Old Card", false, "OpenGL 3.3 has no compute shaders"), device(1, "soft", true)},
      ""};
  const check::BackendChoice choice = choose(list, 1e12);
  EXPECT_EQ(choice.backend, check::Backend::cpu);
  EXPECT_EQ(check::backend_line(choice),
            "backend: cpu: OpenGL device 0 cannot be used: OpenGL 3.3 has no compute shaders; "
            "OpenGL device 1 is software, slower than the CPU backend\n");
  EXPECT_EQ(choose({{}, "this machine has no graphics device"}, 1e12).why,
            "this machine has no graphics device");
  EXPECT_EQ(choose({{device(0, "soft", true)}, "", "the driver is not loaded"}, 1e12).why,
            "OpenGL device 0 is software, slower than the CPU backend; the driver is not loaded");
}

TEST(Backend, AutoDoesNotCountWorkWithoutADevice) {
  const check::BackendChoice choice = check::choose_automatically(
      {{}, "none"},
      [] {
        ADD_FAILURE() << "planned for nothing";
        return calc::DeviceWork{};
      },
      nothing_known);
  EXPECT_EQ(choice.backend, check::Backend::cpu);
}

TEST(Backend, WhatIsAskedForIsTaken) {
  for (const check::Backend backend : {check::Backend::cpu, check::Backend::gpu}) {
    check::BackendRequest request;
    request.backend = backend;
    check::Hardware hardware(gpu::Fault::no_egl, "");
    const check::BackendChoice choice =
        check::choose_backend(request, 0, hardware, [] { return calc::DeviceWork{}; });
    EXPECT_EQ(choice.backend, backend);
    EXPECT_EQ(choice.why, "selected with --backend");
  }
}

TEST(Backend, FailureIsNeverTurnedIntoTheCpu) {
  std::string problem, warning;
  EXPECT_FALSE(
      check::open_backend({check::Backend::gpu, -1, ""}, gpu::Fault::no_egl, "", problem, warning));
  EXPECT_EQ(problem, "there is no EGL library (libEGL.so.1)");
}

TEST(Backend, StagesAreNamed) {
  check::BackendRequest request;
  request.backend = check::Backend::gpu;
  request.stages = check::GpuStages{false, true, false, true};
  const auto chosen = [&] {
    check::Hardware hardware(gpu::Fault::no_egl, "");
    return check::choose_backend(request, 0, hardware, [] { return calc::DeviceWork(); });
  };
  EXPECT_EQ(check::backend_line(chosen()),
            "backend: gpu: selected with --backend\ngpu stages: light-paths, near-field\n");
  request.stages.reset();
  EXPECT_EQ(chosen().stages, check::GpuStages());
  EXPECT_THAT(check::backend_line(chosen()),
              HasSubstr("gpu stages: direct-light, light-paths, connections, near-field\n"));
}

// Maps make the connections, whatever is chosen, and nothing is near to them.
TEST(Backend, StagesBesideShadowMapsAreNamedAsTheyAre) {
  check::BackendRequest request;
  request.backend = check::Backend::gpu;
  const auto line = [&] {
    check::Hardware hardware(gpu::Fault::no_egl, "");
    return check::backend_line(
        check::choose_backend(request, 64, hardware, [] { return calc::DeviceWork(); }));
  };
  EXPECT_THAT(line(), HasSubstr("gpu stages: connections\n"));
  request.stages = check::GpuStages{false, true, false, true};
  EXPECT_THAT(line(), HasSubstr("gpu stages: light-paths, connections\n"));
}

TEST(Backend, FaultsForTestsHaveNames) {
  EXPECT_EQ(check::find_gl_fault(""), gpu::Fault::none);
  EXPECT_EQ(check::find_gl_fault("no-egl"), gpu::Fault::no_egl);
  EXPECT_EQ(check::find_gl_fault("out-of-memory"), gpu::Fault::out_of_memory);
  EXPECT_EQ(check::find_gl_fault("context-lost"), gpu::Fault::context_lost);
  EXPECT_EQ(check::find_gl_fault("fence-lost"), gpu::Fault::fence_lost);
  EXPECT_EQ(check::find_gl_fault("results-lost"), gpu::Fault::results_lost);
  EXPECT_EQ(check::find_gl_fault("no-buffer-storage"), gpu::Fault::no_buffer_storage);
  EXPECT_FALSE(check::find_gl_fault("none"));
}

TEST(Devices, AreListedWithWhatKeepsThemFromUse) {
  const gpu::DeviceList list{
      {device(0, "Card \"A\"\n", false), device(1, "", true, "EGL cannot start it")}, ""};
  const std::string text = cli::render_devices_text(list);
  EXPECT_THAT(text, HasSubstr("0   Card \"A\" \n    Maker, OpenGL 4.6.0 Driver 1\n"
                              "    hardware\n    usable\n"));
  EXPECT_THAT(text, HasSubstr("1   (no OpenGL)\n"));
  EXPECT_THAT(text, HasSubstr("software: draws, and calculates with --backend gpu only\n"
                              "    not usable: EGL cannot start it\n"));
  const auto json = nlohmann::json::parse(cli::render_devices_json(list));
  EXPECT_EQ(json["devices"][0]["renderer"], "Card \"A\"\n");
  EXPECT_EQ(json["devices"][0]["usable"], true);
  EXPECT_EQ(json["devices"][1]["software"], true);
  EXPECT_EQ(json["devices"][1]["problem"], "EGL cannot start it");
  EXPECT_EQ(cli::render_devices_text({{}, "there is no EGL library"}),
            "no OpenGL device: there is no EGL library\n");
  const gpu::DeviceList advised{{device(0, "soft", true)}, "", "the driver is not loaded"};
  EXPECT_THAT(cli::render_devices_text(advised),
              HasSubstr("GPU not found: the driver is not loaded\n"));
  EXPECT_EQ(nlohmann::json::parse(cli::render_devices_json(advised))["advice"],
            "the driver is not loaded");
}

}  // namespace
}  // namespace backend_test
