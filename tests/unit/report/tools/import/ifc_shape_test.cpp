#include "report/tools/import/ifc_shape.h"

#include "calc/base/units.h"
#include "calc/scene/polygon.h"
#include "report/tools/import/ifc_placement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/report/tools/import/ifc_text.h"

namespace ifc_shape_test {
namespace {

using cli::IfcFile;
using cli::IfcLeftOut;
using cli::IfcRoomShape;
using cli::StepProblem;
using cli::StepText;
using test_support::ifc_extrusion;
using test_support::ifc_file;
using test_support::ifc_space;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Of the space #1, or why it is left out.
struct Read {
  std::optional<IfcRoomShape> shape;
  std::string why;
};

Read read(const std::string& body,
          const std::string& angle = "IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)") {
  const std::string bytes =
      ifc_file(ifc_space(body), "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)", angle);
  StepProblem problem;
  const auto text = StepText::open(bytes, problem);
  EXPECT_TRUE(text) << problem.what;
  if (!text) return {};
  IfcFile file(*text, cli::read_ifc_units(*text, problem).value());
  cli::IfcPlacements placements(file);
  try {
    const auto a = text->arguments(*text->find(1));
    return {cli::ifc_room_shape(file, a[6], placements.world_from(a[5])), ""};
  } catch (const IfcLeftOut& left_out) {
    return {std::nullopt, left_out.why};
  }
}

double area(const Read& room) {
  EXPECT_TRUE(room.shape) << room.why;
  if (!room.shape) return 0.0;
  double area = calc::signed_area(room.shape->outline);
  for (const auto& hole : room.shape->hole) area += calc::signed_area(hole);
  return area;
}

std::string points(int first, const std::string& list) {
  std::string text;
  std::size_t begin = 0;
  while (begin < list.size()) {
    const std::size_t end = std::min(list.find(';', begin), list.size());
    text += "#" + std::to_string(first++) + "=IFCCARTESIANPOINT((" +
            list.substr(begin, end - begin) + "));";
    begin = end + 1;
  }
  return text;
}

const std::string kRectangle = "#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4000.,6000.);";

TEST(IfcShape, ARectangleIsARoom) {
  const Read room = read(ifc_extrusion(kRectangle));
  ASSERT_TRUE(room.shape) << room.why;
  EXPECT_THAT(room.shape->outline, ElementsAre(glm::dvec2(-2, -3), glm::dvec2(2, -3),
                                               glm::dvec2(2, 3), glm::dvec2(-2, 3)));
  EXPECT_EQ(room.shape->floor_z_m, 0.0);
  EXPECT_EQ(room.shape->height_m, 3.0);
  EXPECT_TRUE(room.shape->doubt.empty());
}

TEST(IfcShape, AnExtrusionDownwardsEndsAtItsFloor) {
  const Read room = read(
      "#10=IFCEXTRUDEDAREASOLID(#11,$,#12,3000.);"
      "#12=IFCDIRECTION((0.,0.,-2.));" +
      kRectangle);
  ASSERT_TRUE(room.shape) << room.why;
  EXPECT_EQ(room.shape->floor_z_m, -3.0);
  EXPECT_EQ(room.shape->height_m, 3.0);
}

TEST(IfcShape, APolylineMayRunEitherWayAndHaveHoles) {
  const std::string corners = points(20, "0.,0.;0.,5000.;4000.,5000.;4000.,0.");
  const Read plain =
      read(ifc_extrusion("#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
                         "#12=IFCPOLYLINE((#20,#21,#22,#23,#20));" +
                         corners));
  EXPECT_DOUBLE_EQ(area(plain), 20.0);
  const Read holed =
      read(ifc_extrusion("#11=IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#12,(#13));"
                         "#12=IFCPOLYLINE((#20,#21,#22,#23,#20));"
                         "#13=IFCPOLYLINE((#30,#31,#32,#30));" +
                         corners + points(30, "1000.,1000.;2000.,1000.;2000.,2000.")));
  EXPECT_DOUBLE_EQ(area(holed), 19.5);
  const Read outside = read(
      ifc_extrusion("#11=IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#12,(#13));"
                    "#12=IFCPOLYLINE((#20,#21,#22,#23,#20));#13=IFCPOLYLINE((#30,#31,#32,#30));" +
                    corners + points(30, "9000.,1000.;9500.,1000.;9500.,2000.")));
  EXPECT_THAT(outside.why, HasSubstr("is outside"));
}

TEST(IfcShape, AnOpenOutlineIsClosedAndThatIsSaid) {
  const Read room =
      read(ifc_extrusion("#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
                         "#12=IFCPOLYLINE((#20,#21,#22));" +
                         points(20, "0.,0.;4000.,0.;4000.,4000.")));
  EXPECT_DOUBLE_EQ(area(room), 8.0);
  EXPECT_THAT(room.shape->doubt, ElementsAre(HasSubstr("is open in the file")));
}

TEST(IfcShape, AnOutlineThatCrossesItselfIsLeftOut) {
  const Read room =
      read(ifc_extrusion("#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
                         "#12=IFCPOLYLINE((#20,#21,#22,#23,#20));" +
                         points(20, "0.,0.;4000.,4000.;4000.,0.;0.,4000.")));
  EXPECT_THAT(room.why, HasSubstr("crosses"));
}

// A square of 4 m with a half circle of 4 m across on its right side: 16 + 2 pi.
std::string half_round(const std::string& trims, const std::string& sense,
                       const std::string& same = ".T.") {
  return ifc_extrusion(
      "#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
      "#12=IFCCOMPOSITECURVE((#13,#14),.F.);"
      "#13=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#15);"
      "#14=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.," +
      same +
      ",#16);"
      "#15=IFCPOLYLINE((#22,#23,#20,#21));"
      "#16=IFCTRIMMEDCURVE(#17," +
      trims + "," + sense +
      ",.PARAMETER.);"
      "#17=IFCCIRCLE(#18,2000.);#18=IFCAXIS2PLACEMENT2D(#24,$);" +
      points(20, "0.,0.;4000.,0.;4000.,4000.;0.,4000.;4000.,2000."));
}

TEST(IfcShape, ArcsAreChordsWithinAMillimetre) {
  const double exact = 16.0 + 2.0 * calc::kPi;
  const Read radians =
      read(half_round("(IFCPARAMETERVALUE(-1.5707963267948966)),"
                      "(IFCPARAMETERVALUE(1.5707963267948966))",
                      ".T."));
  EXPECT_LT(area(radians), exact);
  EXPECT_GT(area(radians), exact - 0.001 * 2.0 * calc::kPi);  // 1 mm along the arc
  const std::string degree =
      "IFCCONVERSIONBASEDUNIT($,.PLANEANGLEUNIT.,'DEGREE',#906);"
      "#906=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.017453292519943295),#907);"
      "#907=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)";
  const Read degrees =
      read(half_round("(IFCPARAMETERVALUE(270.)),(IFCPARAMETERVALUE(90.))", ".T."), degree);
  EXPECT_NEAR(area(degrees), area(radians), 1.0e-9);
  const Read back =
      read(half_round("(IFCPARAMETERVALUE(90.)),(IFCPARAMETERVALUE(-90.))", ".F.", ".F."), degree);
  EXPECT_NEAR(area(back), area(radians), 1.0e-9);
  const Read by_points = read(half_round("(#21),(#22)", ".T."));
  EXPECT_NEAR(area(by_points), area(radians), 1.0e-9);
}

TEST(IfcShape, AnArcInTheWrongUnitDoesNotMeetTheRest) {
  const Read room = read(half_round("(IFCPARAMETERVALUE(270.)),(IFCPARAMETERVALUE(90.))", ".T."));
  EXPECT_THAT(room.why, HasSubstr("do not meet"));
}

TEST(IfcShape, IndexedCurvesHaveArcsThroughThreePoints) {
  const Read room = read(ifc_extrusion(
      "#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
      "#12=IFCINDEXEDPOLYCURVE(#13,(IFCLINEINDEX((3,4,1,2)),IFCARCINDEX((2,5,3))),.F.);"
      "#13=IFCCARTESIANPOINTLIST2D(((0.,0.),(4000.,0.),(4000.,4000.),(0.,4000.),"
      "(6000.,2000.)));"));
  const double exact = 16.0 + 2.0 * calc::kPi;
  EXPECT_LT(area(room), exact);
  EXPECT_GT(area(room), exact - 0.001 * 2.0 * calc::kPi);
  const Read beyond =
      read(ifc_extrusion("#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
                         "#12=IFCINDEXEDPOLYCURVE(#13,(IFCLINEINDEX((1,2,7))),.F.);"
                         "#13=IFCCARTESIANPOINTLIST2D(((0.,0.),(4000.,0.),(4000.,4000.)));"));
  EXPECT_THAT(beyond.why, HasSubstr("beyond the list"));
}

// A box of 4 x 5 x 3 m as polygons; bottom: the faces at its foot.
std::string box(const std::string& bottom) {
  return "#10=IFCPOLYGONALFACESET(#11,.T.,(#12,#13,#14,#15,#16" +
         std::string(bottom.find("#18") != std::string::npos ? ",#17,#18" : ",#17") +
         "),$);#11=IFCCARTESIANPOINTLIST3D(((0.,0.,500.),(4000.,0.,500.),(4000.,5000.,500.),"
         "(0.,5000.,500.),(0.,0.,3500.),(4000.,0.,3500.),(4000.,5000.,3500.),(0.,5000.,3500.)));"
         "#12=IFCINDEXEDPOLYGONALFACE((5,6,7,8));#13=IFCINDEXEDPOLYGONALFACE((1,2,6,5));"
         "#14=IFCINDEXEDPOLYGONALFACE((2,3,7,6));#15=IFCINDEXEDPOLYGONALFACE((3,4,8,7));"
         "#16=IFCINDEXEDPOLYGONALFACE((4,1,5,8));" +
         bottom;
}

TEST(IfcShape, FacesStandOnTheirFloor) {
  const Read one = read(box("#17=IFCINDEXEDPOLYGONALFACE((4,3,2,1));"));
  EXPECT_DOUBLE_EQ(area(one), 20.0);
  EXPECT_EQ(one.shape->floor_z_m, 0.5);
  EXPECT_EQ(one.shape->height_m, 3.0);
  EXPECT_TRUE(one.shape->doubt.empty());
  const Read two =
      read(box("#17=IFCINDEXEDPOLYGONALFACE((3,2,1));"
               "#18=IFCINDEXEDPOLYGONALFACE((1,3,4));"));
  EXPECT_DOUBLE_EQ(area(two), 20.0);
  EXPECT_EQ(two.shape->outline.size(), 4u);
  const Read twice =
      read(box("#17=IFCINDEXEDPOLYGONALFACE((4,3,2,1));"
               "#18=IFCINDEXEDPOLYGONALFACE((4,3,2,1));"));
  EXPECT_THAT(twice.why, HasSubstr("overlap"));
}

// Four corners of a tent: its floor is level, its roof a ridge or a point.
std::string tent(const std::string& top) {
  return "#10=IFCFACETEDBREP(#11);#11=IFCCLOSEDSHELL((#12,#13,#14,#15,#16));" +
         points(20, "0.,0.,0.;4000.,0.,0.;4000.,4000.,0.;0.,4000.,0.;" + top) +
         "#12=IFCFACE((#32));#32=IFCFACEOUTERBOUND(#42,.T.);#42=IFCPOLYLOOP((#23,#22,#21,#20));"
         "#13=IFCFACE((#33));#33=IFCFACEOUTERBOUND(#43,.T.);#43=IFCPOLYLOOP((#20,#21,#24));"
         "#14=IFCFACE((#34));#34=IFCFACEOUTERBOUND(#44,.T.);#44=IFCPOLYLOOP((#21,#22,#24));"
         "#15=IFCFACE((#35));#35=IFCFACEOUTERBOUND(#45,.T.);#45=IFCPOLYLOOP((#22,#23,#24));"
         "#16=IFCFACE((#36));#36=IFCFACEOUTERBOUND(#46,.T.);#46=IFCPOLYLOOP((#23,#20,#24));";
}

TEST(IfcShape, ARoofThatIsNotLevelIsADoubtAndAnOverhangIsLeftOut) {
  const Read inside = read(tent("2000.,2000.,5000."));
  EXPECT_DOUBLE_EQ(area(inside), 16.0);
  EXPECT_EQ(inside.shape->height_m, 5.0);
  EXPECT_THAT(inside.shape->doubt, ElementsAre(HasSubstr("ceiling is not level")));
  EXPECT_THAT(read(tent("6000.,2000.,5000.")).why, HasSubstr("wider further up"));
  EXPECT_THAT(read(tent("2000.,2000.,-5000.")).why, HasSubstr("no level floor"));
}

TEST(IfcShape, WhatIsCutOffIsADoubt) {
  const std::string cut =
      "#10=IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#9,$);"
      "#9=IFCEXTRUDEDAREASOLID(#11,$,#802,3000.);";
  const Read room = read(cut + kRectangle);
  EXPECT_DOUBLE_EQ(area(room), 24.0);
  EXPECT_THAT(room.shape->doubt, ElementsAre(HasSubstr("cut off")));
  EXPECT_THAT(read("#10=IFCBOOLEANRESULT(.UNION.,#10,#10);").why, HasSubstr("UNION"));
  EXPECT_THAT(read("#10=IFCBOOLEANRESULT(.DIFFERENCE.,#10,$);").why, HasSubstr("too deep"));
}

TEST(IfcShape, OthersAreLeftOutByTheirNames) {
  EXPECT_EQ(read("#10=IFCSECTIONEDSOLIDHORIZONTAL($);").why,
            "a shape by IFCSECTIONEDSOLIDHORIZONTAL is not read");
  EXPECT_EQ(read(ifc_extrusion("#11=IFCISHAPEPROFILEDEF($);")).why,
            "a profile by IFCISHAPEPROFILEDEF is not read");
  EXPECT_EQ(read(ifc_extrusion("#11=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#12);"
                               "#12=IFCBSPLINECURVE();"))
                .why,
            "a curve by IFCBSPLINECURVE is not read");
  EXPECT_EQ(read("").why, "its shape is not in the file");
  EXPECT_THAT(read("#10=IFCEXTRUDEDAREASOLID(#11);").why, HasSubstr("has 1 arguments"));
  EXPECT_THAT(read(ifc_extrusion("#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,0.,6000.);")).why,
              HasSubstr("not > 0"));
  EXPECT_THAT(read(ifc_extrusion("#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1.E99,6000.);")).why,
              HasSubstr("beyond"));
}

TEST(IfcShape, AnExtrusionAlongTheGroundStandsOnOneOfItsSides) {
  // A front of 4 m x 3 m (x, z), drawn through 5 m of y.
  const Read room = read(
      "#10=IFCEXTRUDEDAREASOLID(#11,#12,#802,5000.);"
      "#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4000.,3000.);"
      "#12=IFCAXIS2PLACEMENT3D(#803,#13,#14);"
      "#13=IFCDIRECTION((0.,-1.,0.));#14=IFCDIRECTION((1.,0.,0.));");
  EXPECT_DOUBLE_EQ(area(room), 20.0);
  EXPECT_DOUBLE_EQ(room.shape->floor_z_m, -1.5);
  EXPECT_DOUBLE_EQ(room.shape->height_m, 3.0);
}

}  // namespace
}  // namespace ifc_shape_test
