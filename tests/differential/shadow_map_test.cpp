// Shadow maps against rays: fewer wrong pairs as maps grow, and a whole run that agrees.
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/sampling/random.h"
#include "gpu/gather/shader_text.h"
#include "gpu/raster/shadow_map_gatherer.h"
#include "gpu/raster/shadow_map_pass.h"
#include "tests/support/opengl.h"
#include "tests/support/same_sum.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shadow_map_test {
namespace {

using namespace test_support;
using ::testing::HasSubstr;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// Vertices on all sides of a room with furniture, receivers anywhere.
struct Furnished {
  calc::PreparedScene scene;
  std::unique_ptr<calc::Tracer> tracer;
  calc::LightVertices vertices;
  std::vector<calc::Receiver> receivers;

  explicit Furnished(bool is_empty = false) {
    add_box(scene, {-2, -2, 0}, {4, 4, 3}, 0.5);
    if (!is_empty) {
      add_box(scene, {-0.5, -0.5, 0.8}, {1, 1, 0.7}, 0.5);
      add_box(scene, {0.9, -1.4, 0.0}, {0.3, 0.4, 1.9}, 0.5);
      add_sphere(scene, 0.6, 2, 0.5);
    }
    set_extent(scene);
    tracer = std::make_unique<calc::Tracer>(scene);
    const calc::RandomKey key(4);
    const std::vector<std::pair<glm::dvec3, glm::dvec3>> sides{{{0, 0, 0}, {0, 0, 1}},
                                                               {{0, 0, 3}, {0, 0, -1}},
                                                               {{-2, 0, 1.5}, {1, 0, 0}},
                                                               {{2, 0, 1.5}, {-1, 0, 0}},
                                                               {{0, 2, 1.5}, {0, -1, 0}}};
    for (std::size_t j = 0; j < 200; ++j) {
      const auto u = [&](std::uint64_t k) { return key.with(j).with(k).uniform() - 0.5; };
      const auto& [middle, normal] = sides[j % sides.size()];
      glm::dvec3 p = middle + glm::dvec3(3.8 * u(0), 3.8 * u(1), 2.8 * u(2));
      for (int k = 0; k < 3; ++k) {
        if (normal[k] != 0.0) p[k] = middle[k];
      }
      vertices.push_back({glm::vec3(tracer->lift(p, normal)), 1.0f + static_cast<float>(u(3)),
                          glm::vec3(normal), static_cast<std::uint32_t>(j % 2)});
    }
    for (std::size_t i = 0; i < 150; ++i) {
      const auto u = [&](std::uint64_t k) { return key.with(900 + i).with(k).uniform() - 0.5; };
      const glm::dvec3 at = is_empty ? glm::dvec3(2.4 * u(0), 2.4 * u(1), 0.0)
                                     : glm::dvec3(3.8 * u(0), 3.8 * u(1), 1.5 + 2.8 * u(2));
      const glm::dvec3 axis =
          is_empty ? glm::dvec3(0, 0, 1) : glm::normalize(glm::dvec3(u(3), u(4), 0.8 * u(5)));
      receivers.push_back({at, axis, calc::ReceiverKernel::planar});
    }
  }
};

// Share of pairs facing each other of which a map says another thing than a ray.
double disagreement(const Furnished& room, gpu::DeviceThread& device, std::uint32_t texels) {
  std::vector<gpu::GpuReceiver> receivers;
  for (const calc::Receiver& r : room.receivers) {
    receivers.push_back({glm::vec4(glm::vec3(r.position_m), 0.0f),
                         glm::vec4(glm::vec3(r.axis), 0.0f),
                         glm::vec4(glm::vec3(room.tracer->lift(r)), 0.0f)});
  }
  std::size_t pairs = 0, different = 0, hidden = 0;
  const auto take = [&](std::size_t vertex, std::size_t first, std::size_t count,
                        std::span<const std::uint32_t> results) {
    for (std::size_t k = 0; k < results.size(); ++k) {
      EXPECT_NE(results[k], gpu::kNotDone);
      if (results[k] == gpu::kNoRay) continue;
      const calc::Receiver& r = room.receivers[first + k % count];
      const bool is_hidden = results[k] == gpu::kAddsNothing;
      const bool is_blocked = room.tracer->is_blocked(
          room.tracer->lift(r), glm::dvec3(room.vertices[vertex + k / count].position_m));
      ++pairs;
      if (is_hidden) ++hidden;
      if (is_hidden != is_blocked) ++different;
    }
  };
  device.run([&](gpu::DeviceState& state) {
    gpu::ShadowMapPass pass(texels, {});
    pass.run(state, {room.tracer.get(), room.vertices, receivers, 1e9f, true, 0.0, take});
  });
  EXPECT_GT(pairs, 8000u);
  EXPECT_GT(hidden, pairs / 20);
  return static_cast<double>(different) / static_cast<double>(pairs);
}

TEST(ShadowMaps, DisagreeLessWithRaysTheLargerTheyAre) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room;
  const auto device = gl_device();
  double before = 0.0;
  for (const std::uint32_t texels : {32u, 64u, 128u, 256u}) {
    const double share = disagreement(room, *device, texels);
    RecordProperty("texels" + std::to_string(texels), std::to_string(share));
    EXPECT_GT(share, 0.0) << "a map cannot be exact";
    EXPECT_LT(share, 0.12 / std::sqrt(texels));
    if (before > 0.0) {
      EXPECT_LT(share, 0.8 * before) << texels;
    }
    before = share;
  }
}

