// Light paths by OpenGL against the CPU's: the same vertices, up to rounding and rays that graze an
// edge.
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/path_pass.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/opengl.h"
#include "tests/support/path_pools.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gpu_paths_test {
namespace {

using namespace test_support;
using ::testing::HasSubstr;

constexpr double kMostDiverged = 1e-3;
constexpr std::size_t kAll = 1'000'000;

struct Source {
  const calc::PreparedScene& scene;
  calc::Tracer tracer;
  calc::Emitter emitter;

  explicit Source(const calc::PreparedScene& from, std::vector<std::uint8_t> is_unlit = {})
      : scene(from), tracer(from), emitter(from, is_unlit) {}
  calc::TracedPaths cpu(const calc::PathBatch& batch) const {
    return calc::trace_light_paths(tracer, emitter, batch);
  }
  calc::TracedPaths gl(calc::PathTracer& paths, const calc::PathBatch& batch) const {
    return paths.trace(tracer, emitter, batch);
  }
};

void expect_same_pool(const Source& source, calc::PathTracer& gl, const calc::PathBatch& batch,
                      const std::string& name, double most_unmatched) {
  SCOPED_TRACE(name);
  const double begin_s = calc::now_s();
  const calc::TracedPaths a = source.cpu(batch);
  const double middle_s = calc::now_s();
  const calc::TracedPaths b = source.gl(gl, batch);
  const double end_s = calc::now_s();
  const PoolDifference difference =
      compare_pools(a.vertices, b.vertices, {1e-5 * source.scene.extent_m});
  const std::uint32_t paths = batch.last - batch.first;
  std::printf(
      "%-22s %6u paths, %7zu vertices: %zu unmatched, same bits %.4f, within %.2g of the "
      "extent, flux %.2g; %.2f us/path, %.2f on the CPU\n",
      name.c_str(), paths, a.vertices.size(), difference.unmatched,
      static_cast<double>(difference.same_bits) /
          std::max(1.0, static_cast<double>(difference.matched)),
      difference.largest_m / source.scene.extent_m, difference.largest_flux,
      1e6 * (end_s - middle_s) / paths, 1e6 * (middle_s - begin_s) / paths);
  ASSERT_GT(a.vertices.size(), 0u);
  EXPECT_LE(difference.unmatched_share(), most_unmatched);
  const double balance = source.emitter.traced_flux_lm();
  EXPECT_NEAR(b.absorbed_lm, a.absorbed_lm, std::max(1e-3, 0.1 * most_unmatched) * balance);
  EXPECT_NEAR(b.escaped_lm, a.escaped_lm, std::max(1e-3, 0.1 * most_unmatched) * balance);
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
  constexpr std::uint32_t kThreads = 24;
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (std::uint32_t i = t; i < paths; i += kThreads) b[i] = source.gl(gl, {3, 0, i, i + 1});
    });
  }
  for (std::thread& thread : threads) thread.join();
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
    std::printf(
        "rho %.2f: of %zu paths, diverged within 8, 16, 32, any reflections: %zu %zu %zu %zu\n",
        reflectance, result.paths, result.diverged(0, 8), result.diverged(0, 16),
        result.diverged(0, 32), result.diverged(0, kAll));
    EXPECT_LE(result.diverged(0, 8), kMostDiverged * static_cast<double>(result.paths));
    // A ray carries its origin's rounding on to the next surface, divided by the cosine there: an
    // error grows and shrinks from reflection to reflection, and in the end some path leaves.
    EXPECT_LE(result.diverged(0, 32), 0.1 * static_cast<double>(result.paths));
    if (reflectance < 0.7) {
      EXPECT_EQ(result.diverged(0, kAll), 0u);
    }
  }
}

