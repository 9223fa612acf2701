#include "calc/base/elementary.h"
#include "report/images/canvas.h"
#include "report/images/png.h"
#include "report/images/polar_diagram.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace report {
namespace {

constexpr double kScale = 2.0;  // pixels per unit of the drawing
constexpr double kLetters_px = 26.0;
constexpr double kDash = 9.0, kGap = 5.0;  // units of the drawing

Rgb colour_of(PolarRole role) {
  switch (role) {
    case PolarRole::grid:
      return {220, 223, 227};
    case PolarRole::frame:
      return {154, 161, 169};
    case PolarRole::c0_c180:
      return {11, 87, 164};
    case PolarRole::c90_c270:
      return {184, 70, 14};
    case PolarRole::text:
      return {27, 31, 36};
    case PolarRole::faint_text:
      break;
  }
  return {89, 97, 107};
}

glm::dvec2 scaled(PolarPoint point) { return {kScale * point.x, kScale * point.y}; }

void draw_line(const PolarLine& line, Canvas& canvas) {
  double along = 0.0;  // units since the start
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const PolarPoint a = line.points[i];
    const PolarPoint b = line.points[i + 1];
    const double length = calc::hypot(b.x - a.x, b.y - a.y);
    double done = 0.0;
    while (done < length) {
      const double phase = std::fmod(along + done, kDash + kGap);
      const bool is_on = !line.dashed || phase < kDash;
      const double left = line.dashed ? (is_on ? kDash - phase : kDash + kGap - phase) : length;
      const double end = std::min(length, done + std::max(left, 1.0e-6));
      const auto at = [&](double d) {
        return scaled({std::lerp(a.x, b.x, d / length), std::lerp(a.y, b.y, d / length)});
      };
      if (is_on) canvas.cover(at(done), at(end), kScale * line.width);
      done = end;
    }
    along += length;
  }
  canvas.paint(colour_of(line.role));
}

void draw_label(const PolarLabel& label, Canvas& canvas) {
  // Its place is the middle of its height.
  const glm::dvec2 at = scaled(label.at) + glm::dvec2(0.0, 0.35 * kLetters_px);
  const TextAnchor anchor = label.anchor == PolarLabel::Anchor::middle ? TextAnchor::middle
                            : label.anchor == PolarLabel::Anchor::end  ? TextAnchor::end
                                                                       : TextAnchor::start;
  canvas.write(label.text, at, kLetters_px, anchor, colour_of(label.role));
}

}  // namespace

std::string render_polar_png(const PolarDrawing& drawing) {
  Canvas canvas(static_cast<int>(std::lround(kScale * drawing.width)),
                static_cast<int>(std::lround(kScale * (drawing.height - drawing.header))));
  for (PolarLine line : drawing.lines) {
    for (PolarPoint& point : line.points) point.y -= drawing.header;
    draw_line(line, canvas);
  }
  for (PolarLabel label : drawing.labels) {
    if (label.is_title) continue;
    label.at.y -= drawing.header;
    draw_label(label, canvas);
  }
  return encode_png(canvas.raster());
}

}  // namespace report
