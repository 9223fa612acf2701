// Direct light by OpenGL against the CPU's, point by point and replicate by replicate.
#include "calc/radiosity/direct/direct_tracer.h"
#include "calc/radiosity/gather/gatherer.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/opengl.h"
#include "tests/support/same_sum.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

namespace gpu_direct_test {
namespace {

using namespace test_support;
using calc::OpeningShape;
using calc::RandomKey;

// Points of all kinds in a space, some of them in the plane of the floor.
std::vector<calc::Receiver> points_in(const glm::dvec3& low, const glm::dvec3& size,
                                      std::size_t count) {
  std::vector<calc::Receiver> points;
  for (std::size_t i = 0; i < count; ++i) {
    const RandomKey key = RandomKey(29).with(i);
    const auto u = [&](std::uint64_t k) { return key.with(k).uniform(); };
    const auto kernel = static_cast<calc::ReceiverKernel>(i % 5);
    glm::dvec3 axis = glm::normalize(glm::dvec3(u(3) - 0.5, u(4) - 0.5, u(5) - 0.5));
    if (i % 10 == 0) axis = {0, 0, 1};
    if (kernel == calc::ReceiverKernel::semicylindrical) {
      axis = glm::normalize(glm::dvec3(axis.x, axis.y, 0.0));
    }
    glm::dvec3 at = low + size * glm::dvec3(0.02 + 0.96 * u(0), 0.02 + 0.96 * u(1), u(2));
    if (i % 10 == 0) at.z = low.z;
    points.push_back({at, axis, kernel});
  }
  return points;
}

std::vector<RandomKey> keys_of(std::size_t count) {
  std::vector<RandomKey> keys;
  for (std::size_t i = 0; i < count; ++i) keys.push_back(RandomKey(31).with(i));
  return keys;
}

struct Sums {
  std::vector<double> known_lx, sampled_lx;
  std::vector<float> largest;
  std::vector<calc::DirectRays> rays;

  Sums(std::size_t points, std::size_t channels, std::size_t replicates)
      : known_lx(points * channels),
        sampled_lx(points * channels * replicates),
        largest(points),
        rays(points) {}

  calc::DirectBatchSums spans() { return {known_lx, sampled_lx, largest, rays}; }
};

Sums by_cpu(const calc::DirectBatch& batch, const std::vector<RandomKey>& keys,
            const calc::OpeningRounds& rounds) {
  const std::size_t n = batch.receivers.size(), channels = batch.tracer.scene().channels.size();
  Sums sums(n, channels, rounds.replicates);
  for (std::size_t k = 0; k < n; ++k) {
    sums.rays[k] = calc::add_openings(
        batch.tracer, batch.receivers[k], batch.proofs, keys[k], rounds,
        {&sums.known_lx[k], &sums.sampled_lx[k], n, channels * n, &sums.largest[k]});
  }
  return sums;
}

Sums by_gl(calc::DirectTracer& gl, const calc::DirectBatch& batch,
           const std::vector<RandomKey>& keys, const calc::OpeningRounds& rounds) {
  Sums sums(batch.receivers.size(), batch.tracer.scene().channels.size(), rounds.replicates);
  gl.add_openings(batch, keys, rounds, sums.spans());
  return sums;
}

std::unique_ptr<calc::DirectTracer> gl_direct(gpu::Fault fault = gpu::Fault::none) {
  return gpu::make_gl_direct_tracer(gl_device(fault));
}

// Of the light of all replicates: known and sampled together.
struct Comparison {
  std::size_t values = 0, differing = 0;  // by more than rounding
  double largest = 0.0;                   // relative, of those that do not differ
  double sum_a_lx = 0.0, sum_b_lx = 0.0;
};

Comparison compare(const Sums& a, const Sums& b) {
  Comparison result;
  const std::size_t known = a.known_lx.size();
  for (std::size_t i = 0; i < a.sampled_lx.size(); ++i) {
    const double x = a.known_lx[i % known] + a.sampled_lx[i];
    const double y = b.known_lx[i % known] + b.sampled_lx[i];
    ++result.values;
    result.sum_a_lx += x;
    result.sum_b_lx += y;
    const double difference = x == y ? 0.0 : std::abs(x - y) / std::max(std::abs(x), std::abs(y));
    if (difference > 1e-5) {
      ++result.differing;
    } else {
      result.largest = std::max(result.largest, difference);
    }
  }
  std::printf("%zu of %zu values differ by more than 1e-5, the others by %.2g; sums by %.2g\n",
              result.differing, result.values, result.largest,
              std::abs(result.sum_a_lx - result.sum_b_lx) / result.sum_a_lx);
  return result;
}

struct Hall {
  std::vector<std::unique_ptr<calc::PhotometricWeb>> webs;
  calc::PreparedScene scene;

