#include "calc/radiosity/sampling/rays.h"

#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rays_test {
namespace {

using namespace test_support;

TEST(Tracer, EmptySceneBlocksNothing) {
  const calc::PreparedScene scene;
  const calc::Tracer tracer(scene);
  calc::SurfaceHit hit;
  EXPECT_FALSE(tracer.is_blocked({0, 0, 0}, {0, 0, 1}));
  EXPECT_FALSE(tracer.closest_hit({0, 0, 0}, {0, 0, 1}, 10.0, hit));
}

TEST(Tracer, ClosestHitGivesPositionAndFacingNormal) {
  calc::PreparedScene scene;
  add_quad(scene, {-1, -1, 2}, {2, 0, 0}, {0, 2, 0}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  calc::SurfaceHit hit;
  ASSERT_TRUE(tracer.closest_hit({0.25, 0.5, 0}, {0, 0, 1}, 10.0, hit));
  EXPECT_NEAR(glm::length(hit.position_m - glm::dvec3(0.25, 0.5, 2)), 0.0, 1e-6);
  EXPECT_EQ(hit.normal, glm::dvec3(0, 0, -1));
  ASSERT_TRUE(tracer.closest_hit({0.25, 0.5, 3}, {0, 0, -1}, 10.0, hit));
  EXPECT_EQ(hit.normal, glm::dvec3(0, 0, 1));
  EXPECT_FALSE(tracer.closest_hit({0.25, 0.5, 0}, {0, 0, 1}, 1.9, hit));
}

TEST(Tracer, PointsOnASurfaceDoNotHideThemselves) {
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {10, 7, 3}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const calc::RandomKey key(1);
  int blocked = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto u = [&](std::uint64_t k) { return key.with(i).with(k).uniform(); };
    const glm::dvec3 floor = tracer.lift({10 * u(0), 7 * u(1), 0}, {0, 0, 1});
    const glm::dvec3 wall = tracer.lift({0, 7 * u(2), 3 * u(3)}, {1, 0, 0});
    if (tracer.is_blocked(floor, wall)) ++blocked;
  }
  EXPECT_EQ(blocked, 0);
}

TEST(Tracer, NoRayLeavesAClosedRoom) {
  calc::PreparedScene scene;
  add_box(scene, {-5, -4, -1.4}, {10, 8, 2.8}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const calc::RandomKey key(2);
  int escaped = 0;
  calc::SurfaceHit hit;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    // A third of the rays aim exactly at edges and corners, where two triangles meet.
    glm::dvec3 to(10 * key.with(i).with(0).uniform() - 5, 8 * key.with(i).with(1).uniform() - 4,
                  -1.4);
    if (i % 3 == 0) to.x = 5.0;
    if (i % 9 == 0) to.y = 4.0;
    const glm::dvec3 from(0.1, 0.2, 0.3);
    if (!tracer.closest_hit(from, glm::normalize(to - from),
                            std::numeric_limits<double>::infinity(), hit)) {
      ++escaped;
    }
  }
  EXPECT_EQ(escaped, 0);
}

TEST(Tracer, AThinWallBlocksFromBothSidesInPacketsToo) {
  calc::PreparedScene scene;
  add_quad(scene, {0, -1, -1}, {0, 2, 0}, {0, 0, 2}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  calc::SegmentPacket packet;
  for (int k = 0; !packet.is_full(); ++k) {
    const float x = k % 2 == 0 ? 1.0f : -0.5f;  // even ones lie behind the wall
    packet.add({-1.0f, 0.0f, 0.0f}, {x, 0.05f * static_cast<float>(k), 0.1f});
  }
  packet.count = 13;
  EXPECT_EQ(tracer.blocked(packet), 0b1010101010101u);
  EXPECT_TRUE(tracer.is_blocked({1, 0, 0}, {-1, 0, 0}));
}

// Vertices and hits at the foot of a partition, nearer to it than what is left out at receivers.
TEST(Tracer, APartitionBlocksFromWhatStandsAtItsFoot) {
  calc::PreparedScene scene;
  add_box(scene, {-3, -1.5, 0}, {6, 3, 2.5}, 0.5);
  add_quad(scene, {0, -1.5, 0}, {0, 3, 0}, {0, 0, 2.5}, 0.5);
  set_extent(scene);
  const calc::Tracer tracer(scene);
  const glm::dvec3 behind(0.001, 0.0, 0.001);
  for (const double offsets : {0.01, 0.1, 0.5, 0.9}) {
    const glm::dvec3 foot = tracer.lift({-offsets * tracer.offset_m(), 0.0, 0.0}, {0, 0, 1});
    EXPECT_TRUE(tracer.is_blocked(behind, foot, calc::kReceiverToVertex)) << offsets;
    EXPECT_TRUE(tracer.is_blocked(foot, behind, calc::kHitToVertex)) << offsets;
    EXPECT_TRUE(tracer.is_blocked(foot, behind, calc::kHitToSource)) << offsets;
  }
  // A receiver's end is left out: it may lie in the surface.
  const glm::dvec3 foot = tracer.lift({-0.5 * tracer.offset_m(), 0.0, 0.0}, {0, 0, 1});
  EXPECT_FALSE(tracer.is_blocked(foot, behind, calc::kReceiverToVertex));
  // In one place nothing is between.
  EXPECT_FALSE(tracer.is_blocked(behind, behind, calc::kHitToVertex));
}

TEST(CosineDirection, HasCosineDistributionAboutAnyNormal) {
  for (const glm::dvec3 n :
       {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::normalize(glm::dvec3(1, -2, 0.3))}) {
    glm::dvec3 mean(0.0);
    constexpr int kSide = 64;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const glm::dvec3 d = calc::cosine_direction(n, (i + 0.5) / kSide, (j + 0.5) / kSide);
        EXPECT_NEAR(glm::length(d), 1.0, 1e-12);
        EXPECT_GE(glm::dot(d, n), 0.0);
        mean += d / static_cast<double>(kSide * kSide);
      }
    }
    EXPECT_NEAR(glm::length(mean - n * (2.0 / 3.0)), 0.0, 1e-3);  // mean of cos under cos / pi
  }
}

}  // namespace
}  // namespace rays_test
