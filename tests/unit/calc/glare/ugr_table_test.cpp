// UGR tables against light that is traced one ray at a time, closed forms and published tables.
#include "calc/glare/ugr_table.h"

#include "calc/base/units.h"
#include "calc/glare/position_index.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/support/parsed_photometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace calc::ugr_table_test {
namespace {

constexpr std::size_t kAcross = 0, kAlong = 1;  // UgrView

// Cosine light of 1000 cd down, and of up_cd up: half a metre by 0.2 m.
PhotometricWeb panel(double up_cd = 0.0, OpeningShape shape = OpeningShape::rectangle) {
  std::vector<double> gamma, cd;
  for (int k = 0; k <= 180; ++k) {
    gamma.push_back(k * kPi / 180.0);
    const double cosine = std::cos(gamma.back());
    cd.push_back(k == 90 ? 0.0 : cosine > 0 ? 1000.0 * cosine : -up_cd * cosine);
  }
  return PhotometricWeb::make({0.0}, gamma, cd, {shape, 0.2, 0.5, 0.0}, {});
}

const UgrRow& row_of(const std::vector<UgrRow>& table, double x, double y) {
  for (const UgrRow& row : table)
    if (row.x_per_h == x && row.y_per_h == y) return row;
  throw std::runtime_error("no such room");
}

TEST(UgrTable, OppositeRectanglesAgreeWithKnownShares) {
  EXPECT_NEAR(opposite_rectangles_share(1, 1), 0.19982, 1e-5);
  EXPECT_NEAR(opposite_rectangles_share(2, 2), 0.41525, 1e-5);
  EXPECT_NEAR(opposite_rectangles_share(1e4, 1e4), 1.0, 1e-3);
  EXPECT_DOUBLE_EQ(opposite_rectangles_share(2, 5), opposite_rectangles_share(5, 2));
  EXPECT_NEAR(opposite_rectangles_share(0.02, 0.02), 4e-4 / kPi, 1e-7);  // far away
}

// A second way to the light on the walls: rays. They leave the panels evenly, and a surface that
// they meet evenly, which is what an exchange between three surfaces means.
double traced_indirect_share(double x, double y, const UgrReflectances& rho, double up_share) {
  enum Surface { floor, ceiling, walls };
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto cosine_direction = [&](std::array<double, 3> normal) {
    // Of a normal along an axis: two other axes take the sideways parts.
    const double r = std::sqrt(unit(random)), turn = 2.0 * kPi * unit(random);
    const double sideways[2] = {r * std::cos(turn), r * std::sin(turn)};
    std::array<double, 3> direction{};
    for (std::size_t axis = 0, k = 0; axis < 3; ++axis)
      direction[axis] = normal[axis] != 0.0 ? normal[axis] * std::sqrt(1.0 - r * r) : sideways[k++];
    return direction;
  };
  constexpr int kPaths = 400'000;
  double indirect = 0.0;
  for (int path = 0; path < kPaths; ++path) {
    std::array<double, 3> at{x * unit(random), y * unit(random), 1.0};
    std::array<double, 3> direction = cosine_direction({0.0, 0.0, -1.0});
    Surface hit = ceiling;
    bool is_first = true;
    if (unit(random) >= up_share) {
      double t = 1e9;
      const std::array<double, 3> size{x, y, 1.0};
      std::size_t axis = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = direction[k];
        const double to = d > 0 ? (size[k] - at[k]) / d : d < 0 ? -at[k] / d : 1e9;
        if (to < t && to > 0) t = to, axis = k;
      }
      hit = axis < 2 ? walls : floor;
    }
    for (;;) {
      if (hit == walls && !is_first) indirect += 1.0;
      const double reflectance = hit == floor     ? rho.floor
                                 : hit == ceiling ? rho.ceiling
                                                  : rho.walls;
      if (unit(random) >= reflectance) break;
      is_first = false;
      // A new place on that surface, a new direction, and where it ends.
      std::array<double, 3> normal{0.0, 0.0, hit == floor ? 1.0 : -1.0};
      at = {x * unit(random), y * unit(random), hit == floor ? 0.0 : 1.0};
      if (hit == walls) {
        const bool is_x = unit(random) < y / (x + y), is_low = unit(random) < 0.5;
        normal = {0.0, 0.0, 0.0};
        normal[is_x ? 0 : 1] = is_low ? 1.0 : -1.0;
        at[2] = unit(random);
        at[is_x ? 0 : 1] = is_low ? 0.0 : (is_x ? x : y);
      }
      direction = cosine_direction(normal);
      double t = 1e9;
      std::size_t axis = 0;
      const std::array<double, 3> size{x, y, 1.0};
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = direction[k];
        const double to = d > 0 ? (size[k] - at[k]) / d : d < 0 ? -at[k] / d : 1e9;
        if (to < t && to > 1e-12) t = to, axis = k;
      }
      hit = axis < 2 ? walls : direction[2] < 0 ? floor : ceiling;
    }
  }
  return indirect / kPaths;
}

// The sources, said again: every panel has the luminance of its cosine light.
double summed_sources(double x, double y, double spacing, double area_m2) {
  const double luminance = 1000.0 / area_m2;
  double sum = 0.0;
  for (int i = 0; (i + 0.5) * spacing < y; ++i) {
    for (int k = 0; (k + 0.5) * spacing < x; ++k) {
      const glm::dvec3 to((k + 0.5) * spacing - 0.5 * x, (i + 0.5) * spacing, 1.0);
      const auto index = guth_index(to, {0, 1, 0});
      if (!index) continue;
      const double r2 = glm::dot(to, to);
      const double solid_angle = area_m2 / std::sqrt(r2) / r2;
      sum += luminance * luminance * solid_angle / (*index * *index);
    }
  }
  return sum;
}

