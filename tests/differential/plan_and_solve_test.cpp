// What the plan says is left out is what the calculation leaves out, for every quantity that a
// plane may measure: the counters of the calculation against the plan.
#include "calc/forecast/scene_plan.h"
#include "calc/radiosity/looks/solve.h"
#include "tests/support/scenes.h"
#include "tests/unit/calc/proofs/proof_scenes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace plan_and_solve_test {
namespace {

using namespace proof_scenes;
using calc::DerivedQuantity;
using calc::ReceiverKernel;

struct Quantity {
  std::string name;
  ReceiverKernel kernel;
  DerivedQuantity derived;
};
const std::vector<Quantity> kQuantities{
    {"planar", ReceiverKernel::planar, DerivedQuantity::none},
    {"cylindrical", ReceiverKernel::cylindrical, DerivedQuantity::none},
    {"semicylindrical", ReceiverKernel::semicylindrical, DerivedQuantity::none},
    {"hemispherical", ReceiverKernel::hemispherical, DerivedQuantity::none},
    {"scalar", ReceiverKernel::scalar, DerivedQuantity::none},
    {"modelling", ReceiverKernel::cylindrical, DerivedQuantity::modelling},
    {"four planes", ReceiverKernel::cylindrical, DerivedQuantity::four_planes},
    {"ugr", ReceiverKernel::planar, DerivedQuantity::ugr}};

class PlanAndSolve : public ::testing::Test {
 protected:
  PlanAndSolve()
      : point(test_support::lambert_web(300, 9)),
        panel(test_support::lambert_web(300, 9, {calc::OpeningShape::rectangle, 0.6, 0.6, 0.0})) {
    settings.first_paths = settings.max_paths = 128;
    settings.replicates = 4;
  }

  calc::PreparedScene room(const calc::PhotometricWeb& web, double reflectance) const {
    calc::PreparedScene scene;
    test_support::add_box(scene, {-2, -2, 0}, {4, 4, 3}, reflectance);
    test_support::add_luminaire(scene, web, {0.3, 0.2, 2.0});
    test_support::set_extent(scene);
    return scene;
  }

  void expect_agreement(const calc::PreparedScene& scene, const std::string& name) const {
    const std::vector<calc::SensorGrid> places{
        work_plane(-1.5, 1.5, 0.8, 3),                                      // inside
        square_grid({-2, -1.5, 0.5}, {0, 3, 0}, {0, 0, 2}, {1, 0, 0}, 3),   // on a wall
        square_grid({-1, -1, 3}, {2, 0, 0}, {0, 2, 0}, {0, 0, -1}, 3),      // on the ceiling
        square_grid({2.5, -1, 0.5}, {0, 2, 0}, {0, 0, 2}, {-1, 0, 0}, 3)};  // outside
    for (std::size_t place = 0; place < places.size(); ++place) {
      for (const Quantity& quantity : kQuantities) {
        SCOPED_TRACE(name + ", place " + std::to_string(place) + ", " + quantity.name);
        calc::SensorGrid grid = places[place];
        grid.kernel = quantity.kernel;
        grid.derived = quantity.derived;
        const std::vector<calc::PlaneTask> tasks{{"plane", &grid}};
        const calc::ScenePlan plan = calc::make_scene_plan(scene, tasks, settings);
        const auto gatherer = calc::make_cpu_gatherer();
        const calc::SpaceSolution solution = calc::solve_illuminance(
            scene, tasks, settings, 0.95, *gatherer,
            [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; },
            {});
        const calc::PlaneField& field = solution.fields[0];
        if (!field.problem.empty()) continue;
        const calc::SolveCounters& rays = field.counters;
        const calc::PlaneWorkload& load = plan.workload.planes[0];
        EXPECT_EQ(plan.planes[0].is_exact, field.stop == calc::StopReason::exact);
        if (load.is_unobstructed) {
          EXPECT_EQ(rays.direct_rays, 0u);
          EXPECT_EQ(rays.connection_rays, 0u);
        }
        // Light that is 0 by the photometric table needs no ray; dark_pairs says so beforehand.
        // So does a luminaire of which an eye sees nothing that counts.
        const bool knows_dark = settings.skips.allows(calc::Skip::dark_pairs) &&
                                quantity.derived != DerivedQuantity::ugr;
        if (plan.first_look.work.direct_rays == 0.0 || knows_dark) {
          EXPECT_EQ(plan.first_look.work.direct_rays == 0.0, rays.direct_rays == 0);
        }
        EXPECT_EQ(plan.first_look.work.connection_rays == 0.0, rays.connection_rays == 0);
        EXPECT_EQ(plan.first_look.work.pool_rays == 0.0, solution.pool_rays == 0);
      }
    }
  }

  calc::PhotometricWeb point, panel;
  calc::RadiositySettings settings;
};

TEST_F(PlanAndSolve, AgreeInAnEmptyRoom) {
  expect_agreement(room(point, 0.5), "a point");
  expect_agreement(room(panel, 0.5), "a panel");
}

TEST_F(PlanAndSolve, AgreeWhereSomethingStandsInTheRoom) {
  calc::PreparedScene scene = room(panel, 0.5);
  test_support::add_box(scene, {0.5, 0.5, 0}, {0.5, 0.5, 1}, 0.3);
  expect_agreement(scene, "furnished");
}

TEST_F(PlanAndSolve, AgreeInABlackRoom) {
  expect_agreement(room(point, 0.0), "black, a point");
  expect_agreement(room(panel, 0.0), "black, a panel");
}

TEST_F(PlanAndSolve, AgreeWhereNothingMayBeLeftOut) {
  settings.skips.forbid_all();
  expect_agreement(room(panel, 0.5), "nothing left out");
  expect_agreement(room(point, 0.0), "nothing left out, black");
}

}  // namespace
}  // namespace plan_and_solve_test
