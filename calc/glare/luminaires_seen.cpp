#include "calc/glare/luminaires_seen.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/photometry/sine_segment.h"
#include "calc/scene/polygon.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"
#include "calc/scene/solids.h"
#include "calc/scene/walking_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

namespace calc {
namespace {

// A table stands upright whose axis is that near to the vertical.
constexpr double kUpright = 1.0e-9;
// Of a web's flux: less than that is rounding of angles, and none.
constexpr double kNoShare = 1.0e-12;

struct SeenLuminaire {
  std::size_t index;
  const PhotometricWeb* web;
  double factor;
  std::size_t first;  // emitter of the luminaire; itself, if it has one only
};

std::vector<SeenLuminaire> seen_luminaires(const Project& project, const Space& space,
                                           const LightScene* scene) {
  std::vector<SeenLuminaire> seen;
  std::size_t first = 0;
  for (std::size_t i = 0; i < space.luminaires.size(); ++i) {
    const Luminaire& luminaire = space.luminaires[i];
    const LuminaireType& type = project.luminaire_types[luminaire.type];
    if (type.counts_as_luminaire()) first = i;
    const double factor =
        installed_flux_scale(project, luminaire) * level_in_scene(scene, luminaire.group);
    if (!(factor > 0.0)) continue;
    seen.push_back({i, &project.webs[type.web], factor, first});
  }
  return seen;
}

// The world's vertical, upwards, in the frame of the table; a turn about it changes nothing.
glm::dvec3 up_in_table(const Luminaire& luminaire, const PhotometricWeb& web) {
  const glm::dvec3 up = glm::transpose(luminaire.world_from_luminaire) * glm::dvec3(0.0, 0.0, 1.0);
  const auto [x, y, z] = web.to_table(std::array{up.x, up.y, up.z});
  return glm::normalize(glm::dvec3(x, y, z));
}

bool is_upright(const glm::dvec3& up) { return up.x * up.x + up.y * up.y <= kUpright * kUpright; }

// What depends on the web and the vertical alone is found once for all luminaires alike.
template <class Value>
class OncePerMounting {
 public:
  template <class Find>
  Value of(const PhotometricWeb& web, const glm::dvec3& up, const Find& find) {
    const auto key = std::make_tuple(&web, up.x, up.y, up.z);
    const auto known = found_.find(key);
    if (known != found_.end()) return known->second;
    return found_.emplace(key, find(web, up)).first->second;
  }

 private:
  std::map<std::tuple<const PhotometricWeb*, double, double, double>, Value> found_;
};

// A table as rings of equal gamma, each around the full circle: of an axial one between two planes.
class Rings {
 public:
  explicit Rings(const PhotometricWeb& web) : web_(web), c_rad_(web.c_rad()) {
    if (web.is_axial()) c_rad_.push_back(2.0 * kPi);
    for (std::size_t ring = 0; ring < gamma_rad().size(); ++ring) {
      double sum = 0.0;
      for (std::size_t plane = 0; plane < planes(); ++plane) {
        if (plane > 0) {
          sum += 0.5 * (c_rad_[plane] - c_rad_[plane - 1]) *
                 (node_cd(ring, plane - 1) + node_cd(ring, plane));
        }
        arc_to_plane_.push_back(sum);
      }
    }
  }

  const std::vector<double>& gamma_rad() const { return web_.gamma_rad(); }
  const std::vector<double>& c_rad() const { return c_rad_; }
  std::size_t planes() const { return c_rad_.size(); }
  double node_cd(std::size_t ring, std::size_t plane) const {
    return web_.table_cd(web_.is_axial() ? 0 : plane, ring);
  }

  // Between a ring and the next one: where gamma lies, 0 to 1.
  double fraction(std::size_t ring, double gamma) const {
    return std::clamp((gamma - gamma_rad()[ring]) / (gamma_rad()[ring + 1] - gamma_rad()[ring]),
                      0.0, 1.0);
  }
  // In the cell that begins at a ring and a plane.
  double cell_cd(std::size_t ring, std::size_t plane, double c, double gamma) const {
    const double along =
        std::clamp((c - c_rad_[plane]) / (c_rad_[plane + 1] - c_rad_[plane]), 0.0, 1.0);
    return std::lerp(std::lerp(node_cd(ring, plane), node_cd(ring, plane + 1), along),
                     std::lerp(node_cd(ring + 1, plane), node_cd(ring + 1, plane + 1), along),
                     fraction(ring, gamma));
  }

