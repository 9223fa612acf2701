#include "report/html/drawings/storey_plan.h"

#include "calc/base/names.h"
#include "calc/base/utf8.h"
#include "report/html/drawings/html_isolux.h"
#include "report/html/drawings/label_places.h"
#include "report/html/drawings/plan_layout.h"
#include "report/html/drawings/technical_drawing.h"
#include "report/text/markup.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace report {
namespace {

// All in millimetres on paper; y points down. 2.2 mm are 6.2 points.
constexpr double kHead_mm = 2.6, kBody_mm = 2.3, kLetter_mm = 2.2, kLine = 1.2;
constexpr double kMargin_mm = 2.5, kFoot_mm = 8, kFootWithNorth_mm = 16, kLeastPaper_mm = 56;
constexpr double kMostForSigns = 250;  // signs and thick walls: a scale of 1:250
constexpr std::size_t kMostSigns = 2000;

// About, in sizes of the letters; too wide rather than too narrow.
double letters_width(std::string_view words, bool is_bold) {
  const auto letters = std::count_if(words.begin(), words.end(),
                                     [](char c) { return !calc::is_utf8_continuation(c); });
  return (is_bold ? 0.68 : 0.6) * static_cast<double>(letters);
}

glm::dvec2 label_size(const std::vector<std::string>& lines, double head_mm = kHead_mm) {
  constexpr double kAround_mm = 0.4;
  double width = head_mm * letters_width(lines.front(), true);
  for (std::size_t i = 1; i < lines.size(); ++i)
    width = std::max(width, kBody_mm * letters_width(lines[i], false));
  const double height = kLine * (head_mm + kBody_mm * static_cast<double>(lines.size() - 1));
  return {width + kAround_mm, height + kAround_mm};
}

constexpr const char* kBold = " font-weight=\"700\"";

std::string text_line(const glm::dvec2& p, double size_mm, const char* attribute,
                      std::string_view words) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", svg_number(p.x),
                     svg_number(p.y), size_mm, attribute, escape_html(words));
}

std::string label_text(const glm::dvec2& middle, const std::vector<std::string>& lines,
                       double head_mm = kHead_mm) {
  constexpr double kBase = 0.36;  // from the middle of a line to its foot, of its size
  double y = middle.y - 0.5 * kLine * (head_mm + kBody_mm * static_cast<double>(lines.size() - 1));
  std::string svg;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double size = i == 0 ? head_mm : kBody_mm;
    svg += text_line({middle.x, y + (0.5 * kLine + kBase) * size}, size, i == 0 ? kBold : "",
                     lines[i]);
    y += kLine * size;
  }
  return svg;
}

// The class of a tint; "" of none.
std::string_view tint_of(const PlanArea& area) {
  using enum rules::Outcome;
  if (!area.outcome || *area.outcome == waived || *area.outcome == nothing_asked) return "";
  return calc::name_of(*area.outcome);
}

// Beside the colour, so that a print in grey tells them apart; what passes has none.
bool has_hatch(std::string_view tint) { return !tint.empty() && tint != "pass"; }

std::string hatch_id(const std::string& anchor, std::string_view tint) {
  return fmt::format("{}-{}", anchor, tint);
}

std::string hatches(const std::string& anchor, const std::vector<PlanArea>& areas) {
  struct Hatch {
    const char *tint, *data;
  };
  std::string svg;
  for (const Hatch& hatch : {Hatch{"fail", "M0 2.4L2.4 0M-.3 .3L.3 -.3M2.1 2.7L2.7 2.1"},
                             Hatch{"undecided", "M0 1.2H2.4"}, Hatch{"not-judged", "M1 1.2h.4"}}) {
    if (std::none_of(areas.begin(), areas.end(),
                     [&](const PlanArea& area) { return tint_of(area) == hatch.tint; }))
      continue;
    svg += fmt::format(
        "<pattern id=\"{}\" width=\"2.4\" height=\"2.4\" patternUnits=\"userSpaceOnUse\"><path "
        "class=\"hatch {}\" d=\"{}\"/></pattern>\n",
        hatch_id(anchor, hatch.tint), hatch.tint, hatch.data);
  }
  return svg.empty() ? svg : "<defs>" + svg + "</defs>\n";
}

