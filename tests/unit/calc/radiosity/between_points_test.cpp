// Direct light between points: the same as at them where it is even, another where beams or shadows
// fall on the points only.
#include "calc/radiosity/between_points.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/grid_receivers.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <variant>
#include <vector>

namespace {

using namespace test_support;

// 4 m x 3 m, 0.8 m above the ground, cells of 0.5 m.
struct Desk {
  calc::Space space;
  calc::CalcPlane plane;
  calc::SensorGrid grid;
  calc::PreparedScene scene;

  explicit Desk(const calc::GridRule& rule = calc::GridByCount{8, 6}) {
    calc::PlanarArea area;
    area.origin_m = {0, 0, 0.8};
    area.outline_m = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    area.grid = rule;
    plane.id = "desk";
    plane.area = area;
    make_grid();
  }
  void make_grid() {
    calc::Diagnostics diagnostics;
    grid = calc::make_sensor_grid(plane, space, diagnostics).value();
  }
  calc::PlanarArea& area() { return std::get<calc::PlanarArea>(plane.area); }

  calc::LightBetweenPoints between(int jobs = 1) {
    set_extent(scene);
    return calc::light_between_points(scene, space, {{&plane, &grid}}, {jobs, [] { return true; }})
        .front();
  }
  // Mean over the same points.
  double at_points_lx(const std::vector<std::size_t>& points) {
    const calc::Tracer tracer(scene);
    const std::vector<calc::Receiver> receivers = calc::receivers_of(tracer, grid);
    double sum = 0.0;
    for (const std::size_t i : points) {
      calc::add_point_sources(tracer, receivers[i], {}, &sum, 1);
      calc::add_extended_sources(tracer, receivers[i], {}, calc::RandomKey(1).with(i), 0, 1, &sum,
                                 1);
    }
    return sum / static_cast<double>(points.size());
  }
};

// 1000 cd within 2 degrees of its axis.
calc::PhotometricWeb beam() {
  constexpr double kDegree = calc::kPi / 180.0;
  return calc::PhotometricWeb::make({0.0}, {0.0, 2 * kDegree, 2.1 * kDegree, calc::kPi},
                                    {1000, 1000, 0, 0}, {}, {});
}

TEST(LightBetweenPoints, IsThatOfThePointsWhereLightIsEven) {
  Desk desk;
  const calc::PhotometricWeb panel =
      lambert_web(1000, 18, {calc::OpeningShape::rectangle, 1.2, 0.6, 0.0});
  for (const double x : {1.0, 3.0}) add_luminaire(desk.scene, panel, {x, 1.5, 2.8});
  const calc::LightBetweenPoints between = desk.between();
  ASSERT_EQ(between.point.size(), 48u);
  ASSERT_EQ(between.direct_lx.size(), 1u);
  EXPECT_NEAR(between.direct_lx[0], desk.at_points_lx(between.point), 0.01 * between.direct_lx[0]);
  EXPECT_EQ(desk.between(2).direct_lx, between.direct_lx);
}

TEST(LightBetweenPoints, IsFarLessWhereBeamsFallOnThePoints) {
  Desk desk;
  const calc::PhotometricWeb web = beam();
  for (const glm::dvec3& at : desk.grid.position_m) {
    add_luminaire(desk.scene, web, at + glm::dvec3(0, 0, 1.5));
  }
  const calc::LightBetweenPoints between = desk.between();
  const double at_points_lx = desk.at_points_lx(between.point);
  EXPECT_NEAR(at_points_lx, 1000 / (1.5 * 1.5), 1.0);
  // Of a cell of 0.25 m2 the beam has 0.0086 m2.
  EXPECT_LT(between.direct_lx[0], 0.15 * at_points_lx);
}

TEST(LightBetweenPoints, IsMoreWhereShadowsFallOnThePoints) {
  Desk desk;
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 30});
  for (const glm::dvec3& at : desk.grid.position_m) {
    add_quad(desk.scene, at + glm::dvec3(-0.05, -0.05, 0.02), {0.1, 0, 0}, {0, 0.1, 0}, 0.0);
  }
  const calc::LightBetweenPoints between = desk.between();
  EXPECT_EQ(desk.at_points_lx(between.point), 0.0);
  // Of a cell of 0.25 m2 the shadow has 0.01 m2.
  EXPECT_GT(between.direct_lx[0], 0.8 * 500 / (29.2 * 29.2));
}

TEST(LightBetweenPoints, KeepsToTheAreaAndOutOfHoles) {
  Desk desk;
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 30});
  desk.area().outline_m = {{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 1.3}, {0, 1.3}};
  desk.area().holes_m = {{{3.05, 0.05}, {3.95, 0.05}, {3.95, 0.95}, {3.05, 0.95}}};
  desk.make_grid();
  // Cells beside the edge at y = 1.3 m have a place beyond it, by chance not each of them.
  const calc::LightBetweenPoints between = desk.between();
  EXPECT_LT(between.point.size(), desk.grid.position_m.size());
  EXPECT_GT(between.point.size(), desk.grid.position_m.size() / 2);
}

TEST(LightBetweenPoints, TakesSomeOfManyCellsAndNoneOfLists) {
  Desk many(calc::GridByCount{100, 90});
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(many.scene, web, {2, 1.5, 3});
  const std::size_t cells = many.between().point.size();
  EXPECT_GT(cells, 200u);
  EXPECT_LE(cells, 256u);

  Desk list;
  add_luminaire(list.scene, web, {2, 1.5, 3});
  list.plane.area = calc::PointList{"points.csv", {{1, 1, 0.8}}, {{0, 0, 1}}, {2}};
  list.make_grid();
  EXPECT_TRUE(list.between().point.empty());
}

TEST(LightBetweenPoints, EndsWhenItIsToldTo) {
  Desk desk;
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 3});
  set_extent(desk.scene);
  const auto light = calc::light_between_points(desk.scene, desk.space, {{&desk.plane, &desk.grid}},
                                                {1, [] { return false; }});
  ASSERT_EQ(light.size(), 1u);
  EXPECT_TRUE(light[0].point.empty());
}

}  // namespace
