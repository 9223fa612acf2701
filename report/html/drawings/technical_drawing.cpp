#include "report/html/drawings/technical_drawing.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/text/markup.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace report {
namespace {

constexpr double kDigit = 0.6;  // its width, of the size of words

std::string tick(const glm::dvec2& p) {
  return fmt::format("M{} {}l1.6 -1.6", svg_number(p.x - 0.8), svg_number(p.y + 0.8));
}

}  // namespace

double drawing_scale(const glm::dvec2& size_m, const glm::dvec2& room_mm) {
  constexpr double kMillimetres = 1000.0, kAlmost = 1 - 1e-9;
  const double least =
      std::max(size_m.x * kMillimetres / room_mm.x, size_m.y * kMillimetres / room_mm.y);
  for (double power = 1e-3;; power *= 10.0) {
    for (const double step : {1.0, 2.0, 2.5, 5.0}) {
      if (step * power >= least * kAlmost) return std::max(1.0, std::round(step * power * 10) / 10);
    }
  }
}

std::string DrawingView::path(const std::vector<glm::dvec2>& corners_m, bool is_closed) const {
  std::string data;
  for (const glm::dvec2& corner : corners_m) {
    const glm::dvec2 p = at(corner);
    data += fmt::format("{}{} {}", data.empty() ? "M" : "L", svg_number(p.x), svg_number(p.y));
  }
  return data.empty() || !is_closed ? data : data + "z";
}

std::string drawing_path(const char* kind, const std::string& data) {
  return data.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, data);
}

std::string drawing_words(const glm::dvec2& p, std::string_view words, const char* anchor,
                          const char* kind) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", svg_number(p.x),
                     svg_number(p.y), anchor,
                     *kind == '\0' ? "" : fmt::format(" class=\"{}\"", kind), escape_html(words));
}

double drawing_width_mm(std::string_view words) {
  return kDigit * kDrawingText_mm * static_cast<double>(words.size());
}

std::string circle_path(const glm::dvec2& p, double radius_mm) {
  return fmt::format("M{0} {1}a{2} {2} 0 1 0 {3} 0a{2} {2} 0 1 0 -{3} 0",
                     svg_number(p.x - radius_mm), svg_number(p.y), svg_number(radius_mm),
                     svg_number(2 * radius_mm));
}

std::string point_sign(const glm::dvec2& p) {
  constexpr double kCross_mm = 1.5;
  return circle_path(p, kPointSign_mm) + fmt::format("M{0} {1}l{2} {2}m0 -{2}l-{2} {2}",
                                                     svg_number(p.x - 0.5 * kCross_mm),
                                                     svg_number(p.y - 0.5 * kCross_mm), kCross_mm);
}

std::string level_dimension(double from_mm, double to_mm, double y_mm, const std::string& words) {
  std::string svg = drawing_path("dimension", fmt::format("M{} {}H{}", svg_number(from_mm),
                                                          svg_number(y_mm), svg_number(to_mm)) +
                                                  tick({from_mm, y_mm}) + tick({to_mm, y_mm}));
  if (drawing_width_mm(words) < to_mm - from_mm)
    svg += drawing_words({0.5 * (from_mm + to_mm), y_mm - 0.9}, words);
  return svg;
}

std::string upright_dimension(double from_mm, double to_mm, double x_mm, const std::string& words) {
  std::string svg = drawing_path("dimension", fmt::format("M{} {}V{}", svg_number(x_mm),
                                                          svg_number(from_mm), svg_number(to_mm)) +
                                                  tick({x_mm, from_mm}) + tick({x_mm, to_mm}));
  if (drawing_width_mm(words) < std::abs(to_mm - from_mm)) {
    const double y = 0.5 * (from_mm + to_mm);
    svg += fmt::format(
        "<text text-anchor=\"middle\" transform=\"translate({} {}) rotate(-90)\">{}</text>\n",
        svg_number(x_mm - 0.9), svg_number(y), words);
  }
  return svg;
}

std::string north_arrow(const glm::dvec2& middle, double north_deg) {
  constexpr double kLength_mm = 9;
  const double angle = calc::radians_from_degrees(north_deg);
  const glm::dvec2 ahead(calc::cos(angle), -calc::sin(angle)), beside(-ahead.y, ahead.x);
  const glm::dvec2 tip = middle + 0.5 * kLength_mm * ahead,
                   foot = middle - 0.5 * kLength_mm * ahead;
  const glm::dvec2 left = foot + 2.0 * beside, right = foot - 2.0 * beside;
  const glm::dvec2 notch = foot + 2.0 * ahead, letter = tip + 2.4 * ahead;
  return fmt::format("<path class=\"north\" d=\"M{} {}L{} {}L{} {}L{} {}z\"/>\n", svg_number(tip.x),
                     svg_number(tip.y), svg_number(left.x), svg_number(left.y), svg_number(notch.x),
                     svg_number(notch.y), svg_number(right.x), svg_number(right.y)) +
         drawing_words({letter.x, letter.y + 0.36 * kDrawingText_mm}, "N");
}

void DrawingLabels::take(const glm::dvec2& middle, const glm::dvec2& size) {
  taken_.push_back(box_around(middle, size));
}

std::string DrawingLabels::put(const std::vector<glm::dvec2>& places, const std::string& words,
                               const char* kind) {
  const glm::dvec2 size(drawing_width_mm(words) + 0.6, kDrawingText_mm);
  glm::dvec2 chosen = places.front();
  for (const glm::dvec2& place : places) {
    const LabelBox box = box_around(place, size);
    if (std::none_of(taken_.begin(), taken_.end(),
                     [&](const LabelBox& other) { return other.meets(box); })) {
      chosen = place;
      break;
    }
  }
  take(chosen, size);
  return drawing_words({chosen.x, chosen.y + 0.36 * kDrawingText_mm}, words, "middle", kind);
}

}  // namespace report
