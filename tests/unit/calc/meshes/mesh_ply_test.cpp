#include "calc/meshes/mesh_ply.h"

#include "tests/unit/calc/meshes/mesh_file_support.h"

#include <limits>

namespace calc::tests::mesh_ply_test {
namespace {

template <class T>
std::string ordered(T number, bool is_big) {
  std::string bytes = raw(number);
  if (is_big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// The square with a double and a list besides, and an element that is not a surface.
std::string square_ply_binary(bool is_big, float x = 2.0F) {
  std::string bytes = "ply\nformat binary_" + std::string(is_big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n"
                      "property short z\nproperty list uchar short more\nelement edge 1\n"
                      "property int a\nelement face 1\nproperty uchar kind\n"
                      "property list ushort uint vertex_index\nend_header\n";
  for (const auto& [cx, cy] :
       {std::pair(0.0F, 0.0F), std::pair(x, 0.0F), std::pair(2.0F, 2.0F), std::pair(0.0F, 2.0F)}) {
    bytes += ordered(static_cast<double>(cx), is_big) + ordered(cy, is_big) +
             ordered(std::int16_t{7}, is_big) + '\2' + std::string(4, 'm');
  }
  bytes += std::string(4, 'e') + 'k' + ordered(std::uint16_t{4}, is_big);
  for (const std::uint32_t index : {0u, 1u, 2u, 3u}) bytes += ordered(index, is_big);
  return bytes;
}

TEST(PlyMesh, TextIsRead) {
  const Parsed parsed = parse(kSquarePlyText, "tile.ply");
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->format, MeshFormat::ply);
  EXPECT_EQ(parsed.mesh->material_name, std::vector<std::string>{"default"});
  EXPECT_EQ(parsed.mesh->triangle.size(), 2u);
  EXPECT_EQ(parsed.mesh->faces, 1u);
  EXPECT_DOUBLE_EQ(area(*parsed.mesh), 4.0);
}

TEST(PlyMesh, BinaryIsReadInBothByteOrders) {
  for (const bool is_big : {false, true}) {
    const Parsed parsed = parse(square_ply_binary(is_big), "tile.ply");
    ASSERT_TRUE(parsed.mesh) << parsed.messages;
    EXPECT_EQ(upper_corner(*parsed.mesh), glm::dvec3(2, 2, 7));
    EXPECT_DOUBLE_EQ(area(*parsed.mesh), 4.0);
  }
}

TEST(PlyMesh, ConcavePolygonsKeepTheirArea) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n5 0 1 2 3 4\n";
  const Parsed parsed = parse(text, "tile.ply");
  ASSERT_TRUE(parsed.mesh);
  EXPECT_DOUBLE_EQ(area(*parsed.mesh), 10.0);
}

TEST(PlyMesh, CountsWithoutDataAreRefused) {
  EXPECT_EQ(parse(with(kSquarePlyText, "vertex 4", "vertex 900000000000"), "t.ply").messages,
            "t.ply:12: error[mesh-broken]: PLY file: its header states 900000000000 of 'vertex', "
            "but only 50 bytes follow");
  EXPECT_EQ(parse(with(kSquarePlyText, "4 0 1 2 3", "4000000000 0 1 2 3"), "t.ply").messages,
            "t.ply:16: error[mesh-broken]: PLY file: a list 'vertex_indices' of 4000000000 "
            "numbers does not fit into the 9 bytes left");
  EXPECT_EQ(parse(with(kSquarePlyText, "4 0 1 2 3", "4 0 1 2"), "t.ply").messages,
            "t.ply:17: error[mesh-broken]: PLY file: it ends within its data");
}

TEST(PlyMesh, IndicesOutOfRangeAreErrors) {
  for (const char* index : {"4", "-1"}) {
    EXPECT_EQ(
        parse(with(kSquarePlyText, "4 0 1 2 3", std::string("4 0 1 2 ") + index), "t.ply").messages,
        std::string("t.ply:16: error[mesh-bad-index]: face 1 names vertex ") + index +
            "; allowed: 0 to 3");
  }
}

TEST(PlyMesh, NumbersThatAreNotFiniteAreErrors) {
  EXPECT_EQ(parse(with(kSquarePlyText, "2 2 0", "2 nan 0"), "t.ply").messages,
            "t.ply:14: error[mesh-broken]: PLY file: 'nan' is not a finite number");
  EXPECT_EQ(parse(with(kSquarePlyText, "4 0 1 2 3", "4 0 1 2 2.5"), "t.ply").messages,
            "t.ply:16: error[mesh-broken]: PLY file: '2.5' is not a finite whole number");
  EXPECT_EQ(
      parse(square_ply_binary(true, std::numeric_limits<float>::infinity()), "t.ply").messages,
      "t.ply: error[mesh-not-finite]: vertex 2: the position inf 0 7 is not finite or beyond "
      "1e+12");
}

TEST(PlyMesh, HeadersThatMakeNoSenseAreRefused) {
  EXPECT_EQ(parse(with(kSquarePlyText, "ascii 1.0", "ascii 2.0"), "t.ply").messages,
            "t.ply:2: error[mesh-broken]: PLY file: unknown header line 'format ascii 2.0'");
  EXPECT_EQ(parse(with(kSquarePlyText, "float y", "float w"), "t.ply").messages,
            "t.ply:12: error[mesh-broken]: PLY file: its vertices have no property 'y'");
  EXPECT_EQ(parse(with(kSquarePlyText, "vertex_indices", "corners"), "t.ply").messages,
            "t.ply:15: error[mesh-broken]: PLY file: its faces have no list of whole numbers "
            "'vertex_indices'");
  EXPECT_EQ(parse(with(kSquarePlyText, "element face", "element tristrips"), "t.ply").messages,
            "t.ply:11: error[mesh-broken]: PLY file: triangle strips are not read; export the mesh "
            "with faces");
  EXPECT_EQ(parse(with(kSquarePlyText, "end_header\n", ""), "t.ply").messages,
            "t.ply:11: error[mesh-broken]: PLY file: unknown header line '0 0 0 255'");
}

TEST(PlyMesh, AnyCutOfAFileEndsWell) {
  expect_cuts_end_well(kSquarePlyText, "t.ply");
  expect_cuts_end_well(square_ply_binary(false), "t.ply");
}

}  // namespace
}  // namespace calc::tests::mesh_ply_test