TEST(GlPathTracer, TracesThePoolsOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_path_tracer();
  for (const bool is_open : {false, true}) {
    const LampHall black(0.0, is_open), grey(0.6, is_open), bright(0.9, is_open);
    expect_same_pool(Source(black.scene), *gl, {1, 0, 0, 4096}, "rho 0", kMostDiverged);
    expect_same_pool(Source(grey.scene), *gl, {1, 0, 0, 8192}, "rho 0.6", kMostDiverged);
    // Long paths: see KeepsToThePathsOfTheCpu.
    expect_same_pool(Source(bright.scene), *gl, {1, 0, 0, 4096}, "rho 0.9",
                     is_open ? kMostDiverged : 0.03);
  }
  const LampHall white(0.99);
  expect_same_pool(Source(white.scene), *gl, {5, 3, 256, 512}, "rho 0.99", 0.15);
  // Not from the beginning, no whole chunk, more than one pass.
  const LampHall hall(0.5);
  expect_same_pool(Source(hall.scene), *gl, {7, 2, 1024, 1040}, "few", kMostDiverged);
  expect_same_pool(Source(hall.scene), *gl, {7, 2, 8192, 20000}, "many", kMostDiverged);
  // Luminaires that no path starts from: the first, the last, two in a row.
  expect_same_pool(Source(hall.scene, {1, 0, 0, 1, 1, 0, 0, 1}), *gl, {7, 2, 0, 4096}, "unlit",
                   kMostDiverged);
}

// One lamp alone in a closed box: what leaves it, in which direction, from where.
TEST(GlPathTracer, StartsWhereTheCpuStarts) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_path_tracer();
  std::vector<calc::PhotometricWeb> webs = lamp_shop();
  // Without thickness: an upright disk, a flat box, a line.
  webs.push_back(crooked_web({calc::OpeningShape::cylinder_c0, 0.0, 0.3, 0.2}));
  webs.push_back(crooked_web({calc::OpeningShape::box, 0.3, 0.2, 0.0}));
  webs.push_back(lambert_web(100.0, 4, {calc::OpeningShape::rectangle, 0.9, 0.0, 0.0}));
  for (std::size_t k = 0; k < webs.size(); ++k) {
    calc::PreparedScene scene;
    add_box(scene, {-1, -1, -1}, {2, 2, 2}, 0.2);
    add_luminaire(scene, webs[k], {0.1, 0.2, 0.3});
    if (k % 2 == 1) scene.luminaires[0].world_from_luminaire = tilted_axes(0.7, 2.2);
    set_extent(scene);
    const Source source(scene);
    const calc::TracedPaths a = source.cpu({11, 0, 0, 2048}), b = source.gl(*gl, {11, 0, 0, 2048});
    const PoolDifference difference =
        compare_pools(a.vertices, b.vertices, {1e-5 * scene.extent_m});
    EXPECT_EQ(difference.unmatched, 0u) << k;
    EXPECT_GT(difference.same_bits, difference.matched / 2) << k;
    EXPECT_EQ(difference.largest_flux, 0.0);
  }
}

bool operator==(const calc::LightVertex& a, const calc::LightVertex& b) {
  return a.position_m == b.position_m && a.flux_lm == b.flux_lm && a.normal == b.normal &&
         a.channel == b.channel;
}

void expect_same_bits(const calc::TracedPaths& a, const calc::TracedPaths& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) ASSERT_TRUE(a.vertices[i] == b.vertices[i]);
  EXPECT_EQ(a.absorbed_lm, b.absorbed_lm);
  EXPECT_EQ(a.escaped_lm, b.escaped_lm);
  EXPECT_EQ(a.rays, b.rays);
}

