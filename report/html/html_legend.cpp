#include "report/html/html_legend.h"

#include "calc/base/elementary.h"
#include "report/html/html_markup.h"
#include "report/text/markup.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

constexpr double kBarLeft = 14, kBarWidth = 440, kBarHeight = 14, kLimitLine = 17,
                 kLegendWidth = 480, kHistogramHeight = 40, kNumbersHeight = 20;

double bar_x(const ColourScale& scale, double value) {
  const double part = (value - scale.low) / (scale.high() - scale.low);
  return kBarLeft + std::clamp(part, 0.0, 1.0) * kBarWidth;
}

// Decimals that tell neighbouring band limits apart.
int step_decimals(double step) {
  return std::max(0, -static_cast<int>(std::floor(calc::log10(step) + 1e-9)));
}

std::string band_boxes(const ColourScale& scale, double top) {
  std::string svg;
  const double width = kBarWidth / scale.bands;
  for (int band = 0; band < scale.bands; ++band) {
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>",
                       svg_number(kBarLeft + band * width), svg_number(top),
                       svg_number(width + 0.3), kBarHeight, hex_colour(band_colour(scale, band)));
  }
  return svg + fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                           kBarLeft, svg_number(top), kBarWidth, kBarHeight);
}

// How many points lie in each band: heights are shares of the fullest one.
std::string histogram_bars(const Texts& t, const ColourScale& scale,
                           const std::vector<std::size_t>& counts, double bottom) {
  std::size_t most = 0;
  for (const std::size_t count : counts) most = std::max(most, count);
  if (most == 0) return {};
  const double width = kBarWidth / scale.bands;
  constexpr double kGap = 1.5;
  std::string svg = "<g class=\"histogram\">";
  for (std::size_t band = 0; band < counts.size(); ++band) {
    if (counts[band] == 0) continue;
    const double share = static_cast<double>(counts[band]) / static_cast<double>(most);
    const double height = std::max(1.5, share * (kHistogramHeight - 6));
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}</title></rect>",
        svg_number(kBarLeft + static_cast<double>(band) * width + kGap),
        svg_number(bottom - height - 2), svg_number(width - 2 * kGap), svg_number(height),
        counts[band] == 1 ? t.say<Text::one_point>(counts[band])
                          : t.say<Text::many_points>(counts[band]));
  }
  return svg + "</g>";
}

std::string band_numbers(const Texts& t, const ColourScale& scale, double top) {
  std::string svg;
  for (int i = 0; i <= scale.bands; ++i) {
    const double value = scale.low + i * scale.step;
    svg += svg_text(bar_x(scale, value), top + kBarHeight + 14, "middle",
                    format_fixed(t, value, step_decimals(scale.step)));
  }
  return svg;
}

// A label beside its mark, on the side with room; the line runs down through the bar.
std::string limit_mark(const ColourScale& scale, const PlanLimit& limit, double y, double bar_top) {
  const double x = bar_x(scale, limit.limit);
  const bool is_below = limit.limit<scale.low, is_above = limit.limit> scale.high();
  const bool to_the_left = x > kBarLeft + kBarWidth / 2;
  const std::string words =
      (is_below ? "◂ " : "") + escape_html(limit.words) + (is_above ? " ▸" : "");
  std::string svg =
      fmt::format("<text class=\"limit\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>",
                  svg_number(x + (to_the_left ? -5 : 5)), svg_number(y + 12),
                  to_the_left ? "end" : "start", words);
  if (is_below || is_above) return svg;
  return svg +
         fmt::format(
             "<path class=\"halo\" d=\"M{0} {2}v{3}\"/><path class=\"mark\" d=\"M{0} {1}V{4}\"/>",
             svg_number(x), svg_number(y + 3), svg_number(bar_top), kBarHeight,
             svg_number(bar_top + kBarHeight));
}

std::string key_item(const std::string& picture, const std::string& words,
                     const char* attributes = "") {
  return fmt::format(
      "<li{}><svg width=\"16\" height=\"16\" viewBox=\"0 0 16 16\" "
      "aria-hidden=\"true\">{}</svg>{}</li>",
      attributes, picture, words);
}

}  // namespace

