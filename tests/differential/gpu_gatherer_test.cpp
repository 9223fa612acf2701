// The OpenGL gatherer against the CPU's: the same sum, up to rounding and rays that graze an edge.
#include "calc/project/project_xml.h"
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/sampling/random.h"
#include "tests/support/opengl.h"
#include "tests/support/same_sum.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <filesystem>
#include <limits>
#include <utility>

namespace gpu_gatherer_test {
namespace {

using namespace test_support;
using ::testing::HasSubstr;

// Vertices on floor and ceiling, receivers of all kinds among boxes, all connected to all.
struct Crowd {
  calc::PreparedScene scene;
  std::unique_ptr<calc::Tracer> tracer;
  calc::LightVertices vertices;
  std::vector<calc::Receiver> receivers;
  std::vector<calc::Connection> connections;

  explicit Crowd(std::size_t vertex_count = 700, std::size_t receiver_count = 45) {
    add_box(scene, {-2, -2, 0}, {4, 4, 3}, 0.5);
    add_box(scene, {-0.5, -0.5, 0.8}, {1, 1, 0.7}, 0.5);
    add_box(scene, {0.9, -1.4, 0.0}, {0.3, 0.4, 1.9}, 0.5);
    add_sphere(scene, 0.6, 2, 0.5);
    set_extent(scene);
    tracer = std::make_unique<calc::Tracer>(scene);
    const calc::RandomKey key(9);
    for (std::size_t j = 0; j < vertex_count; ++j) {
      const auto u = [&](std::uint64_t k) { return key.with(j).with(k).uniform(); };
      const glm::dvec3 normal(0, 0, j % 2 == 0 ? 1 : -1);
      const glm::dvec3 position(4 * u(0) - 2, 4 * u(1) - 2, j % 2 == 0 ? 0.0 : 3.0);
      vertices.push_back({glm::vec3(tracer->lift(position, normal)), static_cast<float>(0.1 + u(2)),
                          glm::vec3(normal), j % 3 == 0 ? 1u : 0u});
    }
    for (std::size_t i = 0; i < receiver_count; ++i) {
      const auto u = [&](std::uint64_t k) { return key.with(5000 + i).with(k).uniform(); };
      const auto kernel = static_cast<calc::ReceiverKernel>(i % 5);
      const glm::dvec3 axis = kernel == calc::ReceiverKernel::semicylindrical
                                  ? glm::dvec3(u(3) - 0.5, u(4) - 0.5, 0.0)
                                  : glm::dvec3(u(3) - 0.5, u(4) - 0.5, i % 4 == 0 ? -1.0 : 1.0);
      receivers.push_back(
          {{3.8 * u(0) - 1.9, 3.8 * u(1) - 1.9, 0.1 + 2.7 * u(2)}, glm::normalize(axis), kernel});
      for (std::uint32_t j = 0; j < vertex_count; ++j) {
        connections.push_back({static_cast<std::uint32_t>(i), j, i % 3 == 0 ? 2.0f : 1.0f});
      }
    }
  }
};

struct Gathered {
  std::vector<double> lx;
  std::vector<float> largest_lx;
  std::uint64_t rays = 0;
  friend bool operator==(const Gathered&, const Gathered&) = default;
};

Gathered gather(const Crowd& crowd, calc::Gatherer& gatherer, const calc::VertexBounds& bounds,
                std::span<const calc::Connection> connections, bool has_shadows = true,
                std::uint64_t identity = 0) {
  const std::size_t count = crowd.receivers.size();
  Gathered result{std::vector<double>(2 * count, 1.0), std::vector<float>(count, 0.0f), 0};
  result.rays = gatherer.gather(
      {*crowd.tracer, crowd.vertices, bounds, crowd.receivers, connections, has_shadows, identity},
      {result.lx.data(), count, result.largest_lx.data()});
  return result;
}

void expect_same_sum(const Gathered& cpu, const Gathered& gpu) {
  EXPECT_EQ(cpu.rays, gpu.rays);
  double sum_cpu = 0.0, sum_gpu = 0.0;
  for (std::size_t k = 0; k < cpu.lx.size(); ++k) {
    EXPECT_NEAR(gpu.lx[k] / cpu.lx[k], 1.0, 1e-5) << k;
    sum_cpu += cpu.lx[k];
    sum_gpu += gpu.lx[k];
  }
  EXPECT_NEAR(sum_gpu / sum_cpu, 1.0, 1e-6);
  for (std::size_t i = 0; i < cpu.largest_lx.size(); ++i) {
    EXPECT_NEAR(gpu.largest_lx[i], cpu.largest_lx[i], 1e-5f * cpu.largest_lx[i]) << i;
  }
}

TEST(GlGatherer, GivesTheSameSumForAllKernels) {
  LUXGATE_NEEDS_OPENGL();
  const Crowd crowd;
  const auto gl = gl_gatherer();
  const auto cpu = calc::make_cpu_gatherer();
  for (const double most : {0.05, 0.2, std::numeric_limits<double>::infinity()}) {
    const calc::VertexBounds bounds(most);
    for (const bool has_shadows : {true, false}) {
      const Gathered expected = gather(crowd, *cpu, bounds, crowd.connections, has_shadows);
      expect_same_sum(expected, gather(crowd, *gl, bounds, crowd.connections, has_shadows));
      EXPECT_EQ(expected.rays > 0, has_shadows);
    }
  }
}

// One connection at a time: every ray must agree with Tracer::blocked() unless it passes an edge
// within rounding.
TEST(GlGatherer, SeesWhatTheCpuSees) {
  LUXGATE_NEEDS_OPENGL();
  Crowd crowd(700, 300);
  const auto gl = gl_gatherer();
  const auto cpu = calc::make_cpu_gatherer();
  const calc::VertexBounds bounds(std::numeric_limits<double>::infinity());
  // A receiver of its own for each connection shows each by itself.
  std::vector<calc::Receiver> receivers;
  std::size_t differing = 0, blocked = 0, seen = 0;
  std::vector<calc::Connection> connections;
  for (const calc::Connection& connection : crowd.connections) {
    receivers.push_back(crowd.receivers[connection.receiver]);
    connections.push_back(
        {static_cast<std::uint32_t>(connections.size()), connection.vertex, 1.0f});
  }
  crowd.receivers = std::move(receivers);
  const Gathered a = gather(crowd, *cpu, bounds, connections);
  const Gathered b = gather(crowd, *gl, bounds, connections);
  // What a surface's edge takes within rounding needs no ray.
  EXPECT_NEAR(static_cast<double>(a.rays), static_cast<double>(b.rays),
              static_cast<double>(connections.size()) / 50'000);
  for (std::size_t i = 0; i < connections.size(); ++i) {
    const bool cpu_sees = a.largest_lx[i] > 0.0f, gl_sees = b.largest_lx[i] > 0.0f;
    ++(cpu_sees ? seen : blocked);
    if (cpu_sees != gl_sees) ++differing;
  }
  EXPECT_GT(seen, 30'000u);
  EXPECT_GT(blocked, 30'000u);
  RecordProperty("differing", static_cast<int>(differing));
  EXPECT_LE(differing, connections.size() / 50'000) << "of " << connections.size();
}

// Rays aimed at shared edges and corners of a closed surface must not slip through.
TEST(GlGatherer, ClosedSurfacesDoNotLeak) {
  LUXGATE_NEEDS_OPENGL();
  Crowd crowd(0, 1);
  crowd.connections.clear();
  calc::PreparedScene sphere;
  add_sphere(sphere, 1.0, 3, 0.5);
  set_extent(sphere);
  crowd.scene = sphere;
  crowd.tracer = std::make_unique<calc::Tracer>(crowd.scene);
  crowd.receivers = {{{0.013, -0.007, 0.021}, {0, 0, 1}, calc::ReceiverKernel::scalar}};
  for (const glm::uvec3& t : sphere.triangle) {
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 a = sphere.vertex_m[t[k]], b = sphere.vertex_m[t[(k + 1) % 3]];
      for (const float share : {0.0f, 0.25f, 0.5f}) {
        const glm::vec3 through = a + share * (b - a);
        const glm::vec3 from(crowd.receivers[0].position_m);
        crowd.vertices.push_back(
            {from + 2.0f * (through - from), 1.0f, -glm::normalize(through), 0});
        crowd.connections.push_back(
            {0, static_cast<std::uint32_t>(crowd.vertices.size() - 1), 1.0f});
      }
    }
  }
  const calc::VertexBounds bounds(std::numeric_limits<double>::infinity());
  const Gathered result = gather(crowd, *gl_gatherer(), bounds, crowd.connections);
  EXPECT_EQ(result.rays, crowd.connections.size());
  EXPECT_EQ(result.largest_lx[0], 0.0f);
}

TEST(GlGatherer, GivesTheSameBitsAgainAndInPieces) {
  LUXGATE_NEEDS_OPENGL();
  const Crowd crowd;
  const auto gl = gl_gatherer();
  const calc::VertexBounds bounds(0.2);
  const Gathered once = gather(crowd, *gl, bounds, crowd.connections, true, 77);
  EXPECT_EQ(once, gather(crowd, *gl, bounds, crowd.connections, true, 77));
  EXPECT_EQ(once, gather(crowd, *gl_gatherer(), bounds, crowd.connections));
  // More than one dispatch.
  std::vector<calc::Connection> many;
  for (int k = 0; k < 12; ++k) {
    many.insert(many.end(), crowd.connections.begin(), crowd.connections.end());
  }
  const Gathered repeated = gather(crowd, *gl, bounds, many, true, 77);
  EXPECT_EQ(repeated.rays, 12 * once.rays);
  for (std::size_t k = 0; k < once.lx.size(); ++k) {
    EXPECT_NEAR((repeated.lx[k] - 1.0) / 12.0, once.lx[k] - 1.0, 1e-9 * once.lx[k]);
  }
}

TEST(GlGatherer, GivesTheSameBitsOnManyThreads) {
  LUXGATE_NEEDS_OPENGL();
  const Crowd crowd(200, 45);
  const auto gl = gl_gatherer();
  const calc::VertexBounds bounds(0.2);
  const Gathered alone = gather(crowd, *gl, bounds, crowd.connections, true, 5);
  std::vector<Gathered> all(64);
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t k) {
    // Some bring their vertices along, some let them be kept.
    all[k] = gather(crowd, *gl, bounds, crowd.connections, true, k % 3 == 0 ? 0 : k % 3 + 4);
  });
  for (const Gathered& gathered : all) EXPECT_EQ(alone, gathered);
}

// Other vertices and another scene at the same addresses: nothing that was kept may be used.
TEST(GlGatherer, TellsReusedMemoryApart) {
  LUXGATE_NEEDS_OPENGL();
  const auto gl = gl_gatherer();
  const auto cpu = calc::make_cpu_gatherer();
  const calc::VertexBounds bounds(0.2);
  Crowd crowd(100, 10);
  const Gathered before = gather(crowd, *gl, bounds, crowd.connections, true, 11);
  for (calc::LightVertex& v : crowd.vertices) v.flux_lm *= 3.0f;
  const Gathered brighter = gather(crowd, *gl, bounds, crowd.connections, true, 12);
  EXPECT_GT(brighter.lx[0], before.lx[0]);
  expect_same_sum(gather(crowd, *cpu, bounds, crowd.connections), brighter);
  add_quad(crowd.scene, {-2, -2, 2.5}, {4, 0, 0}, {0, 4, 0}, 0.5);
  crowd.tracer->~Tracer();
  new (crowd.tracer.get()) calc::Tracer(crowd.scene);
  const Gathered darker = gather(crowd, *gl, bounds, crowd.connections, true, 12);
  EXPECT_NE(darker.lx, brighter.lx);
  expect_same_sum(gather(crowd, *cpu, bounds, crowd.connections), darker);
}

TEST(GlGatherer, FailsWithAReason) {
  std::string problem;
  EXPECT_EQ(gpu::DeviceThread::open({-1, gpu::Fault::no_egl}, problem), nullptr);
  EXPECT_EQ(problem, "there is no EGL library (libEGL.so.1)");
  LUXGATE_NEEDS_OPENGL();
  const Crowd crowd(10, 5);
  const calc::VertexBounds bounds(0.2);
  for (const auto& [fault, text] : {std::pair{gpu::Fault::out_of_memory, "out of memory"},
                                    {gpu::Fault::context_lost, "reset"},
                                    {gpu::Fault::fence_lost, "has not answered"}}) {
    const auto gl = gl_gatherer(fault);
    for (int k = 0; k < 2; ++k) {  // not only the first time
      try {
        gather(crowd, *gl, bounds, crowd.connections);
        ADD_FAILURE() << text;
      } catch (const calc::BackendFailure& failure) {
        EXPECT_THAT(failure.what(), HasSubstr(text));
      }
    }
  }
}

TEST(GlGatherer, TakesNoEarlierResults) {
  LUXGATE_NEEDS_OPENGL();
  const Crowd crowd(10, 5);
  const calc::VertexBounds bounds(0.2);
  const auto gl = gl_gatherer(gpu::Fault::results_lost);
  gather(crowd, *gl, bounds, crowd.connections);
  try {
    gather(crowd, *gl, bounds, crowd.connections);
    ADD_FAILURE();
  } catch (const calc::BackendFailure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
  }
}

// --- the whole calculation -----------------------------------------------------------------------

calc::RadiositySettings settings_of(std::uint64_t paths, int jobs) {
  calc::RadiositySettings settings;
  settings.first_paths = paths / 2;
  settings.max_paths = paths;
  settings.replicates = 4;
  settings.jobs = jobs;
  return settings;
}

void expect_same_sum(const calc::PreparedScene& scene, const std::vector<calc::PlaneTask>& tasks,
                     calc::RadiositySettings settings) {
  const auto cpu = calc::make_cpu_gatherer();
  const auto gl = gl_gatherer();
  const std::vector<calc::PlaneField> a = solve_with(scene, tasks, settings, *cpu);
  const std::vector<calc::PlaneField> b = solve_with(scene, tasks, settings, *gl);
  const SameSum same = compare_sums(a, b);
  EXPECT_LE(same.grazed, same.values / 200) << "of " << same.values;
  EXPECT_LE(same.mean_difference(), 1e-6);
  EXPECT_LE(same.largest_grazed, 0.01);
}

struct Room {
  calc::PhotometricWeb web = lambert_web(500.0, 18, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0});
  calc::PreparedScene scene;
  calc::SensorGrid task, corner;

  Room() {
    add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.6);
    add_box(scene, {1, 1, 0}, {1, 0.8, 0.7}, 0.4);
    add_luminaire(scene, web, {1.5, 1.5, 2.5});
    add_luminaire(scene, web, {3.0, 1.5, 2.5});
    scene.channels.push_back({"second", 0.8});
    scene.luminaires[1].channel = 1;
    set_extent(scene);
    for (int i = 0; i < 40; ++i) {
      task.position_m.emplace_back(0.1 + 0.09 * i, 0.3 + 0.06 * i, 0.75);
      task.normal.emplace_back(0, 0, 1);
      corner.position_m.emplace_back(0.01, 0.05 + 0.07 * i, 0.02);  // the bound matters here
      corner.normal.emplace_back(1, 0, 0);
    }
  }
};

TEST(GlSolve, GivesTheSameSumForRooms) {
  LUXGATE_NEEDS_OPENGL();
  const Room room;
  expect_same_sum(room.scene, {{"task", &room.task}, {"corner", &room.corner}},
                  settings_of(512, 2));
  calc::RadiositySettings settings = settings_of(64, 2);
  settings.method = calc::Method::instant_radiosity;
  expect_same_sum(room.scene, {{"task", &room.task}, {"corner", &room.corner}}, settings);
}

// Its weights are 0 in single precision: what the others get is no number then, if nobody looks.
TEST(GlSolve, GivesTheSameSumBesideAChannelOfNextToNothing) {
  LUXGATE_NEEDS_OPENGL();
  Room room;
  room.scene.luminaires[1].flux_scale = 1e-41;
  expect_same_sum(room.scene, {{"task", &room.task}}, settings_of(512, 2));
}

TEST(GlSolve, GivesTheSameBitsForAnyNumberOfThreads) {
  LUXGATE_NEEDS_OPENGL();
  const Room room;
  const auto gl = gl_gatherer();
  const std::vector<calc::PlaneTask> tasks{{"task", &room.task}, {"corner", &room.corner}};
  const auto one = solve_with(room.scene, tasks, settings_of(128, 1), *gl);
  for (const int jobs : {2, 8}) {
    const auto many = solve_with(room.scene, tasks, settings_of(128, jobs), *gl);
    for (std::size_t p = 0; p < one.size(); ++p) {
      EXPECT_EQ(one[p].indirect_lx, many[p].indirect_lx);
      EXPECT_EQ(one[p].largest_share, many[p].largest_share);
      EXPECT_EQ(one[p].counters.connection_rays, many[p].counters.connection_rays);
    }
  }
}

TEST(GlSolve, EndsWithTheReasonWhenTheDeviceFails) {
  LUXGATE_NEEDS_OPENGL();
  const Room room;
  const auto gl = gl_gatherer(gpu::Fault::context_lost);
  EXPECT_THROW(solve_with(room.scene, {{"task", &room.task}}, settings_of(64, 4), *gl),
               calc::BackendFailure);
}

TEST(GlSolve, GivesTheSameSumForEveryExample) {
  LUXGATE_NEEDS_OPENGL();
  const std::filesystem::path folder = std::filesystem::path(LUXGATE_SOURCE_DIR) / "examples";
  std::size_t count = 0;
  for (const std::filesystem::directory_entry& entry :
       std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path file = entry.path() / "project.xml";
    if (!std::filesystem::exists(file)) continue;
    SCOPED_TRACE(file.string());
    ++count;
    calc::Diagnostics diagnostics;
    const auto project = calc::load_project(calc::DiskFileReader(), file.string(), diagnostics);
    ASSERT_TRUE(project);
    for (const calc::Space& space : project->spaces) {
      std::vector<calc::SensorGrid> grids;
      for (const calc::CalcPlane& plane : space.planes) {
        auto grid = calc::make_sensor_grid(plane, space, diagnostics);
        if (grid) grids.push_back(std::move(*grid));
      }
      std::vector<calc::PlaneTask> tasks;
      for (std::size_t p = 0; p < grids.size(); ++p) {
        tasks.push_back({"plane " + std::to_string(p), &grids[p]});
      }
      expect_same_sum(calc::prepare_scene(*project, space), tasks, settings_of(128, 2));
    }
  }
  EXPECT_GE(count, 7u);
}

}  // namespace
}  // namespace gpu_gatherer_test
