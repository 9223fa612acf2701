#include "calc/meshes/mesh_obj.h"
#include "calc/base/file_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace calc::mesh_obj_test {
namespace {

struct Parsed {
  std::optional<TriangleMesh> mesh;
  std::vector<std::string> messages;
};

Parsed parse(std::string_view text) {
  Diagnostics diagnostics;
  Parsed parsed;
  parsed.mesh = parse_obj(text, "desk.obj", diagnostics);
  for (const Diagnostic& d : diagnostics.all()) parsed.messages.push_back(format_diagnostic(d));
  EXPECT_EQ(parsed.mesh.has_value(), !diagnostics.has_errors());
  return parsed;
}

// Per triangle.
std::vector<std::string> materials(const TriangleMesh& mesh) {
  std::vector<std::string> names;
  for (const std::uint32_t name : mesh.material_of) names.push_back(mesh.material_name[name]);
  return names;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangle) {
    sum += 0.5 * glm::length(glm::cross(mesh.vertex[t.y] - mesh.vertex[t.x],
                                        mesh.vertex[t.z] - mesh.vertex[t.x]));
  }
  return sum;
}

void expect_one_error(std::string_view text, const std::string& message) {
  const Parsed parsed = parse(text);
  EXPECT_FALSE(parsed.mesh);
  ASSERT_EQ(parsed.messages.size(), 1u);
  EXPECT_EQ(parsed.messages[0], message);
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ObjMesh, TakesCoordinatesExactly) {
  const Parsed parsed = parse("v 0.1 1e6 -1000000.0000001\nv +1 0 0 0.5\nv 0 1 0 1 0 0\nf 1 2 3\n");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->vertex[0], glm::dvec3(0.1, 1e6, -1000000.0000001));
  EXPECT_EQ(parsed.mesh->vertex[1], glm::dvec3(1, 0, 0)) << "a fourth number is a weight";
  EXPECT_TRUE(parsed.messages.empty());
}

TEST(ObjMesh, TakesEveryFormOfFaceStatement) {
  const Parsed parsed = parse(kThree + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\n" +
                              "f 1//1 2//1 3//1\r\n  f\t1/1/1 2/1/1  3/1/1 \nf -3 -2 -1");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle, std::vector<glm::uvec3>(5, glm::uvec3(0, 1, 2)));
}

TEST(ObjMesh, FacesMayNameLaterVertices) {
  const Parsed parsed = parse("f 1 2 3\n" + kThree);
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 1u);
}

TEST(ObjMesh, MaterialNamesNeedNoMaterialFile) {
  const Parsed parsed = parse(kThree + "f 1 2 3\nusemtl oak\nf 1 2 3\no top\nf 3 2 1\n" +
                              "mtllib missing.mtl\nusemtl white paint \nf 1 2 3\n");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(materials(*parsed.mesh), (std::vector<std::string>{"", "oak", "oak", "white paint"}));
  EXPECT_TRUE(parsed.messages.empty());
}

TEST(ObjMesh, ObjectsAreNamedByTheLastObjectOrGroupStatement) {
  const Parsed parsed =
      parse(kThree + "f 1 2 3\no desk \nf 1 2 3\ng left leg\nf 3 2 1\no desk\n" + "f 1 2 3\n");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->object_name, (std::vector<std::string>{"", "desk", "left leg"}));
  EXPECT_EQ(parsed.mesh->object_of, (std::vector<std::uint32_t>{0, 1, 2, 1}));
}

TEST(ObjMesh, EachTriangleOfAFaceHasItsMaterial) {
  const Parsed parsed =
      parse("usemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nusemtl b\nf 1 2 3\n");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(materials(*parsed.mesh), (std::vector<std::string>{"a", "a", "b"}));
}

TEST(ObjMesh, ConcaveFacesKeepTheirArea) {
  const Parsed parsed = parse(
      "v 0 7 0\nv 6 7 0\nv 6 7 2\nv 3 7 2\nv 3 7 5\nv 0 7 5\n"
      "f 4 5 6 1 2 3\n");  // a fan from the first corner would be right, one from the second not
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 4u);
  EXPECT_NEAR(area(*parsed.mesh), 21.0, 1e-12);
  const Parsed dart = parse("v 0 0 0\nv 4 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");
  ASSERT_TRUE(dart.mesh);
  EXPECT_NEAR(area(*dart.mesh), 3.0, 1e-12) << "a fan from corner 1 gives 5";
}

TEST(ObjMesh, FacesWithMoreThan255CornersAreWhole) {
  std::string text, face = "f";
  for (int i = 0; i < 300; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 300;
    text += fmt::format("v {:.17g} {:.17g} 0\n", std::cos(angle), std::sin(angle));
    face += fmt::format(" {}", i + 1);
  }
  const Parsed parsed = parse(text + face);
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 298u);
  EXPECT_NEAR(area(*parsed.mesh), 150.0 * std::sin(2.0 * 3.14159265358979 / 300), 1e-9);
}