  void add(calc::PhotometricWeb web, const glm::dvec3& at_m, std::uint32_t channel = 0) {
    webs.push_back(std::make_unique<calc::PhotometricWeb>(std::move(web)));
    add_luminaire(scene, *webs.back(), at_m);
    scene.luminaires.back().channel = channel;
  }
};

// Panels, a disk, a line near which points lie, furniture.
Hall office() {
  Hall hall;
  hall.scene.channels = {{"a", 1.0}, {"b", 1.0}, {"dark", 1.0}};
  add_box(hall.scene, {0, 0, 0}, {6, 4, 2.8}, 0.5);
  add_box(hall.scene, {2, 1, 0.7}, {1.6, 0.8, 0.05}, 0.4);
  add_box(hall.scene, {4, 2.5, 0}, {0.5, 1.0, 1.6}, 0.3);
  add_sphere(hall.scene, 0.2, 2, 0.3);
  for (int k = 0; k < 6; ++k) {
    hall.add(lambert_web(1000, 9, {OpeningShape::rectangle, 1.2, 0.3, 0.0}),
             {1.0 + 2.0 * (k % 3), k < 3 ? 1.0 : 3.0, 2.8}, k % 2 == 0 ? 0u : 1u);
  }
  const auto crooked = [](const calc::LuminousOpening& opening) {
    return crooked_web(opening, calc::TableAxis::vertical, 0.0, kNoBeams_cd);
  };
  hall.add(crooked({OpeningShape::disk, 0.4, 0.2, 0.0}), {3, 2, 2.7}, 1u);
  hall.add(crooked({OpeningShape::rectangle, 0.5, 0.4, 0.0}), {1.5, 3.2, 2.0});
  hall.add(lambert_web(300, 18, {OpeningShape::rectangle, 3.0, 0.02, 0.0}), {3, 2, 2.0}, 1u);
  hall.add(lambert_web(300, 18), {2, 2, 2.5});
  set_extent(hall.scene);
  return hall;
}

TEST(GlDirect, AddsThePointSourcesOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  Hall hall = office();
  for (int k = 0; k < 12; ++k) {
    hall.add(
        crooked_web({}, k % 2 == 0 ? calc::TableAxis::vertical : calc::TableAxis::lateral, 0.1 * k),
        {0.4 + 0.45 * k, 0.5 + 0.25 * k, 2.6}, static_cast<std::uint32_t>(k % 2));
    hall.scene.luminaires.back().world_from_luminaire = tilted_axes(0.3 * k, 0.2 * k);
  }
  hall.scene.luminaires.back().reach = calc::LightReach{{0.6, 0.8}, 2.0};
  const calc::Tracer tracer(hall.scene);
  const auto gl = gl_direct();
  const std::vector<calc::Receiver> points = points_in({0, 0, 0}, {6, 4, 2.8}, 2000);
  std::vector<std::uint8_t> dark(hall.scene.luminaires.size(), 0);
  dark[dark.size() - 2] = 1;
  for (const bool has_shadows : {true, false}) {
    const calc::DirectBatch batch{tracer, points, {dark, has_shadows}, 0.0};
    const std::size_t n = points.size();
    std::vector<double> cpu(3 * n), device(3 * n);
    std::uint64_t rays = 0;
    for (std::size_t k = 0; k < n; ++k) {
      rays += calc::add_point_sources(tracer, points[k], batch.proofs, &cpu[k], n).traced;
    }
    EXPECT_EQ(gl->add_point_sources(batch, device), rays);
    std::size_t grazed = 0, lit = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < cpu.size(); ++i) {
      if (cpu[i] > 0.0) ++lit;
      const double difference =
          cpu[i] == device[i] ? 0.0 : std::abs(cpu[i] - device[i]) / std::max(cpu[i], device[i]);
      if (difference > 1e-9) {
        ++grazed;
      } else {
        largest = std::max(largest, difference);
      }
    }
    std::printf("%zu of %zu values differ by more than 1e-9, the others by %.2g\n", grazed, lit,
                largest);
    EXPECT_GT(lit, 3000u);
    EXPECT_LE(grazed, has_shadows ? lit / 500 : 0u);
  }
}

TEST(GlDirect, AddsTheOpeningsOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall = office();
  const calc::Tracer tracer(hall.scene);
  const auto gl = gl_direct();
  const std::vector<calc::Receiver> points = points_in({0, 0, 0}, {6, 4, 2.8}, 600);
  const std::vector<RandomKey> keys = keys_of(points.size());
  for (const bool has_shadows : {true, false}) {
    const calc::DirectBatch batch{tracer, points, {{}, has_shadows}, 0.0};
    const calc::OpeningRounds rounds{0, 1, 4, 1.0};
    const Sums cpu = by_cpu(batch, keys, rounds), device = by_gl(*gl, batch, keys, rounds);
    const Comparison same = compare(cpu, device);
    const std::size_t grazing =
        has_shadows || roundings_of_hardware() > 1.0 ? same.values / 500 : 0;
    EXPECT_LE(same.differing, grazing);
    EXPECT_NEAR(same.sum_b_lx / same.sum_a_lx, 1.0, 1e-5);
    std::size_t unlike = 0;
    std::uint64_t cpu_rays = 0, device_rays = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const calc::DirectRays &a = cpu.rays[k], &b = device.rays[k];
      cpu_rays += a.traced;
      device_rays += b.traced;
      if (a.has_hidden != b.has_hidden || a.has_seen != b.has_seen ||
          a.may_be_lit != b.may_be_lit ||
          std::abs(cpu.largest[k] - device.largest[k]) >
              1e-5f * std::max(cpu.largest[k], device.largest[k])) {
        ++unlike;
      }
    }
    EXPECT_LE(unlike, points.size() / 500);
    EXPECT_NEAR(static_cast<double>(device_rays), static_cast<double>(cpu_rays),
                0.002 * static_cast<double>(cpu_rays));
    EXPECT_EQ(device_rays > 0, has_shadows);
  }
}

