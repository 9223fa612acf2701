#pragma once
// The result of every reader of mesh files.

#include "calc/base/names.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

enum class MeshFormat { obj, gltf, stl, ply };

template <>
struct EnumNames<MeshFormat> {
  static constexpr EnumName<MeshFormat> list[] = {{MeshFormat::obj, "obj"},
                                                  {MeshFormat::gltf, "gltf"},
                                                  {MeshFormat::stl, "stl"},
                                                  {MeshFormat::ply, "ply"}};
};

// Returns true for glTF, which is in metres with y up by its standard; other formats do not say.
constexpr bool has_fixed_units(MeshFormat format) { return format == MeshFormat::gltf; }

// A mesh in the file's own units and axes; glTF with the transforms of its nodes applied. All
// coordinates are finite and at most kMaxMeshCoordinate; no triangle has an area of exactly zero.
struct TriangleMesh {
  MeshFormat format = MeshFormat::obj;
  std::vector<glm::dvec3> vertex;
  std::vector<glm::uvec3> triangle;
  // Per triangle, indices into the names, each of which has a triangle.
  std::vector<std::uint32_t> material_of, object_of;
  std::vector<std::string> material_name;  // "" = the file names none
  std::vector<std::string> object_name;    // "" = the file names none
  std::size_t faces = 0;                   // of the file, before they were split
  std::size_t faces_left_out = 0;          // of them, without area or with crossing sides
  std::size_t faces_mended = 0;            // of them, see polygon_mend.h
  double area_left_out = 0.0;              // what these enclose, square units of the file
};

inline constexpr double kMaxMeshCoordinate = 1.0e12;  // areas stay far from overflow
inline constexpr std::size_t kMaxMeshTriangles = 10'000'000;
inline constexpr std::size_t kMaxMeshVertices = 30'000'000;

// The material of STL and PLY faces, because these formats name none.
inline constexpr std::string_view kDefaultMeshMaterial = "default";

}  // namespace calc
