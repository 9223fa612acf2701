#include "calc/photometry/web_measures.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace calc {
namespace {

constexpr double kSameIntensity = 1.0e-9;  // relative
constexpr int kUniformPlanes = 360, kUniformGammaSteps = 360;

bool is_pole(double gamma_rad) { return gamma_rad <= 0.0 || gamma_rad >= kPi; }

// So that equal angles from other frames are equal, and 2 pi is 0.
WebAngles without_rounding(const WebAngles& angles) {
  constexpr double kRounding_rad = 1.0e-12;
  const auto rounded = [](double rad) { return std::round(rad / kRounding_rad) * kRounding_rad; };
  const double c = rounded(angles.c_rad), gamma = rounded(angles.gamma_rad);
  return {c >= 2.0 * kPi - kRounding_rad ? 0.0 : c, gamma >= kPi - kRounding_rad ? kPi : gamma};
}

struct ProfilePoint {
  double angle_rad;  // signed gamma
  double cd;
};

// One plane from nadir to zenith. The jumps at the ends of the table are two points at one angle.
std::vector<ProfilePoint> half_profile(const PhotometricWeb& web, double c_rad,
                                       const std::vector<double>& gamma_rad) {
  std::vector<ProfilePoint> points;
  if (gamma_rad.front() > 0.0) {
    points.push_back({0.0, 0.0});
    points.push_back({gamma_rad.front(), 0.0});
  }
  for (const double gamma : gamma_rad) points.push_back({gamma, web.intensity_cd(c_rad, gamma)});
  if (gamma_rad.back() < kPi) {
    points.push_back({gamma_rad.back(), 0.0});
    points.push_back({kPi, 0.0});
  }
  return points;
}

// From -pi over nadir to pi; linear between the points.
std::vector<ProfilePoint> full_profile(const PhotometricWeb& web, double c_rad) {
  const std::vector<double> gamma_rad = measure_angles(web).gamma_rad;
  std::vector<ProfilePoint> points = half_profile(web, c_rad + kPi, gamma_rad);
  std::reverse(points.begin(), points.end());
  for (ProfilePoint& point : points) point.angle_rad = -point.angle_rad;
  for (const ProfilePoint& point : half_profile(web, c_rad, gamma_rad)) points.push_back(point);
  return points;
}

struct Arc {
  double from_rad, to_rad;
};

// Where the profile is at least threshold_cd, ascending; an arc over the zenith ends beyond pi.
std::vector<Arc> arcs_above(const std::vector<ProfilePoint>& profile, double threshold_cd) {
  std::vector<Arc> arcs;
  bool inside = profile.front().cd >= threshold_cd;
  double from = -kPi;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const ProfilePoint& a = profile[i];
    const ProfilePoint& b = profile[i + 1];
    if ((a.cd >= threshold_cd) == (b.cd >= threshold_cd)) continue;
    const double crossing =
        std::lerp(a.angle_rad, b.angle_rad, (threshold_cd - a.cd) / (b.cd - a.cd));
    if (inside) arcs.push_back({from, crossing});
    inside = !inside;
    from = crossing;
  }
  if (inside) arcs.push_back({from, kPi});
  if (arcs.size() > 1 && arcs.front().from_rad == -kPi && arcs.back().to_rad == kPi) {
    arcs.back().to_rad = arcs.front().to_rad + 2.0 * kPi;
    arcs.erase(arcs.begin());
  }
  return arcs;
}

double smallest_span(const std::vector<Arc>& arcs) {
  double widest_gap = arcs.front().from_rad + 2.0 * kPi - arcs.back().to_rad;
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i) {
    widest_gap = std::max(widest_gap, arcs[i + 1].from_rad - arcs[i].to_rad);
  }
  return 2.0 * kPi - widest_gap;
}

// Of equal values the one furthest towards the positive side.
ProfilePoint highest(const std::vector<ProfilePoint>& profile) {
  ProfilePoint best = profile.front();
  for (const ProfilePoint& point : profile) {
    if (point.cd >= best.cd * (1.0 - kSameIntensity)) {
      best = {point.angle_rad, std::max(point.cd, best.cd)};
    }
  }
  return best;
}

// The running integral of values that are linear between their places.
class LinearIntegral {
 public:
  // place: ascending, at least two.
  LinearIntegral(std::vector<double> place, std::vector<double> value)
      : place_(std::move(place)), value_(std::move(value)), up_to_(place_.size(), 0.0) {
    for (std::size_t i = 1; i < place_.size(); ++i) {
      up_to_[i] = up_to_[i - 1] + 0.5 * (value_[i - 1] + value_[i]) * (place_[i] - place_[i - 1]);
    }
  }
  // From the first place on; beyond the ends there is nothing.
  double up_to(double x) const {
    if (x <= place_.front()) return 0.0;
    if (x >= place_.back()) return up_to_.back();
    const std::size_t i = interval_of(place_, x);
    const double along_rad = x - place_[i];
    const double slope = (value_[i + 1] - value_[i]) / (place_[i + 1] - place_[i]);
    return up_to_[i] + along_rad * (value_[i] + 0.5 * slope * along_rad);
  }

