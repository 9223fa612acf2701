#include "report/html/chapters/sheet_body.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/glare/mean_luminance.h"
#include "calc/glare/ugr_table.h"
#include "calc/photometry/web_measures.h"
#include "report/document/document.h"
#include "report/html/page/html_markup.h"
#include "report/images/polar_diagram.h"
#include "report/text/base64.h"
#include "report/text/markup.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace report {
namespace {

constexpr const char* kSheetStyle = R"css(
.sheet { display: grid; grid-template-columns: repeat(auto-fit, minmax(19rem, 1fr)); gap: 1.2rem 2.4rem; align-items: start; margin: 1.2rem 0; }
.sheet figure { flex: none; }
.sheet img { display: block; width: 100%; max-width: 24rem; height: auto; }
.cone { display: block; width: 100%; max-width: 24rem; height: auto; }
.sheet p { margin: 0; } .key { stroke-width: 2; }
.cone text { font-size: 12px; fill: var(--quiet); }
.cone .value { fill: var(--ink); }
.cone .rule { stroke: var(--line); } .cone .c0 { fill: none; stroke: var(--link); stroke-width: 1.6; }
.cone .c90 { fill: none; stroke: var(--open); stroke-width: 1.6; stroke-dasharray: 7 4; }
.sheet > div { display: grid; gap: 1rem; } .sheet p { font-size: .85rem; }
h5.sheet-heading { font-size: 1.02rem; margin: 1.6rem 0 .8rem; line-height: 1.2; }
.intensities td, .intensities th { text-align: right; white-space: nowrap; min-width: 0 !important; padding: .12rem .6rem .12rem 0; }
.intensities { width: auto; font-size: .8rem; }
.ugr { width: auto; } .ugr td, .ugr th { text-align: right; white-space: nowrap; min-width: 0 !important; padding: .18rem .6rem; }
.ugr .size { color: var(--quiet); font-weight: 400; } .ugr .first { padding-left: 1.6rem; }
.ugr .reference td { font-weight: 650; background: var(--soft); }
@media (max-width: 40rem) { .sheet .facts tbody th { white-space: normal; width: 45%; } }
.data-sheet { margin: 1.2rem 0; border-bottom: 1px solid var(--line); padding-bottom: 1.2rem; }
@media print {
  .data-sheets, .data-sheet + .data-sheet { break-before: page; }
  .data-sheets { break-after: page; }
  .data-sheets > p { margin-bottom: 2mm; }
  .data-sheet .scroll { break-inside: avoid; }
  .data-sheets > h3 { margin-top: 0; } .data-sheet { margin: 0; border: 0; padding: 0; }
  .sheet { gap: 2mm 6mm; margin: 3mm 0; grid-template-columns: 1fr 1fr; }
  .sheet.drawings { grid-template-columns: 1.4fr 1fr 1fr; } .cone text { font-size: 21px; }
  .sheet img, .cone { max-width: 100%; max-height: 47mm; width: auto; }
  .intensities { font-size: .74rem !important; } .intensities td, .intensities th { padding: .03rem .5rem .03rem 0; line-height: 1.25; }
  .ugr { font-size: .74rem; } .ugr td, .ugr th { padding: .05rem .5rem; line-height: 1.25; }
  .sheet .facts th, .sheet .facts td { padding-top: .08rem; padding-bottom: .08rem; }
  h5.sheet-heading { margin: 3mm 0 1mm; font-size: 1rem; break-after: avoid; }
}
)css";

std::string or_none(const Texts& t, const std::string& words) {
  return words.empty() ? t[Text::not_stated] : escape_html(words);
}

std::string degrees(const Texts& t, double rad) {
  return format_fixed(t, calc::degrees_from_radians(rad), 1) + "°";
}

// Of the flux below the horizon so much lies within 41.4, 60 and 75.5 degrees; the downward share;
// the light output ratio.  [CIE 52]
std::string flux_code(const calc::PhotometricWeb& web) {
  const double down = web.zonal_flux_lm(0.0, 0.5 * calc::kPi);
  const auto whole = [](double share) { return fmt::format("{:.0f}", 100.0 * share); };
  std::string code;
  for (const double solid_angle : {0.5, 1.0, 1.5}) {  // of pi
    const double gamma = calc::acos(1.0 - 0.5 * solid_angle);
    code += (down > 0.0 ? whole(web.zonal_flux_lm(0.0, gamma) / down) : "0") + " ";
  }
  code += whole(down / web.flux_lm());
  const double lamps = web.source().rated_lamp_flux_lm;
  return code + " " + (lamps > 0.0 ? whole(web.flux_lm() / lamps) : "100");
}

