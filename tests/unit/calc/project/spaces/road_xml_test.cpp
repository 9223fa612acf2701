// <road>: what is read, where its luminaires stand and look, and verbatim what is refused.

#include "calc/base/units.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace calc::tests::road_xml_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kRow = "<luminaire-row id='r' type='spot' side='right' height='10'/>";

// attributes: of the road besides id, width, lanes, spacing and surface.
std::string road(const std::string& attributes, const std::string& inside = kRow,
                 const std::string& size = "width='7' lanes='2' spacing='30' surface='R3'") {
  return "<luxgate version='1' maintenance-factor='0.8'>\n<luminaire-type id='spot' "
         "photometry='spot.ies'/>\n<road id='a' " +
         size + " " + attributes + ">\n" + inside + "</road></luxgate>";
}

std::string messages_of(const std::string& xml) { return load(files_for_messages(xml)).messages; }

const std::vector<MessageCase> kCases{
    {"RoadWithoutRow", road("", ""),
     "dir/p.xml:3:1: error[missing-form]: <road> needs a <luminaire-row>"},
    {"RoadOfNoLane", road("", kRow, "width='7' lanes='0' spacing='30' surface='R3'"),
     "dir/p.xml:3:24: error[number-out-of-range]: attribute 'lanes' of <road>: 0 is not allowed; "
     "expected a whole number from 1"},
    {"RoadOfManyLanes", road("", kRow, "width='7' lanes='21' spacing='30' surface='R3'"),
     "dir/p.xml:3:24: error[number-out-of-range]: attribute 'lanes' of <road>: 21 is not allowed; "
     "expected a whole number from 1 to 20"},
    {"RoadOfUnknownSurface", road("", kRow, "width='7' lanes='2' spacing='30' surface='R5'"),
     "dir/p.xml:3:47: error[unknown-value]: attribute 'surface' of <road>: unknown value 'R5'; "
     "allowed: R1, R2, R3, R4, C1, C2, W3 or W4; did you mean 'R1'?"},
    {"RoadOfWideSpacing", road("", kRow, "width='7' lanes='2' spacing='501' surface='R3'"),
     "dir/p.xml:3:34: error[number-out-of-range]: attribute 'spacing' of <road>: 501 m is not "
     "allowed; expected from 4 m to 500 m"},
    {"RoadWithAllLanesAndMoreOncoming", road("oncoming-lanes='3'"),
     "dir/p.xml:3:60: error[number-out-of-range]: attribute 'oncoming-lanes' of <road>: 3 is not "
     "allowed; expected a whole number from 0 to 2"},
    {"RoadWithTrafficOfNobody", road("traffic='left'"),
     "dir/p.xml:3:60: error[missing-partner]: <road> has 'traffic' without 'oncoming-lanes'; "
     "the two belong together"},
    {"RoadWithWideStrip", road("left-strip='7.5'"),
     "dir/p.xml:3:60: error[number-out-of-range]: attribute 'left-strip' of <road>: 7.5 m is not "
     "allowed; expected 0, or from 1 m to the width of the carriageway"},
    {"RoadWithNarrowStrip", road("left-strip='0.5'"),
     "dir/p.xml:3:60: error[number-out-of-range]: attribute 'left-strip' of <road>: 0.5 m is not "
     "allowed; expected 0, or from 1 m to the width of the carriageway"},
    {"RoadOfOneWideLane", road("", kRow, "width='21' lanes='1' spacing='30' surface='R3'"),
     "dir/p.xml:3:25: error[number-out-of-range]: attribute 'lanes' of <road>: 1 is not allowed; "
     "expected lanes that are 1.5 m to 7 m wide; these lanes are 21 m wide"},
    {"RoadOfBrightSurface", road("q0='0.15'"),
     "dir/p.xml:3:60: error[number-out-of-range]: attribute 'q0' of <road>: 0.15 is not allowed; "
     "expected a number from 0.035 to 0.14, half to twice the value of surface R3"},
    {"RoadThatBeginsAtNoLuminaire",
     road("", "<luminaire-row id='r' type='spot' side='right' height='9' shift='5'/>"),
     "dir/p.xml:3:1: error[missing-form]: <road> needs a <luminaire-row> without 'shift': "
     "the field begins at its luminaire"},
    {"RoadTurnedTwice", road("rotation='361'"),
     "dir/p.xml:3:60: error[number-out-of-range]: attribute 'rotation' of <road>: 361 is not "
     "allowed; expected a number from -360 to 360 (degrees)"},
    {"RoadWithLowRow", road("", "<luminaire-row id='r' type='spot' side='right' height='1.5'/>"),
     "dir/p.xml:4:48: error[number-out-of-range]: attribute 'height' of <luminaire-row>: 1.5 m is "
     "not allowed; expected from 2 m to 60 m"},
    {"RoadWithRowInTheMiddle",
     road("", "<luminaire-row id='r' type='spot' side='middle' height='9'/>"),
     "dir/p.xml:4:35: error[unknown-value]: attribute 'side' of <luminaire-row>: unknown value "
     "'middle'; allowed: right or left"},
    {"RoadWithRowTwice", road("", kRow + kRow),
     "dir/p.xml:4:76: error[duplicate-id]: the row of luminaires 'r' is given twice, also in line "
     "4"},
    {"RoadNamedAsTheOpenSpace",
     "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='spot' "
     "photometry='spot.ies'/>\n<road id='site' width='7' lanes='2' spacing='30' surface='R3'>" +
         kRow + "</road></luxgate>",
     "dir/p.xml:2:7: error[reserved-id]: the id 'site' is reserved for the open space; choose "
     "another one"},
    {"RoadWithPlane", road("", kRow + "<plane id='p'/>"),
     "dir/p.xml:4:61: error[unknown-element]: unknown element <plane> in <road>; allowed: "
     "luminaire-row, strip or require"},
};

