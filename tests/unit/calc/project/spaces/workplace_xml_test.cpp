#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>

namespace calc::tests::workplace_xml_test {
namespace {

// In the room of 4 x 3 x 2.5 m of in_room(), line 5.
Loaded load_workplace(const std::string& attributes, const std::string& children = "") {
  return load(in_room("<workplace id='w' pack='p' row='1' " + attributes + ">" + children +
                      "</workplace>"));
}

void expect_message(const Loaded& loaded, const std::string& message) {
  EXPECT_FALSE(loaded.project);
  EXPECT_NE(loaded.messages.find(message), std::string::npos) << loaded.messages;
}

TEST(WorkplacesXml, FactsAreReadInWorldCoordinatesAndMetres) {
  const Loaded loaded = load(
      "<luxgate version='1' units='cm'><material id='white' reflectance='0.7'/>"
      "<luminaire-type id='spot' photometry='spot.ies'/>"
      "<room id='r' origin='1000 2000 100' size='400 300 250' ceiling='white' walls='white' "
      "floor='white'><luminaire id='l' type='spot' position='200 150 250'/>"
      "<workplace id='w' name='Desk' pack='p' row='1' level='modified' origin='100 50' "
      "size='200 100' height='75'>"
      "<zone role='cylinder' height='160' margin='20' rounding='up' because='standing'/>"
      "<zone role='background' footprint='0 0  0 300  400 300  400 0'/>"
      "<without role='wall.2' because='glass' by='A. Meier' "
      "until='2099-12-31'/></workplace></room></luxgate>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(loaded.messages, "");  // a workplace counts as planes
  const Workplace& w = loaded.project->spaces.at(0).workplaces.at(0);
  EXPECT_EQ(w.name, "Desk");
  EXPECT_TRUE(w.is_good);
  ASSERT_NE(w.element.find("level"), nullptr);
  EXPECT_EQ(w.element.find("level")->value, "modified");
  ASSERT_EQ(w.task_m.size(), 4u);
  EXPECT_EQ(w.task_m[0], glm::dvec2(11, 20.5));
  EXPECT_EQ(w.task_m[2], glm::dvec2(13, 21.5));
  EXPECT_EQ(w.height_m, 0.75);
  EXPECT_EQ(w.walls.size(), 4u);
  EXPECT_EQ(w.ceiling.origin_m.z, 3.5);
  EXPECT_EQ(w.ceiling.normal().z, -1.0);
  ASSERT_EQ(w.zones.size(), 3u);
  EXPECT_EQ(w.zones[0].height_m, 1.6);
  EXPECT_EQ(w.zones[0].margin_m, 0.2);
  EXPECT_EQ(std::get<GridByRule>(w.zones[0].grid.value()).rounding, GridRounding::up);
  EXPECT_EQ(w.zones[0].because, "standing");
  EXPECT_FALSE(w.zones[1].grid);
  EXPECT_EQ(w.zones[1].area_m.at(1), glm::dvec2(14, 23)) << "counter-clockwise";
  ASSERT_TRUE(w.zones[2].left_out);
  EXPECT_EQ(w.zones[2].left_out->owner, "A. Meier");
  EXPECT_EQ(w.zones[2].left_out->until, "2099-12-31");
  EXPECT_EQ(w.zones[2].left_out->reason, "glass");
}

TEST(WorkplacesXml, UprightTasksAreInTheProjectsUnitsAndInTheWorld) {
  const auto upright = [](const std::string& attributes) {
    const Loaded loaded = load(
        "<luxgate version='1' units='cm'><material id='white' reflectance='0.7'/>"
        "<luminaire-type id='spot' photometry='spot.ies'/>"
        "<room id='r' origin='1000 2000 100' size='400 300 250' ceiling='white' walls='white' "
        "floor='white'><luminaire id='l' type='spot' position='200 150 250'/>"
        "<workplace id='w' pack='p' row='1' " +
        attributes + "/></room></luxgate>");
    EXPECT_TRUE(loaded.project) << loaded.messages;
    return loaded.project ? loaded.project->spaces.at(0).workplaces.at(0).upright : std::nullopt;
  };
  // Wall 1 runs along y = 0; seen from the room its left end is at x = 4 m.
  const auto board = upright("wall='1' along='100 250' heights='90 210'");
  ASSERT_TRUE(board);
  EXPECT_EQ(board->wall, 0u);
  EXPECT_EQ(board->area.origin_m, glm::dvec3(13, 20, 1.9));
  EXPECT_EQ(board->area.u, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(board->area.normal(), glm::dvec3(0, 1, 0));
  EXPECT_NEAR(board->area.outline_m[2].x, 1.5, 1e-12);
  EXPECT_NEAR(board->area.outline_m[2].y, 1.2, 1e-12);
  const auto face = upright("face='300 100 100 100' heights='0 200'");
  ASSERT_TRUE(face);
  EXPECT_FALSE(face->wall);
  EXPECT_EQ(face->area.origin_m, glm::dvec3(13, 21, 1));
  EXPECT_EQ(face->area.normal(), glm::dvec3(0, 1, 0));
  EXPECT_NEAR(face->high_m, 2.0, 1e-12);
}

TEST(WorkplacesXml, WithoutAnAreaTheTaskIsTheRoom) {
  const Loaded loaded = load_workplace("");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_TRUE(loaded.project->spaces.at(0).workplaces.at(0).task_m.empty());
  EXPECT_FALSE(loaded.project->spaces.at(0).workplaces.at(0).height_m);
}

TEST(WorkplacesXml, ThePlaceOfTheTaskAndTheWallInFront) {
  const Loaded loaded = load_workplace("task-place='unknown' front-wall='4'");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_TRUE(loaded.project->spaces.at(0).workplaces.at(0).is_task_place_unknown);
  EXPECT_EQ(loaded.project->spaces.at(0).workplaces.at(0).front_wall, 3u);
  const Loaded neither = load_workplace("");
  EXPECT_FALSE(neither.project->spaces.at(0).workplaces.at(0).is_task_place_unknown);
  EXPECT_FALSE(neither.project->spaces.at(0).workplaces.at(0).front_wall);
  expect_message(load_workplace("front-wall='0'"), "attribute 'front-wall' of <workplace>");
  expect_message(load_workplace("front-wall='x'"), "attribute 'front-wall' of <workplace>");
}

Loaded load_grid(const std::string& attributes) {
  return load(in_room("<workplace-grid id='g' pack='p' row='1' " + attributes + "/>"));
}

TEST(WorkplaceGridXml, CopiesAreCountedAlongXFirst) {
  const Loaded loaded =
      load_grid("name='Desk' origin='0.5 0.5' size='1 0.8' repeat='2 2' step='1.5 1.2'");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const std::vector<Workplace>& all = loaded.project->spaces.at(0).workplaces;
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[1].id, "g[1,0]");
  EXPECT_EQ(all[2].id, "g[0,1]");
  EXPECT_EQ(all[3].name, "Desk [1,1]");
  EXPECT_EQ(all[3].task_m.at(0), glm::dvec2(2.0, 1.7));
  EXPECT_FALSE(all[0].is_further_copy);
  EXPECT_TRUE(all[1].is_further_copy);
}

TEST(WorkplaceGridXmlMessage, CopiesThatCannotBe) {
  const std::string area = "origin='0.5 0.5' size='1 0.8' ";
  expect_message(load_grid("repeat='2 1' step='1 0'"),
                 "<workplace-grid> needs the area of its first copy: 'origin' and 'size', "
                 "'footprint' or 'face'");
  expect_message(load_grid(area + "repeat='2 1' step='0 1'"),
                 "attribute 'step' of <workplace-grid>: 0 is not allowed; expected a distance "
                 "other than 0 wherever 'repeat' is above 1");
  expect_message(load_grid(area + "repeat='100000 100000' step='1 1'"), "at most 4000 copies");
  expect_message(load_grid(area + "repeat='2 0' step='1 1'"), "attribute 'repeat'");
  expect_message(load_grid(area + "repeat='2 1'"), "<workplace-grid> needs the attribute 'step'");
  expect_message(load_grid(area + "repeat='4 1' step='1.2 0'"),
                 "error[copy-outside-room]: copy 'g[3,0]': 0.8 m2 of its areas are outside room "
                 "'r'; all copies must be within the room");
}

TEST(WorkplacesXmlMessage, TaskLargerThanTheRoom) {
  expect_message(load_workplace("origin='1 1' size='4 1'"),
                 "p.xml:5:49: error[area-outside-room]: attribute 'size' of <workplace>: 1 of its "
                 "4 m2 are outside room 'r'; it must be within the room");
}

TEST(WorkplacesXmlMessage, AreaOfAZoneOutsideTheRoom) {
  expect_message(load_workplace("", "<zone role='background' footprint='0 0  9 0  9 3  0 3'/>"),
                 "attribute 'footprint' of <zone>: 15 of its 27 m2 are outside room 'r'");
}

TEST(WorkplacesXmlMessage, AreasThatAreNone) {
  expect_message(load_workplace("size='2 1'"), "<workplace> has 'size' without 'origin'");
  expect_message(load_workplace("origin='1 1' size='2 0'"), "a number above 0");
  expect_message(load_workplace("footprint='1 1  2 2  1 2  2 1'"), "not-simple-polygon");
  expect_message(load_workplace("origin='1 1' size='1 1' footprint='1 1  2 1  2 2'"),
                 "has both 'size' and 'footprint'");
}

TEST(WorkplacesXmlMessage, HeightBeyondTheRoom) {
  expect_message(
      load_workplace("height='2.5'"),
      "attribute 'height' of <workplace>: 2.5 is not allowed; expected a number from 0 to "
      "below the room's height 2.5");
}

TEST(WorkplacesXmlMessage, ZoneThatChangesNothing) {
  expect_message(load_workplace("", "<zone role='wall' because='x'/>"),
                 "<zone> needs at least one attribute that changes it: 'height', 'margin'");
}

TEST(WorkplacesXmlMessage, LeftOutWithoutReasonOwnerOrDay) {
  const auto without = [](const std::string& attributes) {
    return load_workplace("", "<without role='wall' " + attributes + "/>");
  };
  expect_message(without("by='A' until='2027-01-01'"), "<without> needs the attribute 'because'");
  expect_message(without("because='x' until='2027-01-01'"), "<without> needs the attribute 'by'");
  expect_message(without("because='x' by='A'"), "<without> needs the attribute 'until'");
  expect_message(without("because='x' by='A' until='2027-02-29'"),
                 "attribute 'until' of <without>: '2027-02-29' is not a date; expected YYYY-MM-DD");
}

TEST(WorkplacesXmlMessage, SameZoneTwice) {
  expect_message(load_workplace("",
                                "<zone role='wall' margin='0'/>\n<without role='wall' because='x' "
                                "by='A. Meier' until='2099-12-31'/>"),
                 "p.xml:6:10: error[duplicate-id]: the zone 'wall' is given twice, also in line 5");
}

TEST(WorkplacesXmlMessage, SameIdTwice) {
  expect_message(load(in_room("<workplace id='w' pack='p' row='1'/>\n<workplace id='w' pack='p' "
                              "row='1'/>")),
                 "the workplace 'w' is given twice, also in line 5");
}

TEST(WorkplacesXmlMessage, OutsideARoom) {
  expect_message(load(in_project("<workplace id='w' pack='p' row='1'/>")),
                 "unknown element <workplace> in <luxgate>");
}

TEST(WorkplacesXmlMessage, InARoomOfABuildingFile) {
  expect_message(load(in_project("<room id='b' file='house.xml' space='low' material='white'>"
                                 "<workplace id='w' pack='p' row='1' height='0.75'/></room>")),
                 "error[workplace-needs-room]: <workplace> needs a room with 'size'");
}

}  // namespace
}  // namespace calc::tests::workplace_xml_test
