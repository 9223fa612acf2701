#include "calc/base/names.h"
#include "calc/base/utf8.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/html_style.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/svg.h"
#include "report/text/words.h"
#include "report/tools/sweep/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace cli {
namespace {

using report::escape_html;
using report::svg_number;
using report::svg_text;

constexpr std::size_t kMostRowsOfPage = 2000;
constexpr std::size_t kMostRowsOfFront = 100;
// Margins beyond are drawn at the edge of a picture.
constexpr double kLeastMarginDrawn = -1.0, kMostMarginDrawn = 2.0;

constexpr const char* kSweepStyle = R"css(
.chart { display: block; width: 100%; height: auto; }
.chart text { font-size: 12px; fill: var(--quiet); } .chart .name { fill: var(--ink); font-weight: 600; }
.chart .rule { stroke: var(--line); } .chart .limit { stroke: var(--ink); stroke-width: 1.5; }
.chart .front { fill: none; stroke: var(--link); stroke-width: 2; stroke-dasharray: 6 3; }
.chart .bar { stroke-opacity: .3; }
.chart .m { stroke: var(--tone); fill: none; stroke-width: 1.6; } .chart circle.m { fill: var(--tone); }
.chart .ring { fill: none; stroke: var(--link); stroke-width: 2; }
.chart .range { fill: var(--soft); stroke: var(--field); } .chart .mid { stroke: var(--ink); stroke-width: 2; }
.chart .count { fill: var(--tone); font-weight: 600; }
.multiples { display: flex; flex-wrap: wrap; gap: 1.5rem 2.5rem; }
.multiples figure { margin: 0; flex: 0 1 auto; max-width: 100%; }
.key { display: flex; flex-wrap: wrap; gap: .3rem 1.4rem; list-style: none; padding: 0; margin: .6rem 0 0; font-size: .85rem; }
.key svg { width: 1.1rem; height: 1.1rem; vertical-align: -.2rem; margin-right: .35rem; }
td.command code { font-size: .78rem; overflow-wrap: anywhere; }
)css";

std::string_view tone_of(rules::Outcome outcome) {
  const bool is_verdict = outcome == rules::Outcome::pass || outcome == rules::Outcome::fail ||
                          outcome == rules::Outcome::undecided;
  return calc::name_of(is_verdict ? outcome : rules::Outcome::not_judged);
}

// A shape for each outcome: a disc, a cross, a diamond, a square.
std::string mark(rules::Outcome outcome, double x, double y) {
  const std::string_view tone = tone_of(outcome);
  const std::string at_x = svg_number(x), at_y = svg_number(y);
  switch (outcome) {
    case rules::Outcome::pass:
      return fmt::format("<circle class=\"m pass\" cx=\"{}\" cy=\"{}\" r=\"3.5\"/>", at_x, at_y);
    case rules::Outcome::fail:
      return fmt::format("<path class=\"m fail\" d=\"M{},{}m-3.5,-3.5l7,7m0,-7l-7,7\"/>", at_x,
                         at_y);
    case rules::Outcome::undecided:
      return fmt::format("<path class=\"m undecided\" d=\"M{},{}m-5,0l5,-5l5,5l-5,5z\"/>", at_x,
                         at_y);
    default:
      return fmt::format("<path class=\"m {}\" d=\"M{},{}m-3.5,-3.5h7v7h-7z\"/>", tone, at_x, at_y);
  }
}

std::string percent_words(double margin) {
  const std::string text = report::format_fixed(100.0 * margin, 0);
  return report::with_minus((margin > 0.0 && text != "0" ? "+" : "") + text) + " %";
}

// The scale of margins that all pictures share: round steps, and the limit is in it.
class MarginScale {
 public:
  explicit MarginScale(const std::vector<SweepRow>& rows) {
    for (const SweepRow& row : rows) {
      if (!row.margin) continue;
      low_ = std::min(low_, inside(row.margin->low));
      high_ = std::max(high_, inside(row.margin->high));
    }
    const double width = std::max(high_ - low_, 0.02);
    for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
      step_ = step;
      if (width / step <= 7.0) break;
    }
    low_ = std::floor(low_ / step_ - 0.1) * step_;
    high_ = std::ceil(high_ / step_ + 0.1) * step_;
  }

  double share(double margin) const { return (inside(margin) - low_) / (high_ - low_); }
  std::vector<double> ticks() const {
    std::vector<double> ticks;
    const auto count = static_cast<int>(std::lround((high_ - low_) / step_));
    for (int i = 0; i <= count; ++i) ticks.push_back(low_ + i * step_);
    return ticks;
  }

 private:
  static double inside(double margin) {
    return std::clamp(margin, kLeastMarginDrawn, kMostMarginDrawn);
  }
  double low_ = 0.0, high_ = 0.0, step_ = 1.0;
};

