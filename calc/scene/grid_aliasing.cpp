#include "calc/scene/grid_aliasing.h"

#include "calc/base/units.h"
#include "calc/scene/plane_place.h"
#include "calc/scene/scene_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr double kLevel = 0.9998;  // cosine of one degree
constexpr double kMostSpread = 0.25;
constexpr double kSameHeight_m = 0.05;
// Across a row, as a share of the spacing of the points that way: they cannot tell it.
constexpr double kSameLine = 0.1;
constexpr double kSamePlace_m = 0.01;
constexpr double kEven = 0.95;            // darkest to brightest place
constexpr double kBeyond = 1.0 + 1.0e-9;  // the ends of a row, in spacings
constexpr double kLeastShareOfFlux = 0.5;

// A luminaire as a plane sees it.
struct Source {
  const Luminaire* luminaire = nullptr;
  double level = 1.0;         // in the scene
  double height_m = 0.0;      // before the plane
  glm::dvec2 at_m{0.0};       // along the grid's axes, from its origin
  glm::dvec2 opening_m{0.0};  // sizes along them
  double flux_lm = 0.0;       // towards the plane's side
};

// Flux into the half-space that the plane is in; all of it, if the luminaire is tilted.
double flux_towards_lm(const PhotometricWeb& web, const glm::dvec3& up, const glm::dvec3& normal) {
  const double same = glm::dot(up, normal);
  if (same >= kLevel) return web.zonal_flux_lm(0.0, 0.5 * kPi);
  if (same <= -kLevel) return web.zonal_flux_lm(0.5 * kPi, kPi);
  return web.flux_lm();
}

// Those within their height of the grid, seen from above.
std::vector<Source> sources_before(const Project& project, const Space& space,
                                   const SensorGrid& grid, const LightScene* scene) {
  const glm::dvec3 normal = glm::cross(grid.u, grid.v);
  const glm::dvec2 side_m(grid.columns * grid.spacing_u_m, grid.rows * grid.spacing_v_m);
  std::map<std::pair<std::size_t, int>, double> flux_lm;  // by type and the way it hangs
  std::vector<Source> sources;
  for (const Luminaire& luminaire : space.luminaires) {
    const glm::dvec3 from_m = luminaire.position_m - grid.origin_m;
    Source source{&luminaire};
    source.height_m = glm::dot(from_m, normal);
    source.at_m = {glm::dot(from_m, grid.u), glm::dot(from_m, grid.v)};
    const bool is_near =
        source.height_m > 0.0 &&
        glm::all(glm::greaterThanEqual(source.at_m + source.height_m, glm::dvec2(0.0))) &&
        glm::all(glm::lessThanEqual(source.at_m - source.height_m, side_m));
    if (!is_near) continue;
    source.level = level_in_scene(scene, luminaire.group);
    const LuminaireType& type = project.luminaire_types[luminaire.type];
    const PhotometricWeb& web = project.webs[type.web];
    const glm::dvec3& up = luminaire.world_from_luminaire[2];
    const double same = glm::dot(up, normal);
    const int way = same >= kLevel ? 1 : same <= -kLevel ? -1 : 0;
    const auto [known, is_new] = flux_lm.try_emplace({luminaire.type, way}, 0.0);
    if (is_new) known->second = type.flux_scale * flux_towards_lm(web, up, normal);
    source.flux_lm = source.level * known->second;
    if (!(source.flux_lm > 0.0)) continue;
    source.opening_m = 2.0 * glm::dvec2(opening_reach_m(web.opening(), luminaire, grid.u),
                                        opening_reach_m(web.opening(), luminaire, grid.v));
    sources.push_back(source);
  }
  return sources;
}

// Cells along an axis that have a point, ascending; their middles in metres.
std::vector<double> places_m(const std::vector<int>& cell, int cells, double spacing_m) {
  std::vector<bool> has_point(static_cast<std::size_t>(cells), false);
  for (const int index : cell) has_point[static_cast<std::size_t>(index)] = true;
  std::vector<double> places;
  for (std::size_t i = 0; i < has_point.size(); ++i) {
    if (has_point[i]) places.push_back((static_cast<double>(i) + 0.5) * spacing_m);
  }
  return places;
}

// How many luminaires of a row a point has passed, whole and part of the next; empty: it is farther
// beyond the row's end than the last two of it are apart. next: where to go on, of points in order.
std::optional<double> passed(const std::vector<double>& row_m, double point_m, std::size_t& next) {
  while (next < row_m.size() && row_m[next] <= point_m) ++next;
  const std::size_t right = std::clamp<std::size_t>(next, 1, row_m.size() - 1);
  const double gap_m = row_m[right] - row_m[right - 1];
  const double share = (point_m - row_m[right - 1]) / gap_m;
  if (share < -kBeyond || share > 1.0 + kBeyond) return std::nullopt;
  return static_cast<double>(right - 1) + share;
}

