// <housing file="...">: a housing that is a mesh.

#include "calc/scene/housing.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/solids.h"
#include "tests/support/mesh_rooms.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::housing_mesh_test {
namespace {

using test_support::ObjText;
using ::testing::HasSubstr;
using ::testing::Not;

std::string ies(const std::string& sizes, const std::string& table = "0 90\n0\n100 0\n") {
  return "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 1000 1 2 1 1 2 " +
         sizes + "\n1 1 12\n" + table;
}

std::string box_obj(const glm::dvec3& low, const glm::dvec3& high, int without = -1) {
  return ObjText().box("body", low, high, false, without).text();
}

const std::string kHanging = R"(<luminaire id="l" type="t" position="2 1.5 2"/>)";
const std::string kMesh = R"(material="grey" file="body.obj" units="m" up="z")";

// flat, up (with light to both sides): 1.2 m along C0 and 0.3 m along C90; body: that and 0.2 m
// high. "dir/body.obj" is `obj`.
Loaded room_with(const std::string& photometry, const std::string& housing, const std::string& obj,
                 const std::string& objects = kHanging) {
  MemoryFileReader files = project_files(in_project(
      R"(<material id="grey" reflectance="0.3"/><luminaire-type id="t" photometry=")" + photometry +
      "\"><housing " + housing +
      R"(/></luminaire-type><room id="r" size="4 3 2.5" ceiling="white" walls="white" floor="white">)" +
      objects + R"(<plane id="task" height="0.75"/></room>)"));
  files.add("dir/body.obj", obj);
  files.add("dir/flat.ies", ies("0.3 1.2 0"));
  files.add("dir/body.ies", ies("0.3 1.2 0.2"));
  files.add("dir/up.ies", ies("0.3 1.2 0", "0 180\n0\n100 100\n"));
  return load(files);
}

std::vector<const Body*> housings(const Loaded& loaded) {
  std::vector<const Body*> found;
  for (const Body& body : loaded.project->spaces[0].bodies) {
    if (!body.housing_of.empty()) found.push_back(&body);
  }
  return found;
}

void expect_box(const Body& one, const glm::dvec3& lower_m, const glm::dvec3& upper_m) {
  const BoundingBox box = bounding_box(one.vertex_m);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.lower[i], lower_m[i], 1e-12) << i;
    EXPECT_NEAR(box.upper[i], upper_m[i], 1e-12) << i;
  }
}

// Of the last luminaire type.
double depth_m(const Loaded& loaded) {
  return loaded.project->luminaire_types.back().housing.value().depth_m;
}

double area_m2(const Body& body) {
  double sum = 0.0;
  for (const glm::uvec3& t : body.triangle) {
    sum += 0.5 * glm::length(glm::cross(body.vertex_m[t.y] - body.vertex_m[t.x],
                                        body.vertex_m[t.z] - body.vertex_m[t.x]));
  }
  return sum;
}

TEST(HousingMesh, OfABoxItIsTheBox) {
  const Loaded mesh = room_with("flat.ies", kMesh, box_obj({-0.6, -0.15, 0}, {0.6, 0.15, 0.1}));
  const Loaded depth = room_with("flat.ies", R"(material="grey" depth="0.1")", "");
  ASSERT_TRUE(mesh.project) << mesh.messages;
  ASSERT_TRUE(depth.project) << depth.messages;
  EXPECT_EQ(mesh.messages, depth.messages);
  ASSERT_EQ(housings(mesh).size(), 2u);
  ASSERT_EQ(housings(depth).size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Body &one = *housings(mesh)[i], &other = *housings(depth)[i];
    EXPECT_EQ(one.id, other.id);
    EXPECT_EQ(one.housing_of, "l");
    EXPECT_EQ(one.is_closed, other.is_closed);
    EXPECT_EQ(one.material_of, other.material_of);
    EXPECT_NEAR(area_m2(one), area_m2(other), 1e-12);
    const BoundingBox box = bounding_box(other.vertex_m);
    expect_box(one, box.lower, box.upper);
  }
  EXPECT_NEAR(depth_m(mesh), 0.1, 1e-12);
  bool is_named = false;  // among what the result rests on
  for (const InputFile& file : mesh.project->inputs) {
    is_named = is_named || file.path.find("body.obj") != std::string::npos;
  }
  EXPECT_TRUE(is_named);
}

TEST(HousingMesh, UnitsAxesAndPlaceAreThoseOfMeshes) {
  // 600 mm along x, 100 along y, which is up in the file, 200 along -z.
  const Loaded loaded = room_with(
      "flat.ies",
      R"(material="grey" file="body.obj" units="mm" up="y" scale="2" rotation="90" position="0.1 0.2 0.05")",
      box_obj({0, 0, -100}, {300, 50, 0}));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  // x 0 to 0.6, y 0 to 0.2, z 0 to 0.1; turned x -0.2 to 0, y 0 to 0.6.
  expect_box(*housings(loaded)[1], {1.9, 1.7, 2.05}, {2.1, 2.3, 2.15});
  EXPECT_NEAR(depth_m(loaded), 0.15, 1e-12);
}