double colour_bar_height_px(std::size_t limits, bool has_counts) {
  return kLimitLine * static_cast<double>(limits) + 4 + (has_counts ? kHistogramHeight : 0) +
         kBarHeight + kNumbersHeight;
}

std::string html_colour_bar(const Texts& t, const ColourScale& scale,
                            const std::vector<PlanLimit>& limits,
                            const std::vector<std::size_t>& counts, std::string_view unit) {
  const double height = colour_bar_height_px(limits.size(), !counts.empty());
  const double bar_top = height - kBarHeight - kNumbersHeight;
  std::string svg = fmt::format(
      "<svg class=\"colour-bar\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\">",
      kLegendWidth, svg_number(height),
      t.say<Text::colour_scale>(format_shortest(t, scale.low), format_shortest(t, scale.high()),
                                unit, format_shortest(t, scale.step), unit));
  svg += histogram_bars(t, scale, counts, bar_top) + band_boxes(scale, bar_top);
  double y = 0;
  for (const PlanLimit& limit : limits) {
    svg += limit_mark(scale, limit, y, bar_top);
    y += kLimitLine;
  }
  svg += band_numbers(t, scale, bar_top);
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" class=\"unit\">{}</text>",
                     kLegendWidth, svg_number(bar_top + kBarHeight - 3), unit);
  return svg + "</svg>\n";
}

std::string html_plan_key(const Texts& t, const PlanSigns& signs) {
  std::string items = key_item(
      "<rect x=\"2\" y=\"2\" width=\"12\" height=\"12\" class=\"min-halo\"/>"
      "<rect x=\"2\" y=\"2\" width=\"12\" height=\"12\" class=\"min-mark\"/>",
      t.say<Text::key_minimum>(escape_html(signs.minimum)), " class=\"calculated\"");
  const std::string hatch =
      "<rect x=\"1\" y=\"1\" width=\"14\" height=\"14\" class=\"sample\"/>"
      "<rect x=\"1\" y=\"1\" width=\"14\" height=\"14\" fill=\"url(#hatch-" +
      signs.anchor + ")\"/>";
  if (!signs.below.empty())
    items += key_item(hatch, escape_html(signs.below), " class=\"calculated\"");
  if (!signs.above.empty())
    items += key_item(hatch, escape_html(signs.above), " class=\"calculated\"");
  if (signs.luminaires > 0) {
    items +=
        key_item(signs.has_openings ? "<path class=\"luminaire\" d=\"M1 5.5h14v5h-14z\"/>"
                                    : "<g class=\"luminaire\"><circle cx=\"8\" cy=\"8\" r=\"5\"/>"
                                      "<path d=\"M4.5 4.5l7 7M11.5 4.5l-7 7\"/></g>",
                 t.say<Text::key_luminaire>(signs.luminaires));
  }
  if (signs.has_directions) {
    items += key_item("<path class=\"c0\" d=\"M1 8h11M9 4.5l5 3.5-5 3.5z\"/>", t[Text::key_c0]);
  }
  if (signs.has_isolux) {
    items +=
        key_item("<path class=\"isolux\" d=\"M0 11C5 11 8 4 16 4\"/>",
                 signs.unit.empty() ? t[Text::key_isoline] : t.say<Text::key_isolux>(signs.unit));
  }
  if (!signs.required.empty()) {
    const std::string required = escape_html(signs.required);
    items += key_item("<path class=\"isolux required\" d=\"M0 11C5 11 8 4 16 4\"/>",
                      signs.unit.empty() ? t.say<Text::key_required_isoline>(required)
                                         : t.say<Text::key_required_isolux>(required));
  }
  if (signs.has_furniture) {
    items += key_item("<path class=\"furniture\" d=\"M2.5 4.5h11v7h-11z\"/>",
                      t[signs.has_above ? Text::key_furniture_above : Text::key_furniture]);
  }
  return "<ul class=\"key\">" + items + "</ul>\n";
}

}  // namespace report
