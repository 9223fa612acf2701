// Connections that the device draws itself, in random scenes: the CPU's draws, the CPU's sums.
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/random.h"
#include "gpu/gather/draw_queue.h"
#include "gpu/scene/device_points.h"
#include "tests/support/opengl.h"
#include "tests/support/same_sum.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace gpu_draws_test {
namespace {

using namespace test_support;
using ::testing::HasSubstr;

// A room of some size with bodies in it, open or closed, up to three channels, and planes that
// measure all that can be measured.
struct RandomRoom {
  calc::PhotometricWeb web = lambert_web(800.0, 18);
  calc::PreparedScene scene;
  std::vector<calc::SensorGrid> grids;
  std::vector<calc::PlaneTask> tasks;

  explicit RandomRoom(std::uint64_t seed) {
    const calc::RandomKey key = calc::RandomKey(77).with(seed);
    std::uint64_t number = 0;
    const auto between = [&](double low, double high) {
      return low + (high - low) * key.with(number++).uniform();
    };
    const glm::dvec3 size(between(2.0, 12.0), between(2.0, 9.0), between(2.2, 5.0));
    const double rho = between(0.2, 0.8);
    if (seed % 3 == 0) {  // no ceiling, one wall
      add_quad(scene, {0, 0, 0}, {size.x, 0, 0}, {0, size.y, 0}, rho);
      add_quad(scene, {0, 0, 0}, {0, size.y, 0}, {0, 0, size.z}, rho);
    } else {
      add_box(scene, {0, 0, 0}, size, rho);
    }
    for (std::uint64_t k = 0; k < seed % 4; ++k) {
      const glm::dvec3 part(between(0.05, 0.3), between(0.05, 0.3), between(0.1, 0.6));
      add_box(scene, glm::dvec3(between(0.0, 0.7), between(0.0, 0.7), 0.0) * size, part * size,
              between(0.0, 0.9));
    }
    const std::uint64_t channels = 1 + seed % 3;
    for (std::uint64_t l = 0; l < 2 + channels; ++l) {
      add_luminaire(scene, web, glm::dvec3(between(0.1, 0.9), between(0.1, 0.9), 0.98) * size);
      scene.luminaires.back().channel = static_cast<std::uint32_t>(l % channels);
    }
    while (scene.channels.size() < channels) scene.channels.push_back({"further", 0.8});
    set_extent(scene);
    grids.resize(2);
    for (std::size_t p = 0; p < grids.size(); ++p) {
      grids[p].kernel =
          p == 0 ? static_cast<calc::ReceiverKernel>(seed % 5) : calc::ReceiverKernel::planar;
      for (int i = 0; i < 40; ++i) {
        grids[p].position_m.push_back(
            glm::dvec3(between(0.003, 0.997), between(0.003, 0.997), between(0.62, 0.95)) * size);
        const bool is_upright = grids[p].kernel == calc::ReceiverKernel::cylindrical;
        const double angle = is_upright ? 0.0 : between(0.0, 6.2);
        grids[p].normal.emplace_back(grids[p].kernel == calc::ReceiverKernel::semicylindrical
                                         ? glm::dvec3(std::cos(angle), std::sin(angle), 0.0)
                                         : glm::dvec3(0, 0, 1));
      }
    }
    for (const calc::SensorGrid& grid : grids) {
      tasks.push_back({"plane " + std::to_string(tasks.size()), &grid});
    }
  }
};

calc::RadiositySettings settings_of(std::uint64_t paths, int jobs) {
  calc::RadiositySettings settings;
  settings.first_paths = paths / 2;
  settings.max_paths = paths;
  settings.replicates = 2;
  settings.jobs = jobs;
  return settings;
}

std::uint64_t rays_of(const std::vector<calc::PlaneField>& fields) {
  std::uint64_t rays = 0;
  for (const calc::PlaneField& field : fields) rays += field.counters.connection_rays;
  return rays;
}

TEST(GlDraws, GiveTheSameSumInRandomRooms) {
  LUXGATE_NEEDS_OPENGL();
  const auto cpu = calc::make_cpu_gatherer();
  const auto gl = gl_gatherer();
  std::size_t values = 0, grazed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRoom room(seed);
    const auto a = solve_with(room.scene, room.tasks, settings_of(256, 2), *cpu);
    const auto b = solve_with(room.scene, room.tasks, settings_of(256, 2), *gl);
    // A single draw of another vertex would change the rays or a sum by far more than rounding.
    EXPECT_EQ(rays_of(a), rays_of(b));
    const SameSum same = compare_sums(a, b);
    EXPECT_GT(same.sum_a_lx, 0.0);
    EXPECT_LE(same.largest_grazed, 0.05);
    if (same.grazed == 0) {
      EXPECT_LE(same.mean_difference(), 1e-6);
    }
    values += same.values;
    grazed += same.grazed;
  }
  RecordProperty("grazed", static_cast<int>(grazed));
  EXPECT_GE(values, 6'000u);
  EXPECT_LE(grazed, values / 1000) << "of " << values;
}

TEST(GlDraws, GiveTheSameBitsTenTimesOnAnyThreads) {
  LUXGATE_NEEDS_OPENGL();
  const RandomRoom room(5);
  const auto first = solve_with(room.scene, room.tasks, settings_of(128, 1), *gl_gatherer());
  const auto gl = gl_gatherer();
  for (int run = 0; run < 10; ++run) {
    const auto again = solve_with(room.scene, room.tasks, settings_of(128, 1 + run % 4), *gl);
    for (std::size_t p = 0; p < first.size(); ++p) {
      EXPECT_EQ(first[p].indirect_lx, again[p].indirect_lx);
      EXPECT_EQ(first[p].largest_share, again[p].largest_share);
      EXPECT_EQ(first[p].counters.connection_rays, again[p].counters.connection_rays);
    }
  }
}

// --- one batch -----------------------------------------------------------------------------------

// Vertices on floor and ceiling and receivers of all kinds, in tiles of unlike sizes.
struct Batch {
  RandomRoom room{4};
  calc::Tracer tracer{room.scene};
  std::unique_ptr<calc::VertexTree> tree;
  calc::ReceiverTiles tiles;
  calc::VertexBounds bounds;

