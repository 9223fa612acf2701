#include "calc/scene/polygon.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

namespace calc::tests::planes_xml_test {
namespace {

// In a room of 4 x 3 x 2.5 m whose floor corner is at (10, 20, 1).
CalcPlane plane_in_room(const std::string& lines) {
  const Loaded loaded =
      load(in_project("<room id='r' origin='10 20 1' size='4 3 2.5' ceiling='white' walls='white' "
                      "floor='white'><luminaire id='l' type='spot' position='1 1 2'/>" +
                      lines + "</room>"));
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project ? loaded.project->spaces.at(0).planes.at(0) : CalcPlane{};
}

PlanarArea area_in_room(const std::string& lines) {
  return std::get<PlanarArea>(plane_in_room(lines).area);
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1.0e-12);
  EXPECT_NEAR(found.y, expected.y, 1.0e-12);
  EXPECT_NEAR(found.z, expected.z, 1.0e-12);
}

// World coordinates of the middle of the outline's corners.
glm::dvec3 middle_of(const PlanarArea& area) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec2& c : area.outline_m) sum += area.origin_m + c.x * area.u + c.y * area.v;
  return sum / static_cast<double>(area.outline_m.size());
}

TEST(PlanesXml, HeightCoversTheFootprintAndFacesUp) {
  const PlanarArea area = area_in_room("<plane id='p' height='0.75' margin='0.5'/>");
  expect_near(area.normal(), {0, 0, 1});
  expect_near(middle_of(area), {12, 21.5, 1.75});
  EXPECT_DOUBLE_EQ(signed_area(area.outline_m), 12.0);
  EXPECT_DOUBLE_EQ(area.margin_m, 0.5);
  EXPECT_TRUE(std::holds_alternative<GridByRule>(area.grid));
}

// Along x and y the grid of a slender room at an angle would keep a few points in its middle.
TEST(PlanesXml, HeightRunsAlongTheLongSideOfATurnedRoom) {
  const Loaded loaded = load(
      in_project("<room id='r' footprint='0 0  8 6  6.8 7.6  -1.2 1.6' height='3' ceiling='white' "
                 "walls='white' floor='white'><luminaire id='l' type='spot' position='3 3 2'/>"
                 "<plane id='up' height='0.75'/><plane id='down' on='ceiling'/></room>"));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  for (const CalcPlane& plane : loaded.project->spaces.at(0).planes) {
    const auto& area = std::get<PlanarArea>(plane.area);
    expect_near(area.u, {0.8, 0.6, 0});
    expect_near(area.normal(), {0, 0, plane.id == "up" ? 1.0 : -1.0});
    glm::dvec2 lower = area.outline_m[0], upper = lower;
    for (const glm::dvec2& corner : area.outline_m) {
      lower = glm::min(lower, corner);
      upper = glm::max(upper, corner);
    }
    EXPECT_NEAR(upper.x - lower.x, 10.0, 1.0e-12);
    EXPECT_NEAR(upper.y - lower.y, 2.0, 1.0e-12);
    EXPECT_NEAR(signed_area(area.outline_m), 20.0, 1.0e-12);
    expect_near(middle_of(area), {3.4, 3.8, plane.id == "up" ? 0.75 : 3.0});
  }
}

TEST(PlanesXml, TheRoundingOfTheRuleCanBeChosen) {
  const PlanarArea area = area_in_room("<plane id='p' height='0.75' rounding='up'/>");
  EXPECT_EQ(std::get<GridByRule>(area.grid).rounding, GridRounding::up);
  const Loaded loaded = load(in_room("<plane id='p' height='0.75' rounding='up' spacing='0.5'/>"));
  EXPECT_NE(loaded.messages.find("'rounding' has no meaning together with 'spacing'"),
            std::string::npos)
      << loaded.messages;
}

