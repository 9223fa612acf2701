#include "calc/road/road_light.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/scene/road.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace calc {
namespace {

constexpr double kEye_m = 1.5;  // above the road
constexpr double kEyeBeforeField_m = 60.0;
// Luminaires that count, in their own heights.
constexpr double kBefore = 5.0, kBeyond = 12.0, kBeside = 5.0;
constexpr double kGlareAhead_m = 500.0;
constexpr double kTiStart = 2.75;                                 // times the height above the eye
constexpr double kAge = 23.0;                                     // years
constexpr double kDarkest_cd_m2 = 0.05, kBrightRoad_cd_m2 = 5.0;  // of the formulas of TI
// Of comparisons of lengths, so that a road and the same road turned by half a turn agree.
constexpr double kLengthRounding_m = 1.0e-9;

void require_road(bool condition, const char* what) {
  if (!condition) throw std::logic_error(std::string("road: ") + what);
}

void require_valid_road(const RoadLayout& layout) {
  require_road(layout.spacing_m >= 1.0 && layout.spacing_m <= 1.0e4, "spacing");
  require_road(layout.width_m > 0.0 && layout.width_m <= 1.0e3, "width");
  require_road(layout.lanes >= 1 && layout.lanes <= 100, "lanes");
  require_road(layout.is_oncoming.size() == static_cast<std::size_t>(layout.lanes),
               "a direction for every lane");
  require_road(layout.table != nullptr, "a surface");
  require_road(layout.q0 > 0.0 && layout.q0 <= 1.0, "Q0");
  for (const std::optional<double>& strip : {layout.right_strip_m, layout.left_strip_m})
    require_road(!strip || (*strip > 0.0 && *strip <= layout.width_m), "width of a strip");
  for (const RoadRow& row : layout.rows) {
    require_road(row.web != nullptr, "light of a row");
    require_road(row.factor >= 0.0 && row.factor * row.web->max_intensity_cd() <= 1.0e30, "factor");
    require_road(row.maintenance > 0.0 && row.maintenance <= 1.0, "maintenance in (0, 1]");
    require_road(row.height_m > kEye_m && row.height_m <= 1.0e3, "height");
    require_road(std::abs(row.y_m) <= 1.0e4, "place across");
    require_road(row.shift_m >= 0.0 && row.shift_m < layout.spacing_m, "shift in [0, spacing)");
    const glm::dmat3& m = row.road_from_luminaire;
    const glm::dmat3 product = glm::transpose(m) * m;
    double off = std::abs(glm::determinant(m) - 1.0);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) off = std::max(off, std::abs(product[i][k] - (i == k)));
    require_road(off < 1.0e-6, "a rotation");
  }
}

// Calls use(x) for the luminaires of a row within [from, to], ascending.
template <typename Use>
void for_luminaires(const RoadRow& row, double spacing_m, double from_m, double to_m,
                    const Use& use) {
  const double first = std::ceil((from_m - kLengthRounding_m - row.shift_m) / spacing_m);
  const double last = std::floor((to_m + kLengthRounding_m - row.shift_m) / spacing_m);
  for (double k = first; k <= last; k += 1.0) use(row.shift_m + k * spacing_m);
}

// New, towards a direction of the road's frame of any length > 0.
double row_intensity_cd(const RoadRow& row, const glm::dvec3& direction) {
  const glm::dvec3 out = glm::transpose(row.road_from_luminaire) * direction /
                         std::sqrt(glm::dot(direction, direction));
  return row.factor * row.web->intensity_cd(std::array<double, 3>{out.x, out.y, out.z});
}

// What one luminaire sends to a point of the road, for eyes wherever they are.
struct RoadBeam {
  glm::dvec2 to_luminaire_m;  // in plan
  double tan_epsilon;
  double cd_per_m2;  // I / H^2, new
  double maintenance;
};