// Ascending, of two luminaires at least.
bool is_trap(const std::vector<double>& row_m, const std::vector<double>& points_m) {
  // Each point needs another luminaire, but for those beyond both ends.
  if (points_m.size() < 2 || points_m.size() > row_m.size() + 2) return false;
  std::size_t next = 0;
  double before = 0.0, drift = 0.0, lowest = 0.0, highest = 0.0;
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const std::optional<double> now = passed(row_m, points_m[i], next);
    if (!now) return false;
    if (i > 0) {
      const double step = *now - before;
      if (std::round(step) < 1.0) return false;
      drift += step - std::round(step);
      lowest = std::min(lowest, drift);
      highest = std::max(highest, drift);
    }
    if (highest - lowest >= kMostSpread) return false;
    before = *now;
  }
  return true;
}

// What a row gives to the plane.
class RowLight {
 public:
  RowLight(const PhotometricWeb& web, const Source& source, const glm::dvec3& along,
           const glm::dvec3& normal, double spacing_m, double opening_m)
      : web_(web),
        frame_(glm::transpose(source.luminaire->world_from_luminaire)),
        along_(along),
        across_(glm::cross(normal, along)),
        normal_(normal),
        height_m_(source.height_m),
        spacing_m_(spacing_m),
        opening_m_(opening_m) {}

  bool is_even() const {
    constexpr double kTold = 0.1;  // of the most: less light than that makes no ripple
    struct Ends {
      double least = 0.0, most = 0.0;
    };
    std::array<Ends, 3> of_lines;
    double most = 0.0;
    for (std::size_t line = 0; line < of_lines.size(); ++line) {
      Ends& ends = of_lines[line];
      for (int phase = 0; phase < kPhases; ++phase) {
        const double light =
            at(spacing_m_ * phase / kPhases, 0.5 * height_m_ * static_cast<double>(line));
        ends.least = phase == 0 ? light : std::min(ends.least, light);
        ends.most = std::max(ends.most, light);
      }
      most = std::max(most, ends.most);
    }
    return std::all_of(of_lines.begin(), of_lines.end(), [&](const Ends& ends) {
      return ends.most < kTold * most || ends.least >= kEven * ends.most;
    });
  }

 private:
  static constexpr int kPhases = 16, kParts = 8;  // of the spacing, and of an opening

  double at(double along_m, double across_m) const {
    constexpr double kReach = 6.0;  // heights
    constexpr int kMostEachWay = 200;
    const int each_way = static_cast<int>(
        std::min<double>(kMostEachWay, std::ceil(kReach * height_m_ / spacing_m_)));
    const int parts = opening_m_ > 0.0 ? kParts : 1;
    double light = 0.0;
    for (int k = -each_way; k <= each_way + 1; ++k) {
      for (int part = 0; part < parts; ++part) {
        const double from_m = k * spacing_m_ + opening_m_ * ((part + 0.5) / parts - 0.5);
        const glm::dvec3 way =
            (along_m - from_m) * along_ + across_m * across_ - height_m_ * normal_;
        const double distance_m = glm::length(way);
        const glm::dvec3 local = frame_ * (way / distance_m);
        light += web_.intensity_cd({local.x, local.y, local.z}) * height_m_ /
                 (parts * distance_m * distance_m * distance_m);
      }
    }
    return light;
  }

  const PhotometricWeb& web_;
  glm::dmat3 frame_;
  glm::dvec3 along_, across_, normal_;
  double height_m_, spacing_m_, opening_m_;
};

class TrapsAlong {
 public:
  TrapsAlong(const Project& project, const SensorGrid& grid, int axis)
      : project_(project),
        normal_(glm::cross(grid.u, grid.v)),
        axis_(axis),
        points_m_(axis == 0 ? places_m(grid.column, grid.columns, grid.spacing_u_m)
                            : places_m(grid.row, grid.rows, grid.spacing_v_m)),
        same_line_m_(kSameLine * (axis == 0 ? grid.spacing_v_m : grid.spacing_u_m)) {
    trap_.along = axis == 0 ? grid.u : grid.v;
    trap_.points_m = axis == 0 ? grid.spacing_u_m : grid.spacing_v_m;
  }

