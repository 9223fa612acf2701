#include "calc/photometry/web_sampling.h"

#include "tests/support/photometry_samples.h"
#include "tests/support/web_inversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace calc::web_sampling_test {
namespace {

using test_support::angle_steps;
using test_support::make_web;

std::vector<std::pair<std::string, PhotometricWeb>> webs() {
  std::vector<std::pair<std::string, PhotometricWeb>> list;
  list.emplace_back("isotropic, two angles",
                    make_web({0}, {0, 180}, [](double, double) { return 1.0; }));
  list.emplace_back("axial spot",
                    make_web({0}, angle_steps(0, 20, 0.25), test_support::narrow_spot));
  list.emplace_back("spot with planes", make_web(angle_steps(0, 360, 30), angle_steps(0, 90, 0.5),
                                                 test_support::narrow_spot));
  list.emplace_back("wall washer", make_web(angle_steps(0, 360, 15), angle_steps(0, 180, 5),
                                            test_support::wall_washer));
  list.emplace_back(
      "batwing", make_web(angle_steps(0, 360, 10), angle_steps(0, 90, 2.5), test_support::batwing));
  list.emplace_back("uplight", make_web({0, 90, 200, 360}, {90, 100, 150, 180},
                                        [](double c, double gamma) { return c + gamma; }));
  return list;
}

// Random numbers without std::uniform_real_distribution, whose values differ between libraries.
class Uniform {
 public:
  double operator()() { return static_cast<double>(generator_() >> 11U) * 0x1p-53; }

 private:
  std::mt19937_64 generator_{20260101};
};

TEST(WebSampler, NumbersComeBackFromTheirDirections) {
  for (const auto& [name, web] : webs()) {
    const WebSampler sampler(web);
    const WebInversion inverted(sampler);
    Uniform uniform;
    for (int i = 0; i < 5000; ++i) {
      const double u0 = uniform();
      const double u1 = uniform();
      const std::array<double, 3> direction = sampler.sample(u0, u1);
      const std::array<double, 2> back = inverted(direction);
      EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1.0, 1e-14);
      ASSERT_NEAR(back[0], u0, 1e-10) << name;
      ASSERT_NEAR(back[1], u1, 1e-10) << name;
    }
  }
}

TEST(WebSampler, SumsEndAtTheFlux) {
  for (const auto& [name, web] : webs()) {
    EXPECT_NEAR(WebSampler(web).c_prefix().back() / web.flux_lm(), 1.0, 1e-12) << name;
  }
}

TEST(WebSampler, NoSampleIsDark) {
  for (const auto& [name, web] : webs()) {
    const WebSampler sampler(web);
    Uniform uniform;
    for (int i = 0; i < 2000; ++i) {
      const std::array<double, 3> direction = sampler.sample(uniform(), uniform());
      EXPECT_GT(web.intensity_cd(direction), 0.0) << name;
    }
  }
}

// Integral of the density over a cell between table angles, by products of Gauss-Legendre rules
// (4 points in gamma on 4 pieces, 2 in C, where it is linear): independent of the sampler's sums.
double cell_probability(const PhotometricWeb& web, double c0, double c1, double gamma0,
                        double gamma1) {
  constexpr double kNode[4] = {-0.86113631159405257522, -0.33998104358485626480,
                               0.33998104358485626480, 0.86113631159405257522};
  constexpr double kWeight[4] = {0.34785484513745385737, 0.65214515486254614263,
                                 0.65214515486254614263, 0.34785484513745385737};
  constexpr int kPieces = 4;
  double sum = 0.0;
  const double half_c = 0.5 * (c1 - c0);
  const double half_gamma = 0.5 * (gamma1 - gamma0) / kPieces;
  for (const double sign : {-1.0, 1.0}) {
    const double c = c0 + half_c * (1.0 + sign / std::sqrt(3.0));
    for (int piece = 0; piece < kPieces; ++piece) {
      for (int k = 0; k < 4; ++k) {
        const double gamma = gamma0 + half_gamma * (2.0 * piece + 1.0 + kNode[k]);
        const std::array<double, 3> direction{std::sin(gamma) * std::cos(c),
                                              std::sin(gamma) * std::sin(c), -std::cos(gamma)};
        sum += kWeight[k] * half_gamma * half_c * std::sin(gamma) * web.intensity_cd(direction);
      }
    }
  }
  return sum / web.flux_lm();
}

// Each interval cut into `parts`, so that the distribution inside of the table's intervals is seen
// too.
std::vector<double> subdivided(const std::vector<double>& nodes, int parts) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    for (int k = 0; k < parts; ++k) {
      result.push_back(nodes[i] + (nodes[i + 1] - nodes[i]) * k / parts);
    }
  }
  result.push_back(nodes.back());
  return result;
}

// Probability of each cell, [C interval][gamma interval].
struct Cells {
  std::vector<double> c, gamma, probability;
};