std::vector<RoadBeam> beams_to(const RoadLayout& layout, const glm::dvec2& point) {
  std::vector<RoadBeam> beams;
  for (const RoadRow& row : layout.rows) {
    const double h = row.height_m, dy = row.y_m - point.y;
    if (std::abs(dy) > kBeside * h + kLengthRounding_m) continue;
    for_luminaires(row, layout.spacing_m, point.x - kBefore * h, point.x + kBeyond * h,
                   [&](double x) {
                     const glm::dvec2 to(x - point.x, dy);
                     const double tan_epsilon = std::sqrt(glm::dot(to, to)) / h;
                     if (tan_epsilon > kRTableTan.back() + kLengthRounding_m) return;
                     const double cd = row_intensity_cd(row, {-to.x, -to.y, -h});
                     if (cd > 0.0)
                       beams.push_back({to, tan_epsilon, cd / (h * h), row.maintenance});
                   });
  }
  return beams;
}

RoadLevel luminance_of(const RoadLayout& layout, const std::vector<RoadBeam>& beams,
                       const glm::dvec2& eye_to_point) {
  RoadLevel sum;
  for (const RoadBeam& beam : beams) {
    // 0 where the luminaire stands beyond the point. Under a luminaire all columns are equal.
    const glm::dvec2& to = beam.to_luminaire_m;
    const double sine = eye_to_point.x * to.y - eye_to_point.y * to.x;
    const double beta_deg =
        degrees_from_radians(calc::atan2(std::abs(sine), glm::dot(eye_to_point, to)));
    const double initial = beam.cd_per_m2 * r_1e4(*layout.table, beam.tan_epsilon, beta_deg);
    sum.initial += initial;
    sum.maintained += beam.maintenance * initial;
  }
  const double scale = 1.0e-4 * layout.q0 / layout.table->q0;
  return {sum.maintained * scale, sum.initial * scale};
}

std::vector<double> middles(double from, double to, int count) {
  std::vector<double> at;
  for (int i = 0; i < count; ++i) at.push_back(from + (to - from) * (i + 0.5) / count);
  return at;
}

Estimate hull_of(double value, double other) {
  return {value, std::min(value, other), std::max(value, other)};
}

double lane_middle_m(const RoadLayout& layout, int lane) {
  return layout.width_m * (lane + 0.5) / layout.lanes;
}

// The highest veiling luminance on the way of an eye through one spacing.
RoadVeiling worst_of_series(const RoadLayout& layout, const RoadRow& first, double eye_y_m) {
  const int points = road_points_along(layout.spacing_m);
  const double start = first.shift_m - kTiStart * (first.height_m - kEye_m);
  RoadVeiling worst;
  for (int i = 0; i < points; ++i) {
    const RoadVeiling here =
        road_veiling(layout, {start + layout.spacing_m * i / points, eye_y_m, kEye_m});
    worst.by_plane_cd_m2 = std::max(worst.by_plane_cd_m2, here.by_plane_cd_m2);
    worst.by_elevation_cd_m2 = std::max(worst.by_elevation_cd_m2, here.by_elevation_cd_m2);
  }
  return worst;
}

Estimate highest_veiling(const RoadLayout& layout, double eye_y_m) {
  if (layout.rows.empty()) return {};
  double least_shift = layout.spacing_m;
  for (const RoadRow& row : layout.rows) least_shift = std::min(least_shift, row.shift_m);
  Estimate veiling{0.0, std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < layout.rows.size(); ++i) {
    const RoadRow& row = layout.rows[i];
    const auto has_same_series = [&](const RoadRow& other) {
      return other.shift_m == row.shift_m && other.height_m == row.height_m;
    };
    if (std::any_of(layout.rows.begin(), layout.rows.begin() + static_cast<std::ptrdiff_t>(i),
                    has_same_series))
      continue;
    const RoadVeiling worst = worst_of_series(layout, row, eye_y_m);
    if (row.shift_m <= least_shift + kLengthRounding_m)
      veiling.value = std::max(veiling.value, worst.by_plane_cd_m2);
    veiling.low = std::min({veiling.low, worst.by_plane_cd_m2, worst.by_elevation_cd_m2});
    veiling.high = std::max({veiling.high, worst.by_plane_cd_m2, worst.by_elevation_cd_m2});
  }
  return veiling;
}

