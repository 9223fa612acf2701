#include "calc/scene/polygon_mend.h"

#include "calc/scene/polygon.h"
#include "calc/scene/polygon_rings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace calc {
namespace {

glm::dvec3 in_space(const glm::dvec3& p) { return p; }
glm::dvec3 in_space(const glm::dvec2& p) { return {p.x, p.y, 0.0}; }

// Takes corners away that enclose nothing with their neighbours, as often as there are any.
template <class Point>
class OutlineStripper {
 public:
  OutlineStripper(const std::vector<Point>& polygon, double gap, Mending& mending)
      : polygon_(polygon), gap_(gap), mending_(mending), is_foot_(polygon.size(), 0) {}

  std::vector<std::uint32_t> run() {
    drop_doubled();
    std::size_t unchanged = 0;
    for (std::size_t i = 0; kept_.size() >= 3 && unchanged < kept_.size();) {
      i %= kept_.size();
      if (strip_tip(i)) {
        unchanged = 0;
        i += kept_.size() - 2;  // what is before it may be a tip now
      } else {
        ++unchanged;
        ++i;
      }
    }
    return std::move(kept_);
  }

 private:
  const Point& at(std::uint32_t corner) const { return polygon_[corner]; }
  bool are_same(std::uint32_t a, std::uint32_t b) const {
    return glm::length(at(a) - at(b)) <= gap_;
  }

  void drop_doubled() {
    for (std::uint32_t i = 0; i < polygon_.size(); ++i) {
      if (kept_.empty() || !are_same(kept_.back(), i)) {
        kept_.push_back(i);
      } else {
        count_doubled(i);
      }
    }
    while (kept_.size() > 1 && are_same(kept_.back(), kept_.front())) {
      count_doubled(kept_.back());
      kept_.pop_back();
    }
  }

  void count_doubled(std::uint32_t corner) {
    if (!mending_.is_any()) mending_.at = in_space(at(corner));
    ++mending_.doubled;
  }

  // At b the outline turns back: one of its neighbours lies on the way to the other.
  bool is_tip(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Point to_a = at(a) - at(b), to_c = at(c) - at(b);
    const bool is_c_far = glm::length(to_a) < glm::length(to_c);
    const Point far = is_c_far ? to_c : to_a, near = is_c_far ? to_a : to_c;
    const double share = glm::dot(near, far) / glm::dot(far, far);
    return share > 0.0 && glm::length(near - share * far) <= gap_;
  }

  bool strip_tip(std::size_t i) {
    const std::size_t n = kept_.size(), next = (i + 1) % n;
    const std::uint32_t a = kept_[(i + n - 1) % n], b = kept_[i], c = kept_[next];
    if (!is_tip(a, b, c)) return false;
    const double length = std::min(glm::length(at(a) - at(b)), glm::length(at(c) - at(b)));
    if (!mending_.is_any() || length > mending_.longest) {
      mending_.longest = length;
      mending_.at = in_space(at(b));
    }
    // At the foot of one that is gone a spike of several sides goes on.
    if (is_foot_[b] == 0) ++mending_.spikes;
    const bool comes_back = are_same(a, c);
    if (comes_back) is_foot_[a] = 1;
    if (comes_back) kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(comes_back ? std::min(i, next) : i));
    return true;
  }

  const std::vector<Point>& polygon_;
  double gap_;
  Mending& mending_;
  std::vector<std::uint32_t> kept_;
  std::vector<std::uint8_t> is_foot_;
};

template <class Point>
std::vector<Point> chosen(const std::vector<Point>& polygon,
                          const std::vector<std::uint32_t>& corner) {
  std::vector<Point> points;
  points.reserve(corner.size());
  for (const std::uint32_t c : corner) points.push_back(polygon[c]);
  return points;
}

// Of an outline without doubled corners and spikes: indices into `outline`.
bool split_into_triangles(const std::vector<glm::dvec2>& outline, MendedPolygon& mended) {
  if (auto triangles = triangulate_polygon(outline)) {
    mended.triangle = std::move(*triangles);
    mended.ring.emplace_back();
    for (std::uint32_t i = 0; i < outline.size(); ++i) mended.ring[0].push_back(i);
    return true;
  }
  std::optional<RingSet> rings = split_into_rings(outline);
  if (!rings) return false;
  std::optional<std::vector<glm::uvec3>> triangles = triangulate_rings(outline, rings->ring);
  if (!triangles) return false;
  mended.triangle = std::move(*triangles);
  mended.ring = std::move(rings->ring);
  mended.mending.joints = std::max<std::size_t>(1, mended.ring.size() - 1);
  const bool had_nothing = mended.mending.doubled + mended.mending.spikes == 0;
  if (rings->longest > mended.mending.longest || had_nothing) {
    mended.mending.longest = rings->longest;
    mended.mending.at = in_space(outline[rings->longest_at]);
  }
  return true;
}

void rename_corners(const std::vector<std::uint32_t>& corner, MendedPolygon& mended) {
  for (std::vector<std::uint32_t>& ring : mended.ring) {
    for (std::uint32_t& c : ring) c = corner[c];
  }
  for (glm::uvec3& t : mended.triangle) t = {corner[t.x], corner[t.y], corner[t.z]};
}

