#include "report/html/chapters/html_revision.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/html_tool_page.h"
#include "report/text/markup.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"
#include "report/tools/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

constexpr const char* kComparisonStyle = R"css(
.pair { display: grid; grid-template-columns: auto 1fr; gap: .1rem .8rem; margin: .3rem 0 0; font-size: .9rem; }
.allowed { margin-top: .8rem; }
.pair dt { font-weight: 650; } .pair dd { margin: 0; color: var(--quiet); overflow-wrap: anywhere; }
.compared { display: grid; grid-template-columns: minmax(0, 1.5fr) minmax(0, 1fr); gap: 1.2rem 2.4rem; align-items: start; }
.compared .facts tbody th { white-space: normal; width: auto; }
.scatter { display: block; width: 100%; height: auto; font-family: inherit; }
.scatter text { font-size: 12px; fill: var(--quiet); }
.scatter .rule { stroke: var(--line); } .scatter .zero { stroke: var(--quiet); }
.scatter .bar { stroke: var(--link); stroke-opacity: .35; }
.scatter .dot { fill: var(--link); } .scatter .beyond { fill: var(--fail); }
.scatter-key { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.4rem; margin: .4rem 0 0; padding: 0; font-size: .85rem; color: var(--quiet); }
.scatter-key svg { width: 1rem; height: 1rem; vertical-align: -.15rem; margin-right: .35rem; }
@media screen and (max-width: 50rem) { .compared { grid-template-columns: minmax(0, 1fr); } .scatter text { font-size: 17px; } }
@media print {
  .compared { gap: 4mm; } .compared figure { margin: 0; }
  .compared, .furthest { break-inside: avoid; } h2 { break-after: avoid; margin-top: 6mm; }
}
)css";

constexpr PlotFrame kScatterFrame{700, 330, 84, 14, 14, 46};
// Differences beyond are drawn at the edge.
constexpr double kMostDrawn = 1.0;

std::string percent(const Texts& t, double share) {
  return t.number(with_minus(signed_percent(share)));
}

std::string digits(const Texts& t, double value) {
  return std::isfinite(value) ? t.number(with_minus(fmt::format("{:.5g}", value))) : "–";
}

double share_of(const ComparedPoint& p, double lx) { return p.b.lx > 0.0 ? lx / p.b.lx : 0.0; }

struct Scatter {
  std::string svg;            // "" where there is nothing to draw
  std::size_t off_scale = 0;  // points at the edge
  bool has_beyond = false;
};

bool is_beyond(const ComparedPoint& p, const Comparison& comparison) {
  return std::abs(p.difference_lx()) >
         comparison.widening * p.interval_lx() + (comparison.tolerance + 1e-9) * std::abs(p.b.lx);
}