  // cd rad around a ring, whole and between -2 pi <= from <= to <= 2 pi.
  double whole_cd_rad(std::size_t ring) const { return arc_to_plane_[(ring + 1) * planes() - 1]; }
  double arc_cd_rad(std::size_t ring, double from, double to) const {
    return std::max(0.0, arc_to_cd_rad(ring, to) - arc_to_cd_rad(ring, from));
  }

 private:
  double arc_to_cd_rad(std::size_t ring, double c) const {
    if (c < 0.0) return arc_to_cd_rad(ring, c + 2.0 * kPi) - whole_cd_rad(ring);
    const std::size_t plane = interval_of(c_rad_, c);
    const double start_cd = node_cd(ring, plane), end_cd = node_cd(ring, plane + 1);
    const double x = c - c_rad_[plane];
    const double share = x / (c_rad_[plane + 1] - c_rad_[plane]);
    return arc_to_plane_[ring * planes() + plane] +
           x * (start_cd + 0.5 * share * (end_cd - start_cd));
  }

  const PhotometricWeb& web_;
  std::vector<double> c_rad_;
  std::vector<double> arc_to_plane_;  // [ring][plane], from C = 0
};

struct Range {
  double low = 0.0, high = 0.0;

  Range& operator+=(const Range& other) {
    low += other.low;
    high += other.high;
    return *this;
  }
};

// The flux above the horizon of a table that does not stand upright.
//
// At one gamma the directions above the horizon are an arc of C about that of the vertical. Its
// half, phi, with cos(phi) = up.z cot(gamma) / |up.x, up.y|, only grows or only shrinks with gamma.
// So of a strip between two gammas the shorter arc of its ends is above throughout, and its flux
// has a closed form; and nothing beyond the longer arc is above. The solid angle above the horizon
// has a closed form too: what remains of it lies between the two arcs, half on either side, and its
// intensity is between the lowest and the highest one there.
class FluxAbove {
 public:
  FluxAbove(const PhotometricWeb& web, const glm::dvec3& up)
      : rings_(web), up_z_(up.z), up_c_(calc::atan2(up.y, up.x)), flux_lm_(web.flux_lm()) {}

  Range lm() const {
    Range sum;
    const std::vector<double>& gamma = rings_.gamma_rad();
    for (std::size_t ring = 0; ring + 1 < gamma.size(); ++ring) {
      sum += strip_lm(ring, edge(gamma[ring]), edge(gamma[ring + 1]), 0);
    }
    if (!(sum.high > 0.0)) return {};
    return {std::max(0.0, sum.low - kRounding * flux_lm_),
            std::min(flux_lm_, sum.high + kRounding * flux_lm_)};
  }

 private:
  static constexpr int kDeepest = 20;
  static constexpr double kWidth = 3.0e-5;  // of the flux, for a strip of half a turn
  static constexpr double kRounding =
      1.0e-14;  // of solid angles, and of sums as a share of the flux

  struct Edge {
    double gamma_rad, cosine;
    double half_arc_rad;
    double above_sr;  // up to here, from some gamma on
  };

  Edge edge(double gamma_rad) const {
    const double sine = calc::sin(gamma_rad), cosine = calc::cos(gamma_rad);
    // The same root in both angles: near the last arc their roundings then cancel.
    const double root =
        std::sqrt(std::max(0.0, (sine - std::abs(up_z_)) * (sine + std::abs(up_z_))));
    const double half_arc = calc::atan2(root, up_z_ * cosine);
    return {gamma_rad, cosine, half_arc, 2.0 * (calc::atan2(root, up_z_) - half_arc * cosine)};
  }

  Range strip_lm(std::size_t ring, const Edge& from, const Edge& to, int depth) const {
    const auto [inner, outer] = std::minmax(from.half_arc_rad, to.half_arc_rad);
    if (!(outer > 0.0)) return {};
    Range sum = inner_lm(ring, from, to, inner);
    if (outer > inner) {
      const double rest_sr =
          std::max(0.0, to.above_sr - from.above_sr - 2.0 * inner * (from.cosine - to.cosine));
      for (const double side : {-1.0, 1.0}) {
        const Range cd = range_cd(ring, from, to, up_c_ + side * inner, up_c_ + side * outer);
        sum += {cd.low * std::max(0.0, 0.5 * rest_sr - kRounding),
                cd.high * (0.5 * rest_sr + kRounding)};
      }
    }
    const double width_rad = to.gamma_rad - from.gamma_rad;
    if (sum.high - sum.low <= kWidth * flux_lm_ * width_rad / kPi || depth == kDeepest) return sum;
    const Edge middle = edge(0.5 * (from.gamma_rad + to.gamma_rad));
    sum = strip_lm(ring, from, middle, depth + 1);
    return sum += strip_lm(ring, middle, to, depth + 1);
  }