TEST(UgrTable, AgreesWithTracedLight) {
  for (const double up_cd : {0.0, 500.0}) {
    const PhotometricWeb web = panel(up_cd);
    const auto table = ugr_table(web, 1.0);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->size(), 19U);
    for (const auto& [x, y] : std::map<double, double>{{2, 4}, {4, 8}, {12, 6}}) {
      for (const std::size_t k : {std::size_t{0}, std::size_t{4}}) {
        const double share =
            traced_indirect_share(x, y, kUgrReflectances[k], up_cd / (1000.0 + up_cd));
        const double walls_lx = x * y * web.flux_lm() * share / (2.0 * (x + y));
        const double expected =
            8.0 * std::log10(0.25 * summed_sources(x, y, 1.0, 0.1) / (walls_lx / kPi));
        const UgrRow& row = row_of(*table, x, y);
        EXPECT_NEAR(row.ugr[kAcross][k], expected, 0.03) << x << " " << y << " " << k;
        EXPECT_NEAR(row.ugr[kAlong][k], expected, 0.03);  // cosine light has no sides
      }
    }
  }
}

TEST(UgrTable, FollowsTheSquareOfLuminance) {
  const auto scaled = [](double cd, double along_c0_m) {
    const PhotometricWeb web = PhotometricWeb::make(
        {0.0}, {0.0, 0.5 * kPi}, {cd, 0.5 * cd}, {OpeningShape::rectangle, along_c0_m, 1, 0}, {});
    return ugr_reference_row(*ugr_table(web)).ugr[kAcross][0];
  };
  EXPECT_NEAR(scaled(2000, 0.5) - scaled(1000, 0.5), 8.0 * std::log10(2.0), 1e-9);
  EXPECT_NEAR(scaled(1000, 1.0) - scaled(1000, 0.5), -8.0 * std::log10(2.0), 1e-9);
}

TEST(UgrTable, ViewsAreThoseOfTheLongerSide) {
  // Light along C0 only: seen crosswise.
  std::vector<double> c, cd;
  const std::vector<double> gamma{0.0, 0.25 * kPi, 0.5 * kPi};
  for (int k = 0; k <= 4; ++k) {
    c.push_back(k * 0.5 * kPi);
    const double side = k % 2 == 0 ? 800.0 : 100.0;
    cd.insert(cd.end(), {500.0, side, 0.5 * side});
  }
  const auto table =
      ugr_table(PhotometricWeb::make(c, gamma, cd, {OpeningShape::rectangle, 0.3, 1.2, 0.0}, {}));
  const UgrRow& row = ugr_reference_row(*table);
  EXPECT_GT(row.ugr[kAcross][0], row.ugr[kAlong][0] + 5.0);
}

TEST(UgrTable, SidesOfFlatOpeningsCount) {
  const auto rating = [](double height_m) {
    return ugr_reference_row(
               *ugr_table(PhotometricWeb::make({0.0}, {0.0, 0.5 * kPi}, {1000, 500},
                                               {OpeningShape::rectangle, 0.5, 0.5, height_m}, {})))
        .ugr[kAcross][0];
  };
  EXPECT_LT(rating(0.05), rating(0.0) - 0.5);
}

TEST(UgrTable, WithoutAreaOrLightThereIsNoNumber) {
  EXPECT_FALSE(ugr_table(panel(0.0, OpeningShape::point)));
  // Only up: nothing is seen, though the room is lit.
  const PhotometricWeb uplight = PhotometricWeb::make({0.0}, {0.0, 0.5 * kPi, kPi}, {0, 0, 1000},
                                                      {OpeningShape::disk, 1, 1, 0}, {});
  const auto table = ugr_table(uplight);
  ASSERT_TRUE(table);
  EXPECT_TRUE(std::isnan(ugr_reference_row(*table).ugr[kAcross][0]));
}

// Published tables of other programs, which are not part of this project.
TEST(UgrTable, AgreesWithPublishedTables) {
  const char* folder = std::getenv("LUXGATE_SHARED_DATA");
  if (folder == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  std::ifstream file(std::filesystem::path(folder) / "standards/glare_tables.csv");
  if (!file) GTEST_SKIP() << "no tables in LUXGATE_SHARED_DATA";
  std::map<std::string, double> worst, sum;
  std::map<std::string, int> count;
  std::map<std::string, std::vector<UgrRow>> tables;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    const std::string& name = cells[1];
    if (!tables.contains(name)) {
      std::ifstream photometry(std::filesystem::path(folder) / "photometry" / name,
                               std::ios::binary);
      std::ostringstream bytes;
      bytes << photometry.rdbuf();
      const auto parsed = test_support::parse_with_messages(bytes.str(), name);
      ASSERT_TRUE(parsed.web) << name << parsed.messages;
      tables[name] = *ugr_table(*parsed.web, 0.25);
    }
    const UgrRow& row = row_of(tables[name], std::stod(cells[4]), std::stod(cells[5]));
    for (std::size_t k = 0; k < 10; ++k) {
      const double difference = row.ugr[k / 5][k % 5] - std::stod(cells[6 + k]);
      double& largest = worst[cells[2]];
      if (std::abs(difference) > std::abs(largest)) largest = difference;
      sum[cells[2]] += difference;
      ++count[cells[2]];
    }
  }
  for (const auto& [program, difference] : worst) {
    std::printf("%s: largest %.2f, mean %.2f of %d\n", program.c_str(), difference,
                sum[program] / count[program], count[program]);
  }
  EXPECT_LT(std::abs(worst["Relux"]), 0.4);
  EXPECT_LT(std::abs(worst["DIALux"]), 0.9);
}

}  // namespace
}  // namespace calc::ugr_table_test