bool all_finite_corners(const std::vector<glm::dvec2>& polygon) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [](const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

double turn_between(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

std::string counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

}  // namespace

void Mending::add(const Mending& other) {
  if (!other.is_any()) return;
  if (!is_any() || other.longest > longest) {
    longest = other.longest;
    at = other.at;
  }
  doubled += other.doubled;
  spikes += other.spikes;
  joints += other.joints;
}

std::string Mending::words() const {
  std::vector<std::string> parts;
  if (doubled > 0) parts.push_back(counted(doubled, "doubled corner", "doubled corners"));
  if (spikes > 0) parts.push_back(counted(spikes, "spike", "spikes"));
  if (joints > 0) {
    parts.push_back(counted(joints, "joined hole or part", "joined holes or parts"));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::optional<MendedPolygon> mend_polygon(const std::vector<glm::dvec2>& polygon) {
  if (polygon.size() < 3 || !all_finite_corners(polygon)) return std::nullopt;
  MendedPolygon mended;
  const std::vector<std::uint32_t> corner =
      OutlineStripper(polygon, polygon_gap(polygon), mended.mending).run();
  if (corner.size() < 3 || !split_into_triangles(chosen(polygon, corner), mended)) {
    return std::nullopt;
  }
  rename_corners(corner, mended);
  return mended;
}

std::optional<MendedPolygon> mend_polygon(const std::vector<glm::dvec3>& polygon) {
  if (polygon.size() < 3 || !std::all_of(polygon.begin(), polygon.end(), [](const glm::dvec3& p) {
        return std::isfinite(p.x + p.y + p.z);
      })) {
    return std::nullopt;
  }
  MendedPolygon mended;
  const std::vector<std::uint32_t> corner =
      OutlineStripper(polygon, polygon_gap(polygon), mended.mending).run();
  const std::vector<glm::dvec3> outline = chosen(polygon, corner);
  const std::optional<FlatPolygon> flat = flatten_polygon(outline);
  if (!flat || !split_into_triangles(flat->corner, mended)) return std::nullopt;
  mended.deviation = flat->deviation;
  if (mended.mending.joints > 0) {
    // Known in the plane so far.
    const auto at =
        std::find_if(flat->corner.begin(), flat->corner.end(),
                     [&](const glm::dvec2& p) { return in_space(p) == mended.mending.at; });
    if (at != flat->corner.end()) {
      mended.mending.at = outline[static_cast<std::size_t>(at - flat->corner.begin())];
    }
  }
  rename_corners(corner, mended);
  return mended;
}

void drop_unused_corners(std::vector<glm::dvec3>& corner, std::vector<glm::uvec3>& triangle) {
  std::vector<std::uint32_t> number(corner.size(), 0);
  for (const glm::uvec3& t : triangle) number[t.x] = number[t.y] = number[t.z] = 1;
  std::uint32_t used = 0;
  for (std::uint32_t i = 0; i < corner.size(); ++i) {
    if (number[i] == 0) continue;
    number[i] = used;
    corner[used++] = corner[i];
  }
  corner.resize(used);
  for (glm::uvec3& t : triangle) t = {number[t.x], number[t.y], number[t.z]};
}

double enclosed_area(const std::vector<glm::dvec2>& polygon) {
  const std::size_t n = polygon.size();
  constexpr std::size_t kMost = 200;  // else without regard to crossings
  if (n < 3) return 0.0;
  if (n > kMost) return std::abs(signed_area(polygon));
  // Between two neighbouring stops no side begins, ends or crosses another.
  std::set<double> stops;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 p = polygon[i], along = polygon[(i + 1) % n] - p;
    stops.insert(p.x);
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec2 q = polygon[j], other = polygon[(j + 1) % n] - q;
      const double sine = turn_between(along, other);
      const double t = turn_between(q - p, other) / sine, s = turn_between(q - p, along) / sine;
      if (t > 0.0 && t < 1.0 && s > 0.0 && s < 1.0) stops.insert(p.x + t * along.x);
    }
  }
  double area = 0.0;
  for (auto left = stops.begin(), right = std::next(left); right != stops.end(); ++left, ++right) {
    const double middle = 0.5 * (*left + *right);
    std::vector<double> heights;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % n];
      if ((a.x < middle) == (b.x < middle)) continue;
      heights.push_back(a.y + (middle - a.x) / (b.x - a.x) * (b.y - a.y));
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t k = 1; k < heights.size(); k += 2) {
      area += (heights[k] - heights[k - 1]) * (*right - *left);
    }
  }
  return area;
}

double enclosed_area(const std::vector<glm::dvec3>& polygon) {
  if (const std::optional<FlatPolygon> flat = flatten_polygon(polygon)) {
    return enclosed_area(flat->corner);
  }
  // The two halves of a bow tie may cancel out: the plane of its widest corners instead.
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const glm::dvec3 across = glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    if (glm::length(across) > glm::length(normal)) normal = across;
  }
  if (!(glm::length(normal) > 0.0)) return 0.0;
  const glm::dvec3 w = glm::normalize(normal), size = glm::abs(w);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                          : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, w)), v = glm::cross(w, u);
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : polygon) flat.emplace_back(glm::dot(p, u), glm::dot(p, v));
  return enclosed_area(flat);
}

}  // namespace calc