  Range inner_lm(std::size_t ring, const Edge& from, const Edge& to, double half_arc_rad) const {
    if (!(half_arc_rad > 0.0)) return {};
    const double c0 = up_c_ - half_arc_rad, c1 = up_c_ + half_arc_rad;
    const double start = rings_.arc_cd_rad(ring, c0, c1);
    const double end = rings_.arc_cd_rad(ring + 1, c0, c1);
    const double width_rad = to.gamma_rad - from.gamma_rad;
    const double lm = integral({from.gamma_rad, width_rad,
                                std::lerp(start, end, rings_.fraction(ring, from.gamma_rad)),
                                std::lerp(start, end, rings_.fraction(ring, to.gamma_rad))});
    return {lm, lm};
  }

  // A bilinear cell is lowest and highest in its corners.
  Range range_cd(std::size_t ring, const Edge& from, const Edge& to, double c0, double c1) const {
    Range found{std::numeric_limits<double>::infinity(), 0.0};
    const auto look = [&](std::size_t plane, double c) {
      for (const double gamma : {from.gamma_rad, to.gamma_rad}) {
        const double cd = rings_.cell_cd(ring, plane, c, gamma);
        found = {std::min(found.low, cd), std::max(found.high, cd)};
      }
    };
    const std::vector<double>& planes = rings_.c_rad();
    const double first = std::min(c0, c1), last = std::max(c0, c1);
    for (const double turn : {-2.0 * kPi, 0.0, 2.0 * kPi}) {
      const double begin = std::max(0.0, first - turn), end = std::min(2.0 * kPi, last - turn);
      if (begin > end) continue;
      const std::size_t last_plane = interval_of(planes, end);
      for (std::size_t plane = interval_of(planes, begin); plane <= last_plane; ++plane) {
        look(plane, std::max(begin, planes[plane]));
        look(plane, std::min(end, planes[plane + 1]));
      }
    }
    return found;
  }

  Rings rings_;
  double up_z_, up_c_, flux_lm_;
};

Range upright_flux_lm(const PhotometricWeb& web, bool is_upside_down) {
  const double horizon = 0.5 * kPi;
  const double from = is_upside_down ? 0.0 : horizon, to = is_upside_down ? horizon : kPi;
  double lm = 0.0;
  if (web.axis() == TableAxis::vertical) {
    lm = web.zonal_flux_lm(from, to);
  } else {  // zonal_flux_lm() is about another line
    const Rings rings(web);
    const std::vector<double>& gamma = rings.gamma_rad();
    for (std::size_t ring = 0; ring + 1 < gamma.size(); ++ring) {
      const double begin = std::max(from, gamma[ring]), end = std::min(to, gamma[ring + 1]);
      if (!(begin < end)) continue;
      const double first = rings.whole_cd_rad(ring), second = rings.whole_cd_rad(ring + 1);
      lm += integral({begin, end - begin, std::lerp(first, second, rings.fraction(ring, begin)),
                      std::lerp(first, second, rings.fraction(ring, end))});
    }
  }
  return {lm, lm};
}

Range flux_above_lm(const PhotometricWeb& web, const glm::dvec3& up) {
  const Range lm = is_upright(up) ? upright_flux_lm(web, up.z < 0.0) : FluxAbove(web, up).lm();
  return lm.high <= kNoShare * web.flux_lm() ? Range{} : lm;
}

// The greatest intensity between two cones about the vertical. Heights are cosines from straight
// up. Boxes of the table that reach into the zone are halved, always the one that may hold most,
// until none may hold more than what was found.
class ZonePeak {
 public:
  ZonePeak(const PhotometricWeb& web, const glm::dvec3& up, const Range& height)
      : web_(web),
        rings_(web),
        up_z_(up.z),
        up_flat_(calc::hypot(up.x, up.y)),
        up_c_(calc::atan2(up.y, up.x)),
        height_(height) {}

