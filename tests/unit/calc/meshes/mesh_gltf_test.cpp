#include "calc/meshes/mesh_gltf.h"
#include "tests/unit/calc/meshes/mesh_file_support.h"

#include <limits>

namespace calc::tests::mesh_gltf_test {
namespace {

Parsed parse_square(const std::string& json, const std::string& bytes = square_bytes()) {
  return parse(json, "tile.gltf", {{"tile.bin", bytes}});
}

std::string broken(const std::string& what) {
  return "tile.gltf: error[mesh-broken]: glTF file: " + what;
}

TEST(GltfMesh, ReadsItsBufferFromTheFileBesideIt) {
  const Parsed parsed = parse_square(kSquareGltf);
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.messages, "");
  EXPECT_EQ(parsed.mesh->format, MeshFormat::gltf);
  EXPECT_EQ(parsed.mesh->object_name, std::vector<std::string>{"tile"});
  EXPECT_EQ(parsed.mesh->material_name, std::vector<std::string>{"grey"});
  EXPECT_EQ(parsed.mesh->triangle, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(upper_corner(*parsed.mesh), glm::dvec3(2, 2, 0));
}

TEST(GltfMesh, ReadsGlbAndDataUris) {
  EXPECT_TRUE(parse(square_glb(), "tile.glb").mesh);
  // Three zero bytes in base64 are "AAAA"; all positions are zero then, so that no face has an
  // area.
  const std::string zeros =
      with(kSquareGltf, "tile.bin", "data:application/octet-stream;base64," + std::string(80, 'A'));
  EXPECT_EQ(parse(zeros, "tile.gltf").messages,
            "tile.gltf: error[mesh-without-faces]: no face with an area in this mesh (4 vertices, "
            "2 faces)");
}

TEST(GltfMesh, BufferNamesMayHaveCodesAndFolders) {
  const std::string json = with(kSquareGltf, "tile.bin", "parts/my%20tile+1.bin");
  EXPECT_TRUE(parse(json, "tile.gltf", {{"parts/my tile+1.bin", square_bytes()}}).mesh);
}

TEST(GltfMesh, BufferNamesMustNotLeadAway) {
  for (const std::string uri : {"../tile.bin", "%2e%2e/tile.bin", "/etc/passwd", "a/../../b",
                                "http://example.org/tile.bin", "file:tile.bin", "."}) {
    EXPECT_EQ(parse_square(with(kSquareGltf, "tile.bin", uri)).messages,
              broken("its buffer '" + uri + "' is not a file beside it or in a folder below it"));
  }
  EXPECT_EQ(parse(kSquareGltf, "tile.gltf").messages,
            "tile.gltf: error[file-not-readable]: cannot read 'tile.bin': absent");
}

TEST(GltfMesh, ImagesAreNeverAskedFor) {
  const Parsed parsed = parse_square(
      with(kSquareGltf, R"("buffers")", R"("images":[{"uri":"absent.png"}],"buffers")"));
  EXPECT_TRUE(parsed.mesh) << parsed.messages;
}

TEST(GltfMesh, NodesMoveTheirChildren) {
  // Turned by 90 degrees about y (z becomes x), stretched along x before, shifted after.
  const std::string json = with(
      with(
          kSquareGltf, R"({"name":"tile","mesh":0})",
          R"({"name":"top","children":[1],"translation":[10,0,0]},)"
          R"({"mesh":0,"rotation":[0,0.70710678118654752,0,0.70710678118654752],"scale":[3,1,1]})"),
      R"("meshes":[{)", R"("meshes":[{"name":"plate",)");
  const Parsed parsed = parse_square(json);
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->object_name, std::vector<std::string>{"plate"});
  const glm::dvec3 corner = parsed.mesh->vertex.at(2);
  EXPECT_NEAR(glm::distance(corner, glm::dvec3(10, 2, -6)), 0.0, 1e-12);
}

TEST(GltfMesh, MatricesAreByColumns) {
  const Parsed parsed = parse_square(with(
      kSquareGltf, R"("mesh":0})", R"("mesh":0,"matrix":[0,0,1,0, 0,1,0,0, 1,0,0,0, 5,6,7,1]})"));
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->vertex.at(1), glm::dvec3(5, 6, 9));
}