glm::dvec2 turned(const glm::dvec2& m) { return {-m.y, m.x}; }

// The drawing while it is made.
class Plan {
 public:
  Plan(const Texts& t, const PlanContents& contents, const FlatBox& extent_m, const PlanFit& fit,
       const std::string& anchor);

  PlanDrawing draw(const std::string& title);

 private:
  struct Sign {
    const PlanSign* sign;
    FlatBox box;
    std::size_t number;  // of the box that is taken
  };

  std::vector<glm::dvec2> placed(const std::vector<glm::dvec2>& outline_m) const;
  glm::dvec2 placed(const glm::dvec2& m) const { return view_.at(fit_.is_turned ? turned(m) : m); }
  std::string closed_path(const std::vector<glm::dvec2>& outline_m) const;
  bool is_on_paper(const std::vector<glm::dvec2>& outline_mm) const;
  std::string areas() const;
  std::string dashed() const;
  std::string lines() const;
  std::string signs();
  std::string as_points();
  std::string labels();
  std::string label(std::size_t area);
  std::string leader(std::size_t area);
  std::string sign_in(std::size_t area);
  std::string label_at(const PlanArea& area, const std::vector<std::string>& lines, double head_mm,
                       bool is_upright, const glm::dvec2& middle) const;
  std::string letters();
  std::string letter_of(const Sign& sign, const std::string& words);
  std::string foot() const;

  const Texts& t_;
  const PlanContents& contents_;
  PlanFit fit_;
  std::string anchor_;
  DrawingView view_;
  FlatBox paper_;
  LabelPlaces places_;
  std::vector<std::vector<glm::dvec2>> outlines_mm_;  // of the areas
  std::vector<Sign> signs_;
  PlanDrawing drawing_;
};

DrawingView view_of(const FlatBox& extent_m, const PlanFit& fit) {
  DrawingView view;
  if (fit.is_turned) {
    view.extent_m.add(turned(extent_m.low));
    view.extent_m.add(turned(extent_m.high));
  } else {
    view.extent_m = extent_m;
  }
  view.mm_by_m = 1000.0 / fit.scale;
  view.corner_mm = glm::dvec2(kMargin_mm);
  if (view.width_mm() < kLeastPaper_mm)
    view.corner_mm.x += 0.5 * (kLeastPaper_mm - view.width_mm());
  return view;
}

FlatBox paper_of(const DrawingView& view) {
  return {glm::dvec2(0.0), {view.right_mm() + view.corner_mm.x, view.bottom_mm() + kMargin_mm}};
}

Plan::Plan(const Texts& t, const PlanContents& contents, const FlatBox& extent_m,
           const PlanFit& fit, const std::string& anchor)
    : t_(t),
      contents_(contents),
      fit_(fit),
      anchor_(anchor),
      view_(view_of(extent_m, fit)),
      paper_(paper_of(view_)),
      places_(paper_) {
  for (const PlanArea& area : contents.areas) {
    outlines_mm_.push_back(placed(area.outline_m));
    places_.take_outline(outlines_mm_.back());
  }
}

std::vector<glm::dvec2> Plan::placed(const std::vector<glm::dvec2>& outline_m) const {
  std::vector<glm::dvec2> outline_mm;
  for (const glm::dvec2& corner : outline_m) outline_mm.push_back(placed(corner));
  return outline_mm;
}

std::string Plan::closed_path(const std::vector<glm::dvec2>& outline_m) const {
  std::vector<glm::dvec2> corners_m = outline_m;
  if (fit_.is_turned) std::transform(corners_m.begin(), corners_m.end(), corners_m.begin(), turned);
  return view_.path(corners_m);
}

bool Plan::is_on_paper(const std::vector<glm::dvec2>& outline_mm) const {
  return std::all_of(outline_mm.begin(), outline_mm.end(),
                     [this](const glm::dvec2& p) { return paper_.contains(p); });
}