  explicit Batch(double most_per_m2, std::size_t vertex_count = 3000, std::size_t tile_count = 5)
      : bounds(most_per_m2) {
    const calc::RandomKey key(31);
    const auto u = [&](std::uint64_t i, std::uint64_t k) { return key.with(i).with(k).uniform(); };
    calc::LightVertices vertices;
    for (std::size_t j = 0; j < vertex_count; ++j) {
      const glm::dvec3 normal(0, 0, j % 2 == 0 ? 1 : -1);
      const glm::dvec3 at(6 * u(j, 0), 5 * u(j, 1), j % 2 == 0 ? 0.0 : 2.5);
      vertices.push_back({glm::vec3(tracer.lift(at, normal)), static_cast<float>(0.01 + u(j, 2)),
                          glm::vec3(normal), static_cast<std::uint32_t>(j % 2)});
    }
    tree = std::make_unique<calc::VertexTree>(std::move(vertices), 2);
    std::vector<calc::ReceiverGroup> groups;
    for (std::size_t t = 0; t < tile_count; ++t) {
      auto& [points, tile] = groups.emplace_back();
      for (std::uint64_t i = 0; i < 7 * t + 1; ++i) {
        const std::uint64_t n = 10'000 + 100 * t + i;
        tile.push_back({{2.0 + 2 * u(n, 0), 2.0 + u(n, 1), 0.05 + 2 * u(n, 2)},
                        {0, 0, 1},
                        static_cast<calc::ReceiverKernel>(t == 0 ? 0 : i % 5)});
        if (tile.back().kernel == calc::ReceiverKernel::semicylindrical) {
          tile.back().axis = {1, 0, 0};
        }
        points.push_back(static_cast<std::uint32_t>(n));
      }
    }
    tiles = calc::ReceiverTiles(std::move(groups));
  }
};

struct Sums {
  std::vector<std::vector<double>> lx;
  std::vector<std::vector<float>> largest_lx;
  std::uint64_t rays = 0;
  friend bool operator==(const Sums&, const Sums&) = default;
};

Sums gather(const Batch& batch, calc::Gatherer& gatherer, std::uint32_t draws,
            bool has_shadows = true, double deadline_s = 0.0, std::size_t nodes = 200) {
  Sums sums;
  std::vector<calc::GatherSums> wanted;
  for (const calc::ReceiverGroup& tile : batch.tiles.groups()) {
    sums.lx.emplace_back(2 * tile.receiver.size(), 1.0);
    sums.largest_lx.emplace_back(tile.receiver.size(), 0.0f);
  }
  for (std::size_t t = 0; t < sums.lx.size(); ++t) {
    wanted.push_back({sums.lx[t].data(), sums.largest_lx[t].size(), sums.largest_lx[t].data()});
  }
  sums.rays = gatherer.draw_and_gather({batch.tracer,
                                        *batch.tree,
                                        batch.bounds,
                                        {nodes, 0.5f, true},
                                        draws,
                                        has_shadows,
                                        deadline_s,
                                        calc::RandomKey(77),
                                        batch.tiles,
                                        0,
                                        wanted});
  return sums;
}

TEST(GlDraws, GiveTheSameSumWithAndWithoutBoundsAndShadows) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_gatherer();
  const auto cpu = calc::make_cpu_gatherer();
  // 0.02: nearly all draws are above the bound.
  for (const double most : {0.02, 0.3, std::numeric_limits<double>::infinity()}) {
    const Batch batch(most);
    for (const bool has_shadows : {true, false}) {
      // 1: fewer draws than a group of invocations; 1000: many blocks of them
      for (const std::uint32_t draws : {1u, 64u, 1000u}) {
        const Sums a = gather(batch, *cpu, draws, has_shadows);
        const Sums b = gather(batch, *gl, draws, has_shadows);
        EXPECT_EQ(a.rays, b.rays) << draws;
        EXPECT_EQ(a.rays > 0, has_shadows);
        std::size_t grazed = 0;
        for (std::size_t t = 0; t < a.lx.size(); ++t) {
          for (std::size_t k = 0; k < a.lx[t].size(); ++k) {
            if (std::abs(b.lx[t][k] / a.lx[t][k] - 1.0) > 1e-5) ++grazed;
          }
          for (std::size_t k = 0; k < a.largest_lx[t].size(); ++k) {
            EXPECT_NEAR(b.largest_lx[t][k], a.largest_lx[t][k], 1e-5f * a.largest_lx[t][k]);
          }
        }
        EXPECT_LE(grazed, 1u) << most << " " << draws;
      }
    }
  }
}