// Difference in per cent of B over B, with combined intervals.
Scatter scatter(const Texts& t, const ComparedPlane& plane, const Comparison& comparison) {
  double low = 1e300, high = 0.0, most = 1e-6;
  for (const ComparedPoint& p : plane.points) {
    if (std::isnan(p.difference_lx()) || std::isnan(p.interval_lx())) continue;
    low = std::min(low, p.b.lx);
    high = std::max(high, p.b.lx);
    most = std::max(most, std::min(kMostDrawn, std::abs(share_of(p, p.difference_lx())) +
                                                   share_of(p, p.interval_lx())));
  }
  if (!(high > 0.0)) return {};
  if (!(high > low)) low = 0.5 * high;
  most *= 1.08;
  const auto x = [&](double lx) {
    return kScatterFrame.x(0.02 + 0.96 * (lx - low) / (high - low));
  };
  const auto y = [&](double share) {
    const double inside = std::clamp(share, -most, most);
    return kScatterFrame.y(0.5 * (1.0 + inside / most));
  };
  Scatter drawing;
  std::string& svg = drawing.svg;
  svg = fmt::format(
      "<svg class=\"scatter\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\">\n",
      kScatterFrame.width, kScatterFrame.height, t[Text::compare_drawing]);
  for (const double tick : round_ticks(-100.0 * most, 100.0 * most, 7)) {
    const double at = y(tick / 100.0);
    svg += fmt::format("<path class=\"{}\" d=\"M{},{}H{}\"/>\n", tick == 0.0 ? "zero" : "rule",
                       svg_number(kScatterFrame.left), svg_number(at),
                       svg_number(kScatterFrame.x_end()));
    svg += svg_text(kScatterFrame.left - 6, at + 4, "end",
                    (tick > 0.0 ? "+" : "") + with_minus(format_shortest(t, tick)) + " %") +
           "\n";
  }
  for (const double lx : round_ticks(low, high, 8)) {
    svg += fmt::format("<path class=\"zero\" d=\"M{},{}v4\"/>\n", svg_number(x(lx)),
                       svg_number(kScatterFrame.y_end()));
    svg += svg_text(x(lx), kScatterFrame.y_end() + 18, "middle", format_shortest(t, lx)) + "\n";
  }
  const double middle = 0.5 * (kScatterFrame.left + kScatterFrame.x_end());
  svg += svg_text(middle, kScatterFrame.height - 5, "middle", "B, lx") + "\n";
  svg += fmt::format("<g transform=\"rotate(-90 14 {0})\">{1}</g>\n", svg_number(y(0.0)),
                     svg_text(14, y(0.0) + 4, "middle", t[Text::compare_axis]));
  for (const ComparedPoint& p : plane.points) {
    const double d = share_of(p, p.difference_lx()), h = share_of(p, p.interval_lx());
    if (std::isnan(d) || std::isnan(h)) continue;
    const bool beyond = is_beyond(p, comparison);
    drawing.has_beyond = drawing.has_beyond || beyond;
    if (std::abs(d) > most) ++drawing.off_scale;
    if (h > 0.0) {
      svg += fmt::format("<path class=\"bar\" d=\"M{0},{1}V{2}\"/>", svg_number(x(p.b.lx)),
                         svg_number(y(d - h)), svg_number(y(d + h)));
    }
    svg +=
        fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"3\"><title>{}</title></circle>\n",
                    beyond ? "beyond" : "dot", svg_number(x(p.b.lx)), svg_number(y(d)),
                    escape_html(t.say<Text::compare_point>(format_position(t, p.position_m),
                                                           digits(t, p.a.lx), digits(t, p.b.lx))));
  }
  svg += "</svg>\n";
  return drawing;
}

std::string key_item(const char* kind, const char* words) {
  return fmt::format(
      "<li><svg class=\"scatter\" viewBox=\"0 0 16 16\" aria-hidden=\"true\"><path class=\"bar\" "
      "d=\"M8,1V15\"/><circle class=\"{}\" cx=\"8\" cy=\"8\" r=\"3\"/></svg>{}</li>",
      kind, words);
}

std::string figure(const Texts& t, const ComparedPlane& plane, const Comparison& comparison) {
  const Scatter drawing = scatter(t, plane, comparison);
  if (drawing.svg.empty()) return "";
  std::string html = "<figure>\n" + drawing.svg + "<ul class=\"scatter-key\">" +
                     key_item("dot", t[Text::compare_key_within]);
  if (drawing.has_beyond) html += key_item("beyond", t[Text::compare_is_beyond]);
  html += "</ul>\n";
  if (drawing.off_scale > 0) {
    html += fmt::format("<p class=\"quiet\">{}</p>\n",
                        t.say<Text::compare_off_scale>(drawing.off_scale));
  }
  return html + "</figure>\n";
}

std::string facts(const Texts& t, const ComparedPlane& plane) {
  const Text judged = !plane.average_interval_lx() ? Text::compare_not_judged
                      : plane.is_average_beyond    ? Text::compare_is_beyond
                                                   : Text::compare_is_within;
  // Ratios: no average, no number.
  const auto uo = [&](double value) { return format_fixed(t, value, 3); };
  return fmt::format("<table class=\"facts\"><caption class=\"unseen\">{}</caption><tbody>\n",
                     escape_html(t.say<Text::compare_plane>(plane.id))) +
         fact(t[Text::points], std::to_string(plane.points.size())) +
         fact(t[Text::compare_of_a], digits(t, plane.average_a_lx) + " lx") +
         fact(t[Text::compare_of_b], digits(t, plane.average_b_lx) + " lx") +
         fact(t[Text::compare_bias], percent(t, plane.bias)) +
         fact(t[Text::compare_average], t[judged]) +
         fact(t[Text::compare_rms], t.number(signed_percent(plane.rms).substr(1))) +
         fact(t[Text::compare_uo], uo(plane.uo_a) + "; " + uo(plane.uo_b)) +
         fact(t[Text::compare_held], t.say<Text::so_many_of>(plane.held, plane.points.size())) +
         fact(t[Text::compare_beyond], std::to_string(plane.beyond)) + "</tbody></table>\n";
}

