#include "calc/meshes/mesh_shells.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_mend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace calc {
namespace {

constexpr double kOneLevel_m = 1.0e-3;
constexpr double kOtherFloors = 0.05;  // of the floor's area

// One side of a triangle; `forward` if the triangle runs along it from `a` to `b`.
struct TriangleEdge {
  std::uint32_t a, b, triangle;
  bool forward;
};

bool same_place(const TriangleEdge& one, const TriangleEdge& other) {
  return one.a == other.a && one.b == other.b;
}

// Sorted by their ends, then by triangle.
std::vector<TriangleEdge> edges_of(const std::vector<std::uint32_t>& welded,
                                   const std::vector<glm::uvec3>& triangle) {
  std::vector<TriangleEdge> edges;
  edges.reserve(3 * triangle.size());
  for (std::size_t t = 0; t < triangle.size(); ++t) {
    const std::array corner{welded[triangle[t].x], welded[triangle[t].y], welded[triangle[t].z]};
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corner[i], to = corner[(i + 1) % 3];
      edges.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(t), from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const TriangleEdge& one, const TriangleEdge& other) {
    return std::array{one.a, one.b, one.triangle} < std::array{other.a, other.b, other.triangle};
  });
  return edges;
}

// Calls visit(first, count) for the triangles at each edge.
template <class Visit>
void for_each_edge(const std::vector<TriangleEdge>& sorted, Visit visit) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    while (end < sorted.size() && same_place(sorted[end], sorted[begin])) ++end;
    visit(sorted.data() + begin, end - begin);
    begin = end;
  }
}

// Triangles that are known to hang together.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t k) {
    i = find(i);
    k = find(k);
    parent_[std::max(i, k)] = std::min(i, k);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Turns the triangles of each patch (joined by edges of two triangles) the same way round.
class Turns {
 public:
  Turns(std::size_t triangles, const std::vector<TriangleEdge>& edges)
      : neighbours_(triangles), flipped_(triangles), patch_(triangles, kNone) {
    for_each_edge(edges, [&](const TriangleEdge* edge, std::size_t count) {
      if (count != 2) return;
      const bool against = edge[0].forward == edge[1].forward;
      neighbours_[edge[0].triangle].push_back({edge[1].triangle, against});
      neighbours_[edge[1].triangle].push_back({edge[0].triangle, against});
    });
  }

  // False if the shell is of several patches or has one side only.
  bool settle(const std::vector<std::uint32_t>& shell) {
    std::vector<std::uint32_t> open{shell.front()};
    const std::uint32_t patch = shell.front();
    patch_[patch] = patch;
    std::size_t seen = 1;
    bool is_good = true;
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (const Neighbour& next : neighbours_[at]) {
        const bool flipped = flipped_[at] != next.against;
        if (patch_[next.triangle] == kNone) {
          patch_[next.triangle] = patch;
          flipped_[next.triangle] = flipped;
          open.push_back(next.triangle);
          ++seen;
        } else if (flipped_[next.triangle] != flipped) {
          is_good = false;
        }
      }
    }
    return is_good && seen == shell.size();
  }
  bool is_flipped(std::uint32_t triangle) const { return flipped_[triangle]; }

 private:
  struct Neighbour {
    std::uint32_t triangle;
    bool against;
  };
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<bool> flipped_;
  std::vector<std::uint32_t> patch_;
};

void measure(const std::vector<glm::dvec3>& vertex, const std::vector<glm::uvec3>& triangle,
             const Turns& turns, MeshShell& shell) {
  const glm::dvec3 centre = shell.bounds.centre();
  double volume = 0.0;
  std::size_t flipped = 0;
  for (const std::uint32_t t : shell.triangle) {
    const glm::dvec3 a = vertex[triangle[t].x] - centre, b = vertex[triangle[t].y] - centre,
                     c = vertex[triangle[t].z] - centre;
    const bool is_flipped = turns.is_flipped(t);
    volume += (is_flipped ? -1.0 : 1.0) * glm::dot(a, glm::cross(b, c)) / 6.0;
    if (is_flipped) ++flipped;
  }
  if (volume == 0.0) return;
  shell.volume = std::abs(volume);
  shell.outward = volume > 0.0 ? shell.triangle.size() - flipped : flipped;
  shell.faces = shell.outward == 0                       ? FacesLook::inward
                : shell.outward == shell.triangle.size() ? FacesLook::outward
                                                         : FacesLook::mixed;
}

