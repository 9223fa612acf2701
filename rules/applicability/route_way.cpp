#include "rules/applicability/route_way.h"

#include "calc/base/sentences.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace rules {
namespace {

constexpr double kChest_m = 1.0;  // above what stairs and sills are, below what lintels are

struct Obstacle {
  glm::dvec3 a, b, c;
  const calc::Body* body;
};

// Edges belong to the triangle.
bool crosses(const glm::dvec3& from, const glm::dvec3& to, const Obstacle& triangle) {
  const glm::dvec3 way = to - from, u = triangle.b - triangle.a, v = triangle.c - triangle.a;
  const glm::dvec3 p = glm::cross(way, v);
  const double determinant = glm::dot(u, p);
  if (determinant == 0.0) return false;  // alongside it
  const glm::dvec3 s = from - triangle.a, q = glm::cross(s, u);
  const double x = glm::dot(s, p) / determinant, y = glm::dot(way, q) / determinant;
  const double t = glm::dot(v, q) / determinant;
  return x >= 0.0 && y >= 0.0 && x + y <= 1.0 && t >= 0.0 && t <= 1.0;
}

class Way {
 public:
  Way(const calc::SensorGrid& grid, const calc::Space& space)
      : grid_(grid),
        point_of_(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows)) {
    for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
      point_of_[cell(grid.column[i], grid.row[i])] = i;
    }
    collect(space);
  }

  calc::Message barred() const {
    for (int column = 0; column < grid_.columns; ++column) {
      if (const auto words = lost(column); !words.empty()) return words;
    }
    for (int column = 0; column + 1 < grid_.columns; ++column) {
      if (const auto words = barred_after(column); !words.empty()) return words;
    }
    return {};
  }

 private:
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(grid_.rows) +
           static_cast<std::size_t>(row);
  }

  void collect(const calc::Space& space) {
    if (grid_.position_m.empty()) return;
    glm::dvec3 low = grid_.position_m.front(), high = low;
    for (const glm::dvec3& point : grid_.position_m) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    low.z += kChest_m;
    high.z += kChest_m;
    for (const calc::Body& body : space.bodies) {
      for (const glm::uvec3& corner : body.triangle) {
        const Obstacle one{body.vertex_m[corner.x], body.vertex_m[corner.y],
                           body.vertex_m[corner.z], &body};
        const glm::dvec3 least = glm::min(one.a, glm::min(one.b, one.c));
        const glm::dvec3 most = glm::max(one.a, glm::max(one.b, one.c));
        const bool is_near =
            glm::all(glm::lessThanEqual(least, high)) && glm::all(glm::greaterThanEqual(most, low));
        if (is_near) obstacles_.push_back(one);
      }
    }
  }

  // Returns words for a station of which every point is omitted.
  calc::Message lost(int column) const {
    for (int row = 0; row < grid_.rows; ++row) {
      if (point_of_[cell(column, row)]) return {};
    }
    const auto dropped =
        std::find_if(grid_.dropped.begin(), grid_.dropped.end(),
                     [&](const calc::DroppedPoint& point) { return point.column == column; });
    if (dropped == grid_.dropped.end()) return {};
    const glm::dvec3& at_m = dropped->position_m;
    return dropped->body.empty()
               ? calc::say<calc::Sentence::nobody_passes_floor>(at_m.x, at_m.y, at_m.z)
               : words(at_m, dropped->body);
  }

  const calc::Body* between(const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 up(0.0, 0.0, kChest_m);
    for (const Obstacle& obstacle : obstacles_) {
      if (crosses(from + up, to + up, obstacle)) return obstacle.body;
    }
    return nullptr;
  }

  calc::Message barred_after(int column) const {
    const calc::Body* first = nullptr;
    glm::dvec3 place{0.0};
    for (int row = 0; row < grid_.rows; ++row) {
      const auto here = point_of_[cell(column, row)], next = point_of_[cell(column + 1, row)];
      if (!here || !next) continue;
      const calc::Body* body = between(grid_.position_m[*here], grid_.position_m[*next]);
      if (body == nullptr) return {};
      if (first == nullptr) place = grid_.position_m[*here];
      first = first == nullptr ? body : first;
    }
    return first == nullptr ? calc::Message() : words(place, first->id);
  }

  static calc::Message words(const glm::dvec3& at_m, const std::string& body) {
    return calc::say<calc::Sentence::nobody_passes>(at_m.x, at_m.y, at_m.z, body);
  }

  const calc::SensorGrid& grid_;
  std::vector<std::optional<std::size_t>> point_of_;  // by cell; empty: left out
  std::vector<Obstacle> obstacles_;
};

}  // namespace

calc::Message barred_words(const calc::SensorGrid& grid, const calc::Space& space) {
  return grid.route ? Way(grid, space).barred() : calc::Message();
}

}  // namespace rules