  std::optional<GridAliasing> of(std::vector<Source>& sources) {
    const auto kind = [](const Source& source) {
      return std::tuple(source.luminaire->type, source.level);
    };
    std::sort(sources.begin(), sources.end(), [&](const Source& a, const Source& b) {
      return std::tuple(kind(a), a.height_m) < std::tuple(kind(b), b.height_m);
    });
    double all_lm = 0.0;
    for (const Source& source : sources) all_lm += source.flux_lm;
    std::size_t begin = 0;
    while (begin < sources.size()) {
      std::size_t end = begin + 1;
      while (end < sources.size() && kind(sources[end]) == kind(sources[begin]) &&
             sources[end].height_m - sources[begin].height_m <= kSameHeight_m) {
        ++end;
      }
      add_lines(std::span(sources).subspan(begin, end - begin));
      begin = end;
    }
    if (!(trapped_lm_ > 0.0) || trapped_lm_ < kLeastShareOfFlux * all_lm) return std::nullopt;
    return trap_;
  }

 private:
  double along_m(const Source& source) const { return source.at_m[axis_]; }
  double across_m(const Source& source) const { return source.at_m[1 - axis_]; }

  // All of one kind and height.
  void add_lines(std::span<Source> sources) {
    std::sort(sources.begin(), sources.end(),
              [&](const Source& a, const Source& b) { return across_m(a) < across_m(b); });
    std::size_t begin = 0;
    while (begin < sources.size()) {
      std::size_t end = begin + 1;
      while (end < sources.size() && across_m(sources[end]) - across_m(sources[begin]) <=
                                         std::max(same_line_m_, kSamePlace_m)) {
        ++end;
      }
      add_row(sources.subspan(begin, end - begin));
      begin = end;
    }
  }

  void add_row(std::span<Source> row) {
    std::sort(row.begin(), row.end(),
              [&](const Source& a, const Source& b) { return along_m(a) < along_m(b); });
    std::vector<double> places_m;
    double row_lm = 0.0;
    for (const Source& source : row) {
      row_lm += source.flux_lm;
      if (places_m.empty() || along_m(source) - places_m.back() > kSamePlace_m)
        places_m.push_back(along_m(source));
    }
    if (places_m.size() < 2) return;
    const auto gaps = static_cast<double>(places_m.size() - 1);
    const double spacing_m = (places_m.back() - places_m.front()) / gaps;
    if (!is_trap(places_m, points_m_) || is_even(row.front(), spacing_m)) return;
    trapped_lm_ += row_lm;
    if (places_m.size() <= longest_) return;
    longest_ = places_m.size();
    trap_.luminaires_m = spacing_m;
    trap_.first_id = row.front().luminaire->id;
    trap_.last_id = row.back().luminaire->id;
  }

  // Once for all rows of a kind.
  bool is_even(const Source& source, double spacing_m) {
    constexpr double kSameSpacing_m = 0.01, kSameTurn = 0.01;
    const Luminaire& luminaire = *source.luminaire;
    const auto rounded = [](double x, double step) { return std::llround(x / step); };
    const std::tuple kind(
        luminaire.type, rounded(spacing_m, kSameSpacing_m), rounded(source.height_m, kSameHeight_m),
        rounded(glm::dot(luminaire.world_from_luminaire[0], trap_.along), kSameTurn),
        rounded(glm::dot(luminaire.world_from_luminaire[2], trap_.along), kSameTurn));
    const auto [known, is_new] = is_even_.try_emplace(kind, false);
    if (is_new) {
      const PhotometricWeb& web = project_.webs[project_.luminaire_types[luminaire.type].web];
      known->second =
          RowLight(web, source, trap_.along, normal_, spacing_m, source.opening_m[axis_]).is_even();
    }
    return known->second;
  }

  const Project& project_;
  glm::dvec3 normal_;
  int axis_;
  std::vector<double> points_m_;
  double same_line_m_;
  double trapped_lm_ = 0.0;
  std::size_t longest_ = 0;
  std::map<std::tuple<std::size_t, long long, long long, long long, long long>, bool> is_even_;
  GridAliasing trap_;
};

}  // namespace

std::optional<GridAliasing> grid_aliasing(const Project& project, const Space& space,
                                          const SensorGrid& grid, const LightScene* scene) {
  const bool is_level = std::abs(glm::cross(grid.u, grid.v).z) >= kLevel;
  const bool has_cells = grid.columns > 0 && !grid.route;
  const bool is_planar =
      grid.kernel == ReceiverKernel::planar && grid.derived == DerivedQuantity::none;
  if (!is_level || !has_cells || !is_planar || space.road) return std::nullopt;
  std::vector<Source> sources = sources_before(project, space, grid, scene);
  for (const int axis : {0, 1}) {
    if (const std::optional<GridAliasing> trap = TrapsAlong(project, grid, axis).of(sources))
      return trap;
  }
  return std::nullopt;
}

}  // namespace calc
