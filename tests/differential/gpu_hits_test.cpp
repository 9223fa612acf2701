// Light at the hits of short rays by OpenGL against the CPU's, point by point.
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "gpu/scene/plane_blocks.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/near_points.h"
#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace gpu_hits_test {
namespace {

using namespace test_support;
using calc::HitLight;
using calc::OpeningShape;
using calc::ReceiverKernel;
using calc::ShortRayLight;
using ::testing::HasSubstr;

// One device for all tests that need no other: drivers compile for seconds.
class GlHits : public ::testing::Test {
 protected:
  static void TearDownTestSuite() { device_.reset(); }

  static std::shared_ptr<gpu::DeviceThread> device() {
    if (!device_) device_ = gl_device();
    return device_;
  }
  static std::unique_ptr<calc::ShortRayCaster> caster(const gpu::HitLimits& limits = {}) {
    return gpu::make_gl_short_rays(device(), limits);
  }
  static std::unique_ptr<calc::ShortRayCaster> first_steps() {
    return caster({.leaves_all = true});
  }

 private:
  inline static std::shared_ptr<gpu::DeviceThread> device_;
};

// Of each request: light by channels, largest ray, rays.
struct Sums {
  std::vector<double> lx;
  std::vector<float> largest;
  std::vector<std::uint64_t> rays;
};

Sums sums_of(const calc::NearField& field, const NearPoints& points, const ShortRayLight* found) {
  const std::size_t channels = field.channels;
  Sums sums{std::vector<double>(channels * points.requests.size()),
            std::vector<float>(points.requests.size()),
            {}};
  for (std::size_t r = 0; r < points.requests.size(); ++r) {
    std::optional<calc::PointLight> own;
    if (found != nullptr) own = found->of(r);
    sums.rays.push_back(calc::add_near_field(field, points.requests[r], own, &sums.lx[channels * r],
                                             1, sums.largest[r]));
  }
  EXPECT_TRUE(found == nullptr || found->points() == points.requests.size());
  return sums;
}

ShortRayLight find(calc::ShortRayCaster& gl, const NearScene& field, const NearPoints& points) {
  ShortRayLight found;
  gl.find_light(field.near(), points.batch(), found);
  return found;
}

double sum_of(const std::vector<double>& lx) { return std::accumulate(lx.begin(), lx.end(), 0.0); }

// What the device was asked for, so that no test is about nothing: of first steps, which it leaves
// to the CPU if it is told to.
struct Kinds {
  std::size_t hits = 0, direct = 0, hidden = 0, unlit = 0, left = 0, next = 0;
  std::size_t draws = 0, hidden_draws = 0;
  std::vector<std::size_t> of_luminaire;
};

Kinds kinds_of(const NearScene& field, const std::vector<HitLight>& found) {
  Kinds kinds;
  kinds.of_luminaire.resize(field.scene.luminaires.size());
  for (const HitLight& light : found) {
    ++kinds.hits;
    kinds.left += light.luminaire == HitLight::kLeft ? 1 : 0;
    kinds.hidden += light.luminaire == HitLight::kHidden ? 1 : 0;
    kinds.unlit += light.luminaire == HitLight::kNothing ? 1 : 0;
    if (light.luminaire < kinds.of_luminaire.size()) {
      ++kinds.direct;
      ++kinds.of_luminaire[light.luminaire];
    }
    kinds.next += light.next_triangle_and_side != HitLight::kNothing ? 1 : 0;
    for (const HitLight::Draw& draw : light.draws) {
      kinds.draws += draw.channel < HitLight::kLeft ? 1 : 0;
      kinds.hidden_draws += draw.channel == HitLight::kHidden ? 1 : 0;
    }
  }
  std::printf(
      "%zu hits; direct: %zu, hidden %zu, none %zu, left %zu; from afar: %zu, hidden %zu; %zu "
      "chains go on\n",
      kinds.hits, kinds.direct, kinds.hidden, kinds.unlit, kinds.left, kinds.draws,
      kinds.hidden_draws, kinds.next);
  return kinds;
}

// A ray that grazes an edge, or a draw at the border of two, changes all of what hangs on it.
constexpr double kRounding = 1e-6;
// Of a single sample, a product of floats along up to three steps and over squares of short
// distances: the sums are means of many. 2.2e-6 was seen on Mesa 25 between sheets 0.1 m apart.
constexpr double kRoundingOfOne = 4e-6;

// grazed: share of values that may differ by more than rounding.
void expect_same_sums(const Sums& cpu, const Sums& device, double grazed) {
  std::size_t lit = 0, differing = 0;
  double largest = 0.0, cpu_lx = 0.0, device_lx = 0.0;
  for (std::size_t i = 0; i < cpu.lx.size(); ++i) {
    const double a = cpu.lx[i], b = device.lx[i];
    cpu_lx += a;
    device_lx += b;
    if (a == 0.0 && b == 0.0) continue;
    ++lit;
    const double difference = std::abs(a - b) / std::max(a, b);
    if (difference > kRounding) {
      ++differing;
    } else {
      largest = std::max(largest, difference);
    }
  }
  std::size_t unlike = 0;
  std::uint64_t cpu_rays = 0, device_rays = 0;
  const std::size_t points = cpu.rays.size();
  for (std::size_t r = 0; r < points; ++r) {
    cpu_rays += cpu.rays[r];
    device_rays += device.rays[r];
    const bool is_same =
        cpu.rays[r] == device.rays[r] && std::abs(cpu.largest[r] - device.largest[r]) <=
                                             static_cast<float>(kRoundingOfOne) * cpu.largest[r];
    if (!is_same) ++unlike;
  }
  std::printf(
      "%zu of %zu values differ by more than %.0e, the others by %.2g; sums by %.2g; %zu of "
      "%zu points in rays or the largest\n",
      differing, lit, kRounding, largest, std::abs(device_lx / cpu_lx - 1.0), unlike, points);
  const double room = roundings_of_hardware();
  const double most = room * grazed * static_cast<double>(points);
  EXPECT_GT(lit, points / 4);
  EXPECT_LE(static_cast<double>(differing), most);
  EXPECT_LE(static_cast<double>(unlike), most);
  EXPECT_NEAR(device_lx / cpu_lx, 1.0, room * 1e-4);
  EXPECT_NEAR(static_cast<double>(device_rays), static_cast<double>(cpu_rays),
              1e-3 * static_cast<double>(cpu_rays));
}

// Chains by the device, and first steps by it with all else by the CPU. Returns what it did;
// most_left: of its hits, to the CPU.
Kinds expect_same(const NearScene& field, const NearPoints& points, calc::ShortRayCaster& gl,
                  calc::ShortRayCaster& first_steps, double grazed, double most_left) {
  const Sums cpu = sums_of(field.near(), points, nullptr);
  const ShortRayLight found = find(gl, field, points), first = find(first_steps, field, points);
  expect_same_sums(cpu, sums_of(field.near(), points, &found), grazed);
  expect_same_sums(cpu, sums_of(field.near(), points, &first), grazed);
  EXPECT_LE(static_cast<double>(found.left.size()),
            most_left * static_cast<double>(first.left.size()));
  std::printf("%zu of %zu hits are left to the CPU\n", found.left.size(), first.left.size());
  for (const double lx : first.lx) EXPECT_EQ(lx, 0.0);
  return kinds_of(field, first.left);
}

// Bodies, panels and points in two channels, walls of reflectance 0, points of all kernels.
TEST_F(GlHits, GiveTheLightOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6);
  const NearScene field(hall.scene, 512);
  const Kinds kinds =
      expect_same(field, points_in_hall(600, 64), *caster(), *first_steps(), 0.01, 0.01);
  EXPECT_GT(kinds.hits, 2000u);
  EXPECT_GT(kinds.hidden, 100u);
  EXPECT_GT(kinds.unlit, 100u);
  EXPECT_GT(kinds.next, 100u);
  EXPECT_GT(kinds.draws, 4000u);
  EXPECT_GT(kinds.hidden_draws, 100u);
  for (const std::size_t count : kinds.of_luminaire) EXPECT_GT(count, 10u);
}

