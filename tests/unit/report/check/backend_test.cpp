#include "report/check/backend.h"

#include "report/tools/devices/devices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

check::BackendChoice choose(const gpu::DeviceList& list, double connections) {
  // Five connections share a vertex.
  return check::choose_automatically(list, [&] {
    return check::GatherWork{connections, connections / 5.0, 1000.0};
  });
}

TEST(Backend, AutoTakesAGpuForMuchWorkOnly) {
  const gpu::DeviceList list{{device(0, "Card A", false), device(1, "Card B", false)}, ""};
  const check::BackendChoice much = choose(list, 1.2e9);
  EXPECT_EQ(much.backend, check::Backend::gpu);
  EXPECT_EQ(much.device, 0);
  EXPECT_THAT(check::backend_line(much), HasSubstr("backend: gpu: enough work for Card A: 1"));
  EXPECT_THAT(much.why,
              HasSubstr("take some 7.1 s on 16 processor cores, 6.7 s with it: 0.4 s to "
                        "open it, 3.6 s to send scene and light vertices, 2.7 s to gather"));
  const check::BackendChoice little = choose(list, 6e7);
  EXPECT_EQ(little.backend, check::Backend::cpu);
  EXPECT_THAT(little.why, HasSubstr("too little work for Card A"));
}

// What a context, the scene and the vertices cost must be won back.
TEST(Backend, AutoCountsWhatHasToBeSent) {
  const gpu::DeviceList list{{device(0, "Card A", false)}, ""};
  const auto with = [&](const check::GatherWork& work) {
    return check::choose_automatically(list, [&] { return work; }).backend;
  };
  EXPECT_EQ(with({2e8, 0.0, 0.0}), check::Backend::gpu);
  EXPECT_EQ(with({2e8, 1e8, 0.0}), check::Backend::cpu);
  EXPECT_EQ(with({2e8, 0.0, 5e6}), check::Backend::cpu);
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
  const check::BackendChoice choice = check::choose_automatically({{}, "none"}, [] {
    ADD_FAILURE() << "planned for nothing";
    return check::GatherWork{};
  });
  EXPECT_EQ(choice.backend, check::Backend::cpu);
}

TEST(Backend, WhatIsAskedForIsTaken) {
  for (const check::Backend backend : {check::Backend::cpu, check::Backend::gpu}) {
    check::BackendRequest request;
    request.backend = backend;
    const check::BackendChoice choice =
        check::choose_backend(request, 0, gpu::Fault::no_egl, [] { return check::GatherWork{}; });
    EXPECT_EQ(choice.backend, backend);
    EXPECT_EQ(choice.why, "asked for with --backend");
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
  request.stages = check::GpuStages{true, false, true};
  const auto choose = [&] {
    return check::choose_backend(request, 0, gpu::Fault::no_egl,
                                 [] { return check::GatherWork(); });
  };
  EXPECT_EQ(check::backend_line(choose()),
            "backend: gpu: asked for with --backend\ngpu stages: light-paths, near-field\n");
  request.stages.reset();
  EXPECT_EQ(choose().stages, check::GpuStages());
  EXPECT_THAT(check::backend_line(choose()),
              HasSubstr("gpu stages: light-paths, connections, near-field\n"));
}

// Maps make the connections, whatever is chosen, and nothing is near to them.
TEST(Backend, StagesBesideShadowMapsAreNamedAsTheyAre) {
  check::BackendRequest request;
  request.backend = check::Backend::gpu;
  const auto line = [&] {
    return check::backend_line(
        check::choose_backend(request, 64, gpu::Fault::no_egl, [] { return check::GatherWork(); }));
  };
  EXPECT_THAT(line(), HasSubstr("gpu stages: connections\n"));
  request.stages = check::GpuStages{true, false, true};
  EXPECT_THAT(line(), HasSubstr("gpu stages: light-paths, connections\n"));
}

TEST(Backend, FaultsForTestsHaveNames) {
  EXPECT_EQ(check::find_gl_fault(""), gpu::Fault::none);
  EXPECT_EQ(check::find_gl_fault("no-egl"), gpu::Fault::no_egl);
  EXPECT_EQ(check::find_gl_fault("out-of-memory"), gpu::Fault::out_of_memory);
  EXPECT_EQ(check::find_gl_fault("context-lost"), gpu::Fault::context_lost);
  EXPECT_FALSE(check::find_gl_fault("none"));
}

TEST(Devices, AreListedWithWhatKeepsThemFromUse) {
  const gpu::DeviceList list{
      {device(0, "Card \"A\"\n", false), device(1, "", true, "EGL cannot start it")}, ""};
  const std::string text = cli::render_devices_text(list);
  EXPECT_THAT(text, HasSubstr("0   Card \"A\" \n    Maker, OpenGL 4.6.0 Driver 1\n"
                              "    hardware\n    usable\n"));
  EXPECT_THAT(text, HasSubstr("1   (no OpenGL)\n"));
  EXPECT_THAT(text, HasSubstr("software: only used with --backend gpu\n"
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
              HasSubstr("no hardware: the driver is not loaded\n"));
  EXPECT_EQ(nlohmann::json::parse(cli::render_devices_json(advised))["advice"],
            "the driver is not loaded");
}

}  // namespace
