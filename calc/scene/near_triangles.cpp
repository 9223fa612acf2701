#include "calc/scene/near_triangles.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

BoundingBox box_of(const Triangle& triangle) {
  return {glm::min(triangle.a, glm::min(triangle.b, triangle.c)),
          glm::max(triangle.a, glm::max(triangle.b, triangle.c))};
}

bool overlap(const BoundingBox& a, const BoundingBox& b) {
  return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
         glm::all(glm::lessThanEqual(b.lower, a.upper));
}

}  // namespace

NearTriangles::NearTriangles(const Space& space, const BoundingBox& region, double most_m)
    : region_{region.lower - most_m, region.upper + most_m}, most_m_(most_m) {
  if (region.is_empty()) return;
  for (const Body& body : space.bodies) {
    for (const glm::uvec3& t : body.triangle) {
      const Triangle corner{body.vertex_m[t.x], body.vertex_m[t.y], body.vertex_m[t.z]};
      const bool has_area = glm::cross(corner.b - corner.a, corner.c - corner.a) != glm::dvec3(0.0);
      if (has_area && overlap(box_of(corner), region_)) triangles_.push_back({corner, &body});
    }
  }
  lay_cells();
}

// About as many cells as triangles.
void NearTriangles::lay_cells() {
  const glm::dvec3 size_m = region_.upper - region_.lower;
  const double most_cells = 1.0 + 2.0 * static_cast<double>(triangles_.size());
  side_m_ = std::max({size_m.x, size_m.y, size_m.z}) / 1024.0;
  const auto cells = [&](double length_m) { return std::max(1.0, std::ceil(length_m / side_m_)); };
  while (cells(size_m.x) * cells(size_m.y) * cells(size_m.z) > most_cells) side_m_ *= 2.0;
  for (int axis = 0; axis < 3; ++axis) {
    count_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(cells(size_m[axis]));
  }
  begin_.assign(count_[0] * count_[1] * count_[2] + 1, 0);
  for (const BodyTriangle& one : triangles_) {
    visit_cells(one.corner_m, [&](std::size_t cell) { ++begin_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  listed_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    visit_cells(triangles_[i].corner_m,
                [&](std::size_t cell) { listed_[next[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

NearTriangles::Cell NearTriangles::cell_of(const glm::dvec3& place_m) const {
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double at = (place_m[axis] - region_.lower[axis]) / side_m_;
    cell[i] = static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count_[i] - 1)));
  }
  return cell;
}

std::size_t NearTriangles::number(const Cell& cell) const {
  return (cell[2] * count_[1] + cell[1]) * count_[0] + cell[0];
}

// Cells reach most_m beyond their sides, so that a place has all it needs in its own.
template <class Visit>
void NearTriangles::visit_cells(const Triangle& triangle, const Visit& visit) const {
  const BoundingBox box = box_of(triangle);
  const Cell low = cell_of(box.lower - most_m_), high = cell_of(box.upper + most_m_);
  const glm::dvec3 normal =
      glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
  const glm::dvec3 upright = glm::abs(normal);
  const double reach_m = 0.5 * side_m_ * (upright.x + upright.y + upright.z) + 2.0 * most_m_;
  for (std::size_t z = low[2]; z <= high[2]; ++z) {
    for (std::size_t y = low[1]; y <= high[1]; ++y) {
      for (std::size_t x = low[0]; x <= high[0]; ++x) {
        const glm::dvec3 centre_m =
            region_.lower + (glm::dvec3(x, y, z) + glm::dvec3(0.5)) * side_m_;
        // A large triangle does not meet every cell of its box.
        if (std::abs(glm::dot(normal, centre_m - triangle.a)) > reach_m) continue;
        visit(number({x, y, z}));
      }
    }
  }
}

std::vector<BodyTriangle> NearTriangles::within(const glm::dvec3& place_m, double radius_m) const {
  std::vector<BodyTriangle> near;
  if (triangles_.empty()) return near;
  const std::size_t cell = number(cell_of(place_m));
  for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
    const BodyTriangle& one = triangles_[listed_[k]];
    const BoundingBox box = box_of(one.corner_m);
    const BoundingBox around{box.lower - radius_m, box.upper + radius_m};
    if (around.contains(place_m) && distance_m(place_m, one.corner_m) <= radius_m) {
      near.push_back(one);
    }
  }
  return near;
}

}  // namespace calc