std::optional<Estimate> ti_of(const Estimate& veiling, const Estimate& average) {
  const std::optional<double> value = threshold_increment_percent(veiling.value, average.value);
  if (!value) return std::nullopt;
  Estimate ti{*value, *value, *value};
  for (const double lv : {veiling.low, veiling.high}) {
    for (const double lav : {average.low, average.value, average.high}) {
      const std::optional<double> other = threshold_increment_percent(lv, lav);
      if (!other) return std::nullopt;
      ti.low = std::min(ti.low, *other);
      ti.high = std::max(ti.high, *other);
    }
  }
  return ti;
}

// What one eye sees, by one reading of where it stands.
struct RoadView {
  std::vector<double> cd_m2;  // maintained
  double average = 0.0, initial_average = 0.0;
  double uo = 0.0, ul = 0.0;  // < 0: dark
};

RoadView view_of(const RoadLayout& layout, const RoadGrid& grid,
                 const std::vector<std::vector<RoadBeam>>& beams, int lane, double eye_x_m) {
  const glm::dvec2 eye(eye_x_m, lane_middle_m(layout, lane));
  RoadView view;
  for (std::size_t j = 0; j < grid.across(); ++j) {
    for (std::size_t i = 0; i < grid.along(); ++i) {
      const glm::dvec2 point(grid.x_m[i], grid.y_m[j]);
      const RoadLevel level = luminance_of(layout, beams[j * grid.along() + i], point - eye);
      view.cd_m2.push_back(level.maintained);
      view.average += level.maintained;
      view.initial_average += level.initial;
    }
  }
  const auto count = static_cast<double>(view.cd_m2.size());
  view.average /= count;
  view.initial_average /= count;
  const double least = *std::min_element(view.cd_m2.begin(), view.cd_m2.end());
  view.uo = view.average > 0.0 ? least / view.average : -1.0;
  // The middle one of the lane's rows of points is its middle line.
  const auto row = static_cast<std::size_t>(lane * kRoadRowsPerLane + kRoadRowsPerLane / 2);
  const auto line = view.cd_m2.begin() + static_cast<std::ptrdiff_t>(row * grid.along());
  const auto [low, high] =
      std::minmax_element(line, line + static_cast<std::ptrdiff_t>(grid.along()));
  view.ul = *high > 0.0 ? *low / *high : -1.0;
  return view;
}

// The eyes that look along +x.
std::vector<RoadObserver> observers_along_x(const RoadLayout& layout) {
  const RoadGrid grid = road_luminance_grid(layout);
  std::vector<std::vector<RoadBeam>> beams;
  for (const double y : grid.y_m)
    for (const double x : grid.x_m) beams.push_back(beams_to(layout, {x, y}));
  std::vector<RoadObserver> observers;
  for (int lane = 0; lane < layout.lanes; ++lane) {
    if (layout.is_oncoming[static_cast<std::size_t>(lane)]) continue;
    RoadView view = view_of(layout, grid, beams, lane, -kEyeBeforeField_m);
    const RoadView other = view_of(layout, grid, beams, lane, grid.x_m.front() - kEyeBeforeField_m);
    RoadObserver observer;
    observer.lane = lane;
    observer.eye_m = {-kEyeBeforeField_m, lane_middle_m(layout, lane), kEye_m};
    observer.average_cd_m2 = hull_of(view.average, other.average);
    if (view.uo >= 0.0 && other.uo >= 0.0) observer.uo = hull_of(view.uo, other.uo);
    if (view.ul >= 0.0 && other.ul >= 0.0) observer.ul = hull_of(view.ul, other.ul);
    observer.veiling_cd_m2 = highest_veiling(layout, observer.eye_m.y);
    observer.ti_percent =
        ti_of(observer.veiling_cd_m2, hull_of(view.initial_average, other.initial_average));
    observer.cd_m2 = std::move(view.cd_m2);
    observers.push_back(std::move(observer));
  }
  return observers;
}