TEST(GlDraws, DoNotDependOnHowTheyAreCutIntoPieces) {
  LUXGATE_NEEDS_OPENGL();
  const Batch batch(0.3);
  const Sums whole = gather(batch, *gl_gatherer(), 100);
  // Places of 101, one receiver's, or fewer: each receiver goes alone.
  for (const gpu::DrawLimits limits : {gpu::DrawLimits{1500, 1u << 22},
                                       {1u << 21, 1000},
                                       {101, 1u << 22},
                                       {10, 10},
                                       {1u << 21, 1u << 22, 64},
                                       {1500, 1u << 22, 333}}) {
    const auto gl = gpu::make_gl_gatherer(gl_device(), limits);
    EXPECT_EQ(whole, gather(batch, *gl, 100))
        << limits.places << " " << limits.weights << " " << limits.dispatch;
  }
}

// As another sees fit.
struct FixedTiles : TimedGatherer {
  FixedTiles(calc::Gatherer& inner, std::size_t tiles) : TimedGatherer(inner), tiles_(tiles) {}
  std::size_t tiles_per_batch(const calc::TileWork& work) const override {
    EXPECT_GT(work.draws, 0u);
    EXPECT_GT(work.nodes, 0u);
    EXPECT_GT(work.receivers, 0u);
    EXPECT_GT(work.tiles_each, 0u);
    return tiles_;
  }

  std::size_t tiles_;
};

