#include "report/html/html_markup.h"
#include "report/html/html_style.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/svg.h"
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
.plots h4 { font-size: .95rem; margin: 0 0 .35rem; }
.plots h4 span { font-weight: 400; color: var(--quiet); }
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
.halves th, .halves td { padding-right: .45rem; }
.halves tbody th { white-space: nowrap; }
.halves caption { font-weight: 650; color: var(--ink); }
.bar { display: flex; height: 9px; border-radius: 3px; overflow: hidden; min-width: 9rem; background: var(--soft); }
.bar i { display: block; height: 100%; }
.p0 { background: var(--m7); } .p1 { background: var(--m4); } .p2 { background: var(--m2); } .p3 { background: var(--m0); } .p4 { background: var(--m1); } .p5 { background: var(--m3); }
.phase-key i { width: .75em; height: .75em; border-radius: 2px; margin-right: .4em; display: inline-block; }
table.numbers { text-anchor: initial; }
table.numbers td, table.numbers th { padding-top: .3rem; padding-bottom: .3rem; }
@media (max-width: 62rem) { .plots, .halves { grid-template-columns: repeat(2, minmax(0, 1fr)); } .halves { grid-template-columns: 1fr; } }
@media (max-width: 40rem) { .plots { grid-template-columns: 1fr; } }
@media print { .plots { gap: 4mm; margin: 3mm 0; } .plots figure { break-inside: avoid; } }
)css";

std::string num(const std::string& words) {
  return "<td class=\"num\">" + with_minus(words) + "</td>";
}

std::string method_head(const ConvergeMethod& method, std::size_t m) {
  return fmt::format(
      "<th scope=\"row\"><span class=\"key-line m{}\" aria-hidden=\"true\"></span>{}</th>", m % 8,
      escape_html(method.title));
}

std::string heads(const std::vector<std::string>& words) {
  std::string html = "<thead><tr><th scope=\"col\"></th>";
  for (const std::string& word : words) {
    html += "<th scope=\"col\" class=\"num\">" + escape_html(word) + "</th>";
  }
  return html + "</tr></thead>\n";
}

std::string head(const std::string& title) {
  return "<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\"/>\n<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'\"/>\n<title>" +
         title + " – convergence</title>\n<style>\n" + html_style() + kConvergeStyle +
         "</style>\n</head>\n";
}

// " It ends at 4 % here." where the first method is known to get further.
std::string where_it_ends(const ConvergeCurve& ours, const ConvergeCurve& theirs, std::size_t t) {
  if (t + 1 >= kConvergeTargets.size() || theirs.errors.empty()) return "";
  if (!ours.targets[t + 1].seconds || theirs.targets[t + 1].seconds) return "";
  return fmt::format(" Its last error is {}.", error_words(theirs.errors.back()[0]));
}

// The smallest error whose time is known for the first method and another one.
std::string lead(const ConvergeDocument& document) {
  if (document.planes.empty() || document.methods.empty()) return "";
  const ConvergePlane& plane = document.planes.front();
  std::string html;
  for (std::size_t m = 1; m < document.methods.size(); ++m) {
    for (std::size_t t = kConvergeTargets.size(); t-- > 0;) {
      const ConvergeTarget& ours = plane.curves[0].targets[t];
      const ConvergeTarget& theirs = plane.curves[m].targets[t];
      if (!ours.seconds || !theirs.seconds) continue;
      const double ratio = *theirs.seconds / *ours.seconds;
      html += fmt::format(
          "{}To {} of RMS error, {} takes <b>{}</b>, {} <b>{}</b>: <b>{} times</b> as long.{}",
          html.empty() ? "" : "<br/>", format_percent(kConvergeTargets[t]),
          escape_html(document.methods[0].title), time_words(ours),
          escape_html(document.methods[m].title), time_words(theirs),
          format_fixed(ratio, ratio < 9.95 ? 1 : 0),
          escape_html(where_it_ends(plane.curves[0], plane.curves[m], t)));
      break;
    }
  }
  if (html.empty()) return "";
  return "<p class=\"lead\">" +
         (document.planes.size() > 1 ? "Plane " + escape_html(plane.id) + ":<br/>" : "") + html +
         "</p>\n";
}

std::string legend(const ConvergeDocument& document) {
  std::string html = "<ul class=\"legend\">";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    html += fmt::format(
        "<li class=\"m{}\"><svg width=\"26\" height=\"10\" aria-hidden=\"true\"><path "
        "class=\"curve\" d=\"M0,5H26\"/><circle class=\"mark\" cx=\"13\" cy=\"5\" r=\"3.6\"/></svg>"
        "{}{}</li>",
        m % 8, escape_html(document.methods[m].title),
        document.methods[m].name == "clamped-instant-radiosity"
            ? fmt::format(" at {} /m²", format_shortest(document.clamp_per_m2))
            : "");
  }
  return html +
         "<li><svg width=\"26\" height=\"10\" class=\"plot\" style=\"width:26px\" "
         "aria-hidden=\"true\"><path class=\"guide\" d=\"M0,2L26,9\"/></svg><span "
         "class=\"quiet\">slope −½: plain random sampling</span></li></ul>\n";
}