TEST(ObjMesh, NeedlesAndTinyTrianglesAreKept) {
  const Parsed parsed = parse(
      "v 0 0 0\nv 1000 0 0\nv 1000 1e-9 0\nf 1 2 3\n"
      "v 5 5 5\nv 5.0000001 5 5\nv 5 5.0000001 5\nf 4 5 6\n");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 2u);
  EXPECT_TRUE(parsed.messages.empty());
}

TEST(ObjMesh, BentFacesAreSplitWithOneWarning) {
  const Parsed parsed = parse(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 1 0.01\nv 1 1 0.1\nf 1 2 3 4\nf 1 2 5 4\nf 1 2 6 "
      "4\n");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 6u);
  ASSERT_EQ(parsed.messages.size(), 1u);
  EXPECT_EQ(parsed.messages[0],
            "desk.obj:9: warning[mesh-bent-faces]: 2 of 3 faces are not flat to 1e-6 of their size "
            "(the worst, face 3, by 1.8e-02); they were split into triangles");
}

TEST(ObjMesh, FacesWithoutAreaAreLeftOutWithOneWarning) {
  const Parsed parsed = parse(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\n"
      "f 1 2 3 4\n"
      "f 1 3 2 4\n"  // crosses itself
      "f 1 2 5\n"    // on one line
      "f 1 2 1\n"    // two corners
      "f 1\n"
      "f 1 2 2 3\n");  // a triangle in the end
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 3u);
  EXPECT_EQ(parsed.mesh->triangle[2], glm::uvec3(0, 1, 2));
  ASSERT_EQ(parsed.messages.size(), 2u);
  EXPECT_EQ(
      parsed.messages[0],
      "desk.obj:11: warning[mesh-mended-faces]: 1 of 6 faces were mended and keep their areas: 1 "
      "doubled corner; the longest part that was removed is 0 long, at (0, 0, 0) in the file's "
      "unit, of face 6");
  EXPECT_EQ(
      parsed.messages[1],
      "desk.obj:7: warning[mesh-faces-left-out]: 4 of 6 faces were left out, the first one is "
      "face 2: they have no area or their sides cross; an area of 0.5 (in the file's unit, "
      "squared) "
      "is missing, 0.5 of it of face 2");
}

// A square with a spike and one with a hole that a doubled side joins.
TEST(ObjMesh, FacesAreMendedAndSaid) {
  const Parsed parsed = parse(
      "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 7 4 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n"
      "f 1 2 3 5 3 4\n"
      "f 1 6 7 8 9 6 1 2 3 4\n");
  ASSERT_TRUE(parsed.mesh);
  double area = 0.0;
  for (const glm::uvec3& t : parsed.mesh->triangle) {
    const auto& v = parsed.mesh->vertex;
    area += 0.5 * glm::cross(v[t.y] - v[t.x], v[t.z] - v[t.x]).z;
  }
  EXPECT_NEAR(area, 16.0 + 15.0, 1e-12);
  EXPECT_EQ(parsed.mesh->faces_mended, 2u);
  ASSERT_EQ(parsed.messages.size(), 1u);
  EXPECT_EQ(
      parsed.messages[0],
      "desk.obj:10: warning[mesh-mended-faces]: 2 of 2 faces were mended and keep their areas: 1 "
      "spike, 1 joined hole or part; the longest part that was removed is 3 long, at (7, 4, 0) in "
      "the file's unit, of face 1");
}

TEST(ObjMesh, IndicesBeforeTheStartAreErrors) {
  expect_one_error(
      "v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 1 0\n",
      "desk.obj:3: error[mesh-bad-index]: face 1 names vertex -3; allowed: numbers from "
      "1, or -1 to -2 for those before the face");
  expect_one_error(
      kThree + "f 0 1 2\n",
      "desk.obj:4: error[mesh-bad-index]: face 1 names vertex 0; allowed: numbers from "
      "1, or -1 to -3 for those before the face");
}

TEST(ObjMesh, IndicesBeyondTheEndAreErrors) {
  expect_one_error(kThree + "\n\nf 1 2 3\nf 1 2 4\n",
                   "desk.obj:7: error[mesh-bad-index]: face 2 names vertex 4; allowed: 1 to 3");
}

TEST(ObjMesh, IndicesThatWouldWrapAroundAreErrors) {
  expect_one_error(kThree + "f 4294967297 2 3\n",
                   "desk.obj:4: error[mesh-bad-face]: face 1: '4294967297 2 3' is not a list of "
                   "vertex numbers such as '1 2 3' or '1/1/1 2/2/1 3/3/1'");
}

TEST(ObjMesh, FacesThatAreNotNumbersAreErrors) {
  for (const std::string face : {"1 2 c", "1.5 2 3", "1 2 \\ 3", "1 2 0x3", "a b c"}) {
    const Parsed parsed = parse(kThree + "f " + face + "\n");
    EXPECT_FALSE(parsed.mesh) << face;
    EXPECT_EQ(parsed.messages.size(), 1u) << face;
  }
}

