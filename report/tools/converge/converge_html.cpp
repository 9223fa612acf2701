#include "report/html/page/html_markup.h"
#include "report/html/page/html_tool_page.h"
#include "report/text/markup.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"
#include "report/tools/converge/converge_plot.h"
#include "report/tools/converge/converge_words.h"

#include <fmt/format.h>

#include <cmath>

namespace report {
namespace {

// Colours that stay apart for all kinds of colour vision, by luminance too. [Okabe08]
constexpr const char* kConvergeStyle = R"css(
:root { --m0: #0b62b0; --m1: #c8500a; --m2: #0a8765; --m3: #8d3c99; --m4: #7a6300; --m5: #3a7ca5; --m6: #a33a55; --m7: #555e66; }
@media (prefers-color-scheme: dark) {
  :root { --m0: #6db3ff; --m1: #ff9b57; --m2: #45d0a4; --m3: #d896e6; --m4: #e3c54f; --m5: #8ecbe8; --m6: #ff93a8; --m7: #b4bdc5; }
}
@media print { :root { --m0: #0b62b0; --m1: #c8500a; --m2: #0a8765; --m3: #8d3c99; --m4: #7a6300; --m5: #3a7ca5; --m6: #a33a55; --m7: #555e66; } }
.m0 { --c: var(--m0); } .m1 { --c: var(--m1); } .m2 { --c: var(--m2); } .m3 { --c: var(--m3); }
.m4 { --c: var(--m4); } .m5 { --c: var(--m5); } .m6 { --c: var(--m6); } .m7 { --c: var(--m7); }
.lead { font-size: 1.22rem; line-height: 1.4; letter-spacing: -.008em; max-width: 46rem; margin-top: 1.5rem; }
.lead b { font-weight: 650; white-space: nowrap; }
.plots { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 1.7rem 1.6rem; margin: 1.1rem 0 2rem; }
.plots h3 { font-size: .95rem; margin: 0 0 .35rem; }
.plots h3 span { font-weight: 400; color: var(--quiet); }
.plot { display: block; width: 100%; height: auto; font-family: inherit; }
.plot text { font-size: 12.5px; fill: var(--quiet); }
.plot .rule { fill: none; stroke: var(--line); stroke-width: 1; }
.plot .faint { stroke-opacity: .5; }
.plot .base { stroke: var(--quiet); stroke-width: 1; }
.plot .guide { fill: none; stroke: var(--quiet); stroke-opacity: .45; stroke-width: 1; stroke-dasharray: 1.5 4; stroke-linecap: round; }
.plot .floor-line { stroke: var(--quiet); stroke-width: 1; stroke-dasharray: 6 4; }
.plot .band { fill: var(--c); fill-opacity: .15; }
.plot .curve { fill: none; stroke: var(--c); stroke-width: 2; stroke-linejoin: round; }
.plot .mark { fill: var(--c); stroke: var(--paper); stroke-width: 1; }
.plot .hollow { fill: var(--paper); stroke: var(--c); stroke-width: 1.5; }
.legend { list-style: none; display: flex; flex-wrap: wrap; gap: .3rem 1.6rem; margin: .2rem 0 0; padding: 0; font-size: .9rem; }
.legend li { display: inline-flex; align-items: center; gap: .5em; }
.legend svg { flex: none; }
.legend .curve { stroke: var(--c); stroke-width: 2; }
.legend .mark { fill: var(--c); }
.key-line { display: inline-block; width: .8em; height: .8em; border-radius: 2px; background: var(--c); margin-right: .5em; vertical-align: -1px; }
.best { font-weight: 650; }
.halves { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 1.5rem 2.4rem; align-items: start; }
.halves > .scroll { margin: 0; min-width: 0; overflow-x: auto; }
.halves thead th { white-space: normal; }
.halves th, .halves td { padding-right: .45rem; }
.halves tbody th { min-width: 0; }
.halves caption { font-weight: 650; color: var(--ink); }
.bar { display: flex; height: 9px; border-radius: 3px; overflow: hidden; min-width: 9rem; background: var(--soft); }
.bar i { display: block; height: 100%; }
.p0 { background: var(--m7); } .p1 { background: var(--m4); } .p2 { background: var(--m2); } .p3 { background: var(--m0); } .p4 { background: var(--m1); } .p5 { background: var(--m3); }
.phase-key i { width: .75em; height: .75em; border-radius: 2px; margin-right: .4em; display: inline-block; }
table.numbers { text-anchor: initial; }
table.numbers td, table.numbers th { padding-top: .3rem; padding-bottom: .3rem; }
@media screen and (max-width: 62rem) { .plots, .halves { grid-template-columns: repeat(2, minmax(0, 1fr)); } .halves { grid-template-columns: minmax(0, 1fr); } }
@media screen and (max-width: 40rem) { .plots { grid-template-columns: 1fr; } }
@media print { .plots { gap: 4mm; margin: 3mm 0; } .plots figure { break-inside: avoid; } }
)css";

// Of numbers, units and signs alone.
std::string num(const Texts& t, const std::string& words) {
  return "<td class=\"num\">" + t.number(with_minus(words)) + "</td>";
}

std::string method_head(const Texts& t, const ConvergeMethod& method, std::size_t m) {
  return fmt::format(
      "<th scope=\"row\"><span class=\"key-line m{}\" aria-hidden=\"true\"></span>{}</th>", m % 8,
      escape_html(method_title(t, method)));
}

// Up to the first row; the first column holds the methods.
std::string table_start(const char* caption, const std::vector<std::string>& words,
                        const char* kind = "") {
  std::string html = fmt::format("<table{}><caption>{}</caption><thead><tr><td></td>",
                                 *kind == '\0' ? "" : fmt::format(" class=\"{}\"", kind), caption);
  for (const std::string& word : words) {
    html += "<th scope=\"col\" class=\"num\">" + escape_html(word) + "</th>";
  }
  return html + "</tr></thead>\n<tbody>\n";
}

// " Its last error is 4 %." where the first method is known to get further.
std::string where_it_ends(const Texts& t, const ConvergeCurve& ours, const ConvergeCurve& theirs,
                          std::size_t at) {
  if (at + 1 >= kConvergeTargets.size() || theirs.errors.empty()) return "";
  if (!ours.targets[at + 1].seconds || theirs.targets[at + 1].seconds) return "";
  return " " + t.say<Text::converge_last_error>(t.number(error_words(theirs.errors.back()[0])));
}

// The smallest error whose time is known for the first method and another one.
std::string lead(const Texts& t, const ConvergeDocument& document) {
  if (document.planes.empty() || document.methods.empty()) return "";
  const ConvergePlane& plane = document.planes.front();
  std::string html;
  for (std::size_t m = 1; m < document.methods.size(); ++m) {
    for (std::size_t at = kConvergeTargets.size(); at-- > 0;) {
      const ConvergeTarget& ours = plane.curves[0].targets[at];
      const ConvergeTarget& theirs = plane.curves[m].targets[at];
      if (!ours.seconds || !theirs.seconds) continue;
      const double ratio = *theirs.seconds / *ours.seconds;
      const auto strong = [](const std::string& words) { return "<b>" + words + "</b>"; };
      html +=
          (html.empty() ? "" : "<br/>") +
          t.say<Text::converge_lead>(
              format_percent(t, kConvergeTargets[at]),
              escape_html(method_title(t, document.methods[0])), strong(t.number(time_words(ours))),
              escape_html(method_title(t, document.methods[m])),
              strong(t.number(time_words(theirs))),
              strong(t.say<Text::converge_times>(format_fixed(t, ratio, ratio < 9.95 ? 1 : 0)))) +
          escape_html(where_it_ends(t, plane.curves[0], plane.curves[m], at));
      break;
    }
  }
  if (html.empty()) return "";
  return "<p class=\"lead\">" +
         (document.planes.size() > 1 ? escape_html(t.say<Text::compare_plane>(plane.id)) + ":<br/>"
                                     : "") +
         html + "</p>\n";
}

std::string legend(const Texts& t, const ConvergeDocument& document) {
  std::string html = "<ul class=\"legend\">";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    html += fmt::format(
        "<li class=\"m{}\"><svg width=\"26\" height=\"10\" aria-hidden=\"true\"><path "
        "class=\"curve\" d=\"M0,5H26\"/><circle class=\"mark\" cx=\"13\" cy=\"5\" r=\"3.6\"/></svg>"
        "{}</li>",
        m % 8,
        document.methods[m].name == "clamped-instant-radiosity"
            ? t.say<Text::converge_at_clamp>(escape_html(method_title(t, document.methods[m])),
                                             format_shortest(t, document.clamp_per_m2))
            : escape_html(method_title(t, document.methods[m])));
  }
  return html +
         "<li><svg width=\"26\" height=\"10\" class=\"plot\" style=\"width:26px\" "
         "aria-hidden=\"true\"><path class=\"guide\" d=\"M0,2L26,9\"/></svg><span "
         "class=\"quiet\">" +
         t[Text::converge_slope] + "</span></li></ul>\n";
}

enum class Against { time, rays, light_rays };

struct AgainstWords {
  Text axis, against;
};
AgainstWords words_of(Against against) {
  switch (against) {
    case Against::time:
      return {Text::converge_run_time, Text::converge_over_time};
    case Against::rays:
      return {Text::converge_rays_per_point, Text::converge_over_rays};
    case Against::light_rays:
      break;
  }
  return {Text::converge_light_rays, Text::converge_over_light_rays};
}

PlotSpec plot_spec(const Texts& t, const ConvergeDocument& document, const ConvergePlane& plane,
                   std::size_t metric, Against against) {
  PlotSpec spec;
  spec.t = t;
  spec.title = metric_title(t, kAllConvergeMetrics[metric]);
  spec.unit = against == Against::time ? PlotUnit::seconds : PlotUnit::count;
  spec.x_title = t[words_of(against).axis];
  if (metric == 0 && plane.reference_error > 0.0) spec.floor = plane.reference_error;
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    PlotSeries& series = spec.series.emplace_back();
    series.colour = m;
    for (std::size_t k = 0; k < document.methods[m].steps.size(); ++k) {
      const ConvergeStep& step = document.methods[m].steps[k];
      const ConvergeError& e = plane.curves[m].errors[k][metric];
      const double x = against == Against::time   ? step.seconds
                       : against == Against::rays ? step.rays_per_point
                                                  : step.light_rays;
      series.points.push_back(
          {x, e.value, e.low, e.high, e.is_below,
           t.say<Text::converge_mark>(
               method_title(t, document.methods[m]), count_words(static_cast<double>(step.paths)),
               document.replicates, t.number(error_words(e)), t.number(time_words(step.seconds)))});
    }
  }
  return spec;
}

std::string figure(const Texts& t, const PlotSpec& spec, Against against) {
  const std::string plot = log_log_plot(spec);
  if (plot.empty()) return "";
  return fmt::format("<figure><h3>{} <span>{}</span></h3>\n{}</figure>\n", escape_html(spec.title),
                     t[words_of(against).against], plot);
}

std::string plots(const Texts& t, const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html = "<div class=\"plots\">\n";
  for (const Against against : {Against::time, Against::rays, Against::light_rays}) {
    html += figure(t, plot_spec(t, document, plane, 0, against), against);
  }
  for (std::size_t metric = 1; metric < kConvergeMetrics; ++metric) {
    html += figure(t, plot_spec(t, document, plane, metric, Against::time), Against::time);
  }
  return html + "</div>\n";
}

std::string targets(const Texts& t, const ConvergeDocument& document, const ConvergePlane& plane) {
  std::vector<std::string> words;
  for (const double target : kConvergeTargets) words.push_back(format_percent(t, target));
  std::string html = table_start(t[Text::converge_time_to], words);
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    html += "<tr>" + method_head(t, document.methods[m], m);
    for (std::size_t at = 0; at < kConvergeTargets.size(); ++at) {
      const ConvergeTarget& mine = plane.curves[m].targets[at];
      bool is_best = mine.seconds.has_value() && document.methods.size() > 1;
      for (const ConvergeCurve& other : plane.curves) {
        const auto& seconds = other.targets[at].seconds;
        is_best = is_best && (!seconds || *seconds >= *mine.seconds);
      }
      html += fmt::format("<td class=\"num{}\">{}</td>", is_best ? " best" : "",
                          t.number(time_words(mine)));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string slopes(const Texts& t, const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html =
      table_start(t[Text::converge_exponents],
                  {t[Text::converge_rms_by_rays], "RMS", t[Text::converge_worst_head],
                   t[Text::converge_average_head], "Uo"});
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    const auto& all = plane.curves[m].slopes;
    html += "<tr>" + method_head(t, document.methods[m], m) + num(t, slope_words(all[0].over_rays));
    for (const ConvergeSlopes& slope : all) html += num(t, slope_words(slope.over_time));
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string coverage(const Texts& t, const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html = table_start(t[Text::converge_coverage],
                                 {t[Text::converge_points_head], t[Text::converge_of],
                                  t[Text::converge_average_head], t[Text::converge_of]});
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    ConvergeCoverage points, averages;
    for (std::size_t k = 0; k < plane.curves[m].coverage.size(); ++k) {
      points.held += plane.curves[m].coverage[k].held;
      points.tried += plane.curves[m].coverage[k].tried;
      averages.held += plane.curves[m].average_coverage[k].held;
      averages.tried += plane.curves[m].average_coverage[k].tried;
    }
    html += "<tr>" + method_head(t, document.methods[m], m) + num(t, coverage_words(points)) +
            num(t, format_count(points.tried)) + num(t, coverage_words(averages)) +
            num(t, format_count(averages.tried)) + "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string all_numbers(const Texts& t, const ConvergeDocument& document,
                        const ConvergePlane& plane) {
  std::string html = fmt::format("<details><summary>{}</summary>", t[Text::converge_all_numbers]);
  std::string table =
      table_start(t[Text::converge_all_numbers],
                  {t[Text::converge_paths_head], t[Text::converge_time_head],
                   t[Text::converge_rays_head], t[Text::converge_light_rays_head], "RMS",
                   t[Text::converge_worst_head], t[Text::converge_average_head], "Uo",
                   t[Text::converge_held_head], t[Text::converge_average_held_head]},
                  "numbers");
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    const ConvergeMethod& method = document.methods[m];
    for (std::size_t k = 0; k < method.steps.size(); ++k) {
      const ConvergeStep& step = method.steps[k];
      table += "<tr>" + method_head(t, method, m) + num(t, format_count(step.paths)) +
               num(t, time_words(step.seconds)) + num(t, count_words(step.rays_per_point)) +
               num(t, step.light_rays > 0.0 ? count_words(step.light_rays) : "–");
      for (const ConvergeError& e : plane.curves[m].errors[k]) {
        table += num(t, escape_html(error_words(e)));
      }
      table += num(t, coverage_words(plane.curves[m].coverage[k])) +
               num(t, coverage_words(plane.curves[m].average_coverage[k])) + "</tr>\n";
    }
  }
  return html +
         scroll_box(escape_html(plane.id) + ": " + t[Text::converge_all_numbers],
                    table + "</tbody></table>") +
         "</details>\n";
}

// A table that is scrolled by itself where the page is narrow.
std::string half(const Texts& t, const ConvergePlane& plane, Text title, const std::string& table) {
  return scroll_box(escape_html(plane.id) + ": " + t[title], table);
}

std::string plane_html(const Texts& t, const ConvergeDocument& document,
                       const ConvergePlane& plane) {
  const std::string known =
      plane.reference_error > 0.0
          ? t.say<Text::converge_known_to>(t.number(error_words(plane.reference_error)))
          : t[Text::exact];
  return fmt::format(
             "<section><h2>{} <span class=\"id\">{}</span></h2>\n<p class=\"quiet\">{}</p>\n",
             escape_html(plane.name.empty() ? plane.id : plane.name),
             plane.name.empty() ? "" : escape_html(plane.id),
             t.say<Text::converge_plane_facts>(
                 format_count(plane.points), format_cell(t, plane.average_lx),
                 format_cell(t, plane.minimum_lx), format_fixed(t, plane.uo, 3), known)) +
         legend(t, document) + plots(t, document, plane) + "<div class=\"halves\">\n" +
         half(t, plane, Text::converge_time_to, targets(t, document, plane)) +
         half(t, plane, Text::converge_exponents, slopes(t, document, plane)) +
         half(t, plane, Text::converge_coverage, coverage(t, document, plane)) + "</div>\n" +
         all_numbers(t, document, plane) + "</section>\n";
}

std::string bar(const ConvergePhases& phases) {
  double sum = 0.0;
  for (const ConvergePhase& phase : all_phases()) sum += phases.*phase.seconds;
  std::string html = "<div class=\"bar\" aria-hidden=\"true\">";
  for (const ConvergePhase& phase : all_phases()) {
    if (!(phases.*phase.seconds > 0.0)) continue;
    html += fmt::format("<i class=\"p{}\" style=\"width:{}%\"></i>", phase.colour,
                        svg_number(100.0 * (phases.*phase.seconds) / sum));
  }
  return html + "</div>";
}

std::string phases_html(const Texts& t, const ConvergeDocument& document) {
  const std::vector<ConvergePhase> shown = shown_phases(document);
  std::string table = fmt::format(
      "<table><caption class=\"unseen\">{}</caption><thead><tr><td></td><th scope=\"col\" "
      "class=\"num\">{}</th>",
      t[Text::converge_phases], t[Text::converge_paths_head]);
  for (const ConvergePhase& phase : shown) {
    table += fmt::format("<th scope=\"col\" class=\"num phase-key\"><i class=\"p{}\"></i>{}</th>",
                         phase.colour, phase_title(t, phase));
  }
  table += fmt::format("<th scope=\"col\" class=\"num\">{}</th><td></td></tr></thead><tbody>\n",
                       t[Text::converge_phase_all]);
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    const std::vector<ConvergeStep>& steps = document.methods[m].steps;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const std::size_t left = steps.size() - 1 - k;  // the last one and two before it
      if (left % 2 != 0 || left > 4) continue;
      const ConvergeStep& step = steps[k];
      table += "<tr>" + method_head(t, document.methods[m], m) + num(t, format_count(step.paths));
      for (const ConvergePhase& phase : shown) {
        table += num(t, phase_words(step.phases.*phase.seconds));
      }
      table += num(t, time_words(step.seconds)) + "<td>" + bar(step.phases) + "</td></tr>\n";
    }
  }
  const auto time = [&](double seconds) { return t.number(time_words(seconds)); };
  std::string words =
      t.say<Text::converge_reading>(time(document.load_s), time(document.prepare_s));
  if (document.reference_s > 0.0)
    words += " " + t.say<Text::converge_reference_took>(time(document.reference_s));
  words += std::string(" ") + t[Text::converge_phases_note];
  return fmt::format("<section><h2>{}</h2>\n<p class=\"quiet\">{}</p>\n",
                     t[Text::converge_where_time], words) +
         scroll_box(t[Text::converge_phases], table + "</tbody></table>") + "</section>\n";
}

std::string method_notes(const Texts& t, const ConvergeDocument& document) {
  const std::string reference =
      document.reference_replicates > 0
          ? t.say<Text::converge_own_reference>(document.reference_replicates,
                                                format_count(document.reference_paths))
          : document.reference;
  return fmt::format(
             "<section><h2>{0}</h2>\n<table class=\"facts wide\"><caption "
             "class=\"unseen\">{0}</caption><tbody>\n",
             t[Text::converge_how]) +
         fact(t[Text::converge_error_of],
              t[document.part == "indirect" ? Text::converge_indirect : Text::converge_total]) +
         fact(t[Text::converge_reference], escape_html(reference)) +
         fact(t[Text::converge_run],
              t.say<Text::converge_run_words>(document.replicates, document.seeds,
                                              document.first_seed)) +
         fact(t[Text::converge_curves], t[Text::converge_curves_words]) +
         fact(t[Text::time], document.jobs > 0 ? t.say<Text::converge_time_words>(document.jobs)
                                               : t[Text::converge_time_cores]) +
         fact(t[Text::converge_intervals], t[Text::converge_intervals_words]) +
         fact(t[Text::converge_scene],
              t.say<Text::converge_scene_words>(format_count(document.triangles),
                                                format_count(document.luminaires),
                                                format_count(document.points))) +
         (document.opengl.empty() ? "" : fact("OpenGL", escape_html(opengl_words(t, document)))) +
         fact(t[Text::program], escape_html("luxgate " + document.program)) +
         "</tbody></table></section>\n";
}

}  // namespace

std::string render_converge_html(const ConvergeDocument& document, const Texts& t, Paper paper) {
  const std::string& name = document.project.empty() ? document.path : document.project;
  ToolPage page;
  page.title = escape_html(name);
  page.eyebrow = t[Text::converge_title];
  page.style = kConvergeStyle;
  page.foot = name;
  page.paper = paper;
  std::string html = tool_page_start(t, page);
  html +=
      fmt::format("<p class=\"quiet\">{} · {}</p>\n{}</header>\n<main id=\"main\">\n",
                  escape_html(document.path), escape_html(document.space_id), lead(t, document));
  for (const ConvergePlane& plane : document.planes) html += plane_html(t, document, plane);
  return html + phases_html(t, document) + method_notes(t, document) +
         tool_page_end(t.say<Text::made_by_program>(escape_html(document.program)));
}

}  // namespace report
