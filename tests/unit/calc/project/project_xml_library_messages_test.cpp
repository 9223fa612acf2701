// Verbatim messages about elements in general, materials, luminaire types and light scenes.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::project_xml_library_messages_test {
namespace {

const std::vector<MessageCase> kCases{
    {"UnknownElement", in_project(R"(<rooom id="r"/>)"),
     "dir/p.xml:4:1: error[unknown-element]: unknown element <rooom> in <luxgate>; allowed: "
     "about, maintenance-plan, material, luminaire-type, scene, room, road, building, plane, "
     "route, energy, "
     "box, quad, polygon, mesh, assembly, "
     "luminaire, luminaire-grid, luminaire-line, luminaire-ring or "
     "luminaires; did you mean 'room'?"},
    {"UnknownAttribute", in_project(R"(<material id="dark" reflectance="0.1"
  reflectence="0.2"/>)"),
     "dir/p.xml:5:3: error[unknown-attribute]: unknown attribute 'reflectence' of <material>; "
     "allowed: id or reflectance; did you mean 'reflectance'?"},
    {"DuplicateAttribute",
     in_project(R"(<material id="dark" reflectance="0.1" reflectance="0.2"/>)"),
     "dir/p.xml:4:39: error[duplicate-attribute]: <material> has the attribute 'reflectance' "
     "twice"},
    {"TextInElement",
     in_project(R"(<material id="dark" reflectance="0.1"> matt paint </material>)"),
     "dir/p.xml:4:40: error[xml-text]: unexpected text 'matt paint' in <material>; all values are "
     "written as attributes"},
    {"MissingAttribute", in_project(R"(<material id="dark"/>)"),
     "dir/p.xml:4:1: error[missing-attribute]: <material> needs the attribute 'reflectance'"},
    {"EmptyAttribute", in_project(R"(<material id="" reflectance="0.1"/>)"),
     "dir/p.xml:4:11: error[empty-attribute]: attribute 'id' of <material> must not be empty"},
    {"BlankGroup", in_room(R"(<luminaire id="k" type="spot" position="2 1.5 2.5" group=" "/>)"),
     "dir/p.xml:5:52: error[empty-attribute]: attribute 'group' of <luminaire> must not be empty"},
    {"BadId", in_project(R"(<material id="dark wood" reflectance="0.1"/>)"),
     "dir/p.xml:4:11: error[not-an-id]: attribute 'id' of <material>: 'dark wood' is not an id; "
     "allowed are the letters A-Z and a-z, digits, and _ . : -"},
    {"ReflectanceAboveOne", in_project(R"(<material id="mirror" reflectance="1.2"/>)"),
     "dir/p.xml:4:23: error[number-out-of-range]: attribute 'reflectance' of <material>: 1.2 is "
     "not allowed; expected a number from 0 to 1"},
    {"ReflectanceNan", in_project(R"(<material id="mirror" reflectance="nan"/>)"),
     "dir/p.xml:4:23: error[not-a-number]: attribute 'reflectance' of <material>: 'nan' is not a "
     "finite number; expected a number from 0 to 1"},
    {"DecimalComma", in_project(R"(<material id="dark" reflectance="0,1"/>)"),
     "dir/p.xml:4:21: error[not-a-number]: attribute 'reflectance' of <material>: '0,1' is not a "
     "finite number; expected a number from 0 to 1 (decimals have a point, blanks separate "
     "numbers)"},
    {"TextForNumber", in_project(R"(<material id="dark" reflectance="low"/>)"),
     "dir/p.xml:4:21: error[not-a-number]: attribute 'reflectance' of <material>: 'low' is not a "
     "finite number; expected a number from 0 to 1"},
    {"DuplicateMaterial", in_project(R"(<material id="white" reflectance="0.8"/>)"),
     "dir/p.xml:4:11: error[duplicate-id]: the material 'white' is given twice, also in line 2"},
    {"UnusualReflectance", in_room(R"(</room><material id="snow" reflectance="0.97"/>
<room id="q" origin="10 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)"),
     "dir/p.xml:5:28: warning[reflectance-very-high]: material 'snow': a reflectance of 0.97 is "
     "unusual; white paint and tiles stay at 0.9 or below"},
    {"AbsentPhotometry", in_project(R"(<luminaire-type id="t" photometry="none.ies"/>)"),
     "dir/p.xml:4:24: error[file-not-readable]: cannot read 'dir/none.ies': No such file or "
     "directory"},
    {"BrokenPhotometry", in_project(R"(<luminaire-type id="t" photometry="broken.ies"/>)"),
     "dir/broken.ies: error[photometry-format]: not a photometry file that luxgate reads: no TILT= "
     "line, and lines 2 to 4 are not the three counts of EULUMDAT; readable: LM-63 (.ies), "
     "EULUMDAT "
     "(.ldt), TM-33 (.xml) and GLDF (.gldf)"},
    {"LampSetOfLm63", in_project(R"(<luminaire-type id="t" photometry="spot.ies" lamp-set="1"/>)"),
     "dir/p.xml:4:24: error[photometry-option-unused]: 'dir/spot.ies' is an LM-63 file, which has "
     "no lamp sets to choose; leave out 'lamp-set'"},
    {"AbsentLampSet", in_project(R"(<luminaire-type id="t" photometry="two.ldt" lamp-set="3"/>)"),
     "dir/p.xml:4:24: error[photometry-choice]: dir/two.ldt has no lamp set '3'; allowed: 1 (warm, "
     "1000 lm), 2 (cold, 1200 lm)"},
    {"LampSetZero", in_project(R"(<luminaire-type id="t" photometry="two.ldt" lamp-set="0"/>)"),
     "dir/p.xml:4:45: error[number-out-of-range]: attribute 'lamp-set' of <luminaire-type>: 0 is "
     "not allowed; expected a whole number from 1"},
    {"AbsentEmitter", in_project(R"(<luminaire-type id="t" photometry="two.xml" emitter="x"/>)"),
     "dir/p.xml:4:24: error[photometry-choice]: dir/two.xml has no emitter 'x'; allowed: led, 2"},
    {"NoVariantChosen", in_project(R"(<luminaire-type id="t" photometry="two.gldf"/>)"),
     "dir/p.xml:4:24: error[photometry-choice-needed]: there are 2 variants with different light; "
     "choose one with 'variant': down, up"},
    {"AbsentVariant", in_project(R"(<luminaire-type id="t" photometry="two.gldf" variant="x"/>)"),
     "dir/p.xml:4:24: error[photometry-choice]: dir/two.gldf has no variant 'x'; allowed: down, "
     "up"},
    {"PathLeavesFolder", in_project(R"(<luminaire-type id="t" photometry="a/../../spot.ies"/>)"),
     "dir/p.xml:4:24: error[file-outside-project]: 'a/../../spot.ies' leaves the project's folder; "
     "files are read from that folder and below it only"},
    {"AbsolutePath", in_project(R"(<luminaire-type id="t" photometry="/etc/passwd"/>)"),
     "dir/p.xml:4:24: error[file-outside-project]: '/etc/passwd' leaves the project's folder; "
     "files are read from that folder and below it only"},
    {"MaintenanceFactorZero",
     in_project(R"(<luminaire-type id="t" photometry="spot.ies" maintenance-factor="0"/>)"),
     "dir/p.xml:4:46: error[number-out-of-range]: attribute 'maintenance-factor' of "
     "<luminaire-type>: 0 is not allowed; expected a number above 0, up to 1"},
    {"BothMaintenanceForms",
     in_project(
         R"(<luminaire-type id="t" photometry="spot.ies" maintenance-factor="0.8" lmf="0.9"/>)"),
     "dir/p.xml:4:71: error[exclusive-attributes]: <luminaire-type> has both 'maintenance-factor' "
     "and 'lmf'; give only one of them"},
    {"PackageWithoutPower", in_project(R"(<luminaire-type id="t" photometry="spot.ies">
<package article="warm-900" flux-lm="900"/></luminaire-type>)"),
     "dir/p.xml:5:1: error[missing-attribute]: <package> needs the attribute 'power-w'"},
    {"PackageTwice", in_project(R"(<luminaire-type id="t" photometry="spot.ies">
<package article="warm" flux-lm="900" power-w="9"/>
<package article="warm" flux-lm="800" power-w="9"/></luminaire-type>)"),
     "dir/p.xml:6:10: error[duplicate-id]: the package 'warm' is given twice, also in line 5"},
    {"UnknownPackage", in_project(R"(<luminaire-type id="t" photometry="spot.ies" package="warms">
<package article="warm" flux-lm="900" power-w="9"/></luminaire-type>)"),
     "dir/p.xml:4:46: error[unknown-reference]: attribute 'package' of <luminaire-type>: there is "
     "no package 'warms'; defined: warm; did you mean 'warm'?"},
    {"PackageAndPower",
     in_project(R"(<luminaire-type id="t" photometry="spot.ies" package="warm" power-w="8">
<package article="warm" flux-lm="900" power-w="9"/></luminaire-type>)"),
     "dir/p.xml:4:61: error[exclusive-attributes]: <luminaire-type> has both 'package' and "
     "'power-w'; give only one of them"},
    {"UnknownOpening",
     in_project(R"(<luminaire-type id="t" photometry="spot.ies" opening="points"/>)"),
     "dir/p.xml:4:46: error[unknown-value]: attribute 'opening' of <luminaire-type>: unknown value "
     "'points'; allowed: file or point; did you mean 'point'?"},
    {"UnknownDimmingGroup",
     in_room(R"(</room><scene id="night"><dim group="rows" level="0.2"/></scene>
<room id="q" size="4 3 2.5" ceiling="white" walls="white" floor="white">)"),
     "dir/p.xml:5:31: error[unknown-reference]: attribute 'group' of <dim>: there is no luminaire "
     "with the dimming group 'rows'; defined: row; did you mean 'row'?"},
    {"LevelTwo", in_room(R"(</room><scene id="night"><dim group="row" level="2"/></scene>
<room id="q" size="4 3 2.5" ceiling="white" walls="white" floor="white">)"),
     "dir/p.xml:5:43: error[number-out-of-range]: attribute 'level' of <dim>: 2 is not allowed; "
     "expected a number from 0 to 1"},
    {"GroupDimmedTwice",
     in_room(
         R"(</room><scene id="night"><dim group="row" level="1"/><dim group="row" level="0"/></scene>
<room id="q" size="4 3 2.5" ceiling="white" walls="white" floor="white">)"),
     "dir/p.xml:5:54: error[duplicate-id]: the dimming group 'row' is given twice, also in line 5"},
};

class ProjectXmlLibraryMessages : public ::testing::TestWithParam<MessageCase> {};

TEST_P(ProjectXmlLibraryMessages, AreVerbatim) {
  const Loaded loaded = load(files_for_messages(GetParam().xml));
  EXPECT_EQ(loaded.messages, GetParam().messages);
  // Warnings alone leave a project.
  EXPECT_EQ(loaded.project.has_value(), loaded.messages.find("error[") == std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ProjectXmlLibraryMessages, ::testing::ValuesIn(kCases), case_name);

}  // namespace
}  // namespace calc::tests::project_xml_library_messages_test
