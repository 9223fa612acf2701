#include "report/html/room/html_convergence.h"

#include "calc/base/elementary.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/svg.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace report {
namespace {

constexpr PlotFrame kConvergenceFrame{640, 300, 58, 30, 14, 44};
constexpr std::size_t kMostCurves = 600;

struct PlotPlace {
  double paths = 0.0, width = 0.0;  // width: half the interval over the value
};

struct Curve {
  std::vector<PlotPlace> places;
  std::optional<std::size_t> decided;  // look since which the verdict stands
  rules::Verdict verdict = rules::Verdict::not_judged;
  std::string words;
};

std::optional<PlotPlace> place_of(const PlaneLook& look, const calc::Estimate& estimate) {
  const double width = estimate.half_width() / std::abs(estimate.value);
  if (look.paths == 0 || !std::isfinite(width) || !(width > 0.0)) return std::nullopt;
  return PlotPlace{static_cast<double>(look.paths), width};
}

// The first look from which on the verdict is the last one, and that is a decision.
std::optional<std::size_t> decided_at(const PlanePart& plane, std::size_t finding) {
  const auto at = [&](std::size_t look) { return plane.looks[look].findings[finding].verdict; };
  std::size_t look = plane.looks.size() - 1;
  const rules::Verdict last = at(look);
  if (last != rules::Verdict::pass && last != rules::Verdict::fail) return std::nullopt;
  while (look > 0 && at(look - 1) == last) --look;
  return look;
}

Curve curve_of(const Texts& t, const SpacePart& space, const PlanePart& plane,
               std::optional<std::size_t> finding) {
  Curve curve;
  curve.words =
      plane_in_room(t, space, plane) + ", " +
      (finding ? quantity_words(t, plane.findings[*finding].requirement) : t[Text::average]);
  if (finding) {
    curve.verdict = plane.looks.back().findings[*finding].verdict;
    curve.decided = decided_at(plane, *finding);
  }
  std::optional<std::size_t> mark;
  for (std::size_t i = 0; i < plane.looks.size(); ++i) {
    const PlaneLook& look = plane.looks[i];
    const bool is_judged = finding && look.findings[*finding].verdict != rules::Verdict::not_judged;
    if (finding && !is_judged) continue;
    const auto place = place_of(look, finding ? look.findings[*finding].measured : look.average);
    if (!place) continue;
    if (curve.decided == i) mark = curve.places.size();
    curve.places.push_back(*place);
  }
  curve.decided = mark;
  return curve;
}

// All findings of a look list belong together: a file may say otherwise.
bool is_whole(const PlanePart& plane) {
  return !plane.looks.empty() &&
         std::all_of(plane.looks.begin(), plane.looks.end(), [&](const PlaneLook& look) {
           return look.findings.size() == plane.findings.size();
         });
}

std::vector<Curve> curves_of(const Texts& t, const ProjectPart& project) {
  std::vector<Curve> curves;
  const auto add = [&curves](Curve curve) {
    if (!curve.places.empty()) curves.push_back(std::move(curve));
  };
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      if (!is_whole(plane)) continue;
      for (std::size_t i = 0; i < plane.findings.size(); ++i) add(curve_of(t, space, plane, i));
      if (plane.findings.empty()) add(curve_of(t, space, plane, std::nullopt));
    }
  }
  return curves;
}

// Decades of error and powers of two of work, both logarithmic.
struct Frame {
  double low_paths = std::numeric_limits<double>::max(), high_paths = 0.0;
  double low_width = std::numeric_limits<double>::max(), high_width = 0.0;

  void add(const PlotPlace& place) {
    low_paths = std::min(low_paths, place.paths);
    high_paths = std::max(high_paths, place.paths);
    low_width = std::min(low_width, place.width);
    high_width = std::max(high_width, place.width);
  }
  void round() {
    low_width = calc::pow(10.0, std::floor(calc::log10(low_width) + 1e-9));
    high_width = calc::pow(10.0, std::ceil(calc::log10(high_width) - 1e-9));
    if (!(high_width > low_width)) high_width = 10.0 * low_width;
    if (!(high_paths > low_paths)) {
      low_paths /= 2.0;
      high_paths *= 2.0;
    }
  }
  double x(double paths) const {
    const double part = calc::log(paths / low_paths) / calc::log(high_paths / low_paths);
    return kConvergenceFrame.x(part);
  }
  double y(double width) const {
    const double part = calc::log(width / low_width) / calc::log(high_width / low_width);
    return kConvergenceFrame.y(part);
  }
};

std::string axes(const Texts& t, const Frame& frame) {
  std::string grid, text;
  for (double width = frame.low_width; width <= frame.high_width * 1.01; width *= 10.0) {
    grid += fmt::format("M{} {}H{}", kConvergenceFrame.left, svg_number(frame.y(width)),
                        kConvergenceFrame.x_end());
    text +=
        svg_text(kConvergenceFrame.left - 8, frame.y(width) + 4, "end", format_percent(t, width));
  }
  const double doublings = calc::log2(frame.high_paths / frame.low_paths);
  const double factor = calc::exp2(std::max(1.0, std::ceil(doublings / 6.0)));
  for (double paths = frame.low_paths; paths <= frame.high_paths * 1.01; paths *= factor) {
    grid += fmt::format("M{} {}V{}", svg_number(frame.x(paths)), kConvergenceFrame.top,
                        kConvergenceFrame.y_end());
    text += svg_text(frame.x(paths), kConvergenceFrame.y_end() + 17, "middle",
                     format_count(static_cast<std::uint64_t>(std::llround(paths))));
  }
  text += svg_text(0.5 * (kConvergenceFrame.left + kConvergenceFrame.x_end()),
                   kConvergenceFrame.height - 6, "middle", t[Text::paths_of_replicates]);
  return "<path class=\"lines\" d=\"" + grid + "\"/>" + text;
}

