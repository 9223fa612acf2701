#include "report/document/road_facts.h"

#include "tests/support/sample_road.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace report::road_facts_test {
namespace {

TEST(RoadFacts, PowerIsOfOneLuminaireOfEachRowAndSpacing) {
  const SpacePart space = sample_road();
  const RoadFacts facts = road_facts(space);
  EXPECT_EQ(facts.luminaires, 2);
  EXPECT_DOUBLE_EQ(facts.power_w.value(), 150.0);
  EXPECT_DOUBLE_EQ(facts.power_w_km(*space.road).value(), 5000.0);
}

// By hand: 150 W / (20 lx 210 m2 + 10 lx 60 m2), with both ends of the illuminances.
TEST(RoadFacts, PowerDensityIsByTheLightOfAllAreas) {
  const SpacePart space = sample_road();
  const RoadFacts facts = road_facts(space);
  const calc::Estimate density = facts.power_density_w_lx_m2.value();
  EXPECT_DOUBLE_EQ(density.value, 150.0 / 4800.0);
  EXPECT_DOUBLE_EQ(density.low, 150.0 / (21.0 * 210.0 + 10.5 * 60.0));
  EXPECT_DOUBLE_EQ(density.high, 150.0 / (19.0 * 210.0 + 9.5 * 60.0));
}

// 150 W for 4000 h are 600 kWh, on 270 m2.
TEST(RoadFacts, EnergyIsByAllAreas) {
  const SpacePart space = sample_road();
  EXPECT_DOUBLE_EQ(road_facts(space).m2, 270.0);
  EXPECT_DOUBLE_EQ(road_facts(space).energy_kwh_m2(4000.0).value(), 600.0 / 270.0);
}

// The footway is from -2.5 m to 0.5 m: together 9.5 m of 30 m.
TEST(RoadFacts, AreasThatOverlapCountOnce) {
  SpacePart space = sample_road();
  EXPECT_FALSE(road_facts(space).do_areas_overlap);
  space.road->areas[1].to_y_m = 1e-12;
  EXPECT_FALSE(road_facts(space).do_areas_overlap);
  space.road->areas[1].to_y_m = 0.5;
  EXPECT_TRUE(road_facts(space).do_areas_overlap);
  EXPECT_DOUBLE_EQ(road_facts(space).m2, 285.0);
  EXPECT_DOUBLE_EQ(road_facts(space).energy_kwh_m2(4000.0).value(), 600.0 / 285.0);
  EXPECT_FALSE(road_facts(space).power_density_w_lx_m2);
}

TEST(RoadFacts, WhatIsNoFiniteNumberIsNotKnown) {
  SpacePart space = sample_road();
  space.road->rows[0].power_w = space.road->rows[1].power_w = 1e308;
  EXPECT_FALSE(road_facts(space).power_w);
  space.road->rows[1].power_w = 1.0;
  EXPECT_TRUE(road_facts(space).power_w);
  EXPECT_FALSE(road_facts(space).power_w_km(*space.road));
  EXPECT_FALSE(road_facts(space).energy_kwh_m2(1e6));
  space = sample_road();
  space.road->areas[1].from_y_m = -1e308;
  EXPECT_FALSE(road_facts(space).energy_kwh_m2(4000.0));
  EXPECT_FALSE(road_facts(space).power_density_w_lx_m2);
}

TEST(RoadFacts, HaveNoPowerDensityWithoutAPowerOrALight) {
  SpacePart space = sample_road();
  space.road->rows[1].power_w = 0.0;
  EXPECT_FALSE(road_facts(space).power_w);
  EXPECT_FALSE(road_facts(space).power_density_w_lx_m2);
  EXPECT_FALSE(road_facts(space).energy_kwh_m2(4000.0));
  space = sample_road();
  space.planes[1].is_computed = false;
  EXPECT_TRUE(road_facts(space).power_w);
  EXPECT_FALSE(road_facts(space).power_density_w_lx_m2);
  space.planes.pop_back();  // not chosen
  EXPECT_FALSE(road_facts(space).power_density_w_lx_m2);
  EXPECT_EQ(road_facts(space).areas[1].plane, nullptr);
}

TEST(RoadFacts, ClassesAreThoseOfRulePacksOnce) {
  SpacePart space = sample_road();
  space.planes[0].findings.push_back(space.planes[0].findings[0]);
  space.planes[0].findings[0].requirement.clause =
      calc::Message::words("EN 13201-2:2015 M4 [one public source]");
  space.planes[0].findings.push_back(
      sample_finding(rules::Metric::average, 10.0, estimate(20.0, 0.0), "our own"));
  const std::vector<calc::Message> classes = road_facts(space).areas[0].classes;
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].english(), "EN 13201-2:2015 M4");
}

