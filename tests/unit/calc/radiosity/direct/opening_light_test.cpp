// Direct light by what is proved of openings, against sampling all of them with shadow rays.
#include "calc/radiosity/direct/opening_light.h"
#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace opening_light_test {
namespace {

using namespace test_support;
using calc::OpeningShape;
using calc::RandomKey;

struct Room {
  std::vector<std::unique_ptr<calc::PhotometricWeb>> webs;
  calc::PreparedScene scene;

  void add(calc::PhotometricWeb web, const glm::dvec3& at_m, std::uint32_t channel = 0) {
    webs.push_back(std::make_unique<calc::PhotometricWeb>(std::move(web)));
    add_luminaire(scene, *webs.back(), at_m);
    scene.luminaires.back().channel = channel;
  }
};

// Panels, a disk, a table that is coarse, and things that stand in the way.
Room office() {
  Room room;
  add_box(room.scene, {0, 0, 0}, {6, 4, 2.8}, 0.5);
  add_box(room.scene, {2, 1, 0.7}, {1.6, 0.8, 0.05}, 0.4);
  add_box(room.scene, {4, 2.5, 0}, {0.5, 1.0, 1.6}, 0.3);
  room.scene.channels = {{"a", 1.0}, {"b", 1.0}};
  const calc::LuminousOpening panel{OpeningShape::rectangle, 1.2, 0.3, 0.0};
  const calc::LuminousOpening disk{OpeningShape::disk, 0.4, 0.2, 0.0};
  for (int k = 0; k < 6; ++k) {
    room.add(lambert_web(1000, 9, panel), {1.0 + 2.0 * (k % 3), k < 3 ? 1.0 : 3.0, 2.8},
             k % 2 == 0 ? 0u : 1u);
  }
  room.add(crooked_web(disk), {3, 2, 2.7}, 1u);
  room.add(crooked_web({OpeningShape::rectangle, 0.5, 0.5, 0.0}), {1.5, 3.2, 2.0});
  room.add(crooked_web({OpeningShape::box, 0.3, 0.2, 0.1}), {5, 1, 2.0});
  set_extent(room.scene);
  return room;
}

struct Sums {
  std::vector<double> known, sampled;  // [channel], [replicate][channel]
  std::uint64_t rays = 0;
};

Sums by_proof(const calc::Tracer& tracer, const calc::Receiver& receiver, std::uint64_t seed,
              std::size_t replicates, std::uint32_t rounds = 1, double error_factor = 1.0) {
  const std::size_t channels = tracer.scene().channels.size();
  Sums sums{std::vector<double>(channels), std::vector<double>(channels * replicates)};
  float largest = 0.0f;
  sums.rays = calc::add_openings(tracer, receiver, {}, RandomKey(seed),
                                 {0, rounds, replicates, error_factor},
                                 {sums.known.data(), sums.sampled.data(), 1, channels, &largest})
                  .traced;
  for (double& lx : sums.sampled) lx /= rounds;
  return sums;
}

std::vector<double> replicate_totals(const Sums& sums, std::size_t channel) {
  std::vector<double> totals;
  for (std::size_t k = channel; k < sums.sampled.size(); k += sums.known.size()) {
    totals.push_back(sums.known[channel] + sums.sampled[k]);
  }
  return totals;
}

// [channel][replicate]
std::vector<std::vector<double>> by_rays(const calc::Tracer& tracer, const calc::Receiver& receiver,
                                         std::size_t replicates) {
  const std::size_t channels = tracer.scene().channels.size();
  std::vector<std::vector<double>> totals(channels);
  for (std::size_t r = 0; r < replicates; ++r) {
    std::vector<double> sum(channels);
    calc::add_extended_sources(tracer, receiver, {}, RandomKey(77).with(r), 0, 16, sum.data(), 1);
    for (std::size_t c = 0; c < channels; ++c) totals[c].push_back(sum[c] / 16.0);
  }
  return totals;
}

std::vector<calc::Receiver> places() {
  using Kernel = calc::ReceiverKernel;
  const glm::dvec3 up(0, 0, 1);
  std::vector<calc::Receiver> all;
  for (int k = 0; k < 24; ++k) {
    const RandomKey key = RandomKey(5).with(static_cast<std::uint64_t>(k));
    all.push_back({{0.2 + 5.6 * key.with(0).uniform(), 0.2 + 3.6 * key.with(1).uniform(), 0.8},
                   up,
                   Kernel::planar});
  }
  all.push_back({{2.8, 1.4, 0.5}, up, Kernel::planar});          // under the table
  all.push_back({{4.51, 3.0, 0.3}, {1, 0, 0}, Kernel::planar});  // at the cupboard's side
  all.push_back({{1, 1, 2.75}, up, Kernel::planar});             // 50 mm below a panel
  all.push_back({{1.5, 3.2, 1.9}, up, Kernel::planar});          // 0.1 m below a crooked one
  all.push_back({{3, 2, 1.2}, up, Kernel::cylindrical});
  all.push_back({{4.2, 2.2, 1.2}, {0, 1, 0}, Kernel::semicylindrical});
  all.push_back({{0.4, 0.4, 1.6}, up, Kernel::scalar});
  return all;
}

void expect_mean_of_all_rays(double error_factor) {
  const Room room = office();
  const calc::Tracer tracer(room.scene);
  constexpr std::size_t kReplicates = 64;
  double worst = 0.0, sum_square = 0.0;
  int count = 0;
  std::size_t place = 0;
  for (const calc::Receiver& receiver : places()) {
    const Sums sums = by_proof(tracer, receiver, 1000 + place++, kReplicates, 1, error_factor);
    const auto all_rays = by_rays(tracer, receiver, kReplicates);
    for (std::size_t channel = 0; channel < 2; ++channel) {
      const auto ours = calc::replicate_mean(replicate_totals(sums, channel));
      const auto rays = calc::replicate_mean(all_rays[channel]);
      const double error = std::hypot(ours.standard_error, rays.standard_error);
      if (!(error > 0.0)) {
        EXPECT_EQ(ours.mean, rays.mean);
        continue;
      }
      const double z = (ours.mean - rays.mean) / error;
      worst = std::max(worst, std::abs(z));
      sum_square += z * z;
      ++count;
      EXPECT_LT(std::abs(z), 4.5) << "place " << place - 1 << ", channel " << channel << ": "
                                  << ours.mean << " and " << rays.mean;
    }
  }
  // A mean square of 1; its standard deviation is sqrt(2 / count).
  EXPECT_NEAR(sum_square / count, 1.0, 4.0 * std::sqrt(2.0 / count));
}

TEST(OpeningLight, HasTheMeanOfAllRays) { expect_mean_of_all_rays(1.0); }

TEST(OpeningLight, WithFewerSamplesHasTheMeanOfAllRaysToo) {
  expect_mean_of_all_rays(4.0);
  const Room room = office();
  const calc::Tracer tracer(room.scene);
  std::uint64_t usual = 0, few = 0;
  for (const calc::Receiver& receiver : places()) {
    usual += by_proof(tracer, receiver, 1, 4).rays;
    few += by_proof(tracer, receiver, 1, 4, 1, 4.0).rays;
  }
  EXPECT_LT(2 * few, usual);  // 4^(2/3) times as few
}

TEST(OpeningLight, OfFreeOpeningsIsKnownButForALittle) {
  Room room;
  room.scene.channels = {{"", 1.0}};
  const calc::LuminousOpening panel{OpeningShape::rectangle, 1.2, 0.3, 0.0};
  for (int k = 0; k < 15; ++k) {
    room.add(lambert_web(1000, 18, panel), {0.6 + 1.6 * (k % 5), 0.8 + 1.6 * (k / 5), 2.8});
  }
  add_quad(room.scene, {0, 0, 0}, {8, 0, 0}, {0, 5, 0}, 0.5);
  set_extent(room.scene);
  const calc::Tracer tracer(room.scene);
  double worst = 0.0;
  for (int k = 0; k < 40; ++k) {
    const calc::Receiver receiver{{0.3 + 0.19 * k, 0.4 + 0.1 * k, 0.8}, {0, 0, 1}};
    const Sums sums = by_proof(tracer, receiver, static_cast<std::uint64_t>(k), 16);
    const auto mean = calc::replicate_mean(replicate_totals(sums, 0));
    worst = std::max(worst, mean.standard_error / mean.mean);
  }
  std::printf("worst standard error %.5f %%\n", 100.0 * worst);
  EXPECT_LT(worst, 1e-3);
}

// A hall: most openings are known by their middle and by pairs of samples opposite to each other.
TEST(OpeningLight, OfFarOpeningsIsKnownAsWell) {
  Room room;
  room.scene.channels = {{"", 1.0}};
  const calc::LuminousOpening panel{OpeningShape::rectangle, 1.2, 0.3, 0.0};
  for (int k = 0; k < 48; ++k) {
    const glm::dvec3 at_m(4.0 + 8.0 * (k % 8), 4.0 + 8.0 * (k / 8), 12.5);
    if (k % 2 == 0) {
      room.add(lambert_web(1000, 18, panel), at_m);
    } else {
      room.add(crooked_web(panel), at_m);
    }
  }
  add_quad(room.scene, {0, 0, 0}, {64, 0, 0}, {0, 48, 0}, 0.5);
  set_extent(room.scene);
  const calc::Tracer tracer(room.scene);
  double worst = 0.0, sum_square = 0.0;
  constexpr int kPlaces = 30;
  for (int k = 0; k < kPlaces; ++k) {
    const calc::Receiver receiver{{1.0 + 2.1 * k, 2.0 + 1.4 * k, 0.8}, {0, 0, 1}};
    const auto seed = static_cast<std::uint64_t>(k);
    const auto few =
        calc::replicate_mean(replicate_totals(by_proof(tracer, receiver, seed, 16), 0));
    worst = std::max(worst, few.standard_error / few.mean);
    const auto ours =
        calc::replicate_mean(replicate_totals(by_proof(tracer, receiver, seed, 256), 0));
    const auto rays = calc::replicate_mean(by_rays(tracer, receiver, 256)[0]);
    const double z = (ours.mean - rays.mean) / std::hypot(ours.standard_error, rays.standard_error);
    EXPECT_LT(std::abs(z), 4.5) << "place " << k << ": " << ours.mean << " and " << rays.mean;
    sum_square += z * z;
  }
  std::printf("worst standard error %.5f %%\n", 100.0 * worst);
  // crooked_web() has beams of half a degree: more of them may be unseen.
  EXPECT_LT(worst, 1.2e-3);
  EXPECT_NEAR(sum_square / kPlaces, 1.0, 4.0 * std::sqrt(2.0 / kPlaces));
}

TEST(OpeningLight, MoreRoundsMakeTheErrorSmaller) {
  const Room room = office();
  const calc::Tracer tracer(room.scene);
  const calc::Receiver receiver{{3.3, 2.2, 0.8}, {0, 0, 1}};
  const auto error = [&](std::uint32_t rounds) {
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const double e =
          calc::replicate_mean(replicate_totals(by_proof(tracer, receiver, seed, 16, rounds), 0))
              .standard_error;
      sum += e * e;
    }
    return std::sqrt(sum);
  };
  EXPECT_LT(error(16), 0.35 * error(1));
}