Cells cells_of(const PhotometricWeb& web) {
  Cells cells;
  cells.c = web.is_axial() ? subdivided({0.0, 2.0 * kPi}, 8) : subdivided(web.c_rad(), 2);
  cells.gamma = subdivided(web.gamma_rad(), 3);
  for (std::size_t i = 0; i + 1 < cells.c.size(); ++i) {
    for (std::size_t j = 0; j + 1 < cells.gamma.size(); ++j) {
      cells.probability.push_back(
          cell_probability(web, cells.c[i], cells.c[i + 1], cells.gamma[j], cells.gamma[j + 1]));
    }
  }
  return cells;
}

TEST(WebCells, HoldAllLight) {
  for (const auto& [name, web] : webs()) {
    double sum = 0.0;
    for (const double p : cells_of(web).probability) sum += p;
    EXPECT_NEAR(sum, 1.0, 1e-9) << name;
  }
}

// Upper limit of chi-square at significance 1e-4 by Wilson and Hilferty's cube-root rule.
double chi_square_limit(double degrees) {
  const double z = 3.719;
  const double spread = 2.0 / (9.0 * degrees);
  return degrees * std::pow(1.0 - spread + z * std::sqrt(spread), 3);
}

// Six tests at significance 1e-4 each, seed fixed: the chance that a right sampler fails is 6e-4,
// once.
TEST(WebSampler, SamplesFillTheCellsAsTheirDensitySays) {
  constexpr int kSamples = 200'000;
  for (const auto& [name, web] : webs()) {
    const WebSampler sampler(web);
    const Cells cells = cells_of(web);
    std::vector<int> hits(cells.probability.size(), 0);
    Uniform uniform;
    for (int i = 0; i < kSamples; ++i) {
      const double u0 = uniform();
      const WebAngles angles = angles_of(sampler.sample(u0, uniform()));
      const std::size_t row = interval_of(cells.c, angles.c_rad);
      ++hits[row * (cells.gamma.size() - 1) + interval_of(cells.gamma, angles.gamma_rad)];
    }
    double chi_square = 0.0;
    double pooled_expected = 0.0;  // cells of fewer than 5 expected hits go together
    double pooled_hits = 0.0;
    int used = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const double expected = kSamples * cells.probability[i];
      if (expected < 5.0) {
        pooled_expected += expected;
        pooled_hits += hits[i];
        continue;
      }
      chi_square += (hits[i] - expected) * (hits[i] - expected) / expected;
      ++used;
    }
    if (pooled_expected >= 5.0) {
      chi_square +=
          (pooled_hits - pooled_expected) * (pooled_hits - pooled_expected) / pooled_expected;
      ++used;
    } else {
      EXPECT_LE(pooled_hits, 30.0) << name;
    }
    ASSERT_GT(used, 10) << name;
    EXPECT_LT(chi_square, chi_square_limit(used - 1.0)) << name;
  }
}

TEST(WebSampler, EndsOfTheUnitSquareStayInsideTheTable) {
  const double last = std::nextafter(1.0, 0.0);
  for (const auto& [name, web] : webs()) {
    const WebSampler sampler(web);
    for (const double u0 : {0.0, 1e-300, 0.5, last}) {
      for (const double u1 : {0.0, 1e-300, 0.5, last}) {
        const std::array<double, 3> direction = sampler.sample(u0, u1);
        const WebAngles angles = angles_of(direction);
        EXPECT_TRUE(std::isfinite(angles.gamma_rad) && std::isfinite(angles.c_rad)) << name;
        EXPECT_GE(angles.gamma_rad, web.gamma_rad().front() - 1e-14) << name;
        EXPECT_LE(angles.gamma_rad, web.gamma_rad().back() + 1e-14) << name;
      }
    }
  }
}

TEST(WebSampler, DarkAnglesAndPlanesAreNeverChosen) {
  // Light between gamma 40 and 60 only (with its flanks 30 to 70), and between C 90 and 180 (60 to
  // 210).
  const auto cd = [](double c, double gamma) {
    return c >= 90 && c <= 180 && gamma >= 40 && gamma <= 60 ? 50.0 : 0.0;
  };
  const PhotometricWeb web = make_web(angle_steps(0, 360, 30), angle_steps(0, 180, 10), cd);
  const WebSampler sampler(web);
  for (const double u0 : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    for (const double u1 : {0.0, 0.2, 0.5, 0.8, 1.0}) {
      const WebAngles angles = angles_of(sampler.sample(u0, u1));
      EXPECT_GE(degrees_from_radians(angles.gamma_rad), 30.0 - 1e-9);
      EXPECT_LE(degrees_from_radians(angles.gamma_rad), 70.0 + 1e-9);
      EXPECT_GE(degrees_from_radians(angles.c_rad), 60.0 - 1e-9);
      EXPECT_LE(degrees_from_radians(angles.c_rad), 210.0 + 1e-9);
    }
  }
}

TEST(WebInversion, OutsideTheTableGivesItsEnds) {
  const PhotometricWeb web = make_web({0}, {30, 60}, [](double, double) { return 1.0; });
  const WebSampler sampler(web);
  EXPECT_EQ(WebInversion(sampler)({0, 0, -1})[1], 0.0);
  EXPECT_EQ(WebInversion(sampler)({0, 0, 1})[1], 1.0);
}

}  // namespace
}  // namespace calc::web_sampling_test
