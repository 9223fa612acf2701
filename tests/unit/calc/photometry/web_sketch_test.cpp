#include "calc/photometry/web_sketch.h"

#include "tests/support/photometry_samples.h"
#include "tests/support/web_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace calc::web_sketch_test {
namespace {

using test_support::angle_steps;
using test_support::batwing;
using test_support::make_web;

struct Way {
  std::array<double, 3> to;  // unit vector, the luminaire's frame
  double length_m;
};

// All over the sphere, 1 mm to 100 km.
std::vector<Way> ways_all_over(std::size_t count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> z(-1.0, 1.0), c(0.0, 2.0 * kPi), decades(-3.0, 5.0);
  std::vector<Way> ways;
  for (std::size_t k = 0; k < count; ++k) {
    const double up = z(random), across = std::sqrt(1.0 - up * up), c_rad = c(random);
    ways.push_back({{across * std::cos(c_rad), across * std::sin(c_rad), up},
                    std::pow(10.0, decades(random))});
  }
  return ways;
}

std::vector<double> sketched_cd(const PhotometricWeb& web, const std::vector<Way>& ways) {
  SketchLanes lanes;
  for (const Way& way : ways) {
    const std::array<double, 3> in_table = web.to_table(way.to);
    lanes.add(web.sketch(), way.length_m * glm::dvec3(in_table[0], in_table[1], in_table[2]), 1.0);
  }
  evaluate(lanes);
  std::vector<double> cd;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    cd.push_back(static_cast<double>(lanes.lx[k]) * std::pow(ways[k].length_m, 3));
  }
  return cd;
}

// Of the largest intensity.
double largest_error(const PhotometricWeb& web, const std::vector<Way>& ways) {
  const std::vector<double> cd = sketched_cd(web, ways);
  double largest_cd = 0.0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    largest_cd = std::max(largest_cd, std::abs(cd[k] - web.intensity_cd(ways[k].to)));
  }
  return largest_cd / web.max_intensity_cd();
}

TEST(WebSketch, OfEvenAnglesIsTheWebItself) {
  const std::vector<Way> ways = ways_all_over(20'000);
  const PhotometricWeb webs[] = {
      make_web(angle_steps(0, 360, 15), angle_steps(0, 180, 10), batwing),
      make_web(angle_steps(0, 360, 5), angle_steps(0, 180, 0.5), test_support::wall_washer),
      make_web({0}, angle_steps(0, 180, 0.25), test_support::narrow_spot),
      make_web({0}, {0, 180}, [](double, double gamma_deg) { return 200.0 - gamma_deg; }),
      test_support::lateral_web([](double v, double h) { return 150.0 + v + 0.3 * h; }),
  };
  for (const PhotometricWeb& web : webs) {
    EXPECT_EQ(web.sketch().largest_error_share(), 1e-5);
    EXPECT_LT(largest_error(web, ways), 1e-5) << &web - webs;
  }
}

TEST(WebSketch, OfOtherAnglesSaysHowFarItIsOff) {
  const std::vector<Way> ways = ways_all_over(20'000);
  const PhotometricWeb webs[] = {
      make_web(angle_steps(0, 360, 15), {0, 10, 17, 31.5, 44, 60, 75, 80.3, 90}, batwing),
      make_web({0, 31, 100, 180, 360}, angle_steps(0, 180, 5), test_support::wall_washer),
      make_web({0}, angle_steps(0, 180, 0.1), test_support::narrow_spot),
  };
  for (const PhotometricWeb& web : webs) {
    EXPECT_GT(web.sketch().largest_error_share(), 1e-5) << &web - webs;
    EXPECT_LT(web.sketch().largest_error_share(), 0.03) << &web - webs;
    EXPECT_LE(largest_error(web, ways), web.sketch().largest_error_share()) << &web - webs;
  }
}

// A table may end while its light is bright; the sketch must not smear it over half a step.
TEST(WebSketch, EndsWhereTheTableEnds) {
  const PhotometricWeb web =
      make_web({0}, angle_steps(30, 90, 15), [](double, double) { return 100.0; });
  std::vector<Way> ways;
  for (const double gamma_deg : {29.99, 30.01, 89.99, 90.01}) {
    ways.push_back({direction_of({0.4, radians_from_degrees(gamma_deg)}), 2.0});
  }
  const std::vector<double> cd = sketched_cd(web, ways);
  EXPECT_EQ(cd[0], 0.0);
  EXPECT_NEAR(cd[1], 100.0, 1e-3);
  EXPECT_NEAR(cd[2], 100.0, 1e-3);
  EXPECT_EQ(cd[3], 0.0);
}

TEST(WebSketch, KnowsThePolesAndTheSeam) {
  const PhotometricWeb web = make_web(
      angle_steps(0, 360, 15), angle_steps(0, 180, 10), [](double c_deg, double gamma_deg) {
        return 300.0 + gamma_deg + (gamma_deg > 0 && gamma_deg < 180 ? c_deg : 0.0);
      });
  const std::vector<Way> ways = {{{0, 0, -1}, 3.0},         {{0, 0, 1}, 3.0},     {{1, 0, 0}, 3.0},
                                 {{1, 1e-9, 0}, 3.0},       {{1, -1e-9, 0}, 3.0}, {{-1, 0, 0}, 3.0},
                                 {{1e-12, -1e-12, -1}, 3.0}};
  const std::vector<double> cd = sketched_cd(web, ways);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    EXPECT_NEAR(cd[k], web.intensity_cd(ways[k].to), 1e-5 * web.max_intensity_cd()) << k;
  }
}

TEST(WebSketch, LanesOfSeveralLuminairesKeepTheirOwnLight) {
  const PhotometricWeb weak = make_web({0}, {0, 180}, [](double, double) { return 1.0; });
  const PhotometricWeb strong = make_web({0}, {0, 180}, [](double, double) { return 1000.0; });
  SketchLanes lanes;
  const PhotometricWeb* order[] = {&weak, &weak, &strong, &weak, &strong, &strong};
  for (const PhotometricWeb* web : order) lanes.add(web->sketch(), {0, 0.6, -0.8}, 2.0);
  evaluate(lanes);
  for (std::size_t k = 0; k < std::size(order); ++k) {
    EXPECT_NEAR(static_cast<double>(lanes.lx[k]) / (2.0 * order[k]->max_intensity_cd()), 1.0, 1e-6)
        << k;
  }
  lanes.clear();
  evaluate(lanes);
  EXPECT_TRUE(lanes.lx.empty());
}

TEST(WebSketch, IsMadeOnceForAllCopiesOfAWeb) {
  const PhotometricWeb web = make_web({0}, {0, 180}, [](double, double) { return 1.0; });
  const PhotometricWeb copy = web;
  EXPECT_EQ(&web.sketch(), &copy.sketch());
}

}  // namespace
}  // namespace calc::web_sketch_test
