#include "report/tools/import/project_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace project_text_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

cli::ImportMap a_map() {
  cli::ImportMap map;
  map.room.push_back({"ROOM*", "NAME", 2.8, 0.7, 0.5, 0.2, {}, false, 1});
  cli::MapLuminaire luminaire;
  luminaire.type = "LUM*";
  luminaire.photometry = "x/panel.ies";
  map.luminaire.push_back(luminaire);
  return map;
}

cli::Design a_design() {
  cli::Design design;
  design.file = "a--b.dxf";
  cli::DesignRoom room;
  room.source.key = "1F";
  room.name = "A & B";
  room.outline_m = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  room.floor_z_m = 3.0;
  room.height_m = 2.8;
  design.room.push_back(room);
  return design;
}

cli::DesignLuminaire luminaire(const std::string& key, const glm::dvec3& at) {
  cli::DesignLuminaire one;
  one.source.key = key;
  one.type = "LUM_A";
  one.position_m = at;
  one.has_height = true;
  return one;
}

std::size_t count(const cli::Design& design, cli::DesignNote::Kind kind, const std::string& why) {
  std::size_t found = 0;
  for (const cli::DesignNote& note : design.note) {
    if (note.kind == kind && note.why.find(why) != why.npos) found += note.count;
  }
  return found;
}
using Kind = cli::DesignNote::Kind;

TEST(ProjectText, WritesRoomsAndWhatStandsInThem) {
  cli::Design design = a_design();
  design.luminaire.push_back(luminaire("2A", {1.23456, 2, 5.5}));
  const cli::ProjectText text = cli::project_text(design, a_map(), {"photometry/panel.ies"});
  EXPECT_EQ(text.rooms, 1u);
  EXPECT_EQ(text.luminaires, 1u);
  EXPECT_THAT(text.xml, HasSubstr("a-_b.dxf"));
  EXPECT_THAT(text.xml, HasSubstr("<room id=\"room-1F\" name=\"A &amp; B\" origin=\"0 0 3\" "
                                  "footprint=\"0 0  6 0  6 4  0 4\" height=\"2.8\" "
                                  "ceiling=\"ROOM-ceiling\""));
  EXPECT_THAT(text.xml,
              HasSubstr("<luminaire id=\"L-2A\" type=\"panel\" position=\"1.2346 2 2.5\"/>"));
}

// What a GlobalId may have and an id may not, so that results lead back to the model.
TEST(ProjectText, GlobalIdsCanBeReadFromIds) {
  cli::Design design = a_design();
  design.room[0].source.key = "0$_Ab3$$9";
  design.luminaire.push_back(luminaire("1$x", {1, 2, 5.5}));
  const cli::ProjectText text = cli::project_text(design, a_map(), {"photometry/panel.ies"});
  EXPECT_THAT(text.xml, HasSubstr("<room id=\"room-0:_Ab3::9\""));
  EXPECT_THAT(text.xml, HasSubstr("<luminaire id=\"L-1:x\""));
}

TEST(ProjectText, WhatCannotBeWrittenIsSaid) {
  cli::Design design = a_design();
  design.luminaire = {luminaire("1", {9, 9, 5}), luminaire("2", {1, 1, 6.0}),
                      luminaire("3", {1, 1, 5}), luminaire("4", {1, 1, 5}),
                      luminaire("5", {1, 1, 5.8})};
  design.luminaire[2].has_height = false;
  design.luminaire[3].type = "OTHER";
  const cli::ProjectText text = cli::project_text(design, a_map(), {"photometry/panel.ies"});
  EXPECT_EQ(text.luminaires, 1u);
  EXPECT_EQ(count(design, Kind::left_out, "it is not in a room"), 1u);
  EXPECT_EQ(count(design, Kind::left_out, "it is above the ceiling"), 1u);
  EXPECT_EQ(count(design, Kind::left_out, "its height is not known"), 1u);
  EXPECT_EQ(count(design, Kind::left_out, "the map gives it no photometry"), 1u);
  EXPECT_EQ(count(design, Kind::doubt, "it is written 1 cm lower"), 1u);
  EXPECT_THAT(text.xml, HasSubstr("id=\"L-5\" type=\"panel\" position=\"1 1 2.79\""));
}