TEST(GlDraws, DoNotDependOnTheTilesOfABatch) {
  LUXGATE_NEEDS_OPENGL();
  RandomRoom room(4);
  for (calc::SensorGrid& grid : room.grids) {
    for (std::size_t i = 0; i < 280; ++i) {  // 10 tiles
      grid.position_m.push_back(glm::dvec3(grid.position_m[i]));
      grid.normal.push_back(glm::dvec3(grid.normal[i]));
    }
  }
  const auto gl = gl_gatherer();
  std::vector<std::vector<calc::PlaneField>> solved;
  for (const std::size_t tiles : {1u, 7u, 1000u}) {
    FixedTiles gatherer(*gl, tiles);
    solved.push_back(solve_with(room.scene, room.tasks, settings_of(64, 1), gatherer));
  }
  for (const auto& fields : solved) {
    for (std::size_t p = 0; p < fields.size(); ++p) {
      EXPECT_EQ(fields[p].indirect_lx, solved[0][p].indirect_lx);
      EXPECT_EQ(fields[p].largest_share, solved[0][p].largest_share);
      EXPECT_EQ(fields[p].counters.connection_rays, solved[0][p].counters.connection_rays);
    }
  }
}

// Many threads, some with pools that the device does not know yet.
TEST(GlDraws, GiveTheSameBitsOnManyThreads) {
  LUXGATE_NEEDS_OPENGL();
  std::vector<std::unique_ptr<Batch>> batches;
  for (std::size_t k = 0; k < 4; ++k)
    batches.push_back(std::make_unique<Batch>(0.3, 500 + 200 * k));
  const auto gl = gl_gatherer();
  std::vector<Sums> alone, all(48);
  for (const auto& batch : batches) alone.push_back(gather(*batch, *gl_gatherer(), 50));
  tbb::parallel_for(std::size_t{0}, all.size(),
                    [&](std::size_t k) { all[k] = gather(*batches[k % 4], *gl, 50); });
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k], alone[k % 4]) << k;
}

// Instant radiosity sends the vertices of a tree without it.
TEST(GlDraws, TakeNoPoolThatLacksItsTree) {
  LUXGATE_NEEDS_OPENGL();
  const Batch batch(0.3);
  const auto gl = gl_gatherer();
  std::vector<double> lx(2, 0.0);
  float largest_lx = 0.0f;
  const std::vector<calc::Connection> connections{{0, 0, 1.0f}};
  gl->gather({batch.tracer, batch.tree->vertices(), batch.bounds,
              std::span(batch.tiles.groups()[0].receiver).first(1), connections, true,
              batch.tree->identity()},
             {lx.data(), 1, &largest_lx});
  EXPECT_EQ(gather(batch, *gl, 100), gather(batch, *gl_gatherer(), 100));
}

// Mesa's llvmpipe leaves loops of an invocation after 65535 turns: the answer is right, or none.
TEST(GlDraws, DoNotTakeALoopCutShortForAnAnswer) {
  LUXGATE_NEEDS_OPENGL();
  constexpr std::uint32_t kDraws = 1u << 22;  // 64 invocations add them
  const Batch batch(std::numeric_limits<double>::infinity(), 3000, 1);
  ASSERT_EQ(batch.tiles.receivers(), 1u);
  const auto device = gl_device();
  try {
    const Sums b = gather(batch, *gpu::make_gl_gatherer(device), kDraws, false);
    const Sums a = gather(batch, *calc::make_cpu_gatherer(), kDraws, false);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(b.lx[0][k], a.lx[0][k], 1e-5 * a.lx[0][k]);
  } catch (const calc::BackendFailure& failure) {
    EXPECT_TRUE(device->device().is_software) << failure.what();
    EXPECT_STREQ(failure.what(), "the device did not finish its work");
  }
}