TEST(ObjMesh, CoordinatesThatAreNotFiniteNumbersAreErrors) {
  expect_one_error("v 1 nan 2\nf 1 1 1\n",
                   "desk.obj:1: error[mesh-bad-vertex]: vertex 1: '1 nan 2' is not three decimal "
                   "numbers of at most 1e+12");
  for (const std::string vertex :
       {"inf 0 0", "1e999 0 0", "0 0", "1,5 0 0", "0 0 1.#IND", "1e13 0 0"}) {
    const Parsed parsed = parse(kThree + "v " + vertex + "\nf 1 2 3\n");
    EXPECT_FALSE(parsed.mesh) << vertex;
    EXPECT_EQ(parsed.messages.size(), 1u) << vertex;
  }
}

TEST(ObjMesh, ErrorsEndAfterTen) {
  std::string text = kThree;
  for (int i = 0; i < 1000; ++i) text += "f 1 2 9\n";
  const Parsed parsed = parse(text);
  EXPECT_FALSE(parsed.mesh);
  EXPECT_EQ(parsed.messages.size(), 11u);
}

TEST(ObjMesh, ABackslashGoesOnWithTheNextLine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const Parsed parsed = parse(kThree + "f 1 \\" + end + "2 \\" + end + "3" + end);
    ASSERT_TRUE(parsed.mesh);
    EXPECT_EQ(parsed.mesh->triangle.size(), 1u);
  }
  // A comment ends with its line, and later lines keep their numbers.
  const Parsed counted = parse("# C:\\models\\\n" + kThree + "f 1 2 \\\n3\nf 1 2 9\n");
  ASSERT_EQ(counted.messages.size(), 1u);
  EXPECT_TRUE(counted.messages[0].starts_with("desk.obj:7: ")) << counted.messages[0];
}

TEST(ObjMesh, AFileWithoutFacesIsAnError) {
  expect_one_error("",
                   "desk.obj: error[mesh-without-faces]: no face with an area in this mesh (0 "
                   "vertices, 0 faces)");
  expect_one_error(kThree,
                   "desk.obj: error[mesh-without-faces]: no face with an area in this mesh (3 "
                   "vertices, 0 faces)");
  expect_one_error(kThree + "f 1 1 1\n",
                   "desk.obj: error[mesh-without-faces]: no face with an area in this mesh (3 "
                   "vertices, 1 faces)");
}

TEST(ObjMesh, BinaryFilesAreRefused) {
  expect_one_error(
      std::string_view("v 0 0 0\0\x01", 9),
      "desk.obj: error[mesh-not-text]: not a Wavefront OBJ file: it has bytes that are "
      "not text");
}

TEST(ObjMesh, HugeFacesAreRefused) {
  std::string text = kThree + "f";
  for (int i = 0; i < 5000; ++i) text += " 1 2 3";
  expect_one_error(text,
                   "desk.obj:4: error[mesh-face-too-large]: face 1 has 15000 corners; at most 2000 "
                   "are read");
}

TEST(ObjMesh, AnyCutOfAFileEndsWell) {
  const std::string text =
      "# c\r\nmtllib a.mtl\r\no desk\r\ng a b\r\nv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\n"
      "vn 0 0 1\r\nvt 0 0\r\nusemtl wood\r\ns off\r\nf 1/1/1 2/1/1 3/1/1 -1//\r\nl 1 2\r\np 1\r\n";
  for (std::size_t length = 0; length <= text.size(); ++length) parse(text.substr(0, length));
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string broken = text;
    broken[at] = '/';
    parse(broken);
    broken[at] = '-';
    parse(broken);
    broken[at] = '9';
    parse(broken);
  }
}

// Real files, where they are at hand.
TEST(ObjMesh, RealMeshesAreReadOrRefusedWithAReason) {
  const char* folder = std::getenv("LUXGATE_SHARED_DATA");
  if (folder == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const std::filesystem::path meshes = std::filesystem::path(folder) / "photometry" / "meshes";
  if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "no meshes in LUXGATE_SHARED_DATA";
  for (const auto& entry : std::filesystem::directory_iterator(meshes)) {
    if (entry.path().extension() != ".obj") continue;
    const FileContent content = DiskFileReader().read(entry.path().string());
    ASSERT_TRUE(content.ok()) << content.error;
    Diagnostics diagnostics;
    const auto mesh = parse_obj(content.bytes, entry.path().filename().string(), diagnostics);
    EXPECT_EQ(mesh.has_value(), !diagnostics.has_errors());
    RecordProperty(entry.path().stem().string(),
                   mesh ? static_cast<int>(mesh->triangle.size()) : -1);
    for (const Diagnostic& d : diagnostics.all()) std::puts(format_diagnostic(d).c_str());
    if (mesh) {
      std::printf("%s: %zu vertices, %zu triangles\n", entry.path().filename().c_str(),
                  mesh->vertex.size(), mesh->triangle.size());
    }
  }
}

}  // namespace
}  // namespace calc::mesh_obj_test
