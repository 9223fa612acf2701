#include "report/images/polar_diagram.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/photometry/web_measures.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace report {
namespace {

constexpr double kRadius = 230.0;  // of the outermost ring, pixels
constexpr double kSide = 56.0, kHeader = 56.0, kFooter = 52.0, kRim = 30.0;
constexpr double kDarkShare = 0.01;
constexpr double kFinest_rad = calc::kPi / 360.0;  // linear in gamma is no straight line here
constexpr std::size_t kTitleColumns = 66;

struct PlaneCurve {
  std::vector<double> angle_rad;  // signed gamma, -pi to pi
  std::vector<double> cd;
  double max_cd = 0.0;
};

void add_side(const calc::PhotometricWeb& web, double c_rad, double sign,
              const std::vector<double>& gammas, PlaneCurve& curve) {
  for (const double gamma : gammas) {
    const double cd = web.intensity_cd(c_rad, gamma);
    curve.angle_rad.push_back(sign * gamma);
    curve.cd.push_back(cd);
    curve.max_cd = std::max(curve.max_cd, cd);
  }
}

PlaneCurve plane_curve(const calc::PhotometricWeb& web, double c_rad) {
  std::vector<double> gammas;
  const std::vector<double> nodes = calc::measure_angles(web).gamma_rad;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double width = nodes[i + 1] - nodes[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(width / kFinest_rad)));
    for (int s = 0; s < steps; ++s) gammas.push_back(nodes[i] + width * s / steps);
  }
  gammas.push_back(nodes.back());
  std::vector<double> backwards(gammas.rbegin(), gammas.rend());
  PlaneCurve curve;
  add_side(web, c_rad + calc::kPi, -1.0, backwards, curve);
  add_side(web, c_rad, 1.0, gammas, curve);
  return curve;
}

// Highest intensity below (sign 1) or above (-1) the horizon.
double half_max_cd(const PlaneCurve& curve, double sign) {
  double highest = 0.0;
  for (std::size_t i = 0; i < curve.cd.size(); ++i) {
    if (sign * calc::cos(curve.angle_rad[i]) > 1.0e-9) highest = std::max(highest, curve.cd[i]);
  }
  return highest;
}

class Drawer {
 public:
  Drawer(const calc::PhotometricWeb& web, const std::string& title)
      : c0_(plane_curve(web, 0.0)), c90_(plane_curve(web, 0.5 * calc::kPi)) {
    const double highest = std::max(c0_.max_cd, c90_.max_cd);
    const double below = std::max(half_max_cd(c0_, 1.0), half_max_cd(c90_, 1.0));
    const double above = std::max(half_max_cd(c0_, -1.0), half_max_cd(c90_, -1.0));
    has_lower_ = below >= kDarkShare * highest || above <= below;
    has_upper_ = above >= kDarkShare * highest && above > 0.0;
    ring_cd_ = polar_ring_step(highest > 0.0 ? highest : 1.0);
    rings_ = std::max(1, static_cast<int>(std::ceil(highest / ring_cd_ - 1.0e-9)));
    drawing_.title = printable(title);
    drawing_.header = kHeader - 16.0;
    drawing_.width = 2.0 * (kRadius + kSide);
    centre_.x = 0.5 * drawing_.width;
    centre_.y = kHeader + (has_upper_ ? kRadius + kRim : kRim);
    drawing_.height = centre_.y + (has_lower_ ? kRadius + kRim : kRim) + kFooter;
  }

  PolarDrawing draw() {
    add_rings();
    add_rays();
    add_curve(c0_, PolarRole::c0_c180, false);
    add_curve(c90_, PolarRole::c90_c270, true);  // both show where they are equal
    add_ring_labels();
    add_header_and_legend();
    return std::move(drawing_);
  }

 private:
  // angle_rad: signed gamma; radius in pixels.
  PolarPoint at(double angle_rad, double radius) const {
    return {centre_.x + radius * calc::sin(angle_rad), centre_.y + radius * calc::cos(angle_rad)};
  }
  double pixels(double cd) const { return kRadius * cd / (ring_cd_ * rings_); }
  bool is_shown(double angle_rad) const {
    const double down = calc::cos(angle_rad);
    return (has_lower_ && down > -1.0e-9) || (has_upper_ && down < 1.0e-9);
  }