TEST(RoadFacts, ArrangementFollowsFromSidesAndShifts) {
  SpacePart space = sample_road();
  std::vector<RoadRowPart>& rows = space.road->rows;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::opposite);
  rows[1].shift_m = 15.0;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::staggered);
  // A whole spacing is no distance, and -15 m are 15 m.
  rows[1].shift_m = 30.0 - 1e-12;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::opposite);
  rows[0].shift_m = 20.0;
  rows[1].shift_m = 5.0;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::staggered);
  rows[0].shift_m = 0.0;
  rows[1].shift_m = 10.0;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::other);
  rows[1].y_m = 0.5;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::other);
  rows.pop_back();
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::right);
  rows[0].y_m = 8.0;
  EXPECT_EQ(road_facts(space).arrangement, RoadArrangement::left);
}

TEST(RoadFacts, ShiftsAreWithinASpacing) {
  EXPECT_DOUBLE_EQ(first_shift_m(12.0, 30.0), 12.0);
  EXPECT_DOUBLE_EQ(first_shift_m(30.0, 30.0), 0.0);
  EXPECT_DOUBLE_EQ(first_shift_m(-5.0, 30.0), 25.0);
  EXPECT_DOUBLE_EQ(first_shift_m(65.0, 30.0), 5.0);
  EXPECT_EQ(first_shift_m(-1e-17, 30.0), 0.0);
}

TEST(RoadFacts, OverhangAndTiltAreTowardsTheStreet) {
  const SpacePart space = sample_road();
  const RoadPart& road = *space.road;
  EXPECT_DOUBLE_EQ(overhang_m(road, road.rows[0]), 0.5);
  EXPECT_DOUBLE_EQ(overhang_m(road, road.rows[1]), -0.25);
  EXPECT_DOUBLE_EQ(street_tilt_deg(road, road.rows[0]), 5.0);
  EXPECT_DOUBLE_EQ(street_tilt_deg(road, road.rows[1]), 5.0);
}

// The lowest luminance and uniformities, the highest glare, the darker edge; equal ones together.
TEST(RoadFacts, TheWorstObserverDecides) {
  const SpacePart space = sample_road();
  const std::vector<RoadFacts::Observer> observers = road_facts(space).observers;
  ASSERT_EQ(observers.size(), 2U);
  EXPECT_TRUE(observers[0].of_average);
  EXPECT_FALSE(observers[1].of_average);
  EXPECT_FALSE(observers[0].of_uo);
  EXPECT_TRUE(observers[1].of_uo);
  EXPECT_TRUE(observers[0].of_ul);
  EXPECT_TRUE(observers[1].of_ul);
  EXPECT_FALSE(observers[0].of_ti);
  EXPECT_TRUE(observers[1].of_ti);
  EXPECT_DOUBLE_EQ(observers[0].edge_ratio->value, 0.6);
  EXPECT_DOUBLE_EQ(observers[1].edge_ratio->value, 0.4);
  EXPECT_FALSE(observers[0].of_edge_ratio);
  EXPECT_TRUE(observers[1].of_edge_ratio);
}

TEST(RoadFacts, ADriverAtTheOtherEndMaySeeTheSame) {
  SpacePart space = sample_road();
  std::vector<calc::RoadObserver>& seen = space.road->light.observers;
  EXPECT_FALSE(road_facts(space).observers[1].same_as);
  seen[1].cd_m2.assign(seen[0].cd_m2.rbegin(), seen[0].cd_m2.rend());
  EXPECT_EQ(road_facts(space).observers[1].same_as, 0U);
  seen[1].cd_m2[3] *= 1.001;
  EXPECT_FALSE(road_facts(space).observers[1].same_as);
}

TEST(RoadFacts, TheStrictestRequirementIsShown) {
  SpacePart space = sample_road();
  const RoadFacts one = road_facts(space);
  EXPECT_EQ(road_requirement(one, rules::Metric::edge_ratio), nullptr);
  EXPECT_DOUBLE_EQ(road_requirement(one, rules::Metric::road_luminance)->limit, 0.75);
  space.planes[0].findings.push_back(
      sample_finding(rules::Metric::road_luminance, 1.0, estimate(0.8, 0.0)));
  const RoadFacts two = road_facts(space);
  EXPECT_DOUBLE_EQ(road_requirement(two, rules::Metric::road_luminance)->limit, 1.0);
}

TEST(RoadFacts, OfARoomAreNothing) {
  const RoadFacts facts = road_facts(small_document().projects[0].spaces[0]);
  EXPECT_TRUE(facts.areas.empty());
  EXPECT_FALSE(facts.power_w);
}

}  // namespace
}  // namespace report::road_facts_test
