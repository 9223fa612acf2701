#include "calc/radiosity/direct/point_problem.h"

#include "calc/radiosity/looks/solve.h"
#include "calc/radiosity/sampling/grid_receivers.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace point_problem_test {
namespace {

using namespace test_support;

// A room of 4 x 3 x 2.5 m about the origin, and a plate in it at z = 0.2.
calc::PreparedScene room() {
  calc::PreparedScene scene;
  add_box(scene, {-2, -1.5, -1.25}, {4, 3, 2.5}, 0.5);
  add_quad(scene, {0.5, 0.5, 0.2}, {1, 0, 0}, {0, 0.5, 0}, 0.5);
  set_extent(scene);
  scene.body.back() = scene.body[scene.body.size() - 2] = 1;
  scene.body_id = {"walls", "plate"};
  return scene;
}

std::string problem_of(const calc::PreparedScene& scene, const glm::dvec3& position_m,
                       const glm::dvec3& normal,
                       calc::ReceiverKernel kernel = calc::ReceiverKernel::planar,
                       calc::DerivedQuantity derived = calc::DerivedQuantity::none,
                       const glm::dvec3& shift_m = glm::dvec3(0.0)) {
  const calc::Tracer tracer(scene);
  calc::SensorGrid grid;
  grid.kernel = kernel;
  grid.derived = derived;
  grid.position_m = {position_m};
  grid.normal = {normal};
  grid.shift_m = {shift_m};
  return calc::point_problem(tracer, grid, calc::receivers_of(tracer, grid), true).english();
}

const glm::dvec3 kUp(0, 0, 1), kDown(0, 0, -1);

TEST(PointProblem, NamesPointSurfaceDistanceAndWhatIsAllowed) {
  const std::string problem = problem_of(room(), {-2 + 1e-5, 0, 0}, {-1, 0, 0});
  for (const char* part : {"(-1.99999 0 0)", "1e-05 m", "'walls'", "a model of 5.59 m", "at least",
                           "Put the point into the surface"}) {
    EXPECT_NE(problem.find(part), std::string::npos) << part << " in " << problem;
  }
  EXPECT_NE(problem_of(room(), {1, 0.7, 0.2 - 1e-6}, kUp).find("'plate'"), std::string::npos);
}

TEST(PointProblem, WhatIsSaidToBeEnoughIsEnough) {
  const calc::PreparedScene scene = room();
  const double enough_m = 2.125 * scene.ray_offset_m();
  for (const double share : {0.2, 0.5, 0.9, 1.0, 1.5, 2.0}) {
    const double d = share * scene.ray_offset_m();
    EXPECT_FALSE(problem_of(scene, {-2 + d, 0, 0}, {-1, 0, 0}).empty()) << share;
    EXPECT_FALSE(problem_of(scene, {1, 0.7, 0.2 - d}, kUp).empty()) << share;
  }
  EXPECT_EQ(problem_of(scene, {-2 + enough_m * 1.01, 0, 0}, {-1, 0, 0}), "");
  EXPECT_EQ(problem_of(scene, {1, 0.7, 0.2 - enough_m * 1.01}, kUp), "");
  // Beside a wall rays begin no nearer to it than the point is.
  EXPECT_EQ(problem_of(scene, {-2 + 1.2 * scene.ray_offset_m(), 0, 0}, kUp), "");
  EXPECT_FALSE(problem_of(scene, {-2 + 0.8 * scene.ray_offset_m(), 0, 0}, kUp).empty());
}

TEST(PointProblem, PointsInSurfacesAreAllowed) {
  const calc::PreparedScene scene = room();
  EXPECT_EQ(problem_of(scene, {1, 0.7, 0.2}, kUp), "");
  EXPECT_EQ(problem_of(scene, {1, 0.7, 0.2}, kDown), "");
  EXPECT_EQ(problem_of(scene, {0, 0, -1.25}, kUp), "");
  EXPECT_EQ(problem_of(scene, {0.3, 0.2, -1.25 + 1e-9}, kUp), "");
  EXPECT_EQ(problem_of(scene, {-2, 0, 0}, {1, 0, 0}), "");
}

TEST(PointProblem, BehindAPlanarPointNothingIsInTheWay) {
  const calc::PreparedScene scene = room();
  EXPECT_EQ(problem_of(scene, {1, 0.7, 0.2 + 1e-5}, kUp), "");
  EXPECT_FALSE(problem_of(scene, {1, 0.7, 0.2 + 2e-6}, kUp, calc::ReceiverKernel::scalar).empty());
}

TEST(PointProblem, ASlopeThatRisesFarAwayIsNoObstacle) {
  calc::PreparedScene scene;  // 1 : 1000, under a point 10 um above it
  add_quad(scene, {-2, -2, -0.002}, {4, 0, 0.004}, {0, 4, 0}, 0.5);
  set_extent(scene);
  EXPECT_EQ(problem_of(scene, {0, 0, 1e-5}, kUp), "");
  EXPECT_FALSE(problem_of(scene, {0, 0, -5e-6}, kUp).empty());
}

// Nothing that rises in front of a point, or stands at one that looks all around, may be missed:
// such points are measured from off the surface, which is the grid's task.
TEST(PointProblem, OfSurfacesInFrontOnlyThoseThatAreShiftedOff) {
  const calc::PreparedScene scene = room();
  const double enough_m = 2.2 * scene.ray_offset_m();
  const auto problem_at = [&](const glm::dvec3& position_m, const glm::dvec3& axis,
                              calc::ReceiverKernel kernel, const glm::dvec3& shift_m) {
    return problem_of(scene, position_m, axis, kernel, calc::DerivedQuantity::none, shift_m);
  };
  struct Case {
    const char* name;
    glm::dvec3 position_m, axis;
    calc::ReceiverKernel kernel;
    glm::dvec3 off;
  };
  const calc::ReceiverKernel planar = calc::ReceiverKernel::planar,
                             cylinder = calc::ReceiverKernel::cylindrical,
                             sphere = calc::ReceiverKernel::scalar;
  for (const Case& c : {Case{"edge of floor and wall", {-2, 0.1, -1.25}, kUp, planar, {1, 0, 0}},
                        Case{"upright on the floor", {0, 0, -1.25}, {1, 0, 0}, planar, kUp},
                        Case{"cylinder on the floor", {0, 0, -1.25}, kUp, cylinder, kUp},
                        Case{"off the diagonal", {1e-6, 0, -1.25}, kUp, cylinder, kUp},
                        Case{"sphere on the floor", {0.3, 0.2, -1.25}, kUp, sphere, kUp},
                        Case{"sphere in a wall", {-2, 0, 0}, kUp, sphere, {1, 0, 0}}}) {
    EXPECT_FALSE(problem_at(c.position_m, c.axis, c.kernel, glm::dvec3(0.0)).empty()) << c.name;
    EXPECT_EQ(problem_at(c.position_m, c.axis, c.kernel, enough_m * c.off), "") << c.name;
  }
}

TEST(PointProblem, OneOfTheFourPlanesLooksAtTheWall) {
  const calc::PreparedScene scene = room();
  const glm::dvec3 beside(-2 + 1.5 * scene.ray_offset_m(), 0, 0);
  EXPECT_FALSE(problem_of(scene, beside, kUp, calc::ReceiverKernel::cylindrical,
                          calc::DerivedQuantity::four_planes)
                   .empty());
}

TEST(PointProblem, PlaneIsNotJudgedAndPicturesMayStillAsk) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene = room();
  add_luminaire(scene, web, {0, 0, 1});
  calc::SensorGrid grid;
  grid.position_m = {{0, 0, 0}, {1, 0.7, 0.2 - 1e-6}, {1.2, 0.7, 0.2 - 1e-6}};
  grid.normal = {kUp, kUp, kUp};
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = 16;
  const auto gatherer = calc::make_cpu_gatherer();
  const auto problem = [&] {
    return calc::solve_illuminance(
               scene, {{"p", &grid}}, settings, 0.95, *gatherer,
               [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; },
               {})
        .fields[0]
        .problem;
  };
  EXPECT_NE(problem().english().find("the first of 2 such points"), std::string::npos) << problem();
  settings.refuses_close_points = false;
  EXPECT_EQ(problem(), "");
}

// In a scene of kilometres rays begin millimetres off an opening.
TEST(SourceProblem, NamesWhatRaysWouldPass) {
  const calc::PhotometricWeb down = lambert_web(1000, 9);
  const auto problem = [&](double below_m, double size_m) {
    calc::PreparedScene scene;
    scene.channels = {{"", 1.0}};
    add_luminaire(scene, down, {0, 0, 6});
    add_quad(scene, {-0.3, -0.3, 6 - below_m}, {0.6, 0, 0}, {0, 0.6, 0}, 0.0);
    set_extent(scene);
    scene.body_id = {"shield"};
    scene.extent_m = size_m;
    return calc::source_problem(calc::Tracer(scene));
  };
  EXPECT_NE(problem(0.004, 3000.0)
                .english()
                .find("'shield' is 0.004 m in front of the luminaire at (0 0 6) m"),
            std::string::npos);
  EXPECT_EQ(problem(0.004, 30.0), "");
  EXPECT_EQ(problem(0.04, 3000.0), "");
  EXPECT_EQ(problem(0.0, 3000.0), "") << "a ceiling that it is flush with";
  EXPECT_EQ(problem(-0.004, 3000.0), "") << "above it, where it sends no light";
}

}  // namespace
}  // namespace point_problem_test
