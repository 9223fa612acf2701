#include "report/html/drawings/html_legend.h"

#include "calc/base/elementary.h"
#include "calc/base/utf8.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace report {
namespace {

// The bar, its boxes of equal width, and the words at it: of a screen, or as large as paper has it.
struct BarForm {
  double left = 14, width = 440, height = 14, limit_line = 17, all_width = 480, histogram = 40,
         numbers = 20, text = 11;  // px
};
constexpr BarForm kOnScreen{};
// Words of 6.5 points, nothing for which paper has no place.
constexpr BarForm kOnPaper{12, 232, 9, 10.5, 272, 0, 12, 8.7};

double bar_x(const BarForm& form, const ColourScale& scale, double value) {
  const double band_width = form.width / scale.bands;
  if (value <= scale.low) return form.left;
  for (int band = 0; band < scale.bands; ++band) {
    const double low = scale.border(band), high = scale.border(band + 1);
    if (value <= high) return form.left + (band + (value - low) / (high - low)) * band_width;
  }
  return form.left + form.width;
}

// Decimals that tell neighbouring band limits apart.
int step_decimals(double step) {
  return std::max(0, -static_cast<int>(std::floor(calc::log10(step) + 1e-9)));
}

std::string border_words(const Texts& t, const ColourScale& scale, int border) {
  const double value = scale.border(border);
  if (!scale.has_classes()) return format_fixed(t, value, step_decimals(scale.step));
  return format_level(t, value);
}

std::string band_boxes(const BarForm& form, const ColourScale& scale, double top) {
  std::string svg;
  const double width = form.width / scale.bands;
  for (int band = 0; band < scale.bands; ++band) {
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>",
                       svg_number(form.left + band * width), svg_number(top),
                       svg_number(width + 0.3), form.height, hex_colour(band_colour(scale, band)));
  }
  return svg + fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
                           form.left, svg_number(top), form.width, form.height);
}

// How many points lie in each band: heights are shares of the fullest one.
std::string histogram_bars(const Texts& t, const BarForm& form, const ColourScale& scale,
                           const std::vector<std::size_t>& counts, double bottom) {
  std::size_t most = 0;
  for (const std::size_t count : counts) most = std::max(most, count);
  if (most == 0) return {};
  const double width = form.width / scale.bands;
  constexpr double kGap = 1.5;
  std::string svg = "<g class=\"histogram\">";
  for (std::size_t band = 0; band < counts.size(); ++band) {
    if (counts[band] == 0) continue;
    const double share = static_cast<double>(counts[band]) / static_cast<double>(most);
    const double height = std::max(1.5, share * (form.histogram - 6));
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}</title></rect>",
        svg_number(form.left + static_cast<double>(band) * width + kGap),
        svg_number(bottom - height - 2), svg_number(width - 2 * kGap), svg_number(height),
        counts[band] == 1 ? t.say<Text::one_point>(counts[band])
                          : t.say<Text::many_points>(counts[band]));
  }
  return svg + "</g>";
}

// Roughly, of the fonts that pages have.
double words_width(const BarForm& form, std::string_view words) {
  const auto characters = std::count_if(
      words.begin(), words.end(), [](char byte) { return !calc::is_utf8_continuation(byte); });
  return 0.6 * form.text * static_cast<double>(characters);
}

// Those that there is room for; the first one always.
std::string band_numbers(const Texts& t, const BarForm& form, const ColourScale& scale,
                         double top) {
  constexpr double kGap = 3;
  std::string svg;
  double free_x = 0;
  for (int i = 0; i <= scale.bands; ++i) {
    const std::string number = border_words(t, scale, i);
    const double x = form.left + i * form.width / scale.bands;
    const double width = words_width(form, number);
    if (i > 0 && x - 0.5 * width < free_x) continue;
    free_x = x + 0.5 * width + kGap;
    svg += svg_text(x, top + form.height + 0.85 * form.numbers - 3, "middle", number);
  }
  return svg;
}

// A label beside its mark, on the side with room; the line runs down through the bar.
std::string limit_mark(const BarForm& form, const ColourScale& scale, const PlanLimit& limit,
                       double y, double bar_top) {
  const double x = bar_x(form, scale, limit.limit);
  const bool is_below = limit.limit < scale.low;
  const bool is_above = limit.limit > scale.high();
  const bool to_the_left = x > form.left + form.width / 2;
  const std::string words =
      (is_below ? "◂ " : "") + escape_html(limit.words) + (is_above ? " ▸" : "");
  std::string svg =
      fmt::format("<text class=\"limit\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>",
                  svg_number(x + (to_the_left ? -5 : 5)),
                  svg_number(y + form.limit_line - 5 * form.limit_line / kOnScreen.limit_line),
                  to_the_left ? "end" : "start", words);
  if (is_below || is_above) return svg;
  return svg +
         fmt::format(
             "<path class=\"halo\" d=\"M{0} {2}v{3}\"/><path class=\"mark\" d=\"M{0} {1}V{4}\"/>",
             svg_number(x), svg_number(y + 3), svg_number(bar_top), form.height,
             svg_number(bar_top + form.height));
}

double bar_height_px(const BarForm& form, std::size_t lines, bool has_counts) {
  return form.limit_line * static_cast<double>(lines) + 4 + (has_counts ? form.histogram : 0) +
         form.height + form.numbers;
}

std::string scale_words(const Texts& t, const ColourScale& scale, std::string_view unit) {
  if (!scale.has_classes()) {
    return t.say<Text::colour_scale>(format_level(t, scale.low), format_level(t, scale.high()),
                                     unit, format_level(t, scale.step), unit);
  }
  std::string borders;
  for (int i = 0; i <= scale.bands; ++i)
    borders += (i == 0 ? "" : " · ") + border_words(t, scale, i);
  return t.say<Text::colour_classes>(borders, unit);
}

std::string colour_bar(const Texts& t, const BarForm& form, const char* name,
                       const ColourScale& scale, const std::vector<PlanLimit>& limits,
                       const std::vector<std::size_t>& counts, std::string_view unit) {
  const double height = bar_height_px(form, limits.size(), !counts.empty());
  const double bar_top = height - form.height - form.numbers;
  std::string svg = fmt::format(
      "<svg class=\"{3}\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\">",
      form.all_width, svg_number(height), scale_words(t, scale, unit), name);
  svg += histogram_bars(t, form, scale, counts, bar_top) + band_boxes(form, scale, bar_top);
  double y = 0;
  for (const PlanLimit& limit : limits) {
    svg += limit_mark(form, scale, limit, y, bar_top);
    y += form.limit_line;
  }
  svg += band_numbers(t, form, scale, bar_top);
  svg +=
      fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" class=\"unit\">{}</text>",
                  form.all_width, svg_number(bar_top + form.height - 3 * form.height / 14), unit);
  return svg + "</svg>\n";
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
  return bar_height_px(kOnScreen, limits, has_counts);
}

std::string html_colour_bar(const Texts& t, const ColourScale& scale,
                            const std::vector<PlanLimit>& limits,
                            const std::vector<std::size_t>& counts, std::string_view unit) {
  return colour_bar(t, kOnScreen, "colour-bar", scale, limits, counts, unit);
}

std::string html_paper_colour_bar(const Texts& t, const ColourScale& scale,
                                  const std::vector<PlanLimit>& limits, std::string_view unit) {
  return colour_bar(t, kOnPaper, "colour-bar paper", scale, limits, {}, unit);
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
