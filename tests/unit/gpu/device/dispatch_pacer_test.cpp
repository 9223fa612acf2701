// How much goes into a dispatch and into a batch.
#include "gpu/device/dispatch_pacer.h"

#include "gpu/device/egl_context.h"
#include "gpu/gather/draw_piece.h"
#include "gpu/opengl/gl_error.h"
#include "tests/support/opengl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace dispatch_pacer_test {
namespace {

using ::testing::HasSubstr;

TEST(DispatchSize, FollowsWhatDispatchesTook) {
  gpu::DispatchSize size(100, 10'000, 1000);
  size.learn(1000, 0.03, 0.03);
  EXPECT_EQ(size.items(), 1000u);
  size.learn(1000, 0.001, 0.001);
  EXPECT_EQ(size.items(), 2000u);
  size.learn(1000, 0.001, 0.001);  // had been sent before
  EXPECT_EQ(size.items(), 2000u);
  size.learn(10, 0.001, 0.001);  // the rest of a piece says nothing
  EXPECT_EQ(size.items(), 2000u);
  size.learn(2000, 0.06, 0.06);
  EXPECT_LT(size.items(), 1000u);
  EXPECT_GT(size.items(), 800u);
  size.learn(2000, 0.06, 0.06);  // had been sent before
  EXPECT_GT(size.items(), 800u);
  size.learn(800, 0.0, 60.0);  // nobody looked when it ended
  EXPECT_GT(size.items(), 800u);
  EXPECT_LT(size.items(), 1000u);
  size.learn(800, 60.0, 60.0);
  EXPECT_EQ(size.items(), 100u);
  for (int k = 0; k < 10; ++k) size.learn(size.items(), 0.001, 0.001);
  EXPECT_EQ(size.items(), 10'000u);
}

TEST(DispatchPacer, CallsEveryDispatchOnce) {
  LUXGATE_NEEDS_OPENGL();
  std::string problem;
  const auto context = gpu::EglContext::open(-1, gpu::Fault::none, problem);
  ASSERT_NE(context, nullptr) << problem;
  gpu::DispatchPacer pacer({1, 64, 1});
  std::size_t calls = 0;
  for (int k = 0; k < 20; ++k) pacer.run(pacer.items(), "testing", [&] { ++calls; });
  EXPECT_EQ(calls, 20u);
}

TEST(DispatchPacer, DoesNotWaitForEver) {
  LUXGATE_NEEDS_OPENGL();
  std::string problem;
  const auto context = gpu::EglContext::open(-1, gpu::Fault::fence_lost, problem);
  ASSERT_NE(context, nullptr) << problem;
  gpu::DispatchPacer pacer({1, 64, 1});
  std::size_t calls = 0;
  const auto run = [&] { pacer.run(1, "testing", [&] { ++calls; }); };
  try {
    for (int k = 0; k < 20; ++k) run();
    ADD_FAILURE();
  } catch (const gpu::GlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the device has not answered"));
    EXPECT_THAT(error.what(), HasSubstr("while testing"));
  }
  EXPECT_EQ(calls, gpu::DispatchPacer::kMostUnderWay);
}

// So many threads fit onto the largest devices of today.
constexpr std::size_t kLargeDevice = 270'000;

TEST(TilesPerBatch, FillADeviceThatIsFast) {
  constexpr std::size_t kPlenty = 100'000, kFast = std::size_t{1} << 21;
  for (const std::uint32_t draws : {16u, 64u, 128u}) {
    const std::size_t nodes = std::min<std::size_t>(16 * draws, 1024);
    const std::size_t tiles = gpu::tiles_per_batch({draws, nodes, 32, kPlenty}, {}, kFast);
    EXPECT_GE(tiles * 32 * draws, kLargeDevice) << draws;
    // One piece takes them all.
    EXPECT_LE(tiles * 32 * nodes, gpu::DrawLimits{}.weights);
    EXPECT_LE(tiles * 32 * (draws + 1), gpu::DrawLimits{}.places);
  }
}

TEST(TilesPerBatch, LeaveEachThreadItsShareAndAreNoLongerThanADispatch) {
  const calc::TileWork work{16, 256, 32, 300};
  EXPECT_EQ(gpu::tiles_per_batch(work, {}, std::size_t{1} << 21), 300u);
  EXPECT_EQ(gpu::tiles_per_batch(work, {}, 100 * 32 * 17), 100u);
  EXPECT_EQ(gpu::tiles_per_batch(work, {}, 0), 64u);  // nothing is known yet
  EXPECT_EQ(gpu::tiles_per_batch({16, 256, 32, 2}, {}, std::size_t{1} << 21), 64u);
  EXPECT_EQ(gpu::tiles_per_batch({}, {}, std::size_t{1} << 21), 64u);
}

}  // namespace
}  // namespace dispatch_pacer_test
