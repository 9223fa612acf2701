// <room file="..." space="..."> and <luminaires file="..."> in a project.

#include "tests/support/gbxml_samples.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

namespace calc::tests::gbxml_space_test {
namespace {

Loaded load_room(const std::string& room, const std::string& csv = "") {
  MemoryFileReader files = project_files(in_project(room));
  files.add("dir/b.xml", two_rooms());
  files.add("dir/l.csv", csv);
  return load(files);
}

TEST(GbxmlSpace, BecomesARoomWithItsSurfaces) {
  const Loaded loaded = load_room(
      R"(<material id="glass" reflectance="0.1"/><room id="r" file="b.xml" space="low" material="white">
<map name="FixedWindow" material="glass"/><map name="Roof" material="glass"/>
<luminaire id="l" type="spot" position="2 1.5 2.4"/><plane id="task" height="0.75"/></room>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(loaded.messages, "");
  const Space& space = loaded.project->spaces.at(0);
  EXPECT_EQ(space.name, "Low room");
  EXPECT_EQ(space.surfaces_file, "b.xml");
  EXPECT_FALSE(space.shell);
  ASSERT_EQ(space.bodies.size(), 7u);
  EXPECT_EQ(space.bodies[1].id, "r.south");
  EXPECT_EQ(space.bodies[2].id, "r.window");
  EXPECT_EQ(space.bodies[1].material_of.front(), 0u);
  EXPECT_EQ(space.bodies[2].material_of.front(), 1u);
  const auto& area = std::get<PlanarArea>(space.planes.at(0).area);
  EXPECT_DOUBLE_EQ(area.origin_m.z, 0.75);
  EXPECT_EQ(area.outline_m.size(), 4u);
  EXPECT_GT(area.normal().z, 0.0);
  EXPECT_EQ(loaded.project->inputs.back().path, "b.xml");
}

TEST(GbxmlSpace, UnmappedTypesAreErrors) {
  EXPECT_EQ(
      load_room(R"(<room id="r" file="b.xml" space="low"><map name="Ceiling" material="white"/>
<map name="ExteriorWall" material="white"/></room>)")
          .messages,
      "dir/p.xml:4:1: error[gbxml-unmapped]: room 'r': no material for 'SlabOnGrade', "
      "'FixedWindow', 'InteriorWall'; add <map name=\"...\" material=\"...\"/> for each, or "
      "the attribute 'material' for all that are not mapped");
  EXPECT_NE(load_room(R"(<room id="r" file="b.xml" space="low" material="white">
<map name="Exteriorwall" material="white"/></room>)")
                .messages.find("there is no surface or opening type 'Exteriorwall'"),
            std::string::npos);
}

TEST(GbxmlSpace, HasNoShapeOfItsOwnAndNoNumberedWalls) {
  EXPECT_NE(load_room(R"(<room id="r" file="b.xml" space="low" size="1 1 1" material="white"/>)")
                .messages.find("unknown attribute 'size' of <room>"),
            std::string::npos);
  EXPECT_EQ(
      load_room(R"(<room id="r" file="b.xml" space="low" material="white">
<plane id="p" on="wall1"/></room>)")
          .messages,
      "dir/p.xml:5:15: error[gbxml-plane]: 'on' of <plane>: the walls of a gbXML room have no "
      "numbers; use 'points'");
}

TEST(LuminaireListXml, LuminairesAreNamedAimedAndPlacedInTheirRoom) {
  const Loaded loaded = load_room(
      R"(<room id="r" origin="10 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">
<luminaires id="plan" file="l.csv"/><plane id="task" height="0.75"/></room>)",
      "name,type,x_m,y_m,z_m,aim_x_m,aim_y_m,aim_z_m,group\nA1,spot,1,1,2.5,,,,row\n"
      "A2,spot,3,1,2.5,3,2,2.5,\n");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const std::vector<Luminaire>& luminaires = loaded.project->spaces.at(0).luminaires;
  ASSERT_EQ(luminaires.size(), 2u);
  EXPECT_EQ(luminaires[0].id, "plan.A1");
  EXPECT_EQ(luminaires[0].group, "row");
  EXPECT_EQ(luminaires[0].position_m, glm::dvec3(11, 1, 2.5));
  EXPECT_EQ(luminaires[0].where.file, "dir/l.csv");
  EXPECT_EQ(luminaires[0].where.line, 2);
  EXPECT_NEAR(glm::distance(-luminaires[1].world_from_luminaire[2], glm::dvec3(0, 1, 0)), 0, 1e-12);
}

TEST(LuminaireListXml, UnknownTypesAreReportedAtTheirLine) {
  EXPECT_EQ(load_room(R"(<luminaires id="plan" file="l.csv"/>)",
                      "name,type,x_m,y_m,z_m\nA1,sport,1,1,2.5\n")
                .messages,
            "dir/l.csv:2: error[luminaire-list-line]: unknown luminaire type 'sport'; did you "
            "mean 'spot'?");
}

}  // namespace
}  // namespace calc::tests::gbxml_space_test
