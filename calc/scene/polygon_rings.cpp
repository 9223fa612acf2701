#include "calc/scene/polygon_rings.h"

#include "calc/scene/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace calc {
namespace {

using RingCorners = std::vector<glm::dvec2>;
using Ring = std::vector<std::uint32_t>;
using Side = std::pair<std::uint32_t, std::uint32_t>;

double turn_of(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Distance of p from the line through a and b, > 0 on its left.
double left_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return turn_of(b - a, p - a) / glm::length(b - a);
}

RingCorners corners_of(const RingCorners& corner, const Ring& ring) {
  RingCorners points;
  for (const std::uint32_t c : ring) points.push_back(corner[c]);
  return points;
}

// Each corner's number: that of the first one at its place.
Ring places_of(const RingCorners& corner, double gap) {
  Ring place(corner.size());
  for (std::uint32_t i = 0; i < corner.size(); ++i) {
    place[i] = i;
    for (std::uint32_t j = 0; j < i && place[i] == i; ++j) {
      if (place[j] == j && glm::length(corner[i] - corner[j]) <= gap) place[i] = j;
    }
  }
  return place;
}

class RingSplitter {
 public:
  explicit RingSplitter(const RingCorners& corner)
      : corner_(corner),
        gap_(polygon_gap(corner)),
        direction_(signed_area(corner) < 0.0 ? -1.0 : 1.0),
        place_(places_of(corner, gap_)) {}

  std::optional<RingSet> run() {
    collect_sides();
    if (!cancel_sides() || sides_cross() || !trace()) return std::nullopt;
    if (set_.ring.empty() || !is_nested()) return std::nullopt;
    std::stable_partition(set_.ring.begin(), set_.ring.end(), [&](const Ring& ring) {
      return signed_area(corners_of(corner_, ring)) * direction_ > 0.0;
    });
    return std::move(set_);
  }

 private:
  // Sides, divided where other corners lie on them.
  void collect_sides() {
    const std::size_t n = corner_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t from = place_[i], to = place_[(i + 1) % n];
      if (from == to) continue;
      const glm::dvec2 a = corner_[from], along = corner_[to] - a;
      std::vector<std::pair<double, std::uint32_t>> stops{{0.0, from}, {1.0, to}};
      for (std::uint32_t k = 0; k < n; ++k) {
        if (place_[k] != k || k == from || k == to) continue;
        const double t = glm::dot(corner_[k] - a, along) / glm::dot(along, along);
        if (t > 0.0 && t < 1.0 && glm::length(corner_[k] - a - t * along) <= gap_) {
          stops.emplace_back(t, k);
        }
      }
      std::sort(stops.begin(), stops.end());
      for (std::size_t k = 1; k < stops.size(); ++k) {
        sides_.emplace_back(stops[k - 1].second, stops[k].second);
      }
    }
  }

  // False if a side is there twice the same way.
  bool cancel_sides() {
    std::map<Side, int> count;
    for (const Side& side : sides_) ++count[side];
    sides_.clear();
    for (const auto& [side, times] : count) {
      const auto back = count.find({side.second, side.first});
      const int left = times - (back == count.end() ? 0 : back->second);
      if (left > 1) return false;
      if (left == 1) sides_.push_back(side);
      if (back == count.end()) continue;
      const double length = glm::length(corner_[side.first] - corner_[side.second]);
      if (length <= set_.longest) continue;
      set_.longest = length;
      set_.longest_at = side.first;
    }
    return true;
  }

