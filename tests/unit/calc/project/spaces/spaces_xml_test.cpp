// Rooms and the open space.

#include "calc/project/project_xml.h"
#include "calc/scene/polygon.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>

namespace calc::tests::spaces_xml_test {
namespace {

const char* const kFinishes = " ceiling='white' walls='white' floor='white'";

Project project_with(const std::string& lines) {
  Loaded loaded = load(in_project(lines));
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project.value_or(Project{});
}

glm::dvec3 normal_of(const Body& body, std::size_t triangle) {
  const glm::uvec3 t = body.triangle.at(triangle);
  return glm::normalize(
      glm::cross(body.vertex_m[t.y] - body.vertex_m[t.x], body.vertex_m[t.z] - body.vertex_m[t.x]));
}

glm::dvec3 middle_of(const Body& body) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& vertex : body.vertex_m) sum += vertex;
  return sum / static_cast<double>(body.vertex_m.size());
}

double area_of(const Body& body) {
  double area = 0.0;
  for (const glm::uvec3& t : body.triangle) {
    area += 0.5 * glm::length(glm::cross(body.vertex_m[t.y] - body.vertex_m[t.x],
                                         body.vertex_m[t.z] - body.vertex_m[t.x]));
  }
  return area;
}

// Doubled corners and spikes are taken out and said; sides that cross are an error.
TEST(RoomXml, FootprintsAreMendedAndSaid) {
  const auto room = [](const std::string& corners, const std::string& more = "") {
    return load(in_project("<room id='r' footprint='" + corners + "' height='3' ceiling='white' " +
                           more + " walls='white' floor='white'/>"));
  };
  const Loaded mended = room("0 0  4 0  6 1  4 0  4 3  0 3  0 3");
  ASSERT_TRUE(mended.project) << mended.messages;
  ASSERT_TRUE(mended.project->spaces[0].shell);
  EXPECT_EQ(mended.project->spaces[0].bodies.size(), 6u);
  EXPECT_NE(
      mended.messages.find("warning[outline-mended]: attribute 'footprint' of <room> was mended "
                           "and keeps its area: 1 doubled corner, 1 spike; the longest part that "
                           "was removed is 2.24 m, at (6.000, 1.000, 0.000) m; "
                           "walls are numbered without these corners"),
      std::string::npos)
      << mended.messages;
  EXPECT_NE(room("0 0  4 3  4 0  0 3").messages.find("not-simple-polygon"), std::string::npos);
  // A hole: no prism.
  EXPECT_NE(room("0 0  1 1  1 2  2 2  1 1  0 0  4 0  4 3  0 3").messages.find("not-simple-polygon"),
            std::string::npos);
}

TEST(RoomXml, SizeGivesAShellWithWallsFromTheFirstSide) {
  const Project project = project_with("<room id='r' name='Room' origin='10 20 1' size='4 3 2.5'" +
                                       std::string(kFinishes) + "/>");
  ASSERT_EQ(project.spaces.size(), 1u);
  const Space& room = project.spaces[0];
  EXPECT_EQ(room.name, "Room");
  ASSERT_TRUE(room.shell);
  EXPECT_DOUBLE_EQ(room.shell->floor_z_m, 1.0);
  EXPECT_DOUBLE_EQ(room.shell->height_m, 2.5);
  EXPECT_DOUBLE_EQ(signed_area(room.shell->footprint_m), 12.0);
  EXPECT_EQ(room.shell->footprint_m[2], glm::dvec2(14, 23));
  ASSERT_EQ(room.bodies.size(), 6u);
  EXPECT_EQ(room.bodies[0].id, "r.floor");
  EXPECT_EQ(room.bodies[1].id, "r.ceiling");
  EXPECT_EQ(room.bodies[5].id, "r.wall4");
  EXPECT_EQ(middle_of(room.bodies[2]), glm::dvec3(12, 20, 2.25));    // wall1: y = 0
  EXPECT_EQ(middle_of(room.bodies[3]), glm::dvec3(14, 21.5, 2.25));  // wall2: x = max
  EXPECT_EQ(middle_of(room.bodies[4]), glm::dvec3(12, 23, 2.25));    // wall3: y = max
  EXPECT_EQ(middle_of(room.bodies[5]), glm::dvec3(10, 21.5, 2.25));  // wall4: x = 0
}

