// Verbatim messages about calculation planes, and the warnings.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::project_xml_plane_messages_test {
namespace {

std::string many_tags() {
  std::string tags = "t";
  for (int i = 0; i < 32; ++i) tags += " t";
  return tags;
}

const std::vector<MessageCase> kCases{
    {"DuplicatePlane", in_room(R"(<plane id="task" height="1"/>)"),
     "dir/p.xml:7:8: error[duplicate-id]: the plane 'task' is given twice, also in line 5"},
    {"TagThatIsNoWord", in_room(R"(<plane id="p" tags="a b/c" height="0.8"/>)"),
     "dir/p.xml:5:15: error[not-an-id]: attribute 'tags' of <plane>: 'b/c' is not an id; allowed "
     "are "
     "the letters A-Z and a-z, digits, and _ . : -"},
    {"TagsWithoutOne", in_room(R"(<plane id="p" tags=" " height="0.8"/>)"),
     "dir/p.xml:5:15: error[empty-attribute]: attribute 'tags' of <plane> must not be empty"},
    {"TagsThatAreTooMany", in_room("<plane id=\"p\" tags=\"" + many_tags() + "\" height=\"0.8\"/>"),
     "dir/p.xml:5:15: error[wrong-number-count]: attribute 'tags' of <plane>: expected 1 to 32 "
     "ids separated by blanks, found 33"},
    {"PlaneThatWasOneThatIsThere", in_room(R"(<plane id="p" was="task" height="0.8"/>)"),
     "dir/p.xml:5:15: error[former-id-in-use]: was=\"task\": the plane 'task' still exists, in "
     "line 7, so nothing else can have had its id; remove 'was' when every compared revision has "
     "the new id"},
    {"TwoPlanesThatWereOne",
     in_room(R"(<plane id="p" was="old" height="0.8"/><plane id="q" was="old" height="1"/>)"),
     "dir/p.xml:5:53: error[former-id-twice]: was=\"old\": the plane 'p' says the same, in line 5; "
     "only one of them can have had this id"},
    {"FormerIdThatIsNone", in_room(R"(<plane id="p" was="" height="0.8"/>)"),
     "dir/p.xml:5:15: error[empty-attribute]: attribute 'was' of <plane> must not be empty"},
    {"PlaneWithoutForm", in_room(R"(<plane id="p"/>)"),
     "dir/p.xml:5:1: error[missing-form]: <plane> needs one of 'height', 'origin' with 'u' and "
     "'v', 'points', 'on', 'on-top-of' or 'file'"},
    {"PlaneWithTwoForms", in_room(R"(<plane id="p" height="0.8" on="floor"/>)"),
     "dir/p.xml:5:28: error[exclusive-attributes]: <plane> has both 'height' and 'on'; give only "
     "one of them"},
    {"PlaneWithStraySide", in_room(R"(<plane id="p" height="0.8" u="1 0 0"/>)"),
     "dir/p.xml:5:28: error[attribute-without-meaning]: <plane>: 'u' has no meaning together with "
     "'height'"},
    {"RectangleWithoutV", in_room(R"(<plane id="p" origin="0 0 1" u="1 0 0"/>)"),
     "dir/p.xml:5:1: error[missing-attribute]: <plane> needs the attribute 'v'"},
    {"PlaneNotPerpendicular", in_room(R"(<plane id="p" origin="0 0 1" u="1 0 0" v="1 1 0"/>)"),
     "dir/p.xml:5:30: error[not-perpendicular]: attributes 'u' and 'v' of <plane> must be "
     "perpendicular, but the angle between them is 45 degrees; use 'points' for other shapes"},
    {"PlaneSidesParallel", in_room(R"(<plane id="p" origin="0 0 1" u="1 0 0" v="1 0 0"/>)"),
     "dir/p.xml:5:30: error[parallel-vectors]: attributes 'u' and 'v' of <plane> must span an "
     "area, but they are parallel or zero"},
    {"RoomPlaneInOpenSpace", in_project(R"(<plane id="p" height="0.8"/>)"),
     "dir/p.xml:4:15: error[room-only]: 'height' of <plane> needs a <room> around it; in the open "
     "space use 'origin', 'u' and 'v', or 'points', 'on-top-of' or 'file'"},
    {"WallPlaneInOpenSpace", in_project(R"(<plane id="p" on="wall1"/>)"),
     "dir/p.xml:4:15: error[room-only]: 'on' of <plane> needs a <room> around it; in the open "
     "space use 'origin', 'u' and 'v', or 'points', 'on-top-of' or 'file'"},
    {"PlaneAboveCeiling", in_room(R"(<plane id="p" height="2.5"/>)"),
     "dir/p.xml:5:15: error[number-out-of-range]: attribute 'height' of <plane>: 2.5 is not "
     "allowed; expected a number from 0 to below the room's height 2.5"},
    {"UnknownWall", in_room(R"(<plane id="p" on="wall5"/>)"),
     "dir/p.xml:5:15: error[unknown-value]: attribute 'on' of <plane>: unknown value 'wall5'; "
     "allowed: floor, ceiling, wall1, wall2, wall3 or wall4; did you mean 'wall1'?"},
    {"UnknownBox", in_room(R"(<box id="desk" size="1 1 1" material="white"/>
<plane id="p" on-top-of="dsk"/>)"),
     "dir/p.xml:6:15: error[unknown-reference]: attribute 'on-top-of' of <plane>: there is no box "
     "'dsk'; defined: desk; did you mean 'desk'?"},
    {"RepeatedBoxWithoutIndices",
     in_room(R"(<box id="desk" size="1 1 1" material="white" repeat="2 1 1" step="2 0 0"/>
<plane id="p" on-top-of="desk"/>)"),
     "dir/p.xml:6:15: error[unknown-reference]: attribute 'on-top-of' of <plane>: there is no box "
     "'desk'; defined: desk[0,0,0]"},
    {"CountZero", in_room(R"(<plane id="p" height="0.8" count="0 4"/>)"),
     "dir/p.xml:5:28: error[number-out-of-range]: attribute 'count' of <plane>: 0 is not allowed; "
     "expected a whole number from 1"},
    {"HugeCount", in_room(R"(<plane id="p" height="0.8" count="2000 2000"/>)"),
     "dir/p.xml:5:28: error[number-out-of-range]: attribute 'count' of <plane>: 2000 x 2000 is not "
     "allowed; expected at most 1000000 points"},
    {"CountAndSpacing", in_room(R"(<plane id="p" height="0.8" count="2 2" spacing="0.5"/>)"),
     "dir/p.xml:5:40: error[exclusive-attributes]: <plane> has both 'count' and 'spacing'; give "
     "only one of them"},
    {"NegativeMargin", in_room(R"(<plane id="p" height="0.8" margin="-0.5"/>)"),
     "dir/p.xml:5:28: error[number-out-of-range]: attribute 'margin' of <plane>: -0.5 is not "
     "allowed; expected a number from 0 to 1e9"},
    {"ThreeSpacings", in_room(R"(<plane id="p" height="0.8" spacing="1 2 3"/>)"),
     "dir/p.xml:5:28: error[wrong-number-count]: attribute 'spacing' of <plane>: expected 1 or 2 "
     "numbers (along u and v), found 3 numbers"},
    {"HoleWithoutPoints",
     in_room(R"(<plane id="p" height="0.8"><hole points="0 0 0 1 0 0 1 1 0"/></plane>)"),
     "dir/p.xml:5:28: error[hole-without-points]: <hole> is for a <plane> given by 'points'"},
    {"HoleOutsidePlane",
     in_room(
         R"(<plane id="p" points="0 0 1  2 0 1  2 2 1"><hole points="1 0.5 1  3 0.5 1  1.5 1 1"/></plane>)"),
     "dir/p.xml:5:50: error[hole-outside-plane]: attribute 'points' of <hole>: the corner 3 0.5 1 "
     "is not in the plane's area"},
    {"MarginOfPointList", in_room(R"(<plane id="p" file="points.csv" margin="0.5"/>)"),
     "dir/p.xml:5:33: error[attribute-without-meaning]: <plane>: 'margin' has no meaning together "
     "with 'file'"},
    {"BadPointListLines", in_room(R"(<plane id="p" file="bad.csv"/>)"),
     "dir/bad.csv:3: error[point-list-line]: expected 6 numbers separated by commas "
     "(x,y,z,nx,ny,nz), found 5\n"
     "dir/bad.csv:4: error[point-list-number]: 'x' is not a number from -1e9 to 1e9"},
    {"ZeroNormal", in_room(R"(<plane id="p" file="zero.csv"/>)"),
     "dir/zero.csv:2: error[point-list-zero-normal]: the normal (nx,ny,nz) is zero; it must be the "
     "direction that the point faces"},
    {"BadPointListHeader", in_room(R"(<plane id="p" file="head.csv"/>)"),
     "dir/head.csv:1:2: error[csv-separator]: cells are separated by semicolons; commas are needed "
     "between cells, and decimal points in numbers"},
    {"EmptyPointList", in_room(R"(<plane id="p" file="empty.csv"/>)"),
     "dir/empty.csv:1: error[point-list-empty]: no points after the header line"},
    {"UnknownQuantity", in_room(R"(<plane id="p" height="1.2" quantity="cylindric"/>)"),
     "dir/p.xml:5:28: error[unknown-value]: attribute 'quantity' of <plane>: unknown value "
     "'cylindric'; allowed: planar, cylindrical, semicylindrical, hemispherical, scalar, ugr, "
     "modelling or cylindrical-4; did you mean 'cylindrical'?"},
    {"SemicylindricalWithoutDirection",
     in_room(R"(<plane id="p" height="1.5" quantity="semicylindrical"/>)"),
     "dir/p.xml:5:28: error[missing-partner]: <plane> has 'quantity=\"semicylindrical\"' without "
     "'direction'; the two belong together"},
    {"DirectionWithoutSemicylindrical",
     in_room(R"(<plane id="p" height="1.5" quantity="cylindrical" direction="1 0 0"/>)"),
     "dir/p.xml:5:51: error[missing-partner]: <plane> has 'direction' without "
     "'quantity=\"semicylindrical\" or \"ugr\"'; the two belong together"},
    {"UgrWithoutDirection", in_room(R"(<plane id="p" height="1.2" quantity="ugr"/>)"),
     "dir/p.xml:5:28: error[missing-partner]: <plane> has 'quantity=\"ugr\"' without "
     "'direction'; the two belong together"},
    {"UgrLooksHorizontally",
     in_room(R"(<plane id="p" height="1.2" quantity="ugr" direction="1 0 -1"/>)"),
     "dir/p.xml:5:43: error[not-horizontal]: attribute 'direction' of <plane>: the direction must "
     "be horizontal, but it rises by -45 degrees"},
    {"DirectionOfModelling",
     in_room(R"(<plane id="p" height="1.2" quantity="modelling" direction="1 0 0"/>)"),
     "dir/p.xml:5:49: error[missing-partner]: <plane> has 'direction' without "
     "'quantity=\"semicylindrical\" or \"ugr\"'; the two belong together"},
    {"DirectionZero",
     in_room(R"(<plane id="p" height="1.5" quantity="semicylindrical" direction="0 0 0"/>)"),
     "dir/p.xml:5:55: error[zero-vector]: attribute 'direction' of <plane>: the direction must not "
     "be zero"},
    {"DirectionNotHorizontal",
     in_room(R"(<plane id="p" height="1.5" quantity="semicylindrical" direction="1 0 -1"/>)"),
     "dir/p.xml:5:55: error[not-horizontal]: attribute 'direction' of <plane>: the direction must "
     "be horizontal, but it rises by -45 degrees"},
    {"DirectionNotQuiteHorizontal",
     in_room(R"(<plane id="p" height="1.5" quantity="semicylindrical" direction="1 0 1.1e-6"/>)"),
     "dir/p.xml:5:55: error[not-horizontal]: attribute 'direction' of <plane>: the direction must "
     "be horizontal, but it rises by 6.30254e-05 degrees"},
    {"DirectionIsToldBesideOtherErrors",
     in_room(R"(<plane id="p" height="9" quantity="semicylindrical" direction="0 0 0"/>)"),
     "dir/p.xml:5:15: error[number-out-of-range]: attribute 'height' of <plane>: 9 is not "
     "allowed; expected a number from 0 to below the room's height 2.5\n"
     "dir/p.xml:5:53: error[zero-vector]: attribute 'direction' of <plane>: the direction must not "
     "be zero"},
    {"DirectionOfPointList",
     in_room(R"(<plane id="p" file="points.csv" quantity="semicylindrical" direction="1 0 0"/>)"),
     "dir/p.xml:5:60: error[attribute-without-meaning]: <plane>: 'direction' has no meaning "
     "together with 'file'"},
    {"SemicylindricalPointListFacesUp",
     in_room(R"(<plane id="p" file="looks.csv" quantity="semicylindrical"/>)"),
     "dir/p.xml:5:15: error[point-list-not-horizontal]: 2 of the 3 normals in 'looks.csv' are not "
     "horizontal; semicylindrical and UGR points need horizontal ones; the first is (0,0,1) in "
     "line 4"},
    {"LuminaireOutsideRoom", in_room(R"(<luminaire id="k" type="spot" position="1 1 2.6"/>)"),
     "dir/p.xml:5:1: warning[luminaire-outside-room]: luminaire 'k' is outside room 'r', 0.1 m "
     "above its ceiling: its light does not reach the room"},
    {"GridPartlyOutsideRoom",
     in_room(
         R"(<luminaire-grid id="g" type="spot" origin="0 0 2" size="8 3" rows="1" columns="4"/>)"),
     "dir/p.xml:5:1: warning[luminaire-outside-room]: luminaire 'g[2,0]' (and 1 more of this "
     "element) is outside room 'r': its light does not reach the room"},
    {"PlaneInSurfaceOfBox", in_room(R"(<box id="desk" size="1 1 0.75" material="white"/>)"),
     "dir/p.xml:7:1: warning[plane-in-surface]: plane 'task' is in a surface of 'desk'; use 'on' "
     "or 'on-top-of' if that surface is meant, else move the plane"},
    {"PlaneInFloor", in_room(R"(<plane id="p" height="0"/>)"),
     "dir/p.xml:5:1: warning[plane-in-surface]: plane 'p' is in a surface of 'r.floor'; use 'on' "
     "or 'on-top-of' if that surface is meant, else move the plane"},
    {"OpenObjectInsideRoom", in_room(R"(</room><box id="b" size="1 1 1" material="white"/>
<room id="q" origin="9 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)"),
     "dir/p.xml:5:8: warning[object-inside-room]: object 'b' is in the open space but within room "
     "'r', and the room ignores it; write it inside the <room>"},
    {"NoLuminaire", in_project(R"(<plane id="p" origin="0 0 0" u="1 0 0" v="0 1 0"/>)"),
     "dir/p.xml:1:1: warning[space-without-luminaires]: the open space has planes but no "
     "luminaire: every illuminance in it is 0"},
    {"NoPlane", in_project(R"(<box id="b" size="1 1 1" material="white"/>)"),
     "dir/p.xml: warning[project-without-planes]: the project has no <plane>: there is nothing to "
     "calculate"},
};

class ProjectXmlPlaneMessages : public ::testing::TestWithParam<MessageCase> {};

TEST_P(ProjectXmlPlaneMessages, AreVerbatim) {
  const Loaded loaded = load(files_for_messages(GetParam().xml));
  EXPECT_EQ(loaded.messages, GetParam().messages);
  // Warnings alone leave a project.
  EXPECT_EQ(loaded.project.has_value(), loaded.messages.find("error[") == std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ProjectXmlPlaneMessages, ::testing::ValuesIn(kCases), case_name);

}  // namespace
}  // namespace calc::tests::project_xml_plane_messages_test
