#include "report/tools/geometry/rimless.h"

#include "calc/scene/solids.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace cli {
namespace {

constexpr double kGapShare = 1.0e-5;      // of the model's size
constexpr std::size_t kMostEdges = 4000;  // without an equal: each is held against all others

struct Segment {
  glm::dvec3 begin_m, end_m;
};

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x + p.y + p.z); }

// Edges with an odd number of triangles; edges with an even one cancel out.
std::vector<Segment> odd_edges(const calc::SurfaceModel& model) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  const std::vector<std::uint32_t> welded = calc::weld_vertices(model.vertex_m);
  std::vector<Edge> edges;
  for (const glm::uvec3& t : model.triangle) {
    const std::uint32_t a = welded[t.x], b = welded[t.y], c = welded[t.z];
    edges.insert(edges.end(), {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Segment> odd;
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::upper_bound(begin, edges.end(), *begin);
    if ((end - begin) % 2 == 1 && begin->first != begin->second) {
      odd.push_back({model.vertex_m[begin->first], model.vertex_m[begin->second]});
    }
    begin = end;
  }
  return odd;
}

// Places of edges along one of them, from 0 to its length.
using Span = std::pair<double, double>;

// All edges on the line of this one, itself included, where they lie beside it.
std::vector<Span> spans_along(const Segment& edge, double length_m,
                              const std::vector<Segment>& edges, double gap_m) {
  const glm::dvec3 along = (edge.end_m - edge.begin_m) / length_m;
  std::vector<Span> spans;
  for (const Segment& other : edges) {
    const glm::dvec3 from = other.begin_m - edge.begin_m, to = other.end_m - edge.begin_m;
    const double a = glm::dot(from, along), b = glm::dot(to, along);
    if (std::max(a, b) < gap_m || std::min(a, b) > length_m - gap_m) continue;
    if (glm::length(from - a * along) > gap_m || glm::length(to - b * along) > gap_m) continue;
    spans.push_back(std::minmax(a, b));
  }
  return spans;
}

// Every piece of the line that is no gap lies in an even number of spans.
bool cancel_out(const std::vector<Span>& spans, double length_m, double gap_m) {
  std::vector<double> ends{0.0, length_m};
  for (const Span& span : spans) {
    for (const double end : {span.first, span.second}) {
      if (end > 0.0 && end < length_m) ends.push_back(end);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] - ends[i - 1] <= gap_m) continue;
    const double middle = 0.5 * (ends[i - 1] + ends[i]);
    const auto over = std::count_if(spans.begin(), spans.end(), [&](const Span& span) {
      return span.first < middle && middle < span.second;
    });
    if (over % 2 != 0) return false;
  }
  return true;
}

}  // namespace

bool is_rimless(const calc::SurfaceModel& model) {
  calc::BoundingBox box;
  for (const glm::uvec3& t : model.triangle) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3& corner = model.vertex_m[t[k]];
      if (!is_finite(corner)) return false;
      box.add(corner);
    }
  }
  if (box.is_empty()) return false;
  const double gap_m = kGapShare * glm::length(box.upper - box.lower);
  const std::vector<Segment> edges = odd_edges(model);
  if (edges.size() > kMostEdges) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const Segment& edge) {
    const double length_m = glm::length(edge.end_m - edge.begin_m);
    return length_m <= gap_m ||
           cancel_out(spans_along(edge, length_m, edges, gap_m), length_m, gap_m);
  });
}

}  // namespace cli
