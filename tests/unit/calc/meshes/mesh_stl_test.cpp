#include "calc/meshes/mesh_stl.h"

#include "tests/unit/calc/meshes/mesh_file_support.h"

#include <limits>

namespace calc::tests::mesh_stl_test {
namespace {

const std::vector<std::string> kDefault{"default"};

TEST(StlMesh, TextIsRead) {
  const Parsed parsed = parse(kSquareStlText, "tile.stl");
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->format, MeshFormat::stl);
  EXPECT_EQ(parsed.mesh->object_name, std::vector<std::string>{"tile one"});
  EXPECT_EQ(parsed.mesh->material_name, kDefault);
  EXPECT_EQ(parsed.mesh->triangle.size(), 2u);
  EXPECT_DOUBLE_EQ(area(*parsed.mesh), 4.0);
}

TEST(StlMesh, TextMayHaveCapitalsSeveralSolidsAndAnyLineEnds) {
  std::string text = with(kSquareStlText, "solid tile one", "SOLID tile one");
  text = with(with(text, "facet normal", "FACET NORMAL"), "vertex 0 0 0", "VERTEX 0 0 0");
  text +=
      "solid two\r\nfacet normal 0 0 0\router loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\n"
      "endloop\nendfacet\nendsolid\n";
  const Parsed parsed = parse(text, "tile.stl");
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->object_name, (std::vector<std::string>{"tile one", "two"}));
  EXPECT_EQ(parsed.mesh->object_of, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(StlMesh, BinaryIsReadEvenIfItsHeaderSaysSolid) {
  std::string bytes = square_stl_binary();
  for (const char* header : {"part", "solid"}) {
    bytes.replace(0, 5, std::string(header) + std::string(5 - std::string(header).size(), ' '));
    const Parsed parsed = parse(bytes, "tile.stl");
    ASSERT_TRUE(parsed.mesh) << parsed.messages;
    EXPECT_EQ(parsed.mesh->material_name, kDefault);
    EXPECT_EQ(upper_corner(*parsed.mesh), glm::dvec3(2, 2, 0));
    EXPECT_DOUBLE_EQ(area(*parsed.mesh), 4.0);
  }
}

TEST(StlMesh, BinaryOfAnotherSizeIsRefused) {
  const std::string bytes = square_stl_binary();
  for (const std::string& wrong : {bytes.substr(0, bytes.size() - 1), bytes + "x"}) {
    const Parsed parsed = parse(wrong, "tile.stl");
    EXPECT_EQ(parsed.messages,
              "tile.stl: error[mesh-broken]: STL file: a binary file of 2 triangles has 184 bytes, "
              "this one has " +
                  std::to_string(wrong.size()));
  }
}

TEST(StlMesh, HugeCountsAreRefusedBeforeAnythingIsAllocated) {
  std::string bytes = square_stl_binary();
  bytes.replace(80, 4, raw(std::uint32_t{0xFFFFFFFF}));
  EXPECT_EQ(parse(bytes, "tile.stl").messages,
            "tile.stl: error[mesh-broken]: STL file: a binary file of 4294967295 triangles has "
            "214748364834 bytes, this one has 184");
}

TEST(StlMesh, CoordinatesThatAreNotFiniteAreErrors) {
  std::string bytes = square_stl_binary();
  bytes.replace(84 + 50 + 12 + 12, 4, raw(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(parse(bytes, "tile.stl").messages,
            "tile.stl: error[mesh-not-finite]: triangle 2, corner 2: the position nan 2 0 is not "
            "finite or beyond 1e+12");
  EXPECT_EQ(parse(with(kSquareStlText, "2 2 0", "2 inf 0"), "tile.stl").messages,
            "tile.stl:6: error[mesh-broken]: STL file: 'inf' is not a finite number");
  EXPECT_EQ(parse(with(kSquareStlText, "2 2 0", "2 2e12 0"), "tile.stl").messages,
            "tile.stl: error[mesh-not-finite]: line 6: the position 2 2000000000000 0 is not "
            "finite or beyond 1e+12");
}

TEST(StlMesh, TextWithWrongStatementsIsRefusedAtItsLine) {
  EXPECT_EQ(parse(with(kSquareStlText, "   vertex 2 2 0\n", ""), "t.stl").messages,
            "t.stl:7: error[mesh-broken]: STL file: a facet has 2 corners; 3 are needed");
  EXPECT_EQ(parse(with(kSquareStlText, "outer loop", "outer ring"), "t.stl").messages,
            "t.stl:3: error[mesh-broken]: STL file: unexpected 'outer ring'");
  EXPECT_EQ(parse(with(kSquareStlText, "endsolid tile one\n", ""), "t.stl").messages,
            "t.stl:15: error[mesh-broken]: STL file: it ends within a solid");
  EXPECT_EQ(parse("solid nothing\nendsolid\n", "t.stl").messages,
            "t.stl: error[mesh-without-faces]: no face with an area in this mesh (0 vertices, 0 "
            "faces)");
}

TEST(StlMesh, TrianglesWithoutAreaAreLeftOutAndCounted) {
  const Parsed parsed = parse(with(kSquareStlText, "vertex 2 2 0", "vertex 1 0 0"), "t.stl");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.mesh->triangle.size(), 1u);
  EXPECT_EQ(parsed.mesh->faces_left_out, 1u);
  EXPECT_EQ(parsed.messages,
            "t.stl:3: warning[mesh-faces-left-out]: 1 of 2 faces were left out, the first one is "
            "face 1: they have no area or their sides cross");
}

TEST(StlMesh, AnyCutOfAFileEndsWell) {
  expect_cuts_end_well(kSquareStlText, "t.stl");
  expect_cuts_end_well(square_stl_binary(), "t.stl");
}

}  // namespace
}  // namespace calc::tests::mesh_stl_test