TEST(PlanesXml, RectangleHasFullSidesAndFacesUCrossV) {
  const PlanarArea area =
      area_in_room("<plane id='p' origin='1 1 1' u='0 2 0' v='0 0 1' count='4 2'/>");
  expect_near(area.origin_m, {11, 21, 2});
  expect_near(area.u, {0, 1, 0});
  expect_near(area.normal(), {1, 0, 0});
  EXPECT_EQ(area.outline_m.at(2), glm::dvec2(2, 1));
  EXPECT_EQ(std::get<GridByCount>(area.grid).columns, 4);
  EXPECT_EQ(std::get<GridByCount>(area.grid).rows, 2);
}

TEST(PlanesXml, AxesAreOrthonormalWithinTheToleranceOfTheFile) {
  const PlanarArea area =
      area_in_room("<plane id='p' origin='1 1 1' u='2 0 0' v='0.0000009 1 0'/>");
  EXPECT_NEAR(glm::dot(area.u, area.v), 0.0, 1.0e-15);
  EXPECT_NEAR(glm::length(area.v), 1.0, 1.0e-15);
}

TEST(PlanesXml, PolygonFacesTheSideFromWhichItRunsCounterClockwise) {
  const PlanarArea up =
      area_in_room("<plane id='p' points='1 1 1  3 1 1  3 2 1  1 2 1' spacing='0.5'/>");
  expect_near(up.normal(), {0, 0, 1});
  expect_near(up.u, {1, 0, 0});  // along the first side
  EXPECT_DOUBLE_EQ(std::get<GridBySpacing>(up.grid).along_v_m, 0.5);
  const PlanarArea down =
      area_in_room("<plane id='p' points='1 1 1  1 2 1  3 2 1  3 1 1' spacing='0.5 0.25'/>");
  expect_near(down.normal(), {0, 0, -1});
  expect_near(down.u, {0, 1, 0});
  EXPECT_NEAR(signed_area(down.outline_m), 2.0, 1.0e-12);
  expect_near(middle_of(down), {12, 21.5, 2});
  EXPECT_DOUBLE_EQ(std::get<GridBySpacing>(down.grid).along_u_m, 0.5);
  EXPECT_DOUBLE_EQ(std::get<GridBySpacing>(down.grid).along_v_m, 0.25);
}

// A corner that is cut off gives a grid no direction; a first side that is short, but straight,
// does.
TEST(PlanesXml, PolygonLiesAlongItsLongestSideWhereTheFirstIsSlanted) {
  const PlanarArea cut =
      area_in_room("<plane id='p' points='1.1 1 1  3 1 1  3 2 1  1 2 1  1 1.1 1'/>");
  expect_near(cut.u, {1, 0, 0});
  const PlanarArea slanted =
      area_in_room("<plane id='p' points='1 1.05 1  1.1 1 1  3 1 1  3 2 1  1 2 1'/>");
  expect_near(slanted.u, {1, 0, 0});
  expect_near(slanted.normal(), {0, 0, 1});
  EXPECT_NEAR(signed_area(slanted.outline_m), 2.0 - 0.0025, 1.0e-12);
  expect_near(area_in_room("<plane id='p' points='3 1 1  3 2 1  1 2 1  1 1 1'/>").u, {0, 1, 0});
}

TEST(PlanesXml, PolygonMayBeConcaveAtTheFirstCorner) {
  const PlanarArea area =
      area_in_room("<plane id='p' points='2 1.2 1  3 0.5 1  2 2.5 1  1 0.5 1'/>");
  expect_near(area.normal(), {0, 0, 1});
}

TEST(PlanesXml, HolesAreInThePlanesCoordinates) {
  const PlanarArea area = area_in_room(
      "<plane id='p' points='1 1 1  3 1 1  3 2 1  1 2 1'>"
      "<hole points='1.5 1.25 1  2 1.25 1  2 1.5 1'/></plane>");
  ASSERT_EQ(area.holes_m.size(), 1u);
  EXPECT_NEAR(area.holes_m[0].at(2).x, 1.0, 1.0e-12);
  EXPECT_NEAR(area.holes_m[0].at(2).y, 0.5, 1.0e-12);
}