std::string Plan::areas() const {
  std::string svg;
  for (const PlanArea& area : contents_.areas) {
    const std::string_view tint = tint_of(area);
    const std::string kind = std::string(!area.is_room                ? "area"
                                         : fit_.scale > kMostForSigns ? "wall thin"
                                                                      : "wall") +
                             (tint.empty() ? "" : fmt::format(" tint {}", tint));
    svg += drawing_path(kind.c_str(), closed_path(area.outline_m));
    if (!has_hatch(tint)) continue;
    svg += fmt::format("<path style=\"fill:url(#{});stroke:none\" d=\"{}\"/>\n",
                       hatch_id(anchor_, tint), closed_path(area.outline_m));
  }
  return svg;
}

std::string Plan::dashed() const {
  std::string data;
  for (const std::vector<glm::dvec2>& outline : contents_.dashed_m) {
    if (is_on_paper(placed(outline))) data += closed_path(outline);
  }
  return drawing_path("area", data);
}

std::string Plan::lines() const {
  std::string data;
  for (const auto& [from_m, to_m] : contents_.lines_m) {
    const glm::dvec2 from = placed(from_m), to = placed(to_m);
    if (from == to || !paper_.contains(from) || !paper_.contains(to)) continue;
    data += fmt::format("M{} {}L{} {}", svg_number(from.x), svg_number(from.y), svg_number(to.x),
                        svg_number(to.y));
  }
  return drawing_path("furniture", data);
}

std::string Plan::as_points() {
  std::string data;
  for (const PlanSign& sign : contents_.luminaires) {
    const glm::dvec2 p = placed(glm::dvec2(sign.luminaire->position_m));
    if (!paper_.contains(p)) {
      ++drawing_.outside;
      continue;
    }
    data += fmt::format("M{} {}h0", svg_number(p.x), svg_number(p.y));
  }
  return drawing_path("points", data);
}

// Outlines; a sign where they are not known or too small to be seen.
std::string Plan::signs() {
  constexpr double kSmallest_mm = 0.9, kAround_mm = 0.15, kDot_mm = 0.45;
  drawing_.is_as_points = contents_.luminaires.size() > kMostSigns;
  if (drawing_.is_as_points) return as_points();
  std::string data;
  for (const PlanSign& sign : contents_.luminaires) {
    const LuminaireMark& luminaire = *sign.luminaire;
    const glm::dvec2 p = placed(glm::dvec2(luminaire.position_m));
    const std::vector<glm::dvec2> outline = placed(luminaire.outline_m);
    FlatBox box;
    for (const glm::dvec2& corner : outline) box.add(corner);
    const bool is_seen = !box.is_empty() && box.longest() >= kSmallest_mm;
    if (!paper_.contains(p) || (is_seen && !is_on_paper(outline))) {
      ++drawing_.outside;
      continue;
    }
    const bool is_dot = fit_.scale > kMostForSigns;
    data += is_seen  ? closed_path(luminaire.outline_m)
            : is_dot ? circle_path(p, kDot_mm)
                     : point_sign(p);
    const glm::dvec2 radius(is_dot ? kDot_mm : kPointSign_mm);
    if (!is_seen) box = {p - radius, p + radius};
    const std::size_t number =
        places_.take({box.low - glm::dvec2(kAround_mm), box.high + glm::dvec2(kAround_mm)});
    signs_.push_back({&sign, box, number});
  }
  return drawing_path("luminaire", data);
}

// On hatching a label has a plate below it.
std::string Plan::label_at(const PlanArea& area, const std::vector<std::string>& lines,
                           double head_mm, bool is_upright, const glm::dvec2& middle) const {
  std::string svg;
  if (const std::string_view tint = tint_of(area); has_hatch(tint)) {
    glm::dvec2 size = label_size(lines, head_mm);
    if (is_upright) std::swap(size.x, size.y);
    const glm::dvec2 low = middle - 0.5 * size;
    svg += fmt::format("<rect class=\"plate {}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                       tint, svg_number(low.x), svg_number(low.y), svg_number(size.x),
                       svg_number(size.y));
  }
  if (!is_upright) return svg + label_text(middle, lines, head_mm);
  return svg +
         fmt::format("<g transform=\"translate({} {}) rotate(-90)\">", svg_number(middle.x),
                     svg_number(middle.y)) +
         label_text(glm::dvec2(0.0), lines, head_mm) + "</g>\n";
}