TEST(GltfMesh, MeshesMayBeUsedTwice) {
  const std::string json =
      with(with(kSquareGltf, R"("nodes":[0])", R"("nodes":[0,1])"), R"({"name":"tile","mesh":0})",
           R"({"name":"tile","mesh":0},{"mesh":0,"translation":[0,0,3]})");
  const Parsed parsed = parse_square(json);
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->object_name, (std::vector<std::string>{"tile", "node 1"}));
  EXPECT_DOUBLE_EQ(area(*parsed.mesh), 8.0);
}

TEST(GltfMesh, OnlyTheDefaultSceneCounts) {
  const std::string json =
      with(with(kSquareGltf, R"({"nodes":[0]})", R"({"nodes":[0]},{"nodes":[1]})"),
           R"({"name":"tile","mesh":0})", R"({"name":"a","mesh":0},{"name":"b","mesh":0})");
  EXPECT_EQ(parse_square(json).mesh->object_name, std::vector<std::string>{"a"});
  EXPECT_EQ(parse_square(with(json, R"("scene":0)", R"("scene":1)")).mesh->object_name,
            std::vector<std::string>{"b"});
}

TEST(GltfMesh, StripsAndFansAreTriangles) {
  for (const std::string mode : {"5", "6"}) {
    const Parsed parsed = parse_square(
        with(with(kSquareGltf, R"("indices":1)", R"("mode":)" + mode), "\"grey\"", "\"\""));
    ASSERT_TRUE(parsed.mesh) << parsed.messages;
    EXPECT_EQ(parsed.mesh->triangle.size(), 2u);
    // A strip takes corners 1 2 3 for its second triangle, a fan 0 2 3.
    EXPECT_EQ(parsed.mesh->triangle[1], mode == "5" ? glm::uvec3(1, 3, 2) : glm::uvec3(2, 3, 0));
    EXPECT_EQ(parsed.mesh->material_name, std::vector<std::string>{"material 0"});
  }
}

TEST(GltfMesh, PointsAndLinesAreNotSurfaces) {
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("indices":1)", R"("mode":1,"indices":1)")).messages,
            "tile.gltf: error[mesh-without-faces]: no face with an area in this mesh (0 vertices, "
            "0 faces)");
}

TEST(GltfMesh, SparseAccessorsReplacePositions) {
  const std::string bytes =
      square_bytes() + raw(std::uint16_t{2}) + std::string(2, '\0') + floats({2, 2, 5});
  std::string json = with(kSquareGltf, R"("type":"VEC3")",
                          R"("type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,)"
                          R"("componentType":5123},"values":{"bufferView":3}})");
  json = with(json, R"("byteLength":12}])",
              R"("byteLength":12},{"buffer":0,"byteOffset":60,"byteLength":2},)"
              R"({"buffer":0,"byteOffset":64,"byteLength":12}])");
  json = with(json, R"("byteLength":60)", R"("byteLength":76)");
  const Parsed parsed = parse_square(json, bytes);
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_EQ(parsed.mesh->vertex.at(2), glm::dvec3(2, 2, 5));
  EXPECT_EQ(
      parse_square(with(json, R"("sparse":{"count":1)", R"("sparse":{"count":2)"), bytes).messages,
      broken("an accessor of 2 elements does not fit into buffer view 2 of 2 bytes"));
}

TEST(GltfMesh, QuantisedPositionsAreRead) {
  std::string bytes;
  for (const int number : {0, 0, 0, 0, 2, 0, 0, 0, 2, 2, 0, 0, 0, 2, 0, 0}) {
    bytes += raw(static_cast<std::int16_t>(number));
  }
  bytes.resize(48);
  for (const int index : {0, 1, 2, 0, 2, 3}) bytes += raw(static_cast<std::uint16_t>(index));
  std::string json = with(kSquareGltf, R"("componentType":5126)", R"("componentType":5122)");
  json = with(json, R"("byteLength":48})", R"("byteLength":48,"byteStride":8})");
  json = with(json, R"("scene":0)", R"("extensionsRequired":["KHR_mesh_quantization"],"scene":0)");
  const Parsed parsed = parse_square(json, bytes);
  ASSERT_TRUE(parsed.mesh) << parsed.messages;
  EXPECT_DOUBLE_EQ(area(*parsed.mesh), 4.0);
  const Parsed normalized =
      parse_square(with(json, R"("type":"VEC3")", R"("type":"VEC3","normalized":true)"), bytes);
  EXPECT_DOUBLE_EQ(upper_corner(*normalized.mesh).x, 2.0 / 32767.0);
}