// Points whose light would be another if no vertex had a bound.
std::size_t points_with_bounds(const NearScene& field, const NearPoints& points) {
  const calc::VertexBounds none(std::numeric_limits<double>::infinity());
  const calc::NearField near = field.near();
  const calc::NearField free{near.tracer, near.bound, near.luminaires, near.tree,
                             none,        near.cut,   near.channels};
  const Sums with = sums_of(near, points, nullptr), without = sums_of(free, points, nullptr);
  std::size_t count = 0;
  for (std::size_t i = 0; i < with.lx.size(); ++i) {
    if (without.lx[i] > with.lx[i] * (1.0 + kRounding)) ++count;
  }
  return count;
}

// Two spots beside a wall raise bounds there; so many vertices around that some draws come near.
TEST_F(GlHits, GiveItBesideBrightSpots) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = isotropic_web(100.0), other = lambert_web(80.0, 9);
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}};
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.7);
  add_box(scene, {0.3, 1.0, 0}, {0.5, 1.0, 1.4}, 0.5);
  add_luminaire(scene, web, {0.03, 1.5, 1.5});
  add_luminaire(scene, other, {0.2, 1.2, 1.5});
  set_extent(scene);
  const NearScene field(scene, 4096);
  std::vector<calc::Receiver> receivers;
  for (std::size_t i = 0; i < 300; ++i) {
    const calc::RandomKey key = calc::RandomKey(31).with(i);
    const auto u = [&](std::uint64_t k) { return key.with(k).uniform(); };
    const glm::dvec3 at(0.002 + 0.1 * u(0), 0.8 + 1.4 * u(1), 0.8 + 1.4 * u(2));
    receivers.push_back({at, {0, 0, i % 2 == 0 ? 1 : -1}, ReceiverKernel::planar});
  }
  const NearPoints points(receivers, 64);
  const Kinds kinds = expect_same(field, points, *caster(), *first_steps(), 0.01, 0.01);
  EXPECT_GT(points_with_bounds(field, points), 10u);
  EXPECT_GT(kinds.direct, 1000u);
}

