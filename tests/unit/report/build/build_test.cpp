#include "report/build/build.h"

#include "report/document/shown_plane.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace build_test {
namespace {

// Two channels (maintenance 0.5 and 1), two replicates, two points.
calc::PlaneField two_channel_field() {
  calc::PlaneField field;
  field.plane_id = "desk";
  field.points = 2;
  field.replicates = 2;
  field.channels = {{"", 0.5}, {"", 1.0}};
  field.direct_exact_lx = {100, 200, 10, 20};
  field.direct_sampled_lx = {4, 4, 0, 0, 8, 8, 0, 0};
  field.indirect_lx = {20, 40, 2, 4, 40, 80, 4, 8};
  return field;
}

calc::SensorGrid two_points() {
  calc::SensorGrid grid;
  grid.columns = 2;
  grid.rows = 1;
  grid.position_m = {{0.5, 0.5, 0.0}, {1.5, 0.5, 0.0}};
  grid.normal = {{0, 0, 1}, {0, 0, 1}};
  grid.column = {0, 1};
  grid.row = {0, 0};
  return grid;
}

TEST(BuildPlane, SplitsMaintainedLightIntoDirectAndIndirect) {
  const report::PlanePart part =
      report::build_plane(calc::CalcPlane{}, two_points(), two_channel_field(), {}, 0.95);
  ASSERT_EQ(part.points.size(), 2u);
  EXPECT_TRUE(part.is_computed);
  EXPECT_DOUBLE_EQ(part.points[0].direct_lx, 0.5 * (100 + 6) + 10);
  EXPECT_DOUBLE_EQ(part.points[0].indirect_lx, 0.5 * 30 + 3);
  EXPECT_DOUBLE_EQ(part.points[1].direct_lx, 0.5 * (200 + 6) + 20);
  EXPECT_DOUBLE_EQ(part.points[1].indirect_lx, 0.5 * 60 + 6);
  for (const report::PointRow& point : part.points) {
    EXPECT_NEAR(point.measured.value, point.direct_lx + point.indirect_lx, 1e-9);
    EXPECT_LT(point.measured.low, point.measured.value);
  }
  EXPECT_NEAR(part.average.value,
              0.5 * (part.points[0].measured.value + part.points[1].measured.value), 1e-9);
}

TEST(BuildPlane, KeepsWhatThePointsMeasure) {
  calc::CalcPlane plane;
  plane.kernel = calc::ReceiverKernel::cylindrical;
  EXPECT_EQ(report::build_plane(plane, two_points(), two_channel_field(), {}, 0.95).kernel,
            calc::ReceiverKernel::cylindrical);
  EXPECT_EQ(report::build_uncomputed_plane(plane, calc::Message::words("dark"), {}).kernel,
            calc::ReceiverKernel::cylindrical);
}

rules::Finding asked_of(const std::string& scene, bool direct_only = false,
                        rules::LightState state = rules::LightState::maintained) {
  rules::Finding finding;
  finding.requirement.scene = scene;
  finding.requirement.direct_only = direct_only;
  finding.requirement.state = state;
  return finding;
}

report::PlanePart asked_plane(std::vector<rules::Finding> findings) {
  calc::PlaneField field = two_channel_field();
  field.channels = {{"on", 0.5}, {"off", 1.0}};
  const std::vector<calc::LightScene> scenes{{"night", {{"on", 0.5}, {"off", 0.0}}, {}}};
  return report::build_plane(calc::CalcPlane{}, two_points(), field, std::move(findings), 0.95,
                             scenes);
}

TEST(BuildPlane, HasTheLightThatItsRequirementsAskFor) {
  const auto of_scene = asked_plane({asked_of("night"), asked_of("night")}).asked_light;
  ASSERT_TRUE(of_scene);
  EXPECT_EQ(of_scene->scene, "night");
  EXPECT_DOUBLE_EQ(of_scene->points[0].direct_lx, 0.5 * 0.5 * 106);
  EXPECT_DOUBLE_EQ(of_scene->points[1].indirect_lx, 0.5 * 0.5 * 60);
  EXPECT_NEAR(of_scene->points[0].measured.value, 0.25 * (106 + 30), 1e-9);
  EXPECT_NEAR(of_scene->average.value, 0.25 * 0.5 * (106 + 30 + 206 + 60), 1e-9);
  EXPECT_NEAR(of_scene->minimum.value, 0.25 * 136, 1e-9);
  EXPECT_LT(of_scene->points[0].measured.low, of_scene->points[0].measured.value);

  const auto direct = asked_plane({asked_of("night", true)}).asked_light;
  ASSERT_TRUE(direct);
  EXPECT_NEAR(direct->points[0].measured.value, 0.25 * 106, 1e-9);
  EXPECT_EQ(direct->points[0].indirect_lx, 0.0);
  const auto new_ones = asked_plane({asked_of("", false, rules::LightState::initial)}).asked_light;
  ASSERT_TRUE(new_ones);
  EXPECT_NEAR(new_ones->points[0].measured.value, 106 + 10 + 30 + 3, 1e-9);
}

TEST(BuildPlane, HasNoOtherLightWhereItsOwnIsAskedForOrSeveralAre) {
  EXPECT_FALSE(asked_plane({}).asked_light);
  EXPECT_FALSE(asked_plane({asked_of("")}).asked_light);
  EXPECT_FALSE(asked_plane({asked_of("night"), asked_of("")}).asked_light);
  EXPECT_FALSE(asked_plane({asked_of("night"), asked_of("night", true)}).asked_light);
  EXPECT_FALSE(asked_plane({asked_of("gone")}).asked_light);
  rules::Finding out = asked_of("night");
  out.requirement.any_one_unit_out = true;
  EXPECT_FALSE(asked_plane({out}).asked_light);
}

TEST(ShownPlane, IsInTheLightThatIsAskedFor) {
  const report::PlanePart part = asked_plane({asked_of("night")});
  const report::ShownPlane shown(part);
  const report::ShownPlane again(*shown);
  for (const report::PlanePart* plane : {&*shown, &*again}) {
    EXPECT_EQ(plane->points[1].measured.value, part.asked_light->points[1].measured.value);
    EXPECT_EQ(plane->points[1].direct_lx, part.asked_light->points[1].direct_lx);
    EXPECT_EQ(plane->average.value, part.asked_light->average.value);
    EXPECT_EQ(plane->asked_light->points[1].measured.value, part.points[1].measured.value);
    EXPECT_TRUE(plane->asked_light->is_shown);
  }
  const report::PlanePart plain = asked_plane({asked_of("")});
  EXPECT_EQ(&*report::ShownPlane(plain), &plain);
}

TEST(BuildPlane, ExactFieldsHaveNoInterval) {
  calc::PlaneField field = two_channel_field();
  field.direct_sampled_lx.clear();
  field.indirect_lx.clear();
  const report::PlanePart part =
      report::build_plane(calc::CalcPlane{}, two_points(), field, {}, 0.95);
  EXPECT_DOUBLE_EQ(part.points[0].measured.value, 60.0);
  EXPECT_EQ(part.points[0].measured.low, part.points[0].measured.high);
  EXPECT_DOUBLE_EQ(part.points[0].indirect_lx, 0.0);
  EXPECT_EQ(part.minimum.half_width(), 0.0);
}

// Half of the risk for each of two looks: t with one degree of freedom at 1 - 0.05 / 4.
TEST(BuildPlane, IntervalsHaveTheLevelOfOneLook) {
  calc::PlaneField field = two_channel_field();
  const auto reach_above_lx = [&field] {  // below, intervals end at 0 lx
    const calc::Estimate average =
        report::build_plane(calc::CalcPlane{}, two_points(), field, {}, 0.95).average;
    return average.high - average.value;
  };
  const double one_look_lx = reach_above_lx();
  field.looks_planned = 2;
  EXPECT_NEAR(reach_above_lx() / one_look_lx, 25.4517 / 12.7062, 1e-4);
  EXPECT_EQ(report::build_plane(calc::CalcPlane{}, two_points(), field, {}, 0.95).looks_planned, 2);
}

TEST(BuildPlane, CountsPointsThatCannotBeTrusted) {
  calc::PlaneField field = two_channel_field();
  field.unseen = {0, 1};
  field.largest_share = {0.1F, 0.5F};
  const report::PlanePart part =
      report::build_plane(calc::CalcPlane{}, two_points(), field, {}, 0.95);
  EXPECT_EQ(part.unseen_points, 1u);
  EXPECT_EQ(part.single_sample_points, 1u);
}

TEST(BuildPlane, OutlineIsMovedToTheOriginOfTheGrid) {
  calc::CalcPlane plane;
  calc::PlanarArea area;
  area.origin_m = {10, 20, 1};
  area.u = {0, 1, 0};
  area.v = {-1, 0, 0};
  area.outline_m = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  area.holes_m = {{{1, 1}, {2, 1}, {2, 1.5}}};
  plane.area = area;
  calc::SensorGrid grid = two_points();
  grid.u = area.u;
  grid.v = area.v;
  grid.origin_m = area.origin_m + 0.5 * area.u + 0.25 * area.v;

  const report::PlanePart part = report::build_plane(plane, grid, two_channel_field(), {}, 0.95);
  ASSERT_EQ(part.outline_m.size(), 4u);
  EXPECT_DOUBLE_EQ(part.outline_m[0].x, -0.5);
  EXPECT_DOUBLE_EQ(part.outline_m[0].y, -0.25);
  EXPECT_DOUBLE_EQ(part.outline_m[2].x, 3.5);
  EXPECT_DOUBLE_EQ(part.outline_m[2].y, 1.75);
  ASSERT_EQ(part.holes_m.size(), 1u);
  EXPECT_DOUBLE_EQ(part.holes_m[0][0].x, 0.5);
}

TEST(BuildPlane, UncomputedPlaneKeepsItsReasonAndFindings) {
  calc::CalcPlane plane;
  plane.id = "desk";
  const report::PlanePart part = report::build_uncomputed_plane(
      plane, calc::Message::words("no points"), std::vector<rules::Finding>(2));
  EXPECT_FALSE(part.is_computed);
  EXPECT_EQ(part.reason, "no points");
  EXPECT_EQ(part.findings.size(), 2u);
  EXPECT_TRUE(part.points.empty());
}

TEST(BuildProject, LuminaireRowsCountUseAndApplyTheFluxOverride) {
  calc::Project project;
  project.webs.push_back(calc::PhotometricWeb::make(
      {0.0}, {0.0, std::numbers::pi}, {100.0, 100.0}, calc::LuminousOpening{},
      calc::PhotometrySource{"EULUMDAT", "Lamp", "", 0, 0, "", ""}));
  calc::LuminaireType type;
  type.id = "A";
  type.photometry_file = "lamps/a.ldt";
  type.flux_scale = 2.0;
  type.power_w = 30.0;
  type.maintenance.product = 0.8;
  project.luminaire_types = {type};
  project.inputs = {{"/home/office/project.xml", "00"}, {"/home/office/lamps/a.ldt", "ab"}};
  project.spaces.resize(2);
  project.spaces[0].luminaires.resize(3);
  project.spaces[1].luminaires.resize(1);

  const report::ProjectPart part = report::build_project(project);
  ASSERT_EQ(part.luminaires.size(), 1u);
  EXPECT_EQ(part.luminaires[0].count, 4);
  EXPECT_NEAR(part.luminaires[0].flux_lm, 800.0 * std::numbers::pi, 1e-6);
  EXPECT_DOUBLE_EQ(part.luminaires[0].max_intensity_cd, 200.0);
  EXPECT_DOUBLE_EQ(part.luminaires[0].maintenance_factor, 0.8);
  EXPECT_EQ(part.luminaires[0].sha256, "ab");
  EXPECT_EQ(part.luminaires[0].name, "Lamp");
}

}  // namespace
}  // namespace build_test