// Every opening is hidden by the one table top: nothing is sampled, nothing is unseen.
// Half of the light at half the angle, nothing beyond it. steps: of the table.
calc::PhotometricWeb beam_web(double half_angle_deg, std::size_t steps,
                              const calc::LuminousOpening& opening) {
  const double end = calc::radians_from_degrees(half_angle_deg);
  std::vector<double> gamma, cd;
  for (std::size_t k = 0; k <= steps; ++k) {
    gamma.push_back(1.1 * end * static_cast<double>(k) / static_cast<double>(steps));
    cd.push_back(1000.0 * std::clamp(1.0 - 0.5 * gamma.back() / end, 0.5, 1.0));
  }
  cd.back() = 0.0;
  return calc::PhotometricWeb::make({0.0}, gamma, cd, opening, {});
}

// Wherever the beam that comes to a point has all of its outline on the opening, the light there is
// the beam's flux over the opening's area: dA = d^2 dw / cos.
TEST(OpeningLight, OfABeamNarrowerThanTheOpeningIsKnown) {
  for (const double half_angle_deg : {0.5, 1.0, 2.5, 5.0, 10.0}) {
    Room room;
    room.scene.channels = {{"a", 1.0}};
    room.add(beam_web(half_angle_deg, 40, {OpeningShape::rectangle, 1.0, 1.0, 0.0}), {0, 0, 1.5});
    set_extent(room.scene);
    const double truth_lx = room.webs[0]->flux_lm();  // on 1 m2
    const calc::Tracer tracer(room.scene);
    for (const glm::dvec3& at_m : {glm::dvec3(0, 0, 0), glm::dvec3(0.13, 0.07, 0.0),
                                   glm::dvec3(-0.2, 0.11, 0.3), glm::dvec3(0.1, -0.1, 1.2)}) {
      const calc::Receiver receiver{at_m, {0, 0, 1}, calc::ReceiverKernel::planar};
      const std::vector<double> totals = replicate_totals(by_proof(tracer, receiver, 3, 64, 1), 0);
      const calc::ReplicateMean mean = calc::replicate_mean(totals);
      EXPECT_NEAR(mean.mean, truth_lx, 4.5 * mean.standard_error)
          << half_angle_deg << ", " << at_m.x;
      EXPECT_LT(mean.standard_error, 0.015 * truth_lx) << half_angle_deg << ", " << at_m.x;
      EXPECT_LT(*std::max_element(totals.begin(), totals.end()), 2.0 * truth_lx);
    }
    // Beside the beams nothing comes, and no part is looked at.
    EXPECT_TRUE(calc::opening_cells(room.scene.luminaires[0], {3, 0, 0}).empty());
    EXPECT_TRUE(calc::has_fine_beams(room.scene, {}, std::vector<calc::Receiver>{{}}));
  }
}

TEST(OpeningLight, HiddenOpeningsNeedNoRays) {
  Room room;
  room.scene.channels = {{"", 1.0}};
  add_quad(room.scene, {-2, -2, 1}, {4, 0, 0}, {0, 4, 0}, 0.5);
  room.add(lambert_web(1000, 18, {OpeningShape::rectangle, 0.6, 0.6, 0.0}), {0, 0, 3});
  set_extent(room.scene);
  const calc::Tracer tracer(room.scene);
  double known = 0.0, sampled = 0.0;
  const calc::DirectRays rays = calc::add_openings(
      tracer, {{0, 0, 0.5}, {0, 0, 1}}, {}, RandomKey(1), {0, 1, 1}, {&known, &sampled, 1, 1});
  EXPECT_EQ(rays.traced, 0u);
  EXPECT_FALSE(rays.may_be_lit);
  EXPECT_EQ(known + sampled, 0.0);
}

}  // namespace
}  // namespace opening_light_test