// The plane pairs C0-C180 and C90-C270.
using BeamWidths = std::array<calc::BeamWidth, 2>;

BeamWidths beam_widths(const calc::PhotometricWeb& web, double share) {
  return {calc::beam_width(web, 0.0, share), calc::beam_width(web, 0.5 * calc::kPi, share)};
}

constexpr double kBeamShare = 0.5, kFieldShare = 0.1;

std::string beam_words(const Texts& t, const BeamWidths& widths) {
  const auto one = [&](const calc::BeamWidth& width) {
    return width.lobes == 0 ? std::string("–") : degrees(t, width.lobe_rad);
  };
  return one(widths[0]) + " × " + one(widths[1]);
}

std::string opening_words(const Texts& t, const calc::LuminousOpening& opening) {
  if (opening.shape == calc::OpeningShape::point) return t[Text::sheet_point];
  const auto mm = [](double metres) { return fmt::format("{:.0f}", 1000.0 * metres); };
  const bool is_round =
      opening.shape == calc::OpeningShape::disk || opening.shape == calc::OpeningShape::cylinder;
  std::string words = is_round && opening.along_c0_m == opening.along_c90_m
                          ? "⌀ " + mm(opening.along_c0_m)
                          : mm(opening.along_c0_m) + " × " + mm(opening.along_c90_m);
  if (opening.height_m > 0.0) words += " × " + mm(opening.height_m);
  return words + " mm";
}

// Product and light side by side.
std::string figures(const Texts& t, const SheetLight& light, const std::string& more_facts) {
  const calc::PhotometricWeb& web = light.web;
  const calc::PhotometrySource& source = web.source();
  const double power = light.power_w;
  const bool is_one = light.emitters == 1;
  std::string left =
      fact(t[Text::sheet_maker], or_none(t, source.manufacturer)) +
      fact(t[Text::sheet_article], or_none(t, source.article_number)) +
      fact(t[Text::sheet_lamp], or_none(t, source.lamp)) +
      fact(t[Text::sheet_colour_temperature], or_none(t, source.colour_temperature)) +
      fact(t[Text::sheet_colour_rendering], or_none(t, source.colour_rendering)) +
      fact(t[Text::sheet_opening],
           is_one ? opening_words(t, web.opening()) : std::string(t[Text::sheet_openings]));
  if (!is_one) {
    left += fact(t[Text::sheet_emitters], t.say<Text::sheet_emitters_together>(light.emitters));
  }
  left += fact(t[Text::sheet_file], escape_html(light.file_name) + ", " +
                                        escape_html(source.format) + "<span class=\"hash\">" +
                                        escape_html(light.sha256) + "</span>") +
          more_facts;
  const double told_lm =
      is_one ? told_flux_lm(light.flux_lm, source.stated_flux_lm) : light.flux_lm;
  std::string right = fact(t[Text::flux], format_lumens(t, told_lm) + " lm");
  if (source.rated_lamp_flux_lm > 0.0) {
    right +=
        fact(t[Text::sheet_output_ratio], format_share(t, told_lm / source.rated_lamp_flux_lm));
  }
  const calc::Peak peak = calc::peak_of(web);
  right += fact(t[Text::power],
                power > 0.0 ? format_watts(t, power) + " W" : std::string(t[Text::not_stated])) +
           fact(t[Text::efficacy], power > 0.0 ? format_fixed(t, told_lm / power, 0) + " lm/W"
                                               : std::string(t[Text::not_stated])) +
           fact(t[Text::sheet_downward], format_share(t, calc::downward_share(web))) +
           fact(t[Text::sheet_flux_code], flux_code(web)) +
           fact(t[Text::peak], format_cell(t, peak.intensity_cd) + " cd, C " +
                                   degrees(t, peak.c_rad) + ", γ " + degrees(t, peak.gamma_rad)) +
           fact(t[Text::sheet_beam], beam_words(t, beam_widths(web, kBeamShare))) +
           fact(t[Text::sheet_field], beam_words(t, beam_widths(web, kFieldShare)));
  const auto table = [](const char* caption, const std::string& rows) {
    return fmt::format("<table class=\"facts\"><caption>{}</caption><tbody>\n{}</tbody></table>\n",
                       caption, rows);
  };
  return "<div class=\"sheet\">\n" + table(t[Text::sheet_product], left) +
         table(t[Text::sheet_light], right) + "</div>\n";
}