struct Sums {
  std::vector<double> lx;
  std::vector<float> largest_lx;
  std::vector<std::uint32_t> pairs;
  friend bool operator==(const Sums&, const Sums&) = default;
};

Sums gather_all(const Furnished& room, calc::Gatherer& gatherer, double most_per_m2 = kNoLimit,
                bool has_shadows = true, double deadline_s = 0.0) {
  const std::size_t count = room.receivers.size();
  Sums sums{std::vector<double>(2 * count, 0.0), std::vector<float>(count, 0.0f), {}};
  const calc::VertexBounds bounds(most_per_m2);
  sums.pairs =
      gatherer
          .gather_all(
              {*room.tracer, room.vertices, bounds, room.receivers, {}, has_shadows, 0, deadline_s},
              {sums.lx.data(), count, sums.largest_lx.data()})
          .pairs;
  return sums;
}

// The floor is in every map, and points lie in it: no bias may make it hide them, however coarse
// the map and however flat the light.
TEST(ShadowMaps, DoNotHideASurfaceFromItself) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room(true);
  const auto device = gl_device();
  for (const std::uint32_t texels : {16u, 128u}) {
    const auto gatherer = gpu::make_shadow_map_gatherer(device, texels);
    const Sums with = gather_all(room, *gatherer);
    EXPECT_EQ(with, gather_all(room, *gatherer, kNoLimit, false)) << texels;
    EXPECT_GT(with.lx[0], 0.0);
  }
}

// Without anything between, sums are those of the CPU, limited or not.
TEST(ShadowMaps, AddWhatConnectionsAdd) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room(true);
  const auto gatherer = gpu::make_shadow_map_gatherer(gl_device(), 64);
  const auto cpu = calc::make_cpu_gatherer();
  std::vector<calc::Connection> connections;
  for (std::uint32_t i = 0; i < room.receivers.size(); ++i) {
    for (std::uint32_t j = 0; j < room.vertices.size(); ++j) connections.push_back({i, j, 1.0f});
  }
  for (const double most : {0.05, kNoLimit}) {
    const Sums sums = gather_all(room, *gatherer, most);
    std::vector<double> expected(sums.lx.size(), 0.0);
    std::vector<float> largest(sums.largest_lx.size(), 0.0f);
    const calc::VertexBounds bounds(most);
    const std::uint64_t rays =
        cpu->gather({*room.tracer, room.vertices, bounds, room.receivers, connections},
                    {expected.data(), room.receivers.size(), largest.data()});
    std::uint64_t pairs = 0;
    for (const std::uint32_t count : sums.pairs) pairs += count;
    EXPECT_EQ(pairs, rays);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(sums.lx[k], expected[k], 1e-5 * expected[k]) << k;
    }
  }
}

TEST(ShadowMaps, GiveTheSameBitsAgain) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room;
  const auto gatherer = gpu::make_shadow_map_gatherer(gl_device(), 64);
  const Sums once = gather_all(room, *gatherer);
  EXPECT_EQ(once, gather_all(room, *gatherer));
  EXPECT_EQ(once, gather_all(room, *gpu::make_shadow_map_gatherer(gl_device(), 64)));
}

