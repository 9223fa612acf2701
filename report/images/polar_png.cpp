#include "calc/base/elementary.h"
#include "calc/base/utf8.h"
#include "report/images/dot_font.h"
#include "report/images/heatmap.h"
#include "report/images/png.h"
#include "report/images/polar_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace report {
namespace {

constexpr double kScale = 2.0;             // pixels per unit of the drawing
constexpr int kLetterDot = 3;              // pixels per dot of a letter
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

class Canvas {
 public:
  Canvas(int width, int height) : coverage_(static_cast<std::size_t>(width) * height, 0.0F) {
    raster_.width = width;
    raster_.height = height;
    raster_.rgba.assign(coverage_.size() * 4, 255);
  }

  // A straight piece of a line, round ends; painted with the rest of the line by paint().
  void cover(PolarPoint a, PolarPoint b, double width) {
    const double reach = 0.5 * width + 1.0;
    const int left = limited(std::min(a.x, b.x) - reach, raster_.width);
    const int right = limited(std::max(a.x, b.x) + reach, raster_.width);
    const int top = limited(std::min(a.y, b.y) - reach, raster_.height);
    const int bottom = limited(std::max(a.y, b.y) + reach, raster_.height);
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const double px = x + 0.5 - a.x;
        const double py = y + 0.5 - a.y;
        const double t = length2 > 0.0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
        const double distance = calc::hypot(px - t * dx, py - t * dy);
        const double share = std::clamp(0.5 * width + 0.5 - distance, 0.0, 1.0);
        float& covered = coverage_[index(x, y)];
        covered = std::max(covered, static_cast<float>(share));
      }
    }
  }

  void paint(Rgb colour) {
    for (std::size_t i = 0; i < coverage_.size(); ++i) {
      if (coverage_[i] > 0.0F) blend(i, colour, coverage_[i]);
      coverage_[i] = 0.0F;
    }
  }

  void dot(int x, int y, Rgb colour) {
    for (int row = y; row < y + kLetterDot; ++row) {
      for (int column = x; column < x + kLetterDot; ++column) {
        if (row < 0 || row >= raster_.height || column < 0 || column >= raster_.width) continue;
        blend(index(column, row), colour, 1.0F);
      }
    }
  }

  const Raster& raster() const { return raster_; }

 private:
  static int limited(double value, int size) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size - 1)));
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.width) +
           static_cast<std::size_t>(x);
  }
  void blend(std::size_t pixel, Rgb colour, float share) {
    const std::array<std::uint8_t, 3> paint{colour.r, colour.g, colour.b};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t& value = raster_.rgba[4 * pixel + k];
      value = static_cast<std::uint8_t>(
          std::lround(static_cast<float>(value) + share * (static_cast<float>(paint[k]) - value)));
    }
  }

  Raster raster_;
  std::vector<float> coverage_;
};

PolarPoint scaled(PolarPoint point) { return {kScale * point.x, kScale * point.y}; }

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

// One character per letter; the degree sign has two bytes.
std::string letters_of(const std::string& utf8) {
  std::string letters;
  for (const char c : utf8) {
    if (calc::is_utf8_continuation(c)) continue;
    letters += static_cast<unsigned char>(c) < 0x80 ? c : 'o';
  }
  return letters;
}

void draw_label(const PolarLabel& label, Canvas& canvas) {
  const std::string letters = letters_of(label.text);
  constexpr int kAdvance = (kGlyphWidth + 1) * kLetterDot;
  const int width = static_cast<int>(letters.size()) * kAdvance - kLetterDot;
  int x = static_cast<int>(std::lround(kScale * label.at.x));
  if (label.anchor == PolarLabel::Anchor::middle) x -= width / 2;
  if (label.anchor == PolarLabel::Anchor::end) x -= width;
  const int y = static_cast<int>(std::lround(kScale * label.at.y)) - kGlyphHeight * kLetterDot / 2;
  for (const char letter : letters) {
    for_each_dot(letter, [&](int column, int row) {
      canvas.dot(x + column * kLetterDot, y + row * kLetterDot, colour_of(label.role));
    });
    x += kAdvance;
  }
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
