#include "gpu/device/egl_context.h"

#include "tests/support/opengl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace egl_context_test {
namespace {

using ::testing::HasSubstr;

TEST(Devices, AreNamedOneByOne) {
  LUXGATE_NEEDS_OPENGL();
  const gpu::DeviceList list = gpu::list_devices();
  EXPECT_EQ(list.problem, "");
  for (std::size_t k = 0; k < list.devices.size(); ++k) {
    EXPECT_EQ(list.devices[k].index, static_cast<int>(k));
    EXPECT_TRUE(!list.devices[k].renderer.empty() || !list.devices[k].problem.empty());
  }
  EXPECT_GE(gpu::preferred_device(list), 0) << "EGL is there, but no device can be used";
}

TEST(Devices, SoftwareIsRecognised) {
  LUXGATE_NEEDS_OPENGL();
  for (const gpu::Device& found : gpu::list_devices().devices) {
    if (found.renderer.find("llvmpipe") != std::string::npos) {
      EXPECT_TRUE(found.is_software);
    }
  }
  for (const gpu::Device& found : gpu::list_hardware().devices) {
    EXPECT_FALSE(found.is_software && found.is_usable()) << found.renderer;
  }
}

TEST(Context, SaysWhyThereIsNone) {
  std::string problem;
  EXPECT_EQ(gpu::EglContext::open(-1, gpu::Fault::no_egl, problem), nullptr);
  EXPECT_EQ(problem, "there is no EGL library (libEGL.so.1)");
  LUXGATE_NEEDS_OPENGL();
  EXPECT_EQ(gpu::EglContext::open(1000, gpu::Fault::none, problem), nullptr);
  EXPECT_THAT(problem, HasSubstr("there is no OpenGL device 1000: 'luxgate devices' lists "));
}

TEST(Context, CanBeOpenedAgain) {
  LUXGATE_NEEDS_OPENGL();
  for (int k = 0; k < 3; ++k) {
    std::string problem;
    const auto context = gpu::EglContext::open(-1, gpu::Fault::none, problem);
    ASSERT_NE(context, nullptr) << problem;
    EXPECT_EQ(problem, "");
    EXPECT_EQ(context->loss(), "");
    EXPECT_THAT(context->device().name(), HasSubstr("OpenGL "));
  }
}

}  // namespace
}  // namespace egl_context_test