  Range cd() {
    for (std::size_t ring = 0; ring + 1 < rings_.gamma_rad().size(); ++ring) {
      for (std::size_t plane = 0; plane + 1 < rings_.planes(); ++plane) {
        keep({ring, plane, rings_.c_rad()[plane], rings_.c_rad()[plane + 1],
              rings_.gamma_rad()[ring], rings_.gamma_rad()[ring + 1]});
      }
    }
    const double nothing_cd = kNothing * web_.max_intensity_cd();
    int halvings = 0;
    while (!boxes_.empty()) {
      const Box box = boxes_.top();
      if (box.most_cd <= (1.0 + kWidth) * found_cd_ + nothing_cd || halvings == kMostHalvings) {
        return {found_cd_, std::max(found_cd_, box.most_cd)};
      }
      boxes_.pop();
      const Range up = heights(box, cosines(box));
      if (up.high < height_.low - kRounding || up.low > height_.high + kRounding) continue;
      if (up.low >= height_.low && up.high <= height_.high) return {box.most_cd, box.most_cd};
      look_into(box);
      if (is_small(box)) return {found_cd_, std::max(found_cd_, box.most_cd)};
      halve(box);
      ++halvings;
    }
    return {found_cd_, found_cd_};
  }

 private:
  static constexpr double kWidth = 1.0e-4;      // of the greatest in the zone, and
  static constexpr double kNothing = 1.0e-8;    // of the greatest of all
  static constexpr double kRounding = 1.0e-13;  // of heights: what is on the border is in the zone
  static constexpr int kMostHalvings = 50000;

  struct Box {
    std::size_t ring, plane;
    double c0, c1, gamma0, gamma1;
    double most_cd = 0.0;
    std::size_t number = 0;

    // Of equal ones the oldest, so that the order is fixed.
    bool operator<(const Box& other) const {
      return std::make_tuple(most_cd, other.number) < std::make_tuple(other.most_cd, number);
    }
  };

  double height(double cos_c, double gamma) const {
    return up_flat_ * cos_c * calc::sin(gamma) - up_z_ * calc::cos(gamma);
  }
  double slope(double cos_c, double gamma) const {
    return up_flat_ * cos_c * calc::cos(gamma) + up_z_ * calc::sin(gamma);
  }

  // Of the cosine of C from the vertical's.
  Range cosines(const Box& box) const {
    const double a = calc::cos(box.c0 - up_c_), b = calc::cos(box.c1 - up_c_);
    Range found{std::min(a, b), std::max(a, b)};
    for (const double turn : {-2.0 * kPi, 0.0, 2.0 * kPi}) {
      if (box.c0 <= up_c_ + turn && up_c_ + turn <= box.c1) found.high = 1.0;
      const double opposite = up_c_ + kPi + turn;
      if (box.c0 <= opposite && opposite <= box.c1) found.low = -1.0;
    }
    return found;
  }

  // The sine of gamma is not negative: heights are those at the ends of the cosine's range, and
  // along gamma at the ends, or where a sine wave turns between them.
  Range heights(const Box& box, const Range& cosine) const {
    Range found{std::min(height(cosine.low, box.gamma0), height(cosine.low, box.gamma1)),
                std::max(height(cosine.high, box.gamma0), height(cosine.high, box.gamma1))};
    if (slope(cosine.low, box.gamma0) < 0.0 && slope(cosine.low, box.gamma1) > 0.0) {
      found.low = -calc::hypot(up_flat_ * cosine.low, up_z_);
    }
    if (slope(cosine.high, box.gamma0) > 0.0 && slope(cosine.high, box.gamma1) < 0.0) {
      found.high = calc::hypot(up_flat_ * cosine.high, up_z_);
    }
    return found;
  }

  // So near to a pole rounding decides on C.
  static bool is_pole(double gamma) {
    constexpr double kPole_rad = 1.0e-9;
    return std::min(gamma, kPi - gamma) < kPole_rad;
  }
  // Nothing more can be found by halving it.
  static bool is_small(const Box& box) {
    constexpr double kSmallest_rad = 1.0e-8;
    const double gamma_rad = box.gamma1 - box.gamma0;
    return std::max(box.c1 - box.c0, gamma_rad) < kSmallest_rad ||
           (is_pole(box.gamma0) && is_pole(box.gamma1) && gamma_rad < 1.0);
  }

