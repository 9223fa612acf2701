// Sheets that lie in other surfaces: whose material is where.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <map>
#include <string>

namespace calc::tests::coincident_surfaces_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

double area_m2(const Body& body, const glm::uvec3& t) {
  return 0.5 * glm::length(glm::cross(body.vertex_m[t.y] - body.vertex_m[t.x],
                                      body.vertex_m[t.z] - body.vertex_m[t.x]));
}

// Area of a body by the id of its material.
std::map<std::string, double> areas_m2(const Project& project, const std::string& id) {
  std::map<std::string, double> areas;
  for (const Body& body : project.spaces.at(0).bodies) {
    if (body.id != id) continue;
    for (std::size_t i = 0; i < body.triangle.size(); ++i) {
      areas[project.materials.at(body.material_of.at(i)).id] += area_m2(body, body.triangle[i]);
    }
  }
  return areas;
}

Loaded loaded(const std::string& objects) {
  return load(
      in_project("<material id='glass' reflectance='0.1'/><material id='felt' reflectance='0.2'/>\n"
                 "<room id='r' size='6 4 3' ceiling='white' walls='white' floor='white'>\n" +
                 objects + "</room>"));
}

TEST(CoincidentSurfaces, AWindowInAWallTakesItsPlace) {
  // In the middle, over a corner of the wall, over both triangles' seam, larger than the wall.
  const std::map<std::string, double> windows{
      {"<quad id='w' origin='1 0 1' u='2 0 0' v='0 0 1' material='glass'/>", 2.0},
      {"<quad id='w' origin='-1 0 -1' u='2 0 0' v='0 0 2' material='glass'/>", 1.0},
      {"<quad id='w' origin='3 0 0.5' u='1 0 1' v='-1 0 1' material='glass'/>", 2.0},
      {"<quad id='w' origin='-1 0 -1' u='9 0 0' v='0 0 9' material='glass'/>", 18.0},
      {"<polygon id='w' points='1 0 1  3 0 1  3 0 2  2 0 2  2 0 2.5  1 0 2.5' material='glass'/>",
       2.5}};
  for (const auto& [window, glass_m2] : windows) {
    const Loaded read = loaded(window);
    ASSERT_TRUE(read.project) << read.messages;
    std::map<std::string, double> areas = areas_m2(*read.project, "r.wall1");
    EXPECT_NEAR(areas["glass"], glass_m2, 1e-9) << window;
    EXPECT_NEAR(areas["white"], 18.0 - glass_m2, 1e-9) << window;
    EXPECT_NEAR(areas_m2(*read.project, "r.wall2")["white"], 12.0, 1e-9);
    EXPECT_THAT(read.messages, Not(HasSubstr("surfaces-coincide")));
  }
}

TEST(CoincidentSurfaces, WhatIsNotInThePlaneOrNotASheetCoversNothing) {
  for (const char* object :
       {"<quad id='w' origin='1 0.001 1' u='2 0 0' v='0 0 1' material='glass'/>",
        "<quad id='w' origin='1 0 1' u='2 0 0' v='0 1 0' material='glass'/>",
        "<quad id='w' origin='6 0 3' u='2 0 0' v='0 0 1' material='glass'/>",
        "<box id='w' position='1 0 1' size='2 1 1' material='glass'/>"}) {
    const Loaded read = loaded(object);
    ASSERT_TRUE(read.project) << read.messages;
    EXPECT_EQ(areas_m2(*read.project, "r.wall1").size(), 1u) << object;
  }
}

TEST(CoincidentSurfaces, AMatOnATableAndARugOnTheFloor) {
  const Loaded read = loaded(
      "<box id='t' position='1 1 0' size='2 1 0.7' material='white'/>"
      "<quad id='mat' origin='1.2 1.2 0.7' u='1 0 0' v='0 0.5 0' material='felt'/>"
      "<quad id='rug' origin='3 1 0' u='2 0 0' v='0 2 0' material='felt'/>");
  ASSERT_TRUE(read.project) << read.messages;
  EXPECT_NEAR(areas_m2(*read.project, "t")["felt"], 0.5, 1e-9);
  EXPECT_NEAR(areas_m2(*read.project, "t")["white"], 2 * (2.0 + 1.4 + 0.7) - 0.5, 1e-9);
  EXPECT_NEAR(areas_m2(*read.project, "r.floor")["felt"], 4.0, 1e-9);
}

TEST(CoincidentSurfaces, OfTwoSheetsInOnePlaceNoneIsTheUpperOne) {
  const std::string lower = "<quad id='a' origin='1 1 1' u='2 0 0' v='0 2 0' material='glass'/>";
  const auto second = [&](const std::string& material, const std::string& origin) {
    return loaded(lower + "<quad id='b' origin='" + origin + "' u='1 0 0' v='0 1 0' material='" +
                  material + "'/>")
        .messages;
  };
  EXPECT_THAT(second("felt", "2 2 1"), HasSubstr("object 'b' lies exactly in 'a' of line"));
  EXPECT_THAT(second("glass", "2 2 1"), Not(HasSubstr("surfaces-coincide")));
  EXPECT_THAT(second("felt", "3 2 1"), Not(HasSubstr("surfaces-coincide"))) << "side by side";
  EXPECT_THAT(second("felt", "2 2 1.001"), Not(HasSubstr("surfaces-coincide")));
}

TEST(CoincidentSurfaces, FarFromTheOriginAndTurned) {
  const Loaded read = load(in_project(
      "<material id='glass' reflectance='0.1'/>\n"
      "<room id='r' origin='450000 5400000 80' footprint='0 0 8 6 5 10 -3 4' height='3' "
      "ceiling='white' walls='white' floor='white'>\n"
      "<quad id='w' origin='0.8 0.6 1' u='1.6 1.2 0' v='0 0 1' material='glass'/></room>"));
  ASSERT_TRUE(read.project) << read.messages;
  EXPECT_NEAR(areas_m2(*read.project, "r.wall1")["glass"], 2.0, 1e-6);
}

}  // namespace
}  // namespace calc::tests::coincident_surfaces_test