class RoadXmlMessages : public ::testing::TestWithParam<MessageCase> {};

TEST_P(RoadXmlMessages, AreVerbatim) {
  EXPECT_EQ(messages_of(GetParam().xml), GetParam().messages);
}

INSTANTIATE_TEST_SUITE_P(All, RoadXmlMessages, ::testing::ValuesIn(kCases), case_name);

void expect_vector(const glm::dvec3& found, const glm::dvec3& wanted) {
  EXPECT_NEAR(glm::distance(found, wanted), 0.0, 1e-9)
      << found.x << " " << found.y << " " << found.z;
}

// In the project's unit, turned and moved; the carriageway lies to the left of the origin.
TEST(RoadXml, IsReadInWorldCoordinatesAndMetres) {
  const std::string xml =
      "<luxgate version='1' units='mm' maintenance-factor='0.8'><luminaire-type id='spot' "
      "photometry='spot.ies'/><road id='a' name='Way' was='b' origin='1000 2000 500' "
      "rotation='90' width='7000' lanes='3' oncoming-lanes='1' spacing='40000' surface='C2' "
      "q0='0.08' right-strip='2000' left-strip='0'>"
      "<luminaire-row id='r' type='spot' side='right' height='10000' overhang='-500' "
      "shift='-10000' tilt='10' street='C90' group='g'/><luminaire-row id='z' type='spot' "
      "side='left' height='2000' street='C90'/>"
      "<require quantity='TI' at-most='15'/>"
      "<strip id='walk' side='right' gap='1000' width='2000'/></road></luxgate>";
  const Loaded loaded = load(files_for_messages(xml));
  ASSERT_TRUE(loaded.project.has_value()) << loaded.messages;
  EXPECT_EQ(loaded.messages, "");
  const Space& space = loaded.project->spaces.at(0);
  EXPECT_EQ(space.id, "a");
  EXPECT_EQ(space.was, "b");
  EXPECT_EQ(space.name, "Way");
  EXPECT_FALSE(space.is_open_space());
  ASSERT_TRUE(space.road.has_value());
  const Road& road = *space.road;
  EXPECT_DOUBLE_EQ(road.spacing_m, 40.0);
  EXPECT_DOUBLE_EQ(road.width_m, 7.0);
  EXPECT_THAT(road.is_oncoming, ElementsAre(false, false, true));
  EXPECT_EQ(road.surface, "C2");
  EXPECT_EQ(road.q0, 0.08);
  EXPECT_EQ(road.right_strip_m, 2.0);
  EXPECT_FALSE(road.left_strip_m.has_value());
  ASSERT_EQ(road.rows.size(), 2u);
  expect_vector(road.rows[0].position_m, {30, -0.5, 10});
  EXPECT_EQ(road.rows[0].group, "g");
  // Of each row those within five heights: at -50, -10, 30 and 70 m, which the world has turned.
  ASSERT_EQ(space.luminaires.size(), 6u);  // two of them at 0 and 40 m
  EXPECT_EQ(space.luminaires[0].id, "r[-2]");
  expect_vector(space.luminaires[0].position_m, {1.5, 2.0 - 50.0, 10.5});
  expect_vector(space.luminaires[3].position_m, {1.5, 2.0 + 70.0, 10.5});
  ASSERT_EQ(space.planes.size(), 2u);
  const auto& way = std::get<PlanarArea>(space.planes[0].area);
  EXPECT_EQ(space.planes[0].id, "a");
  EXPECT_EQ(space.planes[0].usual_role, kCarriagewayRole);
  EXPECT_EQ(space.planes[0].requirements.size(), 1u);
  expect_vector(way.origin_m, {1, 2, 0.5});
  expect_vector(way.u, {0, 1, 0});
  expect_vector(way.normal(), {0, 0, 1});
  EXPECT_EQ(way.outline_m[2], glm::dvec2(40, 7));
  EXPECT_EQ(std::get<GridByCount>(way.grid), (GridByCount{14, 5}));
  const auto& walk = std::get<PlanarArea>(space.planes[1].area);
  EXPECT_EQ(space.planes[1].usual_role, kFootwayRole);
  expect_vector(walk.origin_m, {4, 2, 0.5});  // 1 m beside the right edge, and 2 m wide
  EXPECT_EQ(walk.outline_m[2], glm::dvec2(40, 2));
  EXPECT_THAT(calc::texts(space.notes),
              ElementsAre(AllOf(HasSubstr("14 x 9 points"), HasSubstr("Q0 = 0.08")),
                          HasSubstr("within 5 mounting heights")));
}

