#include "calc/radiosity/paths/vertex_bounds.h"

namespace calc {

VertexBounds::VertexBounds(const GeometryBound& bound, std::span<const LightVertex> vertices)
    : bound_(&bound),
      vertices_(vertices),
      lowest_(static_cast<float>(bound.smallest())),
      known_(std::make_unique<std::atomic<float>[]>(vertices.size())) {}

float VertexBounds::at(std::size_t vertex) const {
  float bound = known_[vertex].load(std::memory_order_relaxed);
  if (bound == 0.0f) {
    const LightVertex& v = vertices_[vertex];
    bound = static_cast<float>(bound_->at_lifted(glm::dvec3(v.position_m), glm::dvec3(v.normal)));
    known_[vertex].store(bound, std::memory_order_relaxed);
  }
  return bound;
}

}  // namespace calc
