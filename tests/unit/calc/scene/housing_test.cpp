#include "calc/scene/housing.h"

#include "calc/scene/prepared_scene.h"
#include "calc/scene/solids.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace calc::housing_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::load;

std::string ies(const std::string& sizes, const std::string& table = "0 90\n0\n100 0\n") {
  return "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 1000 1 2 1 1 2 " +
         sizes + "\n1 1 12\n" + table;
}

// flat: 1.2 m along C0 and 0.3 m along C90; panel, larger: EULUMDAT; disk: 0.6 m; box, ball, tube:
// bodies; up: flat, with light to both sides.
tests::Loaded room_with(const std::string& type, const std::string& objects) {
  MemoryFileReader files = tests::project_files(tests::in_project(
      type + "<room id=\"r\" size=\"4 3 2.5\" ceiling=\"white\" walls=\"white\" floor=\"white\">" +
      objects + "<plane id=\"task\" height=\"0.75\"/></room>"));
  files.add("dir/panel.ldt", test_support::ldt_text({}));
  test_support::LdtSample larger;
  larger.luminous_width_mm = "400";
  files.add("dir/larger.ldt", test_support::ldt_text(larger));
  files.add("dir/flat.ies", ies("0.3 1.2 0"));
  files.add("dir/disk.ies", ies("-0.6 -0.6 0"));
  files.add("dir/box.ies", ies("0.3 1.2 0.2"));
  files.add("dir/ball.ies", ies("-0.3 -0.3 -0.3"));
  files.add("dir/up.ies", ies("0.3 1.2 0", "0 180\n0\n100 100\n"));
  return load(files);
}

std::string type_of(const std::string& file, const std::string& housing) {
  return "<luminaire-type id=\"t\" photometry=\"" + file + "\"" +
         (housing.empty() ? "/>" : ">" + housing + "</luminaire-type>") + "\n";
}

const std::string kHanging = "<luminaire id=\"l\" type=\"t\" position=\"2 1.5 2\"/>";

std::vector<const Body*> housings(const tests::Loaded& loaded) {
  std::vector<const Body*> found;
  for (const Body& body : loaded.project->spaces[0].bodies) {
    if (!body.housing_of.empty()) found.push_back(&body);
  }
  return found;
}

double area_m2(const Body& body) {
  double sum = 0.0;
  for (const glm::uvec3& t : body.triangle) {
    sum += 0.5 * glm::length(glm::cross(body.vertex_m[t.y] - body.vertex_m[t.x],
                                        body.vertex_m[t.z] - body.vertex_m[t.x]));
  }
  return sum;
}

// > 0: all triangles face outwards as a whole.
double volume_m3(const Body& body) {
  double sum = 0.0;
  for (const glm::uvec3& t : body.triangle) {
    sum += glm::dot(body.vertex_m[t.x], glm::cross(body.vertex_m[t.y], body.vertex_m[t.z])) / 6.0;
  }
  return sum;
}

TEST(Housing, WithoutOneNothingIsInTheWay) {
  const tests::Loaded loaded = room_with(type_of("flat.ies", ""), kHanging);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_TRUE(housings(loaded).empty());
}

TEST(Housing, TheFaceOfAFlatOpeningLiesInIt) {
  const tests::Loaded loaded =
      room_with(type_of("flat.ies", "<housing material=\"white\"/>"), kHanging);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(housings(loaded).size(), 1u);
  const Body& face = *housings(loaded)[0];
  EXPECT_EQ(face.id, "l.face");
  EXPECT_EQ(face.housing_of, "l");
  EXPECT_FALSE(face.is_closed);
  EXPECT_NEAR(area_m2(face), 0.36, 1e-12);
  const BoundingBox box = bounding_box(face.vertex_m);
  EXPECT_NEAR(box.lower.x, 1.4, 1e-12);
  EXPECT_NEAR(box.upper.y, 1.65, 1e-12);
  EXPECT_EQ(box.lower.z, 2.0);
  EXPECT_EQ(box.upper.z, 2.0);
}

TEST(Housing, DepthGoesBackwards) {
  const tests::Loaded loaded =
      room_with(type_of("flat.ies", "<housing material=\"white\" depth=\"0.1\" size=\"1.3 0.4\"/>"),
                kHanging);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(housings(loaded).size(), 2u);
  const Body& solid = *housings(loaded)[1];
  EXPECT_EQ(solid.id, "l.housing");
  EXPECT_TRUE(solid.is_closed);
  EXPECT_TRUE(is_watertight(solid));
  EXPECT_NEAR(volume_m3(solid), 1.3 * 0.4 * 0.1, 1e-12);
  const BoundingBox box = bounding_box(solid.vertex_m);
  EXPECT_NEAR(box.lower.z, 2.0, 1e-12);
  EXPECT_NEAR(box.upper.z, 2.1, 1e-12);
  EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
}

