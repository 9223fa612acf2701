#include "calc/meshes/mesh_file.h"
#include "calc/base/file_reader.h"
#include "tests/unit/calc/meshes/mesh_file_support.h"

#include <cstdlib>
#include <filesystem>

namespace calc::tests::mesh_file_test {
namespace {

TEST(MeshFile, ContentsDecideTheFormat) {
  EXPECT_EQ(detect_mesh_format(kSquareGltf), MeshFormat::gltf);
  EXPECT_EQ(detect_mesh_format("\xEF\xBB\xBF \n{}"), MeshFormat::gltf);
  EXPECT_EQ(detect_mesh_format(square_glb()), MeshFormat::gltf);
  EXPECT_EQ(detect_mesh_format(kSquareStlText), MeshFormat::stl);
  EXPECT_EQ(detect_mesh_format(square_stl_binary()), MeshFormat::stl);
  EXPECT_EQ(detect_mesh_format(kSquarePlyText), MeshFormat::ply);
  EXPECT_EQ(detect_mesh_format("v 0 0 0\n"), MeshFormat::obj);
  EXPECT_EQ(detect_mesh_format("solidity\n"), MeshFormat::obj);
  EXPECT_EQ(detect_mesh_format(""), MeshFormat::obj);
  EXPECT_EQ(detect_mesh_format(std::string("PK\0\1", 4)), std::nullopt);
}

TEST(MeshFile, NamesOfFilesDecideNothing) {
  EXPECT_EQ(parse(kSquarePlyText, "tile.obj").mesh->format, MeshFormat::ply);
  EXPECT_EQ(parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "tile.stl").mesh->format,
            MeshFormat::obj);
}

TEST(MeshFile, BytesThatAreNoMeshAreRefused) {
  EXPECT_EQ(parse(std::string("PK\0\1", 4), "tile.zip").messages,
            "tile.zip: error[file-of-other-kind]: by its name it is a ZIP archive; a mesh "
            "(OBJ, STL, PLY or glTF) is needed here. Unpack it and name the file inside");
  EXPECT_EQ(parse(std::string("PK\0\1", 4), "tile").messages,
            "tile: error[mesh-unknown-format]: unknown mesh format; luxgate reads glTF, PLY, STL "
            "and OBJ");
  EXPECT_EQ(parse("just words\n", "tile").messages,
            "tile: error[mesh-unknown-format]: unknown mesh format; luxgate reads glTF, PLY, STL "
            "and OBJ");
}

TEST(MeshFile, FilesOfOtherKindsAreNamed) {
  EXPECT_EQ(parse("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\n", "a.obj").messages,
            "a.obj: error[file-of-other-kind]: it is an IFC building model; a mesh (OBJ, STL, "
            "PLY or glTF) is needed here. 'luxgate import' begins a project with it");
  // A mesh under a foreign name is a mesh.
  EXPECT_EQ(parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "tile.rad").mesh->format,
            MeshFormat::obj);
}

TEST(MeshFile, Utf16IsRead) {
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")) {
    wide += c;
    wide += '\0';
  }
  EXPECT_EQ(parse(wide, "tile.obj").mesh->format, MeshFormat::obj);
}

// Data that is not part of the program: LUXGATE_SHARED_DATA names its folder.
TEST(MeshFile, RealMeshesAreReadOrRefusedWithAReason) {
  const char* folder = std::getenv("LUXGATE_SHARED_DATA");
  if (folder == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const std::filesystem::path meshes = std::filesystem::path(folder) / "photometry/meshes";
  if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "no meshes in LUXGATE_SHARED_DATA";
  const DiskFileReader files;
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(meshes)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".obj" && extension != ".glb" && extension != ".gltf") continue;
    Diagnostics diagnostics;
    const SideFiles beside = [&](const std::string& path) -> std::optional<std::string> {
      FileContent content = files.read((entry.path().parent_path() / path).string());
      EXPECT_TRUE(content.ok()) << path << content.error;
      return content.bytes;
    };
    const std::string bytes = files.read(entry.path().string()).bytes;
    const auto mesh = parse_mesh_file(bytes, entry.path().filename().string(), beside, diagnostics);
    EXPECT_EQ(mesh.has_value(), !diagnostics.has_errors()) << entry.path();
    if (mesh) ++read;
  }
  EXPECT_GT(read, 3u);
}

}  // namespace
}  // namespace calc::tests::mesh_file_test