TEST(PlanesXml, RoomSurfacesFaceIntoTheRoom) {
  const struct {
    const char* name;
    glm::dvec3 middle, normal;
    double area;
  } cases[] = {
      {"floor", {12, 21.5, 1}, {0, 0, 1}, 12.0},   {"ceiling", {12, 21.5, 3.5}, {0, 0, -1}, 12.0},
      {"wall1", {12, 20, 2.25}, {0, 1, 0}, 10.0},  {"wall2", {14, 21.5, 2.25}, {-1, 0, 0}, 7.5},
      {"wall3", {12, 23, 2.25}, {0, -1, 0}, 10.0}, {"wall4", {10, 21.5, 2.25}, {1, 0, 0}, 7.5}};
  for (const auto& expected : cases) {
    const PlanarArea area = area_in_room("<plane id='p' on='" + std::string(expected.name) + "'/>");
    expect_near(middle_of(area), expected.middle);
    expect_near(area.normal(), expected.normal);
    EXPECT_NEAR(signed_area(area.outline_m), expected.area, 1.0e-12) << expected.name;
  }
}

TEST(PlanesXml, BoxTopsFollowTheirBox) {
  const PlanarArea area = area_in_room(
      "<assembly id='a' position='1 1 0' rotation='90'>"
      "<box id='b' size='2 1 0.7' position='0 0 0.1' rotation='90' material='white' repeat='1 2 1' "
      "step='0 -1 0'/></assembly><plane id='p' on-top-of='a.b[0,1,0]'/>");
  expect_near(area.origin_m, {12, 21, 1.8});
  expect_near(area.u, {-1, 0, 0});
  expect_near(area.normal(), {0, 0, 1});
  EXPECT_NEAR(area.outline_m.at(2).x, 2.0, 1.0e-12);
  EXPECT_NEAR(area.outline_m.at(2).y, 1.0, 1.0e-12);
}

// The unit of a list is its own, as that of a list of luminaires: metres, or what its columns name.
TEST(PlanesXml, PointListsKeepTheirUnitAndAreMovedIntoTheRoom) {
  const auto load_list = [](const std::string& head, const std::string& units) {
    MemoryFileReader files = project_files(
        "<luxgate version='1' units='" + units +
        "'><material id='m' reflectance='0.5'/>"
        "<room id='r' origin='1000 0 0' size='400 300 250' ceiling='m' walls='m' floor='m'>"
        "<plane id='p' file='list.csv'/></room></luxgate>");
    files.add("dir/list.csv", head + ",nx,ny,nz\n1,2,0.8,0,0,2\n");
    return load(files);
  };
  const auto first_point = [](const Loaded& loaded) {
    return std::get<PointList>(loaded.project->spaces.at(0).planes.at(0).area).position_m.at(0);
  };
  const Loaded bare = load_list("x,y,z", "cm");
  ASSERT_TRUE(bare.project) << bare.messages;
  expect_near(first_point(bare), {11, 2, 0.8});
  EXPECT_THAT(bare.messages,
              testing::HasSubstr("warning[point-list-unit]: 'list.csv': its columns x, y and z "
                                 "have no unit and are read in metres, but the project is in cm"));
  for (const std::string head : {"x_m,y_m,z_m", "x_mm,y_mm,z_mm"}) {
    const Loaded named = load_list(head, "cm");
    ASSERT_TRUE(named.project) << named.messages;
    const double metres = head == "x_m,y_m,z_m" ? 1.0 : 0.001;
    expect_near(first_point(named), glm::dvec3(10, 0, 0) + metres * glm::dvec3(1, 2, 0.8));
    EXPECT_THAT(named.messages, testing::Not(testing::HasSubstr("point-list-unit"))) << head;
  }
  EXPECT_THAT(load_list("x,y,z", "m").messages,
              testing::Not(testing::HasSubstr("point-list-unit")));
}

