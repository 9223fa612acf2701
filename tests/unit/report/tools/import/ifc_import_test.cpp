#include "report/tools/import/ifc_import.h"

#include "report/tools/import/design_heights.h"
#include "tests/unit/report/tools/import/ifc_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ifc_import_test {
namespace {

using cli::Design;
using cli::ImportMap;
using test_support::ifc_extrusion;
using test_support::ifc_file;
using test_support::ifc_space;
using ::testing::HasSubstr;

// A room of 4 m x 6 m x 3 m with a panel under its ceiling and a switch.
std::string office() {
  return ifc_file(ifc_space(ifc_extrusion("#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4000.,6000.);")) +
                  "#40=IFCLOCALPLACEMENT(#800,#41);#41=IFCAXIS2PLACEMENT3D(#42,$,$);"
                  "#42=IFCCARTESIANPOINT((500.,500.,2900.));"
                  "#43=IFCLIGHTFIXTURE('l1',$,'A',$,'Panel 600',#40,$,'1',$);"
                  "#44=IFCLIGHTFIXTURE('l2',$,'B',$,'Switch',#40,$,'2',$);");
}

TEST(IfcImport, SuggestsAMapThatIsReadBack) {
  std::string problem;
  auto suggested = cli::suggest_ifc_map(office(), "house.ifc", "", problem);
  ASSERT_TRUE(suggested) << problem;
  std::string& map = *suggested;
  EXPECT_THAT(map,
              HasSubstr("# \"Office\": 1 time; heights 3 m; numbers \"101\"; use \"office\"\n"));
  EXPECT_THAT(map, HasSubstr("# \"Panel 600\": 1 time; z 2.9\n"));
  EXPECT_THAT(map, HasSubstr("but the file calls it a light fixture"));
  calc::Diagnostics diagnostics;
  EXPECT_TRUE(cli::read_import_map(map, "map.toml", diagnostics));
  for (const char* table : {"# [[room]]\n# layer", "# [[luminaire]]\n# type = \"Panel"}) {
    const std::size_t at = map.find(table);
    ASSERT_NE(at, map.npos);
    for (std::size_t line = at; map[line] == '#'; line = map.find('\n', line) + 1) {
      map.erase(line, 2);
    }
  }
  const auto read = cli::read_import_map(map, "map.toml", diagnostics);
  ASSERT_TRUE(read);
  const auto design = cli::design_of_ifc(office(), "house.ifc", *read, "", problem);
  ASSERT_TRUE(design) << problem;
  EXPECT_EQ(design->room[0].rule, 0u);
  ASSERT_EQ(design->luminaire.size(), 2u);
  EXPECT_EQ(design->luminaire[0].rule, 0u);
  EXPECT_EQ(design->luminaire[1].rule, std::nullopt);
  EXPECT_FALSE(cli::suggest_ifc_map("ISO-10303-21;", "house.ifc", "", problem));
  EXPECT_NE(problem, "");
}

ImportMap map_with(std::vector<cli::HeightSource> height) {
  ImportMap map;
  map.room.resize(2);
  map.room[0].layer = "corridor*";
  cli::MapLuminaire panel;
  panel.type = "panel*";
  panel.height = std::move(height);
  map.luminaire.push_back(panel);
  map.ignore = {"switch"};
  return map;
}

Design read(const ImportMap& map) {
  std::string problem;
  const auto design = cli::design_of_ifc(office(), "a.ifc", map, "", problem);
  EXPECT_TRUE(design) << problem;
  return design.value_or(Design());
}

TEST(IfcImport, RulesOfTheMapTakeRoomsAndLuminaires) {
  const Design design = read(map_with({cli::FromZ()}));
  ASSERT_EQ(design.room.size(), 1u);
  EXPECT_EQ(design.room[0].rule, 1u);  // it is no corridor
  ASSERT_EQ(design.luminaire.size(), 1u);
  EXPECT_EQ(design.luminaire[0].rule, 0u);
  EXPECT_EQ(design.luminaire[0].position_m.z, 2.9);
}

TEST(IfcImport, TheMapSaysTheHeight) {
  EXPECT_EQ(read(map_with({2.5})).luminaire.at(0).position_m.z, 2.5);
  const cli::FromAttribute tag{"Tag"};  // 1 mm above the floor
  EXPECT_EQ(read(map_with({tag})).luminaire.at(0).position_m.z, 0.001);
  EXPECT_FALSE(read(map_with({cli::FromAttribute{"no"}})).luminaire.at(0).has_height);
}

// As of drawings: with a unit behind it, or no height at all.
TEST(IfcImport, HeightsOfAttributesAreReadAsInDrawings) {
  EXPECT_DOUBLE_EQ(cli::length_of_text("2,80 m", 0.001).value(), 2.8);
  EXPECT_DOUBLE_EQ(cli::length_of_text("2800", 0.001).value(), 2.8);
  EXPECT_FALSE(cli::length_of_text("high", 0.001));
  Design design;
  cli::DesignNotes notes(design);
  cli::DesignLuminaire lamp;
  lamp.attribute = {{"HEIGHT", " "}, {"Height", "-1"}, {"height", "2.5"}};
  EXPECT_FALSE(cli::height_of_attribute(lamp, "height", 1.0, notes));
  ASSERT_EQ(design.note.size(), 1u);
  EXPECT_THAT(design.note[0].why, HasSubstr("Height is not a height"));
}

TEST(IfcImport, ARoomThatNoRuleFitsHasNone) {
  ImportMap map = map_with({cli::FromZ()});
  map.room.pop_back();
  EXPECT_EQ(read(map).room.at(0).rule, 1u);  // beyond the list
  map.room[0].layer = "off*";
  EXPECT_EQ(read(map).room.at(0).rule, 0u);
}

TEST(IfcImport, BrokenFilesHaveALine) {
  std::string problem;
  EXPECT_FALSE(cli::design_of_ifc("ISO-10303-21;\nHEAD", "a.ifc", ImportMap(), "", problem));
  EXPECT_THAT(problem, HasSubstr("line 2: HEADER is expected"));
}

}  // namespace
}  // namespace ifc_import_test