// The same road for someone who looks at it from its other end: x -> spacing - x, y -> width - y.
RoadLayout half_turned(const RoadLayout& layout) {
  RoadLayout turned = layout;
  std::reverse(turned.is_oncoming.begin(), turned.is_oncoming.end());
  turned.is_oncoming.flip();
  std::swap(turned.right_strip_m, turned.left_strip_m);
  const glm::dmat3 half_turn({-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0});
  for (RoadRow& row : turned.rows) {
    row.y_m = layout.width_m - row.y_m;
    row.shift_m = layout.spacing_m - row.shift_m;
    if (row.shift_m >= layout.spacing_m) row.shift_m = 0.0;  // of 0, or rounded
    row.road_from_luminaire = half_turn * row.road_from_luminaire;
  }
  return turned;
}

// Of a strip from an edge to there (outside_m: beyond it, with its sign) and as wide a one inside.
std::optional<Estimate> edge_ratio(const RoadLayout& layout, double edge_m, double outside_m) {
  std::array<double, 2> ratios{};
  for (const RoadReach reach : {RoadReach::square, RoadReach::circle}) {
    const auto mean = [&](double to_m) {
      return road_illuminance(layout, std::min(edge_m, to_m), std::max(edge_m, to_m), reach)
          .mean_lx();
    };
    const double inside = mean(edge_m - outside_m);
    if (!(inside > 0.0)) return std::nullopt;
    ratios[reach == RoadReach::square ? 0 : 1] = mean(edge_m + outside_m) / inside;
  }
  return hull_of(ratios[0], ratios[1]);
}

}  // namespace

RoadGrid road_luminance_grid(const RoadLayout& layout) {
  require_valid_road(layout);
  return {middles(0.0, layout.spacing_m, road_points_along(layout.spacing_m)),
          middles(0.0, layout.width_m, kRoadRowsPerLane * layout.lanes)};
}

double RoadIlluminance::mean_lx() const {
  double sum = 0.0;
  for (const double value : lx) sum += value;
  return lx.empty() ? 0.0 : sum / static_cast<double>(lx.size());
}

RoadIlluminance road_illuminance(const RoadLayout& layout, double from_y_m, double to_y_m,
                                 RoadReach reach) {
  require_valid_road(layout);
  require_road(from_y_m >= -1.0e4 && to_y_m > from_y_m && to_y_m <= 1.0e4, "a strip");
  const int rows = road_points_across(to_y_m - from_y_m);
  RoadIlluminance strip{{middles(0.0, layout.spacing_m, road_points_along(layout.spacing_m)),
                         middles(from_y_m, to_y_m, rows)},
                        {}};
  for (const double y : strip.grid.y_m)
    for (const double x : strip.grid.x_m)
      strip.lx.push_back(road_point_illuminance_lx(layout, {x, y}, reach));
  return strip;
}

RoadLevel road_luminance_cd_m2(const RoadLayout& layout, const glm::dvec2& point_m,
                               const glm::dvec2& eye_m) {
  return luminance_of(layout, beams_to(layout, point_m), point_m - eye_m);
}

double road_point_illuminance_lx(const RoadLayout& layout, const glm::dvec2& point_m,
                                 RoadReach reach) {
  double sum = 0.0;
  for (const RoadRow& row : layout.rows) {
    const double h = row.height_m, dy = row.y_m - point_m.y;
    const double around = kRoadReach_heights * h + kLengthRounding_m;
    if (std::abs(dy) > around) continue;
    for_luminaires(row, layout.spacing_m, point_m.x - around, point_m.x + around, [&](double x) {
      const double dx = x - point_m.x, plan2 = dx * dx + dy * dy;
      if (reach == RoadReach::circle && plan2 > around * around) return;
      const double d2 = plan2 + h * h;
      sum += row.maintenance * row_intensity_cd(row, {-dx, -dy, -h}) * h / (d2 * std::sqrt(d2));
    });
  }
  return sum;
}