TEST(ProjectText, WithoutPhotometryThereIsNoLuminaire) {
  cli::Design design = a_design();
  design.luminaire.push_back(luminaire("2A", {1, 2, 5.5}));
  const cli::ProjectText text = cli::project_text(design, a_map(), {""});
  EXPECT_EQ(text.luminaires, 0u);
  EXPECT_THAT(text.xml, Not(HasSubstr("luminaire-type")));
  EXPECT_EQ(count(design, Kind::left_out, "could not be read"), 1u);
}

TEST(ProjectText, RoomsWithTheSameLayerAndOtherReflectancesHaveMaterialsOfTheirOwn) {
  cli::ImportMap map = a_map();
  map.room.push_back(map.room[0]);
  map.room[1].walls = 0.3;
  cli::Design design = a_design();
  design.room.push_back(design.room[0]);
  design.room[1].source.key = "2F";
  design.room[1].rule = 1;
  const std::string xml = cli::project_text(design, map, {""}).xml;
  EXPECT_THAT(xml, HasSubstr("id=\"ROOM-walls\" reflectance=\"0.5\""));
  EXPECT_THAT(xml, HasSubstr("id=\"ROOM-walls-2\" reflectance=\"0.3\""));
}

// A prism has no holes: what is not in the room is a solid in it.
TEST(ProjectText, HolesAreSolidsAsHighAsTheRoom) {
  cli::Design design = a_design();
  design.room[0].hole_m = {{{2, 1}, {2, 2}, {3.5, 2}, {3.5, 1}}, {{5, 1}, {4, 1}, {5, 2}}};
  const cli::ProjectText text = cli::project_text(design, a_map(), {""});
  EXPECT_THAT(text.xml, HasSubstr("<box id=\"H-1F\" size=\"1.5 1 2.8\" position=\"2 1 0\" "
                                  "material=\"ROOM-walls\"/>"));
  ASSERT_EQ(text.file.size(), 1u);
  EXPECT_THAT(text.xml, HasSubstr("<mesh id=\"H-1F-2\" file=\"" + text.file[0].name +
                                  "\" units=\"m\" up=\"z\" material=\"ROOM-walls\"/>"));
  EXPECT_EQ(text.file[0].bytes.substr(0, 8), "v 5 2 0\n");
  EXPECT_THAT(text.file[0].bytes, HasSubstr("v 4 1 2.8\n"));
  EXPECT_THAT(text.file[0].bytes, HasSubstr("f 1 2 5 4\n"));
  EXPECT_EQ(count(design, Kind::doubt, "as a solid as high as the room"), 2u);
}

TEST(ProjectText, HolesThatAreTooSmallAreSaid) {
  cli::Design design = a_design();
  design.room[0].hole_m = {{{2, 1}, {2, 1.00001}, {2.00001, 1}}};
  EXPECT_THAT(cli::project_text(design, a_map(), {""}).xml, Not(HasSubstr("H-1F")));
  EXPECT_EQ(count(design, Kind::doubt, "is filled"), 1u);
}

TEST(ProjectText, TurnedHolesAreTurnedBoxes) {
  cli::Design design = a_design();
  design.room[0].hole_m = {{{3, 1}, {2, 2}, {3, 3}, {4, 2}}};
  EXPECT_THAT(cli::project_text(design, a_map(), {""}).xml,
              HasSubstr("size=\"1.4142 1.4142 2.8\" position=\"3 1 0\" rotation=\"45\""));
}

TEST(ProjectText, BoxesTurnAboutTheirCorner) {
  cli::Design design = a_design();
  cli::DesignBox box;
  box.source.key = "7";
  box.name = "DESK";
  box.centre_m = {3, 2, 3};
  box.size_m = {1.6, 0.8, 0.75};
  box.rotation_deg = 90.0;
  design.box.push_back(box);
  cli::ImportMap map = a_map();
  map.furniture.push_back({"DESK", "", 0.75, 0.4, 1});
  EXPECT_THAT(cli::project_text(design, map, {""}).xml,
              HasSubstr("size=\"1.6 0.8 0.75\" position=\"3.4 1.2 0\" rotation=\"90\""));
}

}  // namespace
}  // namespace project_text_test
