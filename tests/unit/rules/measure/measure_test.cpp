#include "rules/measure/measure.h"

#include "calc/glare/field_glare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rules::measure_test {
namespace {

using testing::ElementsAre;

// A plane of 4 m x 3 m with a point in the middle of every square metre.
calc::SensorGrid grid_of_twelve() {
  calc::SensorGrid grid;
  grid.columns = 4;
  grid.rows = 3;
  grid.spacing_u_m = grid.spacing_v_m = 1.0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      grid.position_m.emplace_back(column + 0.5, row + 0.5, 0.0);
    }
  }
  return grid;
}

// Exact direct light of 1, 2, ... 12 lx, and reflected light in two replicates.
calc::PlaneField field_of_twelve() {
  calc::PlaneField field;
  field.points = 12;
  field.replicates = 2;
  field.channels = {{"", 0.5}};
  for (int i = 1; i <= 12; ++i) field.direct_exact_lx.push_back(i);
  for (int i = 0; i < 24; ++i) field.indirect_lx.push_back(i < 12 ? 99.0 : 101.0);
  return field;
}

Requirement minimum_at_least(double limit) {
  Requirement requirement;
  requirement.metric = Metric::minimum;
  requirement.state = LightState::initial;
  requirement.limit = limit;
  return requirement;
}

TEST(Measure, CountsThePointsOfTheMaskOnly) {
  Requirement requirement = minimum_at_least(1);
  requirement.mask = {"inner", {{MaskStep::inset, 0.6, 0, 0}}};
  requirement.direct_only = true;
  const Measurement result = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  ASSERT_TRUE(result.metric.has_value());
  EXPECT_EQ(result.metric->estimate.value, 6.0);  // points 5 and 6 of 0 ... 11
  EXPECT_EQ(result.metric->point, 5u);
  EXPECT_EQ(result.points_used, 2u);
}

// A place over a point is not its place: what is asked of eyes is not what a desk gets.
TEST(Measure, AValueIsThatOfAPlaceInThePlane) {
  const calc::SensorGrid grid = grid_of_twelve();
  const auto measured = [&](const glm::dvec3& off_m) {
    Requirement requirement = minimum_at_least(1);
    requirement.metric = Metric::value_at_point;
    requirement.direct_only = true;
    requirement.arguments = PointOfValue{grid.position_m[6] + off_m, {}};
    return measure(requirement, grid, field_of_twelve(), {}, 0.95);
  };
  const glm::dvec3 across = glm::cross(grid.u, grid.v);
  const double half_m = 0.5 * grid.spacing_u_m;
  ASSERT_GT(half_m, 0.06);
  EXPECT_TRUE(measured(half_m * grid.u).metric);
  EXPECT_TRUE(measured(0.05 * across).metric);
  EXPECT_TRUE(measured(-0.05 * across).metric);
  EXPECT_FALSE(measured(0.051 * across).metric);
  EXPECT_FALSE(measured(-0.051 * across).metric);
  EXPECT_THAT(measured(1.15 * across).reason.english(),
              testing::HasSubstr("along the plane and 0.05 m "
                                 "across it of"));
  EXPECT_THAT(measured(1.15 * across).reason.english(),
              testing::EndsWith("the plane is 1.150 m away"));
}

TEST(Measure, ASinglePointHasNoUniformity) {
  const calc::SensorGrid grid = grid_of_twelve();
  Requirement requirement = minimum_at_least(0.1);
  requirement.direct_only = true;
  for (const Metric metric : {Metric::uniformity_min_avg, Metric::uniformity_min_max}) {
    requirement.metric = metric;
    requirement.mask = {"inner", {{MaskStep::inset, 0.6, 0, 0}}};
    EXPECT_TRUE(measure(requirement, grid, field_of_twelve(), {}, 0.95).metric) << "two points";
  }
  calc::SensorGrid one = grid;
  calc::PlaneField field = field_of_twelve();
  one.position_m.resize(1);
  one.column.resize(1);
  one.row.resize(1);
  one.normal.resize(std::min<std::size_t>(one.normal.size(), 1));
  field.points = 1;
  field.direct_exact_lx.resize(1);
  requirement.mask = {};
  for (const Metric metric : {Metric::uniformity_min_avg, Metric::uniformity_min_max}) {
    requirement.metric = metric;
    const Measurement result = measure(requirement, one, field, {}, 0.95);
    EXPECT_FALSE(result.metric);
    EXPECT_THAT(result.reason.english(), testing::HasSubstr("a single point has no uniformity"));
  }
  requirement.metric = Metric::average;
  EXPECT_TRUE(measure(requirement, one, field, {}, 0.95).metric);
}