// Each form level, then each upright, which is better than the short name with its list.
std::string Plan::label(std::size_t area) {
  const PlanArea& labelled = contents_.areas[area];
  const std::size_t most = labelled.labels.size(), full = most - 1;
  std::vector<glm::dvec2> sizes;
  const auto add = [&](std::size_t form, bool is_upright) {
    const glm::dvec2 size = label_size(labelled.labels[form], form == full ? kLetter_mm : kHead_mm);
    sizes.push_back(is_upright ? glm::dvec2(size.y, size.x) : size);
  };
  for (std::size_t form = 0; form < full; ++form) add(form, false);
  for (std::size_t form = 0; form < full; ++form) add(form, true);
  add(full, false);
  add(full, true);
  const std::optional<LabelPlace> place = places_.put_inside(outlines_mm_[area], sizes);
  if (!place) return {};
  const bool is_short = place->form >= 2 * full;
  drawing_.is_short[area] = is_short && most > 1;
  const std::size_t form = is_short ? full : place->form % full;
  const bool is_upright = is_short ? place->form > 2 * full : place->form >= full;
  return label_at(labelled, labelled.labels[form], is_short ? kLetter_mm : kHead_mm, is_upright,
                  place->middle);
}

std::string Plan::leader(std::size_t area) {
  constexpr double kDot_mm = 0.35;
  const PlanArea& labelled = contents_.areas[area];
  const std::optional<LeaderPlace> place =
      places_.put_beside(outlines_mm_[area], label_size(labelled.labels.back(), kLetter_mm));
  if (!place) return {};
  return drawing_path("dimension", fmt::format("M{} {}L{} {}", svg_number(place->from.x),
                                               svg_number(place->from.y), svg_number(place->to.x),
                                               svg_number(place->to.y)) +
                                       circle_path(place->to, kDot_mm)) +
         label_text(place->middle, labelled.labels.back(), kLetter_mm);
}

std::string Plan::sign_in(std::size_t area) {
  const PlanArea& signed_area = contents_.areas[area];
  if (signed_area.sign.empty()) return {};
  const std::vector<std::string> line{signed_area.sign};
  const std::optional<LabelPlace> place =
      places_.put_inside(outlines_mm_[area], {label_size(line)});
  return place ? label_at(signed_area, line, kHead_mm, false, place->middle) : std::string();
}

// Inside where there is room; beside only when all that fit inside have their place.
std::string Plan::labels() {
  std::string svg;
  std::vector<std::size_t> left;
  drawing_.is_short.assign(contents_.areas.size(), false);
  for (std::size_t i = 0; i < contents_.areas.size(); ++i) {
    const std::string inside = label(i);
    if (inside.empty()) left.push_back(i);
    svg += inside;
  }
  for (const std::size_t i : left) {
    drawing_.is_short[i] = contents_.areas[i].labels.size() > 1;
    const std::string beside = leader(i);
    svg += beside.empty() ? sign_in(i) : beside;
  }
  return svg;
}

// Marks of luminaires, on them or beside them; else the letter of the type alone, and counted.
std::string Plan::letters() {
  std::string svg;
  for (const Sign& sign : signs_) {
    const std::string& letter = sign.sign->letter;
    std::string placed = letter_of(sign, sign.sign->luminaire->label);
    if (placed.empty()) ++drawing_.without_letter;
    if (placed.empty() && !letter.empty()) placed = letter_of(sign, letter);
    svg += placed;
  }
  return svg;
}