// --- the cone
// --------------------------------------------------------------------------------------

// How far the beam reaches to either side, per metre below the luminaire. has_cone: it holds the
// nadir and ends below the horizon.
struct Cone {
  double minus = 0.0, plus = 0.0;
  bool has_cone = false;
};

Cone cone_of(const calc::BeamWidth& beam) {
  constexpr double kWidest = 80.0 / 180.0 * calc::kPi;
  Cone cone;
  cone.has_cone = beam.lobes > 0 && beam.from_rad < 0.0 && beam.to_rad > 0.0 &&
                  beam.from_rad > -kWidest && beam.to_rad < kWidest;
  if (!cone.has_cone) return cone;
  const auto tangent = [](double rad) { return calc::sin(rad) / calc::cos(rad); };
  cone.minus = tangent(-beam.from_rad);
  cone.plus = tangent(beam.to_rad);
  return cone;
}

struct Figure {
  std::string drawing, table;  // either "" where there is nothing to show
};

Figure cone_figure(const Texts& t, const calc::PhotometricWeb& web) {
  constexpr int kMetres = 5;
  constexpr double kWidth = 440, kTop = 22, kStep = 62, kMiddle = 190, kReach = 165;
  const double nadir_cd = web.intensity_cd(0.0, 0.0);
  const BeamWidths beam = beam_widths(web, kBeamShare);
  const std::array<Cone, 2> cones{cone_of(beam[0]), cone_of(beam[1])};
  double widest = 0.0;
  for (const Cone& cone : cones) widest = std::max({widest, cone.minus, cone.plus});
  if (!(nadir_cd > 0.0) || !(widest > 0.0))
    return {"", fmt::format("<p class=\"quiet\">{}</p>\n", t[Text::sheet_no_cone])};
  const double scale = std::min(kReach / (widest * kMetres), kStep);
  const double height = kTop + kMetres * kStep + 12;
  std::string svg =
      fmt::format("<svg class=\"cone\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
                  kWidth, height, t[Text::sheet_cone]);
  svg += svg_text(4, 14, "start", "m") + svg_text(kWidth - 4, 14, "end", "lx");
  std::string rows;
  for (int metre = 1; metre <= kMetres; ++metre) {
    const double y = kTop + metre * kStep;
    const std::string lux = format_cell(t, nadir_cd / (metre * metre));
    svg += fmt::format("<path class=\"rule\" d=\"M20 {0}H{1}\"/><text x=\"4\" y=\"{2}\">{3}</text>",
                       svg_number(y), kWidth - 80, svg_number(y + 4), metre) +
           fmt::format("<text class=\"value\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n",
                       kWidth - 4, svg_number(y + 4), lux);
    const auto diameter = [&](const Cone& cone) {
      return cone.has_cone ? format_fixed(t, metre * (cone.minus + cone.plus), 2) + " m"
                           : std::string("–");
    };
    rows += fmt::format(
        "<tr><th scope=\"row\">{} m</th><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
        "class=\"num strong\">{} lx</td></tr>\n",
        metre, diameter(cones[0]), diameter(cones[1]), lux);
  }
  for (const std::size_t pair : {0U, 1U}) {
    if (!cones[pair].has_cone) continue;
    const double y = kTop + kMetres * kStep, length = scale * kMetres;
    svg += fmt::format("<path class=\"{}\" d=\"M{} {}L{} {}L{} {}\"/>\n", pair == 0 ? "c0" : "c90",
                       svg_number(kMiddle - length * cones[pair].minus), svg_number(y), kMiddle,
                       kTop, svg_number(kMiddle + length * cones[pair].plus), svg_number(y));
  }
  return {svg + "</svg>\n",
          fmt::format(
              "<table class=\"facts\"><caption>{}</caption><thead><tr><th scope=\"col\">{}</th><th "
              "scope=\"col\" class=\"num\">C0–C180</th><th scope=\"col\" "
              "class=\"num\">C90–C270</th><th scope=\"col\" "
              "class=\"num\">{}</th></tr></thead><tbody>\n{}</tbody></table>\n",
              t[Text::sheet_cone], t[Text::sheet_distance], t[Text::sheet_on_axis], rows)};
}

// --- luminances and glare
// --------------------------------------------------------------------------------------

std::string candela_by_area(const Texts& t, double cd_m2) {
  return std::isfinite(cd_m2) ? format_fixed(t, cd_m2, 0) : "–";
}