TEST(GltfMesh, RequiredExtensionsAreRefusedByName) {
  const auto with_extension = [](const std::string& list, const std::string& names) {
    return with(kSquareGltf, R"("scene":0)", "\"" + list + "\":[" + names + R"(],"scene":0)");
  };
  EXPECT_EQ(parse_square(with_extension("extensionsRequired",
                                        R"("EXT_meshopt_compression","KHR_materials_unlit",)"
                                        R"("KHR_draco_mesh_compression")"))
                .messages,
            "tile.gltf: error[mesh-extension-required]: the file requires glTF extensions that "
            "luxgate does not read: EXT_meshopt_compression, KHR_draco_mesh_compression "
            "(compressed meshes: switch compression off in the exporter, or unpack the file with a "
            "glTF tool); export it without them");
  const Parsed optional = parse_square(
      with_extension("extensionsUsed", R"("EXT_mesh_gpu_instancing","KHR_materials_unlit")"));
  EXPECT_TRUE(optional.mesh);
  EXPECT_EQ(optional.messages,
            "tile.gltf: warning[mesh-extension-ignored]: the file uses glTF extensions that "
            "luxgate does not read: EXT_mesh_gpu_instancing; they are ignored");
}

TEST(GltfMesh, RangesOutsideTheirDataAreErrors) {
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("count":4)", R"("count":5)")).messages,
            broken("an accessor of 5 elements does not fit into buffer view 0 of 48 bytes"));
  EXPECT_EQ(
      parse_square(with(kSquareGltf, R"("count":4)", R"("count":18446744073709551615)")).messages,
      broken("accessor 0 has 18446744073709551615 elements"));
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("byteOffset":48)", R"("byteOffset":49)")).messages,
            broken("buffer view 1 reaches beyond its buffer of 60 bytes"));
  EXPECT_EQ(
      parse_square(with(kSquareGltf, R"("byteOffset":48)", R"("byteOffset":18446744073709551608)"))
          .messages,
      broken("buffer view 1 reaches beyond its buffer of 60 bytes"));
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("componentType":5126)",
                              R"("byteOffset":4,"componentType":5126)"))
                .messages,
            broken("an accessor of 4 elements does not fit into buffer view 0 of 48 bytes"));
}

// The library would take 0 instead, and the mesh would be another one.
TEST(GltfMesh, BytesBelowZeroAreErrors) {
  for (const auto& [right, wrong, words] :
       {std::array{R"("byteOffset":48)", R"("byteOffset":-4)",
                   "'byteOffset' in 'bufferViews' is -4; whole numbers from 0 are allowed"},
        std::array{R"("byteOffset":48)", R"("byteOffset":4.5)",
                   "'byteOffset' in 'bufferViews' is 4.5"},
        std::array{R"("byteLength":12)", R"("byteLength":-12)", "'byteLength' in 'bufferViews'"},
        std::array{R"("count":4)", R"("count":-4)", "'count' in 'accessors' is -4"}}) {
    const std::string message = parse_square(with(kSquareGltf, right, wrong)).messages;
    EXPECT_NE(message.find(words), std::string::npos) << wrong << ": " << message;
  }
  EXPECT_EQ(
      parse_square(with(kSquareGltf, R"("name":"grey")", R"("extras":{"count":-4})")).messages, "");
}

TEST(GltfMesh, IndicesOutOfRangeAreErrors) {
  std::string bytes = square_bytes();
  bytes.replace(58, 2, raw(std::uint16_t{4}));
  EXPECT_EQ(parse_square(kSquareGltf, bytes).messages,
            broken("object 'tile', primitive 0 names position 4; allowed: 0 to 3"));
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("POSITION":0)", R"("POSITION":7)")).messages,
            broken("accessor 7 is named, but there are 2"));
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("mesh":0)", R"("mesh":3)")).messages,
            broken("mesh 3 is named, but there are 1"));
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("nodes":[0])", R"("nodes":[9])")).messages,
            broken("node 9 is named, but there are 1"));
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("material":0)", R"("material":1)")).messages,
            broken("material 1 is named, but there are 1"));
}