// The same of weights: more groups than a group of invocations has turns for.
TEST(GlDraws, DoNotTakeSumsOfWeightsCutShortForThem) {
  LUXGATE_NEEDS_OPENGL();
  constexpr std::size_t kNodes = 500'000;
  Batch batch(std::numeric_limits<double>::infinity(), kNodes + 10'000, 1);
  calc::ReceiverGroup group = batch.tiles.groups()[0];
  group.receiver[0].kernel = calc::ReceiverKernel::scalar;  // sees both channels
  batch.tiles = calc::ReceiverTiles({group});
  const auto device = gl_device();
  try {
    const Sums b = gather(batch, *gpu::make_gl_gatherer(device), 1000, false, 0.0, kNodes);
    const Sums a = gather(batch, *calc::make_cpu_gatherer(), 1000, false, 0.0, kNodes);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(b.lx[0][k], a.lx[0][k], 1e-4 * a.lx[0][k]);
  } catch (const calc::BackendFailure& failure) {
    EXPECT_TRUE(device->device().is_software) << failure.what();
    EXPECT_STREQ(failure.what(), "the device did not finish its work");
  }
}

TEST(GlDraws, EndAtTheDeadline) {
  LUXGATE_NEEDS_OPENGL();
  const Batch batch(0.3);
  const auto gl = gl_gatherer();
  EXPECT_EQ(gather(batch, *gl, 1000, true, 1e-9).rays, 0u);
  EXPECT_GT(gather(batch, *gl, 1000, true, 1e12).rays, 0u);
}

TEST(GlDraws, FailWithAReason) {
  LUXGATE_NEEDS_OPENGL();
  const Batch batch(0.3);
  for (const auto& [fault, text] : {std::pair{gpu::Fault::out_of_memory, "out of memory"},
                                    {gpu::Fault::context_lost, "reset"},
                                    {gpu::Fault::fence_lost, "has not answered"}}) {
    const auto gl = gl_gatherer(fault);
    for (int k = 0; k < 2; ++k) {
      try {
        gather(batch, *gl, 20);
        ADD_FAILURE() << text;
      } catch (const calc::BackendFailure& failure) {
        EXPECT_THAT(failure.what(), HasSubstr(text));
      }
    }
  }
}

// The answers of the piece before lie where those that do not come should be.
TEST(GlDraws, TakeNoEarlierAnswers) {
  LUXGATE_NEEDS_OPENGL();
  const Batch batch(0.3);
  const auto gl = gl_gatherer(gpu::Fault::results_lost);
  const Sums expected = gather(batch, *gl_gatherer(), 20);
  EXPECT_EQ(gather(batch, *gl, 20), expected);
  try {
    gather(batch, *gl, 20);
    ADD_FAILURE();
  } catch (const calc::BackendFailure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did not finish its work"));
  }
}

// A driver older than OpenGL 4.4.
TEST(GlDraws, GiveTheSameBitsWithoutBufferStorage) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_gatherer(gpu::Fault::no_buffer_storage);
  for (const double most : {0.02, 0.3}) {
    const Batch batch(most);
    EXPECT_EQ(gather(batch, *gl, 100), gather(batch, *gl_gatherer(), 100));
  }
}

// More bounded draws than pieces had so far: they are fetched in two parts.
TEST(GlDraws, FetchListsThatAreLongerThanExpected) {
  LUXGATE_NEEDS_OPENGL();
  const Batch few(0.3), many(0.002);
  const auto gl = gl_gatherer(), whole = gl_gatherer();
  gather(few, *gl, 20);
  const Sums first = gather(many, *gl, 200);
  EXPECT_EQ(first, gather(many, *gl, 200));
  EXPECT_NE(first, gather(few, *gl, 200));
  const auto cpu = calc::make_cpu_gatherer();
  const Sums expected = gather(many, *cpu, 200);
  EXPECT_EQ(first.rays, expected.rays);
  for (std::size_t t = 0; t < first.lx.size(); ++t) {
    for (std::size_t k = 0; k < first.lx[t].size(); ++k) {
      EXPECT_NEAR(first.lx[t][k], expected.lx[t][k], 1e-5 * expected.lx[t][k]);
    }
  }
}

// --- pieces of many threads ----------------------------------------------------------------------