std::string margin_axis(const report::PlotFrame& frame, const MarginScale& scale) {
  std::string svg;
  for (const double tick : scale.ticks()) {
    const bool is_limit = std::abs(tick) < 1e-9;
    const double y = frame.y(scale.share(tick));
    svg += fmt::format("<path class=\"{}\" d=\"M{},{}H{}\"/>", is_limit ? "limit" : "rule",
                       svg_number(frame.left), svg_number(y), svg_number(frame.x_end()));
    svg += svg_text(frame.left - 6, y + 4, "end", is_limit ? "limit" : percent_words(tick)) + "\n";
  }
  return svg;
}

std::string values_words(const Sweep& sweep, const SweepRow& row) {
  std::string words;
  for (std::size_t v = 0; v < sweep.vary.size(); ++v) {
    words += fmt::format("{}{} = {}", v == 0 ? "" : ", ", sweep.vary[v].path, row.values[v]);
  }
  return words;
}

std::string_view cost_name(const Sweep& sweep) { return calc::name_of(sweep.front_of); }

std::string_view installed_words(FrontOf front_of) {
  return front_of == FrontOf::price ? "price" : "installed power";
}

// Sums of which a part is not known are no place in a picture.
bool is_drawn(const Sweep& sweep, const SweepRow& row) {
  return row.margin && cost_of(row, sweep.front_of);
}

double drawn_cost(const Sweep& sweep, const SweepRow& row) {
  return cost_of(row, sweep.front_of).value();
}

// Where powers or prices stand. Variants of the same cost stand side by side, in their order, where
// there is room between one cost and the next.
class CostScale {
 public:
  CostScale(const Sweep& sweep, const report::PlotFrame& frame) : sweep_(sweep), frame_(frame) {
    for (const SweepRow& row : sweep.rows) {
      if (is_drawn(sweep, row)) of_cost_[drawn_cost(sweep, row)].push_back(row.variant);
    }
    if (is_empty()) return;
    low_ = of_cost_.begin()->first;
    width_ = of_cost_.rbegin()->first - low_;
    const auto costs = static_cast<double>(of_cost_.size());
    edge_ = 0.5 / costs;
    double least = frame.field_width() / costs;
    for (auto one = of_cost_.begin(), next = std::next(one); next != of_cost_.end();
         ++one, ++next) {
      least = std::min(least, centre(next->first) - centre(one->first));
    }
    room_ = least < 14.0 ? 0.0 : 0.75 * least;
  }

  bool is_empty() const { return of_cost_.empty(); }
  double centre(double cost) const {
    return frame_.x(width_ > 0.0 ? edge_ + (1.0 - 2.0 * edge_) * (cost - low_) / width_ : 0.5);
  }
  double place(const SweepRow& row) const {
    const double cost = drawn_cost(sweep_, row);
    const std::vector<std::size_t>& beside = of_cost_.at(cost);
    const auto rank = static_cast<double>(
        std::lower_bound(beside.begin(), beside.end(), row.variant) - beside.begin());
    return centre(cost) + room_ * ((rank + 0.5) / static_cast<double>(beside.size()) - 0.5);
  }
  // All costs where they are few, else round ones.
  std::vector<double> ticks() const {
    std::vector<double> ticks;
    if (of_cost_.size() <= 14) {
      for (const auto& [cost, variants] : of_cost_) ticks.push_back(cost);
      return ticks;
    }
    double step = 0.001;  // 1, 2 or 5, and zeros
    for (int i = 0; width_ / step > 8.0; ++i) step *= i % 3 == 1 ? 2.5 : 2.0;
    for (double tick = std::ceil(low_ / step); tick * step <= low_ + width_; ++tick) {
      ticks.push_back(tick * step);
    }
    return ticks;
  }

 private:
  const Sweep& sweep_;
  const report::PlotFrame& frame_;
  std::map<double, std::vector<std::size_t>> of_cost_;  // variants, ascending
  double low_ = 0.0, width_ = 0.0, edge_ = 0.0, room_ = 0.0;
};

