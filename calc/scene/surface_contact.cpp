#include "calc/scene/surface_contact.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>

namespace calc {
namespace {

// All in ray offsets.
constexpr double kTouching = 0.25;  // twice touching_m(): whatever rays take for touching, too
constexpr double kBlind = 1.125;    // a ray does not meet what is nearer to its beginning
constexpr double kStandOff = 1.25;  // clearly more than that
// Of receivers without a back: planes at the same place, across them, begin an offset nearer.
constexpr double kStandOffAllAround = 2.5;
constexpr double kApart = 0.125;   // what is nearer to a surface is on no side of it
constexpr double kAcross = 0.999;  // cosine: such a surface lies across the way to the front

constexpr double kHalfWay = 0.70710678118654752;  // cosine of 45 degrees
constexpr std::size_t kTurns = 32;
constexpr std::array kWays{1.02, 2.0, 6.0};  // in stand-offs

// PlacesAround around a point, and which of them surfaces keep apart.
class PlacesAround {
 public:
  PlacesAround(std::vector<BodyTriangle> near, const glm::dvec3& point_m, const glm::dvec3& front,
               ReceiverKernel kernel, double offset_m)
      : near_(std::move(near)), front_(front), offset_m_(offset_m) {
    // Relative to the point: the places are some micrometres apart.
    for (BodyTriangle& one : near_) {
      Triangle& corner = one.corner_m;
      corner = {corner.a - point_m, corner.b - point_m, corner.c - point_m};
    }
    is_plane_ = kernel == ReceiverKernel::planar;
    stand_off_m_ = offset_m * (is_plane_ ? kStandOff : kStandOffAllAround);
  }

  const Body* touched() const {
    const auto found = std::find_if(near_.rbegin(), near_.rend(), [&](const BodyTriangle& one) {
      return is_touched(one.corner_m);
    });
    return found == near_.rend() ? nullptr : found->body;
  }

  // Everything that is touched lies across the way to the front.
  bool is_all_across() const {
    return std::all_of(near_.begin(), near_.end(), [&](const BodyTriangle& one) {
      const auto& [a, b, c] = one.corner_m;
      return !is_touched(one.corner_m) ||
             std::abs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), front_)) >= kAcross;
    });
  }

  std::vector<SurfaceContact::Side> sides();

 private:
  // Where rays of a receiver at this place begin.
  glm::dvec3 lifted(const glm::dvec3& place_m) const {
    return is_plane_ ? place_m + offset_m_ * front_ : place_m;
  }
  double clear_m(const Triangle& triangle, const glm::dvec3& place_m) const {
    return is_plane_ ? distance_in_front_m(lifted(place_m), front_, 0.0, triangle)
                     : distance_m(place_m, triangle);
  }
  double clear_m(const glm::dvec3& place_m) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (const BodyTriangle& one : near_) {
      least_m = std::min(least_m, clear_m(one.corner_m, place_m));
    }
    return least_m;
  }
  bool is_touched(const Triangle& triangle) const {
    if (distance_m(glm::dvec3(0.0), triangle) > kTouching * offset_m_) return false;
    return !is_plane_ || clear_m(triangle, glm::dvec3(0.0)) < kBlind * offset_m_;
  }
  bool sees(const glm::dvec3& from_m, const glm::dvec3& to_m) const {
    const glm::dvec3 from = lifted(from_m), to = lifted(to_m);
    return std::none_of(near_.begin(), near_.end(),
                        [&](const BodyTriangle& one) { return divides(one.corner_m, from, to); });
  }

  void add_places();
  void connect();
  std::size_t find(std::size_t i) {
    while (joined_[i] != i) i = joined_[i] = joined_[joined_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t k);
  void measure_depths();
  // Rings of kTurns places about the front, at the same distance in a row.
  std::size_t rings() const { return is_plane_ ? 1 : 2; }
  std::size_t of_way() const { return place_m_.size() / kWays.size(); }

  std::vector<BodyTriangle> near_;
  glm::dvec3 front_;
  double offset_m_, stand_off_m_ = 0.0;
  bool is_plane_ = false;
  std::vector<glm::dvec3> place_m_;
  std::vector<double> room_m_;
  std::vector<bool> is_apart_;
  std::vector<std::size_t> joined_;
  std::vector<std::vector<std::size_t>> beside_;  // that each place sees, on the same way
  std::vector<bool> is_border_;                   // something is between it and one beside it
  std::vector<std::size_t> depth_;                // steps from the border of its side
};

