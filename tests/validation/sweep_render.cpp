#include "report/html/page/html_markup.h"
#include "report/text/csv_field.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/tools/converge/converge_plot.h"
#include "report/tools/selftest/report.h"
#include "tests/validation/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace validation {

using namespace cli::selftest;

namespace {

std::string value_of(const Sweep& sweep, const SweepStep& step) {
  return fmt::format("{:g} {}", step.value, sweep.unit);
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

constexpr const char* kPlotStyle = R"css(
.plot { display: block; width: 100%; max-width: 34rem; height: auto; }
.plot text { font-size: 12.5px; fill: var(--quiet); }
.plot .rule { stroke: var(--line); } .plot .base { stroke: var(--quiet); }
.plot .guide { stroke: none; } .plot .faint { stroke-opacity: .5; }
.m0 { --c: var(--link); } .m1 { --c: var(--fail); }
.plot .band { fill: none; } .plot .curve { fill: none; stroke: var(--c); stroke-width: 2; }
.plot .mark { fill: var(--c); }
)css";

report::PlotPoint point(const SweepStep& step, double y, const std::string& words) {
  report::PlotPoint p;
  p.x = step.value;
  p.y = p.low = p.high = y;
  p.words = words;
  return p;
}

std::string plot(const Sweep& sweep) {
  report::PlotSpec spec;
  spec.title = "error";
  spec.unit = report::PlotUnit::count;
  spec.x_title = sweep.unit;
  spec.series.resize(2);
  spec.series[1].colour = 1;
  for (const SweepStep& step : sweep.steps) {
    if (!step.said.empty()) continue;
    if (step.half_width > 0.0) {
      spec.series[0].points.push_back(
          point(step, step.half_width,
                value_of(sweep, step) + ": 95 % half-width " + percent(step.half_width)));
    }
    spec.series[1].points.push_back(
        point(step, std::max(1e-6, std::abs(step.deviation)),
              value_of(sweep, step) + ": off by " + percent(step.deviation)));
  }
  for (report::PlotSeries& series : spec.series) {
    std::sort(series.points.begin(), series.points.end(),
              [](const auto& a, const auto& b) { return a.x < b.x; });
  }
  return report::log_log_plot(spec);
}

}  // namespace

std::string render_sweeps_csv(const std::vector<Sweep>& sweeps) {
  std::string csv = "sweep,value,unit,deviation,half_width_95,known_to,rays,said\n";
  for (const Sweep& sweep : sweeps) {
    for (const SweepStep& step : sweep.steps) {
      csv +=
          fmt::format("{},{},{},{},{},{},{}", sweep.name, report::format_shortest(step.value),
                      report::csv_field(sweep.unit), report::format_shortest(step.deviation),
                      report::format_shortest(step.half_width),
                      report::format_shortest(step.known_to), report::format_shortest(step.rays));
      csv += "," + report::csv_field(step.said) + "\n";
    }
  }
  return csv;
}

std::string render_sweeps_markdown(const std::vector<Sweep>& sweeps) {
  std::string text =
      "# Numerical stability\n\nWritten by `validation_report sweeps FOLDER`, never by hand: how "
      "far "
      "the mean is off the truth, and the half-width of\nthe 95 % interval, towards the ends of "
      "what can be asked for.\n";
  for (const Sweep& sweep : sweeps) {
    text += fmt::format(
        "\n## {}\n\nCompared: {}.\n\n| {} | off by | half-width | rays | |\n"
        "|---|---|---|---|---|\n",
        sweep.title, sweep.what, sweep.unit);
    for (const SweepStep& step : sweep.steps) {
      const bool is_number = step.said.empty() || step.half_width > 0.0;
      text +=
          fmt::format("| {:g} | {} | {} | {:.2g} | {} |\n", step.value,
                      is_number ? percent(step.deviation) : "",
                      is_number ? (step.half_width > 0.0 ? percent(step.half_width) : "exact") : "",
                      step.rays, step.said);
    }
  }
  return text;
}

std::string render_sweeps_html(const std::vector<Sweep>& sweeps) {
  std::string body =
      "<p class=\"eyebrow\">validation_report sweeps</p>\n<h1>Numerical stability</h1>\n<p>How far "
      "the mean is off the truth (<span class=\"m1\" style=\"color:var(--c)\">red</span>, at least "
      "0.0001 %), and the half-width of the 95 % interval (<span class=\"m0\" "
      "style=\"color:var(--c)\">blue</span>).</p>\n";
  for (const Sweep& sweep : sweeps) {
    body +=
        fmt::format("<h2>{}</h2>\n<p class=\"quiet\">{}</p>\n{}", report::escape_html(sweep.title),
                    report::escape_html(sweep.what), plot(sweep));
    for (const SweepStep& step : sweep.steps) {
      if (step.said.empty()) continue;
      body +=
          fmt::format("<p class=\"message\">{}: {}</p>\n",
                      report::escape_html(value_of(sweep, step)), report::escape_html(step.said));
    }
  }
  return html_page("Numerical stability", kPlotStyle, body);
}

}  // namespace validation
