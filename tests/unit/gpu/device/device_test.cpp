#include "gpu/device/device.h"

#include <gtest/gtest.h>

#include <string>

namespace device_test {
namespace {

gpu::Device device(int index, bool is_software, const std::string& problem) {
  gpu::Device result;
  result.index = index;
  result.is_software = is_software;
  result.problem = problem;
  return result;
}

TEST(PreferredDevice, IsHardwareIfAnyCanBeUsed) {
  EXPECT_EQ(gpu::preferred_device({}), -1);
  EXPECT_EQ(gpu::preferred_device({{device(0, false, "too old")}, ""}), -1);
  EXPECT_EQ(gpu::preferred_device({{device(0, true, ""), device(1, true, "")}, ""}), 0);
  EXPECT_EQ(gpu::preferred_device({{device(0, false, "too old"), device(1, true, ""),
                                    device(2, false, ""), device(3, false, "")},
                                   ""}),
            2);
}

TEST(HardwareDevice, IsNeverSoftware) {
  EXPECT_EQ(gpu::hardware_device({{device(0, false, "too old"), device(1, true, "")}, ""}), -1);
  EXPECT_EQ(gpu::hardware_device({{device(0, true, ""), device(1, false, "")}, ""}), 1);
}

TEST(SoftwareDevice, MayNotBeOpenedYet) {
  EXPECT_EQ(gpu::software_device({{device(0, false, ""), device(1, true, "broken")}, ""}), -1);
  EXPECT_EQ(gpu::software_device({{device(0, false, ""), device(1, true, gpu::kNotOpened)}, ""}),
            1);
  EXPECT_EQ(gpu::software_device({{device(0, false, ""), device(1, true, "")}, ""}), 1);
}

TEST(SoftwareRenderers, AreKnownByTheirNames) {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer",
                           "Mesa swrast", "Google SwiftShader"}) {
    EXPECT_TRUE(gpu::is_software_renderer(name)) << name;
  }
  for (const char* name :
       {"NVIDIA H200/PCIe/SSE2", "Mesa Intel(R) UHD Graphics 620", "AMD Radeon"}) {
    EXPECT_FALSE(gpu::is_software_renderer(name)) << name;
  }
}

TEST(Device, NamesItselfAndWhyItCannotBeUsed) {
  gpu::Device card = device(0, false, "");
  card.renderer = "Card";
  card.version = "4.6.0 Driver 1";
  EXPECT_EQ(card.name(), "Card, OpenGL 4.6.0");
  EXPECT_EQ(gpu::why_none_is_usable({{device(0, false, "too old"), device(1, true, "broken")}, ""}),
            "no OpenGL device can be used; device 0: too old; device 1: broken");
  EXPECT_EQ(gpu::why_none_is_usable({{device(0, false, "too old")}, "", "get a new one"}),
            "no OpenGL device can be used; device 0: too old; get a new one");
}

}  // namespace
}  // namespace device_test
