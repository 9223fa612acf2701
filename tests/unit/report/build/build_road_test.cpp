#include "report/build/build_road.h"

#include "calc/road/road_values.h"
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/support/memory_file_reader.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace report::build_road_test {
namespace {

// Wide to both sides of the road and across it.
const std::string kLamp =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 -1 1 5 3 1 2 0.2 0.2 0\n1 1 80\n0 30 60 75 90\n0 90 180\n"
    "2000 2500 3000 500 0\n2000 2800 4500 1500 0\n2000 900 200 50 0\n";

std::optional<rules::JudgedProject> street(const std::string& attributes = "") {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='head' "
      "photometry='head.ies' power-w='60'/><scene id='night'><dim group='g' level='0.5'/></scene>"
      "<road id='a' name='A' width='7' lanes='2' oncoming-lanes='1' spacing='30' surface='R2' " +
      attributes +
      "><luminaire-row id='r' type='head' side='right' height='9' overhang='0.5' tilt='10' "
      "group='g'/><luminaire-row id='l' type='head' side='left' height='8' overhang='-1' "
      "tilt='5' shift='15'/><strip id='s' name='S' side='right' gap='0.5' width='2'/></road>"
      "</luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"head.ies", kLamp}});
  return rules::load_judged_project(files, "p.xml", rules::builtin_rule_packs(), diagnostics);
}

TEST(BuildRoad, HasRowsAndAreasAsTheProjectSays) {
  const auto judged = street("origin='3 4 0' rotation='90'");
  ASSERT_TRUE(judged);
  const auto road = build_road(judged->project, judged->project.spaces.at(0), {});
  ASSERT_TRUE(road);
  EXPECT_EQ(road->surface, "R2");
  EXPECT_DOUBLE_EQ(road->q0, 0.07);
  ASSERT_EQ(road->rows.size(), 2U);
  EXPECT_EQ(road->rows[0].type_id, "head");
  EXPECT_EQ(road->rows[0].group, "g");
  EXPECT_NEAR(road->rows[0].y_m, 0.5, 1e-12);
  EXPECT_NEAR(road->rows[0].tilt_deg, 10.0, 1e-9);
  EXPECT_NEAR(road->rows[1].y_m, 8.0, 1e-12);
  EXPECT_NEAR(road->rows[1].tilt_deg, -5.0, 1e-9);
  EXPECT_NEAR(road->rows[1].shift_m, 15.0, 1e-12);
  EXPECT_DOUBLE_EQ(road->rows[1].power_w, 60.0);
  EXPECT_DOUBLE_EQ(road->rows[1].maintenance_factor, 0.8);
  ASSERT_EQ(road->areas.size(), 2U);
  EXPECT_NEAR(road->areas[0].from_y_m, 0.0, 1e-12);
  EXPECT_NEAR(road->areas[0].to_y_m, 7.0, 1e-12);
  EXPECT_NEAR(road->areas[1].from_y_m, -2.5, 1e-12);
  EXPECT_NEAR(road->areas[1].to_y_m, -0.5, 1e-12);
}

// Of the scene that drivers' requirements ask for, and of full output where they ask for none.
TEST(BuildRoad, LightIsThatOfTheSceneAskedFor) {
  const auto judged = street();
  ASSERT_TRUE(judged);
  const calc::Space& space = judged->project.spaces.at(0);
  PlanePart plane;
  plane.findings.emplace_back().requirement.scene = "night";  // an illuminance
  const auto full = build_road(judged->project, space, {plane});
  plane.findings.emplace_back().requirement.metric = rules::Metric::road_luminance;
  plane.findings.back().requirement.scene = "night";
  const auto night = build_road(judged->project, space, {plane});
  EXPECT_EQ(full->scene, "");
  EXPECT_EQ(night->scene, "night");
  ASSERT_EQ(full->light.observers.size(), 2U);
  EXPECT_LT(night->light.observers[0].average_cd_m2.value,
            full->light.observers[0].average_cd_m2.value);
  const calc::RoadLight light =
      calc::road_light(calc::road_layout(judged->project, space, nullptr));
  EXPECT_EQ(full->light.observers[0].cd_m2, light.observers[0].cd_m2);
}

TEST(BuildRoad, OfARoomIsNothing) { EXPECT_FALSE(build_road(calc::Project(), calc::Space(), {})); }

}  // namespace
}  // namespace report::build_road_test
