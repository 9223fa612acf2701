#include "calc/forecast/memory_need.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace calc::memory_need_test {
namespace {

CalcPlane plane_of(int columns, int rows, DerivedQuantity derived = DerivedQuantity::none) {
  PlanarArea area;
  area.outline_m = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  area.grid = GridByCount{columns, rows};
  CalcPlane plane;
  plane.area = area;
  plane.derived = derived;
  return plane;
}

Space space_of(int columns, int rows) {
  Space space;
  space.planes.push_back(plane_of(columns, rows));
  return space;
}

Project project_of(std::vector<Space> spaces) {
  Project project;
  project.path = "p.xml";
  project.spaces = std::move(spaces);
  return project;
}

std::string refusal(const Project& project, const Budget& budget) {
  Diagnostics diagnostics;
  const bool fits = need_within(project, 16, budget, diagnostics).has_value();
  EXPECT_EQ(fits, !diagnostics.has_errors());
  return fits ? "" : format_diagnostic(diagnostics.all().front());
}

TEST(MemoryNeed, CountsPointsOfAllPlanes) {
  const Project project = project_of({space_of(100, 10), space_of(7, 3)});
  EXPECT_EQ(need_of(project, 16, PointCount::exactly).points, 1021.0);
}

TEST(MemoryNeed, GrowsWithEverythingThatTakesIt) {
  const auto need = [](const Space& space, int replicates) {
    return need_of(project_of({space}), replicates, PointCount::exactly).memory.with(1);
  };
  const Space plain = space_of(100, 100);
  EXPECT_GT(need(space_of(100, 101), 16), need(plain, 16));
  EXPECT_GT(need(plain, 17), need(plain, 16));
  Space more = plain;
  more.luminaires.resize(1);
  EXPECT_GT(need(more, 16), need(plain, 16));
  more = plain;
  more.bodies.resize(1);
  const double with_body = need(more, 16);
  EXPECT_GT(with_body, need(plain, 16));
  more.bodies[0].triangle.resize(5);
  EXPECT_GT(need(more, 16), with_body);
  // Modelling needs two receivers at each point.
  Space derived;
  derived.planes.push_back(plane_of(100, 100, DerivedQuantity::modelling));
  EXPECT_GT(need(derived, 16), 1.5 * need(plain, 16) - 64.0 * (1 << 20));
}

// What was measured: a million points with 16 replicates took 1.38 GB, 1.2 million triangles
// 1.17 GB, 99,900 luminaires 0.35 GB. Less must not be believed, much more would refuse for
// nothing.
TEST(MemoryNeed, IsNotLessThanWhatWasMeasured) {
  const auto gb = [](const Space& space) {
    return need_of(project_of({space}), 16, PointCount::exactly).memory.with(1) / 1.0e9;
  };
  EXPECT_GE(gb(space_of(1000, 1000)), 1.38);
  EXPECT_LE(gb(space_of(1000, 1000)), 1.7);
  Space boxes = space_of(10, 10);
  boxes.bodies.resize(99'900);
  for (Body& body : boxes.bodies) body.triangle.resize(12);
  EXPECT_GE(gb(boxes), 1.17);
  EXPECT_LE(gb(boxes), 1.5);
  Space ceiling = space_of(10, 10);
  ceiling.luminaires.resize(99'900);
  EXPECT_GE(gb(ceiling), 0.35);
  EXPECT_LE(gb(ceiling), 0.5);
}

TEST(MemoryNeed, OnlySpacesAtTheSameTimeAddUp) {
  const Project project = project_of({space_of(100, 100), space_of(300, 300), space_of(200, 200)});
  const MemoryNeed need = need_of(project, 16, PointCount::exactly).memory;
  ASSERT_EQ(need.of_space.size(), 3u);
  EXPECT_GT(need.of_space[0], need.of_space[1]);
  EXPECT_GT(need.of_space[1], need.of_space[2]);
  EXPECT_EQ(need.with(1), need.held + need.of_space[0]);
  EXPECT_EQ(need.with(9), need.held + need.of_space[0] + need.of_space[1] + need.of_space[2]);
  Budget budget;
  budget[BudgetOf::memory] = need.with(2);
  EXPECT_EQ(spaces_within(need, budget, 9), 2u);
  budget[BudgetOf::memory] = need.with(2) - 1.0;
  EXPECT_EQ(spaces_within(need, budget, 9), 1u);
  budget[BudgetOf::memory] = need.with(3);
  EXPECT_EQ(spaces_within(need, budget, 2), 2u);
  EXPECT_EQ(spaces_within(need, budget, 0), 1u);
}

TEST(MemoryNeed, RefusesWhatIsBeyondTheBudget) {
  const Project project = project_of({space_of(100, 100), space_of(100, 100)});
  Budget budget;
  EXPECT_EQ(refusal(project, budget), "");
  budget[BudgetOf::points] = 20'000;
  EXPECT_EQ(refusal(project, budget), "");
  budget[BudgetOf::points] = 19'999;
  EXPECT_EQ(refusal(project, budget),
            "p.xml: error[beyond-limit]: the project takes 20000 calculation points; at most 19999 "
            "are allowed, see --limit points");
  budget = Budget();
  budget[BudgetOf::memory] = 65.0 * (1 << 20);
  EXPECT_NE(
      refusal(project, budget).find("of memory; at most 65 MiB are allowed, see --limit memory"),
      std::string::npos);
  Project endless = project;
  std::get<PlanarArea>(endless.spaces[0].planes[0].area).grid =
      GridBySpacing{std::numeric_limits<double>::denorm_min(), 1.0, {}};
  EXPECT_NE(refusal(endless, Budget()), "");
}

// An L that a rule's grid reaches everywhere: 49 times the points are possible, and not had.
TEST(MemoryNeed, CountsExactlyWhereTheMostIsTooMuch) {
  Space space = space_of(1, 1);
  auto& area = std::get<PlanarArea>(space.planes[0].area);
  area.outline_m = {{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}};
  area.grid = GridByRule();
  const Project project = project_of({space});
  const double exact = need_of(project, 16, PointCount::exactly).points;
  EXPECT_EQ(need_of(project, 16, PointCount::at_most).points, 49.0 * exact);
  Diagnostics diagnostics;
  Budget budget;
  budget[BudgetOf::points] = exact;
  const auto need = need_within(project, 16, budget, diagnostics);
  ASSERT_TRUE(need.has_value());
  EXPECT_EQ(need->points, exact);
  budget[BudgetOf::points] = exact - 1.0;
  EXPECT_FALSE(need_within(project, 16, budget, diagnostics).has_value());
}

TEST(Budget, TextsNameTheUnit) {
  EXPECT_EQ(budget_text(BudgetOf::points, 1.0e7), "10000000");
  EXPECT_EQ(budget_text(BudgetOf::memory, 8.0 * (1 << 30)), "8 GiB");
  EXPECT_EQ(budget_text(BudgetOf::output, 1.5 * (1 << 20)), "1.5 MiB");
  EXPECT_EQ(budget_text(BudgetOf::output, 2048.0), "2 KiB");
  EXPECT_EQ(budget_text(BudgetOf::output, 100.0), "100 bytes");
}

}  // namespace
}  // namespace calc::memory_need_test
