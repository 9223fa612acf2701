// Points in walls and corners against the closed forms of what is just beside them.
//
// A surface that lies in a vertical plane through a horizontal element, seen under the azimuths of
// a turn by `a`, fills that part of its sky: of its exitance B the element gets B a / (2 pi). The
// surfaces' far parts lie in the element's own horizon and give nothing.

#include "calc/scene/sensor_grid.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace points_in_surfaces_test {
namespace {

using namespace test_support;

constexpr double kFlux_lm = 1000.0;
constexpr double kReflectance = 0.6;

struct Case {
  calc::Space space;
  calc::PreparedScene scene;
};

void add_sheet(Case& c, const char* id, glm::dvec3 origin, glm::dvec3 u, glm::dvec3 v,
               double reflectance) {
  calc::Body body;
  body.id = id;
  body.vertex_m = {origin, origin + u, origin + u + v, origin + v};
  body.triangle = {{0, 1, 2}, {0, 2, 3}};
  c.space.bodies.push_back(body);
  const auto first = static_cast<std::uint32_t>(c.scene.vertex_m.size());
  for (const glm::dvec3& corner : body.vertex_m) c.scene.vertex_m.emplace_back(corner);
  const auto index = static_cast<std::uint32_t>(c.space.bodies.size() - 1);
  c.scene.body_id.emplace_back(id);
  for (const glm::uvec3& t : body.triangle) {
    c.scene.triangle.push_back(t + first);
    c.scene.reflectance.push_back(reflectance);
    c.scene.body.push_back(index);
  }
}

// Walls x = 0 and y = 0 of a room that lies in x, y > 0; the floor is open.
Case corner(double reflectance_x, double reflectance_y, const calc::PhotometricWeb& web,
            glm::dvec3 lamp_m) {
  Case c;
  c.space.shell = calc::RoomShell{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, -4.0, 8.0};
  add_sheet(c, "x", {0, 0, -4}, {0, 8, 0}, {0, 0, 8}, reflectance_x);
  add_sheet(c, "y", {0, 0, -4}, {8, 0, 0}, {0, 0, 8}, reflectance_y);
  add_luminaire(c.scene, web, lamp_m);
  calc::Luminaire lamp;
  lamp.position_m = lamp_m;
  c.space.luminaires.push_back(lamp);
  set_extent(c.scene);
  return c;
}

double value_lx(const Case& c, glm::dvec3 point_m, calc::ReceiverKernel kernel,
                glm::dvec3 axis = {0, 0, 1}) {
  calc::CalcPlane plane;
  plane.id = "p";
  plane.kernel = kernel;
  plane.area = calc::PointList{"", {point_m}, {axis}, {1}};
  calc::Diagnostics diagnostics;
  const auto grid = calc::make_sensor_grid(plane, c.space, diagnostics);
  if (!grid) return -1.0;
  EXPECT_EQ(grid->inner.size(), 1u);
  const calc::PlaneField field = solve_with_paths(c.scene, *grid, 7, 16384).fields[0];
  EXPECT_EQ(field.problem, "");
  double sum = 0.0;
  for (std::size_t r = 0; r < field.replicates; ++r) sum += total_lx(field, r, 0);
  return sum / static_cast<double>(field.replicates);
}

constexpr glm::dvec3 kLamp_m(1.5, 1.5, 1.0);

double direct_lx(glm::dvec3 point_m, glm::dvec3 normal) {
  const glm::dvec3 to = kLamp_m - point_m;
  const double d = glm::length(to);
  return kFlux_lm / (4.0 * calc::kPi) * glm::dot(to, normal) / (d * d * d);
}

TEST(PointsInSurfaces, AtAWallHalfTheSkyIsTheWall) {
  const calc::PhotometricWeb web = isotropic_web(kFlux_lm / (4.0 * calc::kPi));
  const Case c = corner(kReflectance, 0.0, web, kLamp_m);
  const glm::dvec3 p(0, 2, 0);
  const double exitance = kReflectance * direct_lx(p, {1, 0, 0});
  const double expected = direct_lx(p, {0, 0, 1}) + 0.5 * exitance;
  EXPECT_NEAR(value_lx(c, p, calc::ReceiverKernel::planar) / expected, 1.0, 0.005);
  // A sphere has half of its surroundings in the wall; E_scalar = (1 / 4) integral L.
  const glm::dvec3 to = kLamp_m - p;
  const double scalar = kFlux_lm / (4.0 * calc::kPi) / (4.0 * glm::dot(to, to)) + 0.5 * exitance;
  EXPECT_NEAR(value_lx(c, p, calc::ReceiverKernel::scalar) / scalar, 1.0, 0.005);
}

TEST(PointsInSurfaces, InACornerEachWallHasThreeEighthsOfTheSky) {
  const calc::PhotometricWeb web = isotropic_web(kFlux_lm / (4.0 * calc::kPi));
  const Case c = corner(kReflectance, 0.0, web, kLamp_m);
  const glm::dvec3 p(0, 0, 0);
  const double expected = direct_lx(p, {0, 0, 1}) + 0.375 * kReflectance * direct_lx(p, {1, 0, 0});
  EXPECT_NEAR(value_lx(c, p, calc::ReceiverKernel::planar) / expected, 1.0, 0.005);
}

TEST(PointsInSurfaces, OfAWallAtAnotherWallIsTheSame) {
  const calc::PhotometricWeb web = isotropic_web(kFlux_lm / (4.0 * calc::kPi));
  const Case c = corner(kReflectance, 0.0, web, kLamp_m);
  const glm::dvec3 p(0, 0, 1.2);  // on wall y, at wall x: half of its sky
  const double expected = direct_lx(p, {0, 1, 0}) + 0.5 * kReflectance * direct_lx(p, {1, 0, 0});
  EXPECT_NEAR(value_lx(c, p, calc::ReceiverKernel::planar, {0, 1, 0}) / expected, 1.0, 0.005);
}

}  // namespace
}  // namespace points_in_surfaces_test
