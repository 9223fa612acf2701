#include "report/tools/import/ifc_design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/unit/report/tools/import/ifc_text.h"

namespace ifc_design_test {
namespace {

using cli::Design;
using cli::DesignNote;
using cli::StepProblem;
using test_support::ifc_extrusion;
using test_support::ifc_file;
using test_support::ifc_places;
using test_support::ifc_space;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

Design read(const std::string& data, const std::string& schema = "IFC4") {
  StepProblem problem;
  auto design = cli::read_ifc(ifc_file(data, schema), "a.ifc", {}, problem);
  EXPECT_TRUE(design) << problem.what;
  return design.value_or(Design());
}

// "kind: count x what: why" of the notes whose reason has this in it.
std::vector<std::string> notes(const Design& design, const std::string& why) {
  std::vector<std::string> result;
  for (const DesignNote& note : design.note) {
    if (note.why.find(why) == std::string::npos) continue;
    const char* kind = note.kind == DesignNote::Kind::taken       ? "taken"
                       : note.kind == DesignNote::Kind::doubt     ? "doubt"
                       : note.kind == DesignNote::Kind::not_asked ? "not asked"
                                                                  : "left out";
    result.push_back(std::string(kind) + ": " + std::to_string(note.count) + " x " + note.what);
  }
  return result;
}

const std::string kRoom =
    ifc_space(ifc_extrusion("#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4000.,6000.);"));

// A place at (x, y, z) mm in #800, turned by x and z axes.
std::string place(int number, const std::string& at, const std::string& axes = "$,$") {
  const std::string n = std::to_string(number);
  return "#" + n + "0=IFCLOCALPLACEMENT(#800,#" + n + "1);#" + n + "1=IFCAXIS2PLACEMENT3D(#" + n +
         "2," + axes + ");#" + n + "2=IFCCARTESIANPOINT((" + at + "));";
}

TEST(IfcDesign, SaysWhatARoomIsCalled) {
  const Design design = read(kRoom +
                             "#30=IFCBUILDINGSTOREY('s',$,'Level 2',$,$,$,$,$,.ELEMENT.,3.);"
                             "#31=IFCRELAGGREGATES('r',$,$,$,#30,(#1));");
  ASSERT_EQ(design.room.size(), 1u);
  const cli::DesignRoom& room = design.room[0];
  EXPECT_EQ(room.source.key, "room-a");
  EXPECT_THAT(room.source.place, HasSubstr("#1, line "));
  EXPECT_EQ(room.number, "101");
  EXPECT_EQ(room.name, "Office");
  EXPECT_EQ(room.use, "office");
  EXPECT_EQ(room.storey, "Level 2");
  EXPECT_EQ(room.height_m, 3.0);
  EXPECT_EQ(design.unit, "mm");
  EXPECT_EQ(design.file, "a.ifc");
  EXPECT_EQ(design.origin_m, glm::dvec3(0.0));
}

TEST(IfcDesign, ThePropertyOfUseComesFirst) {
  const Design design =
      read(kRoom +
           "#31=IFCRELDEFINESBYPROPERTIES('r',$,$,$,(#1),#32);"
           "#32=IFCPROPERTYSET('s',$,'Pset_SpaceOccupancyRequirements',$,(#33));"
           "#33=IFCPROPERTYSINGLEVALUE('OccupancyType',$,IFCLABEL('B\\X2\\00FC\\X0\\ro'),$);");
  ASSERT_EQ(design.room.size(), 1u);
  EXPECT_EQ(design.room[0].use, "Büro");
}

TEST(IfcDesign, LettersOfUnknownAlphabetsAreSaid) {
  std::string data = kRoom;
  const auto rename = [&](const std::string& name) {
    std::string renamed = data;
    return read(renamed.replace(renamed.find("'Office'"), 8, "'" + name + "'"));
  };
  const Design known = rename("\\PB\\\\S\\C\\S\\f");
  ASSERT_EQ(known.room.size(), 1u);
  EXPECT_EQ(known.room[0].name, "Ăć");
  EXPECT_TRUE(notes(known, "escape").empty());
  const Design unknown = rename("B\\PX\\\\S\\|ro");
  ASSERT_EQ(unknown.room.size(), 1u);
  EXPECT_EQ(unknown.room[0].name, "B\\PX\\\uFFFDro");
  EXPECT_THAT(notes(unknown, "escape"), ElementsAre("doubt: 1 x text"));
}

TEST(IfcDesign, PlacesStandOnOneAnother) {
  // The storey is 3 m up and turned by 90 degrees, the space 10 m along its x.
  std::string data = kRoom;
  const std::string flat = "#800=IFCLOCALPLACEMENT($,#801);";
  const std::size_t at = data.find(flat);
  ASSERT_NE(at, std::string::npos);
  data.replace(at, flat.size(),
               "#800=IFCLOCALPLACEMENT(#50,#51);#51=IFCAXIS2PLACEMENT3D(#52,$,$);"
               "#52=IFCCARTESIANPOINT((10000.,0.,0.));#50=IFCLOCALPLACEMENT($,#53);"
               "#53=IFCAXIS2PLACEMENT3D(#54,#802,#55);#54=IFCCARTESIANPOINT((0.,0.,3000.));"
               "#55=IFCDIRECTION((0.,1.,0.));");
  const Design design = read(data);
  ASSERT_EQ(design.room.size(), 1u);
  EXPECT_EQ(design.room[0].floor_z_m, 3.0);
  EXPECT_THAT(design.room[0].outline_m, ElementsAre(glm::dvec2(3, 8), glm::dvec2(3, 12),
                                                    glm::dvec2(-3, 12), glm::dvec2(-3, 8)));
}

TEST(IfcDesign, PlacesInACircleAreRefused) {
  std::string data = kRoom;
  data.replace(data.find("IFCLOCALPLACEMENT($,"), 20, "IFCLOCALPLACEMENT(#800,");
  EXPECT_THAT(notes(read(data), "or refers to itself"), ElementsAre("left out: 1 x IFCSPACE"));
}

TEST(IfcDesign, FarOriginsAreTakenAway) {
  std::string data = kRoom;
  data.replace(data.find("(0.,0.,0.)"), 10, "(3500000250.,5600000500.,120000.)");
  const Design design = read(data);
  ASSERT_EQ(design.room.size(), 1u);
  EXPECT_EQ(design.origin_m, glm::dvec3(3499998, 5599997, 0));
  EXPECT_EQ(design.room[0].outline_m[0], glm::dvec2(0.25, 0.5));
  EXPECT_EQ(design.room[0].floor_z_m, 120.0);
  EXPECT_THAT(notes(design, "is subtracted"), ElementsAre("taken: 1 x origin"));
}

TEST(IfcDesign, RoomsThatAreNoneAreLeftOut) {
  const auto with = [](std::string from, const std::string& to) {
    std::string data = kRoom;
    data.replace(data.find(from), from.size(), to);
    return read(data);
  };
  EXPECT_THAT(notes(with(".ELEMENT.,.SPACE.", ".COMPLEX.,.SPACE."), "group"),
              ElementsAre("left out: 1 x IFCSPACE"));
  EXPECT_THAT(notes(with(".ELEMENT.,.SPACE.", ".ELEMENT.,.GFA."), "gross area"),
              ElementsAre("left out: 1 x IFCSPACE"));
  EXPECT_THAT(notes(with("#800,#2,", "#800,$,"), "it has no shape"),
              ElementsAre("left out: 1 x IFCSPACE"));
  EXPECT_THAT(notes(with("4000.,6000.", "4.,6."), "check the unit, mm"),
              ElementsAre("doubt: 1 x IFCSPACE"));
}

TEST(IfcDesign, GlobalIdsThatAreTwiceBecomeTwoKeys) {
  const Design design = read(kRoom +
                             "#5=IFCSPACE('room-a',$,'102',$,$,#800,#2,$,.ELEMENT.,.SPACE.,$);"
                             "#6=IFCSPACE($,$,'103',$,$,#800,#2,$,.ELEMENT.,.SPACE.,$);");
  ASSERT_EQ(design.room.size(), 3u);
  EXPECT_EQ(design.room[0].source.key, "room-a");
  EXPECT_EQ(design.room[1].source.key, "room-a#5");
  EXPECT_EQ(design.room[2].source.key, "#6");
  EXPECT_EQ(notes(design, "GlobalId").size(), 2u);
}

TEST(IfcDesign, LightFixturesOfIfc4) {
  const Design design =
      read(ifc_places() + place(4, "1000.,2000.,2800.", "#802,#45") +
           "#45=IFCDIRECTION((0.,-1.,0.));"
           "#1=IFCLIGHTFIXTURE('l1',$,'L1',$,$,#40,$,'17',.POINTSOURCE.);"
           "#2=IFCLIGHTFIXTURETYPE('t',$,'Panel 600',$,$,(#6),$,'T',$,.NOTDEFINED.);"
           "#3=IFCRELDEFINESBYTYPE('r',$,$,$,(#1),#2);"
           "#5=IFCPROPERTYSET('s',$,'Makers',$,(#7,#8));#6=IFCPROPERTYSET('s2',$,'Makers',$,(#9));"
           "#7=IFCPROPERTYSINGLEVALUE('Article',$,IFCLABEL('X-1'),$);"
           "#8=IFCPROPERTYSINGLEVALUE('Emergency',$,IFCBOOLEAN(.F.),$);"
           "#9=IFCPROPERTYSINGLEVALUE('Power',$,IFCPOWERMEASURE(36.5),$);"
           "#20=IFCRELDEFINESBYPROPERTIES('r2',$,$,$,(#1),#5);"
           "#21=IFCBUILDINGSTOREY('s',$,'Level 2',$,$,$,$,$,.ELEMENT.,3.);"
           "#22=IFCRELCONTAINEDINSPATIALSTRUCTURE('c',$,$,$,(#1),#21);");
  ASSERT_EQ(design.luminaire.size(), 1u);
  const cli::DesignLuminaire& one = design.luminaire[0];
  EXPECT_EQ(one.source.key, "l1");
  EXPECT_EQ(one.type, "Panel 600");
  EXPECT_EQ(one.storey, "Level 2");
  EXPECT_EQ(one.position_m, glm::dvec3(1.0, 2.0, 2.8));
  EXPECT_TRUE(one.has_height);
  EXPECT_EQ(one.rotation_deg, 270.0);
  EXPECT_FALSE(one.is_mirrored);
  EXPECT_THAT(one.attribute,
              ElementsAre(Pair("Tag", "17"), Pair("PredefinedType", "POINTSOURCE"),
                          Pair("Makers.Article", "X-1"), Pair("Makers.Emergency", "false"),
                          Pair("Makers.Power", "36.5")));
}

TEST(IfcDesign, FlowTerminalsOfIfc2x3AreLuminairesByTheirType) {
  const Design design =
      read(ifc_places() + place(4, "0.,0.,2800.") +
               "#1=IFCFLOWTERMINAL('l1',$,'A',$,$,#40,$,'1');"
               "#2=IFCFLOWTERMINAL('l2',$,'Wall Switch',$,$,#40,$,'2');"
               "#3=IFCFLOWTERMINAL('l3',$,'B',$,$,#40,$,'3');#4=IFCFLOWTERMINAL('l4',$,'C',$,$,#40,"
               "$,'4');"
               "#5=IFCLIGHTFIXTURETYPE('t1',$,'Panel',$,$,$,$,'T',$,.NOTDEFINED.);"
               "#6=IFCOUTLETTYPE('t2',$,'Outlet',$,$,$,$,'T',$,.NOTDEFINED.);"
               "#7=IFCRELDEFINESBYTYPE('r',$,$,$,(#1,#2),#5);"
               "#8=IFCRELDEFINESBYTYPE('r',$,$,$,(#3),#6);",
           "IFC2X3");
  ASSERT_EQ(design.luminaire.size(), 2u);
  EXPECT_EQ(design.luminaire[0].type, "Panel");
  EXPECT_THAT(notes(design, "IFCOUTLETTYPE"), ElementsAre("not asked: 1 x IFCFLOWTERMINAL"));
  EXPECT_THAT(notes(design, "it has no type: it is not known whether it gives light"),
              ElementsAre("left out: 1 x IFCFLOWTERMINAL"));
  EXPECT_THAT(notes(design, "says 'switch'"), ElementsAre("doubt: 1 x IFCFLOWTERMINAL"));
}

TEST(IfcDesign, TypesOfOneNameAreToldApart) {
  const Design design =
      read(ifc_places() + place(4, "0.,0.,2800.") +
           "#1=IFCLIGHTFIXTURE('l1',$,'A',$,$,#40,$,'1',$);#2=IFCLIGHTFIXTURE('l2',$,'B',$,$,#40,$,"
           "'2',$);"
           "#5=IFCLIGHTFIXTURETYPE('t1',$,'36 W',$,$,$,$,'T1',$,.NOTDEFINED.);"
           "#6=IFCLIGHTFIXTURETYPE('t2',$,'36 W',$,$,$,$,'T2',$,.NOTDEFINED.);"
           "#7=IFCRELDEFINESBYTYPE('r',$,$,$,(#1),#5);#8=IFCRELDEFINESBYTYPE('r',$,$,$,(#2),#6);");
  ASSERT_EQ(design.luminaire.size(), 2u);
  EXPECT_EQ(design.luminaire[0].type, "36 W (T1)");
  EXPECT_EQ(design.luminaire[1].type, "36 W (T2)");
  EXPECT_EQ(notes(design, "several types").size(), 1u);
}

TEST(IfcDesign, LuminairesThatHangOtherwiseAreDoubts) {
  const Design design =
      read(ifc_places() + place(4, "0.,0.,2800.", "#5,$") + place(6, "0.,0.,2800.", "#7,$") +
           "#5=IFCDIRECTION((0.,0.,-1.));#7=IFCDIRECTION((1.,0.,0.));"
           "#1=IFCLIGHTFIXTURE('l1',$,'A',$,$,#40,$,'1',$);#2=IFCLIGHTFIXTURE('l2',$,'B',$,$,#60,$,"
           "'2',$);");
  ASSERT_EQ(design.luminaire.size(), 2u);
  EXPECT_TRUE(design.luminaire[0].is_mirrored);
  EXPECT_EQ(notes(design, "it is upside down").size(), 1u);
  EXPECT_EQ(notes(design, "tilted").size(), 1u);
}

// A table of 1.6 x 0.8 x 0.75 m, whose corner is its origin, as a type that is mapped.
TEST(IfcDesign, FurnitureIsTheBoxAroundItsType) {
  const Design design = read(
      ifc_places() + place(4, "5000.,1000.,0.", "#802,#45") +
      "#45=IFCDIRECTION((0.,1.,0.));"
      "#1=IFCFURNITURE('f1',$,'Desk',$,$,#40,#2,$,$);#2=IFCPRODUCTDEFINITIONSHAPE($,$,(#3));"
      "#3=IFCSHAPEREPRESENTATION($,'Body','MappedRepresentation',(#5));#5=IFCMAPPEDITEM(#6,#7);"
      "#6=IFCREPRESENTATIONMAP(#801,#8);#7=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#803,1.,$);"
      "#8=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#9));"
      "#9=IFCEXTRUDEDAREASOLID(#11,$,#802,750.);"
      "#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,#12,1600.,800.);#12=IFCAXIS2PLACEMENT2D(#13,$);"
      "#13=IFCCARTESIANPOINT((800.,400.));"
      "#14=IFCFURNITURE('f2',$,'Odd',$,$,#40,#15,$,$);#15=IFCPRODUCTDEFINITIONSHAPE($,$,(#16));"
      "#16=IFCSHAPEREPRESENTATION($,'Body','AdvancedBrep',(#17));#17=IFCADVANCEDBREP($);");
  ASSERT_EQ(design.box.size(), 1u);
  const cli::DesignBox& box = design.box[0];
  EXPECT_EQ(box.source.key, "f1");
  EXPECT_EQ(box.name, "Desk");
  EXPECT_EQ(box.size_m, glm::dvec3(1.6, 0.8, 0.75));
  EXPECT_EQ(box.rotation_deg, 90.0);
  EXPECT_NEAR(box.centre_m.x, 4.6, 1e-12);
  EXPECT_NEAR(box.centre_m.y, 1.8, 1e-12);
  EXPECT_EQ(box.centre_m.z, 0.0);
  EXPECT_THAT(notes(design, "IFCADVANCEDBREP"), ElementsAre("left out: 1 x IFCFURNITURE"));
}

TEST(IfcDesign, WhatIsPassedOverIsCounted) {
  const Design design = read(kRoom + "#30=IFCWINDOW();#31=IFCWINDOW();#32=IFCWALL();");
  EXPECT_THAT(notes(design, "no daylight"), ElementsAre("not asked: 2 x IFCWINDOW"));
  EXPECT_THAT(notes(design, "other objects in it"), ElementsAre("not asked: 1 x IFCWALL"));
  EXPECT_THAT(notes(read(""), "no IFCSPACE"), ElementsAre("left out: 1 x rooms"));
}

TEST(IfcDesign, TheUserMaySayTheUnit) {
  StepProblem problem;
  const std::string metres =
      ifc_file(kRoom, "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)");  // it is not
  const auto design = cli::read_ifc(metres, "a.ifc", {0.001}, problem);
  ASSERT_TRUE(design) << problem.what;
  ASSERT_EQ(design->room.size(), 1u);
  EXPECT_EQ(design->room[0].height_m, 3.0);
  EXPECT_THAT(design->unit_reason, HasSubstr("the file says m"));
  EXPECT_THAT(notes(*cli::read_ifc(metres, "a.ifc", {}, problem), "check the unit, m"),
              ElementsAre("doubt: 1 x IFCSPACE"));
}

TEST(IfcDesign, OtherSchemasAreRefused) {
  StepProblem problem;
  EXPECT_FALSE(cli::read_ifc(ifc_file("", "AUTOMOTIVE_DESIGN"), "a.stp", {}, problem));
  EXPECT_THAT(problem.what, HasSubstr("'AUTOMOTIVE_DESIGN'; IFC2X3 and IFC4 are read"));
}

// Maps that use maps twice each would be a billion bodies.
TEST(IfcDesign, ABillionBodiesAreRefusedSoon) {
  std::string data = ifc_places() +
                     "#1=IFCSPACE('a',$,'1',$,$,#800,#2,$,.ELEMENT.,.SPACE.,$);"
                     "#2=IFCPRODUCTDEFINITIONSHAPE($,$,(#3));"
                     "#3=IFCSHAPEREPRESENTATION($,'Body','X',(#1000,#1000));"
                     "#7=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#803,1.,$);";
  for (int i = 0; i < 30; ++i) {
    const auto n = [&](int k) { return "#" + std::to_string(1000 + 10 * (i + k / 10) + k % 10); };
    data += n(0) + "=IFCMAPPEDITEM(" + n(1) + ",#7);" + n(1) + "=IFCREPRESENTATIONMAP(#801," +
            n(2) + ");" + n(2) + "=IFCSHAPEREPRESENTATION($,'Body','X',(" + n(10) + "," + n(10) +
            "));";
  }
  data += "#1300=IFCPOLYGONALFACESET(#1301,.T.,(),$);#1301=IFCCARTESIANPOINTLIST3D(());";
  EXPECT_THAT(notes(read(data), "its shape is too large"), ElementsAre("left out: 1 x IFCSPACE"));
}

}  // namespace
}  // namespace ifc_design_test