Luminaire row_of(const std::string& attributes) {
  const Loaded loaded = load(files_for_messages(
      road("", "<luminaire-row id='r' type='spot' height='10' " + attributes + "/>")));
  return loaded.project ? loaded.project->spaces.at(0).road->rows.at(0) : Luminaire{};
}

// Which way the half-plane of the photometry looks, and what is straight below.
TEST(RoadXml, TurnsTheStreetSideToTheStreet) {
  const double s = std::sin(kPi / 18.0), c = std::cos(kPi / 18.0);
  const glm::dmat3 ies = row_of("side='right'").world_from_luminaire;
  expect_vector(ies[0], {0, 1, 0});
  expect_vector(ies[2], {0, 0, 1});
  const glm::dmat3 ldt = row_of("side='right' street='C90' tilt='10'").world_from_luminaire;
  expect_vector(ldt[1], {0, c, s});    // lifted
  expect_vector(-ldt[2], {0, s, -c});  // the axis meets the road farther out
  expect_vector(ldt[0], {1, 0, 0});
  const glm::dmat3 left = row_of("side='left' street='C90' tilt='10'").world_from_luminaire;
  expect_vector(left[1], {0, -c, s});
  expect_vector(left[0], {-1, 0, 0});
  expect_vector(row_of("side='right' street='C270'").world_from_luminaire[1], {0, -1, 0});
  expect_vector(row_of("side='right' street='C180'").world_from_luminaire[0], {0, -1, 0});
  expect_vector(row_of("side='left' overhang='0.75'").position_m, {0, 6.25, 10});
}

