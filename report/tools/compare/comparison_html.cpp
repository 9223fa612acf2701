#include "report/html/html_markup.h"
#include "report/html/html_revision.h"
#include "report/html/html_style.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/svg.h"
#include "report/tools/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

constexpr const char* kComparisonStyle = R"css(
.scatter { display: block; width: 100%; max-width: 46rem; height: auto; }
.scatter text { font-size: 12px; fill: var(--quiet); }
.scatter .rule { stroke: var(--line); } .scatter .zero { stroke: var(--quiet); }
.scatter .bar { stroke: var(--link); stroke-opacity: .35; }
.scatter .dot { fill: var(--link); } .scatter .beyond { fill: var(--fail); }
)css";

constexpr PlotFrame kScatterFrame{700, 300, 62, 12, 12, 40};

std::string percent(double share) { return with_minus(signed_percent(share)); }

double share_of(const ComparedPoint& p, double lx) { return p.b.lx > 0.0 ? lx / p.b.lx : 0.0; }

// Difference in per cent of B over B, with combined intervals.
std::string scatter(const ComparedPlane& plane, const Comparison& comparison) {
  double low = 1e300, high = 0.0, most = 1e-6;
  for (const ComparedPoint& p : plane.points) {
    low = std::min(low, p.b.lx);
    high = std::max(high, p.b.lx);
    most = std::max(most, std::min(1.0, std::abs(share_of(p, p.difference_lx())) +
                                            share_of(p, p.interval_lx())));
  }
  if (!(high > low)) low = 0.5 * high;
  if (!(high > 0.0)) return "";
  most *= 1.08;
  const auto x = [&](double lx) {
    return kScatterFrame.x(0.02 + 0.96 * (lx - low) / (high - low));
  };
  const auto y = [&](double share) {
    const double inside = std::clamp(share, -most, most);
    return kScatterFrame.y(0.5 * (1.0 + inside / most));
  };
  std::string svg = fmt::format(
      "<svg class=\"scatter\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"Difference of A "
      "and "
      "B in per cent of B, over B\">\n",
      kScatterFrame.width, kScatterFrame.height);
  for (const double tick : round_ticks(-100.0 * most, 100.0 * most, 7)) {
    const double at = y(tick / 100.0);
    svg += fmt::format("<path class=\"{}\" d=\"M{},{}H{}\"/>\n", tick == 0.0 ? "zero" : "rule",
                       svg_number(kScatterFrame.left), svg_number(at),
                       svg_number(kScatterFrame.x_end()));
    svg += svg_text(kScatterFrame.left - 6, at + 4, "end",
                    (tick > 0.0 ? "+" : "") + with_minus(format_shortest(tick)) + " %") +
           "\n";
  }
  for (const double lx : round_ticks(low, high, 8)) {
    svg += fmt::format("<path class=\"zero\" d=\"M{},{}v4\"/>\n", svg_number(x(lx)),
                       svg_number(kScatterFrame.y_end()));
    svg += svg_text(x(lx), kScatterFrame.y_end() + 16, "middle", format_shortest(lx)) + "\n";
  }
  svg += svg_text(0.5 * kScatterFrame.width, kScatterFrame.height - 6, "middle", "B, lx") + "\n";
  for (const ComparedPoint& p : plane.points) {
    const double d = share_of(p, p.difference_lx()), h = share_of(p, p.interval_lx());
    if (std::isnan(d) || std::isnan(h)) continue;
    const bool is_beyond =
        std::abs(p.difference_lx()) >
        comparison.widening * p.interval_lx() + (comparison.tolerance + 1e-9) * std::abs(p.b.lx);
    if (h > 0.0) {
      svg += fmt::format("<path class=\"bar\" d=\"M{0},{1}V{2}\"/>", svg_number(x(p.b.lx)),
                         svg_number(y(d - h)), svg_number(y(d + h)));
    }
    svg +=
        fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"3\"><title>{}</title></circle>\n",
                    is_beyond ? "beyond" : "dot", svg_number(x(p.b.lx)), svg_number(y(d)),
                    escape_html(fmt::format("{}: {:.5g} and {:.5g} lx",
                                            format_position(p.position_m), p.a.lx, p.b.lx)));
  }
  return svg + "</svg>\n";
}

std::string plane_html(const ComparedPlane& plane, const Comparison& comparison,
                       std::size_t worst) {
  std::string html = "<h2>Plane " + escape_html(plane.id) + "</h2>\n" + scatter(plane, comparison);
  html += "<table>\n" + fact("Points", std::to_string(plane.points.size())) +
          fact("Average of A", fmt::format("{:.5g} lx", plane.average_a_lx)) +
          fact("Average of B", fmt::format("{:.5g} lx", plane.average_b_lx)) +
          fact("Mean difference, of B's average", percent(plane.bias)) +
          fact("Average", !plane.average_interval_lx() ? "not judged: its interval is not known"
                          : plane.is_average_beyond    ? "beyond what is allowed"
                                                       : "within what is allowed") +
          fact("RMS difference, of B's average", percent(plane.rms).substr(1)) +
          fact("Uo of A and B", fmt::format("{:.3f}, {:.3f}", plane.uo_a, plane.uo_b)) +
          fact("Within the combined interval",
               fmt::format("{} of {}", plane.held, plane.points.size())) +
          fact("Beyond what is allowed", std::to_string(plane.beyond)) + "</table>\n";
  if (worst == 0) return html;
  html +=
      "<h3>Furthest apart</h3>\n<table><thead><tr><th>Point, m</th><th class=\"num\">A, lx</th>"
      "<th class=\"num\">B, lx</th><th class=\"num\">difference</th><th class=\"num\">combined "
      "interval, lx</th></tr></thead><tbody>\n";
  for (const std::size_t i : worst_points(plane, worst)) {
    const ComparedPoint& p = plane.points[i];
    html += fmt::format(
        "<tr><td>{}</td><td class=\"num\">{:.5g}</td><td class=\"num\">{:.5g}</td>"
        "<td class=\"num\">{}</td><td class=\"num\">±{:.2g}</td></tr>\n",
        escape_html(format_position(p.position_m)), p.a.lx, p.b.lx,
        p.b.lx != 0.0 ? percent(p.difference_lx() / p.b.lx) : "–", p.interval_lx());
  }
  return html + "</tbody></table>\n";
}

}  // namespace

std::string render_comparison_html(const Comparison& comparison, std::size_t worst) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\"/>\n<title>Comparison</title>\n<style>\n" +
      html_style() + kComparisonStyle +
      "</style>\n</head>\n<body>\n<p class=\"eyebrow\">luxgate compare</p>\n";
  const std::string headline = comparison_headline(comparison);
  html += fmt::format(
      "<h1>{}</h1>\n<p class=\"quiet\">A: {}<br/>B: {}<br/>{} of {} points and {} of {} averages "
      "are "
      "beyond what is allowed</p>\n",
      escape_html(headline), escape_html(comparison.name_a), escape_html(comparison.name_b),
      comparison.beyond(), comparison.points(), comparison.averages_beyond(),
      comparison.averages_judged());
  if (comparison.revised) html += html_revision({}, *comparison.revised);
  for (const std::string& note : comparison.notes) {
    html += "<p class=\"message\">" + escape_html(note) + "</p>\n";
  }
  for (const ComparedPlane& plane : comparison.planes) html += plane_html(plane, comparison, worst);
  return html + "</body>\n</html>\n";
}

}  // namespace report
