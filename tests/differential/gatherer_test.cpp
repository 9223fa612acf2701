// The packet gatherer against the formula in double, one ray at a time.
#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/near_field.h"
#include "calc/radiosity/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace {

using namespace test_support;

TEST(CpuGatherer, EqualsTheFormulaRayByRay) {
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, 0}, {4, 4, 3}, 0.5);
  add_box(scene, {-0.5, -0.5, 0.8}, {1, 1, 0.7}, 0.5);  // an occluder
  set_extent(scene);
  const calc::Tracer tracer(scene);

  calc::LightVertices vertices;
  vertices.channel_begin = {0, 150, 333};
  const calc::RandomKey key(9);
  for (std::size_t j = 0; j < 333; ++j) {
    const auto u = [&](std::uint64_t k) { return key.with(j).with(k).uniform(); };
    vertices.position_m.emplace_back(4 * u(0) - 2, 4 * u(1) - 2, j % 2 == 0 ? 0.0 : 3.0);
    vertices.normal.emplace_back(0, 0, j % 2 == 0 ? 1 : -1);
    vertices.flux_lm.push_back(u(2));
    vertices.bound_per_m2.push_back(0.2f);
  }
  std::vector<glm::dvec3> position, normal;
  for (std::size_t i = 0; i < 40; ++i) {
    position.emplace_back(3.8 * key.with(1000 + i).uniform() - 1.9,
                          3.8 * key.with(2000 + i).uniform() - 1.9, 0.5);
    normal.emplace_back(
        glm::normalize(glm::dvec3(0.3, 0.1 * static_cast<double>(i % 3), i % 4 == 0 ? -1.0 : 1.0)));
  }
  std::vector<double> sum(2 * position.size(), 1.0);  // gather adds
  const std::uint64_t rays =
      calc::make_cpu_gatherer()->gather(tracer, {position, normal}, vertices, sum);

  std::uint64_t expected_rays = 0, blocked = 0, bounded = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    std::array<double, 2> expected{1.0, 1.0};
    for (std::size_t j = 0; j < vertices.size(); ++j) {
      const glm::dvec3 y(vertices.position_m[j]), ny(vertices.normal[j]);
      const double g = calc::geometry_term(position[i], normal[i], y, ny);
      if (g <= 0.0) continue;
      ++expected_rays;
      if (g > 0.2) ++bounded;
      if (tracer.is_blocked(tracer.lift(position[i], normal[i]), tracer.lift(y, ny))) {
        ++blocked;
        continue;
      }
      expected[j < 150 ? 0 : 1] += vertices.flux_lm[j] / calc::kPi * std::min(g, 0.2);
    }
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(sum[c * position.size() + i] / expected[c], 1.0, 1e-5) << i << " channel " << c;
    }
  }
  EXPECT_EQ(rays, expected_rays);
  EXPECT_GT(blocked, 100u);  // the test sees all three cases
  EXPECT_GT(bounded, 20u);
  EXPECT_GT(expected_rays, blocked + bounded);
}

}  // namespace