TEST(RoadXml, HasOncomingTrafficWhereItKeeps) {
  const auto lanes = [](const std::string& attributes) {
    return load(files_for_messages(
                    road(attributes, kRow, "width='14' lanes='4' spacing='30' surface='R3'")))
        .project->spaces.at(0)
        .road->is_oncoming;
  };
  EXPECT_THAT(lanes(""), ElementsAre(false, false, false, false));
  EXPECT_THAT(lanes("oncoming-lanes='1'"), ElementsAre(false, false, false, true));
  EXPECT_THAT(lanes("oncoming-lanes='3' traffic='left'"), ElementsAre(true, true, true, false));
  EXPECT_THAT(lanes("oncoming-lanes='4'"), ElementsAre(true, true, true, true));
}

// Before, it was a crash.
TEST(RoadXml, SurvivesLightThatCannotBeRead) {
  for (const std::string file : {"nope.ies", "broken.ies", "../outside.ies"}) {
    std::string xml = road("");
    xml.replace(xml.find("spot.ies"), 8, file);
    const Loaded loaded = load(files_for_messages(xml));
    EXPECT_FALSE(loaded.project.has_value());
    EXPECT_THAT(loaded.messages, HasSubstr("error")) << file;
    EXPECT_THAT(loaded.messages, ::testing::Not(HasSubstr("footway"))) << file;
  }
}

// By the format of the file, also of one in a GLDF archive, and said.
TEST(RoadXml, SaysWhichSideLooksToTheStreet) {
  const auto notes = [](const std::string& type, const std::string& street) {
    const Loaded loaded = load(files_for_messages(
        "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='spot' " + type +
        "/><road id='a' width='7' lanes='2' spacing='30' surface='R3'><luminaire-row id='r' "
        "type='spot' side='right' height='10' " +
        street + "/></road></luxgate>"));
    return loaded.project ? calc::texts(loaded.project->spaces.at(0).notes)
                          : std::vector<std::string>{loaded.messages};
  };
  const auto said = [](int c) {
    return "row 'r': C" + std::to_string(c) +
           " of its photometry points to the street, the usual direction of this file format";
  };
  EXPECT_THAT(notes("photometry='spot.ies'", ""), ::testing::Contains(said(0)));
  EXPECT_THAT(notes("photometry='two.ldt' lamp-set='1'", ""), ::testing::Contains(said(90)));
  EXPECT_THAT(notes("photometry='two.gldf' variant='down'", ""), ::testing::Contains(said(90)));
  EXPECT_THAT(notes("photometry='two.gldf' variant='up'", ""), ::testing::Contains(said(0)));
  EXPECT_THAT(notes("photometry='spot.ies'", "street='C0'"), ::testing::SizeIs(2));
}

// A file for the other half of the world is the mistake that nobody sees.
TEST(RoadXml, WarnsOfLightThatGoesElsewhere) {
  const std::string to_c90 =
      "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
      "TILT=NONE\n1 1000 1 3 5 1 2 0.2 0.2 0\n1 1 12\n0 45 90\n0 90 180 270 360\n100 100 0\n"
      "100 200 0\n100 100 0\n100 20 0\n100 100 0\n";
  const auto said = [&](const std::string& street) {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='0.8'>\n<luminaire-type id='spot' "
        "photometry='head.ies'/>\n<road id='a' width='7' lanes='2' spacing='30' surface='R3'>\n"
        "<luminaire-row id='r' type='spot' side='right' height='10' " +
        street + "/></road></luxgate>";
    return load(MemoryFileReader({{"dir/p.xml", xml}, {"dir/head.ies", to_c90}})).messages;
  };
  EXPECT_EQ(said(""),
            "dir/p.xml:4:1: warning[road-luminaire-turned]: row of luminaires 'r': most of its "
            "light goes to C90, but C0 faces the street; write street=\"C90\", or street=\"C0\" if "
            "that is meant");
  EXPECT_EQ(said("street='C0'"), "");
  EXPECT_EQ(said("street='C90'"), "");
}

}  // namespace
}  // namespace calc::tests::road_xml_test