// Where shells touch along an edge, each of them has an even number of triangles there.
void unite_at_crowded_edges(const std::vector<TriangleEdge>& edges, Groups& groups) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // groups to be united
  for_each_edge(edges, [&](const TriangleEdge* edge, std::size_t count) {
    if (count <= 2) return;
    std::map<std::uint32_t, std::size_t> triangles_of;
    for (std::size_t i = 0; i < count; ++i) ++triangles_of[groups.find(edge[i].triangle)];
    std::optional<std::uint32_t> first;
    for (const auto& [group, triangles] : triangles_of) {
      if (triangles % 2 == 0) continue;
      if (first) pairs.emplace_back(*first, group);
      if (!first) first = group;
    }
  });
  for (const auto& [one, other] : pairs) groups.unite(one, other);
}

bool meets(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& corner,
           const glm::dvec3& u, const glm::dvec3& v) {
  const glm::dvec3 across = glm::cross(direction, v);
  const double scale = glm::dot(u, across);
  if (scale == 0.0) return false;
  const glm::dvec3 offset = from - corner;
  const double a = glm::dot(offset, across) / scale;
  if (!(a >= 0.0 && a <= 1.0)) return false;
  const glm::dvec3 turned = glm::cross(offset, u);
  const double b = glm::dot(direction, turned) / scale;
  return b >= 0.0 && a + b <= 1.0 && glm::dot(v, turned) / scale > 0.0;
}

// Outline of the triangles' union: sides that only one of them has, in order. Empty if that is not
// one ring.
std::vector<std::uint32_t> rim_of(const std::vector<std::uint32_t>& welded,
                                  const std::vector<glm::uvec3>& triangle) {
  std::map<std::uint32_t, std::array<std::uint32_t, 2>> beside;
  std::map<std::uint32_t, std::size_t> sides;
  bool is_simple = true;
  for_each_edge(edges_of(welded, triangle), [&](const TriangleEdge* edge, std::size_t count) {
    if (count > 2) is_simple = false;
    if (count != 1) return;
    for (const auto& [end, other] : {std::pair(edge->a, edge->b), std::pair(edge->b, edge->a)}) {
      const std::size_t n = sides[end]++;
      if (n < 2) beside[end][n] = other;
    }
  });
  for (const auto& [end, count] : sides) is_simple = is_simple && count == 2;
  if (!is_simple || sides.empty()) return {};
  std::vector<std::uint32_t> ring{sides.begin()->first};
  std::uint32_t before = ring[0], at = beside[ring[0]][0];
  while (at != ring[0]) {
    ring.push_back(at);
    const std::array<std::uint32_t, 2> next = beside[at];
    const std::uint32_t onwards = next[0] == before ? next[1] : next[0];
    before = at;
    at = onwards;
  }
  return ring.size() == sides.size() ? ring : std::vector<std::uint32_t>();
}

// Without corners in the middle of a straight side.
std::vector<glm::dvec2> without_straight_corners(const std::vector<glm::dvec2>& ring) {
  const double gap = polygon_gap(ring);
  std::vector<glm::dvec2> corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 from = ring[(i + ring.size() - 1) % ring.size()],
                     to = ring[(i + 1) % ring.size()];
    const glm::dvec2 along = to - from, offset = ring[i] - from;
    const double across = std::abs(along.x * offset.y - along.y * offset.x);
    if (across > gap * glm::length(along) || glm::dot(along, offset) < 0.0 ||
        glm::dot(along, offset) > glm::dot(along, along)) {
      corners.push_back(ring[i]);
    }
  }
  return corners;
}

double level_area(const std::vector<glm::dvec3>& vertex, const glm::uvec3& t) {
  return 0.5 * std::abs(glm::cross(vertex[t.y] - vertex[t.x], vertex[t.z] - vertex[t.x]).z);
}

}  // namespace

std::vector<MeshShell> find_shells(const std::vector<glm::dvec3>& vertex,
                                   const std::vector<glm::uvec3>& triangle) {
  const std::vector<TriangleEdge> edges = edges_of(weld_vertices(vertex), triangle);
  Groups groups(triangle.size());
  for_each_edge(edges, [&](const TriangleEdge* edge, std::size_t count) {
    if (count == 2) groups.unite(edge[0].triangle, edge[1].triangle);
  });
  unite_at_crowded_edges(edges, groups);
  std::vector<bool> has_edges(triangle.size());
  for (const TriangleEdge& edge : edges) has_edges[edge.triangle] = true;
  std::vector<MeshShell> shells;
  std::map<std::uint32_t, std::size_t> shell_of;
  for (std::uint32_t t = 0; t < triangle.size(); ++t) {
    if (!has_edges[t]) continue;
    const auto [entry, is_new] = shell_of.try_emplace(groups.find(t), shells.size());
    if (is_new) shells.emplace_back().is_closed = true;
    MeshShell& shell = shells[entry->second];
    shell.triangle.push_back(t);
    for (int i = 0; i < 3; ++i) shell.bounds.add(vertex[triangle[t][i]]);
  }
  for_each_edge(edges, [&](const TriangleEdge* edge, std::size_t count) {
    std::map<std::size_t, std::size_t> triangles_of;
    for (std::size_t i = 0; i < count; ++i) {
      ++triangles_of[shell_of.at(groups.find(edge[i].triangle))];
    }
    for (const auto& [shell, triangles] : triangles_of) {
      if (triangles % 2 != 0) shells[shell].is_closed = false;
    }
  });
  Turns turns(triangle.size(), edges);
  for (MeshShell& shell : shells) {
    if (shell.is_closed && turns.settle(shell.triangle)) measure(vertex, triangle, turns, shell);
  }
  return shells;
}