enum class Against { time, rays, light_rays };

PlotSpec plot_spec(const ConvergeDocument& document, const ConvergePlane& plane, std::size_t metric,
                   Against against) {
  PlotSpec spec;
  spec.title = converge_metric_title(kAllConvergeMetrics[metric]);
  spec.unit = against == Against::time ? PlotUnit::seconds : PlotUnit::count;
  spec.x_title = against == Against::time   ? "run time"
                 : against == Against::rays ? "rays per point"
                                            : "light rays (VPLs)";
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
           fmt::format("{}, {} paths × {}: {} in {}", document.methods[m].title,
                       count_words(static_cast<double>(step.paths)), document.replicates,
                       error_words(e), time_words(step.seconds))});
    }
  }
  return spec;
}

std::string figure(const PlotSpec& spec) {
  const std::string plot = log_log_plot(spec);
  if (plot.empty()) return "";
  return fmt::format("<figure><h4>{} <span>against {}</span></h4>\n{}</figure>\n",
                     escape_html(spec.title), escape_html(spec.x_title), plot);
}

std::string plots(const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html = "<div class=\"plots\">\n";
  for (const Against against : {Against::time, Against::rays, Against::light_rays}) {
    html += figure(plot_spec(document, plane, 0, against));
  }
  for (std::size_t metric = 1; metric < kConvergeMetrics; ++metric) {
    html += figure(plot_spec(document, plane, metric, Against::time));
  }
  return html + "</div>\n";
}