TEST(GlPathTracer, GivesTheSameBitsAgainAloneAndInBundles) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.7), other_hall(0.4, true);
  const Source source(hall.scene), other(other_hall.scene);
  const auto gl = gl_path_tracer();
  const auto batch = [](std::size_t replicate) {
    return calc::PathBatch{1, replicate, 0, replicate % 2 == 0 ? 512u : 700u};
  };
  std::vector<calc::TracedPaths> once;
  for (std::size_t r = 0; r < 4; ++r) once.push_back(source.gl(*gl, batch(r)));
  const calc::TracedPaths elsewhere = other.gl(*gl, batch(0));
  EXPECT_NE(once[0].vertices.size(), elsewhere.vertices.size());
  for (int run = 0; run < 10; ++run) expect_same_bits(once[1], source.gl(*gl, batch(1)));
  expect_same_bits(once[2], source.gl(*gl_path_tracer(), batch(2)));
  // Bundles of some of the batches, with another scene between them.
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 12; ++k) {
    threads.emplace_back([&, k] {
      if (k % 5 == 4) {
        expect_same_bits(elsewhere, other.gl(*gl, batch(0)));
      } else {
        expect_same_bits(once[k % 4], source.gl(*gl, batch(k % 4)));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// Of several passes with several rounds each: some threads copy what came back while the device is
// at work for others.
TEST(GlPathTracer, GivesTheSameBitsForAnyNumberOfThreads) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.7);
  const Source source(hall.scene);
  const auto batch = [](std::size_t replicate) {
    return calc::PathBatch{1, replicate, 256, replicate == 0 ? 9000u : 3000u};
  };
  std::vector<calc::TracedPaths> once;
  for (const std::size_t thread_count : {1u, 2u, 5u}) {
    const auto gl = gl_path_tracer();
    std::vector<calc::TracedPaths> traced(5);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < thread_count; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t r = t; r < traced.size(); r += thread_count) {
          traced[r] = source.gl(*gl, batch(r));
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    if (once.empty()) once = traced;
    for (std::size_t r = 0; r < traced.size(); ++r) expect_same_bits(once[r], traced[r]);
  }
}

// The device goes on while others read, but not over what they read.
TEST(GlPathTracer, WaitsForSlowReaders) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.99);
  const Source source(hall.scene);
  const calc::PathBatch batch{1, 0, 0, 256};
  const auto device = gl_device();
  calc::LightVertices vertices;
  std::size_t rounds = 0;
  gpu::PathInbox inbox;
  std::thread reader([&] {
    gpu::RoundCollector collector(vertices, 1.0);
    while (const std::optional<gpu::PathRound> round = inbox.next()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(++rounds == 1 ? 200 : 2));
      collector.add(*round);
    }
    collector.finish();
  });
  gpu::PathJob job{
      source.tracer, source.emitter, batch, 0, 256, calc::kMostVertices, [&](gpu::PathRound round) {
        inbox.put(std::move(round));
      }};
  device->run([&](gpu::DeviceState& state) {
    gpu::PathPass pass(256, state.programs);
    pass.run(state, std::vector<gpu::PathJob*>{&job});
  });
  inbox.end("");
  reader.join();
  EXPECT_GT(rounds, 3u);  // more than can be under way
  const calc::TracedPaths alone = source.gl(*gl_path_tracer(), batch);
  ASSERT_EQ(vertices.size(), alone.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    ASSERT_TRUE(vertices[i] == alone.vertices[i]) << i;
  }
}