// "10³".
std::string power_of_ten(int exponent) {
  constexpr std::array kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string words = "10";
  if (exponent < 0) words += "⁻";
  for (const char digit : std::to_string(std::abs(exponent)))
    words += kDigits[static_cast<std::size_t>(digit - '0')];
  return words;
}

// By the angle from the vertical, as people know it from curves of glare limitation: luminance to
// the right in powers of ten, the angle upwards.
std::string luminance_diagram(const Texts& t, const calc::PhotometricWeb& web) {
  constexpr int kFrom_deg = 45, kTo_deg = 85;
  constexpr double kWidth = 440, kHeight = 344, kLeft = 44, kRight = 426, kTop = 14, kBottom = 282;
  constexpr int kMostDecades = 4;
  const calc::MeanLuminance luminance(web);
  if (!luminance.has_area()) return "";
  const auto at = [&](int c_deg, double gamma_deg) {
    return luminance.luminance_cd_m2(calc::radians_from_degrees(c_deg),
                                     calc::radians_from_degrees(gamma_deg));
  };
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (int c = 0; c < 360; c += 90) {
    for (int gamma = kFrom_deg; gamma <= kTo_deg; ++gamma) {
      const double here = at(c, gamma);
      if (!std::isfinite(here) || !(here > 0.0)) continue;
      least = std::min(least, here);
      most = std::max(most, here);
    }
  }
  if (!(most > 0.0)) return "";
  const int high = static_cast<int>(std::ceil(calc::log10(most)));
  const int low =
      std::clamp(static_cast<int>(std::floor(calc::log10(least))), high - kMostDecades, high - 1);
  const auto x_of = [&](double cd_m2) {
    return kLeft + (kRight - kLeft) * (calc::log10(cd_m2) - low) / (high - low);
  };
  const auto y_of = [&](double gamma_deg) {
    return kBottom - (kBottom - kTop) * (gamma_deg - kFrom_deg) / (kTo_deg - kFrom_deg);
  };
  std::string svg =
      fmt::format("<svg class=\"cone\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
                  kWidth, kHeight, t[Text::sheet_luminance_diagram]);
  for (int gamma = kFrom_deg; gamma <= kTo_deg; gamma += 10) {
    svg += fmt::format("<path class=\"rule\" d=\"M{} {}H{}\"/>", kLeft, svg_number(y_of(gamma)),
                       kRight) +
           svg_text(kLeft - 4, y_of(gamma) + 5, "end", fmt::format("{}°", gamma));
  }
  for (int exponent = low; exponent <= high; ++exponent) {
    const double x = x_of(calc::pow(10.0, exponent));
    svg += fmt::format("<path class=\"rule\" d=\"M{} {}V{}\"/>", svg_number(x), kTop, kBottom) +
           svg_text(x, kBottom + 20, exponent == high ? "end" : "middle", power_of_ten(exponent));
  }
  svg += svg_text(kRight, kBottom + 42, "end", "cd/m²");
  for (int c = 0; c < 360; c += 90) {
    std::string path;
    for (int half = 2 * kFrom_deg; half <= 2 * kTo_deg; ++half) {
      const double here = at(c, 0.5 * half);
      // Darker than the drawing goes: at its edge.
      if (!std::isfinite(here)) continue;
      const double x = here > 0.0 ? std::max(x_of(here), kLeft) : kLeft;
      path += fmt::format("{}{} {}", path.empty() ? "M" : "L", svg_number(x),
                          svg_number(y_of(0.5 * half)));
    }
    svg += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", c % 180 == 0 ? "c0" : "c90", path);
  }
  constexpr double kKey = kBottom + 58;
  for (const auto& [kind, words, x] :
       {std::tuple("c0", "C0, C180", kLeft), std::tuple("c90", "C90, C270", kLeft + 150)}) {
    svg += fmt::format("<path class=\"{} key\" d=\"M{} {}h30\"/>", kind, x, kKey - 4) +
           svg_text(x + 38, kKey, "start", words);
  }
  return svg + "</svg>\n";
}

// Of the planes from C0 on that say all of a light; 359 where none repeats another.
int last_plane_deg(const calc::PhotometricWeb& web) {
  switch (calc::symmetry_within(calc::symmetry_fit(web), calc::kExactSymmetry)) {
    case calc::PlaneSymmetry::axial:
      return 0;
    case calc::PlaneSymmetry::quadrant:
      return 90;
    case calc::PlaneSymmetry::c0_c180:
      return 180;
    default:
      return 359;
  }
}

