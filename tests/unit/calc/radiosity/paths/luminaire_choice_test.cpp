// One luminaire for all: probabilities that add up, and a mean that is the sum over all.
#include "calc/radiosity/paths/luminaire_choice.h"
#include "calc/base/statistics.h"
#include "calc/radiosity/direct/direct.h"
#include "tests/support/lamp_shop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace luminaire_choice_test {
namespace {

using namespace test_support;
using calc::RandomKey;

constexpr int kDraws = 20000;

TEST(LuminaireChoice, IsAsOftenAsItSays) {
  const LampHall hall;
  const calc::LuminaireChoice choice(hall.scene);
  std::map<std::size_t, int> times;
  std::map<std::size_t, double> probability;
  for (int i = 0; i < kDraws; ++i) {
    const auto chosen = choice.choose({0.5, 1.0, 0.0}, {0, 0, 1}, (i + 0.5) / kDraws);
    ASSERT_TRUE(chosen);
    ++times[chosen->luminaire];
    probability[chosen->luminaire] = chosen->probability;
  }
  double sum = 0.0;
  for (const auto& [luminaire, p] : probability) {
    EXPECT_NEAR(times[luminaire] / static_cast<double>(kDraws), p, 2.0 / kDraws) << luminaire;
    sum += p;
  }
  EXPECT_NEAR(sum, 1.0, 1e-6);
}

// Each channel, over many draws, against the mean of samples of all luminaires.
void expect_same_mean(const calc::PreparedScene& scene, const glm::dvec3& at_m,
                      const glm::dvec3& normal) {
  const calc::Tracer tracer(scene);
  const calc::LuminaireChoice choice(scene);
  const std::size_t channels = scene.channels.size();
  std::vector<std::vector<double>> one(channels), all(channels);
  for (std::uint64_t i = 0; i < kDraws; ++i) {
    std::vector<double> sum(channels, 0.0);
    const RandomKey key = RandomKey(11).with(i);
    const auto chosen = choice.choose(at_m, normal, key.with(7).uniform());
    if (chosen) {
      calc::add_direct_sample_of(tracer, chosen->luminaire, {at_m, normal}, key,
                                 1.0 / chosen->probability, sum.data(), 1);
    }
    for (std::size_t c = 0; c < channels; ++c) one[c].push_back(sum[c]);
    std::fill(sum.begin(), sum.end(), 0.0);
    calc::add_direct_sample(tracer, {at_m, normal}, RandomKey(12).with(i), 1.0, sum.data(), 1);
    for (std::size_t c = 0; c < channels; ++c) all[c].push_back(sum[c]);
  }
  for (std::size_t c = 0; c < channels; ++c) {
    const calc::ReplicateMean a = calc::replicate_mean(one[c]), b = calc::replicate_mean(all[c]);
    EXPECT_LT(std::abs(a.mean - b.mean),
              4.0 * std::hypot(a.standard_error, b.standard_error) + 1e-9 * b.mean)
        << c << ": " << a.mean << " and " << b.mean;
    // Few samples carry the mean of one in a thousand, or the choice is a bad one.
    EXPECT_LT(a.standard_error * std::sqrt(kDraws), 12.0 * b.mean) << c;
  }
}

TEST(LuminaireChoice, HasTheMeanOfAll) {
  const LampHall hall;
  expect_same_mean(hall.scene, {0.5, 1.0, 0.0}, {0, 0, 1});
  expect_same_mean(hall.scene, {-4.0, 0.3, 1.7}, {1, 0, 0});
  expect_same_mean(hall.scene, {2.0, -1.5, 3.5}, {0, 0, -1});  // the ceiling above a lamp
}

// Openings that are far larger than their distance, among small ones: a sample anywhere on them
// would nearly always be far away, and rarely bring all the light.
TEST(LuminaireChoice, OfALongOpeningNearPartsAreDrawn) {
  using calc::OpeningShape;
  const calc::PhotometricWeb small = lambert_web(10.0, 18);
  const std::vector<calc::LuminousOpening> openings{
      {OpeningShape::rectangle, 50.0, 0.05, 0.0},
      {OpeningShape::rectangle, 1000.0, 1.0, 0.0},
      {OpeningShape::rectangle, 40.0, 40.0, 0.0},
      {OpeningShape::box, 30.0, 0.1, 0.1},
  };
  for (const calc::LuminousOpening& opening : openings) {
    SCOPED_TRACE(opening.along_c0_m);
    const calc::PhotometricWeb large = lambert_web(1000.0, 18, opening);
    calc::PreparedScene scene;
    add_luminaire(scene, large, {0, 0, 3});
    for (int k = 0; k < 4; ++k) add_luminaire(scene, small, {0.5 * k, 1, 2.5});
    add_quad(scene, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0.5);
    set_extent(scene);
    const calc::Tracer tracer(scene);
    const calc::LuminaireChoice choice(scene);
    for (const calc::Receiver& at :
         {calc::Receiver{{3, 0.3, 2.7}, {0, 0, 1}}, calc::Receiver{{1, 0.1, 0.5}, {0, 0, 1}},
          calc::Receiver{{-2, 0.4, 2.9}, {0, -0.6, 0.8}}}) {
      double truth_lx = 0.0;
      calc::add_point_sources(tracer, at, {}, &truth_lx, 1);
      constexpr std::uint32_t kRounds = 256;
      double of_large_lx = 0.0;
      calc::add_extended_sources(tracer, at, {}, RandomKey(5), 0, kRounds, &of_large_lx, 1);
      truth_lx += of_large_lx / kRounds;
      std::vector<double> drawn;
      for (std::uint64_t i = 0; i < kDraws; ++i) {
        double sum = 0.0;
        const RandomKey key = RandomKey(13).with(i);
        const auto chosen = choice.choose(at.position_m, at.axis, key.with(7).uniform());
        if (chosen) {
          calc::add_direct_sample_of(tracer, chosen->luminaire, at, key, 1.0 / chosen->probability,
                                     &sum, 1);
        }
        drawn.push_back(sum);
      }
      const calc::ReplicateMean mean = calc::replicate_mean(drawn);
      EXPECT_NEAR(mean.mean, truth_lx, 4.0 * mean.standard_error);
      EXPECT_LT(mean.standard_error * std::sqrt(kDraws), 2.5 * truth_lx) << at.position_m.z;
      EXPECT_LT(*std::max_element(drawn.begin(), drawn.end()), 30.0 * truth_lx);
    }
  }
}

TEST(LuminaireChoice, AWeakChannelIsAskedAsWell) {
  const calc::PhotometricWeb web = lambert_web(1000.0, 18);
  calc::PreparedScene scene;
  scene.channels = {{"strong", 1.0}, {"weak", 1.0}};
  for (int k = 0; k < 20; ++k) add_luminaire(scene, web, {0.4 * k, 0, 2});
  scene.luminaires[7].channel = 1;
  scene.luminaires[7].flux_scale = 1e-6;
  set_extent(scene);
  expect_same_mean(scene, {3, 0, 0}, {0, 0, 1});
}

TEST(LuminaireChoice, NoneWhereAllAreBehind) {
  const calc::PhotometricWeb web = lambert_web(1000.0, 18);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 2});
  add_luminaire(scene, web, {1, 0, 2});
  set_extent(scene);
  const calc::LuminaireChoice choice(scene);
  EXPECT_FALSE(choice.choose({0, 0, 0}, {0, 0, -1}, 0.5));
  EXPECT_FALSE(choice.choose({0, 0, 3}, {0, 0, 1}, 0.5));
  EXPECT_TRUE(choice.choose({0, 0, 0}, {0, 0, 1}, 0.5));
}

}  // namespace
}  // namespace luminaire_choice_test
