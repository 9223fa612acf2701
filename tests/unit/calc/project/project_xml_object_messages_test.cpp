// Verbatim messages about rooms, objects and luminaires.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::project_xml_object_messages_test {
namespace {

const std::vector<MessageCase> kCases{
    {"RoomWithoutShape",
     in_project(R"(<room id="r" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:1: error[missing-form]: <room> needs 'size', or 'footprint' and 'height'"},
    {"RoomWithBothShapes",
     in_project(
         R"(<room id="r" size="1 1 1" footprint="0 0 1 0 1 1" height="3" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:27: error[exclusive-attributes]: <room> has both 'size' and 'footprint'; give "
     "only one of them"},
    {"FootprintWithoutHeight",
     in_project(
         R"(<room id="r" footprint="0 0 1 0 1 1" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:14: error[missing-partner]: <room> has 'footprint' without 'height'; the two "
     "belong together"},
    {"OddFootprint",
     in_project(
         R"(<room id="r" footprint="0 0 1 0 1 1 3" height="3" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:14: error[wrong-number-count]: attribute 'footprint' of <room>: expected 3 to "
     "2000 corners of 2 numbers (x y), found 7 numbers"},
    {"SelfCrossingFootprint",
     in_project(
         R"(<room id="r" footprint="0 0 2 2 2 0 0 2" height="3" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:14: error[not-simple-polygon]: attribute 'footprint' of <room>: the corners must "
     "span an area, sides must not cross or touch, and the first corner is not repeated at the "
     "end"},
    {"RoomTooThin",
     in_project(R"(<room id="r" size="1e-300 3 2" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:14: error[not-simple-polygon]: attribute 'size' of <room>: the corners must "
     "span an area, sides must not cross or touch, and the first corner is not repeated at the "
     "end"},
    {"RoomOfZeroHeight",
     in_project(R"(<room id="r" size="4 3 0" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:14: error[number-out-of-range]: attribute 'size' of <room>: 0 is not allowed; "
     "expected a number above 0, up to 1e9"},
    {"RoomNamedSite",
     in_project(R"(<room id="site" size="4 3 3" ceiling="white" walls="white" floor="white"/>)"),
     "dir/p.xml:4:7: error[reserved-id]: the id 'site' is reserved for the open space; choose "
     "another one"},
    {"TooFewWallMaterials",
     in_project(
         R"(<room id="r" size="4 3 3" ceiling="white" walls="white" floor="white" wall-materials="white white"/>)"),
     "dir/p.xml:4:71: error[wrong-number-count]: attribute 'wall-materials' of <room>: expected 4 "
     "materials, one for each wall, found 2"},
    {"UnknownMaterial", in_room(R"(<box id="b" size="1 1 1" material="whit"/>)"),
     "dir/p.xml:5:26: error[unknown-reference]: attribute 'material' of <box>: there is no "
     "material 'whit'; defined: white; did you mean 'white'?"},
    {"UnknownLuminaireType", in_room(R"(<luminaire id="k" type="sport" position="1 1 1"/>)"),
     "dir/p.xml:5:19: error[unknown-reference]: attribute 'type' of <luminaire>: there is no "
     "luminaire type 'sport'; defined: spot; did you mean 'spot'?"},
    {"DuplicateObject", in_room(R"(<box id="b" size="1 1 1" material="white"/>
<quad id="b" origin="0 0 1" u="1 0 0" v="0 1 0" material="white"/>)"),
     "dir/p.xml:6:7: error[duplicate-id]: the object 'b' is given twice, also in line 5"},
    {"SameIdByAssembly", in_room(R"(<box id="a.b" size="1 1 1" material="white"/>
<assembly id="a">
  <box id="b" size="1 1 1" material="white"/></assembly>)"),
     "dir/p.xml:7:3: error[duplicate-id]: the object 'a.b' is given twice, also in line 5"},
    {"SameIdAsShell", in_room(R"(<box id="r.wall1" size="1 1 1" material="white"/>)"),
     "dir/p.xml:5:1: error[duplicate-id]: the object 'r.wall1' is given twice, also in line 4"},
    {"NegativeSize", in_room(R"(<box id="b" size="1 -1 1" material="white"/>)"),
     "dir/p.xml:5:13: error[number-out-of-range]: attribute 'size' of <box>: -1 is not allowed; "
     "expected a number above 0, up to 1e9"},
    {"TooFewNumbers", in_room(R"(<box id="b" size="1 1" material="white"/>)"),
     "dir/p.xml:5:13: error[wrong-number-count]: attribute 'size' of <box>: expected 3 numbers (x "
     "y z), found 2 numbers"},
    {"TooManyNumbers", in_room(R"(<box id="b" size="1 1 1" position="1 2 3 4" material="white"/>)"),
     "dir/p.xml:5:26: error[wrong-number-count]: attribute 'position' of <box>: expected 3 numbers "
     "(x y z), found 4 numbers"},
    {"RepeatWithoutStep", in_room(R"(<box id="b" size="1 1 1" material="white" repeat="2 1 1"/>)"),
     "dir/p.xml:5:43: error[missing-partner]: <box> has 'repeat' without 'step'; the two belong "
     "together"},
    {"RepeatWithZeroStep",
     in_room(R"(<box id="b" size="1 1 1" material="white" repeat="2 1 1" step="0 2 0"/>)"),
     "dir/p.xml:5:58: error[number-out-of-range]: attribute 'step' of <box>: 0 is not allowed; "
     "expected a distance other than 0 wherever 'repeat' is above 1"},
    {"RepeatOfHalves",
     in_room(R"(<box id="b" size="1 1 1" material="white" repeat="2.5 1 1" step="1 0 0"/>)"),
     "dir/p.xml:5:43: error[not-an-integer]: attribute 'repeat' of <box>: '2.5' is not a whole "
     "number; expected a whole number from 1"},
    {"TooManyInstances",
     in_room(R"(<box id="b" size="1 1 1" material="white" repeat="2000 2000 1" step="1 1 0"/>)"),
     "dir/p.xml:5:1: error[beyond-limit]: 'b' brings the model to 4000000 objects and "
     "luminaires; at most 250000 are allowed, see --limit objects"},
    {"FlatQuad", in_room(R"(<quad id="q" origin="0 0 1" u="1 0 0" v="-2 0 0" material="white"/>)"),
     "dir/p.xml:5:29: error[parallel-vectors]: attributes 'u' and 'v' of <quad> must span an area, "
     "but they are parallel or zero"},
    {"PolygonNotFlat",
     in_room(R"(<polygon id="q" points="0 0 1  1 0 1  1 1 1  0 1 2" material="white"/>)"),
     "dir/p.xml:5:17: error[not-simple-polygon]: attribute 'points' of <polygon>: the corners must "
     "lie in one plane and span an area, sides must not cross or touch, and the first corner is "
     "not repeated at the end"},
    {"UnmappedMeshMaterials", in_room(R"(<mesh id="m" file="table.obj" units="m" up="z"/>)"),
     "dir/p.xml:5:1: error[unmapped-mesh-materials]: mesh 'm': no material for faces without a "
     "material, 'wood'; add <map name=\"...\" material=\"...\"/> for each, or the attribute "
     "'material' for all that are not mapped"},
    {"UnknownMapName",
     in_room(
         R"(<mesh id="m" file="table.obj" units="m" up="z" material="white"><map name="wod" material="white"/></mesh>)"),
     "dir/p.xml:5:70: error[unknown-reference]: attribute 'name' of <map>: there is no material of "
     "the mesh 'wod'; defined: wood; did you mean 'wood'?"},
    {"UnknownUpAxis",
     in_room(R"(<mesh id="m" file="table.obj" material="white" up="x" units="m"/>)"),
     "dir/p.xml:5:48: error[unknown-value]: attribute 'up' of <mesh>: unknown value 'x'; allowed: "
     "z or y"},
    {"MeshWithoutUnits", in_room(R"(<mesh id="m" file="table.obj" material="white" up="z"/>)"),
     "dir/p.xml:5:1: error[missing-attribute]: <mesh> needs the attribute 'units'"},
    {"MeshWithoutUp", in_room(R"(<mesh id="m" file="table.obj" material="white" units="m"/>)"),
     "dir/p.xml:5:1: error[missing-attribute]: <mesh> needs the attribute 'up'"},
    {"GltfInMillimetres",
     in_room(R"(<mesh id="m" file="tile.gltf" material="white" units="mm" up="y"/>)"),
     "dir/p.xml:5:48: error[mesh-units-fixed]: attribute 'units' of <mesh>: a gltf file is always "
     "in metres with y up; leave the attribute out or write 'm'"},
    {"GltfWithZUp", in_room(R"(<mesh id="m" file="tile.gltf" material="white" up="z"/>)"),
     "dir/p.xml:5:48: error[mesh-units-fixed]: attribute 'up' of <mesh>: a gltf file is always in "
     "metres with y up; leave the attribute out or write 'y'"},
    {"MeshOfAnotherFormat",
     in_room(R"(<mesh id="m" file="table.obj" format="stl" units="m" up="z" material="white"/>)"),
     "dir/table.obj: error[mesh-other-format]: the format is given as stl, but the file is obj"},
    {"AbsentMesh", in_room(R"(<mesh id="m" file="chair.obj" material="white"/>)"),
     "dir/p.xml:5:14: error[file-not-readable]: cannot read 'dir/chair.obj': No such file or "
     "directory"},
    {"PlaneInAssembly", in_room(R"(<assembly id="a"><plane id="p" height="1"/></assembly>)"),
     "dir/p.xml:5:18: error[unknown-element]: unknown element <plane> in <assembly>; allowed: box, "
     "quad, polygon, mesh, assembly, luminaire, luminaire-grid, luminaire-line, luminaire-ring or "
     "luminaires"},
    {"AxisAndAim",
     in_room(R"(<luminaire id="k" type="spot" position="1 1 1" axis="0 0 -1" aim="0 0 0"/>)"),
     "dir/p.xml:5:62: error[exclusive-attributes]: <luminaire> has both 'axis' and 'aim'; give "
     "only one of them"},
    {"RotationAndC0",
     in_room(R"(<luminaire id="k" type="spot" position="1 1 1" rotation="90" c0="1 0 0"/>)"),
     "dir/p.xml:5:62: error[exclusive-attributes]: <luminaire> has both 'rotation' and 'c0'; give "
     "only one of them"},
    {"ZeroAxis", in_room(R"(<luminaire id="k" type="spot" position="1 1 1" axis="0 0 0"/>)"),
     "dir/p.xml:5:48: error[zero-vector]: attribute 'axis' of <luminaire>: the direction must not "
     "be zero"},
    {"AimAtItself", in_room(R"(<luminaire id="k" type="spot" position="1 1 1" aim="1 1 1"/>)"),
     "dir/p.xml:5:48: error[aim-at-itself]: attribute 'aim' of <luminaire> is the luminaire's own "
     "position; it must be another point"},
    {"C0AlongAxis", in_room(R"(<luminaire id="k" type="spot" position="1 1 1" c0="0 0 2"/>)"),
     "dir/p.xml:5:48: error[c0-parallel-to-axis]: attribute 'c0' of <luminaire> must not be zero "
     "or parallel to the luminaire's axis"},
    {"GridWithoutRows",
     in_room(
         R"(<luminaire-grid id="g" type="spot" origin="0 0 2" size="4 3" rows="0" columns="2"/>)"),
     "dir/p.xml:5:62: error[number-out-of-range]: attribute 'rows' of <luminaire-grid>: 0 is not "
     "allowed; expected a whole number from 1"},
    {"LineOfOneAtTheEnds",
     in_room(
         R"(<luminaire-line id="g" type="spot" from="0 0 2" to="1 0 2" count="1" edge="end"/>)"),
     "dir/p.xml:5:60: error[number-out-of-range]: attribute 'count' of <luminaire-line>: 1 is not "
     "allowed; expected a whole number from 2 with edge=\"end\""},
    {"LineWithoutLength",
     in_room(R"(<luminaire-line id="g" type="spot" from="0 0 2" to="0 0 2" count="2"/>)"),
     "dir/p.xml:5:49: error[line-without-length]: attributes 'from' and 'to' of <luminaire-line> "
     "are the same point"},
    {"RingWithoutRadius",
     in_room(R"(<luminaire-ring id="g" type="spot" centre="2 1 2" radius="0" count="4"/>)"),
     "dir/p.xml:5:51: error[number-out-of-range]: attribute 'radius' of <luminaire-ring>: 0 is not "
     "allowed; expected a number above 0, up to 1e9"},
};

class ProjectXmlObjectMessages : public ::testing::TestWithParam<MessageCase> {};

TEST_P(ProjectXmlObjectMessages, AreVerbatim) {
  const Loaded loaded = load(files_for_messages(GetParam().xml));
  EXPECT_EQ(loaded.messages, GetParam().messages);
  // Warnings alone leave a project.
  EXPECT_EQ(loaded.project.has_value(), loaded.messages.find("error[") == std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ProjectXmlObjectMessages, ::testing::ValuesIn(kCases), case_name);

}  // namespace
}  // namespace calc::tests::project_xml_object_messages_test