// Many luminaires, one channel among them weak and one dark.
TEST_F(GlHits, ChooseTheLuminaireOfTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb panel = lambert_web(1000, 9, {OpeningShape::rectangle, 1.2, 0.3, 0.0});
  const calc::PhotometricWeb spot = lambert_web(30, 18);
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}, {"dark", 1.0}, {"weak", 1.0}};
  add_box(scene, {0, 0, 0}, {10, 8, 2.8}, 0.5);
  add_box(scene, {4, 3, 0}, {1.6, 0.8, 1.5}, 0.4);
  for (int k = 0; k < 40; ++k) {
    add_luminaire(scene, k % 5 == 0 ? spot : panel,
                  {0.7 + 1.2 * (k % 8), 0.8 + 1.6 * (k / 8), 2.8});
    scene.luminaires.back().channel = k % 5 == 0 ? 2u : 0u;
    if (k % 3 == 0) scene.luminaires.back().world_from_luminaire = tilted_axes(0.4 * k, 0.5);
  }
  set_extent(scene);
  const NearScene field(scene, 512);
  std::vector<calc::Receiver> receivers;
  for (std::size_t i = 0; i < 150; ++i) {
    const calc::RandomKey key = calc::RandomKey(37).with(i);
    receivers.push_back({{10.0 * key.with(0).uniform(), 0.02 + 0.2 * key.with(1).uniform(),
                          0.1 + 2.6 * key.with(2).uniform()},
                         {0, 0, i % 3 == 0 ? -1 : 1},
                         ReceiverKernel::planar});
  }
  const NearPoints points(receivers, 64);
  const Kinds kinds = expect_same(field, points, *caster(), *first_steps(), 0.01, 0.02);
  EXPECT_GT(std::count_if(kinds.of_luminaire.begin(), kinds.of_luminaire.end(),
                          [](std::size_t count) { return count > 0; }),
            30);
}

