#include "calc/scene/opening_fit.h"

#include "calc/scene/prepared_scene.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace calc::opening_fit_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::load;

// 1.2 m along C0, 0.3 m along C90, 0.2 m high.
const std::string kBoxIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0.3 1.2 0.2\n1 1 12\n0 90\n0\n100 0\n";

// A room with a ceiling 2.5 m above its floor and one such luminaire.
tests::Loaded room_with(const std::string& luminaire) {
  MemoryFileReader files = tests::project_files(tests::in_project(
      "<luminaire-type id=\"body\" photometry=\"box.ies\"/>\n"
      "<room id=\"r\" size=\"4 3 2.5\" ceiling=\"white\" walls=\"white\" floor=\"white\">\n" +
      luminaire + "<plane id=\"task\" height=\"0.75\"/></room>"));
  files.add("dir/box.ies", kBoxIes);
  return load(files);
}

OpeningShape shape_in_scene(const tests::Loaded& loaded) {
  return prepare_scene(*loaded.project, loaded.project->spaces[0]).luminaires[0].opening.shape;
}

TEST(OpeningFit, ABodyCutByTheCeilingIsUsedAsFlatWithAWarning) {
  const tests::Loaded loaded =
      room_with("<luminaire id=\"l\" type=\"body\" position=\"2 1.5 2.5\"/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(
      loaded.messages,
      HasSubstr(
          "warning[luminous-body-cut]: luminaire 'l': a surface cuts through its luminous sides"));
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  EXPECT_EQ(scene.luminaires[0].opening.shape, OpeningShape::rectangle);
  EXPECT_EQ(scene.luminaires[0].opening.along_c0_m, 1.2);
  EXPECT_EQ(scene.luminaires[0].opening.along_c90_m, 0.3);
}

TEST(OpeningFit, ABodyThatTouchesTheCeilingIsKept) {
  const tests::Loaded loaded =
      room_with("<luminaire id=\"l\" type=\"body\" position=\"2 1.5 2.4\"/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(loaded.messages, Not(HasSubstr("luminous-body-cut")));
  EXPECT_EQ(shape_in_scene(loaded), OpeningShape::box);
}

TEST(OpeningFit, TheLuminairesTurnCounts) {
  // 0.5 m from the wall: 0.6 m along C0 reach through it, 0.15 m along C90 do not.
  EXPECT_EQ(shape_in_scene(room_with("<luminaire id=\"l\" type=\"body\" position=\"0.5 1.5 2\"/>")),
            OpeningShape::rectangle);
  EXPECT_EQ(shape_in_scene(room_with(
                "<luminaire id=\"l\" type=\"body\" position=\"0.5 1.5 2\" rotation=\"90\"/>")),
            OpeningShape::box);
}

TEST(OpeningFit, FlatOpeningsAreNeverCut) {
  Space space;
  Luminaire luminaire;
  luminaire.world_from_luminaire = glm::dmat3(1.0);
  Body wall;
  wall.vertex_m = {{0, -9, -9}, {0, 9, -9}, {0, 0, 9}};
  wall.triangle = {{0, 1, 2}};
  wall.material_of = {0};
  space.bodies = {wall};
  OpeningFit fit(space);
  EXPECT_FALSE(fit.is_cut({OpeningShape::rectangle, 1.2, 0.3, 0.2}, luminaire));
  EXPECT_TRUE(fit.is_cut({OpeningShape::ellipsoid, 1.2, 0.3, 0.2}, luminaire));
}

TEST(Flattened, KeepsTheOutlineSeenFromBelow) {
  const auto shape = [](OpeningShape body) { return flattened({body, 1.2, 0.3, 0.2}).shape; };
  EXPECT_EQ(shape(OpeningShape::box), OpeningShape::rectangle);
  EXPECT_EQ(shape(OpeningShape::cylinder_c0), OpeningShape::rectangle);
  EXPECT_EQ(shape(OpeningShape::cylinder_c90), OpeningShape::rectangle);
  EXPECT_EQ(shape(OpeningShape::cylinder), OpeningShape::disk);
  EXPECT_EQ(shape(OpeningShape::ellipsoid), OpeningShape::disk);
  EXPECT_EQ(shape(OpeningShape::point), OpeningShape::point);
}

}  // namespace
}  // namespace calc::opening_fit_test
