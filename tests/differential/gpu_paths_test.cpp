// Light paths by OpenGL against the CPU's: the same vertices, up to rounding and rays that graze an
// edge.
#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/light_paths.h"
#include "calc/radiosity/phase_timer.h"
#include "gpu/gl_path_tracer.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/opengl.h"
#include "tests/support/path_pools.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;
using ::testing::HasSubstr;

constexpr double kMostDiverged = 1e-3;

struct Source {
  const calc::PreparedScene& scene;
  calc::Tracer tracer;
  calc::Emitter emitter;

  explicit Source(const calc::PreparedScene& from)
      : scene(from), tracer(from), emitter(from) {}
  calc::TracedPaths cpu(const calc::PathBatch& batch) const {
    return calc::trace_light_paths(tracer, emitter, batch);
  }
  calc::TracedPaths gl(calc::PathTracer& paths, const calc::PathBatch& batch) const {
    return paths.trace(tracer, emitter, batch);
  }
};

void expect_same_paths(const Source& source, calc::PathTracer& gl, const calc::PathBatch& batch,
                       const std::string& name) {
  SCOPED_TRACE(name);
  const double begin_s = calc::now_s();
  const calc::TracedPaths a = source.cpu(batch);
  const double middle_s = calc::now_s();
  const calc::TracedPaths b = source.gl(gl, batch);
  const double end_s = calc::now_s();
  const PoolDifference difference =
      compare_pools(a.vertices, b.vertices, {1e-5 * source.scene.extent_m});
  const std::uint32_t paths = batch.last - batch.first;
  std::printf("%-22s %6u paths, %7zu vertices: %zu unmatched, same bits %.4f, within %.2g of the "
              "extent, flux %.2g; %.2f us/path, %.2f on the CPU\n",
              name.c_str(), paths, a.vertices.size(), difference.unmatched,
              static_cast<double>(difference.same_bits) /
                  std::max(1.0, static_cast<double>(difference.matched)),
              difference.largest_m / source.scene.extent_m, difference.largest_flux,
              1e6 * (end_s - middle_s) / paths, 1e6 * (middle_s - begin_s) / paths);
  ASSERT_GT(a.vertices.size(), 0u);
  EXPECT_LE(difference.unmatched_share(), kMostDiverged);
  const double balance = source.emitter.traced_flux_lm();
  EXPECT_NEAR(b.absorbed_lm, a.absorbed_lm, 1e-3 * balance);
  EXPECT_NEAR(b.escaped_lm, a.escaped_lm, 1e-3 * balance);
  if (difference.unmatched == 0) {
    EXPECT_NEAR(b.absorbed_lm, a.absorbed_lm, 1e-12 * balance);
    EXPECT_NEAR(b.escaped_lm, a.escaped_lm, 1e-12 * balance);
    EXPECT_EQ(a.rays, b.rays);
  }
}

// Batches of one path show which path and reflection a vertex belongs to. They run side by side, so
// that the device gets them in bundles.
struct PathByPath {
  std::vector<std::size_t> diverged_at;  // [reflection], paths
  std::size_t paths = 0;

  std::size_t diverged(std::size_t first, std::size_t last) const {
    std::size_t sum = 0;
    for (std::size_t k = first; k < std::min(last, diverged_at.size()); ++k) sum += diverged_at[k];
    return sum;
  }
};

PathByPath compare_path_by_path(const Source& source, calc::PathTracer& gl, std::uint32_t paths) {
  std::vector<calc::TracedPaths> b(paths);
  tbb::task_arena(32).execute([&] {
    tbb::parallel_for(std::uint32_t{0}, paths, [&](std::uint32_t i) {
      b[i] = source.gl(gl, {3, 0, i, i + 1});
    });
  });
  PathByPath result;
  result.paths = paths;
  const PoolTolerance tolerance{1e-5 * source.scene.extent_m};
  for (std::uint32_t i = 0; i < paths; ++i) {
    const calc::LightVertices& cpu = source.cpu({3, 0, i, i + 1}).vertices;
    const calc::LightVertices& device = b[i].vertices;
    for (std::size_t k = 0; k < std::max(cpu.size(), device.size()); ++k) {
      if (k < cpu.size() && k < device.size() && is_same_vertex(cpu[k], device[k], tolerance)) {
        continue;
      }
      result.diverged_at.resize(std::max(result.diverged_at.size(), k + 1));
      ++result.diverged_at[k];
      break;
    }
  }
  return result;
}

TEST(GlPathTracer, KeepsToThePathsOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_path_tracer();
  for (const double reflectance : {0.6, 0.9, 0.99}) {
    const LampHall hall(reflectance);
    const PathByPath result = compare_path_by_path(Source(hall.scene), *gl, 2000);
    std::printf("rho %.2f: of %zu paths, diverged within 8, 16, 32, any reflections: %zu %zu %zu %zu\n",
                reflectance, result.paths, result.diverged(0, 8), result.diverged(0, 16),
                result.diverged(0, 32), result.diverged(0, 1000000));
  }
}

TEST(GlPathTracer, TracesThePathsOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_path_tracer();
  for (const double reflectance : {0.0, 0.6, 0.9}) {
    for (const bool is_open : {false, true}) {
      const LampHall hall(reflectance, is_open);
      expect_same_paths(Source(hall.scene), *gl, {1, 0, 0, 8192},
                        "rho " + std::to_string(reflectance) + (is_open ? " open" : ""));
    }
  }
  const LampHall bright(0.99);
  expect_same_paths(Source(bright.scene), *gl, {5, 3, 256, 512}, "rho 0.99");
  // Not from the beginning, no whole chunk, more than one pass.
  const LampHall hall(0.5);
  expect_same_paths(Source(hall.scene), *gl, {7, 2, 1024, 1040}, "few");
  expect_same_paths(Source(hall.scene), *gl, {7, 2, 8192, 20000}, "many");
}

}  // namespace