// As the gatherer, with a queue that tells what it sent.
struct Queued : calc::Gatherer {
  Queued(std::shared_ptr<gpu::DeviceThread> device, const gpu::DrawLimits& limits)
      : thread(std::move(device)), draw_limits(limits), queue(limits) {}
  ~Queued() override {
    thread->clean_up([this](gpu::DeviceState&) { queue.clear(); });
  }
  std::uint64_t gather(const calc::GatherBatch&, const calc::GatherSums&) override { return 0; }
  std::uint64_t draw_and_gather(const calc::DrawBatch& batch) override {
    gpu::DrawPacker packer(batch, draw_limits);
    gpu::DrawPiece piece;
    std::uint64_t rays = 0;
    while (packer.next(piece)) {
      queue.run(*thread, piece, nullptr, nullptr);
      rays += packer.add(piece);
    }
    return rays;
  }
  std::string description() const override { return ""; }

  std::shared_ptr<gpu::DeviceThread> thread;
  gpu::DrawLimits draw_limits;
  gpu::DrawQueue queue;
};

constexpr std::size_t kCallers = 6;

// All callers' pieces wait for a device that is busy, and then go.
void gather_at_once(Queued& gl, const std::function<void(std::size_t)>& gather_one) {
  std::promise<void> is_blocked, gate;
  std::thread blocks([&] {
    gl.thread->run([&](gpu::DeviceState&) {
      is_blocked.set_value();
      gate.get_future().wait();
    });
  });
  is_blocked.get_future().wait();
  std::vector<std::thread> callers;
  for (std::size_t k = 0; k < kCallers; ++k) callers.emplace_back(gather_one, k);
  while (gl.queue.waiting() < kCallers) std::this_thread::yield();
  gate.set_value();
  blocks.join();
  for (std::thread& caller : callers) caller.join();
}

TEST(GlDrawQueue, SendsTogetherWhatWaits) {
  LUXGATE_NEEDS_OPENGL();
  std::vector<std::unique_ptr<Batch>> batches;
  std::vector<Sums> alone;
  for (std::size_t k = 0; k < kCallers; ++k) {
    batches.push_back(std::make_unique<Batch>(k % 2 == 0 ? 0.3 : 0.02, 500 + 200 * k));
    alone.push_back(gather(*batches[k], *gl_gatherer(), 50));
  }
  const std::size_t weights = batches[0]->tiles.receivers() * 200;
  const std::size_t places = batches[0]->tiles.receivers() * 51;
  const gpu::DrawLimits by_weights{1u << 21, 2 * weights}, by_places{3 * places, 1u << 23};
  for (const auto& [limits, sent] :
       {std::pair{gpu::DrawLimits(), 1u}, {by_weights, 3u}, {by_places, 2u}}) {
    Queued gl(gl_device(), limits);
    std::vector<Sums> all(kCallers);
    gather_at_once(gl, [&](std::size_t k) { all[k] = gather(*batches[k], gl, 50); });
    for (std::size_t k = 0; k < kCallers; ++k) EXPECT_EQ(all[k], alone[k]) << k;
    EXPECT_EQ(gl.queue.sent().batches, sent);
    EXPECT_EQ(gl.queue.sent().most_pieces, kCallers / sent);
    EXPECT_EQ(gl.queue.sent().beside, sent - 1);  // rays of each beside the choices of the next
  }
}

// What was sent with others, or waits with its draws known, fails with them; nobody waits for ever.
TEST(GlDrawQueue, TellsAllOfAFailure) {
  LUXGATE_NEEDS_OPENGL();
  const Batch batch(0.3);
  for (const gpu::Fault fault : {gpu::Fault::out_of_memory, gpu::Fault::context_lost}) {
    Queued gl(gl_device(fault), {1u << 21, 2 * batch.tiles.receivers() * 200});
    std::atomic<std::size_t> failures{0};
    gather_at_once(gl, [&](std::size_t) {
      try {
        gather(batch, gl, 50);
      } catch (const calc::BackendFailure&) {
        ++failures;
      }
    });
    EXPECT_EQ(failures, kCallers);
  }
}

