#pragma once
// The axis-parallel box around points of a plane.

#include <glm/glm.hpp>

#include <algorithm>
#include <limits>

namespace report {

struct FlatBox {
  glm::dvec2 low{std::numeric_limits<double>::max()};
  glm::dvec2 high{std::numeric_limits<double>::lowest()};

  void add(const glm::dvec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool is_empty() const { return !(low.x <= high.x); }
  glm::dvec2 size() const { return high - low; }
  double longest() const { return std::max(size().x, size().y); }
  bool meets(const FlatBox& other) const {
    return low.x <= other.high.x && high.x >= other.low.x && low.y <= other.high.y &&
           high.y >= other.low.y;
  }
  bool contains(const glm::dvec2& p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
};

}  // namespace report