void PlacesAround::add_places() {
  const glm::dvec3 aside = std::abs(front_.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(aside - glm::dot(aside, front_) * front_);
  const glm::dvec3 v = glm::cross(front_, u);
  for (const double way : kWays) {
    for (std::size_t ring = 0; ring < rings(); ++ring) {
      const double up = ring == 0 ? 0.0 : kHalfWay;
      const double out = ring == 0 ? 1.0 : kHalfWay;
      for (std::size_t k = 0; k < kTurns; ++k) {
        const double turn = 2.0 * kPi * static_cast<double>(k) / kTurns;
        const glm::dvec3 direction =
            out * (calc::cos(turn) * u + calc::sin(turn) * v) + up * front_;
        place_m_.push_back(way * stand_off_m_ * direction);
      }
    }
    if (!is_plane_) place_m_.push_back(way * stand_off_m_ * front_);
  }
  for (const glm::dvec3& place : place_m_) {
    room_m_.push_back(clear_m(place));
    is_apart_.push_back(room_m_.back() > kApart * offset_m_);
  }
  beside_.resize(place_m_.size());
  is_border_.assign(place_m_.size(), false);
  joined_.resize(place_m_.size());
  std::iota(joined_.begin(), joined_.end(), std::size_t{0});
}

void PlacesAround::join(std::size_t i, std::size_t k) {
  const bool is_same_way = i / of_way() == k / of_way();
  if (!is_apart_[i] || !is_apart_[k] || !sees(place_m_[i], place_m_[k])) {
    if (is_same_way) is_border_[i] = is_border_[k] = true;
    return;
  }
  joined_[find(i)] = find(k);
  if (!is_same_way) return;
  beside_[i].push_back(k);
  beside_[k].push_back(i);
}

// The middle of a side is farthest from its border, also where a surface ends and all places
// behind its end are equally far from it.
void PlacesAround::measure_depths() {
  std::vector<std::size_t> row;
  depth_.assign(place_m_.size(), place_m_.size());
  for (std::size_t i = 0; i < place_m_.size(); ++i) {
    if (!is_border_[i]) continue;
    depth_[i] = 0;
    row.push_back(i);
  }
  for (std::size_t next = 0; next < row.size(); ++next) {
    for (const std::size_t k : beside_[row[next]]) {
      if (depth_[k] <= depth_[row[next]] + 1) continue;
      depth_[k] = depth_[row[next]] + 1;
      row.push_back(k);
    }
  }
}

void PlacesAround::connect() {
  const std::size_t all = place_m_.size();
  for (std::size_t i = 0; i < all; ++i) {
    if (i + of_way() < all) join(i, i + of_way());
    const std::size_t of_ring = i % of_way();
    if (of_ring >= rings() * kTurns) continue;  // the place at the front
    const std::size_t first = i - of_ring % kTurns;
    join(i, first + (of_ring + 1) % kTurns);
    if (is_plane_) continue;
    const bool is_level = of_ring < kTurns;
    join(i, is_level ? i + kTurns : i - of_ring + 2 * kTurns);
  }
}

std::vector<SurfaceContact::Side> PlacesAround::sides() {
  add_places();
  connect();
  measure_depths();
  struct Best {
    std::size_t root, place;
  };
  std::vector<Best> best;  // of each side
  const auto has_room = [&](std::size_t i) { return room_m_[i] >= stand_off_m_; };
  const auto is_better = [&](std::size_t i, std::size_t than) {
    if (has_room(i) != has_room(than)) return has_room(i);
    if (i / of_way() != than / of_way()) return !has_room(than);  // ways come in order
    if (depth_[i] != depth_[than]) return depth_[i] > depth_[than];
    // Not a rounding's worth: places that mirror each other are taken in order.
    return room_m_[i] > room_m_[than] + 1e-6 * offset_m_;
  };
  for (std::size_t i = 0; i < place_m_.size(); ++i) {
    if (!is_apart_[i]) continue;
    const std::size_t root = find(i);
    const auto known =
        std::find_if(best.begin(), best.end(), [&](const Best& one) { return one.root == root; });
    if (known == best.end()) {
      best.push_back({root, i});
    } else if (is_better(i, known->place)) {
      known->place = i;
    }
  }
  std::vector<SurfaceContact::Side> result;
  for (const Best& one : best) result.push_back({place_m_[one.place], has_room(one.place)});
  return result;
}

}  // namespace

SurfaceContact surface_contact(const NearTriangles& near, const glm::dvec3& point_m,
                               const glm::dvec3& front, ReceiverKernel kernel,
                               double ray_offset_m) {
  SurfaceContact contact;
  if (near.within(point_m, kTouching * ray_offset_m).empty()) return contact;
  PlacesAround places(near.within(point_m, kContactReach * ray_offset_m), point_m, front, kernel,
                      ray_offset_m);
  contact.body = places.touched();
  if (contact.body == nullptr) return contact;
  if (kernel != ReceiverKernel::planar && places.is_all_across()) {
    contact.sides.push_back({kStandOff * ray_offset_m * front, true});
    return contact;
  }
  contact.sides = places.sides();
  return contact;
}

}  // namespace calc
