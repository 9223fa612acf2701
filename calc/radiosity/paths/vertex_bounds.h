#pragma once
// Upper bounds of the geometry term at light vertices, computed only where they matter.

#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/paths/near_field.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>

namespace calc {

class VertexBounds {
 public:
  // Bounds by min(G, b(y)) with the density-aware bound: the near field adds the rest.
  VertexBounds(const GeometryBound& bound, std::span<const LightVertex> vertices);
  // Bounds by min(G, most) everywhere: the light above is lost, as in clamped instant radiosity.
  // Infinity cuts nothing.
  explicit VertexBounds(double most_per_m2) : lowest_(static_cast<float>(most_per_m2)) {}

  // Returns the geometry term up to which limited() changes nothing.
  float lowest_per_m2() const { return lowest_; }

  float limited(std::size_t vertex, float geometry_per_m2) const {
    if (geometry_per_m2 <= lowest_) return geometry_per_m2;
    return known_ ? std::min(geometry_per_m2, at(vertex)) : lowest_;
  }

 private:
  float at(std::size_t vertex) const;

  const GeometryBound* bound_ = nullptr;
  std::span<const LightVertex> vertices_;
  float lowest_;
  // 0 = not yet known. Threads may compute the same value twice; it depends on the vertex only.
  std::unique_ptr<std::atomic<float>[]> known_;
};

}  // namespace calc