TEST(GlPathTracer, ObeysItsLimits) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_path_tracer();
  calc::PreparedScene white;
  add_box(white, {-1, -1, -1}, {2, 2, 2}, 1.0);
  const calc::PhotometricWeb web = isotropic_web(100.0);
  add_luminaire(white, web, {0, 0, 0});
  set_extent(white);
  const Source endless(white);
  const calc::TracedPaths never = endless.gl(*gl, {1, 0, 0, 16, 0.0, calc::kMostVertices, 600});
  std::printf("escaped %g of %g, on the CPU %g\n", never.escaped_lm, endless.emitter.flux_lm(),
              endless.cpu({1, 0, 0, 16}).escaped_lm);
  EXPECT_TRUE(never.has_endless_path);
  EXPECT_TRUE(never.vertices.empty());
  const calc::TracedPaths full = endless.gl(*gl, {1, 0, 0, 16, 0.0, 10'000});
  EXPECT_TRUE(full.has_too_many_vertices);
  EXPECT_FALSE(full.has_endless_path);
  EXPECT_TRUE(full.vertices.empty());
  const double begin_s = calc::now_s();
  const calc::TracedPaths late = endless.gl(*gl, {1, 0, 0, 1u << 20, begin_s - 1.0});
  EXPECT_LT(calc::now_s() - begin_s, 5.0);
  EXPECT_FALSE(late.has_endless_path);

  const LampHall hall(0.5);
  const Source source(hall.scene);
  const std::size_t count = source.gl(*gl, {1, 0, 0, 9000}).vertices.size();
  for (const auto& [most, is_too_many] : {std::pair{count, false}, {count - 1, true}}) {
    const calc::PathBatch batch{1, 0, 0, 9000, 0.0, most};
    EXPECT_EQ(source.gl(*gl, batch).has_too_many_vertices, is_too_many);
    EXPECT_EQ(source.cpu(batch).has_too_many_vertices, is_too_many);
  }
  // A bundle goes on without the batches that ended early.
  const calc::TracedPaths alone = source.gl(*gl, {1, 0, 0, 512});
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k) {
    threads.emplace_back([&, k] {
      const calc::PathBatch batch{1, 0, 0, 512, 0.0, k % 2 == 0 ? calc::kMostVertices : 600};
      const calc::TracedPaths traced = source.gl(*gl, batch);
      EXPECT_EQ(traced.has_too_many_vertices, k % 2 == 1);
      if (k % 2 == 0) expect_same_bits(alone, traced);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// All paths of a batch have ended at its last reflection, those of its neighbour go on.
TEST(GlPathTracer, BundlesMayHaveUnlikeLimits) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.8);
  const Source source(hall.scene);
  const auto gl = gl_path_tracer();
  constexpr std::size_t kFew = 8;
  std::size_t replicate = 0;
  const auto one_path = [&] {
    return calc::PathBatch{1, replicate, 0, 1, 0.0, calc::kMostVertices, kFew};
  };
  while (source.gl(*gl, one_path()).has_endless_path) ASSERT_LT(++replicate, 100u);
  const calc::PathBatch brief = one_path(), longer{1, 0, 0, 512};
  const calc::TracedPaths alone = source.gl(*gl, longer);
  ASSERT_TRUE(source.gl(*gl, {1, 0, 0, 512, 0.0, calc::kMostVertices, kFew}).has_endless_path);
  const auto drop = [](gpu::PathRound) {};
  gpu::PathJob a{source.tracer, source.emitter, brief, 0, 1, calc::kMostVertices, drop};
  gpu::PathJob b{source.tracer, source.emitter, longer, 0, 512, calc::kMostVertices, drop};
  gl_device()->run([&](gpu::DeviceState& state) {
    gpu::PathPass pass(1024, state.programs);
    pass.run(state, std::vector<gpu::PathJob*>{&a, &b});
  });
  EXPECT_FALSE(a.is_useless());
  EXPECT_FALSE(b.is_useless());
  EXPECT_EQ(b.vertices, alone.vertices.size());
  EXPECT_EQ(b.absorbed_lm, alone.absorbed_lm);
}

TEST(GlPathTracer, FailsWithAReason) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const Source source(hall.scene);
  for (const auto& [fault, text] : {std::pair{gpu::Fault::out_of_memory, "out of memory"},
                                    {gpu::Fault::context_lost, "reset"},
                                    {gpu::Fault::fence_lost, "has not answered"}}) {
    const auto gl = gl_path_tracer(fault);
    const auto fails = [&, &what = text](std::uint32_t paths) {
      try {
        source.gl(*gl, {1, 0, 0, paths});
        ADD_FAILURE() << what;
      } catch (const calc::BackendFailure& failure) {
        EXPECT_THAT(failure.what(), HasSubstr(what));
      }
    };
    for (int k = 0; k < 2; ++k) fails(16);  // not only the first time
    // In bundles, with others that wait behind them.
    std::vector<std::thread> threads;
    for (const std::uint32_t paths : {16u, 3000u, 9000u, 16u, 6000u}) {
      threads.emplace_back(fails, paths);
    }
    for (std::thread& thread : threads) thread.join();
  }
}

// What came back in a round before lies where that of the next should be.
TEST(GlPathTracer, TakesNoEarlierResults) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const Source source(hall.scene);
  const auto gl = gl_path_tracer(gpu::Fault::results_lost);
  try {
    source.gl(*gl, {1, 0, 0, 1024});  // of several rounds, and a balance
    ADD_FAILURE();
  } catch (const calc::BackendFailure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
  }
}

// A driver older than OpenGL 4.4.
TEST(GlPathTracer, GivesTheSameBitsWithoutBufferStorage) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const Source source(hall.scene);
  const calc::PathBatch batch{1, 0, 0, 1024};
  expect_same_bits(source.gl(*gl_path_tracer(), batch),
                   source.gl(*gl_path_tracer(gpu::Fault::no_buffer_storage), batch));
}

}  // namespace
}  // namespace gpu_paths_test