TEST(GltfMesh, NodesInACircleAreErrors) {
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("mesh":0})", R"("children":[0]})")).messages,
            broken("node 0 is the child of two nodes, or of itself"));
}

TEST(GltfMesh, CoordinatesThatAreNotFiniteAreErrors) {
  std::string bytes = square_bytes();
  bytes.replace(28, 4, raw(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(parse_square(kSquareGltf, bytes).messages,
            "tile.gltf: error[mesh-not-finite]: object 'tile', primitive 0, position 2: the "
            "position nan nan nan is not finite or beyond 1e+12");
}

TEST(GltfMesh, BuffersOfAnotherSizeAreErrors) {
  EXPECT_FALSE(parse_square(kSquareGltf, square_bytes() + "x").mesh);
  EXPECT_FALSE(parse_square(kSquareGltf, "").mesh);
}

TEST(GltfMesh, BrokenFramesOfGlbAreErrors) {
  const std::string good = square_glb();
  std::string longer = good;
  // The BIN chunk claims the four bytes more that an unchecked reader would take from behind it.
  const std::size_t chunk = good.find(std::string("BIN\0", 4)) - 4;
  longer.replace(chunk, 4, raw(std::uint32_t{64}));
  EXPECT_EQ(parse(longer, "t.glb").messages,
            "t.glb: error[mesh-broken]: glTF file: chunk 1 does not fit into the file");
  EXPECT_EQ(parse(good + "more", "t.glb").messages,
            "t.glb: error[mesh-broken]: glTF file: its header states " +
                std::to_string(good.size()) + " bytes, the file has " +
                std::to_string(good.size() + 4));
  std::string old = good;
  old.replace(4, 4, raw(std::uint32_t{1}));
  EXPECT_EQ(parse(old, "t.glb").messages,
            "t.glb: error[mesh-broken]: glTF file: its version is 1; only version 2 is read");
}

TEST(GltfMesh, ABufferWithoutUriIsTheGlbsOwnAndOnlyOnce) {
  const std::string json = with(kSquareGltf, R"({"uri":"tile.bin","byteLength":60})",
                                R"({"byteLength":60},{"byteLength":60})");
  EXPECT_EQ(parse(glb(json, square_bytes()), "t.glb").messages,
            "t.glb: error[mesh-broken]: glTF file: a buffer has no URI; only the first buffer of a "
            "GLB may have none");
}

TEST(GltfMesh, DeepOrBrokenJsonIsRefused) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_EQ(parse_square(with(kSquareGltf, R"("scene":0)", R"("extras":)" + deep)).messages,
            broken("its JSON is nested more than 64 deep"));
  EXPECT_EQ(parse_square("{\"asset\": nothing}").messages.substr(0, 60),
            broken("not well-formed JSON at byte").substr(0, 60));
  EXPECT_EQ(parse_square(with(kSquareGltf, "2.0", "1.0")).messages,
            broken("its version is '1.0'; only version 2 is read"));
}

TEST(GltfMesh, SkinsAndMorphTargetsAreWarnedOf) {
  const Parsed parsed = parse_square(
      with(kSquareGltf, R"("indices":1)", R"("targets":[{"POSITION":0}],"indices":1)"));
  EXPECT_TRUE(parsed.mesh);
  EXPECT_EQ(parsed.messages,
            "tile.gltf: warning[mesh-deformed]: 1 objects have a skin or morph targets, which are "
            "ignored");
}

TEST(GltfMesh, AnyCutOfAFileEndsWell) {
  expect_cuts_end_well(kSquareGltf, "tile.gltf", {{"tile.bin", square_bytes()}});
  expect_cuts_end_well(square_glb(), "tile.glb");
}

TEST(GltfMesh, AnyByteOfAGlbMayBeWrong) {
  const std::string good = square_glb();
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const char wrong : {'\0', '9', '\xFF'}) {
      std::string bytes = good;
      bytes[i] = wrong;
      parse(bytes, "tile.glb");  // expects a mesh or an error
    }
  }
}

}  // namespace
}  // namespace calc::tests::mesh_gltf_test
