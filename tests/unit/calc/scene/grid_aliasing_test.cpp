// Which grids stand in the same place between luminaires: those whose points are one or several
// spacings of the luminaires apart, however these were written, and no others.

#include "calc/scene/grid_aliasing.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <optional>
#include <string>

namespace calc::tests::grid_aliasing_test {
namespace {

// From a square of 0.6 m.
const std::string kPanelIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0.6 0.6 0\n1 1 12\n0 90\n0\n100 0\n";

// In a room of 12 x 8 x 3 m.
std::optional<GridAliasing> trap(const std::string& luminaires, const std::string& plane,
                                 const std::string& scene = "") {
  MemoryFileReader files = project_files(in_project(
      "<luminaire-type id='other' photometry='spot.ies'/>"
      "<luminaire-type id='panel' photometry='panel.ies'/>"
      "<scene id='half'><dim group='b' level='0'/></scene>"
      "<scene id='dimmed'><dim group='b' level='0.4'/></scene>"
      "<room id='r' size='12 8 3' ceiling='white' walls='white' floor='white'>" +
      luminaires + "<plane id='p' " + plane +
      "/></room><room id='q' origin='20 0 0' size='4 4 3' ceiling='white' walls='white' "
      "floor='white'><luminaire id='b' type='spot' position='2 2 2.9' group='b'/></room>"));
  files.add("dir/panel.ies", kPanelIes);
  const Loaded loaded = load(files);
  if (!loaded.project) {
    ADD_FAILURE() << loaded.messages;
    return std::nullopt;
  }
  const Space& space = loaded.project->spaces.at(0);
  Diagnostics diagnostics;
  const auto grid = make_sensor_grid(space.planes.at(0), space, diagnostics);
  if (!grid) {
    ADD_FAILURE() << diagnostics.all().front().message;
    return std::nullopt;
  }
  const LightScene* chosen = nullptr;
  for (const LightScene& one : loaded.project->scenes) {
    if (one.id == scene) chosen = &one;
  }
  return grid_aliasing(*loaded.project, space, *grid, chosen);
}

std::string level(const std::string& count) {
  return fmt::format("height='0.75' count='{}'", count);
}

// 2 m apart both ways, 2.15 m above the plane: at 1, 3 ... 11 and 1, 3, 5, 7 m.
const std::string kArray =
    "<luminaire-grid id='l' type='spot' origin='0 0 2.9' size='12 8' columns='6' rows='4'/>";

TEST(GridAliasing, PointsAsFarApartAsLuminairesHaveOnePlaceBetweenThem) {
  const auto along_x = trap(kArray, level("6 5"));
  ASSERT_TRUE(along_x);
  EXPECT_EQ(along_x->along, glm::dvec3(1, 0, 0));
  EXPECT_NEAR(along_x->points_m, 2.0, 1e-12);
  EXPECT_NEAR(along_x->luminaires_m, 2.0, 1e-12);
  EXPECT_NE(along_x->first_id, along_x->last_id);
  const auto along_y = trap(kArray, level("11 4"));
  ASSERT_TRUE(along_y);
  EXPECT_EQ(along_y->along, glm::dvec3(0, 1, 0));
}

// Every second, every third luminaire: the same place all the same.
TEST(GridAliasing, SoHavePointsSeveralSpacingsApart) {
  EXPECT_TRUE(trap(kArray, level("3 5")));
  EXPECT_TRUE(trap(kArray, level("2 5")));
  EXPECT_TRUE(trap(kArray, level("11 2")));
}

// Half a spacing: two places, whose average has lost the first harmonic of the ripple.
TEST(GridAliasing, TwoAndMorePlacesAreNone) {
  EXPECT_FALSE(trap(kArray, level("12 8")));
  EXPECT_FALSE(trap(kArray, level("18 12")));
  EXPECT_FALSE(trap(kArray, level("4 5"))) << "3 m: one and a half";
  EXPECT_FALSE(trap(kArray, level("5 5"))) << "2.4 m";
  EXPECT_FALSE(trap(kArray, level("7 5"))) << "1.71 m";
}

// Of 6 points the last has drifted by 5/6 of the margin's share of a metre.
TEST(GridAliasing, PlacesMayDriftByLessThanAQuarterOfASpacing) {
  EXPECT_TRUE(trap(kArray, level("6 5") + " margin='0.29'"));
  EXPECT_FALSE(trap(kArray, level("6 5") + " margin='0.31'"));
}

std::string spots(double from_m, double step_m, int count, double y_m,
                  const std::string& more = "") {
  std::string xml;
  for (int k = 0; k < count; ++k) {
    xml += fmt::format("<luminaire id='s{}-{}' type='{}' position='{} {} 2.9'{}/>", k, y_m,
                       more == "other" && k % 2 == 1 ? "other" : "spot", from_m + k * step_m, y_m,
                       more == "groups" && k % 2 == 1 ? " group='b'" : "");
  }
  return xml;
}

TEST(GridAliasing, LuminairesMayBeWrittenOneByOne) {
  const auto found = trap(spots(1, 2, 6, 4), level("6 5"));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first_id, "s0-4");
  EXPECT_EQ(found->last_id, "s5-4");
  // Staggered rows: each point still has the same neighbourhood.
  EXPECT_TRUE(trap(spots(1, 2, 6, 3) + spots(0.2, 2, 6, 5), level("6 5")));
  // Not quite in line, and not quite evenly: what a drawing has.
  EXPECT_TRUE(
      trap("<luminaire id='a' type='spot' position='1 4 2.9'/>"
           "<luminaire id='b' type='spot' position='3.1 4.1 2.9'/>"
           "<luminaire id='c' type='spot' position='5 3.95 2.93'/>"
           "<luminaire id='d' type='spot' position='6.9 4 2.9'/>"
           "<luminaire id='e' type='spot' position='9 4 2.9'/>"
           "<luminaire id='f' type='spot' position='11 4 2.9'/>",
           level("6 5")));
}

// Between points of a desk there is no whole spacing, whatever the luminaires.
TEST(GridAliasing, SmallPlanesAreNone) {
  EXPECT_FALSE(trap(kArray, "origin='2.1 1 0.75' u='1.6 0 0' v='0 1.4 0' count='4 4'"));
  EXPECT_FALSE(trap(spots(1, 10, 2, 4), "origin='4 3 0.75' u='2 0 0' v='0 2 0' count='2 2'"));
}

// Beyond the row's ends points are in other places.
TEST(GridAliasing, TheRowGoesOverTheWholePlane) {
  EXPECT_FALSE(trap(spots(5, 2, 2, 4), level("6 5")));
  EXPECT_TRUE(trap(spots(3, 2, 4, 4), level("6 5"))) << "one spacing beyond each end";
}

TEST(GridAliasing, ATypeOrALevelInBetweenMakesAnotherRow) {
  EXPECT_FALSE(trap(spots(1, 2, 6, 4, "other"), level("6 5")));
  EXPECT_TRUE(trap(spots(1, 2, 6, 4, "other"), level("3 5")));
  EXPECT_TRUE(trap(spots(1, 2, 6, 4, "groups"), level("6 5")));
  EXPECT_FALSE(trap(spots(1, 2, 6, 4, "groups"), level("6 5"), "half"));
  EXPECT_FALSE(trap(spots(1, 2, 6, 4, "groups"), level("6 5"), "dimmed"));
}

TEST(GridAliasing, HalfOfTheFluxIsInSuchRows) {
  const std::string five = spots(0.3, 2.37, 5, 4.5), seven = spots(0.3, 1.87, 7, 4.5);
  EXPECT_TRUE(trap(spots(1, 2, 6, 3) + five, level("6 5")));
  EXPECT_FALSE(trap(spots(1, 2, 6, 3) + seven, level("6 5")));
}

// 0.6 m apart and 0.55 m above the plane.
TEST(GridAliasing, LinesOfLightHaveNoPlaces) {
  const auto row = [](const char* type) {
    return fmt::format(
        "<luminaire-grid id='l' type='{}' origin='0 3.7 1.3' size='12 0.6' columns='20' rows='1'/>",
        type);
  };
  EXPECT_TRUE(trap(row("spot"), level("20 5")));
  EXPECT_FALSE(trap(row("panel"), level("20 5")));
}

// At half their height nothing of them is seen.
TEST(GridAliasing, LuminairesFarAboveThePlaneAreEven) {
  const std::string row =
      "<luminaire-grid id='l' type='spot' origin='0 0 2.9' size='12 8' columns='12' rows='1'/>";
  EXPECT_FALSE(trap(row, "height='0.85' count='12 5'")) << "1 m of 2.05 m";
  EXPECT_TRUE(trap(row, "height='1.6' count='12 5'")) << "1 m of 1.3 m";
}

TEST(GridAliasing, OnlyLevelPlanesBeforeTheLuminaires) {
  const std::string at = "origin='0 0 0.75' u='12 0 0' v='0 8 0' count='6 4'";
  EXPECT_TRUE(trap(kArray, at));
  EXPECT_FALSE(trap(kArray, "origin='0 0 0.75' u='0 8 0' v='12 0 0' count='4 6'")) << "looks down";
  EXPECT_FALSE(trap(kArray, "origin='1 0.5 0.2' u='10 0 0' v='0 0 2' count='5 2'"));
  EXPECT_FALSE(trap(kArray, at + " quantity='cylindrical'"));
  EXPECT_FALSE(trap("", at));
}

// The rows of an array are also those of its diagonals.
TEST(GridAliasing, AlongWhateverWayTheGridGoes) {
  const auto found = trap(
      "<luminaire-grid id='l' type='spot' origin='0 0 2.9' size='12 8' columns='12' rows='8'/>",
      "origin='5 1 1.6' u='3 3 0' v='-1 1 0' count='3 2'");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->luminaires_m, 1.414213562, 1e-6);
  EXPECT_NEAR(found->points_m, 1.414213562, 1e-6);
}

}  // namespace
}  // namespace calc::tests::grid_aliasing_test