TEST(Housing, ATurnedLuminaireTakesItAlong) {
  const tests::Loaded loaded = room_with(
      type_of("flat.ies", "<housing material=\"white\" depth=\"0.1\"/>"),
      "<luminaire id=\"l\" type=\"t\" position=\"2 1.5 1\" axis=\"0 0 1\" rotation=\"90\"/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const BoundingBox box = bounding_box(housings(loaded)[1]->vertex_m);
  EXPECT_NEAR(box.lower.z, 0.9, 1e-12);
  EXPECT_NEAR(box.upper.x - box.lower.x, 0.3, 1e-12);
}

TEST(Housing, RoundOnesHaveTheDisksArea) {
  const tests::Loaded loaded =
      room_with(type_of("disk.ies", "<housing material=\"white\" depth=\"0.1\"/>"), kHanging);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_NEAR(area_m2(*housings(loaded)[0]), kPi * 0.09, 1e-12);
  EXPECT_NEAR(volume_m3(*housings(loaded)[1]), kPi * 0.009, 1e-12);
  EXPECT_TRUE(is_watertight(*housings(loaded)[1]));
}

TEST(Housing, OfALuminousBodyLiesWithinIt) {
  for (const std::string file : {"box.ies", "ball.ies"}) {
    SCOPED_TRACE(file);
    const tests::Loaded loaded =
        room_with(type_of(file, "<housing material=\"white\"/>"), kHanging);
    ASSERT_TRUE(loaded.project) << loaded.messages;
    ASSERT_EQ(housings(loaded).size(), 1u);
    const Body& solid = *housings(loaded)[0];
    EXPECT_TRUE(is_watertight(solid));
    EXPECT_GT(volume_m3(solid), 0.0);
    const LuminaireType& used =
        loaded.project->luminaire_types[loaded.project->spaces[0].luminaires[0].type];
    const glm::dvec3 half_m = 0.5 * loaded.project->webs[used.web].opening().size_m();
    EXPECT_EQ(used.housing.value().depth_m, 2.0 * half_m.z);  // so that reports call it no face
    glm::dvec3 farthest_m(0.0);
    for (const glm::dvec3& p : solid.vertex_m) {
      farthest_m = glm::max(farthest_m, glm::abs(p - glm::dvec3(2, 1.5, 2)));
    }
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(farthest_m[i], half_m[i] - 1.0e-3, 1.0e-9);
    // Its own housing neither cuts the luminous body nor buries the luminaire.
    EXPECT_THAT(loaded.messages, Not(HasSubstr("luminous-body-cut")));
    EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
    const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
    EXPECT_TRUE(scene.luminaires[0].opening.is_body());
  }
}

// A cord into a luminous box makes its opening flat: a body about it would hide all its light.
TEST(Housing, OfALuminousBodyThatIsCutIsAFace) {
  const tests::Loaded loaded =
      room_with(type_of("box.ies", "<housing material=\"white\"/>"),
                kHanging +
                    "<luminaire id=\"far\" type=\"t\" position=\"1 1 1\"/>"
                    "<box id=\"cord\" size=\"0.01 0.01 0.4\" position=\"2 1.5 2.095\" "
                    "material=\"white\"/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(loaded.messages, HasSubstr("luminous-body-cut"));
  ASSERT_EQ(housings(loaded).size(), 2u);
  EXPECT_EQ(housings(loaded)[0]->id, "l.face");
  EXPECT_NEAR(area_m2(*housings(loaded)[0]), 0.36, 1e-12);
  EXPECT_EQ(housings(loaded)[1]->id, "far.housing");
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  EXPECT_FALSE(scene.luminaires[0].opening.is_body());
  EXPECT_TRUE(scene.luminaires[1].opening.is_body());
}

// Three in a row that reach into each other: none sends its light from within a housing.
TEST(Housing, OfBodiesThatOverlapAreFaces) {
  const tests::Loaded loaded =
      room_with(type_of("box.ies", "<housing material=\"white\"/>"),
                "<luminaire-line id=\"row\" type=\"t\" from=\"0.2 1.5 2\" to=\"3.77 1.5 2\" "
                "count=\"3\"/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  ASSERT_EQ(housings(loaded).size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(scene.luminaires[i].opening.is_body());
    EXPECT_FALSE(housings(loaded)[i]->is_closed);
  }
}

// A luminaire set into the ceiling is a piece of it with another reflectance.
TEST(Housing, AFaceInTheCeilingCoversIt) {
  const tests::Loaded loaded = room_with("<material id=\"grey\" reflectance=\"0.2\"/>" +
                                             type_of("flat.ies", "<housing material=\"grey\"/>"),
                                         "<luminaire id=\"l\" type=\"t\" position=\"2 1.5 2.5\"/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  double grey_m2 = 0.0;
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    if (scene.reflectance[t] != 0.2 || scene.body_id[scene.body[t]] != "r.ceiling") continue;
    const glm::uvec3& v = scene.triangle[t];
    grey_m2 += 0.5 * glm::length(glm::cross(glm::dvec3(scene.vertex_m[v.y] - scene.vertex_m[v.x]),
                                            glm::dvec3(scene.vertex_m[v.z] - scene.vertex_m[v.x])));
  }
  EXPECT_NEAR(grey_m2, 0.36, 1e-6);
}

TEST(Housing, CopiesOfAnAssemblyHaveTheirOwn) {
  const tests::Loaded loaded =
      room_with(type_of("flat.ies", "<housing material=\"white\"/>"),
                "<assembly id=\"a\" repeat=\"2 1 1\" step=\"1.5 0 0\" position=\"1 1 0\">"
                "<luminaire id=\"l\" type=\"t\" position=\"0 0 2\"/></assembly>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(housings(loaded).size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(housings(loaded)[i]->housing_of, loaded.project->spaces[0].luminaires[i].id);
  }
}

// A EULUMDAT file says how large the luminaire is: 1250 x 320 x 80 mm, its length along C90.
TEST(Housing, TakesTheSizeOfTheFile) {
  const tests::Loaded loaded = room_with(
      type_of("panel.ldt", "<housing material=\"white\" dimensions=\"file\"/>"), kHanging);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(housings(loaded).size(), 2u);
  const BoundingBox box = bounding_box(housings(loaded)[1]->vertex_m);
  EXPECT_NEAR(box.upper.x - box.lower.x, 0.32, 1e-12);
  EXPECT_NEAR(box.upper.y - box.lower.y, 1.25, 1e-12);
  EXPECT_NEAR(box.upper.z - box.lower.z, 0.08, 1e-12);
}

struct Refused {
  std::string file, housing, message;
};

TEST(Housing, WhatCannotBeIsRefusedAtItsPlace) {
  const std::vector<Refused> cases{
      {"spot.ies", "<housing material=\"white\"/>",
       "<housing> needs photometry with a luminous opening"},
      {"box.ies", "<housing material=\"white\" depth=\"0.1\"/>",
       "attribute 'depth' of <housing>: 0.1 is not allowed; expected no value: the opening of this "
       "photometry is a body, 1.2 x 0.3 x 0.2 m"},
      {"flat.ies", "<housing material=\"white\" size=\"1.1 0.3\"/>",
       "expected at least the luminous opening, 1.2 x 0.3 m"},
      {"up.ies", "<housing material=\"white\" depth=\"0.1\"/>",
       "expected no value: 50 % of the light goes backwards"},
      {"flat.ies", "<housing material=\"white\" dimensions=\"file\"/>",
       "<housing> needs 'size' and 'depth': this photometry does not state how large the luminaire "
       "is"},
      {"panel.ldt", "<housing material=\"white\" dimensions=\"file\" depth=\"0.1\"/>",
       "has both 'dimensions' and 'depth'"},
      {"larger.ldt", "<housing material=\"white\" dimensions=\"file\"/>",
       "file (0.32 x 1.25 m, 0.08 m deep) is not allowed; expected at least the luminous opening, "
       "0.4 x 1.2 m"},
      {"flat.ies", "<housing/>", "<housing> needs the attribute 'material'"},
      {"flat.ies", "<housing material=\"white\"/><housing material=\"white\"/>",
       "<luminaire-type> needs at most one <housing>"},
      {"flat.ies", "<housing material=\"white\" depth=\"0\"/>", "attribute 'depth' of <housing>"},
      {"flat.ies", "<housing material=\"none\"/>", "there is no material 'none'"},
      {"flat.ies", "<house material=\"white\"/>",
       "unknown element <house> in <luminaire-type>; allowed: housing"},
  };
  for (const Refused& one : cases) {
    SCOPED_TRACE(one.message);
    const tests::Loaded loaded = room_with(type_of(one.file, one.housing), kHanging);
    EXPECT_FALSE(loaded.project);
    EXPECT_THAT(loaded.messages, HasSubstr(one.message));
  }
}

// Light to both sides passes its own face, which lies between.
TEST(Housing, AFaceWithLightToBothSidesIsAllowed) {
  const tests::Loaded loaded =
      room_with(type_of("up.ies", "<housing material=\"white\"/>"), kHanging);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(housings(loaded).size(), 1u);
}

}  // namespace
}  // namespace calc::housing_test
