#include "report/images/heatmap.h"

#include "calc/base/elementary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace report {
namespace {

constexpr std::array<Rgb, 10> kCividis{{{0x00, 0x20, 0x4D},
                                        {0x00, 0x33, 0x6F},
                                        {0x39, 0x48, 0x6B},
                                        {0x57, 0x5C, 0x6D},
                                        {0x70, 0x71, 0x73},
                                        {0x8A, 0x87, 0x79},
                                        {0xA6, 0x9D, 0x75},
                                        {0xC4, 0xB5, 0x6C},
                                        {0xE4, 0xCF, 0x5B},
                                        {0xFF, 0xEA, 0x46}}};

constexpr std::array<Rgb, 6> kFalseColours{{{0x14, 0x28, 0xB4},
                                            {0x00, 0xC8, 0xF0},
                                            {0x1E, 0xAA, 0x32},
                                            {0xFF, 0xE6, 0x00},
                                            {0xE1, 0x1E, 0x14},
                                            {0xDC, 0x00, 0xC8}}};

std::uint8_t blend(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : calc::pow((c + 0.055) / 1.055, 2.4);
}

// The smallest of 1, 2, 5 times a power of ten that is >= value > 0.
double round_step(double value) {
  const double power = calc::pow(10.0, std::floor(calc::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= value * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

constexpr double kSame = 1e-9;  // relative

// From whole numbers, so that borders are the numbers that they are called.
std::vector<double> class_borders(ClassSeries series) {
  constexpr double kParts = 1000.0;  // of 1 lx
  const std::vector<double> parts =
      series == ClassSeries::fine ? std::vector<double>{10, 12, 15, 20, 25, 30, 40, 50, 60, 75}
                                  : std::vector<double>{10, 15, 20, 30, 50, 75};
  std::vector<double> borders;
  for (double power = 1.0; power < 1e10; power *= 10.0) {
    for (const double part : parts) borders.push_back(part * power / kParts);
  }
  return borders;
}

// anchors: at least two, evenly spaced over [0, 1].
Rgb between(std::span<const Rgb> anchors, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(anchors.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const double part = place - static_cast<double>(first);
  const Rgb a = anchors[first], b = anchors[first + 1];
  return {blend(a.r, b.r, part), blend(a.g, b.g, part), blend(a.b, b.b, part)};
}

}  // namespace

Rgb cividis(double t) { return between(kCividis, t); }
Rgb false_colour(double t) { return between(kFalseColours, t); }

std::string hex_colour(Rgb colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

bool needs_dark_text(Rgb colour) {
  const double luminance =
      0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
  const double with_black = (luminance + 0.05) / 0.05;
  const double with_white = 1.05 / (luminance + 0.05);
  return with_black > with_white;
}

ColourScale make_colour_scale(double lowest, double highest) {
  constexpr double kWantedBands = 9.0;
  const double size = std::max(std::abs(lowest), std::abs(highest));
  if (!(size > 0.0)) return {};
  const double step = round_step(std::max((highest - lowest) / kWantedBands, 0.01 * size));
  ColourScale scale;
  scale.step = step;
  scale.low = std::floor(lowest / step + 1e-9) * step;
  scale.bands = std::max(1, static_cast<int>(std::ceil((highest - scale.low) / step - 1e-9)));
  return scale;
}

ColourScale make_class_scale(double lowest, double highest, ClassSeries of) {
  constexpr std::size_t kMostBands = 12;
  const std::vector<double> series = class_borders(of);
  // As in band_of(): a value on a border is above it.
  const auto border_above = [&](double value) {
    return static_cast<std::size_t>(
        std::upper_bound(series.begin(), series.end(), value * (1.0 + kSame)) - series.begin());
  };
  std::size_t last = border_above(highest);
  if (last > 0 && series[last - 1] >= highest * (1.0 - kSame)) --last;
  if (last + 1 >= series.size()) return make_colour_scale(0.0, highest);
  std::size_t first = border_above(lowest);
  ColourScale scale;
  if (first == 0 || last - (first - 1) > kMostBands) {
    scale.classes.push_back(0.0);
    first = last + 1 - std::min(last + 1, kMostBands);
  } else {
    --first;
  }
  if (scale.classes.empty() && first == last) ++last;
  for (std::size_t i = first; i <= last; ++i) scale.classes.push_back(series[i]);
  scale.low = scale.classes.front();
  scale.bands = static_cast<int>(scale.classes.size()) - 1;
  return scale;
}

int band_of(const ColourScale& scale, double value) {
  if (scale.has_classes()) {
    const auto inner_end = scale.classes.end() - 1;
    return static_cast<int>(
        std::upper_bound(scale.classes.begin() + 1, inner_end, value * (1.0 + kSame)) -
        (scale.classes.begin() + 1));
  }
  // 1e-9: a value on the border between two bands must not fall below it by rounding.
  const double place = std::floor((value - scale.low) / scale.step + 1e-9);
  if (!(place > 0.0)) return 0;
  return static_cast<int>(std::min(place, static_cast<double>(scale.bands - 1)));
}

Rgb band_colour(const ColourScale& scale, int band) {
  const double t = scale.bands == 1 ? 0.5 : band / static_cast<double>(scale.bands - 1);
  return scale.map == ColourMap::cividis ? cividis(t) : false_colour(t);
}

ColourScale scale_of(const PlanePart& plane, ColourMap map) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const PointRow& point : plane.points) {
    if (!std::isfinite(point.measured.value)) continue;  // e.g. an eye without glare source
    lowest = std::min(lowest, point.measured.value);
    highest = std::max(highest, point.measured.value);
  }
  ColourScale scale = lowest <= highest ? make_colour_scale(lowest, highest) : ColourScale{};
  scale.map = map;
  return scale;
}

bool has_cells(const PlanePart& plane) {
  return plane.is_computed && plane.grid.columns > 0 && plane.grid.rows > 0 &&
         !plane.points.empty();
}

bool has_all_values(const PlanePart& plane) {
  return std::all_of(plane.points.begin(), plane.points.end(),
                     [](const PointRow& point) { return std::isfinite(point.measured.value); });
}

Raster plane_raster(const PlanePart& plane, const ColourScale& scale, int pixels_per_cell) {
  Raster raster;
  raster.width = plane.grid.columns * pixels_per_cell;
  raster.height = plane.grid.rows * pixels_per_cell;
  raster.rgba.resize(static_cast<std::size_t>(raster.width) *
                     static_cast<std::size_t>(raster.height) * 4);
  for (const PointRow& point : plane.points) {
    if (!std::isfinite(point.measured.value)) continue;
    const Rgb colour = band_colour(scale, band_of(scale, point.measured.value));
    const int left = point.column * pixels_per_cell;
    const int top = (plane.grid.rows - 1 - point.row) * pixels_per_cell;
    for (int y = top; y < top + pixels_per_cell; ++y) {
      for (int x = left; x < left + pixels_per_cell; ++x) {
        const std::size_t at =
            (static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) +
             static_cast<std::size_t>(x)) *
            4;
        raster.rgba[at] = colour.r;
        raster.rgba[at + 1] = colour.g;
        raster.rgba[at + 2] = colour.b;
        raster.rgba[at + 3] = 255;
      }
    }
  }
  return raster;
}

int pixels_per_cell(const PlanePart& plane, int wanted) {
  return std::max(1, wanted / std::max({plane.grid.columns, plane.grid.rows, 1}));
}

}  // namespace report
