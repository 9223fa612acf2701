#include "calc/scene/hollow_shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace calc {
namespace {

// The axes and the diagonals, in no simple ratio, so that lines from grids meet no edges of boxes.
constexpr std::array kLines{glm::dvec3(0.0131, 0.0077, 1.0),  glm::dvec3(1.0, 0.0091, 0.0117),
                            glm::dvec3(0.0083, 1.0, -0.0103), glm::dvec3(1.0, 1.03, 0.97),
                            glm::dvec3(-1.02, 1.0, 1.01),     glm::dvec3(1.0, -0.98, 1.03),
                            glm::dvec3(-1.0, -1.01, 0.99)};
constexpr int kMostUnclear = 2;        // directions that are open
constexpr int kMostOfLamp = 4;         // the same, of a luminaire in a room with windows and doors
constexpr double kMostListings = 8.0;  // of a triangle in cells, on average
constexpr double kBehind_m = 0.02;
// Of luminaires that are let into a ceiling the place before it counts.
constexpr std::array kBeforeLamp_m{0.02, 0.1, 0.3};

}  // namespace

// A body's triangles as seen along a line, in the cells of a grid.
class HollowShells::LineView {
 public:
  LineView(const Body& body, const glm::dvec3& line) : body_(body), along_(glm::normalize(line)) {
    const glm::dvec3 aside =
        std::abs(along_.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    u_ = glm::normalize(glm::cross(aside, along_));
    v_ = glm::cross(along_, u_);
    constexpr double kMostCells = 128.0;
    cells_ = static_cast<std::size_t>(
        std::clamp(std::sqrt(0.5 * static_cast<double>(body.triangle.size())), 1.0, kMostCells));
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    low_ = -high;
    for (const glm::dvec3& vertex : body.vertex_m) {
      low_ = glm::min(low_, flat(vertex));
      high = glm::max(high, flat(vertex));
    }
    size_ = high - low_;
    while (cells_ > 1 && listings() > kMostListings * static_cast<double>(body.triangle.size())) {
      cells_ /= 2;
    }
    // Counted first, then filled in.
    begin_.assign(cells_ * cells_ + 1, 0);
    for (const glm::uvec3& t : body.triangle) {
      for_each_cell(t, [&](std::size_t cell) { ++begin_[cell + 1]; });
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    listed_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t t = 0; t < body.triangle.size(); ++t) {
      for_each_cell(body.triangle[t], [&](std::size_t cell) { listed_[next[cell]++] = t; });
    }
  }

  const glm::dvec3& along() const { return along_; }

  // Whether the line through the point meets a triangle ahead of it, and behind it.
  struct Met {
    bool ahead = false, behind = false;
  };
  Met meets(const glm::dvec3& point) const {
    Met met;
    const glm::dvec2 at = flat(point);
    const std::size_t cell = cell_of(at.y, 1) * cells_ + cell_of(at.x, 0);
    for (std::size_t i = begin_[cell]; i < begin_[cell + 1] && !(met.ahead && met.behind); ++i) {
      const glm::uvec3& t = body_.triangle[listed_[i]];
      const std::array corner{body_.vertex_m[t.x] - point, body_.vertex_m[t.y] - point,
                              body_.vertex_m[t.z] - point};
      const glm::dvec2 a = flat(corner[0]), b = flat(corner[1]), c = flat(corner[2]);
      const double ab = a.x * b.y - a.y * b.x;
      const double bc = b.x * c.y - b.y * c.x;
      const double ca = c.x * a.y - c.y * a.x;
      const bool any_left = ab > 0.0 || bc > 0.0 || ca > 0.0;
      const bool any_right = ab < 0.0 || bc < 0.0 || ca < 0.0;
      if (any_left == any_right) continue;  // beside it, or it is seen from its edge
      const double height = (bc * glm::dot(along_, corner[0]) + ca * glm::dot(along_, corner[1]) +
                             ab * glm::dot(along_, corner[2])) /
                            (ab + bc + ca);
      (height > 0.0 ? met.ahead : met.behind) = true;
    }
    return met;
  }

 private:
  glm::dvec2 flat(const glm::dvec3& p) const { return {glm::dot(u_, p), glm::dot(v_, p)}; }

  std::size_t cell_of(double along, glm::length_t axis) const {
    if (!(size_[axis] > 0.0)) return 0;
    const double at = (along - low_[axis]) / size_[axis] * static_cast<double>(cells_);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(cells_ - 1)));
  }

  // Of a triangle's box, both ends included.
  struct Cells {
    std::size_t x0, x1, y0, y1;
  };
  Cells cells_of(const glm::uvec3& t) const {
    const glm::dvec2 a = flat(body_.vertex_m[t.x]), b = flat(body_.vertex_m[t.y]),
                     c = flat(body_.vertex_m[t.z]);
    const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    return {cell_of(low.x, 0), cell_of(high.x, 0), cell_of(low.y, 1), cell_of(high.y, 1)};
  }

  double listings() const {
    double sum = 0.0;
    for (const glm::uvec3& t : body_.triangle) {
      const Cells of = cells_of(t);
      sum += static_cast<double>((of.x1 - of.x0 + 1) * (of.y1 - of.y0 + 1));
    }
    return sum;
  }

  template <class Visit>
  void for_each_cell(const glm::uvec3& t, const Visit& visit) const {
    const Cells of = cells_of(t);
    for (std::size_t y = of.y0; y <= of.y1; ++y) {
      for (std::size_t x = of.x0; x <= of.x1; ++x) visit(y * cells_ + x);
    }
  }

  const Body& body_;
  glm::dvec3 along_, u_, v_;
  std::size_t cells_;  // along u and along v
  glm::dvec2 low_, size_;
  std::vector<std::size_t> begin_;  // of each cell's part of listed_, and its end
  std::vector<std::uint32_t> listed_;
};

