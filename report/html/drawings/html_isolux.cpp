#include "report/html/drawings/html_isolux.h"

#include "report/html/page/html_markup.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace report {
namespace {

// The place on a line nearest to its middle at which a label of that size covers nothing.
std::optional<glm::dvec2> label_place(const PlanLayout& layout, const IsoluxLine& line,
                                      const glm::dvec2& size, const std::vector<LabelBox>& taken) {
  const LabelBox picture{{0, 0}, {layout.width_px(), layout.height_px()}};
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i + 1 < line.points_m.size(); ++i) {
    const glm::dvec2 from = layout.pixel(line.points_m[i]);
    const glm::dvec2 to = layout.pixel(line.points_m[i + 1]);
    for (const double part : {0.0, 0.25, 0.5, 0.75}) places.push_back(from + part * (to - from));
  }
  for (std::size_t step = 0; step < places.size(); ++step) {
    const std::size_t half = (step + 1) / 2, middle = places.size() / 2;
    const glm::dvec2& place = places[step % 2 == 0 ? middle + half : middle - half];
    const LabelBox box = box_around(place, size);
    const bool is_inside = box.low.x > picture.low.x && box.low.y > picture.low.y &&
                           box.high.x < picture.high.x && box.high.y < picture.high.y;
    const bool is_free = is_inside && std::none_of(taken.begin(), taken.end(),
                                                   [&](const auto& b) { return b.meets(box); });
    if (is_free) return place;
  }
  return std::nullopt;
}

double length_m(const IsoluxLine& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.points_m.size(); ++i)
    length += glm::distance(line.points_m[i], line.points_m[i + 1]);
  return length;
}

}  // namespace

std::string svg_path(const PlanLayout& layout, const std::vector<glm::dvec2>& corners) {
  std::string path;
  for (const glm::dvec2& corner : corners) {
    const glm::dvec2 p = layout.pixel(corner);
    path += fmt::format("{}{} {}", path.empty() ? "M" : "L", svg_number(p.x), svg_number(p.y));
  }
  return path.empty() ? path : path + "z";
}

// Every line of a level is drawn; its longest one with a free place has the label.
IsoluxDrawing svg_isolux(const Texts& t, const PlanLayout& layout,
                         const std::vector<IsoluxLevel>& levels, std::vector<LabelBox> taken,
                         const LabelStyle& style) {
  constexpr double kDigitWidth = 0.62;
  const double font = style.font_px;
  IsoluxDrawing svg;
  for (const IsoluxLevel& level : levels) {
    std::vector<IsoluxLine> lines = level.lines;
    std::string path;
    for (const IsoluxLine& line : lines) {
      std::string part = svg_path(layout, line.points_m);
      if (!line.is_closed) part.pop_back();
      path += part;
    }
    if (path.empty()) continue;
    svg.lines += fmt::format(
        "<path class=\"isolux halo{0}\" d=\"{1}\"/><path class=\"isolux{0}\" d=\"{1}\"/>\n",
        level.is_required ? " required" : "", path);
    std::stable_sort(lines.begin(), lines.end(), [](const IsoluxLine& a, const IsoluxLine& b) {
      return length_m(a) > length_m(b);
    });
    const std::string text = format_level(t, level.value);
    const glm::dvec2 size(kDigitWidth * font * static_cast<double>(text.size()) + 4, font + 2);
    for (const IsoluxLine& line : lines) {
      const std::optional<glm::dvec2> place = label_place(layout, line, size, taken);
      if (!place) continue;
      taken.push_back(box_around(*place, size));
      svg.labels += fmt::format("<text class=\"{}{}\" x=\"{}\" y=\"{}\">{}</text>\n", style.names,
                                level.is_required ? " required" : "", svg_number(place->x),
                                svg_number(place->y + 0.36 * font), text);
      break;
    }
  }
  return svg;
}

}  // namespace report
