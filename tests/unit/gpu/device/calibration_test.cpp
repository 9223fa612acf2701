#include "gpu/device/calibration.h"

#include "tests/support/opengl.h"
#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace calibration_test {
namespace {

namespace fs = std::filesystem;

const calc::DeviceRates kSome{1.25e9, 5.5e8, 1e8 / 3.0, 1.2e10, 6.1e9, 8.7e-5, 0.31};

TEST(Rates, ComeBackAsTheyWereWritten) {
  const auto back = gpu::read_rates(gpu::rates_text(kSome));
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, kSome);
}

TEST(Rates, WhatIsNotWholeIsNothing) {
  const std::string text = gpu::rates_text(kSome);
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_FALSE(gpu::read_rates(text.substr(0, length))) << length;
  }
  EXPECT_FALSE(gpu::read_rates(text + "more 1\n"));
  for (const double wrong : {-1.0, 1.0 / 0.0, 0.0 / 0.0}) {
    calc::DeviceRates rates = kSome;
    rates.down_bytes_per_s = wrong;
    EXPECT_FALSE(gpu::read_rates(gpu::rates_text(rates))) << wrong;
  }
}

TEST(Calibration, IsMeasuredOnceForDeviceAndDriver) {
  LUXGATE_NEEDS_OPENGL();
  const test_support::ScratchFolder folder;
  const fs::path programs = folder.path() / "programs";
  std::string problem;
  const auto rates = gpu::measured_rates({-1, gpu::Fault::none, programs}, 60.0, problem);
  ASSERT_TRUE(rates) << problem;
  EXPECT_EQ(calc::with_assumptions(*rates), *rates) << "something was not measured";
  // Wherever this runs: a ray takes more than a picosecond and less than a millisecond.
  for (const double per_s :
       {rates->any_hit_per_s, rates->closest_hit_per_s, rates->path_rays_per_s}) {
    EXPECT_GT(per_s, 1e3);
    EXPECT_LT(per_s, 1e12);
  }
  EXPECT_GT(rates->up_bytes_per_s, 1e6);
  EXPECT_GT(rates->down_bytes_per_s, 1e6);

  EXPECT_EQ(gpu::measured_rates({-1, gpu::Fault::none, programs}, 60.0, problem), rates);
  const gpu::DeviceList list = gpu::list_devices();
  gpu::Device device = list.devices.at(static_cast<std::size_t>(gpu::preferred_device(list)));
  EXPECT_EQ(gpu::kept_rates(device, programs), rates);
  EXPECT_FALSE(gpu::kept_rates(device, ""));
  EXPECT_FALSE(gpu::kept_rates(device, folder.path() / "other"));
  device.version += ".1";
  EXPECT_FALSE(gpu::kept_rates(device, programs));
}

TEST(Calibration, DoesNotKeepWhatItHadNoTimeFor) {
  LUXGATE_NEEDS_OPENGL();
  const test_support::ScratchFolder folder;
  std::string problem;
  const auto rates = gpu::measured_rates({-1, gpu::Fault::none, folder.path()}, 0.0, problem);
  ASSERT_TRUE(rates) << problem;
  EXPECT_EQ(rates->any_hit_per_s, 0.0);
  EXPECT_EQ(rates->path_rays_per_s, 0.0);
  const gpu::DeviceList list = gpu::list_devices();
  EXPECT_FALSE(gpu::kept_rates(
      list.devices.at(static_cast<std::size_t>(gpu::preferred_device(list))), folder.path()));
}

TEST(Calibration, SaysHowTheDeviceFailed) {
  LUXGATE_NEEDS_OPENGL();
  for (const gpu::Fault fault : {gpu::Fault::out_of_memory, gpu::Fault::context_lost}) {
    std::string problem;
    EXPECT_FALSE(gpu::measured_rates({-1, fault, ""}, 60.0, problem));
    EXPECT_THAT(problem, ::testing::HasSubstr("(a test)"));
  }
  std::string problem;
  EXPECT_FALSE(gpu::measured_rates({-1, gpu::Fault::no_egl, ""}, 60.0, problem));
  EXPECT_EQ(problem, "there is no EGL library (libEGL.so.1)");
}

}  // namespace
}  // namespace calibration_test
