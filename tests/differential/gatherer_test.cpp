// The packet gatherer against the formula in double, one ray at a time.
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace gatherer_test {
namespace {

using namespace test_support;

TEST(CpuGatherer, EqualsTheFormulaRayByRay) {
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, 0}, {4, 4, 3}, 0.5);
  add_box(scene, {-0.5, -0.5, 0.8}, {1, 1, 0.7}, 0.5);  // an occluder
  set_extent(scene);
  const calc::Tracer tracer(scene);

  calc::LightVertices vertices;
  const calc::RandomKey key(9);
  for (std::size_t j = 0; j < 333; ++j) {
    const auto u = [&](std::uint64_t k) { return key.with(j).with(k).uniform(); };
    const glm::dvec3 normal(0, 0, j % 2 == 0 ? 1 : -1);
    const glm::dvec3 position(4 * u(0) - 2, 4 * u(1) - 2, j % 2 == 0 ? 0.0 : 3.0);
    vertices.push_back({glm::vec3(tracer.lift(position, normal)), static_cast<float>(u(2)),
                        glm::vec3(normal), j < 150 ? 0u : 1u});
  }
  std::vector<calc::Receiver> receivers;
  std::vector<calc::Connection> connections;
  for (std::size_t i = 0; i < 40; ++i) {
    receivers.push_back(
        {{3.8 * key.with(1000 + i).uniform() - 1.9, 3.8 * key.with(2000 + i).uniform() - 1.9, 0.5},
         glm::normalize(glm::dvec3(0.3, 0.1 * static_cast<double>(i % 3), i % 4 == 0 ? -1.0 : 1.0)),
         i % 8 == 5 ? calc::ReceiverKernel::hemispherical : calc::ReceiverKernel::planar});
    for (std::uint32_t j = 0; j < 333; ++j) {
      connections.push_back({static_cast<std::uint32_t>(i), j, i % 3 == 0 ? 2.0f : 1.0f});
    }
  }
  const std::size_t count = receivers.size();
  std::vector<double> sum(2 * count, 1.0);  // gather adds
  std::vector<float> largest(count, 0.0f);
  const calc::VertexBounds bounds(0.2);
  const std::uint64_t rays = calc::make_cpu_gatherer()->gather(
      {tracer, vertices, bounds, receivers, connections}, {sum.data(), count, largest.data()});

  std::uint64_t expected_rays = 0, blocked = 0, bounded = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const calc::Receiver& receiver = receivers[i];
    std::array<double, 2> expected{1.0, 1.0};
    double most = 0.0;
    for (std::size_t j = 0; j < vertices.size(); ++j) {
      const glm::dvec3 y(vertices[j].position_m), ny(vertices[j].normal);
      const glm::dvec3 w = y - tracer.offset_m() * ny - receiver.position_m;
      const double d = glm::length(w);
      const double cosine = glm::dot(receiver.axis, w) / d;
      const double response = receiver.kernel == calc::ReceiverKernel::planar
                                  ? std::max(0.0, cosine)
                                  : 0.25 * (1.0 + cosine);
      const double g = response * std::max(0.0, -glm::dot(ny, w) / d) / (d * d);
      if (g <= 0.0) continue;
      ++expected_rays;
      if (g > 0.2) ++bounded;
      if (tracer.is_blocked(tracer.lift(receiver), y, calc::kReceiverToVertex)) {
        ++blocked;
        continue;
      }
      const double lx = (i % 3 == 0 ? 2.0 : 1.0) * static_cast<double>(vertices[j].flux_lm) /
                        calc::kPi * std::min(g, 0.2);
      expected[j < 150 ? 0 : 1] += lx;
      most = std::max(most, lx);
    }
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(sum[c * count + i] / expected[c], 1.0, 1e-5) << i << " channel " << c;
    }
    EXPECT_NEAR(static_cast<double>(largest[i]) / most, 1.0, 1e-5) << i;
  }
  EXPECT_EQ(rays, expected_rays);
  EXPECT_GT(blocked, 100u);  // the test sees all three cases
  EXPECT_GT(bounded, 20u);
  EXPECT_GT(expected_rays, blocked + bounded);
}

}  // namespace
}  // namespace gatherer_test