// A sheet slopes down from a panel: where it touches, that falls into more parts than a shader
// visits; farther down into several, of which one is drawn.
TEST_F(GlHits, LeaveWhatIsTooNearToTheCpu) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb panel = lambert_web(1e4, 18, {OpeningShape::rectangle, 2.0, 1.6, 0.0});
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}};
  add_box(scene, {0, 0, 0}, {8, 8, 3}, 0.5);
  add_luminaire(scene, panel, {4, 4, 2.0});
  add_quad(scene, {3, 3, 1.99}, {2, 0, -1.6}, {0, 2, 0}, 0.6);
  set_extent(scene);
  const NearScene field(scene, 512);
  std::vector<calc::Receiver> receivers;
  for (std::size_t i = 0; i < 100; ++i) {
    const calc::RandomKey key = calc::RandomKey(41).with(i);
    const double along = 2.0 * key.with(0).uniform();
    receivers.push_back({{3.0 + along, 3.0 + 2.0 * key.with(1).uniform(), 2.1 - 0.8 * along},
                         {0, 0, -1},
                         ReceiverKernel::planar});
  }
  const NearPoints points(receivers, 32);
  const Kinds kinds = expect_same(field, points, *caster(), *first_steps(), 0.01, 0.3);
  EXPECT_GT(kinds.left, 100u);
  EXPECT_GT(kinds.direct, 100u);
}

// Between two sheets chains go on and on: the device follows them for some steps, and leaves to the
// CPU what goes on longer.
TEST_F(GlHits, FollowChainsBetweenSheets) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}, {"b", 1.0}};
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
  add_quad(scene, {1, 1, 1.0}, {1, 0, 0}, {0, 1, 0}, 0.6);
  add_quad(scene, {1, 1, 1.1}, {1, 0, 0}, {0, 1, 0}, 0.5);
  add_luminaire(scene, web, {1.5, 1.5, 1.05});
  add_luminaire(scene, web, {1.2, 0.8, 1.02});
  scene.luminaires.back().channel = 1;
  set_extent(scene);
  const NearScene field(scene, 512);
  std::vector<calc::Receiver> receivers;
  for (std::size_t i = 0; i < 100; ++i) {
    const calc::RandomKey key = calc::RandomKey(47).with(i);
    receivers.push_back({{1.0 + key.with(0).uniform(), 1.0 + key.with(1).uniform(), 1.05},
                         {0, 0, i % 2 == 0 ? 1 : -1},
                         ReceiverKernel::planar});
  }
  const NearPoints points(receivers, 64);
  const Kinds kinds = expect_same(field, points, *caster(), *first_steps(), 0.01, 0.1);
  EXPECT_GT(kinds.next, kinds.hits / 4);
}

// Points with so many hits that one of them fills several pieces; llvmpipe leaves long loops.
TEST_F(GlHits, AddUpManyHitsOfAPoint) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}, {"b", 1.0}};
  add_box(scene, {0, 0, 0}, {6, 5, 2.5}, 0.5);
  add_quad(scene, {1, 1, 1.1}, {1, 0, 0}, {0, 1, 0}, 0.3);
  add_luminaire(scene, web, {4, 3, 0.5});
  add_luminaire(scene, web, {5, 2, 0.4});
  scene.luminaires.back().channel = 1;
  set_extent(scene);
  const NearScene field(scene, 64);
  std::vector<calc::Receiver> receivers;
  for (int k = 0; k < 3; ++k) {
    receivers.push_back({{1.3 + 0.2 * k, 1.5, 1.05}, {0, 0, 1}, ReceiverKernel::planar});
  }
  const NearPoints points(receivers, 8192);
  const Kinds kinds = expect_same(field, points, *caster(), *first_steps(), 0.0, 0.02);
  EXPECT_GT(kinds.hits, 3u * 7000u);
}

// A convex room: nothing is in the way. One luminaire, and no vertex at all.
TEST_F(GlHits, GiveItWithoutShadowsAndWithoutVertices) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = lambert_web(100.0, 9);
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}};
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
  add_luminaire(scene, web, {2, 1.5, 2.4});
  set_extent(scene);
  std::vector<calc::Receiver> receivers;
  for (std::size_t i = 0; i < 60; ++i) {
    const calc::RandomKey key = calc::RandomKey(43).with(i);
    receivers.push_back({{0.05, 3.0 * key.with(0).uniform(), 0.1 + key.with(1).uniform()},
                         {0, 0, 1},
                         ReceiverKernel::planar});
  }
  const NearPoints points(receivers, 32);
  NearScene field(scene, 256);
  field.tracer.leave_out_shadows();
  const Kinds free = expect_same(field, points, *caster(), *first_steps(), 0.0, 0.02);
  EXPECT_EQ(free.hidden + free.hidden_draws, 0u);
  NearScene none(scene, 1);
  none.tree = calc::VertexTree({}, 1);
  none.cut = calc::Cut();
  const Kinds dark = expect_same(none, points, *caster(), *first_steps(), 0.0, 0.0);
  EXPECT_EQ(dark.draws, 0u);
  EXPECT_GT(dark.direct, 100u);
}