TEST(Measure, AValueUnderAMaskIsThatOfItsPoint) {
  const calc::SensorGrid grid = grid_of_twelve();
  Requirement requirement = minimum_at_least(1);
  requirement.metric = Metric::value_at_point;
  requirement.mask = {"inner", {{MaskStep::inset, 0.6, 0, 0}}};
  requirement.direct_only = true;
  requirement.arguments = PointOfValue{grid.position_m[6], {}};
  const Measurement inner = measure(requirement, grid, field_of_twelve(), {}, 0.95);
  ASSERT_TRUE(inner.metric.has_value());
  EXPECT_EQ(inner.metric->estimate.value, 7.0);
  EXPECT_EQ(inner.metric->point, 6u);
  requirement.arguments = PointOfValue{grid.position_m[0], {}};
  const Measurement outer = measure(requirement, grid, field_of_twelve(), {}, 0.95);
  EXPECT_FALSE(outer.metric.has_value());
  EXPECT_EQ(outer.reason, "the requirement's mask excludes the point");
}

TEST(Measure, PowerPer100LuxFallsWithTheAverage) {
  Requirement requirement = minimum_at_least(1);
  requirement.metric = Metric::power_per_100_lx;
  requirement.arguments = SpacePower{13.0};
  requirement.direct_only = true;
  const calc::Estimate exact =
      measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate;
  EXPECT_DOUBLE_EQ(exact.value, 200.0);  // 6.5 lx
  EXPECT_EQ(exact.low, exact.high);
  requirement.direct_only = false;
  Requirement average = requirement;
  average.metric = Metric::average;
  const calc::Estimate power =
      measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate;
  const calc::Estimate lx =
      measure(average, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate;
  EXPECT_DOUBLE_EQ(power.low, 1300.0 / lx.high);
  EXPECT_DOUBLE_EQ(power.high, 1300.0 / lx.low);
  EXPECT_LT(power.low, power.value);
  // What tells two results apart is in W/m2 per 100 lx, too.
  const Measurement of_power = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  const Measurement of_lx = measure(average, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  ASSERT_FALSE(of_power.without_replicate.empty());
  for (std::size_t r = 0; r < of_power.without_replicate.size(); ++r) {
    EXPECT_DOUBLE_EQ(of_power.without_replicate[r], 1300.0 / of_lx.without_replicate[r]);
  }
}

// Of the veil's ends and those of the average, the other way about; nothing in view is met.
TEST(Measure, GlareOfAFieldFallsWithTheAverage) {
  Requirement requirement = minimum_at_least(1);
  requirement.metric = Metric::glare_rating;
  requirement.arguments = LitField{0.25, {1.0, 0.9, 1.2}};
  Requirement average = requirement;
  average.metric = Metric::average;
  const calc::Estimate lx =
      measure(average, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate;
  const calc::Estimate glare =
      measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate;
  EXPECT_LT(lx.low, lx.high);
  EXPECT_DOUBLE_EQ(glare.value, calc::field_glare(1.0, lx.value, 0.25));
  EXPECT_DOUBLE_EQ(glare.low, calc::field_glare(0.9, lx.high, 0.25));
  EXPECT_DOUBLE_EQ(glare.high, calc::field_glare(1.2, lx.low, 0.25));
  requirement.arguments = LitField{0.25, {}};
  const Measurement none = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  EXPECT_EQ(none.nothing_there, "no luminaire in an eye's view shines towards that eye");
  EXPECT_TRUE(calc::is_nothing(none.metric->estimate));
  EXPECT_TRUE(none.without_replicate.empty());
  // What a rule requires of an area it requires of all of it.
  calc::SensorGrid part = grid_of_twelve();
  part.missed_m2 = 1.0;
  requirement.origin.pack = "en12464-2:2014";
  EXPECT_FALSE(measure(requirement, part, field_of_twelve(), {}, 0.95).metric.has_value());
  requirement.origin.pack.clear();
  requirement.arguments = LitField{0.25, {0.0, 0.0, 1.2}};  // by one reading there is none
  const Measurement perhaps = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  EXPECT_TRUE(calc::is_nothing(perhaps.metric->estimate));
  EXPECT_DOUBLE_EQ(perhaps.metric->estimate.high, calc::field_glare(1.2, lx.low, 0.25));
  EXPECT_EQ(perhaps.nothing_there, "");
  EXPECT_TRUE(perhaps.without_replicate.empty());
}

TEST(Measure, PowerDensityIsKnownBeforehand) {
  Requirement requirement = minimum_at_least(1);
  requirement.metric = Metric::power_density;
  requirement.of_space = {6.5, 6.5, 6.5};
  const Measurement result = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  ASSERT_TRUE(result.metric.has_value());
  EXPECT_EQ(result.metric->estimate.low, 6.5);
  EXPECT_EQ(result.metric->estimate.high, 6.5);
  EXPECT_EQ(result.active, std::vector<std::uint8_t>(12, 0));
}

TEST(Measure, EnergyIsKnownBeforehand) {
  Requirement requirement = minimum_at_least(1);
  requirement.metric = Metric::leni;
  requirement.of_space = {11.9, 11.9, 11.9};
  const Measurement result = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  ASSERT_TRUE(result.metric.has_value());
  EXPECT_EQ(result.metric->estimate.value, 11.9);
  EXPECT_EQ(result.metric->estimate.high, 11.9);
  EXPECT_EQ(result.active, std::vector<std::uint8_t>(12, 0));
}

// What a rule requires of an area it requires of all of it; the project's own limits are about its
// points.
TEST(Measure, OfARulePackNeedsPointsEverywhere) {
  Requirement requirement = minimum_at_least(1);
  calc::SensorGrid grid = grid_of_twelve();
  grid.missed_m2 = 0.8;
  EXPECT_TRUE(measure(requirement, grid, field_of_twelve(), {}, 0.95).metric.has_value());
  requirement.origin.pack = "own:1";
  const Measurement result = measure(requirement, grid, field_of_twelve(), {}, 0.95);
  EXPECT_FALSE(result.metric.has_value());
  EXPECT_THAT(result.reason.english(),
              testing::HasSubstr("0.8 m² of the area have no calculation point"));
  EXPECT_EQ(result.unseen_points, 0u);  // more samples do not help
}

TEST(Measure, LeavesReflectedLightOut) {
  Requirement requirement = minimum_at_least(1);
  EXPECT_EQ(
      measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate.value,
      101.0);
  requirement.direct_only = true;
  const Measurement direct = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  EXPECT_EQ(direct.metric->estimate.low, 1.0);  // exact
  EXPECT_EQ(direct.metric->estimate.high, 1.0);
  requirement.state = LightState::end_of_duration;  // times the maintenance factor
  EXPECT_EQ(
      measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95).metric->estimate.value,
      0.5);
}

TEST(Measure, OfDirectLightDoubtsWhatNoDirectSampleReached) {
  calc::PlaneField field = field_of_twelve();
  field.direct_exact_lx.assign(12, 0.0);
  field.direct_sampled_lx.assign(24, 5.0);
  field.direct_sampled_lx[3] = field.direct_sampled_lx[15] = 0.0;
  field.largest_share.assign(12, 0.09F);
  Requirement requirement = minimum_at_least(1);
  requirement.direct_only = true;
  const Measurement result = measure(requirement, grid_of_twelve(), field, {}, 0.95);
  EXPECT_EQ(result.unseen_points, 1u);
}

TEST(Measure, WorksOnAtPointsOfTheMask) {
  Requirement requirement = minimum_at_least(105.5);
  requirement.mask = {"inner", {{MaskStep::inset, 0.6, 0, 0}}};
  const Measurement result = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  EXPECT_THAT(result.active, ElementsAre(0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0));
}

TEST(Measure, DoesNothingForWhatCannotBeJudged) {
  Requirement requirement = minimum_at_least(1);
  requirement.problem = calc::Message::words("no daylight");
  const Measurement result = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  EXPECT_FALSE(result.metric.has_value());
  EXPECT_EQ(result.reason, "no daylight");
}

TEST(Measure, SharesOfPoints) {
  Requirement requirement = minimum_at_least(0.5);
  requirement.metric = Metric::share;
  requirement.arguments = ValueRange{7.0};
  requirement.direct_only = true;
  const Measurement result = measure(requirement, grid_of_twelve(), field_of_twelve(), {}, 0.95);
  EXPECT_EQ(result.metric->estimate.value, 0.5);
  EXPECT_EQ(result.metric->estimate.low, 0.5);
}

// A place on a route is in a cell, and at its height.
TEST(Measure, AValueOnARouteIsOfTheCellAround) {
  calc::EscapeRoute route;
  route.line = {{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 1.2};
  route.spacing = {1.0, 0.4, {}};
  route.is_spacing_given = true;
  calc::CalcPlane plane;
  plane.area = route;
  calc::Diagnostics diagnostics;
  const calc::SensorGrid grid = calc::make_sensor_grid(plane, calc::Space{}, diagnostics).value();
  calc::PlaneField field;
  field.points = grid.position_m.size();
  field.replicates = 2;
  field.channels = {{"", 1.0}};
  for (std::size_t i = 0; i < field.points; ++i) {
    field.direct_exact_lx.push_back(static_cast<double>(i));
  }
  const auto measured = [&](const glm::dvec3& at_m) {
    Requirement requirement = minimum_at_least(1);
    requirement.metric = Metric::value_at_point;
    requirement.arguments = PointOfValue{at_m, {}};
    return measure(requirement, grid, field, {}, 0.95);
  };
  const glm::dvec3 third = grid.position_m[2];
  EXPECT_EQ(measured(third + glm::dvec3(0.3, 0.15, 0)).metric->estimate.value, 2.0);
  // In the last cell of the outer row before the mitre, but nearer to the centre of the next one.
  EXPECT_EQ(measured({4.58, -0.585, 0}).metric->estimate.value, 4.0);
  EXPECT_FALSE(measured(third + glm::dvec3(0, 0, 0.2)).metric);
  EXPECT_FALSE(measured(third - glm::dvec3(0, 0.3, 0)).metric);
  EXPECT_THAT(measured({4.5, -5, 0}).reason.english(),
              testing::HasSubstr("no calculation point is within"));
}

}  // namespace
}  // namespace rules::measure_test