TEST(RoomXml, SurfacesFaceIntoTheRoomAndCoverIt) {
  // An L, once in each direction.
  for (const char* footprint : {"0 0  4 0  4 1  1 1  1 3  0 3", "0 0  0 3  1 3  1 1  4 1  4 0"}) {
    const Project project = project_with("<room id='r' footprint='" + std::string(footprint) +
                                         "' height='2'" + kFinishes + "/>");
    const Space& room = project.spaces.at(0);
    EXPECT_DOUBLE_EQ(signed_area(room.shell->footprint_m), 6.0);
    ASSERT_EQ(room.bodies.size(), 8u);
    for (const Body& body : room.bodies) {
      EXPECT_FALSE(body.is_closed);
      EXPECT_EQ(body.material_of.size(), body.triangle.size());
    }
    EXPECT_NEAR(area_of(room.bodies[0]), 6.0, 1.0e-12);
    EXPECT_NEAR(area_of(room.bodies[1]), 6.0, 1.0e-12);
    for (std::size_t i = 0; i < room.bodies[0].triangle.size(); ++i) {
      EXPECT_NEAR(normal_of(room.bodies[0], i).z, 1.0, 1.0e-12);
      EXPECT_NEAR(normal_of(room.bodies[1], i).z, -1.0, 1.0e-12);
    }
    for (std::size_t wall = 2; wall < 8; ++wall) {
      const glm::dvec3 inwards =
          middle_of(room.bodies[wall]) + 0.01 * normal_of(room.bodies[wall], 0);
      EXPECT_TRUE(contains_point(room.shell->footprint_m, glm::dvec2(inwards))) << wall;
      EXPECT_NEAR(normal_of(room.bodies[wall], 1).z, 0.0, 1.0e-12);
    }
  }
}

TEST(RoomXml, WallsKeepTheirNumbersInAClockwiseFootprint) {
  const Project project = project_with("<room id='r' footprint='0 0  0 3  4 3  4 0' height='2'" +
                                       std::string(kFinishes) + "/>");
  EXPECT_EQ(middle_of(project.spaces.at(0).bodies.at(2)), glm::dvec3(0, 1.5, 1));
  EXPECT_EQ(middle_of(project.spaces.at(0).bodies.at(3)), glm::dvec3(2, 3, 1));
}

TEST(RoomXml, WallMaterialsReplaceTheCommonOne) {
  const Project project = project_with(
      "<material id='a' reflectance='0.1'/><material id='b' reflectance='0.2'/>"
      "<room id='r' size='1 1 1' ceiling='white' floor='a' walls='white' "
      "wall-materials='white b white a'/>");
  const std::vector<Body>& bodies = project.spaces.at(0).bodies;
  const std::vector<std::uint32_t> expected{1, 0, 0, 2, 0, 1};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(bodies.at(i).material_of.at(0), expected[i]) << bodies[i].id;
  }
}

TEST(RoomXml, ContentsAreInRoomCoordinates) {
  const Project project =
      project_with("<room id='r' origin='10 20 1' size='4 3 2.5'" + std::string(kFinishes) +
                   "><box id='b' size='1 1 1' position='0 1 0' material='white'/>"
                   "<luminaire id='l' type='spot' position='2 1 2.5'/></room>");
  const Space& room = project.spaces.at(0);
  EXPECT_EQ(room.bodies.at(6).id, "b");
  EXPECT_EQ(room.bodies.at(6).vertex_m.at(0), glm::dvec3(10, 21, 1));
  EXPECT_EQ(room.luminaires.at(0).position_m, glm::dvec3(12, 21, 3.5));
}

TEST(OpenSpaceXml, ComesLastAndOnlyIfThereIsSomethingInIt) {
  const std::string room = "<room id='r' size='1 1 1'" + std::string(kFinishes) + "/>";
  EXPECT_EQ(project_with(room).spaces.size(), 1u);
  const Project project =
      project_with("<box id='b' size='1 1 1' position='9 9 9' material='white'/>" + room);
  ASSERT_EQ(project.spaces.size(), 2u);
  EXPECT_EQ(project.spaces[1].id, "site");
  EXPECT_FALSE(project.spaces[1].shell);
  EXPECT_EQ(project.spaces[1].bodies.size(), 1u);
}

TEST(RoomXml, LuminairesOnTheBoundaryAreNoWarning) {
  const Loaded loaded = load(in_room("<luminaire id='k' type='spot' position='0 3 2.5'/>"));
  EXPECT_EQ(loaded.messages, "");
}

TEST(RoomXml, PlanesBesideASurfaceOfTheSameHeightAreNoWarning) {
  const Loaded loaded =
      load(in_room("<box id='b' size='1 1 0.8' material='white'/>"
                   "<plane id='p' origin='1 0 0.8' u='1 0 0' v='0 1 0'/>"
                   "<plane id='f' on='floor'/><plane id='t' on-top-of='b'/>"));
  EXPECT_EQ(loaded.messages, "");
}

}  // namespace
}  // namespace calc::tests::spaces_xml_test
