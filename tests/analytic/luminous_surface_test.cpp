// Luminous surfaces against the form factors of rectangles, from the project file on: near, far,
// very large, from both sides, dimmed, and in a closed room by the balance of its flux.

#include "calc/base/elementary.h"
#include "calc/scene/sensor_grid.h"
#include "tests/support/scenes.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace luminous_surface_test {
namespace {

using namespace test_support;

// Mean over the replicates at points that look along `axis`, in the first space.
std::vector<double> values_lx(const calc::Project& project, std::vector<glm::dvec3> points_m,
                              const glm::dvec3& axis, std::uint64_t paths = 256) {
  calc::CalcPlane plane;
  plane.id = "p";
  const std::size_t count = points_m.size();
  plane.area = calc::PointList{"", std::move(points_m), std::vector<glm::dvec3>(count, axis),
                               std::vector<int>(count, 1)};
  calc::Diagnostics diagnostics;
  const calc::Space& space = project.spaces.at(0);
  const auto grid = calc::make_sensor_grid(plane, space, diagnostics);
  EXPECT_TRUE(grid && grid->position_m.size() == count);
  const calc::PreparedScene scene = calc::prepare_scene(project, space);
  const calc::PlaneField field = solve_with_paths(scene, *grid, 5, paths).fields[0];
  EXPECT_EQ(field.problem, "");
  std::vector<double> means;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (std::size_t r = 0; r < field.replicates; ++r) sum += total_lx(field, r, i);
    means.push_back(sum / static_cast<double>(field.replicates));
  }
  return means;
}

calc::Project project_with(const std::string& lines) {
  calc::tests::Loaded loaded = calc::tests::load(calc::tests::in_project(lines));
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project ? std::move(*loaded.project) : calc::Project{};
}

// Of a parallel rectangle a x b, seen from h straight below one of its corners.
double corner_factor(double a_m, double b_m, double h_m) {
  const double a = a_m / h_m, b = b_m / h_m;
  const double ra = std::sqrt(1.0 + a * a), rb = std::sqrt(1.0 + b * b);
  return (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / (2.0 * calc::kPi);
}

// Signed parts of the rectangle about the point below (x, y).
double factor_below(double width_m, double depth_m, const glm::dvec3& below_m) {
  const auto part = [&](double x, double y) {
    const double size = corner_factor(std::abs(x), std::abs(y), below_m.z);
    return (x < 0.0) == (y < 0.0) ? size : -size;
  };
  const double x = below_m.x, y = below_m.y;
  return part(width_m - x, depth_m - y) + part(x, depth_m - y) + part(width_m - x, y) + part(x, y);
}

TEST(LuminousSurface, GivesTheFormFactorOfItsRectangle) {
  struct Case {
    double width_m, depth_m;
    std::vector<glm::dvec3> below_m;  // x, y from the corner, distance
  };
  const std::vector<Case> cases{
      {60, 60, {{30, 30, 0.01}, {30, 30, 1}, {30, 30, 40}, {0, 0, 3}, {-5, 20, 2}, {59.9, 3, 0.1}}},
      {6, 4, {{3, 2, 0.002}, {3, 2, 2.2}, {1, -3, 2.2}, {3, 2, 300}}},
      {40, 0.05, {{20, 0.025, 0.02}, {20, 0.025, 3}, {20, 2, 3}}}};
  for (const Case& c : cases) {
    const calc::Project project = project_with(
        fmt::format("<quad id='sky' origin='0 {} 5' u='{} 0 0' v='0 -{} 0' material='white' "
                    "luminous-exitance='2000'/>",
                    c.depth_m, c.width_m, c.depth_m));
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& below : c.below_m) points.emplace_back(below.x, below.y, 5.0 - below.z);
    const std::vector<double> found = values_lx(project, points, {0, 0, 1});
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double expected = 2000.0 * factor_below(c.width_m, c.depth_m, c.below_m[i]);
      EXPECT_NEAR(found[i] / expected, 1.0, 0.002)
          << c.width_m << " x " << c.depth_m << ", point " << i;
    }
    const std::vector<double> behind = values_lx(project, {{1, 0.01, 7}}, {0, 0, -1});
    EXPECT_EQ(behind[0], 0.0) << "it sends nothing backwards";
  }
}

// As at 0.3 mm from a surface of 40 m: points nearer to it than a thousandth of its parts' sizes.
TEST(LuminousSurface, FillsHalfOfWhatAPointBesideItSees) {
  const calc::Project project = project_with(
      "<quad id='floor' origin='0 0 0' u='40 0 0' v='0 40 0' material='white' "
      "luminous-exitance='1000'/>");
  for (const double above_m : {3e-4, 1e-3, 1e-2}) {
    for (const double found :
         values_lx(project, {{20, 20, above_m}, {11.3, 29.7, above_m}}, {0, 0, -1})) {
      EXPECT_NEAR(found, 1000.0, 2.0) << above_m;
    }
  }
}