 private:
  std::vector<double> place_, value_, up_to_;
};

constexpr double kTimesMean = 2.5;
// What is weaker is no beam: most files have single angles of some hundredths beside dark ones.
constexpr double kBeamOfMost = 0.05;

// Whether no light along this line is more than kTimesMean times its mean over reach_rad to either
// side, between the ends of the line.
bool is_wide_along(const LinearIntegral& line, const std::vector<double>& place_rad,
                   const std::vector<double>& cd, double least_cd, double reach_rad,
                   double first_rad, double last_rad) {
  for (std::size_t i = 0; i < place_rad.size(); ++i) {
    if (!(cd[i] > least_cd)) continue;
    const double from = std::max(first_rad, place_rad[i] - reach_rad);
    const double to = std::min(last_rad, place_rad[i] + reach_rad);
    if (cd[i] * (to - from) > kTimesMean * (line.up_to(to) - line.up_to(from))) return false;
  }
  return true;
}

// The table's lines along gamma, and its circles.
class TableLines {
 public:
  explicit TableLines(const PhotometricWeb& web) : gamma_rad_(web.gamma_rad()) {
    const std::size_t planes = web.c_rad().size();
    for (std::size_t p = 0; p < planes; ++p) {
      std::vector<double> cd;
      for (std::size_t g = 0; g < gamma_rad_.size(); ++g) cd.push_back(web.table_cd(p, g));
      along_gamma_.push_back({LinearIntegral(gamma_rad_, cd), cd});
    }
    least_cd_ = kBeamOfMost * web.max_intensity_cd();
    if (web.is_axial()) return;
    c_rad_ = web.c_rad();
    // Three times around, so that every reach lies within.
    std::vector<double> around_rad;
    for (const double turn : {-1.0, 0.0, 1.0}) {
      for (std::size_t p = 0; p + 1 < planes; ++p)
        around_rad.push_back(c_rad_[p] + turn * 2.0 * kPi);
    }
    around_rad.push_back(4.0 * kPi);
    for (std::size_t g = 0; g < gamma_rad_.size(); ++g) {
      std::vector<double> cd, around_cd;
      for (std::size_t p = 0; p < planes; ++p) cd.push_back(web.table_cd(p, g));
      for (std::size_t k = 0; k + 1 < around_rad.size(); ++k) {
        around_cd.push_back(cd[k % (planes - 1)]);
      }
      around_cd.push_back(cd.front());
      along_c_.push_back({LinearIntegral(around_rad, std::move(around_cd)), cd});
    }
  }

  bool are_wide(double reach_rad) const {
    for (const Line& line : along_gamma_) {
      if (!is_wide_along(line.sum, gamma_rad_, line.cd, least_cd_, reach_rad, 0.0, kPi)) {
        return false;
      }
    }
    for (std::size_t g = 0; g < along_c_.size(); ++g) {
      const double reach_c_rad = reach_rad / std::max(1.0e-9, calc::sin(gamma_rad_[g]));
      if (reach_c_rad >= 0.5 * kPi) continue;  // the circle is no longer than what is looked at
      const Line& line = along_c_[g];
      if (!is_wide_along(line.sum, c_rad_, line.cd, least_cd_, reach_c_rad, -2.0 * kPi,
                         4.0 * kPi)) {
        return false;
      }
    }
    return true;
  }

 private:
  struct Line {
    LinearIntegral sum;
    std::vector<double> cd;
  };
  std::vector<double> gamma_rad_, c_rad_;
  std::vector<Line> along_gamma_, along_c_;
  double least_cd_ = 0.0;
};

}  // namespace

bool has_c_gamma_table(const PhotometricWeb& web) {
  const double tolerance_cd = kSameIntensity * web.max_intensity_cd();
  for (std::size_t p = 0; p < web.c_rad().size(); ++p) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) {
      if (is_pole(web.gamma_rad()[g])) continue;
      const double cd = web.intensity_cd(web.c_rad()[p], web.gamma_rad()[g]);
      if (!(std::abs(cd - web.table_cd(p, g)) <= tolerance_cd)) return false;
    }
  }
  return true;
}

MeasureAngles measure_angles(const PhotometricWeb& web) {
  if (has_c_gamma_table(web)) {
    MeasureAngles angles{web.c_rad(), web.gamma_rad()};
    if (angles.c_rad.size() > 1) angles.c_rad.pop_back();  // 2 pi is 0 again
    return angles;
  }
  MeasureAngles angles;
  for (int i = 0; i < kUniformPlanes; ++i) angles.c_rad.push_back(2.0 * kPi * i / kUniformPlanes);
  for (int i = 0; i <= kUniformGammaSteps; ++i) {
    angles.gamma_rad.push_back(kPi * i / kUniformGammaSteps);
  }
  return angles;
}

