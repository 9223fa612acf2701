// <route>: what is read, and verbatim what is refused.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::route_xml_test {
namespace {

using ::testing::HasSubstr;

const std::vector<MessageCase> kCases{
    {"RouteWithoutPoints", in_room(R"(<route id="p" width="1"/>)"),
     "dir/p.xml:5:1: error[missing-attribute]: <route> needs the attribute 'points'"},
    {"RouteWithoutWidth", in_room(R"(<route id="p" points="0 0 0 1 0 0"/>)"),
     "dir/p.xml:5:1: error[missing-attribute]: <route> needs the attribute 'width'"},
    {"RouteOfOneCorner", in_room(R"(<route id="p" points="0 0 0" width="1"/>)"),
     "dir/p.xml:5:15: error[wrong-number-count]: attribute 'points' of <route>: expected 2 to 200 "
     "corners of 3 numbers (x y z), found 3 numbers"},
    {"RouteOfPairs", in_room(R"(<route id="p" points="0 0 1 0" width="1"/>)"),
     "dir/p.xml:5:15: error[wrong-number-count]: attribute 'points' of <route>: expected 2 to 200 "
     "corners of 3 numbers (x y z), found 4 numbers"},
    {"RouteWithoutExtent", in_room(R"(<route id="p" points="0 0 0 1 0 0" width="0"/>)"),
     "dir/p.xml:5:36: error[number-out-of-range]: attribute 'width' of <route>: 0 is not allowed; "
     "expected a number above 0, up to 1e9"},
    {"RouteWithOneCornerTwice", in_room(R"(<route id="p" points="0 0 0 1 0 0 1 0 0" width="1"/>)"),
     "dir/p.xml:5:15: error[route-shape]: attribute 'points' of <route>: corners 2 and 3 are the "
     "same point; give each corner once"},
    {"RouteThatFoldsOver",
     in_room(R"(<route id="p" points="0 0 0 1 0 0 1 1 0 0 1 0" width="1.5"/>)"),
     "dir/p.xml:5:15: error[route-shape]: attribute 'points' of <route>: the leg from corner 2 to "
     "corner 3 is 1 m long, too short for its turns: with a width of 1.5 m at least 1.5 m are "
     "needed"},
    {"RouteWithCount", in_room(R"(<route id="p" points="0 0 0 1 0 0" width="1" count="3 3"/>)"),
     "dir/p.xml:5:46: error[unknown-attribute]: unknown attribute 'count' of <route>; allowed: "
     "id, name, was, tags, points, width, height or spacing"},
    {"RouteNamedAsAPlane", in_room(R"(<route id="task" points="0 0 0 1 0 0" width="1"/>)"),
     "dir/p.xml:7:8: error[duplicate-id]: the plane 'task' is given twice, also in line 5"},
};

class RouteXmlMessages : public ::testing::TestWithParam<MessageCase> {};

TEST_P(RouteXmlMessages, AreVerbatim) {
  EXPECT_EQ(load(files_for_messages(GetParam().xml)).messages, GetParam().messages);
}

INSTANTIATE_TEST_SUITE_P(All, RouteXmlMessages, ::testing::ValuesIn(kCases), case_name);

// Lengths are in the project's unit, places in the room's coordinates.
TEST(RouteXml, IsReadInWorldCoordinatesAndMetres) {
  const std::string xml =
      "<luxgate version='1' units='mm'><material id='white' reflectance='0.7'/>"
      "<luminaire-type id='spot' photometry='spot.ies'/>"
      "<room id='r' origin='1000 2000 500' size='4000 3000 2500' ceiling='white' walls='white' "
      "floor='white'><luminaire id='l' type='spot' position='2000 1500 2500'/>"
      "<route id='out' name='Way out' points='0 1000 0  2000 1000 0  2000 3000 100' width='1200' "
      "height='20' spacing='400 300'><require quantity='minimum' at-least='1'/></route>"
      "</room></luxgate>";
  const Loaded loaded = load(files_for_messages(xml));
  ASSERT_TRUE(loaded.project.has_value()) << loaded.messages;
  EXPECT_EQ(loaded.messages, "");
  const CalcPlane& plane = loaded.project->spaces.at(0).planes.at(0);
  EXPECT_EQ(plane.id, "out");
  EXPECT_EQ(plane.name, "Way out");
  EXPECT_EQ(plane.requirements.size(), 1u);
  const auto& route = std::get<EscapeRoute>(plane.area);
  ASSERT_EQ(route.line.corner_m.size(), 3u);
  EXPECT_NEAR(glm::distance(route.line.corner_m[0], {1, 3, 0.5}), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(route.line.corner_m[2], {3, 5, 0.6}), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(route.line.width_m, 1.2);
  EXPECT_DOUBLE_EQ(route.height_m, 0.02);
  EXPECT_TRUE(route.is_spacing_given);
  EXPECT_DOUBLE_EQ(route.spacing.along_u_m, 0.4);
  EXPECT_DOUBLE_EQ(route.spacing.along_v_m, 0.3);
}

TEST(RouteXml, MayStandInTheOpenAndNeedsNoSpacing) {
  const Loaded loaded =
      load(files_for_messages(in_project("<luminaire id='l' type='spot' position='0 0 3'/>"
                                         "<route id='out' points='0 0 0  5 0 0' width='2'/>")));
  ASSERT_TRUE(loaded.project.has_value()) << loaded.messages;
  const auto& route = std::get<EscapeRoute>(loaded.project->spaces.at(0).planes.at(0).area);
  EXPECT_FALSE(route.is_spacing_given);
  EXPECT_DOUBLE_EQ(route.spacing.along_u_m, kRouteSpacing_m);
  EXPECT_DOUBLE_EQ(route.height_m, 0.0);
}

TEST(RouteXml, WarnsIfEveryLuminaireIsBelow) {
  const Loaded loaded =
      load(files_for_messages(in_project("<luminaire id='l' type='spot' position='0 0 -3'/>"
                                         "<route id='out' points='0 0 0  5 0 0' width='2'/>")));
  EXPECT_THAT(loaded.messages, HasSubstr("warning[plane-faces-away]: plane 'out'"));
}

}  // namespace
}  // namespace calc::tests::route_xml_test
