#include "report/build/build_evidence.h"

#include "calc/base/units.h"
#include "calc/scene/luminaire_sums.h"
#include "rules/measure/derived_points.h"
#include "rules/measure/error_spending.h"
#include "rules/measure/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace report {
namespace {

using Levels = std::vector<std::pair<std::string, double>>;

// One value per point of the plane. Not for ratings and ratios, which are no illuminances.
rules::PointValues maintained(const calc::PlaneField& field, calc::DerivedQuantity derived,
                              const Levels& levels,
                              rules::LightParts parts = rules::LightParts::all) {
  rules::PointValues receivers =
      rules::combine_channels(field, rules::LightState::maintained, levels, parts);
  return derived == calc::DerivedQuantity::four_planes ? rules::mean_of_four_planes(receivers)
                                                       : receivers;
}

calc::Estimate statistic(const rules::PointValues& values, rules::Metric metric, double level) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto found = rules::compute_metric(values, metric, 0.0, std::nullopt, level);
  return found ? found->estimate : calc::Estimate{kNone, kNone, kNone};
}

double in_share_digits(double value) {
  const std::string text = fmt::format("{:.{}e}", value, kShareDigits - 1);
  double rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

std::vector<double> means_of_points(const rules::PointValues& values) {
  std::vector<double> means(values.points, 0.0);
  for (std::size_t point = 0; point < values.points; ++point) {
    for (std::size_t r = 0; r < values.replicates; ++r) means[point] += values.at(r, point);
    means[point] = in_share_digits(means[point] / static_cast<double>(values.replicates));
  }
  return means;
}

std::vector<std::string> groups_of(const calc::PlaneField& field) {
  std::vector<std::string> groups;
  for (const calc::LightChannel& channel : field.channels) {
    if (std::find(groups.begin(), groups.end(), channel.group) == groups.end())
      groups.push_back(channel.group);
  }
  return groups;
}

}  // namespace

std::vector<GroupShare> build_groups(const calc::PlaneField& field, calc::DerivedQuantity derived,
                                     double level) {
  if (calc::is_plain_number(derived)) return {};
  const std::vector<std::string> groups = groups_of(field);
  std::vector<GroupShare> shares;
  for (const std::string& group : groups) {
    Levels alone;
    for (const std::string& other : groups) alone.emplace_back(other, other == group ? 1.0 : 0.0);
    const rules::PointValues light = maintained(field, derived, alone);
    const rules::PointValues direct = maintained(field, derived, alone, rules::LightParts::direct);
    shares.push_back({group, statistic(light, rules::Metric::average, level),
                      statistic(direct, rules::Metric::average, level).value});
    if (groups.size() > 1 && groups.size() * light.points <= kMostShareValues)
      shares.back().point_lx = means_of_points(light);
  }
  return shares;
}

PlaneLook build_look(const calc::PlaneField& field, calc::DerivedQuantity derived,
                     const std::vector<rules::Finding>& findings, double confidence) {
  PlaneLook look;
  look.paths = field.counters.paths;
  look.rays =
      field.counters.direct_rays + field.counters.connection_rays + field.counters.near_rays;
  look.points =
      field.counters.active_points.empty() ? field.points : field.counters.active_points.back();
  const double level = rules::look_confidence(confidence, field);
  look.average = calc::is_plain_number(derived)
                     ? no_estimate()
                     : statistic(maintained(field, derived, {}), rules::Metric::average, level);
  for (const rules::Finding& finding : findings)
    look.findings.push_back({finding.verdict, finding.measured});
  return look;
}

std::vector<double> polar_curve(const calc::Project& project, const calc::LuminaireType& type,
                                double c_rad) {
  const calc::PhotometricWeb& web = project.webs[type.web];
  const auto intensity_cd = [&](double c, double gamma) {
    if (type.emitters.empty()) return type.flux_scale * web.intensity_cd(c, gamma);
    return calc::luminaire_intensity_cd(project, type, calc::direction_of({c, gamma}));
  };
  std::vector<double> cd;
  for (int step = -kPolarHalfSteps; step <= kPolarHalfSteps; ++step) {
    const double gamma = calc::radians_from_degrees(std::abs(step) * kPolarStep_deg);
    cd.push_back(intensity_cd(step < 0 ? c_rad + calc::kPi : c_rad, gamma));
  }
  return cd;
}

}  // namespace report
