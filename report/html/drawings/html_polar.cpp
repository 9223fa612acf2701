#include "report/html/drawings/html_polar.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/html/page/html_markup.h"
#include "report/images/polar_diagram.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace report {
namespace {

constexpr double kSize = 132, kMiddle = 66, kRadius = 58;

std::string curve_path(const std::vector<double>& cd, double outer_cd) {
  std::string path;
  for (std::size_t i = 0; i < cd.size(); ++i) {
    const double gamma =
        calc::radians_from_degrees((static_cast<int>(i) - kPolarHalfSteps) * kPolarStep_deg);
    const double r = kRadius * cd[i] / outer_cd;
    path +=
        fmt::format("{}{} {}", path.empty() ? "M" : "L", svg_number(kMiddle + r * calc::sin(gamma)),
                    svg_number(kMiddle + r * calc::cos(gamma)));
  }
  return path;
}

}  // namespace

std::string html_polar(const Texts& t, const LuminaireRow& row) {
  double highest = 0.0;
  for (const auto* curve : {&row.c0_cd, &row.c90_cd}) {
    for (const double cd : *curve) highest = std::max(highest, cd);
  }
  if (!(highest > 0.0)) return {};
  const double step = polar_ring_step(highest);
  const int rings = std::max(1, static_cast<int>(std::ceil(highest / step - 1e-9)));
  std::string circles;
  for (int ring = 1; ring <= rings; ++ring) {
    circles += fmt::format("<circle cx=\"{0}\" cy=\"{0}\" r=\"{1}\"/>", kMiddle,
                           svg_number(kRadius * ring / rings));
  }
  const std::string ring = format_shortest(t, step * rings);
  return fmt::format(
      "<svg class=\"polar\" width=\"{0}\" height=\"{0}\" viewBox=\"0 0 {0} {0}\" role=\"img\" "
      "aria-label=\"{9}\"><g class=\"rings\">{2}<path "
      "d=\"M{3} {4}H{5}M{4} {3}V{5}\"/></g><path class=\"c90\" d=\"{6}\"/><path class=\"c0\" "
      "d=\"{7}\"/><text x=\"{5}\" y=\"{8}\" text-anchor=\"end\">{1} cd</text></svg>",
      kSize, ring, circles, svg_number(kMiddle - kRadius), kMiddle, svg_number(kMiddle + kRadius),
      curve_path(row.c90_cd, step * rings), curve_path(row.c0_cd, step * rings),
      svg_number(kSize - 3), t.say<Text::polar_diagram>(ring));
}

}  // namespace report