TEST(HousingMesh, ATurnedLuminaireTakesItAlong) {
  const Loaded loaded =
      room_with("flat.ies", kMesh, box_obj({0, 0, 0}, {0.5, 0.1, 0.2}),
                R"(<luminaire id="l" type="t" position="2 1.5 1" axis="0 1 0"/>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const BoundingBox box = bounding_box(housings(loaded)[1]->vertex_m);
  // Backwards is away from where it shines.
  EXPECT_NEAR(box.lower.y, 1.3, 1e-12);
  EXPECT_NEAR(box.upper.y, 1.5, 1e-12);
}

// An open one has no inside; the face is where the light leaves all the same.
TEST(HousingMesh, AnOpenOneIsASheet) {
  const Loaded loaded =
      room_with("flat.ies", kMesh, box_obj({-0.6, -0.15, 0}, {0.6, 0.15, 0.1}, 0));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(housings(loaded).size(), 2u);
  EXPECT_FALSE(housings(loaded)[1]->is_closed);
  EXPECT_EQ(housings(loaded)[1]->triangle.size(), 10u);
  EXPECT_EQ(housings(loaded)[0]->id, "l.face");
}

TEST(HousingMesh, LiesWithinALuminousBody) {
  const Loaded loaded =
      room_with("body.ies", kMesh, box_obj({-0.599, -0.149, -0.099}, {0.599, 0.149, 0.099}));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(housings(loaded).size(), 1u);
  EXPECT_EQ(housings(loaded)[0]->id, "l.housing");
  EXPECT_THAT(loaded.messages, Not(HasSubstr("luminous-body-cut")));
  EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  EXPECT_TRUE(scene.luminaires[0].opening.is_body());
}

// A mesh about the centre of an opening that counts as flat would hide its light, an open one, too.
TEST(HousingMesh, OfALuminousBodyThatIsCutIsAFace) {
  for (const int without : {-1, 0}) {
    SCOPED_TRACE(without);
    const Loaded loaded = room_with(
        "body.ies", kMesh, box_obj({-0.5, -0.1, -0.05}, {0.5, 0.1, 0.05}, without),
        kHanging +
            R"(<box id="cord" size="0.01 0.01 0.4" position="2 1.5 2.095" material="white"/>)");
    ASSERT_TRUE(loaded.project) << loaded.messages;
    EXPECT_THAT(loaded.messages, HasSubstr("luminous-body-cut"));
    ASSERT_EQ(housings(loaded).size(), 1u);
    EXPECT_EQ(housings(loaded)[0]->id, "l.face");
    EXPECT_NEAR(area_m2(*housings(loaded)[0]), 0.36, 1e-12);
  }
}

TEST(HousingMesh, WhatCannotBeIsRefused) {
  struct Refused {
    std::string photometry, housing, obj, message;
  };
  const std::string good = box_obj({-0.6, -0.15, 0}, {0.6, 0.15, 0.1});
  const std::vector<Refused> cases{
      {"flat.ies", kMesh, box_obj({-0.6, -0.15, -0.02}, {0.6, 0.15, 0.1}),
       "attribute 'file' of <housing>: body.obj is not allowed; expected surfaces behind the "
       "luminous opening; a corner is 0.02 m in front of it"},
      {"up.ies", kMesh, good,
       "attribute 'file' of <housing>: body.obj is not allowed; expected no value: 50 % of the "
       "light "
       "goes backwards"},
      {"spot.ies", kMesh, good, "<housing> needs photometry with a luminous opening"},
      {"body.ies", kMesh, box_obj({-0.5, -0.1, -0.05}, {0.5, 0.1, 0.0995}),
       "expected surfaces inside the luminous opening, which is a body of 1.2 x 0.3 x 0.2 m"},
      {"body.ies", kMesh, box_obj({-0.5, -0.1, -0.05}, {0.5, 0.1, 0.3}),
       "A corner is at (-0.5, -0.1, 0.3) m from its centre"},
      {"flat.ies", kMesh + R"( depth="0.1")", good, "has both 'file' and 'depth'"},
      {"flat.ies", kMesh + R"( size="1.3 0.4")", good, "has both 'file' and 'size'"},
      {"flat.ies", kMesh + R"( dimensions="file")", good, "has both 'file' and 'dimensions'"},
      {"flat.ies", R"(material="grey" depth="0.1" scale="2")", good,
       "<housing> needs 'file' beside 'scale', which describes a mesh file"},
      {"flat.ies", R"(material="grey" file="body.obj" up="z")", good,
       "<housing> needs the attribute 'units'"},
      {"flat.ies", R"(file="body.obj" units="m" up="z")", good,
       "<housing> needs the attribute 'material'"},
      {"flat.ies", R"(material="grey" file="none.obj" units="m" up="z")", good, "none.obj"},
      {"flat.ies", kMesh, "not a mesh", "body.obj"},
  };
  for (const Refused& one : cases) {
    SCOPED_TRACE(one.message);
    const Loaded loaded = room_with(one.photometry, one.housing, one.obj);
    EXPECT_FALSE(loaded.project);
    EXPECT_THAT(loaded.messages, HasSubstr(one.message));
  }
}

// Corners that no triangle has, as of another object of the file, hide nothing.
TEST(HousingMesh, UnusedCornersDoNotCount) {
  const Loaded loaded =
      room_with("flat.ies", kMesh, box_obj({-0.6, -0.15, 0}, {0.6, 0.15, 0.1}) + "v 0 0 -5\n");
  EXPECT_TRUE(loaded.project) << loaded.messages;
}

}  // namespace
}  // namespace calc::tests::housing_mesh_test