namespace {

// How far it is from a point in the box to where it is left.
double way_out_m(const BoundingBox& box, const glm::dvec3& point, const glm::dvec3& direction) {
  double way_m = std::numeric_limits<double>::infinity();
  for (const glm::length_t axis : {0, 1, 2}) {
    const double side = direction[axis] > 0.0 ? box.upper[axis] : box.lower[axis];
    way_m = std::min(way_m, (side - point[axis]) / direction[axis]);
  }
  return std::max(0.0, way_m);
}

}  // namespace

class HollowShells::Shell {
 public:
  Shell(const Space& space, const Body& body)
      : space_(space), body_(body), box_(bounding_box(body.vertex_m)) {}

  const Body& body() const { return body_; }
  const BoundingBox& box() const { return box_; }

  // Directions that are open, of a point in the box; no more are counted than one above `most`.
  int open_directions(const glm::dvec3& point, int most, const IsAir& is_air) const {
    int open = 0;
    for (std::size_t k = 0; k < kLines.size() && open <= most; ++k) {
      const LineView& view = line(k);
      const LineView::Met met = view.meets(point);
      for (const bool is_ahead : {true, false}) {
        if (is_ahead ? met.ahead : met.behind) continue;
        const glm::dvec3 direction = is_ahead ? view.along() : -view.along();
        const double behind_m = way_out_m(box_, point, direction) + kBehind_m;
        if (is_air(point + behind_m * direction)) ++open;
      }
    }
    return open;
  }

  bool holds_luminaire(const IsAir& is_air) const {
    std::call_once(looked_for_lamps_, [&] {
      holds_lamp_ = std::any_of(
          space_.luminaires.begin(), space_.luminaires.end(), [&](const Luminaire& luminaire) {
            const glm::dvec3 axis = -luminaire.world_from_luminaire[2];
            return std::any_of(kBeforeLamp_m.begin(), kBeforeLamp_m.end(), [&](double way_m) {
              const glm::dvec3 before = luminaire.position_m + way_m * axis;
              return box_.contains(before) &&
                     open_directions(before, kMostOfLamp, is_air) <= kMostOfLamp;
            });
          });
    });
    return holds_lamp_;
  }

 private:
  const LineView& line(std::size_t k) const {
    std::call_once(is_made_[k], [&] { lines_[k].emplace(body_, kLines[k]); });
    return *lines_[k];
  }

  const Space& space_;
  const Body& body_;
  BoundingBox box_;
  mutable std::array<std::once_flag, kLines.size()> is_made_;
  mutable std::array<std::optional<LineView>, kLines.size()> lines_;
  mutable std::once_flag looked_for_lamps_;
  mutable bool holds_lamp_ = false;
};

HollowShells::HollowShells(const Space& space, const BoundingBox& region) {
  for (const Body& body : space.open_shells) {
    auto shell = std::make_shared<const Shell>(space, body);
    const bool is_near = glm::all(glm::lessThanEqual(shell->box().lower, region.upper)) &&
                         glm::all(glm::lessThanEqual(region.lower, shell->box().upper));
    if (is_near) shells_.push_back(std::move(shell));
  }
}

HollowPlace HollowShells::around(const glm::dvec3& point, const IsAir& is_air) const {
  HollowPlace place;
  for (const auto& shell : shells_) {
    if (!shell->box().contains(point)) continue;
    const int open = shell->open_directions(point, kMostUnclear, is_air);
    if (open > kMostUnclear || shell->holds_luminaire(is_air)) continue;
    if (open == 0) return {HollowSide::inside, &shell->body()};
    place = {HollowSide::unclear, &shell->body()};
  }
  return place;
}

}  // namespace calc