bool are_same_bits(const HitLight& x, const HitLight& y) {
  return x.triangle_and_side == y.triangle_and_side && x.request == y.request && x.ray == y.ray &&
         x.weight == y.weight && std::memcmp(&x.place, &y.place, sizeof x.place) == 0 &&
         x.luminaire == y.luminaire && x.direct_lx == y.direct_lx &&
         x.next_triangle_and_side == y.next_triangle_and_side &&
         std::memcmp(x.draws.data(), y.draws.data(), sizeof x.draws) == 0;
}

bool are_same_bits(const ShortRayLight& a, const ShortRayLight& b) {
  return a.lx == b.lx && a.largest_lx == b.largest_lx && a.rays == b.rays &&
         std::equal(a.left.begin(), a.left.end(), b.left.begin(), b.left.end(),
                    [](const HitLight& x, const HitLight& y) { return are_same_bits(x, y); });
}

TEST_F(GlHits, HowWorkIsCutChangesNoBit) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6);
  const NearScene field(hall.scene, 256), other(hall.scene, 128);
  const auto whole = caster();
  const NearPoints points = points_in_hall(100, 32);
  const ShortRayLight expected = find(*whole, field, points);
  const ShortRayLight elsewhere = find(*whole, other, points);
  EXPECT_GT(find(*first_steps(), field, points).left.size(), 200u);
  EXPECT_FALSE(are_same_bits(expected, elsewhere));
  EXPECT_TRUE(are_same_bits(expected, find(*caster({.hits = 37}), field, points)));
  EXPECT_TRUE(are_same_bits(expected, find(*caster({.answer_bytes = 100}), field, points)));
  EXPECT_TRUE(
      are_same_bits(expected, find(*gl_short_rays(gpu::Fault::no_buffer_storage), field, points)));
  EXPECT_TRUE(are_same_bits(find(*first_steps(), field, points),
                            find(*caster({.hits = 37, .leaves_all = true}), field, points)));
  // Some points at a time, into one list.
  ShortRayLight parts;
  const calc::NearFieldBatch all = points.batch();
  for (std::size_t first = 0; first < all.points.size(); first += 13) {
    const std::size_t count = std::min<std::size_t>(13, all.points.size() - first);
    whole->find_light(field.near(), {all.tiles, all.key, all.points.subspan(first, count)}, parts);
  }
  EXPECT_TRUE(are_same_bits(expected, parts));
  std::vector<char> is_same(12);
  tbb::parallel_for(std::size_t{0}, is_same.size(), [&](std::size_t k) {
    is_same[k] = k % 2 == 0 ? are_same_bits(expected, find(*whole, field, points))
                            : are_same_bits(elsewhere, find(*whole, other, points));
  });
  EXPECT_EQ(std::count(is_same.begin(), is_same.end(), 1), 12);
}

// A plane of more tiles than are kept together.
TEST_F(GlHits, GoOnInTheNextBlockOfTiles) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6);
  const NearScene field(hall.scene, 256);
  std::vector<calc::Receiver> receivers;
  for (const auto& request : points_in_hall(gpu::kTilesPerBlock + 40, 1).requests) {
    receivers.push_back(request.receiver);
  }
  NearPoints points(receivers, 32, 1);
  points.points.erase(points.points.begin(), points.points.end() - 80);
  points.requests.erase(points.requests.begin(), points.requests.end() - 80);
  expect_same(field, points, *caster(), *first_steps(), 0.02, 0.1);
}

TEST_F(GlHits, FailuresAreNoResults) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6);
  const NearScene field(hall.scene, 64);
  const NearPoints points = points_in_hall(30, 32);
  for (const auto& [fault, text] : {std::pair{gpu::Fault::out_of_memory, "out of memory"},
                                    {gpu::Fault::context_lost, "reset"},
                                    {gpu::Fault::fence_lost, "has not answered"}}) {
    const auto gl = gpu::make_gl_short_rays(gl_device(fault), {.hits = 37});  // in pieces
    for (int k = 0; k < 2; ++k) {  // not only the first time
      try {
        find(*gl, field, points);
        ADD_FAILURE() << text;
      } catch (const calc::BackendFailure& failure) {
        EXPECT_THAT(failure.what(), HasSubstr(text));
      }
    }
  }
}

