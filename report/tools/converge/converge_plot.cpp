#include "report/tools/converge/converge_plot.h"

#include "calc/base/elementary.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace report {
namespace {

constexpr PlotFrame kPlotFrame{400, 292, 62, 12, 10, 44};

struct Axis {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;  // values
  double from = 0.0, to = 1.0;                                       // places

  void add(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // Room around everything, at least half a decade in all.
  void finish(double begin, double end) {
    from = begin;
    to = end;
    const double narrow = std::max(0.0, 0.25 - 0.5 * calc::log10(high / low));
    low /= calc::pow(10.0, narrow + 0.08);
    high *= calc::pow(10.0, narrow + 0.08);
  }
  double at(double value) const {
    const double share = calc::log(std::max(value, 1e-300) / low) / calc::log(high / low);
    return from + (to - from) * share;
  }
  bool shows(double value) const { return value >= low && value <= high; }
};

struct Tick {
  double value;
  bool is_labelled;
};

// 1, 2 and 5 of every decade; labels where there is room.
std::vector<Tick> ticks_of(const Axis& axis) {
  const double decades = calc::log10(axis.high / axis.low);
  std::vector<Tick> ticks;
  for (int d = static_cast<int>(std::floor(calc::log10(axis.low))); calc::pow(10.0, d) <= axis.high;
       ++d) {
    for (const int step : {1, 2, 5}) {
      const double value = step * calc::pow(10.0, d);
      if (!axis.shows(value)) continue;
      const bool has_room = decades <= 2.2 || (step == 1 && (decades <= 6.0 || d % 2 == 0));
      if (step == 1 || decades <= 3.2) ticks.push_back({value, has_room});
    }
  }
  return ticks;
}

// Of 1, 2 or 5 times a power of ten; "5e-8" where zeros would not fit beside the plot.
std::string short_number(double value) {
  const int exponent = static_cast<int>(std::floor(calc::log10(value) + 1e-9));
  if (exponent < -3) return fmt::format("{:.0f}e{}", value / calc::pow(10.0, exponent), exponent);
  return format_fixed(value, std::max(-exponent, 0));
}

std::string percent_label(double share) {
  const std::string number = short_number(100.0 * share);
  return number + (number.size() > 4 && number.find('e') != std::string::npos ? "%" : " %");
}

std::string x_label(double value, PlotUnit unit) {
  if (unit == PlotUnit::seconds) {
    return value < 0.0999 ? short_number(1e3 * value) + " ms" : short_number(value) + " s";
  }
  if (value > 0.999e6) return short_number(1e-6 * value) + " M";
  return value > 0.999e3 ? short_number(1e-3 * value) + " k" : short_number(value);
}

std::string xy(double x, double y) { return svg_number(x) + "," + svg_number(y); }

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return svg_text(x, y, anchor, words) + "\n";
}

std::string line(const char* kind, double x0, double y0, double x1, double y1) {
  return fmt::format("<path class=\"{}\" d=\"M{}L{}\"/>\n", kind, xy(x0, y0), xy(x1, y1));
}

std::string grid(const Axis& x, const Axis& y, const PlotSpec& spec) {
  std::string svg;
  for (const Tick& tick : ticks_of(x)) {
    svg += line(tick.is_labelled ? "rule" : "rule faint", x.at(tick.value), y.from,
                x.at(tick.value), y.to);
    if (tick.is_labelled) {
      svg += text(x.at(tick.value), y.from + 16, "middle",
                  spec.t.number(x_label(tick.value, spec.unit)));
    }
  }
  for (const Tick& tick : ticks_of(y)) {
    svg += line(tick.is_labelled ? "rule" : "rule faint", x.from, y.at(tick.value), x.to,
                y.at(tick.value));
    if (tick.is_labelled) {
      svg +=
          text(x.from - 7, y.at(tick.value) + 4, "end", spec.t.number(percent_label(tick.value)));
    }
  }
  svg += line("base", x.from, y.from, x.to, y.from);
  return svg + text(0.5 * (x.from + x.to), y.from + 35, "middle", spec.x_title);
}

// Through the middle of the picture, as far as it is inside.
std::string guide(const Axis& x, const Axis& y) {
  const double x0 = std::sqrt(x.low * x.high), y0 = std::sqrt(y.low * y.high);
  const auto y_at = [&](double value) { return y0 * std::sqrt(x0 / value); };
  const double left = std::max(x.low, x0 * calc::pow(y0 / y.high, 2));
  const double right = std::min(x.high, x0 * calc::pow(y0 / y.low, 2));
  return line("guide", x.at(left), y.at(y_at(left)), x.at(right), y.at(y_at(right)));
}

// One of four shapes of about the same weight.
std::string marker(std::size_t colour, double x, double y) {
  switch (colour % 4) {
    case 0:
      return fmt::format("M{}a3.4,3.4 0 1 0 6.8,0a3.4,3.4 0 1 0 -6.8,0z", xy(x - 3.4, y));
    case 1:
      return fmt::format("M{}h6v6h-6z", xy(x - 3, y - 3));
    case 2:
      return fmt::format("M{}l4,6.8h-8z", xy(x, y - 4.2));
    default:
      return fmt::format("M{}l4.3,4.3l-4.3,4.3l-4.3,-4.3z", xy(x, y - 4.3));
  }
}

std::string series_svg(const PlotSeries& series, const Axis& x, const Axis& y) {
  std::string forth, back, curve, markers;
  for (const PlotPoint& p : series.points) {
    if (!(p.y > 0.0) || !(p.x > 0.0)) continue;
    const double px = x.at(p.x), py = y.at(p.y);
    forth += (forth.empty() ? "M" : "L") + xy(px, y.at(std::min(p.high, 10.0 * y.high)));
    back = "L" + xy(px, y.at(std::max(p.low, 0.1 * y.low))) + back;
    curve += (curve.empty() ? "M" : "L") + xy(px, py);
    markers += fmt::format("<path class=\"{}\" d=\"{}\"><title>{}</title></path>\n",
                           p.is_hollow ? "mark hollow" : "mark", marker(series.colour, px, py),
                           escape_html(p.words));
  }
  if (curve.empty()) return "";
  return fmt::format(
      "<g class=\"m{}\"><path class=\"band\" d=\"{}{}z\"/><path class=\"curve\" d=\"{}\"/>\n"
      "{}</g>\n",
      series.colour % 8, forth, back, curve, markers);
}

}  // namespace

