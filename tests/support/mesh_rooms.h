#pragma once
// OBJ files of boxes, for rooms from meshes.

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <array>
#include <string>

namespace test_support {

// Appends objects to one OBJ text.
class ObjText {
 public:
  // Faces as quads that look outward, or into the box. without: a face that is left out, in the
  // order floor, ceiling, south, east, north, west; -1: none. odd: the one that looks the other
  // way.
  ObjText& box(const std::string& name, const glm::dvec3& low, const glm::dvec3& high, bool inward,
               int without = -1, int odd = -1) {
    text_ += "o " + name + "\n";
    for (int i = 0; i < 8; ++i) {
      text_ += fmt::format("v {} {} {}\n", i % 2 == 0 ? low.x : high.x,
                           (i / 2) % 2 == 0 ? low.y : high.y, i < 4 ? low.z : high.z);
    }
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}};
    for (int f = 0; f < 6; ++f) {
      if (f == without) continue;
      const std::array<int, 4> c = kFaces[static_cast<std::size_t>(f)];
      const bool is_turned = inward != (f == odd);
      const auto n = [&](std::size_t i) { return vertices_ + 1 + c[i]; };
      text_ += is_turned ? fmt::format("f {} {} {} {}\n", n(0), n(3), n(2), n(1))
                         : fmt::format("f {} {} {} {}\n", n(0), n(1), n(2), n(3));
    }
    vertices_ += 8;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int vertices_ = 0;
};

}  // namespace test_support