OpenEdges open_edges(const std::vector<glm::dvec3>& vertex,
                     const std::vector<glm::uvec3>& triangle) {
  OpenEdges open;
  for_each_edge(edges_of(weld_vertices(vertex), triangle),
                [&](const TriangleEdge* edge, std::size_t count) {
                  if (count % 2 == 0) return;
                  const double length = glm::length(vertex[edge->b] - vertex[edge->a]);
                  ++open.count;
                  open.length += length;
                  if (length <= open.longest) return;
                  open.longest = length;
                  open.at = vertex[edge->a];
                });
  return open;
}

bool encloses_something(const std::vector<glm::dvec3>& vertex,
                        const std::vector<glm::uvec3>& triangle) {
  constexpr int kDirections = 26, kEnough = 18;
  constexpr double kGoldenRatio = 1.6180339887498949;
  BoundingBox box;
  for (const glm::uvec3& t : triangle) {
    for (int i = 0; i < 3; ++i) box.add(vertex[t[i]]);
  }
  if (box.is_empty()) return false;
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
    const double turn = 0.3 + i * 2.0 * kPi / kGoldenRatio, wide = std::sqrt(1.0 - z * z);
    directions.emplace_back(wide * calc::cos(turn), wide * calc::sin(turn), z);
  }
  const auto is_enclosed = [&](const glm::dvec3& from) {
    int met = 0;
    for (int i = 0; i < kDirections && met < kEnough && met + kDirections - i >= kEnough; ++i) {
      met += std::any_of(triangle.begin(), triangle.end(), [&](const glm::uvec3& t) {
        const glm::dvec3 a = vertex[t.x];
        return meets(from, directions[static_cast<std::size_t>(i)], a, vertex[t.y] - a,
                     vertex[t.z] - a);
      });
    }
    return met >= kEnough;
  };
  // The middle first; no place has a round share of the box, so that rays seldom meet edges.
  const std::array<double, 3> shares{0.4907, 0.2103, 0.7811};
  const glm::dvec3 size = box.upper - box.lower;
  for (const double z : shares) {
    for (const double y : shares) {
      for (const double x : shares) {
        if (is_enclosed(box.lower + glm::dvec3(x, y, z) * size)) return true;
      }
    }
  }
  return false;
}

MeshFloor find_floor(const std::vector<glm::dvec3>& vertex_m,
                     const std::vector<glm::uvec3>& triangle) {
  MeshFloor floor;
  BoundingBox box;
  for (const glm::uvec3& t : triangle) {
    for (int i = 0; i < 3; ++i) box.add(vertex_m[t[i]]);
  }
  if (box.is_empty()) return floor;
  floor.z = box.lower.z;
  floor.height = box.upper.z - box.lower.z;
  std::vector<glm::uvec3> lowest;
  double all_m2 = 0.0, floor_m2 = 0.0;
  for (const glm::uvec3& t : triangle) {
    const double area_m2 = level_area(vertex_m, t);
    all_m2 += area_m2;
    const double highest = std::max({vertex_m[t.x].z, vertex_m[t.y].z, vertex_m[t.z].z});
    // What stands upright on the floor is none of it.
    if (highest > floor.z + kOneLevel_m || area_m2 == 0.0) continue;
    lowest.push_back(t);
    floor_m2 += area_m2;
  }
  // Seen from above, as much of a closed shell looks up as looks down.
  floor.above = std::max(0.0, 0.5 * all_m2 - floor_m2);
  if (floor.above > kOtherFloors * floor_m2) return floor;
  std::vector<glm::dvec2> corners;
  for (const std::uint32_t corner : rim_of(weld_vertices(vertex_m), lowest)) {
    corners.emplace_back(vertex_m[corner]);
  }
  if (corners.size() < 3) return floor;
  corners = without_straight_corners(corners);
  if (signed_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  // The triangles may lie on each other.
  const bool is_whole = std::abs(signed_area(corners) - floor_m2) <= 1.0e-6 * floor_m2;
  if (is_whole && is_simple_polygon(corners)) floor.outline = std::move(corners);
  return floor;
}

}  // namespace calc