// "" where it would cover something. On the luminaire it needs no halo.
std::string Plan::letter_of(const Sign& sign, const std::string& words) {
  constexpr std::array kWays{glm::dvec2(0, 0),  glm::dvec2(1, 0),  glm::dvec2(0, 1),
                             glm::dvec2(-1, 0), glm::dvec2(0, -1), glm::dvec2(1, 1),
                             glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1)};
  const glm::dvec2 size(kLetter_mm * letters_width(words, true) + 0.2, kLetter_mm);
  const glm::dvec2 middle = 0.5 * (sign.box.low + sign.box.high),
                   aside = 0.5 * (sign.box.size() + size) + glm::dvec2(0.2);
  const bool fits_on = sign.box.size().x >= size.x && sign.box.size().y >= size.y;
  for (const glm::dvec2& way : kWays) {
    const bool is_on = way == glm::dvec2(0.0);
    const glm::dvec2 place = middle + way * aside;
    const LabelBox box = box_around(place, size);
    if ((is_on && !fits_on) || !places_.is_free(box, sign.number)) continue;
    if (places_.is_crossed(middle, place)) continue;  // in another room
    places_.take(box);
    return text_line(place + glm::dvec2(0, 0.36 * kLetter_mm), kLetter_mm,
                     is_on ? " stroke=\"none\"" : "", words);
  }
  return {};
}

// Scale bar, scale, north.
std::string Plan::foot() const {
  const double width = paper_.high.x, y = paper_.high.y + 5.5;
  const double length_m = scale_bar_m((width - 2 * kMargin_mm) / view_.mm_by_m);
  const double end = kMargin_mm + length_m * view_.mm_by_m;
  std::string svg = drawing_path(
      "scale-bar",
      fmt::format("M{0} {1}v2H{2}v-2M{3} {4}v1", kMargin_mm, svg_number(y - 2), svg_number(end),
                  svg_number(0.5 * (kMargin_mm + end)), svg_number(y - 1)));
  svg += drawing_words({end + 1.5, y},
                       format_shortest(t_, length_m) + " m · 1:" + format_shortest(t_, fit_.scale),
                       "start");
  if (contents_.north_deg) {
    const double turn_deg = fit_.is_turned ? 90.0 : 0.0;
    svg += north_arrow({width - 8, paper_.high.y + 0.5 * kFootWithNorth_mm},
                       *contents_.north_deg + turn_deg);
  }
  return svg;
}

PlanDrawing Plan::draw(const std::string& title) {
  const double width = paper_.high.x,
               height = paper_.high.y + (contents_.north_deg ? kFootWithNorth_mm : kFoot_mm);
  drawing_.width_mm = width;
  const std::string below = hatches(anchor_, contents_.areas) + areas() + dashed() + lines(),
                    luminaires = signs(), rooms = labels(), types = letters();
  drawing_.svg =
      fmt::format(
          "<svg class=\"layout\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
          "font-size=\"{2}\" role=\"img\" aria-label=\"{3}\">\n",
          svg_number(width), svg_number(height), kDrawingText_mm, escape_html(title)) +
      below + luminaires + "<g text-anchor=\"middle\">\n" + rooms + "<g class=\"number\">\n" +
      types + "</g></g>\n" + foot() + "</svg>\n";
  return std::move(drawing_);
}

// In millimetres, what a page has for a plan beside heading, caption and list.
glm::dvec2 room_on(Paper paper) {
  return paper == Paper::letter ? glm::dvec2(187, 178) : glm::dvec2(182, 196);
}

bool fits(const glm::dvec2& size_m, const glm::dvec2& room_mm, double scale) {
  constexpr double kAlmost = 1 + 1e-9;
  return size_m.x * 1000.0 / scale <= room_mm.x * kAlmost &&
         size_m.y * 1000.0 / scale <= room_mm.y * kAlmost;
}

}  // namespace

std::optional<PlanFit> fit_plan(const glm::dvec2& size_m, Paper paper, double least_scale) {
  const glm::dvec2 room_mm = room_on(paper) - glm::dvec2(2 * kMargin_mm);
  for (const double scale : {50.0, 100.0, 200.0, 250.0, 500.0, 1000.0, 2000.0, 5000.0, 10'000.0}) {
    if (scale < least_scale) continue;
    if (fits(size_m, room_mm, scale)) return PlanFit{scale, false};
    if (fits({size_m.y, size_m.x}, room_mm, scale)) return PlanFit{scale, true};
  }
  return std::nullopt;
}

PlanDrawing draw_plan(const Texts& t, const PlanContents& contents, const FlatBox& extent_m,
                      const PlanFit& fit, const std::string& title, const std::string& anchor) {
  return Plan(t, contents, extent_m, fit, anchor).draw(title);
}

}  // namespace report
