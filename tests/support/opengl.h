#pragma once
// OpenGL for tests: Mesa's software renderer where there is nothing else.

#include "gpu/gather/gl_gatherer.h"
#include "gpu/rays/gl_direct_tracer.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/gl_short_rays.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

namespace test_support {

// "" or why there is no EGL device at all, for GTEST_SKIP. A device that cannot be used is no
// reason to skip: the gatherer then fails the test.
inline std::string no_opengl() { return gpu::list_devices().problem; }

inline std::shared_ptr<gpu::DeviceThread> gl_device(gpu::Fault fault = gpu::Fault::none) {
  std::string problem;
  auto device = gpu::DeviceThread::open({-1, fault}, problem);
  EXPECT_TRUE(device != nullptr) << problem;
  return device;
}

inline std::unique_ptr<calc::Gatherer> gl_gatherer(gpu::Fault fault = gpu::Fault::none) {
  return gpu::make_gl_gatherer(gl_device(fault));
}

inline std::unique_ptr<calc::PathTracer> gl_path_tracer(gpu::Fault fault = gpu::Fault::none) {
  return gpu::make_gl_path_tracer(gl_device(fault));
}

inline std::unique_ptr<calc::ShortRayCaster> gl_short_rays(gpu::Fault fault = gpu::Fault::none) {
  return gpu::make_gl_short_rays(gl_device(fault));
}

// How many times what the CPU gives may differ on a device that rounds as it likes (fused products,
// other square roots): where two choices tie, and where large terms cancel. On an H200 3 % of the
// smallest groups of samples did, of 1e-5 to 1 %, with sums alike to 2e-4; software rounds as the
// CPU does, and must not use this room.
inline double roundings_of_hardware() {
  static const auto device = gl_device();
  return device != nullptr && !device->device().is_software ? 10.0 : 1.0;
}

// Whether this OpenGL leaves loops after 65,535 turns, as llvmpipe of Mesa 22 does and that of Mesa
// 25 does not; nullopt: nobody has looked.
inline std::optional<bool> leaves_long_loops(const gpu::Device& device) {
  if (!device.is_software) return false;
  const std::size_t mesa = device.version.find("Mesa ");
  if (mesa == std::string::npos) return std::nullopt;
  const int version = std::atoi(device.version.c_str() + mesa + 5);
  if (version == 22) return true;
  if (version >= 25) return false;
  return std::nullopt;
}

}  // namespace test_support

#define LUXGATE_NEEDS_OPENGL()                                                 \
  if (const std::string reason = ::test_support::no_opengl(); !reason.empty()) \
  GTEST_SKIP() << "no OpenGL: " << reason
