#include "report/tools/selftest/case.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli::selftest {
namespace {

std::string label_of(const Point& point) {
  const auto number = [](double x) { return fmt::format("{:.7g}", x + 0.0); };
  std::string text = fmt::format("({}, {}, {})", number(point.position_m.x),
                                 number(point.position_m.y), number(point.position_m.z));
  if (point.normal != kUp) {
    text += fmt::format(" facing ({}, {}, {})", fmt::format("{:.3g}", point.normal.x + 0.0),
                        fmt::format("{:.3g}", point.normal.y + 0.0),
                        fmt::format("{:.3g}", point.normal.z + 0.0));
  }
  return text;
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> list = {{"point", "Point sources"},
                                         {"area", "Area sources"},
                                         {"flux", "Flux conservation"},
                                         {"factor", "Form factors"},
                                         {"reflection", "Diffuse reflection"},
                                         {"shadow", "Obstruction, with and without reflection"},
                                         {"room", "Closed rooms: internally reflected component"},
                                         {"extreme", "Extremes"},
                                         {"files", "From project and photometry files"},
                                         {"refused", "Refused by design"}};
  return list;
}

std::vector<SelftestCase> all_cases() {
  std::vector<SelftestCase> all;
  for (auto* const part : {point_cases, area_cases, flux_cases, factor_cases, reflection_cases,
                           shadow_cases, room_cases, extreme_cases, files_cases, refused_cases}) {
    for (SelftestCase& item : part()) all.push_back(std::move(item));
  }
  return all;
}

void CaseResult::note(const Solution& solution) {
  rays += solution.rays;
  if (problem.empty()) problem = solution.problem;
}

void CaseResult::add_points(const Solution& solution, const std::vector<Point>& points,
                            const std::vector<double>& exact_lx, double known_to, double widest,
                            Part part) {
  note(solution);
  if (!solution.problem.empty()) return;
  std::vector<double> ratios;
  double ratios_known_to = known_to;
  int sampled = 0;
  // Where nothing arrives at all, the strip of an edge that rays blur is all that is sampled.
  constexpr double kDarkScale = 0.01;
  const double largest =
      exact_lx.empty() ? 0.0 : *std::max_element(exact_lx.begin(), exact_lx.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Measured m;
    m.what = i < labels.size() && !labels[i].empty() ? labels[i] : label_of(points[i]);
    m.exact = exact_lx[i];
    m.known_to = (known_to + (i < known_each.size() ? known_each[i] : 0.0)) * exact_lx[i];
    m.replicates = solution.replicates(i, part);
    if (m.exact == 0.0) m.scale = kDarkScale * largest;
    m.widest = i < widest_each.size() && widest_each[i] > 0.0 ? widest_each[i] : widest;
    if (m.replicates.size() > 1 && m.exact > 0.0) {
      ratios_known_to = std::max(ratios_known_to, m.known_to / m.exact);
      ++sampled;
      ratios.resize(m.replicates.size(), 0.0);
      for (std::size_t r = 0; r < ratios.size(); ++r) ratios[r] += m.replicates[r] / m.exact;
    }
    measured.push_back(std::move(m));
  }
  if (sampled < 2) return;
  for (double& ratio : ratios) ratio /= sampled;
  measured.push_back({fmt::format("mean of the {} ratios to the truth", sampled), "", 1.0,
                      ratios_known_to, std::move(ratios), widest});
}

void CaseResult::add_sum(const Solution& solution, const std::string& what, const std::string& unit,
                         const std::vector<double>& weights, double exact, double known_to,
                         double widest, Part part) {
  note(solution);
  if (!solution.problem.empty()) return;
  measured.push_back(
      {what, unit, exact, known_to * exact, solution.replicates(weights, part), widest});
}

}  // namespace cli::selftest