std::string targets(const ConvergeDocument& document, const ConvergePlane& plane) {
  std::vector<std::string> words;
  for (const double target : kConvergeTargets) words.push_back(format_percent(target));
  std::string html =
      "<table><caption>Time to an RMS error of</caption>" + heads(words) + "<tbody>\n";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    html += "<tr>" + method_head(document.methods[m], m);
    for (std::size_t t = 0; t < kConvergeTargets.size(); ++t) {
      const ConvergeTarget& mine = plane.curves[m].targets[t];
      bool is_best = mine.seconds.has_value() && document.methods.size() > 1;
      for (const ConvergeCurve& other : plane.curves) {
        const auto& seconds = other.targets[t].seconds;
        is_best = is_best && (!seconds || *seconds >= *mine.seconds);
      }
      html += fmt::format("<td class=\"num{}\">{}</td>", is_best ? " best" : "", time_words(mine));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string slopes(const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html = "<table><caption>Fitted exponents: RMS over rays, and over time</caption>" +
                     heads({"RMS / rays", "RMS", "worst", "average", "Uo"}) + "<tbody>\n";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    const auto& all = plane.curves[m].slopes;
    html += "<tr>" + method_head(document.methods[m], m) + num(slope_words(all[0].over_rays));
    for (const ConvergeSlopes& slope : all) html += num(slope_words(slope.over_time));
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string coverage(const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html = "<table><caption>How often stated 95 % intervals hold the truth</caption>" +
                     heads({"points", "of", "average", "of"}) + "<tbody>\n";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    ConvergeCoverage points, averages;
    for (std::size_t k = 0; k < plane.curves[m].coverage.size(); ++k) {
      points.held += plane.curves[m].coverage[k].held;
      points.tried += plane.curves[m].coverage[k].tried;
      averages.held += plane.curves[m].average_coverage[k].held;
      averages.tried += plane.curves[m].average_coverage[k].tried;
    }
    html += "<tr>" + method_head(document.methods[m], m) + num(coverage_words(points)) +
            num(format_count(points.tried)) + num(coverage_words(averages)) +
            num(format_count(averages.tried)) + "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string all_numbers(const ConvergeDocument& document, const ConvergePlane& plane) {
  std::string html = "<details><summary>All numbers</summary>";
  std::string table = "<table class=\"numbers\">" +
                      heads({"paths", "time", "rays / point", "light rays", "RMS", "worst",
                             "average", "Uo", "held", "av. held"}) +
                      "<tbody>\n";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    const ConvergeMethod& method = document.methods[m];
    for (std::size_t k = 0; k < method.steps.size(); ++k) {
      const ConvergeStep& step = method.steps[k];
      table += "<tr>" + method_head(method, m) + num(format_count(step.paths)) +
               num(time_words(step.seconds)) + num(count_words(step.rays_per_point)) +
               num(step.light_rays > 0.0 ? count_words(step.light_rays) : "–");
      for (const ConvergeError& e : plane.curves[m].errors[k]) {
        table += num(escape_html(error_words(e)));
      }
      table += num(coverage_words(plane.curves[m].coverage[k])) +
               num(coverage_words(plane.curves[m].average_coverage[k])) + "</tr>\n";
    }
  }
  return html + scroll_box("All numbers", table + "</tbody></table>") + "</details>\n";
}

std::string plane_html(const ConvergeDocument& document, const ConvergePlane& plane) {
  return fmt::format(
             "<section><h2>{} <span class=\"id\">{}</span></h2>\n<p class=\"quiet\">{} points · "
             "average {} lx · minimum {} lx · Uo {} · reference {}</p>\n",
             escape_html(plane.name.empty() ? plane.id : plane.name),
             plane.name.empty() ? "" : escape_html(plane.id), format_count(plane.points),
             format_cell(plane.average_lx), format_cell(plane.minimum_lx),
             format_fixed(plane.uo, 3),
             plane.reference_error > 0.0
                 ? fmt::format("known to {} (RMS)", error_words(plane.reference_error))
                 : "exact") +
         legend(document) + plots(document, plane) + "<div class=\"halves\">\n" +
         targets(document, plane) + slopes(document, plane) + coverage(document, plane) +
         "</div>\n" + all_numbers(document, plane) + "</section>\n";
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

std::string phases_html(const ConvergeDocument& document) {
  const std::vector<ConvergePhase> shown = shown_phases(document);
  std::string table =
      "<table><thead><tr><th scope=\"col\"></th><th scope=\"col\" class=\"num\">paths</th>";
  for (const ConvergePhase& phase : shown) {
    table += fmt::format("<th scope=\"col\" class=\"num phase-key\"><i class=\"p{}\"></i>{}</th>",
                         phase.colour, phase.title);
  }
  table += "<th scope=\"col\" class=\"num\">all</th><th scope=\"col\"></th></tr></thead><tbody>\n";
  for (std::size_t m = 0; m < document.methods.size(); ++m) {
    const std::vector<ConvergeStep>& steps = document.methods[m].steps;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const std::size_t left = steps.size() - 1 - k;  // the last one and two before it
      if (left % 2 != 0 || left > 4) continue;
      const ConvergeStep& step = steps[k];
      table += "<tr>" + method_head(document.methods[m], m) + num(format_count(step.paths));
      for (const ConvergePhase& phase : shown) {
        table += num(phase_words(step.phases.*phase.seconds));
      }
      table += num(time_words(step.seconds)) + "<td>" + bar(step.phases) + "</td></tr>\n";
    }
  }
  return "<section><h2>Where the time goes</h2>\n<p class=\"quiet\">Reading files took " +
         time_words(document.load_s) + ", preparing the scene " + time_words(document.prepare_s) +
         (document.reference_s > 0.0 ? ", the reference " + time_words(document.reference_s) : "") +
         ". Path tracing counts its rays as near field. All planes together, the fastest seed.</p>"
         "\n" +
         scroll_box("Phases", table + "</tbody></table>") + "</section>\n";
}

std::string method_notes(const ConvergeDocument& document) {
  return "<section><h2>How it was measured</h2>\n<table class=\"facts wide\">" +
         fact("Error of", document.part == "indirect" ? "reflected light alone"
                                                      : "all light, relative to each point") +
         fact("Reference", escape_html(document.reference)) +
         fact("A run", fmt::format("the mean of {} independent replicates; {} seeds from {}",
                                   document.replicates, document.seeds, document.first_seed)) +
         fact("Curves",
              "root of the mean square over seeds, less the reference's own error but "
              "for worst points; bands from the smallest to the largest seed; hollow "
              "marks drown in the reference's error; <b>~</b> is extrapolated") +
         fact("Time", fmt::format("of the fastest seed, without reading and preparing; {}",
                                  document.jobs > 0 ? fmt::format("{} threads", document.jobs)
                                                    : "one thread per core")) +
         fact("Intervals",
              "Student-t over the replicates at a fixed number of paths, held against "
              "the reference with its own error") +
         fact(
             "Scene",
             fmt::format("{} triangles, {} luminaires, {} points", format_count(document.triangles),
                         format_count(document.luminaires), format_count(document.points))) +
         (document.opengl.empty() ? "" : fact("OpenGL", escape_html(opengl_words(document)))) +
         fact("Program", escape_html("luxgate " + document.program + ", " + document.tracer)) +
         "</table></section>\n";
}

}  // namespace

std::string render_converge_html(const ConvergeDocument& document) {
  const std::string title =
      escape_html(document.project.empty() ? document.path : document.project);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n" + head(title) +
      "<body>\n<header>\n<p class=\"eyebrow\">luxgate · error against run time</p>\n<h1>" + title +
      "</h1>\n<p class=\"quiet\">" + escape_html(document.path) + " · " +
      escape_html(document.space_id) + "</p>\n" + lead(document) + "</header>\n<main>\n";
  for (const ConvergePlane& plane : document.planes) html += plane_html(document, plane);
  return html + phases_html(document) + method_notes(document) + "</main>\n</body>\n</html>\n";
}

}  // namespace report