  bool holds(double height) const {
    return height >= height_.low - kRounding && height <= height_.high + kRounding;
  }

  void keep(Box box) {
    box.most_cd = 0.0;
    for (const double c : {box.c0, box.c1}) {
      for (const double gamma : {box.gamma0, box.gamma1}) {
        box.most_cd = std::max(box.most_cd, rings_.cell_cd(box.ring, box.plane, c, gamma));
      }
    }
    if (box.most_cd <= found_cd_) return;
    box.number = ++boxes_so_far_;
    boxes_.push(box);
  }

  void look_into(const Box& box) {
    for (const double gamma : {box.gamma0, 0.5 * (box.gamma0 + box.gamma1), box.gamma1}) {
      for (const double c : {box.c0, 0.5 * (box.c0 + box.c1), box.c1}) look_at(box, c, gamma);
    }
  }

  // Across the light's steepest way; light that hardly changes is cut where the zone is.
  void halve(const Box& box) {
    const auto cd = [&](double c, double gamma) {
      return rings_.cell_cd(box.ring, box.plane, c, gamma);
    };
    const double c_step = std::max(std::abs(cd(box.c1, box.gamma0) - cd(box.c0, box.gamma0)),
                                   std::abs(cd(box.c1, box.gamma1) - cd(box.c0, box.gamma1)));
    const double gamma_step = std::max(std::abs(cd(box.c0, box.gamma1) - cd(box.c0, box.gamma0)),
                                       std::abs(cd(box.c1, box.gamma1) - cd(box.c1, box.gamma0)));
    const bool is_even = std::max(c_step, gamma_step) < 0.25 * kWidth * box.most_cd;
    const double sine = calc::sin(0.5 * (box.gamma0 + box.gamma1));
    const bool halve_c = is_even ? up_flat_ * sine * (box.c1 - box.c0) > box.gamma1 - box.gamma0
                                 : c_step > gamma_step;
    Box first = box, second = box;
    if (halve_c) {
      first.c1 = second.c0 = 0.5 * (box.c0 + box.c1);
    } else {
      first.gamma1 = second.gamma0 = 0.5 * (box.gamma0 + box.gamma1);
    }
    keep(first);
    keep(second);
  }

  void look_at(const Box& box, double c, double gamma) {
    if (!holds(height(calc::cos(c - up_c_), gamma))) return;
    // The pole itself has the mean over C.
    const double cd = is_pole(gamma) ? web_.at_table_angles_cd(0.0, gamma < 1.0 ? 0.0 : kPi)
                                     : rings_.cell_cd(box.ring, box.plane, c, gamma);
    found_cd_ = std::max(found_cd_, cd);
  }

