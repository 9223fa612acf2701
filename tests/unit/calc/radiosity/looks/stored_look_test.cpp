#include "calc/radiosity/looks/stored_look.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

namespace stored_look_test {
namespace {

constexpr std::size_t kPoints = 5, kReplicates = 4;

calc::SensorGrid grid_of(std::size_t points) {
  calc::SensorGrid grid;
  grid.position_m.resize(points);
  grid.normal.assign(points, {0, 0, 1});
  return grid;
}

calc::PlaneState empty_plane() {
  return {"plane", grid_of(kPoints), {{"a", 1.0}, {"b", 0.5}}, kReplicates};
}

template <class Number>
void fill(std::vector<Number>& list, std::size_t count) {
  list.resize(count);
  for (std::size_t k = 0; k < count; ++k) list[k] = static_cast<Number>(k + 1);
}

calc::PlaneState full_plane() {
  calc::PlaneState plane = empty_plane();
  calc::PlaneSums& sums = plane.sums();
  sums.most_rounds = 2;
  fill(sums.rounds, kPoints);
  fill(sums.largest_opening_lx, kPoints);
  fill(sums.direct_sum_lx, plane.values());
  sums.direct_sum_lx[3] = -1.0;
  sums.has_hidden_opening = {0, 1, 0, 1, 0};
  sums.has_seen_opening = {1, 1, 0, 0, 0};
  sums.may_be_sampled = {1, 1, 1, 0, 0};
  fill(sums.paths, kPoints);
  fill(sums.indirect_sum_lx, plane.values());
  fill(sums.largest_sum_lx, kReplicates * kPoints);
  fill(sums.possible_sample_lx, kPoints);
  fill(sums.short_ray_factor, kPoints);
  fill(sums.clear_m, kPoints);
  fill(sums.connection_rays, kReplicates);
  fill(sums.near_rays, kReplicates);
  calc::PlaneField& field = plane.field();
  fill(field.direct_exact_lx, 2 * kPoints);
  fill(field.glare.value, 2 * kPoints);
  fill(field.glare.low, 2 * kPoints);
  fill(field.glare.high, 2 * kPoints);
  field.glare.doubts = {{1, 1, calc::GlareProblem::too_large, 0.2, {1.0, 2.0, 3.0}}};
  field.counters.paths = 100;
  field.counters.direct_rays = 7;
  field.counters.connection_rays = 10;
  field.counters.near_rays = 10;
  return plane;
}

calc::LookLight light() {
  calc::LookLight light;
  light.emitted_lm = 1000.0;
  light.untraced_lm = 10.0;
  light.has_paths = true;
  fill(light.absorbed_lm, kReplicates);
  fill(light.escaped_lm, kReplicates);
  light.pool_rays = 99;
  return light;
}

TEST(StoredLook, GivesThePlaneBack) {
  const calc::PlaneState plane = full_plane();
  const std::string bytes = calc::render_look(plane, false, light());
  EXPECT_LE(bytes.size(), calc::most_look_bytes(plane));
  calc::PlaneState other = empty_plane();
  auto look = calc::parse_look(bytes, other);
  ASSERT_TRUE(look);
  EXPECT_FALSE(look->is_exact);
  EXPECT_EQ(look->light.absorbed_lm, light().absorbed_lm);
  EXPECT_EQ(look->light.pool_rays, 99u);
  calc::restore(*std::move(look), other);
  EXPECT_EQ(other.sums().direct_sum_lx, plane.sums().direct_sum_lx);
  EXPECT_EQ(other.sums().indirect_sum_lx, plane.sums().indirect_sum_lx);
  EXPECT_EQ(other.sums().has_seen_opening, plane.sums().has_seen_opening);
  EXPECT_EQ(other.field().glare.doubts.at(0).number, 0.2);
  EXPECT_EQ(other.field().counters.near_rays, 10u);
  // What is stored again is the same.
  EXPECT_EQ(calc::render_look(other, false, light()), bytes);
}

TEST(StoredLook, IsOfAPlaneOfItsSizeOnly) {
  const std::string bytes = calc::render_look(full_plane(), false, light());
  const std::vector<calc::LightChannel> channels(2);
  EXPECT_FALSE(calc::parse_look(bytes, {"plane", grid_of(kPoints + 1), channels, kReplicates}));
  EXPECT_FALSE(calc::parse_look(bytes, {"plane", grid_of(kPoints), channels, kReplicates + 1}));
  EXPECT_FALSE(calc::parse_look(
      bytes, {"plane", grid_of(kPoints), std::vector<calc::LightChannel>(3), kReplicates}));
}

TEST(StoredLook, EveryLengthButItsOwnIsRefused) {
  const std::string bytes = calc::render_look(full_plane(), false, light());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(calc::parse_look(std::string_view(bytes).substr(0, length), empty_plane()));
  }
  EXPECT_FALSE(calc::parse_look(bytes + '\0', empty_plane()));
}

TEST(StoredLook, HugeCountsTakeNoMemory) {
  const std::string bytes = calc::render_look(full_plane(), false, light());
  const std::uint64_t huge = std::numeric_limits<std::uint64_t>::max() / 16;
  // Points, channels, replicates, refusals.
  for (const std::size_t at : {8u, 16u, 24u, 88u}) {
    for (const std::uint64_t count : {huge, std::uint64_t{1} << 40, std::uint64_t{1000}}) {
      std::string changed = bytes;
      std::memcpy(changed.data() + at, &count, sizeof count);
      EXPECT_FALSE(calc::parse_look(changed, empty_plane())) << at;
    }
  }
}

// Whoever writes a checksum can write any bytes: they must not lead out of bounds.
TEST(StoredLook, AnyBytesAreRefusedOrFit) {
  const std::string bytes = calc::render_look(full_plane(), false, light());
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    std::string changed = bytes;
    for (int k = 0; k < 3; ++k) {
      const std::size_t most = round % 2 == 0 ? changed.size() : 96;
      changed[random() % most] = static_cast<char>(random());
    }
    calc::PlaneState plane = empty_plane();
    auto look = calc::parse_look(changed, plane);
    if (!look) continue;
    calc::restore(*std::move(look), plane);
    plane.publish(3);
    for (const double lx : plane.field().indirect_lx) EXPECT_TRUE(std::isfinite(lx));
  }
}

TEST(StoredLook, NumbersThatAreNoneAreRefused) {
  calc::PlaneState plane = full_plane();
  plane.sums().indirect_sum_lx[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(calc::parse_look(calc::render_look(plane, false, light()), plane));
  plane = full_plane();
  plane.field().direct_exact_lx[1] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(calc::parse_look(calc::render_look(plane, false, light()), plane));
  plane = full_plane();
  plane.sums().paths[2] = 0;  // would be divided by
  EXPECT_FALSE(calc::parse_look(calc::render_look(plane, false, light()), plane));
}

}  // namespace
}  // namespace stored_look_test
