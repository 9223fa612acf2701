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
  EXPECT_THAT(second("felt", "2 2 1"), HasSubstr("object 'b' is exactly in 'a' of line"));
  EXPECT_THAT(second("glass", "2 2 1"), Not(HasSubstr("surfaces-coincide")));
  EXPECT_THAT(second("felt", "3 2 1"), Not(HasSubstr("surfaces-coincide"))) << "side by side";
  EXPECT_THAT(second("felt", "2 2 1.001"), Not(HasSubstr("surfaces-coincide")));
}

// Which of two one meets must not go by the file: the darker one, whoever is first.
TEST(CoincidentSurfaces, OfTwoSheetsTheDarkerOneCounts) {
  const std::string lower = "<quad id='a' origin='1 1 1' u='2 0 0' v='0 2 0' material='felt'/>";
  const std::string upper = "<quad id='b' origin='2 2 1' u='2 0 0' v='0 1 0' material='glass'/>";
  for (const std::string& objects : {lower + upper, upper + lower}) {
    const Loaded read = loaded(objects);
    ASSERT_TRUE(read.project) << read.messages;
    EXPECT_NEAR(areas_m2(*read.project, "a")["glass"], 1.0, 1e-9);
    EXPECT_NEAR(areas_m2(*read.project, "a")["felt"], 3.0, 1e-9);
    EXPECT_NEAR(areas_m2(*read.project, "b")["glass"], 2.0, 1e-9);
  }
}

// Its faces are of the project's materials of the same names.
Loaded with_mesh(const std::string& obj, const std::string& attributes = "") {
  std::string maps;
  for (const std::string name : {"glass", "felt", "white"}) {
    if (obj.find("usemtl " + name) == std::string::npos) continue;
    maps += "<map name='" + name + "' material='" + name + "'/>";
  }
  MemoryFileReader files = project_files(
      in_project("<material id='glass' reflectance='0.1'/><material id='felt' reflectance='0.2'/>\n"
                 "<room id='r' size='6 4 3' ceiling='white' walls='white' floor='white'>\n"
                 "<mesh id='m' file='m.obj' units='m' up='z' position='1 1 1'" +
                 attributes + ">" + maps + "</mesh></room>"));
  files.add("dir/m.obj", obj);
  return load(files);
}

const std::string kSquare = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

// As one square with a front and a back, as triangles of other diagonals, and in part.
TEST(DoubledFaces, InOneMeshTheDarkerOneCounts) {
  const std::map<std::string, double> second_faces{
      {"f 1 4 3 2\n", 4.0},
      {"f 2 3 4\nf 2 4 1\n", 4.0},
      {"v 1 0.5 0\nv 3 0.5 0\nv 3 1.5 0\nv 1 1.5 0\nf 5 6 7 8\n", 1.0}};
  for (const auto& [second, shared_m2] : second_faces) {
    for (const bool is_glass_first : {true, false}) {
      const std::string first = "usemtl " + std::string(is_glass_first ? "glass" : "white");
      const std::string then = "usemtl " + std::string(is_glass_first ? "white" : "glass");
      const Loaded read = with_mesh(kSquare + first + "\nf 1 2 3 4\n" + then + "\n" + second);
      ASSERT_TRUE(read.project) << read.messages;
      std::map<std::string, double> areas = areas_m2(*read.project, "m");
      const double all_m2 = shared_m2 == 4.0 ? 8.0 : 6.0;
      const double glass_m2 = (is_glass_first ? 4.0 : all_m2 - 4.0) + shared_m2;
      EXPECT_NEAR(areas["glass"], glass_m2, 1e-9) << second << is_glass_first;
      EXPECT_NEAR(areas["white"], all_m2 - glass_m2, 1e-9) << second << is_glass_first;
      EXPECT_THAT(read.messages,
                  HasSubstr("warning[faces-coincide]: object 'm': 2 of its triangles are exactly "
                            "in others of it, of another material, "))
          << second << is_glass_first;
    }
  }
}

TEST(DoubledFaces, OfThreeTheDarkest) {
  const Loaded read = with_mesh(kSquare +
                                "v 1 0 0\nv 1 2 0\nusemtl felt\nf 1 5 6 4\nusemtl white\n"
                                "f 1 2 3 4\nusemtl glass\nf 1 2 3\n");
  ASSERT_TRUE(read.project) << read.messages;
  std::map<std::string, double> areas = areas_m2(*read.project, "m");
  // Of the white square half is glass, and of the rest half a square metre is not under felt.
  EXPECT_NEAR(areas["white"], 0.5, 1e-9);
  EXPECT_NEAR(areas["felt"], 1.5 + 1.5, 1e-9);
  EXPECT_NEAR(areas["glass"], 2.0 + 2.0 + 0.5, 1e-9);
}

TEST(DoubledFaces, OthersAreNoMatter) {
  const std::string first = kSquare + "usemtl glass\nf 1 2 3 4\n";
  for (const std::string second :
       {"f 1 4 3 2\n", "usemtl felt\nv 2 0 0\nv 4 0 0\nv 4 2 0\nv 2 2 0\nf 5 6 7 8\n",
        "usemtl felt\nv 0 0 0.001\nv 2 0 0.001\nv 2 2 0.001\nf 5 6 7\n",
        "usemtl felt\nv 0 0 2\nv 0 2 2\nf 1 5 6 4\n"}) {
    const Loaded read = with_mesh(first + second);
    ASSERT_TRUE(read.project) << read.messages;
    EXPECT_THAT(read.messages, Not(HasSubstr("faces-coincide"))) << second;
  }
}

TEST(DoubledFaces, CopiesAreNamedOnce) {
  const std::string doubled = kSquare + "usemtl glass\nf 1 2 3 4\nusemtl white\nf 1 2 3 4\n";
  const Loaded read = with_mesh(doubled, " repeat='5 1 1' step='0.1 0 0.1'");
  EXPECT_THAT(read.messages, HasSubstr("(and 2 more objects of this space)"));
}

// A floor of many tiles over one of the other material: as many pairs as there are tiles.
TEST(DoubledFaces, AreFoundInManyTriangles) {
  constexpr int kSide = 100;
  std::string obj;
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) obj += fmt::format("v {} {} 0\n", 0.02 * x, 0.02 * y);
  }
  for (const std::string material : {"white", "glass"}) {
    obj += "usemtl " + material + "\n";
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const int v = y * (kSide + 1) + x + 1;
        obj += fmt::format("f {} {} {}\nf {} {} {}\n", v, v + 1, v + kSide + 2, v, v + kSide + 2,
                           v + kSide + 1);
      }
    }
  }
  const Loaded read = with_mesh(obj);
  ASSERT_TRUE(read.project) << read.messages;
  EXPECT_NEAR(areas_m2(*read.project, "m")["glass"], 8.0, 1e-6);
  EXPECT_THAT(read.messages, HasSubstr("20000 of its triangles"));
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