std::string curve_svg(const Frame& frame, const Curve& curve) {
  std::string path;
  for (const PlotPlace& place : curve.places) {
    path += fmt::format("{}{} {}", path.empty() ? "M" : "L", svg_number(frame.x(place.paths)),
                        svg_number(frame.y(place.width)));
  }
  const std::string_view tone = calc::name_of(curve.verdict);
  std::string svg = fmt::format("<g class=\"{}\"><path class=\"curve\" d=\"{}\"/>", tone, path);
  const std::size_t mark = curve.decided.value_or(curve.places.size() - 1);
  svg += fmt::format("<circle{} cx=\"{}\" cy=\"{}\" r=\"3.2\"><title>{}</title></circle></g>",
                     curve.decided ? "" : " class=\"open\"",
                     svg_number(frame.x(curve.places[mark].paths)),
                     svg_number(frame.y(curve.places[mark].width)), escape_html(curve.words));
  return svg;
}

}  // namespace

std::string html_convergence(const Texts& t, const ProjectPart& project) {
  const std::vector<Curve> curves = curves_of(t, project);
  if (curves.empty()) return {};
  const bool is_still = std::all_of(curves.begin(), curves.end(),
                                    [](const Curve& curve) { return curve.places.size() < 2; });
  if (is_still) return fmt::format("<p class=\"quiet\">{}</p>\n", t[Text::finished_at_first_look]);
  Frame frame;
  for (const Curve& curve : curves) {
    for (const PlotPlace& place : curve.places) frame.add(place);
  }
  frame.round();
  std::string lines;
  const std::size_t shown = std::min(curves.size(), kMostCurves);
  for (std::size_t i = 0; i < shown; ++i) lines += curve_svg(frame, curves[i]);
  const std::string left_out =
      shown < curves.size() ? " " + t.say<Text::shown_are_first>(shown, curves.size()) : "";
  return fmt::format(
      "<figure class=\"converge\"><svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "role=\"img\" aria-label=\"{2}\">{3}{4}</svg><figcaption>{5}{6}</figcaption></figure>\n",
      kConvergenceFrame.width, kConvergenceFrame.height,
      t.say<Text::converge_words>(curves.size(), format_percent(t, frame.high_width),
                                  format_percent(t, frame.low_width)),
      axes(t, frame), lines, t[Text::converge_caption], left_out);
}

std::string html_looks(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  if (!is_whole(plane)) return {};
  std::string head;
  for (const Text name : {Text::look, Text::light_paths, Text::rays, Text::points})
    head += fmt::format("<th scope=\"col\" class=\"num\">{}</th>", t[name]);
  for (const rules::Finding& finding : plane.findings)
    head += "<th scope=\"col\">" + escape_html(quantity_words(t, finding.requirement)) + "</th>";
  if (plane.findings.empty()) head += fmt::format("<th scope=\"col\">{}</th>", t[Text::average]);
  std::string rows;
  for (std::size_t i = 0; i < plane.looks.size(); ++i) {
    const PlaneLook& look = plane.looks[i];
    rows += fmt::format(
        "<tr><th scope=\"row\" class=\"num\">{}</th><td class=\"num\">{}</td><td "
        "class=\"num\">{}</td><td class=\"num\">{}</td>",
        i + 1, format_count(look.paths), format_count(look.rays), format_count(look.points));
    for (std::size_t f = 0; f < look.findings.size(); ++f) {
      const LookFinding& finding = look.findings[f];
      const rules::Requirement& requirement = plane.findings[f].requirement;
      const bool is_judged = finding.verdict != rules::Verdict::not_judged;
      rows += fmt::format(
          "<td>{} {}</td>", badge_of(t, requirement, finding.verdict),
          is_judged ? escape_html(measured_words(t, requirement, finding.measured)) : "");
    }
    if (plane.findings.empty())
      rows += "<td>" + format_measured(t, look.average, plane_unit(plane)) + "</td>";
    rows += "</tr>\n";
  }
  const std::string name = escape_html(plane_name(t, space, plane));
  const std::string title = t.say<Text::looks_at>(name);
  const std::size_t looks = plane.looks.size();
  return fmt::format(
      "<details class=\"grid\"><summary>{}</summary>\n{}</details>\n",
      looks == 1 ? t.say<Text::how_reached_one>(looks) : t.say<Text::how_reached>(looks),
      scroll_box(title, "<table class=\"looks\"><caption class=\"unseen\">" + title +
                            "</caption><thead><tr>" + head + "</tr></thead><tbody>\n" + rows +
                            "</tbody></table>"));
}

}  // namespace report