std::string furthest(const Texts& t, const ComparedPlane& plane, std::size_t worst) {
  if (worst == 0) return "";
  std::string rows;
  for (const std::size_t i : worst_points(plane, worst)) {
    const ComparedPoint& p = plane.points[i];
    const double interval_lx = p.interval_lx();
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num\">{}</td>"
        "<td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
        escape_html(format_position(t, p.position_m)), digits(t, p.a.lx), digits(t, p.b.lx),
        p.b.lx != 0.0 ? percent(t, p.difference_lx() / p.b.lx) : "–",
        std::isfinite(interval_lx) ? "±" + t.number(fmt::format("{:.2g}", interval_lx)) : "–");
  }
  const auto head = [](const char* words) {
    return fmt::format("<th scope=\"col\" class=\"num\">{}</th>", words);
  };
  const std::string table =
      fmt::format(
          "<table><caption class=\"unseen\">{}</caption><thead><tr><th scope=\"col\">{}</th>",
          t[Text::compare_furthest], t[Text::position_m]) +
      head("A, lx") + head("B, lx") + head(t[Text::compare_axis]) +
      head(t[Text::compare_combined_lx]) + "</tr></thead><tbody>\n" + rows + "</tbody></table>";
  return fmt::format("<div class=\"furthest\"><h3>{}</h3>\n", t[Text::compare_furthest]) +
         scroll_box(
             escape_html(t.say<Text::compare_plane>(plane.id)) + ": " + t[Text::compare_furthest],
             table) +
         "</div>\n";
}

std::string plane_html(const Texts& t, const ComparedPlane& plane, const Comparison& comparison,
                       std::size_t worst) {
  return fmt::format("<section><h2>{}</h2>\n<div class=\"compared\">\n",
                     escape_html(t.say<Text::compare_plane>(plane.id))) +
         figure(t, plane, comparison) + facts(t, plane) + "</div>\n" + furthest(t, plane, worst) +
         "</section>\n";
}

const char* headline(const Texts& t, const Comparison& comparison) {
  if (comparison.is_alike()) return t[Text::compare_alike];
  if (comparison.are_values_alike()) return t[Text::compare_otherwise];
  return t[comparison.lacks > 0 ? Text::compare_lacks : Text::compare_different];
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::string banner(const Texts& t, const Comparison& comparison) {
  const bool is_alike = comparison.is_alike();
  const std::string level = format_percent(t, comparison.confidence);
  const std::string widening = format_fixed(t, comparison.widening, 2);
  return fmt::format(
      "<section class=\"banner {}\" id=\"outcome\"><span class=\"seal\" "
      "aria-hidden=\"true\">{}</span>"
      "<div><p class=\"outcome\">{}</p><p>{}</p></div></section>\n<p class=\"quiet "
      "allowed\">{}</p>\n",
      is_alike ? "pass" : "fail", is_alike ? "✓" : "✗", headline(t, comparison),
      t.say<Text::compare_beyond_points>(comparison.beyond(), comparison.points(),
                                         comparison.averages_beyond(),
                                         comparison.averages_judged()),
      comparison.tolerance > 0.0 ? t.say<Text::compare_allowed_tolerance>(
                                       level, widening, format_percent(t, comparison.tolerance))
                                 : t.say<Text::compare_allowed>(level, widening));
}

}  // namespace

std::string render_comparison_html(const Comparison& comparison, std::size_t worst, const Texts& t,
                                   Paper paper) {
  ToolPage page;
  page.title = escape_html(file_name(comparison.name_a) + " – " + file_name(comparison.name_b));
  page.eyebrow = t[Text::compare_title];
  page.style = kComparisonStyle;
  page.foot = file_name(comparison.name_a) + " · " + file_name(comparison.name_b);
  page.paper = paper;
  std::string html = tool_page_start(t, page);
  html += fmt::format(
      "<dl class=\"pair\"><dt>A</dt><dd>{}</dd><dt>B</dt><dd>{}</dd></dl>\n</header>\n"
      "<main id=\"main\">\n",
      escape_html(comparison.name_a), escape_html(comparison.name_b));
  html += banner(t, comparison);
  if (comparison.revised) html += html_revision(t, *comparison.revised);
  for (const std::string& note : comparison.notes) {
    html += "<p class=\"message\">" + t.english_html(escape_html(note)) + "</p>\n";
  }
  for (const ComparedPlane& plane : comparison.planes) {
    html += plane_html(t, plane, comparison, worst);
  }
  return html + tool_page_end(t[Text::compare_footer]);
}

}  // namespace report