std::string luminance_table(const Texts& t, const calc::PhotometricWeb& web) {
  const calc::MeanLuminance luminance(web);
  if (!luminance.has_area()) return "";
  const int last = std::min(last_plane_deg(web), 315);
  std::string heads, rows;
  for (int c = 0; c <= last; c += 45)
    heads += fmt::format("<th scope=\"col\" class=\"num\">C{}</th>", c);
  for (const int gamma : {45, 55, 65, 75, 85}) {
    rows += fmt::format("<tr><th scope=\"row\">γ {}°</th>", gamma);
    for (int c = 0; c <= last; c += 45) {
      rows += fmt::format(
          "<td class=\"num\">{}</td>",
          candela_by_area(t, luminance.luminance_cd_m2(calc::radians_from_degrees(c),
                                                       calc::radians_from_degrees(gamma))));
    }
    rows += "</tr>\n";
  }
  double highest = 0.0;
  for (int c = 0; c < 360; c += 5) {
    for (int half = 130; half <= 170; ++half) {
      const double here = luminance.luminance_cd_m2(calc::radians_from_degrees(c),
                                                    calc::radians_from_degrees(0.5 * half));
      if (here > highest) highest = here;
    }
  }
  return fmt::format(
      "<table class=\"facts\"><caption>{}</caption><thead><tr><td></td>{}</tr></"
      "thead><tbody>\n{}</tbody></table>\n<p class=\"quiet\">{}</p>\n",
      t[Text::sheet_luminance], heads, rows,
      t.say<Text::sheet_highest_luminance>(candela_by_area(t, highest)));
}

std::string rating(const Texts& t, double ugr) {
  if (!std::isfinite(ugr)) return "–";
  if (ugr < 10.0) return "&lt; " + t.number("10.0");
  return format_fixed(t, ugr, 1);
}

std::string glare_table(const Texts& t, const calc::PhotometricWeb& web) {
  const auto table = calc::ugr_table(web);
  if (!table) return fmt::format("<p class=\"quiet\">{}</p>\n", t[Text::sheet_no_ugr]);
  const calc::UgrRow& reference = calc::ugr_reference_row(*table);
  std::string views, heads, rows;
  for (const Text view : {Text::sheet_crosswise, Text::sheet_endwise}) {
    views += fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>",
                         calc::kUgrReflectances.size(), t[view]);
    for (std::size_t k = 0; k < calc::kUgrReflectances.size(); ++k) {
      const calc::UgrReflectances& rho = calc::kUgrReflectances[k];
      heads += fmt::format("<th scope=\"col\"{}>{:.0f}/{:.0f}/{:.0f}</th>",
                           k == 0 ? " class=\"first\"" : "", 100 * rho.ceiling, 100 * rho.walls,
                           100 * rho.floor);
    }
  }
  for (const calc::UgrRow& row : *table) {
    rows += fmt::format("<tr{}><th scope=\"row\" class=\"size\">{:g} H × {:g} H</th>",
                        &row == &reference ? " class=\"reference\"" : "", row.x_per_h, row.y_per_h);
    for (const auto& view : row.ugr) {
      for (std::size_t k = 0; k < view.size(); ++k)
        rows += fmt::format("<td{}>{}</td>", k == 0 ? " class=\"first\"" : "", rating(t, view[k]));
    }
    rows += "</tr>\n";
  }
  return scroll_box(
             t[Text::sheet_ugr],
             fmt::format("<table class=\"ugr\"><caption>{}</caption><thead><tr><td></td>{}"
                         "</tr><tr><th "
                         "scope=\"col\">X × Y</th>{}</tr></thead><tbody>\n{}</tbody></table>",
                         t[Text::sheet_ugr_caption], views, heads, rows)) +
         fmt::format("<p class=\"quiet\">{}</p>\n", t[Text::sheet_ugr_note]);
}

// --- intensities
// --------------------------------------------------------------------------------------

// Angles of a table in degrees, up to `last`; those that are not tabulated at even steps of at
// least `step`.
struct SheetAngles {
  std::vector<double> deg;
  int step = 0;  // 0: the photometry's own angles
};