TEST(LuminousSurface, IsALuminaireOfATypeOfItsOwn) {
  const calc::Project project = project_with(
      "<quad id='wall' origin='0 0 0' u='0 3 0' v='0 0 2' material='white' luminous-exitance='800' "
      "group='walls' power-w='90' maintenance-factor='0.7' repeat='2 1 1' step='5 0 0'/>");
  const calc::Space& space = project.spaces.at(0);
  ASSERT_EQ(space.bodies.size(), 2u);
  ASSERT_EQ(space.luminaires.size(), 2u);
  const calc::Luminaire& second = space.luminaires[1];
  EXPECT_EQ(second.id, "wall[1,0,0]");
  EXPECT_EQ(second.group, "walls");
  EXPECT_EQ(second.position_m, glm::dvec3(5, 1.5, 1));
  EXPECT_NEAR(glm::length(second.world_from_luminaire[2] - glm::dvec3(-1, 0, 0)), 0.0, 1e-12);
  ASSERT_EQ(space.luminaires[0].type, second.type);
  const calc::LuminaireType& type = project.luminaire_types.at(second.type);
  EXPECT_EQ(type.id, "wall");
  EXPECT_EQ(type.power_w, 90.0);
  EXPECT_EQ(type.maintenance.product, 0.7);
  EXPECT_TRUE(type.maintenance.is_stated);
  const calc::PhotometricWeb& web = project.webs.at(type.web);
  EXPECT_NEAR(web.flux_lm() * type.flux_scale, 800.0 * 6.0, 1e-9);
  EXPECT_EQ(web.opening().size_m(), glm::dvec3(3, 2, 0));
}

// All that leaves the surfaces of a closed room comes in at them again: with one reflectance
// everywhere, the mean over all surfaces is M A_l / ((1 - rho) A).
TEST(LuminousSurface, FillsAClosedRoomWithItsFlux) {
  const calc::Project project = project_with(
      "<room id='r' size='6 4 3' floor='white' walls='white' ceiling='white'>"
      "<quad id='ceiling' origin='0 4 2.999' u='6 0 0' v='0 -4 0' material='white' "
      "luminous-exitance='1000'/></room>");
  double reflectance = 0.0;
  for (const calc::Material& material : project.materials) {
    if (material.id == "white") reflectance = material.reflectance;
  }
  ASSERT_GT(reflectance, 0.0);
  double flux_lm = 0.0;
  const auto add_face = [&](glm::dvec3 origin, glm::dvec3 u, glm::dvec3 v) {
    constexpr int kCells = 12;
    std::vector<glm::dvec3> points;
    for (int i = 0; i < kCells * kCells; ++i) {
      points.push_back(origin + (i % kCells + 0.5) / kCells * u + (i / kCells + 0.5) / kCells * v);
    }
    double sum = 0.0;
    for (const double lx : values_lx(project, points, glm::normalize(glm::cross(u, v)), 2048)) {
      sum += lx;
    }
    flux_lm += sum / (kCells * kCells) * glm::length(glm::cross(u, v));
  };
  add_face({0, 0, 0}, {6, 0, 0}, {0, 4, 0});
  add_face({0, 4, 2.999}, {6, 0, 0}, {0, -4, 0});
  add_face({0, 0, 0}, {0, 4, 0}, {0, 0, 2.999});
  add_face({6, 0, 0}, {0, 0, 2.999}, {0, 4, 0});
  add_face({0, 0, 0}, {0, 0, 2.999}, {6, 0, 0});
  add_face({0, 4, 0}, {6, 0, 0}, {0, 0, 2.999});
  EXPECT_NEAR(flux_lm * (1.0 - reflectance) / (1000.0 * 24.0), 1.0, 0.01);
}

TEST(LuminousSurface, SaysWhatItCannotBe) {
  using calc::tests::in_project;
  using calc::tests::load;
  const auto messages = [](const std::string& attributes) {
    return load(in_project("<quad id='q' origin='0 0 0' material='white' " + attributes + "/>"))
        .messages;
  };
  EXPECT_THAT(messages("u='1 0 0' v='1 1 0' luminous-exitance='5'"),
              testing::HasSubstr(
                  "error[luminous-not-rectangle]: 'u' and 'v' of a quad with 'luminous-exitance' "
                  "must be at right angles, but the angle between them is 45 degrees"));
  EXPECT_THAT(messages("u='1 0 0' v='0 1 0' power-w='5'"),
              testing::HasSubstr("error[missing-partner]: <quad> has 'power-w' without "
                                 "'luminous-exitance'; the two belong together"));
  EXPECT_THAT(messages("u='1 0 0' v='0 1 0' luminous-exitance='0'"),
              testing::HasSubstr("luminous-exitance"));
}

}  // namespace
}  // namespace luminous_surface_test
