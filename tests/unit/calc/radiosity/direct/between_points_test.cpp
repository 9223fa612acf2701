// Direct light between points: the same as at them where it is even, another where beams or shadows
// fall on the points only.
#include "calc/radiosity/direct/between_points.h"

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/sampling/grid_receivers.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <set>
#include <variant>
#include <vector>

namespace between_points_test {
namespace {

using namespace test_support;

// 4 m x 3 m, 0.8 m above the ground, cells of 0.5 m.
struct Desk {
  calc::Space space;
  calc::CalcPlane plane;
  calc::SensorGrid grid;
  calc::PreparedScene scene;
  std::vector<std::size_t> also;

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

  calc::LightBetweenPoints between(int jobs = 1, int pairs = 1) {
    set_extent(scene);
    return calc::light_between_points(scene, space, {{&plane, &grid, also}},
                                      {jobs, [] { return true; }, pairs})
        .front();
  }
  // Mean over the cells' points.
  double at_points_lx(const calc::LightBetweenPoints& between) {
    const calc::Tracer tracer(scene);
    const std::vector<calc::Receiver> receivers = calc::receivers_of(tracer, grid);
    double sum = 0.0;
    for (const auto& cell : between.cells) {
      const std::size_t i = cell.point;
      calc::add_point_sources(tracer, receivers[i], {}, &sum, 1);
      calc::add_extended_sources(tracer, receivers[i], {}, calc::RandomKey(1).with(i), 0, 1, &sum,
                                 1);
    }
    return sum / static_cast<double>(between.cells.size());
  }
};

double mean_lx(const calc::LightBetweenPoints& between) {
  double sum = 0.0;
  for (const auto& cell : between.cells) sum += cell.direct_lx.at(0);
  return sum / static_cast<double>(between.cells.size());
}

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
  ASSERT_EQ(between.cells.size(), 48u);
  EXPECT_EQ(between.not_measured, 0u);
  EXPECT_NEAR(mean_lx(between), desk.at_points_lx(between), 0.01 * mean_lx(between));
  EXPECT_EQ(mean_lx(desk.between(2)), mean_lx(between));
}

TEST(LightBetweenPoints, IsFarLessWhereBeamsFallOnThePoints) {
  Desk desk;
  const calc::PhotometricWeb web = beam();
  for (const glm::dvec3& at : desk.grid.position_m) {
    add_luminaire(desk.scene, web, at + glm::dvec3(0, 0, 1.5));
  }
  const calc::LightBetweenPoints between = desk.between();
  const double at_points_lx = desk.at_points_lx(between);
  EXPECT_NEAR(at_points_lx, 1000 / (1.5 * 1.5), 1.0);
  // Of a cell of 0.25 m2 the beam has 0.0086 m2.
  EXPECT_LT(mean_lx(between), 0.15 * at_points_lx);
}

TEST(LightBetweenPoints, IsMoreWhereShadowsFallOnThePoints) {
  Desk desk;
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 30});
  for (const glm::dvec3& at : desk.grid.position_m) {
    add_quad(desk.scene, at + glm::dvec3(-0.05, -0.05, 0.02), {0.1, 0, 0}, {0, 0.1, 0}, 0.0);
  }
  const calc::LightBetweenPoints between = desk.between();
  EXPECT_EQ(desk.at_points_lx(between), 0.0);
  // Of a cell of 0.25 m2 the shadow has 0.01 m2.
  EXPECT_GT(mean_lx(between), 0.8 * 500 / (29.2 * 29.2));
}

// Beams that meet parts of cells that are outside the area or in a hole.
TEST(LightBetweenPoints, KeepsToTheAreaAndOutOfHoles) {
  Desk desk;
  const calc::PhotometricWeb web = beam();
  add_luminaire(desk.scene, web, {1.25, 1.42, 2.3});
  add_luminaire(desk.scene, web, {2.93, 0.25, 2.3});
  EXPECT_GT(mean_lx(desk.between(1, 400)), 0.0);
  desk.area().outline_m = {{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 1.34}, {0, 1.34}};
  desk.area().holes_m = {{{2.85, 0.05}, {3.95, 0.05}, {3.95, 0.95}, {2.85, 0.95}}};
  desk.make_grid();
  const calc::LightBetweenPoints between = desk.between(1, 400);
  EXPECT_GT(between.cells.size(), 24u);
  EXPECT_EQ(mean_lx(between), 0.0);
}