std::string cost_chart(const Sweep& sweep, const MarginScale& scale) {
  constexpr report::PlotFrame kFrame{1040, 420, 62, 16, 14, 46};
  const CostScale cost(sweep, kFrame);
  if (cost.is_empty()) {
    return fmt::format("<p class=\"message\">No variant has a margin and a known {} to draw.</p>\n",
                       cost_name(sweep));
  }
  std::string svg = fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Smallest margin over "
      "{} of all variants\">\n",
      kFrame.width, kFrame.height, installed_words(sweep.front_of));
  svg += margin_axis(kFrame, scale);
  for (const double tick : cost.ticks()) {
    svg +=
        svg_text(cost.centre(tick), kFrame.y_end() + 18, "middle", report::format_shortest(tick)) +
        "\n";
  }
  svg += svg_text(0.5 * kFrame.width, kFrame.height - 6, "middle",
                  sweep.front_of == FrontOf::price ? "price" : "installed power, W") +
         "\n";
  std::vector<const SweepRow*> front;
  std::string bars, marks, rings;
  std::set<std::tuple<std::string, std::string, rules::Outcome>> drawn;
  for (const SweepRow& row : sweep.rows) {
    if (!is_drawn(sweep, row)) continue;
    if (row.pareto == ParetoPlace::on) front.push_back(&row);
    const double at_x = cost.place(row), at_y = kFrame.y(scale.share(row.margin->value));
    if (row.pareto == ParetoPlace::on) {
      rings += fmt::format(
          "<circle class=\"ring\" cx=\"{}\" cy=\"{}\" r=\"7.5\"><title>{}</title></circle>\n",
          svg_number(at_x), svg_number(at_y),
          escape_html(
              fmt::format("{}: {}, {}", values_words(sweep, row),
                          sweep.front_of == FrontOf::price ? price_words(row) : power_words(row),
                          margin_words(row))));
    }
    if (!drawn.emplace(report::format_fixed(at_x, 0), report::format_fixed(at_y, 0), row.outcome)
             .second) {
      continue;  // one of the same kind lies there
    }
    bars += fmt::format("<path class=\"m bar {}\" d=\"M{},{}V{}\"/>\n", tone_of(row.outcome),
                        svg_number(at_x), svg_number(kFrame.y(scale.share(row.margin->low))),
                        svg_number(kFrame.y(scale.share(row.margin->high))));
    marks += mark(row.outcome, at_x, at_y) + "\n";
  }
  std::stable_sort(front.begin(), front.end(), [&](const SweepRow* a, const SweepRow* b) {
    return std::pair(drawn_cost(sweep, *a), a->margin->value) <
           std::pair(drawn_cost(sweep, *b), b->margin->value);
  });
  std::string steps;
  for (const SweepRow* row : front) {
    const double at_y = kFrame.y(scale.share(row->margin->value));
    steps += steps.empty() ? fmt::format("M{},{}", svg_number(cost.place(*row)), svg_number(at_y))
                           : fmt::format("H{}V{}", svg_number(cost.place(*row)), svg_number(at_y));
  }
  if (front.size() > 1) svg += fmt::format("<path class=\"front\" d=\"{}\"/>\n", steps);
  return svg + bars + marks + rings + "</svg>\n";
}

std::string chart_key(FrontOf front_of) {
  const auto item = [](const std::string& shape, std::string_view words) {
    return fmt::format(
        "<li><svg class=\"chart\" viewBox=\"0 0 16 16\" aria-hidden=\"true\">{}</svg>{}</li>",
        shape, words);
  };
  std::string html = "<ul class=\"key\">";
  for (const rules::Outcome outcome :
       {rules::Outcome::pass, rules::Outcome::fail, rules::Outcome::undecided}) {
    html += item(mark(outcome, 8, 8), report::outcome_words(outcome));
  }
  return html +
         item(
             "<circle class=\"ring\" cx=\"8\" cy=\"8\" r=\"6\"/>",
             front_of == FrontOf::price
                 ? "on the front: no variant that passes has a lower price with as large a margin"
                 : "on the front: no variant that passes needs less power with as large a margin") +
         item("<path class=\"m bar pass\" d=\"M8,1V15\"/>", "interval of the margin") + "</ul>\n";
}

struct OfValue {
  OutcomeCounts counts;
  std::vector<double> margins;
};

