#include "report/build/surface_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace report {
namespace {

constexpr double kBend = 0.9;       // cosine; a ball of a few hundred faces bends less
constexpr double kStraight = 1e-6;  // sine of the angle in which a run goes on

using Place = std::array<double, 3>;

Place place_of(const glm::dvec3& p) {
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0 is 0
}

// A side of a triangle, by numbers of places; from < to.
struct Side {
  std::uint32_t from, to, triangle;
};

class Surfaces {
 public:
  explicit Surfaces(const std::vector<calc::Body>& bodies) {
    for (const calc::Body& body : bodies) {
      if (!body.housing_of.empty()) continue;
      for (const glm::dvec3& vertex : body.vertex_m) places_.push_back(place_of(vertex));
    }
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    for (const calc::Body& body : bodies) {
      if (body.housing_of.empty()) add(body);
    }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return std::tie(a.from, a.to, a.triangle) < std::tie(b.from, b.to, b.triangle);
    });
  }

  // Pairs of numbers, in order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> borders() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::size_t i = 0, end = 0; i < sides_.size(); i = end) {
      std::size_t first = i;  // of them by its normal, whatever the order of triangles
      for (end = i + 1; end < sides_.size() && sides_[end].from == sides_[i].from &&
                        sides_[end].to == sides_[i].to;
           ++end) {
        if (is_before(normal_of(end), normal_of(first))) first = end;
      }
      bool bends = false;
      for (std::size_t k = i; k < end && !bends; ++k) {  // faces may look to either side
        bends = std::abs(glm::dot(normal_of(first), normal_of(k))) < kBend;
      }
      if (end == i + 1 || bends) found.emplace_back(sides_[i].from, sides_[i].to);
    }
    return found;
  }

  glm::dvec3 at(std::uint32_t number) const {
    const Place& place = places_[number];
    return {place[0], place[1], place[2]};
  }
  std::size_t places() const { return places_.size(); }

 private:
  std::uint32_t number_of(const glm::dvec3& vertex) const {
    const auto found = std::lower_bound(places_.begin(), places_.end(), place_of(vertex));
    return static_cast<std::uint32_t>(found - places_.begin());
  }

  void add(const calc::Body& body) {
    std::vector<std::uint32_t> number;
    number.reserve(body.vertex_m.size());
    for (const glm::dvec3& vertex : body.vertex_m) number.push_back(number_of(vertex));
    for (const glm::uvec3& t : body.triangle) {
      const glm::dvec3 a = body.vertex_m[t.x];
      const glm::dvec3 normal = glm::cross(body.vertex_m[t.y] - a, body.vertex_m[t.z] - a);
      const double length = glm::length(normal);
      if (!(length > 0.0)) continue;
      const auto triangle = static_cast<std::uint32_t>(normals_.size());
      normals_.push_back(normal / length);
      for (const auto& [from, to] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
        sides_.push_back(
            {std::min(number[from], number[to]), std::max(number[from], number[to]), triangle});
    }
  }

  const glm::dvec3& normal_of(std::size_t side) const { return normals_[sides_[side].triangle]; }
  static bool is_before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }

  std::vector<Place> places_;
  std::vector<glm::dvec3> normals_;  // of triangles, unit
  std::vector<Side> sides_;
};

}  // namespace

std::vector<SurfaceLine> surface_lines(const std::vector<calc::Body>& bodies) {
  const Surfaces surfaces(bodies);
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> borders = surfaces.borders();
  // Of each place the first two borders there, and how many there are.
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::array<std::uint32_t, 2>> there(surfaces.places(), {kNone, kNone});
  std::vector<std::uint8_t> count(surfaces.places(), 0);
  for (std::uint32_t i = 0; i < borders.size(); ++i) {
    for (const std::uint32_t end : {borders[i].first, borders[i].second}) {
      if (count[end] < 2) there[end][count[end]] = i;
      if (count[end] < 3) ++count[end];
    }
  }
  std::vector<bool> is_taken(borders.size(), false);
  // From the end `at` of a border as far as it goes straight on.
  const auto far_end = [&](std::uint32_t border, std::uint32_t at) {
    const auto other_end = [&](std::uint32_t i, std::uint32_t end) {
      return borders[i].first == end ? borders[i].second : borders[i].first;
    };
    const glm::dvec3 way = glm::normalize(surfaces.at(at) - surfaces.at(other_end(border, at)));
    while (count[at] == 2) {
      const std::uint32_t next = there[at][0] == border ? there[at][1] : there[at][0];
      const std::uint32_t to = other_end(next, at);
      const glm::dvec3 step = surfaces.at(to) - surfaces.at(at);
      const bool goes_on = glm::dot(way, step) > 0.0 &&
                           glm::length(glm::cross(way, step)) <= kStraight * glm::length(step);
      if (is_taken[next] || !goes_on) break;
      is_taken[next] = true;
      border = next;
      at = to;
    }
    return at;
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  for (std::uint32_t i = 0; i < borders.size(); ++i) {
    if (is_taken[i]) continue;
    is_taken[i] = true;
    const std::uint32_t a = far_end(i, borders[i].first), b = far_end(i, borders[i].second);
    runs.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(runs.begin(), runs.end());
  std::vector<SurfaceLine> lines;
  lines.reserve(runs.size());
  for (const auto& [a, b] : runs) lines.push_back({surfaces.at(a), surfaces.at(b)});
  return lines;
}

}  // namespace report