TEST(PlanesXml, PointsMeasurePlanarIlluminanceUnlessAQuantityIsGiven) {
  EXPECT_EQ(plane_in_room("<plane id='p' height='1'/>").kernel, ReceiverKernel::planar);
  const struct {
    const char* name;
    ReceiverKernel kernel;
  } cases[] = {{"planar", ReceiverKernel::planar},
               {"cylindrical", ReceiverKernel::cylindrical},
               {"hemispherical", ReceiverKernel::hemispherical},
               {"scalar", ReceiverKernel::scalar}};
  for (const auto& expected : cases) {
    const CalcPlane plane =
        plane_in_room("<plane id='p' height='1' quantity='" + std::string(expected.name) + "'/>");
    EXPECT_EQ(plane.kernel, expected.kernel) << expected.name;
    EXPECT_EQ(plane.direction, glm::dvec3(0.0)) << expected.name;
  }
}

TEST(PlanesXml, QuantitiesOfSeveralIlluminancesHaveAKernelToStartFrom) {
  const CalcPlane eyes =
      plane_in_room("<plane id='p' height='1' quantity='ugr' direction='0 2 0'/>");
  EXPECT_EQ(eyes.kernel, ReceiverKernel::planar);
  EXPECT_EQ(eyes.derived, DerivedQuantity::ugr);
  EXPECT_EQ(eyes.direction, glm::dvec3(0, 1, 0));
  const CalcPlane modelling = plane_in_room("<plane id='p' height='1' quantity='modelling'/>");
  EXPECT_EQ(modelling.kernel, ReceiverKernel::cylindrical);
  EXPECT_EQ(modelling.derived, DerivedQuantity::modelling);
  const CalcPlane four = plane_in_room("<plane id='p' height='1' quantity='cylindrical-4'/>");
  EXPECT_EQ(four.kernel, ReceiverKernel::cylindrical);
  EXPECT_EQ(four.derived, DerivedQuantity::four_planes);
}

TEST(PlanesXml, SemicylindricalPointsLookInTheDirectionGiven) {
  const CalcPlane plane = plane_in_room(
      "<plane id='p' height='1' quantity='semicylindrical' direction='3 -4 0.000004'/>");
  EXPECT_EQ(plane.kernel, ReceiverKernel::semicylindrical);
  expect_near(plane.direction, {0.6, -0.8, 0});
  EXPECT_EQ(plane.direction.z, 0.0);
  expect_near(std::get<PlanarArea>(plane.area).normal(), {0, 0, 1});
}

TEST(PlanesXml, SemicylindricalPointsOfAListLookAlongTheirNormals) {
  MemoryFileReader files =
      project_files(in_room("<plane id='p' file='looks.csv' quantity='semicylindrical'/>"));
  files.add("dir/looks.csv", "x,y,z,nx,ny,nz\n1,1,1.5,0,-2,0.0000019\n");
  const Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const CalcPlane& plane = loaded.project->spaces.at(0).planes.at(0);
  EXPECT_EQ(plane.kernel, ReceiverKernel::semicylindrical);
  EXPECT_EQ(std::get<PointList>(plane.area).normal.at(0), glm::dvec3(0, -1, 0));
}

TEST(PlanesXml, RequirementsAreKeptAsWritten) {
  const CalcPlane plane = plane_in_room(
      "<plane id='p' name='Task' height='1'>\n"
      "<require quantity='average' at-least=' 500 '/><require pack='x' row='y'/></plane>");
  EXPECT_EQ(plane.name, "Task");
  ASSERT_EQ(plane.requirements.size(), 2u);
  EXPECT_EQ(plane.requirements[0].role, "");
  EXPECT_EQ(plane.requirements[0].element.name, "require");
  const auto& attributes = plane.requirements[0].element.attributes;
  ASSERT_EQ(attributes.size(), 2u);
  EXPECT_EQ(attributes[1].name, "at-least");
  EXPECT_EQ(attributes[1].value, " 500 ");
  EXPECT_EQ(attributes[1].where.line, 5);
  EXPECT_EQ(attributes[1].where.column, 29);
}

}  // namespace
}  // namespace calc::tests::planes_xml_test
