#include "report/text/luminaire_aim.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace report::luminaires_csv_test {
namespace {

TEST(LuminaireAim, TiltAndTurn) {
  LuminaireMark mark;
  EXPECT_FALSE(aim_of(mark).tilt_deg.has_value());
  EXPECT_FALSE(aim_of(mark).turn_deg.has_value());
  mark.axis = {0, 0, -1};
  mark.c0 = {1, 0, 0};
  EXPECT_DOUBLE_EQ(aim_of(mark).tilt_deg.value(), 0.0);
  EXPECT_DOUBLE_EQ(aim_of(mark).turn_deg.value(), 0.0);
  const double half = std::sqrt(0.5);
  mark.axis = {half, 0, -half};
  mark.c0 = {0, -1, 0};
  EXPECT_NEAR(aim_of(mark).tilt_deg.value(), 45.0, 1e-9);
  EXPECT_EQ(aim_of(mark).heading_deg.value(), 0.0);
  EXPECT_NEAR(aim_of(mark).turn_deg.value(), 270.0, 1e-9);
  mark.axis = {0, 0, 1};  // uplight
  mark.c0 = {1, -1e-17, 0};
  EXPECT_NEAR(aim_of(mark).tilt_deg.value(), 180.0, 1e-9);
  EXPECT_EQ(aim_of(mark).turn_deg.value(), 0.0);  // not 360
  EXPECT_FALSE(aim_of(mark).heading_deg.has_value());
  mark.c0 = {0, 0, 1};
  EXPECT_FALSE(aim_of(mark).turn_deg.has_value());
}

TEST(LuminairesCsv, HasARowForEachWithWhatIsKnown) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  LuminaireRow type;
  type.type_id = "panel";
  type.maker = "Maker, Ltd";
  type.article_number = "=A1";
  type.flux_lm = 3600;
  type.power_w = 30;
  type.maintenance_factor = 0.8;
  type.name = "Panel";
  type.colour_temperature = "4000K";
  type.colour_rendering = "80";
  project.luminaires = {type};
  SpacePart& space = project.spaces[0];
  space.footprint_m = {{0, 0}, {5, 0}, {5, 4}};
  space.floor_z_m = 10.0;
  LuminaireMark mark{{1.5, 2.0, 12.5}, "panel"};
  mark.id = "L.1";
  mark.axis = {0, 0, -1};
  mark.c0 = {1, 0, 0};
  space.luminaires = {mark, {{1, 2, 3}, "gone"}};
  space.luminaires[0].label = "A12";
  const std::string csv = rendered("luminaires-csv", document);
  const std::string at = project.path + "," + space.id;
  EXPECT_THAT(csv, testing::StartsWith("project,space,number,id,type,maker,article,group,x_m,"));
  EXPECT_THAT(csv,
              testing::HasSubstr(
                  at + ",1,L.1,panel,\"Maker, "
                       "Ltd\",'=A1,,1.5,2,12.5,2.5,0,,0,3600,30,0.8,A,Panel,120,4000,80,A12\r\n"));
  EXPECT_THAT(csv, testing::EndsWith(at + ",2,,gone,,,,1,2,3,-7,,,,,,,,,,,,\r\n"));
  // What to order where the project takes a package.
  project.luminaires[0].package = "warm-900";
  EXPECT_THAT(rendered("luminaires-csv", document),
              testing::HasSubstr("\"Maker, Ltd\",warm-900,,1.5"));
}

}  // namespace
}  // namespace report::luminaires_csv_test