SheetAngles sheet_angles(const std::vector<double>& own_rad, int last, std::size_t most,
                         std::initializer_list<int> steps) {
  SheetAngles angles;
  for (const double rad : own_rad) {
    const double deg = calc::degrees_from_radians(rad);
    if (deg <= last + 1e-9) angles.deg.push_back(deg);
  }
  if (angles.deg.size() <= most) return angles;
  for (const int step : steps) {
    angles.step = step;
    if (static_cast<std::size_t>(last / step) + 1 <= most) break;
  }
  angles.deg.clear();
  for (int deg = 0; deg <= last; deg += angles.step) angles.deg.push_back(deg);
  return angles;
}

std::string intensity_table(const Texts& t, const calc::PhotometricWeb& web) {
  const calc::MeasureAngles own = calc::measure_angles(web);
  // What is dark above the horizon says so in its first rows.
  const bool is_dark_above = !(web.zonal_flux_lm(0.5 * calc::kPi, calc::kPi) > 0.0);
  const SheetAngles c = sheet_angles(own.c_rad, last_plane_deg(web), kMostSheetPlanes, {15, 30});
  const SheetAngles gamma =
      sheet_angles(own.gamma_rad, is_dark_above ? 90 : 180, kMostSheetAngles, {5});
  const auto angle = [&](double deg) {
    return format_shortest(t, std::round(deg * 100.0) / 100.0) + "°";
  };
  std::string heads, rows;
  for (const double c_deg : c.deg) heads += "<th scope=\"col\">C " + angle(c_deg) + "</th>";
  for (const double gamma_deg : gamma.deg) {
    rows += "<tr><th scope=\"row\">γ " + angle(gamma_deg) + "</th>";
    for (const double c_deg : c.deg) {
      rows += "<td>" +
              format_cell(t, web.intensity_cd(calc::radians_from_degrees(c_deg),
                                              calc::radians_from_degrees(gamma_deg))) +
              "</td>";
    }
    rows += "</tr>\n";
  }
  std::string html = scroll_box(
      t[Text::sheet_intensities],
      fmt::format("<table class=\"intensities\"><caption class=\"unseen\">{}</caption><thead><tr>"
                  "<td></td>{}</tr></thead><tbody>\n{}</tbody></table>",
                  t[Text::sheet_intensities], heads, rows));
  if (c.step == 0 && gamma.step == 0) return html;
  // A step of the photometry's own is said by its mean.
  const auto step_words = [&](const SheetAngles& angles) {
    if (angles.step > 0) return fmt::format("{}", angles.step);
    if (angles.deg.size() < 2) return fmt::format("{}", 360);
    return format_shortest(t, std::round(100.0 * (angles.deg.back() - angles.deg.front()) /
                                         static_cast<double>(angles.deg.size() - 1)) /
                                  100.0);
  };
  return html + fmt::format("<p class=\"quiet\">{}</p>\n",
                            t.say<Text::sheet_abridged>(step_words(c), step_words(gamma),
                                                        own.c_rad.size(), own.gamma_rad.size()));
}

}  // namespace

const char* sheet_style() { return kSheetStyle; }

std::string sheet_name(const SheetLight& light) {
  const std::string& name = light.web.source().luminaire_name;
  return name.empty() ? light.file_name : name;
}

std::string sheet_body(const Texts& t, const SheetLight& light, const SheetParts& parts) {
  const calc::PhotometricWeb& web = light.web;
  const std::string polar = render_polar_svg(draw_polar_diagram(web, sheet_name(light)));
  const bool is_one = light.emitters == 1;
  std::string html = figures(t, light, parts.more_facts);
  const Figure cone = cone_figure(t, web);
  html += fmt::format(
      "<div class=\"sheet drawings\">\n<figure><img alt=\"{}\" "
      "src=\"data:image/svg+xml;base64,{}\"/></figure>\n{}{}</div>\n",
      t[Text::sheet_polar], base64(polar), cone.drawing, is_one ? luminance_diagram(t, web) : "");
  html += fmt::format("<div class=\"sheet\">\n<div>{}</div>\n<div>{}</div>\n</div>\n",
                      is_one ? luminance_table(t, web) : "", cone.table);
  const auto heading = [&](Text words) {
    return fmt::format("<{0} class=\"sheet-heading\">{1}</{0}>\n", parts.heading, t[words]);
  };
  html += heading(Text::sheet_glare) +
          (is_one ? glare_table(t, web)
                  : fmt::format("<p class=\"quiet\">{}</p>\n", t[Text::sheet_no_ugr_together]));
  if (parts.has_intensities) html += heading(Text::sheet_intensities) + intensity_table(t, web);
  return html;
}

}  // namespace report
