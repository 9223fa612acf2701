#include "report/room_picture.h"

#include "report/dot_font.h"
#include "report/number_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

namespace report {
namespace {

constexpr double kSeenShare = 0.99;
constexpr int kMargin = 24, kBarHeight = 18, kDot = 2, kLetter = (kGlyphWidth + 1) * kDot;
constexpr Rgb kInk{27, 31, 36};

std::size_t at(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x);
}

// Calls tell(index) for the drawn pixels of a picture's pixel.
template <class Tell>
void for_each_sample(const DrawnRoom& drawn, int x, int y, const Tell& tell) {
  for (int dy = 0; dy < kOversampling; ++dy) {
    for (int dx = 0; dx < kOversampling; ++dx) {
      tell(at(kOversampling * x + dx, kOversampling * y + dy, drawn.width));
    }
  }
}

void fill(Raster& raster, int left, int top, int width, int height, Rgb colour) {
  for (int y = std::max(0, top); y < std::min(raster.height, top + height); ++y) {
    for (int x = std::max(0, left); x < std::min(raster.width, left + width); ++x) {
      const std::array<std::uint8_t, 4> pixel{colour.r, colour.g, colour.b, 255};
      std::copy(pixel.begin(), pixel.end(),
                raster.rgba.begin() + static_cast<std::ptrdiff_t>(4 * at(x, y, raster.width)));
    }
  }
}

void write_text(Raster& raster, int left, int top, const std::string& text) {
  for (const char letter : text) {
    for_each_dot(letter, [&](int column, int row) {
      fill(raster, left + column * kDot, top + row * kDot, kDot, kDot, kInk);
    });
    left += kLetter;
  }
}

int text_width(const std::string& text) { return static_cast<int>(text.size()) * kLetter - kDot; }

}  // namespace

Raster paint_room(const DrawnRoom& drawn, const std::function<Rgb(float)>& colour) {
  Raster raster;
  raster.width = drawn.width / kOversampling;
  raster.height = drawn.height / kOversampling;
  raster.rgba.reserve(4 * static_cast<std::size_t>(raster.width) *
                      static_cast<std::size_t>(raster.height));
  constexpr float kSamples = kOversampling * kOversampling;
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x) {
      std::array<float, 4> sum{};  // premultiplied
      for_each_sample(drawn, x, y, [&](std::size_t i) {
        const std::uint8_t* cover = &drawn.cover[4 * i];
        const float through = 1.0F - static_cast<float>(cover[3]) / 255.0F;
        for (std::size_t k = 0; k < 4; ++k) sum[k] += static_cast<float>(cover[k]);
        if (drawn.lx[i] < 0.0F || through <= 0.0F) return;
        const Rgb below = colour(drawn.lx[i]);
        const std::array<std::uint8_t, 4> paint{below.r, below.g, below.b, 255};
        for (std::size_t k = 0; k < 4; ++k) sum[k] += through * static_cast<float>(paint[k]);
      });
      const float opacity = sum[3] / (255.0F * kSamples);
      for (std::size_t k = 0; k < 3; ++k) {
        const float value = opacity > 0.0F ? sum[k] / (kSamples * opacity) : 0.0F;
        raster.rgba.push_back(static_cast<std::uint8_t>(std::lround(std::min(value, 255.0F))));
      }
      raster.rgba.push_back(
          static_cast<std::uint8_t>(std::lround(255.0F * std::min(opacity, 1.0F))));
    }
  }
  return raster;
}

std::vector<float> mean_values(const DrawnRoom& drawn) {
  std::vector<float> result;
  for (int y = 0; y < drawn.height / kOversampling; ++y) {
    for (int x = 0; x < drawn.width / kOversampling; ++x) {
      float sum = 0.0F;
      int seen = 0;
      for_each_sample(drawn, x, y, [&](std::size_t i) {
        if (drawn.lx[i] < 0.0F) return;
        sum += drawn.lx[i];
        ++seen;
      });
      result.push_back(seen > 0 ? sum / static_cast<float>(seen) : -1.0F);
    }
  }
  return result;
}

ColourScale room_scale(std::span<const DrawnRoom> rooms, std::span<const double> values_lx) {
  std::vector<float> seen;
  for (const DrawnRoom& room : rooms) {
    std::copy_if(room.lx.begin(), room.lx.end(), std::back_inserter(seen),
                 [](float lx) { return lx >= 0.0F; });
  }
  double highest = 0.0;
  if (!seen.empty()) {
    const auto place = seen.begin() + static_cast<std::ptrdiff_t>(
                                          kSeenShare * static_cast<double>(seen.size() - 1));
    std::nth_element(seen.begin(), place, seen.end());
    highest = static_cast<double>(*place);
  }
  for (const double lx : values_lx) highest = std::max(highest, lx);
  return make_colour_scale(0.0, highest);
}

Raster with_legend(const Raster& picture, const ColourScale& scale) {
  constexpr int kLegendHeight = kBarHeight + kGlyphHeight * kDot + 3 * kMargin / 2;
  Raster result;
  result.width = picture.width + 2 * kMargin;
  result.height = picture.height + 2 * kMargin + kLegendHeight;
  result.rgba.assign(4 * static_cast<std::size_t>(result.width) *
                         static_cast<std::size_t>(result.height),
                     255);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* from = &picture.rgba[4 * at(x, y, picture.width)];
      std::uint8_t* to = &result.rgba[4 * at(x + kMargin, y + kMargin, result.width)];
      for (std::size_t k = 0; k < 3; ++k) {
        to[k] = static_cast<std::uint8_t>((from[k] * from[3] + 255 * (255 - from[3]) + 127) / 255);
      }
    }
  }
  const int width = std::min(picture.width - 60, 900), left = kMargin + 10;
  const int top = picture.height + 2 * kMargin;
  const auto x_of = [&](int band) { return left + band * width / scale.bands; };
  fill(result, left - 1, top - 1, width + 2, kBarHeight + 2, kInk);
  for (int band = 0; band < scale.bands; ++band) {
    fill(result, x_of(band), top, x_of(band + 1) - x_of(band), kBarHeight,
         band_colour(scale, band));
  }
  for (int band = 0; band <= scale.bands; ++band) {
    const std::string number = format_shortest(scale.low_lx + band * scale.step_lx);
    write_text(result, x_of(band) - text_width(number) / 2, top + kBarHeight + 6, number);
  }
  write_text(result, left + width + 10, top + (kBarHeight - kGlyphHeight * kDot) / 2, "lx");
  return result;
}

}  // namespace report