  void add_rings() {
    const double from = has_lower_ ? (has_upper_ ? -calc::kPi : -0.5 * calc::kPi) : 0.5 * calc::kPi;
    const double to = has_lower_ ? (has_upper_ ? calc::kPi : 0.5 * calc::kPi) : 1.5 * calc::kPi;
    constexpr int kSteps = 180;
    for (int ring = 1; ring <= rings_; ++ring) {
      PolarLine line{ring == rings_ ? PolarRole::frame : PolarRole::grid, 1.0, false, {}};
      for (int i = 0; i <= kSteps; ++i) {
        line.points.push_back(at(from + (to - from) * i / kSteps, kRadius * ring / rings_));
      }
      drawing_.lines.push_back(std::move(line));
    }
  }

  void add_rays() {
    for (int deg = -150; deg <= 180; deg += 30) {
      const double angle = calc::radians_from_degrees(deg);
      if (!is_shown(angle)) continue;
      const PolarRole role = deg == 90 || deg == -90 ? PolarRole::frame : PolarRole::grid;
      drawing_.lines.push_back({role, 1.0, false, {at(angle, 0.0), at(angle, kRadius)}});
      drawing_.labels.push_back({PolarRole::faint_text, at(angle, kRadius + 20.0),
                                 PolarLabel::Anchor::middle, format_fixed(std::abs(deg), 0) + "°",
                                 false});
    }
  }

  void add_curve(const PlaneCurve& curve, PolarRole role, bool dashed) {
    PolarLine line{role, 2.2, dashed, {}};
    for (std::size_t i = 0; i < curve.cd.size(); ++i) {
      if (is_shown(curve.angle_rad[i])) {
        line.points.push_back(at(curve.angle_rad[i], pixels(curve.cd[i])));
      }
    }
    drawing_.lines.push_back(std::move(line));
  }

  // On the horizon, where curves are rare; beside it in the half that is empty.
  void add_ring_labels() {
    const int every = rings_ > 3 ? 2 : 1;
    for (int ring = rings_; ring >= 1; ring -= every) {
      PolarPoint point = at(0.5 * calc::kPi, kRadius * ring / rings_);
      point.x -= 3.0;
      point.y += has_upper_ ? 10.0 : -9.0;
      drawing_.labels.push_back({PolarRole::faint_text, point, PolarLabel::Anchor::end,
                                 format_shortest(ring_cd_ * ring) + (ring == rings_ ? " cd" : ""),
                                 false});
    }
  }

  void add_header_and_legend() {
    drawing_.labels.push_back({PolarRole::text,
                               {centre_.x, 26.0},
                               PolarLabel::Anchor::middle,
                               shorten_start(drawing_.title, kTitleColumns),
                               true});
    const double y = drawing_.height - 26.0;
    const auto add = [&](double x, PolarRole role, bool dashed, const char* name, double max_cd) {
      drawing_.lines.push_back({role, 2.2, dashed, {{x, y}, {x + 34.0, y}}});
      drawing_.labels.push_back({PolarRole::text,
                                 {x + 42.0, y},
                                 PolarLabel::Anchor::start,
                                 std::string(name) + ", max " + format_cell(max_cd) + " cd",
                                 false});
    };
    add(30.0, PolarRole::c0_c180, false, "C0-C180", c0_.max_cd);
    add(centre_.x + 14.0, PolarRole::c90_c270, true, "C90-C270", c90_.max_cd);
  }

  PlaneCurve c0_, c90_;
  double ring_cd_ = 1.0;
  int rings_ = 1;
  bool has_lower_ = true, has_upper_ = false;
  PolarPoint centre_;
  PolarDrawing drawing_;
};

}  // namespace

double polar_ring_step(double highest) {
  double step = calc::pow(10.0, std::floor(calc::log10(highest)) - 1.0);
  for (const double factor : {2.0, 2.5, 2.0}) {  // 1, 2, 5, 10 ... of that power
    if (highest / step <= 6.0) return step;
    step *= factor;
  }
  while (highest / step > 6.0) step *= 2.0;
  return step;
}

PolarDrawing draw_polar_diagram(const calc::PhotometricWeb& web, const std::string& title) {
  return Drawer(web, title).draw();
}

}  // namespace report