Peak peak_of(const PhotometricWeb& web) {
  Peak peak;
  const auto consider = [&](double cd, double c_rad, double gamma_rad) {
    const double tolerance_cd = peak.intensity_cd * kSameIntensity;
    if (cd < peak.intensity_cd - tolerance_cd) return;
    const double c = is_pole(gamma_rad) ? 0.0 : c_rad;
    const bool is_first = std::pair(gamma_rad, c) < std::pair(peak.gamma_rad, peak.c_rad);
    if (cd > peak.intensity_cd + tolerance_cd || is_first) peak = {cd, c, gamma_rad};
  };
  if (!has_c_gamma_table(web)) {  // between the angles of its own table a web has no peak
    for (const double c : web.c_rad()) {
      for (const double gamma : web.gamma_rad()) {
        const std::array<double, 3> direction = web.from_table(direction_of({c, gamma}));
        const WebAngles angles = without_rounding(angles_of(direction));
        consider(web.intensity_cd(direction), angles.c_rad, angles.gamma_rad);
      }
    }
    return peak;
  }
  const MeasureAngles angles = measure_angles(web);
  for (const double gamma : angles.gamma_rad) {
    for (const double c : angles.c_rad) consider(web.intensity_cd(c, gamma), c, gamma);
  }
  return peak;
}

BeamWidth beam_width(const PhotometricWeb& web, double c_rad, double share) {
  const std::vector<ProfilePoint> profile = full_profile(web, c_rad);
  const ProfilePoint top = highest(profile);
  if (!(top.cd > 0.0)) return {};
  const std::vector<Arc> arcs = arcs_above(profile, share * top.cd);
  if (arcs.empty()) return {};  // a share of 1 next to rounding
  BeamWidth width;
  width.lobes = static_cast<int>(arcs.size());
  width.span_rad = smallest_span(arcs);
  for (const Arc& arc : arcs) {
    const bool holds_top = (arc.from_rad <= top.angle_rad && top.angle_rad <= arc.to_rad) ||
                           top.angle_rad + 2.0 * kPi <= arc.to_rad;
    if (!holds_top) continue;
    width.lobe_rad = arc.to_rad - arc.from_rad;
    width.from_rad = arc.from_rad;
    width.to_rad = arc.to_rad;
  }
  return width;
}

SymmetryFit symmetry_fit(const PhotometricWeb& web) {
  SymmetryFit fit;
  if (web.is_axial() && has_c_gamma_table(web)) return fit;
  const MeasureAngles angles = measure_angles(web);
  for (const double gamma : angles.gamma_rad) {
    double lowest = web.max_intensity_cd();
    double highest_cd = 0.0;
    for (const double c : angles.c_rad) {
      const double cd = web.intensity_cd(c, gamma);
      lowest = std::min(lowest, cd);
      highest_cd = std::max(highest_cd, cd);
      fit.c0_c180 = std::max(fit.c0_c180, std::abs(cd - web.intensity_cd(-c, gamma)));
      fit.c90_c270 = std::max(fit.c90_c270, std::abs(cd - web.intensity_cd(kPi - c, gamma)));
    }
    fit.axial = std::max(fit.axial, highest_cd - lowest);
  }
  fit.axial /= web.max_intensity_cd();
  fit.c0_c180 /= web.max_intensity_cd();
  fit.c90_c270 /= web.max_intensity_cd();
  return fit;
}

PlaneSymmetry symmetry_within(const SymmetryFit& fit, double share) {
  if (fit.axial <= share) return PlaneSymmetry::axial;
  if (fit.c0_c180 <= share && fit.c90_c270 <= share) return PlaneSymmetry::quadrant;
  if (fit.c0_c180 <= share) return PlaneSymmetry::c0_c180;
  return fit.c90_c270 <= share ? PlaneSymmetry::c90_c270 : PlaneSymmetry::none;
}

double narrowest_beam_rad(const PhotometricWeb& web) {
  const TableLines lines(web);
  if (lines.are_wide(kTimesMean * kWideBeam_rad)) return std::numeric_limits<double>::infinity();
  constexpr double kFinest_rad = 0.5 * kPi / 180.0;
  double width_rad = kWideBeam_rad;
  do {
    width_rad *= 0.75;
  } while (width_rad > kFinest_rad && !lines.are_wide(kTimesMean * width_rad));
  return std::max(width_rad, kFinest_rad);
}

double downward_share(const PhotometricWeb& web) {
  return std::clamp(web.zonal_flux_lm(0.0, 0.5 * kPi) / web.flux_lm(), 0.0, 1.0);
}

}  // namespace calc