TEST(LightBetweenPoints, TakesSomeOfManyCellsAndNoneOfLists) {
  Desk many(calc::GridByCount{100, 90});
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(many.scene, web, {2, 1.5, 3});
  const std::size_t cells = many.between().cells.size();
  EXPECT_GT(cells, 100u);
  EXPECT_LE(cells, 128u);

  Desk list;
  add_luminaire(list.scene, web, {2, 1.5, 3});
  list.plane.area = calc::PointList{"points.csv", {{1, 1, 0.8}}, {{0, 0, 1}}, {2}};
  list.make_grid();
  EXPECT_TRUE(list.between().cells.empty());
}

// A fixed stride would be known to who aims at all other points.
TEST(LightBetweenPoints, TheCellsTakenAreByChanceAndThoseAskedForToo) {
  Desk desk(calc::GridByCount{40, 15});
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 3});
  desk.also = {7, 599};
  const calc::LightBetweenPoints first = desk.between();
  std::set<std::size_t> rests;
  for (const auto& cell : first.cells) {
    if (cell.is_sample) rests.insert(cell.point % 5);
  }
  EXPECT_EQ(rests.size(), 5u);
  const auto count = first.cells.size();
  EXPECT_EQ(first.cells[count - 2].point, 7u);
  EXPECT_EQ(first.cells[count - 1].point, 599u);
  EXPECT_FALSE(first.cells[count - 1].is_sample);
  desk.scene.luminaires[0].position_m.x += 1e-9;
  const calc::LightBetweenPoints second = desk.between();
  std::size_t same = 0;
  for (std::size_t k = 0; k < count; ++k) same += first.cells[k].point == second.cells[k].point;
  EXPECT_LT(same, count / 2);
}

TEST(LightBetweenPoints, CellsThatSurfacesCoverAreCounted) {
  Desk desk;
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 3});
  // Slabs in the plane between rows and columns of points: 4 cm around each point are free.
  const auto slab = [&](const glm::dvec3& low, const glm::dvec3& high) {
    calc::Body body;
    body.id = "slab";
    body.is_closed = true;
    for (int i = 0; i < 8; ++i) {
      body.vertex_m.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                 (i & 4) != 0 ? high.z : low.z);
    }
    body.triangle = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    body.material_of.assign(body.triangle.size(), 0);
    desk.space.bodies.push_back(body);
  };
  for (int i = 0; i <= 8; ++i) slab({0.5 * i - 0.23, 0, 0.79}, {0.5 * i + 0.23, 3, 0.81});
  for (int i = 0; i <= 6; ++i) slab({0, 0.5 * i - 0.23, 0.79}, {4, 0.5 * i + 0.23, 0.81});
  desk.make_grid();
  ASSERT_EQ(desk.grid.position_m.size(), 48u);
  const calc::LightBetweenPoints between = desk.between();
  EXPECT_GT(between.not_measured, 40u);
  EXPECT_EQ(between.not_measured + between.cells.size(), 48u);
}

TEST(LightBetweenPoints, EndsWhenItIsToldTo) {
  Desk desk;
  const calc::PhotometricWeb web = isotropic_web(500);
  add_luminaire(desk.scene, web, {2, 1.5, 3});
  set_extent(desk.scene);
  const auto light = calc::light_between_points(desk.scene, desk.space, {{&desk.plane, &desk.grid}},
                                                {1, [] { return false; }, 1});
  ASSERT_EQ(light.size(), 1u);
  EXPECT_TRUE(light[0].cells.empty());
}

}  // namespace
}  // namespace between_points_test