  // Sides meet at common corners only.
  bool sides_cross() const {
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto& [a, b] = sides_[i];
        const auto& [c, d] = sides_[j];
        if (a == c || a == d || b == c || b == d) continue;
        const glm::dvec2 &p = corner_[a], &q = corner_[b], &r = corner_[c], &s = corner_[d];
        if ((left_of(p, q, r) > 0.0) != (left_of(p, q, s) > 0.0) &&
            (left_of(r, s, p) > 0.0) != (left_of(r, s, q) > 0.0)) {
          return true;
        }
      }
    }
    return false;
  }

  // Follows sides to rings; a corner that comes again closes one.
  bool trace() {
    std::multimap<std::uint32_t, std::uint32_t> onward(sides_.begin(), sides_.end());
    while (!onward.empty()) {
      Ring path{onward.begin()->first};
      std::map<std::uint32_t, std::size_t> place_on_path{{path[0], 0}};
      do {
        const auto next = innermost(onward, path);
        if (next == onward.end()) return false;
        const std::uint32_t to = next->second;
        onward.erase(next);
        const auto before = place_on_path.find(to);
        if (before == place_on_path.end()) {
          place_on_path.emplace(to, path.size());
          path.push_back(to);
          continue;
        }
        const auto begin = path.begin() + static_cast<std::ptrdiff_t>(before->second);
        add_ring(Ring(begin, path.end()));
        for (auto k = begin + 1; k != path.end(); ++k) place_on_path.erase(*k);
        path.erase(begin + 1, path.end());
      } while (path.size() > 1);
    }
    return true;
  }

  // Where the way goes on from the path's end, as far to the inside as it can, so that it keeps
  // round what it encloses.
  std::multimap<std::uint32_t, std::uint32_t>::iterator innermost(
      std::multimap<std::uint32_t, std::uint32_t>& onward, const Ring& path) const {
    const auto [begin, end] = onward.equal_range(path.back());
    if (begin == end) return onward.end();
    if (path.size() < 2) return begin;
    const glm::dvec2 at = corner_[path.back()], along = at - corner_[path[path.size() - 2]];
    auto best = begin;
    double best_angle = -std::numeric_limits<double>::infinity();
    for (auto k = begin; k != end; ++k) {
      const glm::dvec2 way = corner_[k->second] - at;
      const double length = glm::length(way) * glm::length(along);
      const double sine = turn_of(along, way) / length, cosine = glm::dot(along, way) / length;
      // Grows with the angle from -180 to 180 degrees.
      const double angle = direction_ * (sine >= 0.0 ? 1.0 - cosine : cosine - 1.0);
      if (angle > best_angle) best = k;
      best_angle = std::max(best_angle, angle);
    }
    return best;
  }

  void add_ring(Ring ring) {
    if (ring.size() >= 3) set_.ring.push_back(std::move(ring));
  }

  // Parts lie in no other part, holes in one, rings of the outline's own direction are parts.
  bool is_nested() {
    std::vector<RingCorners> outline;
    for (const Ring& ring : set_.ring) outline.push_back(corners_of(corner_, ring));
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const bool is_hole = signed_area(outline[i]) * direction_ < 0.0;
      int around = 0;
      for (std::size_t j = 0; j < outline.size(); ++j) {
        if (j == i || !contains_point(outline[j], 0.5 * (outline[i][0] + outline[i][1]))) continue;
        around += signed_area(outline[j]) * direction_ < 0.0 ? -1 : 1;
      }
      if (around != (is_hole ? 1 : 0)) return false;
    }
    return true;
  }

  const RingCorners& corner_;
  double gap_;
  double direction_;  // 1: counter-clockwise
  Ring place_;
  std::vector<Side> sides_;
  RingSet set_;
};

// Ear clipping of a ring that may come to one place several times, counter-clockwise.
class RingClipper {
 public:
  RingClipper(const RingCorners& corner, const Ring& ring, double gap)
      : corner_(corner), ring_(ring), gap_(gap) {}

  bool run(std::vector<glm::uvec3>& triangles) {
    while (ring_.size() > 3) {
      std::optional<std::size_t> ear = find_ear(gap_);
      if (!ear) ear = find_ear(0.0);
      if (!ear) return false;
      triangles.push_back(triangle_at(*ear));
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(*ear));
      start_ = *ear % ring_.size();
    }
    if (ring_.size() < 3) return false;
    triangles.push_back(triangle_at(1));
    return left_of(corner_[ring_[0]], corner_[ring_[1]], corner_[ring_[2]]) > 0.0;
  }

 private:
  glm::uvec3 triangle_at(std::size_t i) const {
    const std::size_t n = ring_.size();
    return {ring_[(i + n - 1) % n], ring_[i], ring_[(i + 1) % n]};
  }

  std::optional<std::size_t> find_ear(double gap) const {
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const std::size_t i = (start_ + k) % ring_.size();
      if (is_ear(triangle_at(i), gap)) return i;
    }
    return std::nullopt;
  }

  bool is_ear(const glm::uvec3& t, double gap) const {
    if (t.x == t.z) return false;
    const glm::dvec2 &a = corner_[t.x], &b = corner_[t.y], &c = corner_[t.z];
    if (!(left_of(a, b, c) > gap) || !(left_of(b, c, a) > gap) || !(left_of(c, a, b) > gap)) {
      return false;
    }
    // The same corner again, at the other end of a joint, does not lie in the way.
    return std::none_of(ring_.begin(), ring_.end(), [&](std::uint32_t k) {
      const glm::dvec2& p = corner_[k];
      return k != t.x && k != t.y && k != t.z && left_of(a, b, p) >= -gap &&
             left_of(b, c, p) >= -gap && left_of(c, a, p) >= -gap;
    });
  }

  const RingCorners& corner_;
  Ring ring_;
  double gap_;
  std::size_t start_ = 0;
};

// A part with its holes as one ring.
class HoleJoiner {
 public:
  HoleJoiner(const RingCorners& corner, Ring part, std::vector<Ring> holes, double gap)
      : corner_(corner), ring_(std::move(part)), holes_(std::move(holes)), gap_(gap) {}

  std::optional<Ring> run() {
    while (!holes_.empty()) {
      if (!join_shared() && !join_nearest()) return std::nullopt;
    }
    return std::move(ring_);
  }

