#include "calc/scene/solids.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace calc::tests::objects_xml_test {
namespace {

// Objects of the open space.
Space space_with(const std::string& lines) {
  const Loaded loaded = load(in_project(lines));
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project ? loaded.project->spaces.at(0) : Space{};
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1.0e-12);
  EXPECT_NEAR(found.y, expected.y, 1.0e-12);
  EXPECT_NEAR(found.z, expected.z, 1.0e-12);
}

void expect_box(const Body& body, const glm::dvec3& lower, const glm::dvec3& upper) {
  const BoundingBox box = bounding_box(body.vertex_m);
  expect_near(box.lower, lower);
  expect_near(box.upper, upper);
}

// Positive when the triangles wind counter-clockwise seen from outside.
double signed_volume(const Body& body) {
  double volume = 0.0;
  for (const glm::uvec3& t : body.triangle) {
    volume += glm::dot(body.vertex_m[t.x], glm::cross(body.vertex_m[t.y], body.vertex_m[t.z])) / 6;
  }
  return volume;
}

TEST(ObjectsXml, BoxIsAClosedBodyFacingOutwards) {
  const Body body =
      space_with("<box id='b' size='2 3 4' position='1 1 1' material='white'/>").bodies.at(0);
  expect_box(body, {1, 1, 1}, {3, 4, 5});
  EXPECT_EQ(body.triangle.size(), 12u);
  EXPECT_NEAR(signed_volume(body), 24.0, 1.0e-12);
  EXPECT_TRUE(body.is_closed);
  EXPECT_TRUE(is_watertight(body));
}

TEST(ObjectsXml, BoxTurnsAboutItsPosition) {
  const Body body =
      space_with("<box id='b' size='2 3 4' position='1 1 1' rotation='90' material='white'/>")
          .bodies.at(0);
  expect_box(body, {-2, 1, 1}, {1, 3, 5});
}

TEST(ObjectsXml, RepeatsNameTheirPlace) {
  const Space space =
      space_with("<box id='b' size='1 1 1' material='white' repeat='2 1 3' step='10 0 -20'/>");
  ASSERT_EQ(space.bodies.size(), 6u);
  EXPECT_EQ(space.bodies[0].id, "b[0,0,0]");
  EXPECT_EQ(space.bodies[5].id, "b[1,0,2]");
  expect_box(space.bodies[5], {10, 0, -40}, {11, 1, -39});
}

// A frame as one outline, with a spike: mended. 4 mm off the plane of 5 m: taken for flat. Both
// said.
TEST(ObjectsXml, PolygonsAreMendedAndSaid) {
  const auto loaded_with = [](const std::string& points) {
    return load(in_project("<polygon id='p' points='" + points + "' material='white'/>"));
  };
  const auto area = [](const Loaded& loaded) {
    double sum = 0.0;
    const Body& body = loaded.project->spaces.at(0).bodies.at(0);
    for (const glm::uvec3& t : body.triangle) {
      sum += 0.5 * glm::length(glm::cross(body.vertex_m[t.y] - body.vertex_m[t.x],
                                          body.vertex_m[t.z] - body.vertex_m[t.x]));
    }
    return sum;
  };
  const Loaded frame = loaded_with(
      "0 0 1  1 1 1  1 2 1  3 2 1  3 1 1  1 1 1  0 0 1  4 0 1  9 0 3  4 0 1  4 3 1  0 3 1");
  ASSERT_TRUE(frame.project) << frame.messages;
  EXPECT_NEAR(area(frame), 10.0, 1e-12);
  EXPECT_EQ(frame.project->spaces[0].bodies[0].vertex_m.size(), 8u);
  EXPECT_NE(frame.messages.find("attribute 'points' of <polygon> was mended and keeps its area: 1 "
                                "spike, 1 joined hole or part; the longest"),
            std::string::npos)
      << frame.messages;
  const Loaded bent = loaded_with("0 0 1  4 0 1  4 3 1.004  0 3 1");
  ASSERT_TRUE(bent.project) << bent.messages;
  EXPECT_NE(bent.messages.find("warning[outline-bent]"), std::string::npos) << bent.messages;
  EXPECT_NE(loaded_with("0 0 1  4 0 1  4 3 1.04  0 3 1").messages.find("not-simple-polygon"),
            std::string::npos);
}