  const PhotometricWeb& web_;
  Rings rings_;
  double up_z_, up_flat_, up_c_;
  Range height_;
  double found_cd_ = 0.0;
  std::size_t boxes_so_far_ = 0;
  std::priority_queue<Box> boxes_;
};

// Linear along C and from node to node along gamma: no greater one than at these.
double upright_peak_cd(const PhotometricWeb& web, double from_gamma_rad, double to_gamma_rad) {
  constexpr double kRounding_rad = 1.0e-14;
  const Rings rings(web);
  const std::vector<double>& gamma = rings.gamma_rad();
  if (to_gamma_rad < gamma.front() - kRounding_rad) return 0.0;
  if (from_gamma_rad > gamma.back() + kRounding_rad) return 0.0;
  const double from = std::clamp(from_gamma_rad, gamma.front(), gamma.back());
  const double to = std::clamp(to_gamma_rad, gamma.front(), gamma.back());
  double most_cd = 0.0;
  for (std::size_t ring = 0; ring + 1 < gamma.size(); ++ring) {
    if (gamma[ring + 1] < from || gamma[ring] > to) continue;
    for (std::size_t plane = 0; plane + 1 < rings.planes(); ++plane) {
      const double c = rings.c_rad()[plane];
      most_cd = std::max({most_cd, rings.cell_cd(ring, plane, c, std::max(from, gamma[ring])),
                          rings.cell_cd(ring, plane, c, std::min(to, gamma[ring + 1]))});
    }
  }
  return most_cd;
}

Range zone_peak_cd(const PhotometricWeb& web, const glm::dvec3& up, double from_deg,
                   double to_deg) {
  const bool from_nadir = from_deg <= 0.0, to_zenith = to_deg >= 180.0;
  if (from_nadir && to_zenith) return {web.max_intensity_cd(), web.max_intensity_cd()};
  const double from_rad = from_nadir ? 0.0 : radians_from_degrees(from_deg);
  const double to_rad = to_zenith ? kPi : radians_from_degrees(to_deg);
  if (is_upright(up)) {
    const double cd = up.z > 0.0 ? upright_peak_cd(web, from_rad, to_rad)
                                 : upright_peak_cd(web, kPi - to_rad, kPi - from_rad);
    return {cd, cd};
  }
  return ZonePeak(web, up, {-calc::cos(from_rad), -calc::cos(to_rad)}).cd();
}

// Of a room with walls: its light reaches it.
bool stands_in(const Space& space, const glm::dvec3& place_m) {
  if (!space.shell) return true;
  const RoomShell& room = *space.shell;
  constexpr double kOnSurface_m = 1.0e-6;
  const double above_m = place_m.z - room.floor_z_m;
  return above_m >= -kOnSurface_m && above_m <= room.height_m + kOnSurface_m &&
         (contains_point(room.footprint_m, glm::dvec2(place_m)) ||
          distance_to_boundary(room.footprint_m, glm::dvec2(place_m)) <= kOnSurface_m);
}

}  // namespace

bool has_light(const Project& project, const Space& space, const LightScene* scene) {
  return !seen_luminaires(project, space, scene).empty();
}

bool may_hide_luminaires(const Space& space, double lower_z_m) {
  if (space.shell || !space.surfaces_file.empty()) return true;
  return std::any_of(space.bodies.begin(), space.bodies.end(), [&](const Body& body) {
    return std::any_of(body.vertex_m.begin(), body.vertex_m.end(),
                       [&](const glm::dvec3& vertex) { return vertex.z > lower_z_m; });
  });
}

namespace {

// In a solid, or below the ground: in the open space z = 0, where no surface is below.
class Buried {
 public:
  explicit Buried(const Space& space) : space_(space) {
    for (const Body& body : space.bodies) box_.push_back(bounding_box(body.vertex_m));
  }

  bool has(const glm::dvec3& place_m) const {
    bool has_floor = false;
    for (std::size_t i = 0; i < space_.bodies.size(); ++i) {
      const Body& body = space_.bodies[i];
      if (locate_point(body, box_[i], place_m) == SolidSide::inside) return true;
      if (place_m.z >= 0.0 || has_floor) continue;
      for (const glm::uvec3& t : body.triangle) {
        const std::array corner{body.vertex_m[t.x], body.vertex_m[t.y], body.vertex_m[t.z]};
        const std::optional<double> z = height_at(corner, glm::dvec2(place_m));
        has_floor = has_floor || (z && *z <= place_m.z);
      }
    }
    return place_m.z < 0.0 && !has_floor;
  }