// For one path: what its values come to, over all values of the others.
std::string value_chart(const Sweep& sweep, std::size_t path, const MarginScale& scale) {
  const Vary& vary = sweep.vary[path];
  std::map<std::string_view, OfValue> of_value;
  for (const SweepRow& row : sweep.rows) {
    OfValue& one = of_value[row.values[path]];
    one.counts.add(row.outcome);
    if (row.margin) one.margins.push_back(row.margin->value);
  }
  const auto count = static_cast<double>(vary.values.size());
  const double width = std::clamp(86.0 + 42.0 * count, 260.0, 1040.0);
  const report::PlotFrame frame{width, 330, 62, 12, 30, 98};
  const double step = frame.field_width() / count;
  const auto every = static_cast<std::size_t>(std::ceil(40.0 / step));
  std::string svg = fmt::format(
      "<figure style=\"width:{0}px\"><svg class=\"chart\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\">\n",
      svg_number(width), svg_number(frame.height),
      escape_html("Smallest margin and verdicts by " + vary.path));
  svg += "<g class=\"name\">" + svg_text(frame.left, 16, "start", vary.path) + "</g>\n";
  svg += margin_axis(frame, scale);
  const struct {
    const char* symbol;
    const char* tone;
    std::size_t OutcomeCounts::*count;
  } kLines[] = {{"✓", "pass", &OutcomeCounts::pass},
                {"✗", "fail", &OutcomeCounts::fail},
                {"?", "undecided", &OutcomeCounts::undecided},
                {"–", "not-judged", &OutcomeCounts::not_judged}};
  for (std::size_t l = 0; l < 4; ++l) {
    svg +=
        fmt::format("<text class=\"count {}\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n",
                    kLines[l].tone, svg_number(frame.left - 6),
                    svg_number(frame.y_end() + 38 + 16 * static_cast<double>(l)), kLines[l].symbol);
  }
  for (std::size_t v = 0; v < vary.values.size(); ++v) {
    const double x = frame.left + (static_cast<double>(v) + 0.5) * step;
    OfValue& one = of_value[vary.values[v]];
    if (!one.margins.empty()) {
      std::sort(one.margins.begin(), one.margins.end());
      const double half = std::min(9.0, 0.3 * step);
      const double top = frame.y(scale.share(one.margins.back()));
      const double bottom = frame.y(scale.share(one.margins.front()));
      const double middle = frame.y(scale.share(one.margins[one.margins.size() / 2]));
      svg += fmt::format(
          "<rect class=\"range\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/><path class=\"mid\" "
          "d=\"M{},{}h{}\"/>\n",
          svg_number(x - half), svg_number(top), svg_number(2 * half),
          svg_number(std::max(bottom - top, 0.5)), svg_number(x - half), svg_number(middle),
          svg_number(2 * half));
    }
    if (v % every != 0) continue;
    svg += svg_text(x, frame.y_end() + 18, "middle",
                    calc::shorten_utf8(report::printable(vary.values[v]), 24)) +
           "\n";
    for (std::size_t l = 0; l < 4; ++l) {
      svg += fmt::format(
          "<text class=\"count {}\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
          kLines[l].tone, svg_number(x),
          svg_number(frame.y_end() + 38 + 16 * static_cast<double>(l)),
          one.counts.*kLines[l].count);
    }
  }
  return svg + "</svg></figure>\n";
}

std::string verdict_badge(rules::Outcome outcome) {
  return fmt::format("<span class=\"badge {}\"><span class=\"sign\">{}</span>{}</span>",
                     tone_of(outcome), report::outcome_symbol(outcome),
                     report::outcome_words(outcome));
}

std::string rows_table(const Sweep& sweep, const std::vector<const SweepRow*>& rows,
                       bool with_command) {
  std::string html = "<table><thead><tr><th class=\"num\">no.</th>";
  for (const Vary& vary : sweep.vary) html += "<th>" + escape_html(vary.path) + "</th>";
  html +=
      "<th>verdict</th><th class=\"num\">smallest margin</th><th>of</th><th "
      "class=\"num\">power</th>";
  const bool with_price = has_prices(sweep);
  if (with_price) html += "<th class=\"num\">price</th>";
  html += with_command ? "<th>this one alone</th>"
                       : fmt::format("<th>front of {}</th>", cost_name(sweep));
  html += "</tr></thead><tbody>\n";
  for (const SweepRow* row : rows) {
    html += fmt::format("<tr><td class=\"num\">{}</td>", row->variant + 1);
    for (const std::string& value : row->values) html += "<td>" + escape_html(value) + "</td>";
    html += fmt::format("<td>{}</td><td class=\"num\">{}</td><td>{}</td><td class=\"num\">{}</td>",
                        verdict_badge(row->outcome),
                        escape_html(report::with_minus(margin_words(*row))),
                        escape_html(row->reason.empty() ? requirement_words(*row) : row->reason),
                        escape_html(power_words(*row)));
    if (with_price) {
      html += fmt::format("<td class=\"num\">{}</td>", escape_html(price_words(*row)));
    }
    html += with_command
                ? "<td class=\"command\"><code>" + escape_html(check_command(sweep, *row)) +
                      "</code></td></tr>\n"
                : fmt::format("<td>{}</td></tr>\n",
                              row->pareto == ParetoPlace::off ? "" : calc::name_of(row->pareto));
  }
  return report::scroll_box("variants", html + "</tbody></table>\n");
}

}  // namespace

