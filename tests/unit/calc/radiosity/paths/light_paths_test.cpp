#include "calc/radiosity/paths/light_paths.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

namespace light_paths_test {
namespace {

using namespace test_support;

class TraceLightPaths : public testing::Test {
 protected:
  calc::TracedPaths trace(double reflectance, std::uint32_t paths, double deadline_s = 0.0) {
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, {3, 3, 3}, reflectance);
    add_luminaire(scene, web, {1, 1, 2});
    set_extent(scene);
    const calc::Tracer tracer(scene);
    const calc::Emitter emitter(scene);
    return calc::trace_light_paths(tracer, emitter, {1, 0, 0, paths, deadline_s});
  }

  calc::PhotometricWeb web = isotropic_web(100.0);
};

TEST_F(TraceLightPaths, GivesUpWhereVerticesWouldFillTheMemory) {
  const calc::TracedPaths traced = trace(0.9995, 16384);  // 32 million vertices without a limit
  EXPECT_TRUE(traced.has_too_many_vertices);
  EXPECT_FALSE(traced.has_endless_path);
  EXPECT_TRUE(traced.vertices.empty());
  EXPECT_LT(traced.rays, 2 * calc::kMostVertices);
}

TEST_F(TraceLightPaths, StopsAtTheDeadline) {
  const calc::TracedPaths whole = trace(0.5, 1024);
  EXPECT_FALSE(whole.has_too_many_vertices);
  EXPECT_GT(whole.rays, 1024u);
  EXPECT_EQ(trace(0.5, 1024, calc::now_s() - 1.0).rays, 0u);
}

// A path whose number is 0 would not end by roulette.
TEST(LightPaths, RouletteHasNoZero) {
  EXPECT_EQ(calc::roulette_number(0.0), 0x1p-33);
  EXPECT_EQ(calc::roulette_number(1.0 - 0x1p-32), 1.0 - 0x1p-33);
}

}  // namespace
}  // namespace light_paths_test