 private:
  const Space& space_;
  std::vector<BoundingBox> box_;
};

}  // namespace

Estimate upward_share_percent(const Project& project, const Space& space, const LightScene* scene) {
  OncePerMounting<Range> above;
  const Buried buried(space);
  double all_lm = 0.0;
  Range up_lm;
  for (const SeenLuminaire& seen : seen_luminaires(project, space, scene)) {
    const glm::dvec3 up = up_in_table(space.luminaires[seen.index], *seen.web);
    const Range lm = above.of(*seen.web, up, flux_above_lm);
    up_lm += {seen.factor * lm.low, seen.factor * lm.high};
    // What shines down there lights nothing, and makes no other luminaire better.
    const bool is_buried = buried.has(space.luminaires[seen.index].position_m);
    all_lm += seen.factor * (is_buried ? lm.high : seen.web->flux_lm());
  }
  if (!(all_lm > 0.0)) return {};
  const double low = 100.0 * up_lm.low / all_lm, high = 100.0 * up_lm.high / all_lm;
  return {0.5 * (low + high), low, high};
}

StrongestLight strongest_intensity(const Project& project, const Space& space,
                                   const LightScene* scene, const std::vector<glm::dvec3>& points_m,
                                   const std::vector<glm::dvec3>& facing) {
  const std::vector<SeenLuminaire> all = seen_luminaires(project, space, scene);
  StrongestLight strongest;
  double before_cd = 0.0;
  double lowest_m = std::numeric_limits<double>::infinity();  // of points and luminaires
  for (const SeenLuminaire& seen : all) {
    lowest_m = std::min(lowest_m, space.luminaires[seen.index].position_m.z);
  }
  for (std::size_t point = 0; point < points_m.size(); ++point) {
    lowest_m = std::min(lowest_m, points_m[point].z);
    double luminaire_cd = 0.0, in_front_cd = 0.0;  // of the emitters so far
    for (std::size_t i = 0; i < all.size(); ++i) {
      const SeenLuminaire& seen = all[i];
      const Luminaire& luminaire = space.luminaires[seen.index];
      const glm::dvec3 way = points_m[point] - luminaire.position_m;
      const double squared_m2 = glm::dot(way, way);
      double cd = seen.web->max_intensity_cd();
      if (squared_m2 > 0.0) {
        const glm::dvec3 out =
            glm::transpose(luminaire.world_from_luminaire) * (way / std::sqrt(squared_m2));
        cd = seen.web->intensity_cd(std::array{out.x, out.y, out.z});
      }
      if (i == 0 || all[i - 1].first != seen.first) luminaire_cd = in_front_cd = 0.0;
      luminaire_cd += seen.factor * cd;
      if (glm::dot(way, facing[point]) < 0.0) in_front_cd += seen.factor * cd;
      if (luminaire_cd > strongest.cd.value) {
        strongest = {{luminaire_cd, 0.0, luminaire_cd}, seen.first, point, false};
      }
      before_cd = std::max(before_cd, in_front_cd);
    }
  }
  strongest.may_be_hidden = may_hide_luminaires(space, lowest_m);
  if (!strongest.may_be_hidden) strongest.cd.low = before_cd;
  return strongest;
}

NearestLuminaire nearest_luminaire(const Project& project, const Space& space,
                                   const LightScene* scene,
                                   const std::vector<glm::dvec3>& points_m) {
  const std::vector<SeenLuminaire> all = seen_luminaires(project, space, scene);
  constexpr double kLeastLight_lm = 1.0;  // what gives less is there, and not lit
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (all.empty()) return {{kInfinity, kInfinity, kInfinity}, 0, 0};
  NearestLuminaire farthest;
  double farthest_m2 = -1.0;
  for (std::size_t point = 0; point < points_m.size(); ++point) {
    double nearest_m2 = kInfinity;
    std::size_t luminaire = 0;
    for (const SeenLuminaire& seen : all) {
      if (!(seen.web->flux_lm() * seen.factor >= kLeastLight_lm)) continue;
      if (!stands_in(space, space.luminaires[seen.index].position_m)) continue;
      const glm::dvec2 way(space.luminaires[seen.index].position_m - points_m[point]);
      const double squared_m2 = glm::dot(way, way);
      if (!(squared_m2 < nearest_m2)) continue;
      nearest_m2 = squared_m2;
      luminaire = seen.index;
    }
    if (!(nearest_m2 > farthest_m2)) continue;
    farthest_m2 = nearest_m2;
    const double m = std::sqrt(nearest_m2);
    farthest = {{m, m, m}, luminaire, point};
  }
  return farthest;
}

std::vector<ZoneIntensity> zone_intensities(const Project& project, const Space& space,
                                            const LightScene* scene, double from_deg,
                                            double to_deg) {
  OncePerMounting<Range> peaks;
  std::vector<ZoneIntensity> found;
  for (const SeenLuminaire& seen : seen_luminaires(project, space, scene)) {
    const glm::dvec3 up = up_in_table(space.luminaires[seen.index], *seen.web);
    const Range cd =
        peaks.of(*seen.web, up, [&](const PhotometricWeb& web, const glm::dvec3& vertical) {
          return zone_peak_cd(web, vertical, from_deg, to_deg);
        });
    const Estimate of_emitter{seen.factor * cd.low, seen.factor * cd.low, seen.factor * cd.high};
    if (found.empty() || found.back().luminaire != seen.first) {
      found.push_back({seen.first, of_emitter});
      continue;
    }
    // Where several emitters are greatest may be one direction, or several.
    Estimate& sum = found.back().cd;
    sum.low = std::max(sum.low, of_emitter.low);
    sum.high += of_emitter.high;
    sum.value = sum.high;
  }
  return found;
}

}  // namespace calc
