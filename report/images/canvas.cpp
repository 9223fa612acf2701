#include "report/images/canvas.h"

#include "calc/base/elementary.h"
#include "report/images/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace report {
namespace {

// From pixels outside the picture to one of its own that is nearest; 0 of what is no number.
int limited(double value, int size) {
  if (!(value > 0.0)) return 0;
  return value < size - 1 ? static_cast<int>(value) : size - 1;
}

// First and last x of a straight piece between two heights.
std::array<double, 2> ends_between(const glm::dvec2& a, const glm::dvec2& b, double low,
                                   double high) {
  const double rise = b.y - a.y;
  if (rise == 0.0) return {std::min(a.x, b.x), std::max(a.x, b.x)};
  const auto x_at = [&](double y) {
    return a.x + std::clamp((y - a.y) / rise, 0.0, 1.0) * (b.x - a.x);
  };
  return {std::min(x_at(low), x_at(high)), std::max(x_at(low), x_at(high))};
}

}  // namespace

Canvas::Canvas(int width, int height)
    : coverage_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F),
      left_(width),
      top_(height) {
  raster_.width = width;
  raster_.height = height;
  raster_.rgba.assign(coverage_.size() * 4, 255);
}

void Canvas::put(const Raster& picture, int left, int top) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t from =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(x));
      const int opacity = picture.rgba[from + 3];
      for (std::size_t k = 0; k < 3; ++k) {
        raster_.rgba[4 * index(x + left, y + top) + k] = static_cast<std::uint8_t>(
            (picture.rgba[from + k] * opacity + 255 * (255 - opacity) + 127) / 255);
      }
    }
  }
}

void Canvas::fill(int left, int top, int width, int height, Rgb colour) {
  for (int y = std::max(0, top); y < std::min(raster_.height, top + height); ++y) {
    for (int x = std::max(0, left); x < std::min(raster_.width, left + width); ++x) {
      blend(index(x, y), colour, 1.0F);
    }
  }
}

void Canvas::cover(const glm::dvec2& a, const glm::dvec2& b, double width) {
  const double reach = 0.5 * width + 1.0;
  const int left = limited(std::min(a.x, b.x) - reach, raster_.width);
  const int right = limited(std::max(a.x, b.x) + reach, raster_.width);
  const int top = limited(std::min(a.y, b.y) - reach, raster_.height);
  const int bottom = limited(std::max(a.y, b.y) + reach, raster_.height);
  left_ = std::min(left_, left);
  top_ = std::min(top_, top);
  right_ = std::max(right_, right);
  bottom_ = std::max(bottom_, bottom);
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  for (int y = top; y <= bottom; ++y) {
    // A line that leans has most of its box on none of its pixels.
    const auto [from, to] = ends_between(a, b, y + 0.5 - reach, y + 0.5 + reach);
    const int last = limited(to + reach, raster_.width);
    for (int x = limited(from - reach, raster_.width); x <= last; ++x) {
      const glm::dvec2 p = glm::dvec2(x, y) + 0.5 - a;
      const double t = length2 > 0.0 ? std::clamp(glm::dot(p, along) / length2, 0.0, 1.0) : 0.0;
      const glm::dvec2 aside = p - t * along;
      const double distance = calc::hypot(aside.x, aside.y);
      const double share = std::clamp(0.5 * width + 0.5 - distance, 0.0, 1.0);
      float& covered = coverage_[index(x, y)];
      covered = std::max(covered, static_cast<float>(share));
    }
  }
}

void Canvas::paint(Rgb colour) {
  for (int y = top_; y <= bottom_; ++y) {
    for (int x = left_; x <= right_; ++x) {
      float& covered = coverage_[index(x, y)];
      if (covered > 0.0F) blend(index(x, y), colour, covered);
      covered = 0.0F;
    }
  }
  left_ = raster_.width;
  top_ = raster_.height;
  right_ = bottom_ = -1;
}

void Canvas::line(std::span<const glm::dvec2> corners, double width, Rgb colour) {
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) cover(corners[k], corners[k + 1], width);
  paint(colour);
}

void Canvas::write(std::string_view utf8, const glm::dvec2& at, double size_px, TextAnchor anchor,
                   Rgb colour) {
  const TextStrokes strokes = text_strokes(utf8, size_px);
  glm::dvec2 from = at;
  if (anchor == TextAnchor::middle) from.x -= 0.5 * strokes.width_px;
  if (anchor == TextAnchor::end) from.x -= strokes.width_px;
  for (const std::vector<glm::dvec2>& line : strokes.lines) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      cover(from + line[k], from + line[k + 1], strokes.pen_px);
    }
  }
  paint(colour);
}

void Canvas::blend(std::size_t pixel, Rgb colour, float share) {
  const std::array<std::uint8_t, 3> paint{colour.r, colour.g, colour.b};
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint8_t& value = raster_.rgba[4 * pixel + k];
    value = static_cast<std::uint8_t>(
        std::lround(static_cast<float>(value) + share * (static_cast<float>(paint[k]) - value)));
  }
}

}  // namespace report