std::string render_sweep_html(const Sweep& sweep) {
  const OutcomeCounts counts = count_outcomes(sweep.rows);
  const std::string title = fmt::format("{} variants: {}", sweep.rows.size(), counts.words());
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\"/>\n<title>" +
      escape_html(title) + "</title>\n<style>\n" + report::html_style() + kSweepStyle +
      "</style>\n</head>\n<body>\n<p class=\"eyebrow\">luxgate sweep</p>\n";
  html += fmt::format("<h1>{}</h1>\n<p class=\"quiet\">{}<br/><code>{}</code></p>\n",
                      escape_html(title), escape_html(sweep.project),
                      escape_html(sweep.provenance.command_line));
  for (const std::string& note : sweep_notes(sweep)) {
    html += "<p class=\"message\">" + escape_html(note) + "</p>\n";
  }
  std::vector<const SweepRow*> front, all;
  for (const SweepRow& row : sweep.rows) {
    if (row.pareto == ParetoPlace::on) front.push_back(&row);
    if (all.size() < kMostRowsOfPage) all.push_back(&row);
  }
  std::stable_sort(front.begin(), front.end(), [&](const SweepRow* a, const SweepRow* b) {
    return drawn_cost(sweep, *a) < drawn_cost(sweep, *b);
  });
  const MarginScale scale(sweep.rows);
  html += fmt::format(
      "<h2>Margin over {0}</h2>\n<p class=\"quiet\">Each mark is a variant: its smallest "
      "margin over all requirements, relative to the limit, and its {1}. Variants of the same {0} "
      "stand side by side, in their order.</p>\n",
      cost_name(sweep), installed_words(sweep.front_of));
  html += cost_chart(sweep, scale) + chart_key(sweep.front_of);
  const auto undrawn = std::count_if(sweep.rows.begin(), sweep.rows.end(),
                                     [&](const SweepRow& row) { return !is_drawn(sweep, row); });
  if (undrawn > 0) {
    html += fmt::format(
        "<p class=\"quiet\">{} variants have no margin or no known {}, and are not in this "
        "picture.</p>\n",
        undrawn, cost_name(sweep));
  }
  html +=
      "<h2>By value</h2>\n<p class=\"quiet\">For each value, over all values of the other "
      "paths: the range of smallest margins with its middle, and how many variants pass (✓), "
      "fail (✗), are undecided (?) or not judged (–).</p>\n<div class=\"multiples\">\n";
  for (std::size_t v = 0; v < sweep.vary.size(); ++v) html += value_chart(sweep, v, scale);
  html += fmt::format("</div>\n<h2>On the front of margin and {}</h2>\n", cost_name(sweep));
  if (front.empty()) {
    html += fmt::format("<p class=\"message\">No variant passes with a known {} and margin.</p>\n",
                        cost_name(sweep));
  } else {
    const std::size_t more = front.size() - std::min(front.size(), kMostRowsOfFront);
    front.resize(std::min(front.size(), kMostRowsOfFront));
    html += rows_table(sweep, front, true);
    if (more > 0) html += fmt::format("<p class=\"quiet\">And {} more.</p>\n", more);
  }
  html += "<h2>All variants</h2>\n" + rows_table(sweep, all, false);
  if (all.size() < sweep.rows.size()) {
    html += fmt::format("<p class=\"quiet\">{} more are in CSV and JSON.</p>\n",
                        sweep.rows.size() - all.size());
  }
  const report::Provenance& provenance = sweep.provenance;
  html +=
      "<h2>How to read it</h2>\n<table>\n" +
      report::fact("Program", escape_html("luxgate " + provenance.program_version)) +
      report::fact("Backend", escape_html(provenance.backend)) +
      report::fact("Confidence of intervals", report::format_percent(provenance.confidence)) +
      report::fact("Goal", escape_html(std::string(calc::name_of(provenance.goal)))) +
      (provenance.judged_on.empty()
           ? ""
           : report::fact("Judged on", escape_html(provenance.judged_on))) +
      "</table>\n<p>With the goal 'verdict' a plane is calculated until its requirements pass or "
      "fail: intervals of margins are then as wide as that allows. '--goal accuracy' makes "
      "them narrow. A variant is 'perhaps' on the front where others beat it by their "
      "values, but none with its whole interval.</p>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace cli