TEST(ObjectsXml, QuadAndPolygonAreOpen) {
  const Space space = space_with(
      "<quad id='q' origin='1 0 0' u='0 2 0' v='0 0 3' material='white'/>"
      "<polygon id='p' points='0 0 1  4 0 1  4 4 1  2 1 1  0 4 1' material='white'/>");
  EXPECT_FALSE(space.bodies.at(0).is_closed);
  expect_box(space.bodies[0], {1, 0, 0}, {1, 2, 3});
  EXPECT_EQ(space.bodies.at(1).triangle.size(), 3u);  // concave, 5 corners
}

TEST(ObjectsXml, MeshIsScaledTurnedUprightAndPlaced) {
  // The table's corner (1, 1, 0) with y up becomes (1, 0, 1); times 2 ft; turned by 90 degrees to
  // y; shifted.
  const Space space = space_with(
      "<mesh id='m' file='table.obj' up='y' units='ft' scale='2' rotation='90' "
      "position='5 6 7' material='white'/>");
  expect_near(space.bodies.at(0).vertex_m.at(2), {5, 6 + 0.6096, 7 + 0.6096});
}

TEST(ObjectsXml, MeshHasItsOwnUnitInAnyProject) {
  const Loaded loaded = load(
      "<luxgate version='1' units='cm'><material id='w' reflectance='0.5'/>"
      "<mesh id='m' file='table.obj' units='m' up='z' material='w' position='100 0 0'/></luxgate>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  expect_near(loaded.project->spaces.at(0).bodies.at(0).vertex_m.at(1), {2, 0, 0});
}

TEST(ObjectsXml, GltfIsInMetresWithYUpAndRecordsItsBuffers) {
  MemoryFileReader files = project_files(
      in_project("<material id='g' reflectance='0.3'/>"
                 "<mesh id='m' file='sub/tile.gltf'><map name='grey' material='g'/></mesh>"));
  files.add("dir/sub/tile.gltf", kSquareGltf);
  files.add("dir/sub/tile.bin", square_bytes());
  const Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const Body& body = loaded.project->spaces.at(0).bodies.at(0);
  expect_near(body.vertex_m.at(2), {2, 0, 2});
  EXPECT_EQ(body.material_of, (std::vector<std::uint32_t>{1, 1}));
  EXPECT_EQ(loaded.project->inputs.back().path, "sub/tile.bin");
}

TEST(ObjectsXml, StlMaterialIsCalledDefault) {
  MemoryFileReader files =
      project_files(in_project("<mesh id='m' file='t.stl' format='stl' units='mm' up='z'>"
                               "<map name='default' material='white'/></mesh>"));
  files.add("dir/t.stl", square_stl_binary());
  const Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  expect_near(loaded.project->spaces.at(0).bodies.at(0).vertex_m.at(2), {0.002, 0.002, 0});
}

TEST(ObjectsXml, MeshMaterialsComeFromMapsAndTheDefault) {
  const Space space = space_with(
      "<material id='oak' reflectance='0.3'/>"
      "<mesh id='m' file='table.obj' units='m' up='z' material='white'>"
      "<map name='wood' material='oak'/></mesh>");
  EXPECT_EQ(space.bodies.at(0).material_of, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_FALSE(space.bodies[0].is_closed);
}

TEST(ObjectsXml, ReadsEachMeshFileOnce) {
  const MemoryFileReader files = project_files(
      in_project("<mesh id='m' file='table.obj' units='m' up='z' material='white'/>"
                 "<mesh id='n' file='x/../table.obj' units='m' up='z' material='white'/>"));
  const Loaded loaded = load(files);
  EXPECT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(files.reads("dir/table.obj"), 1);
}

TEST(ObjectsXml, AssemblyMovesItsPartsTogether) {
  const Space space = space_with(
      "<assembly id='a' position='10 0 0' rotation='90'>"
      "<box id='b' size='2 1 1' position='1 0 0' material='white'/>"
      "<assembly id='c' position='0 0 5' rotation='90'>"
      "<quad id='q' origin='1 0 0' u='1 0 0' v='0 0 1' material='white'/></assembly></assembly>");
  ASSERT_EQ(space.bodies.size(), 2u);
  EXPECT_EQ(space.bodies[0].id, "a.b");
  expect_box(space.bodies[0], {9, 1, 0}, {10, 3, 1});
  EXPECT_EQ(space.bodies[1].id, "a.c.q");
  expect_near(space.bodies[1].vertex_m.at(0), {9, 0, 5});
  expect_near(space.bodies[1].vertex_m.at(1), {8, 0, 5});
}

TEST(ObjectsXml, RepeatedAssemblyNamesPartsByCopy) {
  const Space space = space_with(
      "<assembly id='a' repeat='1 2 1' step='0 5 0' rotation='180'>"
      "<box id='b' size='1 1 1' material='white' repeat='2 1 1' step='3 0 0'/></assembly>");
  ASSERT_EQ(space.bodies.size(), 4u);
  EXPECT_EQ(space.bodies[3].id, "a[0,1,0].b[1,0,0]");
  expect_box(space.bodies[3], {-4, 4, 0}, {-3, 5, 1});  // the step itself is not turned
}

TEST(ObjectsXml, LuminairesTurnWithTheirAssembly) {
  const Space space = space_with(
      "<assembly id='a' position='0 0 3' rotation='90'>"
      "<luminaire id='l' type='spot' position='1 0 0' aim='2 0 0'/></assembly>");
  const Luminaire& luminaire = space.luminaires.at(0);
  EXPECT_EQ(luminaire.id, "a.l");
  expect_near(luminaire.position_m, {0, 1, 3});
  expect_near(-luminaire.world_from_luminaire[2], {0, 1, 0});
}

TEST(ObjectsXml, SixteenLevelsOfAssembliesAreTheLimit) {
  const auto nested = [](int levels) {
    std::string text = "<box id='b' size='1 1 1' material='white'/>";
    for (int i = 0; i < levels; ++i) text = "<assembly id='a'>" + text + "</assembly>";
    return in_project(text);
  };
  EXPECT_TRUE(load(nested(16)).project);
  const Loaded refused = load(nested(17));
  EXPECT_FALSE(refused.project);
  EXPECT_NE(refused.messages.find("assemblies are nested more than 16 deep"), std::string::npos);
}

TEST(ObjectsXml, NestedRepeatsAreCountedBeforeTheyAreMade) {
  std::string text = "<quad id='q' origin='0 0 0' u='1 0 0' v='0 1 0' material='white'/>";
  for (int i = 0; i < 10; ++i) {
    text = "<assembly id='a' repeat='1000 1 1' step='1 0 0'>" + text + "</assembly>";
  }
  const Loaded loaded = load(in_project(text));
  EXPECT_FALSE(loaded.project);
  EXPECT_NE(loaded.messages.find("error[beyond-limit]: 'a' brings the model to 1000000 "),
            std::string::npos)
      << loaded.messages;
}

TEST(ObjectsXml, RepeatedEmptyAssembliesTakeNoTime) {
  std::string text;
  for (int i = 0; i < 5; ++i) {
    text = "<assembly id='a' repeat='2000000000 2000000000 1' step='1 1 0'>" + text + "</assembly>";
  }
  EXPECT_TRUE(load(in_project(text)).project);
}

}  // namespace
}  // namespace calc::tests::objects_xml_test