std::string log_log_plot(const PlotSpec& spec) {
  Axis x, y;
  for (const PlotSeries& series : spec.series) {
    for (const PlotPoint& p : series.points) {
      if (!(p.x > 0.0) || !(p.y > 0.0)) continue;
      x.add(p.x);
      y.add(p.y);
      y.add(p.high);
      y.add(std::max(p.low, p.y / 4.0));  // one lucky seed does not squeeze all others
    }
  }
  if (!(x.high > 0.0) || !(y.high > 0.0)) return "";
  x.finish(kPlotFrame.left, kPlotFrame.x_end());
  y.finish(kPlotFrame.y_end(), kPlotFrame.top);
  std::string svg = fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
      "aria-label=\"{2}\">\n",
      svg_number(kPlotFrame.width), svg_number(kPlotFrame.height),
      escape_html(spec.title + ", " + spec.x_title));
  svg += grid(x, y, spec);
  svg += fmt::format(
      "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\" "
      "overflow=\"hidden\">\n",
      svg_number(kPlotFrame.left), svg_number(kPlotFrame.top), svg_number(kPlotFrame.field_width()),
      svg_number(kPlotFrame.field_height()));
  svg += guide(x, y);
  if (spec.floor && y.shows(*spec.floor)) {
    svg += line("floor-line", x.from, y.at(*spec.floor), x.to, y.at(*spec.floor));
    svg += text(x.to - 4, y.at(*spec.floor) - 4, "end", spec.t[Text::converge_floor]);
  }
  for (const PlotSeries& series : spec.series) svg += series_svg(series, x, y);
  return svg + "</svg>\n</svg>\n";
}

}  // namespace report
