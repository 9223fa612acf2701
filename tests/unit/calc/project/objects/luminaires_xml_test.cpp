#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace calc::tests::luminaires_xml_test {
namespace {

std::vector<Luminaire> luminaires_of(const std::string& lines) {
  const Loaded loaded = load(in_project(lines));
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project ? loaded.project->spaces.at(0).luminaires : std::vector<Luminaire>{};
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1.0e-12);
  EXPECT_NEAR(found.y, expected.y, 1.0e-12);
  EXPECT_NEAR(found.z, expected.z, 1.0e-12);
}

TEST(LuminairesXml, ShinesDownWithC0AlongXByDefault) {
  const auto found = luminaires_of("<luminaire id='l' type='spot' position='1 2 3'/>");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "l");
  EXPECT_EQ(found[0].group, "");
  EXPECT_EQ(found[0].position_m, glm::dvec3(1, 2, 3));
  expect_near(found[0].world_from_luminaire[0], {1, 0, 0});
  expect_near(-found[0].world_from_luminaire[2], {0, 0, -1});
}

TEST(LuminairesXml, ReadsAxisRotationC0AimAndGroup) {
  const auto found = luminaires_of(
      "<luminaire id='a' type='spot' position='0 0 0' rotation='90' group='row 1'/>"
      "<luminaire id='b' type='spot' position='0 0 0' axis='0 2 0' c0='0 5 -3'/>"
      "<luminaire id='c' type='spot' position='1 1 3' aim='1 4 3'/>");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].group, "row 1");
  expect_near(found[0].world_from_luminaire[0], {0, 1, 0});
  expect_near(-found[1].world_from_luminaire[2], {0, 1, 0});
  expect_near(found[1].world_from_luminaire[0], {0, 0, -1});
  expect_near(-found[2].world_from_luminaire[2], {0, 1, 0});
}

TEST(LuminairesXml, GridKeepsHalfASpacingFromItsEdges) {
  const auto found = luminaires_of(
      "<luminaire-grid id='g' type='spot' origin='1 1 3' size='6 4' columns='3' rows='2'/>");
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(found[0].id, "g[0,0]");
  expect_near(found[0].position_m, {2, 2, 3});
  EXPECT_EQ(found[5].id, "g[2,1]");
  expect_near(found[5].position_m, {6, 4, 3});
}

TEST(LuminairesXml, ArrayRotationTurnsTheGridWithItsLuminaires) {
  const auto found = luminaires_of(
      "<luminaire-grid id='g' type='spot' origin='1 1 3' size='6 4' columns='3' rows='2' "
      "array-rotation='90' axis='1 0 0'/>");
  expect_near(found.at(5).position_m, {1 - 3, 1 + 5, 3});
  expect_near(-found[5].world_from_luminaire[2], {0, 1, 0});
}

TEST(LuminairesXml, LineStandsHalfASpacingInsideOrAtTheEnds) {
  const auto half =
      luminaires_of("<luminaire-line id='h' type='spot' from='0 0 3' to='8 0 5' count='4'/>");
  ASSERT_EQ(half.size(), 4u);
  expect_near(half[0].position_m, {1, 0, 3.25});
  expect_near(half[3].position_m, {7, 0, 4.75});
  const auto ends = luminaires_of(
      "<luminaire-line id='e' type='spot' from='0 0 3' to='8 0 5' count='3' edge='end'/>");
  ASSERT_EQ(ends.size(), 3u);
  expect_near(ends[0].position_m, {0, 0, 3});
  expect_near(ends[1].position_m, {4, 0, 4});
  EXPECT_EQ(ends[2].id, "e[2]");
  expect_near(ends[2].position_m, {8, 0, 5});
}

TEST(LuminairesXml, RingTurnsItsLuminairesUnlessToldNotTo) {
  const std::string ring =
      "<luminaire-ring id='r' type='spot' centre='5 5 3' radius='2' count='4' start='90' ";
  const auto turned = luminaires_of(ring + "axis='1 0 0'/>");
  ASSERT_EQ(turned.size(), 4u);
  expect_near(turned[0].position_m, {5, 7, 3});
  expect_near(-turned[0].world_from_luminaire[2], {0, 1, 0});
  expect_near(turned[1].position_m, {3, 5, 3});
  expect_near(-turned[1].world_from_luminaire[2], {-1, 0, 0});
  const auto fixed = luminaires_of(ring + "axis='1 0 0' turn='no'/>");
  expect_near(fixed.at(1).position_m, {3, 5, 3});
  expect_near(-fixed[1].world_from_luminaire[2], {1, 0, 0});
}

TEST(LuminairesXml, HugeArraysAreRefusedBeforeTheyAreMade) {
  const Loaded loaded = load(in_project(
      "<luminaire-grid id='g' type='spot' origin='0 0 0' size='1 1' columns='2000000000' "
      "rows='2000000000'/>\n<luminaire-line id='l' type='spot' from='0 0 0' to='1 0 0' "
      "count='1000001'/>\n<luminaire-ring id='r' type='spot' centre='0 0 0' radius='1' "
      "count='2147483647'/>"));
  EXPECT_FALSE(loaded.project);
  EXPECT_EQ(std::count(loaded.messages.begin(), loaded.messages.end(), '\n') + 1, 3);
  EXPECT_NE(loaded.messages.find("'g' brings the model to 4000000000000000000 objects"),
            std::string::npos)
      << loaded.messages;
}

}  // namespace
}  // namespace calc::tests::luminaires_xml_test
