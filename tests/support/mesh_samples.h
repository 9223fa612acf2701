#pragma once
// Small mesh files made in memory.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace calc::tests {

// The bytes of a number as this machine stores it (little endian).
template <class T>
std::string raw(T number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

inline std::string floats(const std::vector<float>& numbers) {
  std::string bytes;
  for (const float number : numbers) bytes += raw(number);
  return bytes;
}

// The square 0..2 x 0..2 at z = 0 as two triangles.
inline const std::string kSquareStlText =
    "solid tile one\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 2 0 0\n"
    "   vertex 2 2 0\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n"
    "   vertex 0 0 0\n   vertex 2 2 0\n   vertex 0 2 0\n  endloop\n endfacet\nendsolid tile one\n";

inline std::string stl_triangle(const std::vector<float>& corners) {
  return floats({0, 0, 1}) + floats(corners) + raw(std::uint16_t{0});
}
inline std::string square_stl_binary() {
  return std::string(80, 's') + raw(std::uint32_t{2}) + stl_triangle({0, 0, 0, 2, 0, 0, 2, 2, 0}) +
         stl_triangle({0, 0, 0, 2, 2, 0, 0, 2, 0});
}

inline const std::string kSquarePlyText =
    "ply\nformat ascii 1.0\ncomment none\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0 255\n2 0 0 255\n2 2 0 255\n0 2 0 255\n4 0 1 2 3\n";

// Positions of the square 0..2 x 0..2 (48 bytes), then its six indices as unsigned short (12).
inline std::string square_bytes() {
  std::string bytes = floats({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0});
  for (const int index : {0, 1, 2, 0, 2, 3}) bytes += raw(static_cast<std::uint16_t>(index));
  return bytes;
}

// A node "tile" with the square in the material "grey"; the buffer is the file tile.bin.
inline const std::string kSquareGltf = R"({"asset":{"version":"2.0"},"scene":0,
"scenes":[{"nodes":[0]}],"nodes":[{"name":"tile","mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"name":"grey"}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],
"buffers":[{"uri":"tile.bin","byteLength":60}]})";

// `text` with its first `from` replaced; "" if there is none, so that a test cannot pass by chance.
inline std::string with(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "";
  return text.substr(0, at) + to + text.substr(at + from.size());
}

inline std::string glb(std::string json, std::string binary) {
  json.append((4 - json.size() % 4) % 4, ' ');
  binary.append((4 - binary.size() % 4) % 4, '\0');
  std::string chunks = raw(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
  if (!binary.empty()) {
    chunks += raw(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
  }
  return "glTF" + raw(std::uint32_t{2}) + raw(static_cast<std::uint32_t>(12 + chunks.size())) +
         chunks;
}

inline std::string square_glb() {
  return glb(with(kSquareGltf, R"("uri":"tile.bin",)", ""), square_bytes());
}

}  // namespace calc::tests