RoadVeiling road_veiling(const RoadLayout& layout, const glm::dvec3& eye_m) {
  static const double kSightX = calc::cos(radians_from_degrees(1.0));
  static const double kSightZ = -calc::sin(radians_from_degrees(1.0));
  static const double kTan20 = calc::tan(radians_from_degrees(20.0));
  // Of A, the age, in the terms of eyes that grow cloudy.
  static const double kWideAge = 1.0 + calc::pow(kAge / 66.4, 4.0);
  static const double kNarrowAge = 1.0 + calc::pow(kAge / 62.5, 4.0);
  RoadVeiling sum;
  for (const RoadRow& row : layout.rows) {
    const double dy = row.y_m - eye_m.y, dz = row.height_m - eye_m.z;
    for_luminaires(row, layout.spacing_m, eye_m.x, eye_m.x + kGlareAhead_m, [&](double x) {
      const double dx = x - eye_m.x;
      if (dx <= 0.0) return;
      const double plan = std::sqrt(dx * dx + dy * dy);
      // plan >= dx: what is above the elevation is above the plane too, not the other way round.
      if (dz > plan * kTan20) return;
      const glm::dvec3 to(dx, dy, dz), sight(kSightX, 0.0, kSightZ);
      const double d2 = glm::dot(to, to), along = glm::dot(to, sight);
      const glm::dvec3 across = glm::cross(to, sight);
      const double theta_deg =
          degrees_from_radians(calc::atan2(std::sqrt(glm::dot(across, across)), along));
      // Never below 0.1: the sight falls by 1 degree and luminaires are above the eye.
      if (theta_deg > 60.0 || theta_deg <= 0.1) return;
      const double eye_lx = row_intensity_cd(row, -to) * along / (d2 * std::sqrt(d2));
      const double theta2 = theta_deg * theta_deg;
      const double per_lx = theta_deg > 1.5
                                ? 9.86 * kWideAge / theta2
                                : 10.0 / (theta2 * theta_deg) + 5.0 * kNarrowAge / theta2;
      sum.by_elevation_cd_m2 += eye_lx * per_lx;
      if (!(dz > dx * kTan20)) sum.by_plane_cd_m2 += eye_lx * per_lx;
    });
  }
  return sum;
}

std::optional<double> threshold_increment_percent(double veiling_cd_m2, double average_cd_m2) {
  if (!(average_cd_m2 > kDarkest_cd_m2)) return std::nullopt;
  return average_cd_m2 <= kBrightRoad_cd_m2 ? 65.0 * veiling_cd_m2 / calc::pow(average_cd_m2, 0.8)
                                            : 95.0 * veiling_cd_m2 / calc::pow(average_cd_m2, 1.05);
}

RoadLight road_light(const RoadLayout& layout) {
  require_valid_road(layout);
  RoadLight light;
  light.grid = road_luminance_grid(layout);
  light.observers = observers_along_x(layout);
  if (std::find(layout.is_oncoming.begin(), layout.is_oncoming.end(), true) !=
      layout.is_oncoming.end()) {
    for (RoadObserver& observer : observers_along_x(half_turned(layout))) {
      observer.lane = layout.lanes - 1 - observer.lane;
      observer.is_oncoming = true;
      observer.eye_m.x = layout.spacing_m - observer.eye_m.x;
      observer.eye_m.y = layout.width_m - observer.eye_m.y;
      std::reverse(observer.cd_m2.begin(), observer.cd_m2.end());
      light.observers.push_back(std::move(observer));
    }
  }
  std::sort(light.observers.begin(), light.observers.end(),
            [](const RoadObserver& a, const RoadObserver& b) { return a.lane < b.lane; });
  if (layout.right_strip_m) light.right_ratio = edge_ratio(layout, 0.0, -*layout.right_strip_m);
  if (layout.left_strip_m)
    light.left_ratio = edge_ratio(layout, layout.width_m, *layout.left_strip_m);
  return light;
}

}  // namespace calc