// Bodies are sampled always.
TEST(GlDirect, AddsTheBodiesOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6, false, kNoBeams_cd);
  const calc::Tracer tracer(hall.scene);
  const auto gl = gl_direct();
  const std::vector<calc::Receiver> points = points_in({-4, -3, 0}, {8, 6, 2.3}, 200);
  const std::vector<RandomKey> keys = keys_of(points.size());
  const calc::DirectBatch batch{tracer, points, {}, 0.0};
  EXPECT_FALSE(calc::has_fine_beams(hall.scene, {}, points)) << "devices know of none";
  const calc::OpeningRounds rounds{1, 3, 2, 4.0};
  const Comparison same = compare(by_cpu(batch, keys, rounds), by_gl(*gl, batch, keys, rounds));
  EXPECT_LE(static_cast<double>(same.differing),
            roundings_of_hardware() * static_cast<double>(same.values) / 200);
  EXPECT_NEAR(same.sum_b_lx / same.sum_a_lx, 1.0, 1e-5);
}

// Their pyramids are flat: all of what float says of a plane that is none would be wrong.
TEST(GlDirect, AddsTheLinesOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  Hall hall;
  hall.scene.channels = {{"a", 1.0}};
  add_box(hall.scene, {0, 0, 0}, {6, 4, 2.8}, 0.5);
  add_box(hall.scene, {2, 1, 0.7}, {1.6, 0.8, 0.05}, 0.4);
  for (int k = 0; k < 6; ++k) {
    hall.add(lambert_web(1000, 9, {OpeningShape::rectangle, 0.0, 1.2, 0.0}),
             {1.0 + 2.0 * (k % 3), k < 3 ? 1.0 : 3.0, 2.7});
  }
  set_extent(hall.scene);
  const calc::Tracer tracer(hall.scene);
  const auto gl = gl_direct();
  const std::vector<calc::Receiver> points = points_in({0, 0, 0}, {6, 4, 2.6}, 300);
  const std::vector<RandomKey> keys = keys_of(points.size());
  const calc::DirectBatch batch{tracer, points, {}, 0.0};
  const calc::OpeningRounds rounds{0, 1, 2, 1.0};
  const Sums cpu = by_cpu(batch, keys, rounds), device = by_gl(*gl, batch, keys, rounds);
  const Comparison same = compare(cpu, device);
  const double room = roundings_of_hardware();
  EXPECT_LE(static_cast<double>(same.differing), room * static_cast<double>(same.values) / 300);
  std::uint64_t cpu_rays = 0, device_rays = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    cpu_rays += cpu.rays[k].traced;
    device_rays += device.rays[k].traced;
  }
  // A flat pyramid has its middle in two of its planes within rounding: a device may prove another
  // one free, whose pair then needs no rays.
  const double share = room > 1.0 ? 0.2 : 0.002;
  EXPECT_NEAR(static_cast<double>(device_rays), static_cast<double>(cpu_rays),
              share * static_cast<double>(cpu_rays));
}