// Small pieces in all buffers that are large make the next large piece fill others.
TEST(GlDrawPass, KeepsNoMoreMemoryThanItsLimitsSay) {
  LUXGATE_NEEDS_OPENGL();
  const gpu::DrawLimits limits{4000, 80'000};
  const Batch batch(0.3);
  const calc::ReceiverTiles few({batch.tiles.groups()[0]});
  const std::vector<calc::GatherSums> wanted(batch.tiles.groups().size());
  const auto batch_of = [&](const calc::ReceiverTiles& tiles, std::size_t nodes) {
    return calc::DrawBatch{batch.tracer,
                           *batch.tree,
                           batch.bounds,
                           {nodes, 0.5f, true},
                           50,
                           true,
                           0.0,
                           calc::RandomKey(77),
                           tiles,
                           0,
                           std::span(wanted).first(tiles.groups().size())};
  };
  const calc::DrawBatch large = batch_of(batch.tiles, 1000), small = batch_of(few, 10);
  const auto device = gl_device();
  device->run([&](gpu::DeviceState& state) {
    gpu::DrawPass pass(device->device(), limits);
    std::array<gpu::DrawPiece, 8> pieces;
    std::vector<gpu::DrawTask> held;
    const auto send = [&](const calc::DrawBatch& of, gpu::DrawPiece& piece) {
      ASSERT_TRUE(gpu::DrawPacker(of, limits).next(piece));
      held.push_back({&piece, nullptr, nullptr, pass.take_slot(piece).value()});
      pass.send(state, std::span(held).last(1), {});
      pass.send(state, {}, std::span(held).last(1));
    };
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      send(small, pieces[k]);
      gpu::DrawPiece piece;
      send(large, piece);
      pass.finish(state, held.back());
      held.pop_back();
    }
    EXPECT_GT(pass.bytes(), gpu::DrawPass::most_bytes(limits));  // in use
    for (const gpu::DrawTask& task : held) pass.finish(state, task);
    held.clear();
    for (gpu::DrawPiece& piece : pieces) piece = {};  // what came back is given back
    send(small, pieces[0]);
    EXPECT_LE(pass.bytes(), gpu::DrawPass::most_bytes(limits));
    pass.finish(state, held.back());
  });
}

// A plane of more tiles than are kept together.
TEST(GlDraws, GoOnInTheNextBlockOfTiles) {
  LUXGATE_NEEDS_OPENGL();
  const Batch light(0.3);
  std::vector<calc::ReceiverGroup> groups(gpu::kTilesPerBlock + 5);
  for (std::uint32_t t = 0; t < groups.size(); ++t) {
    const calc::RandomKey key = calc::RandomKey(5).with(t);
    groups[t] = {{t},
                 {{{2.0 + 2 * key.with(0).uniform(), 2.0 + key.with(1).uniform(), 0.7},
                   {0, 0, 1},
                   calc::ReceiverKernel::planar}}};
  }
  const calc::ReceiverTiles tiles(groups);
  const std::size_t first = gpu::kTilesPerBlock - 3;
  const auto lx_of = [&](calc::Gatherer& gatherer, std::size_t first_tile, std::size_t count) {
    std::vector<double> lx(2 * count);
    std::vector<float> largest_lx(count);
    std::vector<calc::GatherSums> sums;
    for (std::size_t k = 0; k < count; ++k) sums.push_back({&lx[2 * k], 1, &largest_lx[k]});
    gatherer.draw_and_gather({light.tracer,
                              *light.tree,
                              light.bounds,
                              {200, 0.5f, true},
                              50,
                              true,
                              0.0,
                              calc::RandomKey(3),
                              tiles,
                              first_tile,
                              sums});
    return lx;
  };
  const auto gl = gl_gatherer();
  const std::vector<double> all = lx_of(*gl, first, 8),
                            cpu = lx_of(*calc::make_cpu_gatherer(), first, 8);
  std::vector<double> parts = lx_of(*gl, first, 3);
  const std::vector<double> behind = lx_of(*gl, gpu::kTilesPerBlock, 5);
  parts.insert(parts.end(), behind.begin(), behind.end());
  EXPECT_EQ(all, parts);
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_NEAR(all[k], cpu[k], 1e-5 * cpu[k]);
}

}  // namespace
}  // namespace gpu_draws_test