 private:
  // A hole that touches needs no way.
  bool join_shared() {
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      for (std::size_t i = 0; i < ring_.size(); ++i) {
        for (std::size_t k = 0; k < holes_[h].size(); ++k) {
          if (ring_[i] != holes_[h][k]) continue;
          splice(i, h, k, false);
          return true;
        }
      }
    }
    return false;
  }

  // By the shortest way between two corners that nothing stands in.
  bool join_nearest() {
    struct Way {
      double length;
      std::size_t at, hole, corner;
      bool operator<(const Way& other) const { return length < other.length; }
    };
    std::vector<Way> ways;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      for (std::size_t k = 0; k < holes_[0].size(); ++k) {
        ways.push_back({glm::length(corner_[ring_[i]] - corner_[holes_[0][k]]), i, 0, k});
      }
    }
    std::sort(ways.begin(), ways.end());
    for (const Way& way : ways) {
      if (!is_free(ring_[way.at], holes_[way.hole][way.corner]) ||
          !opens_inwards(way.at, corner_[holes_[way.hole][way.corner]]))
        continue;
      splice(way.at, way.hole, way.corner, true);
      return true;
    }
    return false;
  }

  // Of the places of a corner that comes several times, the one whose inside the way leaves into.
  bool opens_inwards(std::size_t at, const glm::dvec2& to) const {
    const std::size_t n = ring_.size();
    const glm::dvec2 &a = corner_[ring_[(at + n - 1) % n]], &b = corner_[ring_[at]],
                     &c = corner_[ring_[(at + 1) % n]];
    const bool after = left_of(b, c, to) > 0.0, before = left_of(a, b, to) > 0.0;
    return left_of(a, b, c) > 0.0 ? after && before : after || before;
  }

  bool is_free(std::uint32_t from, std::uint32_t to) const {
    const auto blocks = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (meets(from, to, ring[i], ring[(i + 1) % ring.size()])) return true;
      }
      return false;
    };
    return !blocks(ring_) && std::none_of(holes_.begin(), holes_.end(), blocks);
  }

  bool meets(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const glm::dvec2 &p = corner_[a], &q = corner_[b];
    for (const std::uint32_t k : {c, d}) {
      if (k == a || k == b) continue;
      const double t = glm::dot(corner_[k] - p, q - p) / glm::dot(q - p, q - p);
      if (t > 0.0 && t < 1.0 && std::abs(left_of(p, q, corner_[k])) <= gap_) return true;
    }
    if (a == c || a == d || b == c || b == d) return false;
    const glm::dvec2 &r = corner_[c], &s = corner_[d];
    return (left_of(p, q, r) > 0.0) != (left_of(p, q, s) > 0.0) &&
           (left_of(r, s, p) > 0.0) != (left_of(r, s, q) > 0.0);
  }

  // Into the ring after its corner i the hole from its corner k round to it.
  void splice(std::size_t i, std::size_t h, std::size_t k, bool by_a_way) {
    Ring& hole = holes_[h];
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(k), hole.end());
    Ring way = hole;
    way.push_back(hole[0]);
    if (by_a_way) {
      way.push_back(ring_[i]);
    } else {
      way.erase(way.begin());
    }
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(i) + 1, way.begin(), way.end());
    holes_.erase(holes_.begin() + static_cast<std::ptrdiff_t>(h));
  }

  const RingCorners& corner_;
  Ring ring_;
  std::vector<Ring> holes_;
  double gap_;
};

}  // namespace

std::optional<RingSet> split_into_rings(const std::vector<glm::dvec2>& outline) {
  if (outline.size() < 3) return std::nullopt;
  return RingSplitter(outline).run();
}

std::optional<std::vector<glm::uvec3>> triangulate_rings(
    const std::vector<glm::dvec2>& corner, const std::vector<std::vector<std::uint32_t>>& ring) {
  const double gap = polygon_gap(corner);
  double area = 0.0;
  for (const Ring& r : ring) area += signed_area(corners_of(corner, r));
  const bool is_clockwise = area < 0.0;
  std::vector<Ring> parts, holes;
  for (Ring r : ring) {
    const bool is_part = (signed_area(corners_of(corner, r)) < 0.0) == is_clockwise;
    if (is_clockwise) std::reverse(r.begin(), r.end());
    (is_part ? parts : holes).push_back(std::move(r));
  }
  std::vector<glm::uvec3> triangles;
  for (Ring& part : parts) {
    const RingCorners outline = corners_of(corner, part);
    std::vector<Ring> inside;
    std::erase_if(holes, [&](const Ring& hole) {
      const bool is_inside = contains_point(outline, 0.5 * (corner[hole[0]] + corner[hole[1]]));
      if (is_inside) inside.push_back(hole);
      return is_inside;
    });
    const std::optional<Ring> whole =
        HoleJoiner(corner, std::move(part), std::move(inside), gap).run();
    if (!whole || !RingClipper(corner, *whole, gap).run(triangles)) return std::nullopt;
  }
  if (!holes.empty()) return std::nullopt;
  double sum = 0.0;
  for (glm::uvec3& t : triangles) {
    sum += signed_area({corner[t.x], corner[t.y], corner[t.z]});
    if (is_clockwise) std::swap(t.x, t.z);
  }
  if (std::abs(sum - std::abs(area)) > kPolygonTolerance * std::abs(area)) return std::nullopt;
  return triangles;
}

}  // namespace calc