// Under a luminous ceiling.
TEST(GlDirect, ADeviceLeavesWhatIsTooNearToTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  Hall hall;
  hall.scene.channels = {{"a", 1.0}};
  add_box(hall.scene, {0, 0, 0}, {20, 20, 3}, 0.5);
  add_box(hall.scene, {9, 9, 0}, {1, 1, 1}, 0.5);
  hall.add(lambert_web(1e6, 18, {OpeningShape::rectangle, 18.0, 18.0, 0.0}), {10, 10, 2.99});
  hall.add(lambert_web(1e3, 18, {OpeningShape::rectangle, 0.5, 0.3, 0.0}), {3, 3, 2.5});
  set_extent(hall.scene);
  const calc::Tracer tracer(hall.scene);
  const auto gl = gl_direct();
  std::vector<calc::Receiver> points = points_in({0, 0, 0}, {20, 20, 2.4}, 40);
  const std::vector<RandomKey> keys = keys_of(points.size());
  const calc::DirectBatch batch{tracer, points, {}, 0.0};
  const calc::OpeningRounds rounds{0, 1, 2, 1.0};
  const Comparison same = compare(by_cpu(batch, keys, rounds), by_gl(*gl, batch, keys, rounds));
  EXPECT_LE(static_cast<double>(same.differing),
            roundings_of_hardware() * static_cast<double>(same.values) / 200);
  EXPECT_NEAR(same.sum_b_lx / same.sum_a_lx, 1.0, 1e-5);
}

TEST(GlDirect, HowWorkIsCutChangesNoBit) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall = office();
  const calc::Tracer tracer(hall.scene);
  const std::vector<calc::Receiver> points = points_in({0, 0, 0}, {6, 4, 2.8}, 60);
  const std::vector<RandomKey> keys = keys_of(points.size());
  const calc::DirectBatch batch{tracer, points, {}, 0.0};
  const calc::OpeningRounds rounds{0, 2, 3, 1.0};
  const auto thread = gl_device();
  const auto whole = gpu::make_gl_direct_tracer(thread);
  const Sums expected = by_gl(*whole, batch, keys, rounds);
  for (const gpu::DirectLimits& limits : {gpu::DirectLimits{37, 100}, gpu::DirectLimits{1000, 1}}) {
    const auto cut = gpu::make_gl_direct_tracer(thread, limits);
    const Sums sums = by_gl(*cut, batch, keys, rounds);
    EXPECT_EQ(sums.known_lx, expected.known_lx);
    EXPECT_EQ(sums.sampled_lx, expected.sampled_lx);
    EXPECT_EQ(sums.largest, expected.largest);
  }
  // Rounds in two steps are the same samples.
  Sums steps = by_gl(*whole, batch, keys, {0, 1, 3, 1.0});
  whole->add_openings(batch, keys, {1, 2, 3, 1.0}, steps.spans());
  EXPECT_EQ(steps.known_lx, expected.known_lx);
  for (std::size_t i = 0; i < steps.sampled_lx.size(); ++i) {
    EXPECT_NEAR(steps.sampled_lx[i], expected.sampled_lx[i],
                1e-9 * (1.0 + std::abs(expected.sampled_lx[i])));
  }
}

TEST(GlDirect, FailuresAreNoResults) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall = office();
  const calc::Tracer tracer(hall.scene);
  const std::vector<calc::Receiver> points = points_in({0, 0, 0}, {6, 4, 2.8}, 10);
  const std::vector<RandomKey> keys = keys_of(points.size());
  const calc::DirectBatch batch{tracer, points, {}, 0.0};
  for (const gpu::Fault fault : {gpu::Fault::out_of_memory, gpu::Fault::context_lost,
                                 gpu::Fault::fence_lost, gpu::Fault::results_lost}) {
    const auto gl = gpu::make_gl_direct_tracer(gl_device(fault), {37, 100});  // in pieces
    std::vector<double> lx(3 * points.size());
    EXPECT_THROW(gl->add_point_sources(batch, lx), calc::BackendFailure);
    EXPECT_THROW(by_gl(*gl, batch, keys, {0, 1, 2, 1.0}), calc::BackendFailure);
  }
}

TEST(GlDirect, PastItsDeadlineItStops) {
  LUXGATE_NEEDS_OPENGL();
  const Hall hall = office();
  const calc::Tracer tracer(hall.scene);
  const std::vector<calc::Receiver> points = points_in({0, 0, 0}, {6, 4, 2.8}, 10);
  const auto gl = gl_direct();
  const calc::DirectBatch batch{tracer, points, {}, 1e-9};
  const Sums sums = by_gl(*gl, batch, keys_of(points.size()), {0, 1, 2, 1.0});
  EXPECT_EQ(std::count(sums.known_lx.begin(), sums.known_lx.end(), 0.0),
            static_cast<std::ptrdiff_t>(sums.known_lx.size()));
}

}  // namespace
}  // namespace gpu_direct_test