// Numbers of hits of the cast before lie where those that do not come should be.
TEST_F(GlHits, TakeNoEarlierHits) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6);
  const NearScene field(hall.scene, 64);
  const NearPoints points = points_in_hall(30, 32);
  const auto gl = gl_short_rays(gpu::Fault::results_lost);
  EXPECT_GT(sum_of(find(*gl, field, points).lx), 0.0);
  EXPECT_THROW(find(*gl, field, points), calc::BackendFailure);
}

// A driver that leaves long loops early, as some llvmpipe does, must not look like a free
// view: the lamp's light passes by slivers one above the other.
TEST_F(GlHits, DoNotTakeALoopCutShortForAnAnswer) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = isotropic_web(1e6);
  calc::PreparedScene pile;
  add_quad(pile, {200, 200, 0}, {100, 0, 0}, {0, 100, 0}, 0.5);  // floor
  for (int k = 0; k < 70'000; ++k) {  // slivers along a diagonal: boxes are large, areas are not
    const double z = 3.0 + 1e-3 * k;
    add_triangle(pile, {-300, 300, z}, {300, -300, z}, {-300, 300.01, z}, 0.0);
  }
  add_luminaire(pile, web, {252, 251, 90});
  set_extent(pile);
  const NearScene field(pile, 16);
  const NearPoints points({{{250, 250, 0.2}, {0, 0, -1}, ReceiverKernel::planar}}, 64);
  const auto gl = caster();
  try {
    const ShortRayLight found = find(*gl, field, points);
    EXPECT_FALSE(leaves_long_loops(device()->device()).value_or(false));
    const Sums cpu = sums_of(field.near(), points, nullptr),
               own = sums_of(field.near(), points, &found);
    EXPECT_GT(sum_of(found.lx), 0.0);
    EXPECT_NEAR(own.lx[0] / cpu.lx[0], 1.0, 0.01);
  } catch (const calc::BackendFailure& failure) {
    EXPECT_TRUE(leaves_long_loops(device()->device()).value_or(true));
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
  }
}

// The same where light is found: a bound is a loop over all luminaires.
TEST_F(GlHits, DoNotTakeABoundCutShortForDarkness) {
  LUXGATE_NEEDS_OPENGL();
  const calc::PhotometricWeb web = isotropic_web(10.0);
  calc::PreparedScene scene;
  scene.channels = {{"a", 1.0}};
  add_box(scene, {0, 0, 0}, {20, 20, 3}, 0.5);
  for (int k = 0; k < 70'000; ++k) {
    add_luminaire(scene, web, {0.2 + 0.06 * (k % 320), 0.2 + 0.08 * (k / 320), 2.5});
  }
  set_extent(scene);
  const NearScene field(scene, 16);
  const NearPoints points({{{5.0, 5.0, 0.1}, {0, 0, -1}, ReceiverKernel::planar},
                           {{9.0, 8.0, 0.1}, {0, 0, -1}, ReceiverKernel::planar}},
                          64);
  try {
    const ShortRayLight found = find(*caster(), field, points);
    EXPECT_FALSE(leaves_long_loops(device()->device()).value_or(false));
    expect_same_sums(sums_of(field.near(), points, nullptr), sums_of(field.near(), points, &found),
                     0.0);
  } catch (const calc::BackendFailure& failure) {
    EXPECT_TRUE(leaves_long_loops(device()->device()).value_or(true));
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
  }
}

TEST_F(GlHits, PastTheDeadlineThereIsNothing) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.6);
  NearScene field(hall.scene, 64);
  field.deadline_s = 1e-9;
  const ShortRayLight found = find(*caster(), field, points_in_hall(30, 32));
  EXPECT_EQ(found.points(), 30u);
  EXPECT_EQ(sum_of(found.lx), 0.0);
  EXPECT_TRUE(found.left.empty());
}

}  // namespace
}  // namespace gpu_hits_test