TEST(ShadowMaps, EndAtTheDeadline) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room;
  const auto gatherer = gpu::make_shadow_map_gatherer(gl_device(), 64);
  for (const double lx : gather_all(room, *gatherer, kNoLimit, true, 1e-9).lx) EXPECT_EQ(lx, 0.0);
  EXPECT_EQ(gather_all(room, *gatherer, kNoLimit, true, 1e12), gather_all(room, *gatherer));
}

TEST(ShadowMaps, EndWithTheReasonWhenTheDeviceFails) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room;
  for (const auto& [fault, text] : {std::pair{gpu::Fault::out_of_memory, "out of memory"},
                                    {gpu::Fault::context_lost, "reset"},
                                    {gpu::Fault::fence_lost, "has not answered"}}) {
    const auto gatherer = gpu::make_shadow_map_gatherer(gl_device(fault), 16);
    for (int k = 0; k < 2; ++k) {
      try {
        gather_all(room, *gatherer);
        ADD_FAILURE() << text;
      } catch (const calc::BackendFailure& failure) {
        EXPECT_THAT(failure.what(), HasSubstr(text));
      }
    }
  }
}

TEST(ShadowMaps, TakeNoEarlierResults) {
  LUXGATE_NEEDS_OPENGL();
  const Furnished room;
  const auto gatherer = gpu::make_shadow_map_gatherer(gl_device(gpu::Fault::results_lost), 16);
  try {
    gather_all(room, *gatherer);
    gather_all(room, *gatherer);
    ADD_FAILURE();
  } catch (const calc::BackendFailure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
  }
}

TEST(ShadowMaps, AWholeRunAgreesWithRaysForAnyNumberOfThreads) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web =
      lambert_web(500.0, 18, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0});
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.6);
  add_box(scene, {1, 1, 0}, {1, 0.8, 0.7}, 0.4);
  add_luminaire(scene, web, {1.5, 1.5, 2.5});
  set_extent(scene);
  calc::SensorGrid task, wall;
  for (int i = 0; i < 40; ++i) {
    task.position_m.emplace_back(0.1 + 0.09 * i, 0.3 + 0.06 * i, 0.75);
    task.normal.emplace_back(0, 0, 1);
    wall.position_m.emplace_back(0.0, 0.05 + 0.07 * i, 1.2);
    wall.normal.emplace_back(1, 0, 0);
  }
  calc::RadiositySettings settings;
  settings.method = calc::Method::instant_radiosity;
  settings.first_paths = settings.max_paths = 64;
  settings.replicates = 4;
  const std::vector<calc::PlaneTask> both{{"task", &task}, {"wall", &wall}};
  const auto cpu = calc::make_cpu_gatherer();
  const auto rays = solve_with(scene, both, settings, *cpu);
  settings.shadow_map_texels = 128;
  ASSERT_EQ(validate(settings), "");
  const auto gatherer = gpu::make_shadow_map_gatherer(gl_device(), 128);
  settings.jobs = 1;
  const auto maps = solve_with(scene, both, settings, *gatherer);
  const SameSum same = compare_sums(rays, maps);
  EXPECT_LT(same.mean_difference(), 5e-3);
  EXPECT_LT(same.largest_grazed, 0.1);
  EXPECT_EQ(rays[0].counters.connection_rays, maps[0].counters.connection_rays);
  settings.jobs = 4;
  const auto many = solve_with(scene, both, settings, *gatherer);
  const auto alone = solve_with(scene, {{"wall", &wall}}, settings, *gatherer);
  EXPECT_EQ(maps[0].indirect_lx, many[0].indirect_lx);
  EXPECT_EQ(maps[1].indirect_lx, alone[0].indirect_lx);
  EXPECT_EQ(maps[1].counters.connection_rays, alone[0].counters.connection_rays);
}

TEST(ShadowMaps, SettingsSayWhatIsAllowed) {
  calc::RadiositySettings settings;
  settings.shadow_map_texels = 64;
  EXPECT_THAT(validate(settings), HasSubstr("instant radiosity"));
  settings.method = calc::Method::instant_radiosity;
  EXPECT_EQ(validate(settings), "");
  for (const std::uint32_t texels : {8u, 96u, 4096u}) {
    settings.shadow_map_texels = texels;
    EXPECT_THAT(validate(settings), HasSubstr("a power of two, 16 to 2048"));
  }
}

}  // namespace
}  // namespace shadow_map_test
